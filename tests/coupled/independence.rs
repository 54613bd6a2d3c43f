//! What must not matter does not: load increments, accelerator, drilling stiffness, number of threads.

use washout::coupling::solution::Solution;
use washout::input::Design;

use crate::support::{Wing, apart, lift_n, shipped};

/// Relative difference of the twist at the spar ends and the tip, and of the lift.
fn moved(a: (&Wing, &Solution), b: (&Wing, &Solution)) -> [f64; 2] {
    let lift = lift_n(a.0, a.1) / lift_n(b.0, b.1) - 1.0;
    [apart(&a.0.twists(a.1), &b.0.twists(b.1)), lift.abs()]
}

#[test]
fn load_increments_and_accelerator_leave_twist_and_lift_within_a_millionth() {
    for name in ["twist-v1", "twist-v2"] {
        let base = shipped(name, &[]);
        let solution = base.solve();
        for set in [
            "structure.load_increments=3",
            "structure.load_increments=10",
            "coupling.accelerator=none",
            "coupling.accelerator=aitken",
            "coupling.accelerator=anderson",
        ] {
            let other = shipped(name, &[set]);
            let again = other.solve();
            let errors = moved((&other, &again), (&base, &solution));
            let report = &again.report;
            println!(
                "{name} {set}: {errors:?}, {} iterations, {} steps",
                report.iterations, report.newton_steps
            );
            assert!(
                errors.iter().all(|error| *error < 1e-6),
                "{name} {set}: {errors:?}"
            );
        }
    }
}

/// A strip of 500 × 50 mm, flat to the load: 20 N press along its chord, 1 N across tells it to which side to go. It buckles sideways at 13.4 N
/// (4.013 √(EI GJ)/L²), and from there on another stable shape stands at −52°, which a long increment may fall into.
#[test]
fn a_strip_that_buckles_sideways_turns_to_the_side_of_its_load_for_any_number_of_increments() {
    let text = r#"
format = 1
name = "strip"

[planform]
length_mm = 500.0
outline = [[0.0, 50.0], [500.0, 50.0]]
base_closure = 0.0
tip_cut = 1.0

[ribs]
bays = 20
rod_chord_fraction = 0.5

[[rod]]
from_mm = 0.0
to_mm = 500.0

[rod.section]
shape = "given"
gj_n_m2 = 0.7
ei_flap_n_m2 = 1.0
ei_edge_n_m2 = 1e4
ea_n = 1e7
mass_kg_m = 0.2

[[load]]
at_mm = 500.0
chord_offset_mm = 25.0
force_n = [0.0, -20.0, 1.0]

[structure]
load_increments = INCREMENTS
"#;
    for increments in [1, 2, 3, 4, 5, 7, 10, 50] {
        let text = text.replace("INCREMENTS", &increments.to_string());
        let wing = Wing::of(Design::from_toml(&text, "strip.toml").expect("a design"));
        let tip_deg = wing.twists(&wing.solve()).last().expect("a tip").to_degrees();
        println!("{increments} increments: {tip_deg:.3} deg");
        assert!(
            (tip_deg - 49.7).abs() < 0.1,
            "{increments} increments: {tip_deg} deg"
        );
    }
}

/// The sheet carries compression and bends, so that the answer is one of rounding and not of which triangle wrinkles.
#[test]
fn a_factor_by_all_threads_gives_the_same_wing_within_a_ten_billionth() {
    let sheet = [
        "film.compression=\"carries\"",
        "film.thickness_mm=0.1",
        "mesh.refine=2",
    ];
    let [one, all] = ["one-thread", "parallel"].map(|by| {
        let by = format!("structure.factorization={by}");
        shipped("twist-v2", &[sheet[0], sheet[1], sheet[2], &by])
    });
    let errors = moved((&all, &all.solve()), (&one, &one.solve()));
    assert!(errors.iter().all(|error| *error < 1e-10), "{errors:?}");
}

/// Movement of twist and lift with ten times and a tenth of the drilling stiffness.
fn drilling(name: &str, base: (&Wing, &Solution)) -> Vec<[f64; 2]> {
    let other = |factor: f64| {
        let wing = shipped(name, &[&format!("structure.drilling_factor={factor}")]);
        moved((&wing, &wing.solve()), base)
    };
    [10.0, 0.1].map(other).to_vec()
}

/// The mesh error is 1.4e-3 (v1) and 1.2e-2 (v2), see below: these are less than a tenth of it.
#[test]
fn drilling_stiffness_hardly_moves_twist_and_lift() {
    for name in ["twist-v1", "twist-v2"] {
        let base = shipped(name, &[]);
        let errors = drilling(name, (&base, &base.solve()));
        println!("{name} drilling: {errors:?}");
        assert!(
            errors.iter().flatten().all(|error| *error < 1e-4),
            "{name}: {errors:?}"
        );
    }
}

#[test]
#[ignore = "solves both wings on meshes four times as large: a minute"]
fn drilling_stiffness_moves_twist_and_lift_far_less_than_the_mesh_does() {
    for name in ["twist-v1", "twist-v2"] {
        let base = shipped(name, &[]);
        let solution = base.solve();
        let fine = shipped(name, &["mesh.refine=2"]);
        let mesh_errors = moved((&base, &solution), (&fine, &fine.solve()));
        for errors in drilling(name, (&base, &solution)) {
            println!("{name} drilling: {errors:?}, mesh {mesh_errors:?}");
            let small = errors
                .iter()
                .zip(mesh_errors)
                .all(|(error, mesh)| *error < 0.1 * mesh);
            assert!(small, "{name}: {errors:?} {mesh_errors:?}");
        }
    }
}

#[test]
fn one_and_two_threads_give_the_same_bits() {
    for name in ["twist-v1", "twist-v2"] {
        let with = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| shipped(name, &[]).solve())
        };
        let (one, two) = (with(1), with(2));
        let bits = |solution: &Solution| -> Vec<u64> {
            let nodes = solution.state.displacement.iter().zip(&solution.state.rotation);
            nodes
                .flat_map(|(u, q)| {
                    u.iter()
                        .chain(q.coords.iter())
                        .map(|x| x.to_bits())
                        .collect::<Vec<_>>()
                })
                .collect()
        };
        assert_eq!(bits(&one), bits(&two), "{name}");
        assert_eq!(one.report, two.report, "{name}");
        assert_eq!(one.strips, two.strips, "{name}");
    }
}
