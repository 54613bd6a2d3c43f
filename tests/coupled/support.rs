//! Wings to solve, and numbers that look random but are always the same.

use std::path::Path;

use nalgebra::Vector3;
use washout::aero::Flow;
use washout::coupling::solution::Solution;
use washout::coupling::{self, CouplingError};
use washout::geometry::Planform;
use washout::input::design::Design;
use washout::mesh::{Mesh, generate};
use washout::observation::Observer;
use washout::progress::Progress;

/// A design with its outline and mesh.
pub struct Wing {
    pub design: Design,
    pub planform: Planform,
    pub mesh: Mesh,
}

/// A wing that is shipped, with changes as `--set` has them.
pub fn shipped(name: &str, sets: &[&str]) -> Wing {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("designs")
        .join(format!("{name}.toml"));
    let sets: Vec<String> = sets.iter().map(|set| set.to_string()).collect();
    Wing::of(Design::load(&path, &sets).unwrap().design)
}

impl Wing {
    pub fn of(design: Design) -> Wing {
        let planform = Planform::from_design(&design).unwrap();
        let mesh = generate(&design, &planform).unwrap();
        Wing {
            design,
            planform,
            mesh,
        }
    }

    pub fn try_solve(&self) -> Result<Solution, CouplingError> {
        coupling::solve(&self.design, &self.mesh, None, &Progress::quiet())
    }

    /// The solution, which must stand on the stable branch.
    pub fn solve(&self) -> Solution {
        let solution = self.try_solve().unwrap();
        assert_eq!(solution.report.negative_pivots, 0, "{}", self.design.name);
        solution
    }

    /// Twist at the ends of the spars and at the tip station, rad.
    pub fn twists(&self, solution: &Solution) -> Vec<f64> {
        let observer = Observer::new(&self.design, &self.planform, solution).unwrap();
        let readings = observer.profile().readings;
        readings.iter().skip(1).map(|reading| reading.twist_rad).collect()
    }
}

/// Force of the air on a wing across the stream at rest, N.
pub fn lift_n(wing: &Wing, solution: &Solution) -> f64 {
    lift_of(&Flow::from_design(&wing.design).unwrap(), solution)
}

/// The same for a flow.
pub fn lift_of(flow: &Flow, solution: &Solution) -> f64 {
    let force: Vector3<f64> = solution.air_force_n.iter().map(|f| Vector3::from(*f)).sum();
    force.dot(&flow.lift_direction())
}

/// Largest difference of two lists over the largest value of the second.
pub fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let largest = b.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, f64::max) / largest
}

/// Numbers in [−1, 1) that look random (Steele, Lea & Flood 2014, SplitMix64).
pub struct Noise(pub u64);

impl Noise {
    pub fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.number())
    }
}
