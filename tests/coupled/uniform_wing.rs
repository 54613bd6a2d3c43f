//! The clamped uniform wing in strip theory, small rotations: twist along the span and divergence in closed form.
//!
//! ```text
//!   LE ━━━━━━━━━━━━━━━━━━━━━━━   rod with given stiffnesses, clamped at x = 0
//!      · · · centre of pressure   c/4 = 50 mm behind the leading edge
//!      ─ ─ ─ elastic axis         100 mm behind it: e = 50 mm
//!   TE └───┴───┴───┴───┴───┘   ribs at every column, stiff; film of 10⁻⁴ N/m, which carries nothing
//! ```
//!
//! The rod is the leading edge. Its elastic axis is put behind it by the section's coupling of twist and shear:
//! K_VV = GA, K_VT = GA d, K_TT = GJ + GA d², so that a force at y = d bends without twist. With λ² = q c e a/GJ the
//! nose-up twist is α₀ (cos λ(L−y)/cos λL − 1) and q_D = (π/2L)² GJ/(e c a) = 392.699 Pa (Bisplinghoff, Ashley &
//! Halfman 1955, section 8-2). With the elastic axis on the leading edge the same wing washes out by
//! α₀ (1 − cosh μ(L−y)/cosh μL), μ² = q c (c/4) a/GJ, and does not diverge.
//!
//! Eight elements carry eight strips of load, each cut at two places (see `coupling::strips`). By hand: with the twist
//! linear in an element the eigenvalue is too large by (λh)²/12 = 0.32 %, and by (λh)²/6 = 0.64 % with one cut.

use washout::coupling::CouplingError;
use washout::coupling::solution::Solution;
use washout::geometry::Planform;
use washout::input::design::Design;
use washout::mesh::{BeamElement, BeamPart, Mesh};

use crate::support::Wing;

pub const LENGTH_M: f64 = 1.0;
pub const CHORD_M: f64 = 0.2;
pub const GJ: f64 = 10.0;
const DENSITY: f64 = 1.225;
const DIVERGENCE_PA: f64 = 392.699;
const ROOT_DEG: f64 = 0.01;

/// What differs between the wings.
pub struct Setup {
    /// Beam elements.
    pub columns: usize,
    /// Dynamic pressure of the stream, Pa.
    pub q_pa: f64,
    /// Elastic axis behind the leading edge, m.
    pub axis_m: f64,
    /// Sweep, deg, positive aft.
    pub sweep_deg: f64,
    /// Centre of pressure, fraction of the chord.
    pub centre: f64,
    /// Shear stiffness of the rod, N.
    pub shear_n: f64,
}

/// The unswept wing with its centre of pressure at a quarter chord.
fn wing(columns: usize, q_pa: f64, axis_m: f64) -> Wing {
    uniform(&Setup {
        columns,
        q_pa,
        axis_m,
        sweep_deg: 0.0,
        centre: 0.25,
        shear_n: 1000.0,
    })
}

/// The wing of a set-up, from the text of a design.
pub fn uniform(setup: &Setup) -> Wing {
    let &Setup {
        columns,
        q_pa,
        axis_m,
        sweep_deg,
        centre,
        shear_n: shear,
    } = setup;
    let (coupling, torsion) = (shear * axis_m, GJ + shear * axis_m * axis_m);
    let terms = if axis_m > 0.0 {
        format!("coupling = [{{ between = ['shear-flap', 'twist'], value = {coupling:?} }}]")
    } else {
        String::new()
    };
    let speed = (2.0 * q_pa / DENSITY).sqrt();
    let mut text = format!(
        "format = 1\nname = 'uniform'\n\
         [planform]\nlength_mm = 1000.0\noutline = [[0.0, 200.0], [1000.0, 200.0]]\nbase_closure = 0.0\ntip_cut = 1.0\n\
         [steady]\nspeed_m_s = {speed:?}\nroot_angle_deg = {ROOT_DEG}\nsweep_deg = {sweep_deg:?}\n\
         [air]\ndensity_kg_m3 = {DENSITY}\ncoefficients = 'thin-airfoil'\ncentre_of_pressure = 'fixed'\n\
         centre_of_pressure_fraction = {centre}\n\
         [structure]\nkinematics = 'linear'\n\
         [film]\nmaterial = 'gauze'\nthickness_mm = 0.0001\n\
         [material.gauze]\ne_gpa = 1e-6\npoisson = 0.3\ndensity_kg_m3 = 0.0\n\
         [[rod]]\nfrom_mm = 0.0\nto_mm = 1000.0\n[rod.section]\nshape = 'given'\nea_n = 1e5\ngj_n_m2 = {torsion:?}\n\
         ei_flap_n_m2 = 10.0\nei_edge_n_m2 = 100.0\nga_edge_n = 1e5\nga_flap_n = {shear:?}\n{}\n",
        terms
    );
    for column in 0..=columns {
        let at = 1000.0 * column as f64 / columns as f64;
        text += &format!(
            "[[spar]]\nat_mm = {at:?}\n[spar.section]\nshape = 'given'\nea_n = 1e6\ngj_n_m2 = 1e4\n\
             ei_flap_n_m2 = 1e4\nei_edge_n_m2 = 1e4\n"
        );
    }
    let design = Design::from_toml(&text, "uniform.toml").unwrap();
    Wing {
        planform: Planform::from_design(&design).unwrap(),
        mesh: grid(columns, 16),
        design,
    }
}

/// A rectangle of right-angled triangles with a rib on every column; the generator would put columns between the ribs.
fn grid(columns: usize, rows: usize) -> Mesh {
    let node = |column: usize, row: usize| column * (rows + 1) + row;
    let mut mesh = Mesh::default();
    for column in 0..=columns {
        let x = LENGTH_M * column as f64 / columns as f64;
        mesh.nodes
            .extend((0..=rows).map(|row| [x, CHORD_M * row as f64 / rows as f64, 0.0]));
    }
    for column in 0..columns {
        mesh.beams.push(BeamElement {
            nodes: [node(column, 0), node(column + 1, 0)],
            part: BeamPart::Rod(0),
        });
        for row in 0..rows {
            let [a, b] = [node(column, row), node(column + 1, row)];
            let halves = if (column + row) % 2 == 0 {
                [[a, b, b + 1], [a, b + 1, a + 1]]
            } else {
                [[a, b, a + 1], [b, b + 1, a + 1]]
            };
            mesh.triangles.extend(halves);
        }
    }
    for column in 0..=columns {
        let part = BeamPart::Spar(column);
        mesh.beams.extend((0..rows).map(|row| BeamElement {
            nodes: [node(column, row), node(column, row + 1)],
            part,
        }));
    }
    mesh.root = (0..=rows).map(|row| node(0, row)).collect();
    mesh.leading_edge = (0..=columns).map(|column| node(column, 0)).collect();
    mesh.trailing_edge = (0..=columns).map(|column| node(column, rows)).collect();
    mesh
}

/// Nose-up twist over the root angle at every column.
fn nose_up(wing: &Wing, solution: &Solution) -> Vec<f64> {
    let ends = wing.mesh.leading_edge.iter().zip(&wing.mesh.trailing_edge);
    ends.map(|(&leading, &trailing)| {
        let [a, b] = [leading, trailing].map(|node| solution.state.displacement[node].z);
        (a - b) / CHORD_M / ROOT_DEG.to_radians()
    })
    .collect()
}

/// Largest error of the twist at the columns over the twist of the tip.
fn twist_error(columns: usize, ratio: f64) -> f64 {
    let wing = wing(columns, ratio * DIVERGENCE_PA, 0.1);
    let solution = wing.solve();
    let lambda = 0.5 * std::f64::consts::PI * ratio.sqrt();
    let exact = |column: usize| {
        let y = LENGTH_M * column as f64 / columns as f64;
        (lambda * (LENGTH_M - y)).cos() / lambda.cos() - 1.0
    };
    let found = nose_up(&wing, &solution);
    let error = found
        .iter()
        .enumerate()
        .skip(1)
        .map(|(k, t)| (t / exact(k) - 1.0).abs());
    error.fold(0.0, f64::max)
}

#[test]
fn twist_along_the_span_follows_the_closed_form_up_to_nine_tenths_of_divergence() {
    for (columns, ratios) in [(8, [0.1, 0.25, 0.5]), (32, [0.5, 0.75, 0.9])] {
        for ratio in ratios {
            let error = twist_error(columns, ratio);
            println!("{columns} elements, q/q_D = {ratio}: {error:.2e}");
            assert!(error < 0.005, "{columns} elements, q/q_D = {ratio}: {error}");
        }
    }
}

#[test]
fn the_feedback_of_the_air_gives_the_divergence_pressure_from_any_pressure() {
    for (columns, allowed) in [(8, 0.005), (32, 0.0005)] {
        for ratio in [0.05, 0.5, 0.95] {
            let solution = wing(columns, ratio * DIVERGENCE_PA, 0.1).solve();
            let critical = solution.report.critical_pressure_ratio.unwrap() * ratio;
            println!("{columns} elements, from {ratio} q_D: {:.3e}", critical - 1.0);
            assert!(
                (critical - 1.0).abs() < allowed,
                "{columns} from {ratio}: {critical}"
            );
        }
    }
}

#[test]
fn a_sweep_of_the_speed_ends_at_the_divergence_pressure_and_says_so() {
    let (mut stands, mut fails) = (0.9, 1.2);
    for _ in 0..10 {
        let middle = 0.5 * (stands + fails);
        match wing(8, middle * DIVERGENCE_PA, 0.1).try_solve() {
            Ok(_) => stands = middle,
            Err(CouplingError::Diverged { critical_ratio, .. }) => {
                assert!(
                    (critical_ratio * middle - 1.0).abs() < 0.005,
                    "{critical_ratio} at {middle}"
                );
                fails = middle;
            }
            Err(other) => panic!("at {middle} q_D: {other}"),
        }
    }
    println!("sweep: {stands} to {fails}");
    assert!(
        (stands - 1.0).abs() < 0.005 && (fails - 1.0).abs() < 0.005,
        "{stands} {fails}"
    );
}

#[test]
fn beyond_divergence_there_is_no_result_but_the_critical_pressure() {
    for ratio in [1.1, 2.0, 5.0, 20.0] {
        let error = wing(8, ratio * DIVERGENCE_PA, 0.1).try_solve().unwrap_err();
        let CouplingError::Diverged { critical_ratio, .. } = error else {
            panic!("at {ratio} q_D: {error}");
        };
        assert!(
            (critical_ratio * ratio - 1.0).abs() < 0.005,
            "{critical_ratio} at {ratio}"
        );
    }
}

#[test]
fn loaded_behind_its_axis_the_same_wing_washes_out_and_never_diverges() {
    for ratio in [0.5, 4.0, 40.0] {
        let wing = wing(32, ratio * DIVERGENCE_PA, 0.0);
        let solution = wing.solve();
        assert_eq!(solution.report.critical_pressure_ratio, None);
        let mu = 0.5 * std::f64::consts::PI * ratio.sqrt();
        let found = nose_up(&wing, &solution);
        for (column, twist) in found.iter().enumerate() {
            let y = LENGTH_M * column as f64 / 32.0;
            let exact = (mu * (LENGTH_M - y)).cosh() / mu.cosh() - 1.0;
            assert!((twist - exact).abs() < 0.005, "{ratio} at {y}: {twist} {exact}");
        }
    }
}
