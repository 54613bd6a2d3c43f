//! A wing with a twist and a deflection imposed on it, for tests of what reads it.

use nalgebra::{UnitQuaternion, Vector3};

use crate::coupling::solution::{Solution, SolveReport};
use crate::geometry::Planform;
use crate::input::design::Design;
use crate::mesh;
use crate::structure::state::State;

/// A 70 mm wing with five spars, flapping, root at 45 deg.
pub fn design(extra: &str) -> Design {
    let section = "section = { shape = 'round', diameter_mm = 1.0 }";
    let mut text = format!(
        "format = 1\nname = 'imposed'\n{extra}\n[planform]\nlength_mm = 70.0\nmean_chord_mm = 20.5\nr2_hat = 0.54\n\
         [flapping]\nfrequency_hz = 22.0\nhalf_amplitude_deg = 34.5\n\
         [film]\nmaterial = 'kapton'\nthickness_mm = 0.006\n\
         [[rod]]\nfrom_mm = 0.0\nto_mm = 70.0\n{section}\n"
    );
    for at_mm in [2.8, 18.9, 35.0, 51.1, 67.2] {
        text += &format!("[[spar]]\nat_mm = {at_mm:?}\n{section}\n");
    }
    toml::from_str(&text).unwrap()
}

/// That wing with every section turned by `twist_rad(r_m)` about the leading edge, which moves by `edge_m(r_m)`.
pub fn wing(
    design: &Design,
    twist_rad: impl Fn(f64) -> f64,
    edge_m: impl Fn(f64) -> [f64; 2],
) -> (Planform, Solution) {
    let planform = Planform::from_design(design).unwrap();
    let mesh = mesh::generate(design, &planform).unwrap();
    let rest = State::at_rest(mesh.nodes.len());
    let mut state = rest.clone();
    for (node, [x, y, _]) in mesh.nodes.iter().enumerate() {
        let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), twist_rad(*x));
        let [sweep_m, deflection_m] = edge_m(*x);
        state.rotation[node] = turn;
        let arm = Vector3::y() * *y;
        state.displacement[node] = turn * arm - arm + Vector3::new(0.0, sweep_m, deflection_m);
    }
    let solution = Solution {
        mesh,
        rest,
        state,
        strips: Vec::new(),
        air_force_n: Vec::new(),
        pressure_pa: Vec::new(),
        beam_force: Vec::new(),
        membrane_force_n_per_m: Vec::new(),
        report: SolveReport {
            residual: Some(0.0),
            twist_change_deg: 0.0,
            iterations: 0,
            newton_steps: 0,
            negative_pivots: 0,
            critical_pressure_ratio: None,
            dof: 0,
            reaction_force_n: [0.0; 3],
            reaction_moment_n_m: [0.0; 3],
            twist_history_deg: Vec::new(),
        },
    };
    (planform, solution)
}
