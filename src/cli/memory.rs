//! Whether a wing fits into the memory that is free: what does not is refused before it is solved, not ended by the system.

use std::path::Path;

use sysinfo::{MemoryRefreshKind, RefreshKind, System};

use super::Failure;

/// Memory of a solve besides what grows with the mesh, bytes.
const BASE: f64 = 2e7;
/// Bytes for each node and doubling of their number, most of them for the factor of the tangent: nested dissection of a plane mesh fills
/// in n log n (George, SIAM J. Numer. Anal. 10, 1973). Measured on the paper's wings: 2.7 to 2.8 kB from 700 to 6000 nodes.
const PER_NODE: f64 = 3e3;

/// About what a solve of a mesh with so many nodes takes, bytes.
fn needed(nodes: usize) -> f64 {
    let nodes = nodes as f64;
    BASE + PER_NODE * nodes * nodes.max(2.0).log2()
}

/// What this process may still take, bytes: of the machine, or of the group of processes that it is in.
fn free() -> Option<f64> {
    let memory = RefreshKind::nothing().with_memory(MemoryRefreshKind::nothing().with_ram());
    let system = System::new_with_specifics(memory);
    let of_machine = system.available_memory();
    // what a group keeps of files is given back where it is needed
    let of_group = system
        .cgroup_limits()
        .map(|limits| limits.total_memory.saturating_sub(limits.rss));
    let free = of_group.map_or(of_machine, |group| group.min(of_machine));
    (free > 0).then_some(free as f64)
}

/// Refuses a mesh whose solve takes more than is free, or than `allowed_gb` where that is given.
pub fn refuse_beyond(design: &Path, nodes: usize, allowed_gb: Option<f64>) -> Result<(), Failure> {
    let allowed = allowed_gb.map(|own| own * 1e9).or_else(free);
    let needed = needed(nodes);
    match allowed {
        Some(allowed) if needed > allowed => Err(Failure::Memory {
            design: design.to_path_buf(),
            nodes,
            needed_gb: needed * 1e-9,
            allowed_gb: allowed * 1e-9,
        }),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mesh_is_refused_above_what_is_allowed_and_taken_below() {
        // as measured: 210 MB for 5846 nodes, 44 MB for 702
        for (nodes, measured) in [(5846, 2.11e8), (702, 0.44e8)] {
            let ratio = needed(nodes) / measured;
            assert!((0.8..1.4).contains(&ratio), "{nodes}: {ratio}");
        }
        let design = Path::new("wing.toml");
        assert!(refuse_beyond(design, 5846, Some(0.3)).is_ok());
        let refused = refuse_beyond(design, 5846, Some(0.1))
            .expect_err("too large")
            .to_string();
        assert!(
            refused.starts_with(
                "wing.toml: a solve of its mesh of 5846 nodes takes about 0.24 GB, and 0.10 GB may be taken"
            ),
            "{refused}"
        );
        assert!(free().is_some());
        assert!(refuse_beyond(design, 700, None).is_ok());
    }
}
