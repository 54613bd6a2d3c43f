//! A mesh of one's own: nodes, triangles and beams by hand, checked, handed over as a Gmsh file, solved.
//!
//! A rectangular wing in a slow wind tunnel, stiff spars, no film tension: small enough to be checked by hand.
//! `cargo run --release --example mesh_of_ones_own`

use std::error::Error;
use std::f64::consts::PI;

use washout::coupling::solve;
use washout::input::Design;
use washout::mesh::{BeamElement, BeamPart, Mesh, MeshFile, check::check, for_design, gmsh};
use washout::observation::twist_at;
use washout::progress::Progress;

const SPAN_M: f64 = 0.060;
const CHORD_M: f64 = 0.020;
const CELLS: [usize; 2] = [24, 8];
const SPARS: usize = 13;

fn main() -> Result<(), Box<dyn Error>> {
    let mesh = mesh();
    check(&mesh)?;
    // This text is what any other mesher would write; `washout solve DESIGN --mesh FILE` takes it too.
    let text = gmsh::write(&mesh);
    let file = MeshFile {
        name: "my-wing.msh",
        bytes: text.as_bytes(),
    };
    let design = Design::from_toml(&design(), "my-wing.toml")?;
    let (planform, mesh) = for_design(&design, Some(file))?;
    let solution = solve(&design, &mesh, None, &Progress::shown())?;
    let solved_deg = twist_at(&design, &planform, &solution, SPAN_M)
        .ok_or("no tip")?
        .to_degrees();
    let by_hand_deg = by_hand_rad().to_degrees();
    println!("twist of the tip: {solved_deg:.5} deg solved, {by_hand_deg:.5} deg by hand");
    assert!((solved_deg / by_hand_deg - 1.0).abs() < 0.02);
    Ok(())
}

/// A grid of `CELLS` rectangles, each cut in two; rod along y = 0, spars at even distances across the chord.
fn mesh() -> Mesh {
    let [along, across] = CELLS;
    let node = |i: usize, j: usize| i * (across + 1) + j;
    let mut mesh = Mesh::default();
    for i in 0..=along {
        for j in 0..=across {
            let [x, y] = [
                SPAN_M * i as f64 / along as f64,
                CHORD_M * j as f64 / across as f64,
            ];
            mesh.nodes.push([x, y, 0.0]);
        }
    }
    for (i, j) in (0..along).flat_map(|i| (0..across).map(move |j| (i, j))) {
        let [a, b, c, d] = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
        mesh.triangles.extend([[a, b, c], [a, c, d]]);
    }
    let beam = |part, nodes| BeamElement { nodes, part };
    mesh.beams
        .extend((0..along).map(|i| beam(BeamPart::Rod(0), [node(i, 0), node(i + 1, 0)])));
    for spar in 0..SPARS {
        let i = spar * along / (SPARS - 1);
        mesh.beams
            .extend((0..across).map(|j| beam(BeamPart::Spar(spar), [node(i, j), node(i, j + 1)])));
    }
    mesh.root = (0..=across).map(|j| node(0, j)).collect();
    mesh.leading_edge = (0..=along).map(|i| node(i, 0)).collect();
    mesh.trailing_edge = (0..=along).map(|i| node(i, across)).collect();
    mesh
}

/// The design that belongs to it; without a shape of its own it takes the outline of the mesh.
fn design() -> String {
    let mut text = format!(
        "format = 1\nname = 'my-wing'\n\
         [planform]\nlength_mm = {}\nroot_offset_mm = 0.0\ntip_cut = 1.0\n[mesh]\nfile = 'my-wing.msh'\n\
         [steady]\nspeed_m_s = 1.0\nroot_angle_deg = 30.0\n\
         [[rod]]\nfrom_mm = 0.0\nto_mm = {0}\nmaterial = 'steel'\nsection = {{ shape = 'round', diameter_mm = 0.5 }}\n\
         [film]\nmaterial = 'kapton'\nthickness_mm = 0.006\n\
         [material.steel]\ne_gpa = 200.0\ng_gpa = 80.0\ndensity_kg_m3 = 7850.0\n\
         [material.kapton]\ne_gpa = 2.5\npoisson = 0.34\ndensity_kg_m3 = 1420.0\n",
        SPAN_M * 1e3
    );
    for spar in 0..SPARS {
        let at_mm = SPAN_M * 1e3 * spar as f64 / (SPARS - 1) as f64;
        text += &format!(
            "[[spar]]\nat_mm = {at_mm}\nmaterial = 'steel'\nsection = {{ shape = 'round', diameter_mm = 0.5 }}\n"
        );
    }
    text
}

/// A rod under an even torque per length m, held at the base: θ = m L²/(2 G J); m = force × its arm, and with so little
/// twist the angle of attack stays 30 deg.
fn by_hand_rad() -> f64 {
    let alpha_deg: f64 = 30.0;
    let lift = 0.225 + 1.58 * (2.13 * alpha_deg - 7.20).to_radians().sin();
    let drag = 1.92 - 1.55 * (2.04 * alpha_deg - 9.82).to_radians().cos();
    let alpha = alpha_deg.to_radians();
    let normal_n_m = 0.5 * 1.2 * CHORD_M * (lift * alpha.cos() + drag * alpha.sin());
    let arm_m = (0.82 * alpha / PI + 0.05) * CHORD_M;
    let gj_n_m2 = 80e9 * PI / 32.0 * 0.0005f64.powi(4);
    normal_n_m * arm_m * SPAN_M.powi(2) / (2.0 * gj_n_m2)
}
