//! Effects of the user's own: what their formulas do, and what is said of wrong ones.

use washout::coupling::wing::Wing;
use washout::effects::bind;
use washout::input::design::Design;
use washout::mesh::for_design;
use washout::structure::state::State;

use super::closed_forms::{self, rectangle, solve};

const AIR: &str = "[film]\nmaterial = 'steel'\nthickness_mm = 0.01\n\
                   [flapping]\nfrequency_hz = 20.0\nhalf_amplitude_deg = 30.0\n";

fn own(acts_on: &str, expression: &str, more: &str) -> String {
    format!(
        "[effects.mine]\nkind = 'custom'\nacts_on = '{acts_on}'\nexpression = '{expression}'\nstrength = 1.0\n{more}"
    )
}

/// Normal force (N) and moment about the leading edge (N·m) of the air on the wing at rest.
fn air(design: &Design) -> (f64, f64) {
    let (_, mesh) = for_design(design, None).unwrap();
    let wing = closed_forms::wing(design, &mesh);
    let shapes = wing.strips.shapes(&State::at_rest(mesh.nodes.len()));
    let force = wing.air_force(&wing.strip_air(&shapes, false).unwrap());
    let nodes = force.iter().zip(&mesh.nodes);
    nodes.fold((0.0, 0.0), |(total, moment), (force, x)| {
        (total + force.z, moment + force.z * x[1])
    })
}

/// k q c² over the span: q = ½ρ(Ωr')², so the moment is k ½ρΩ²c² ((R+r₀)³ − r₀³)/3 = 0.1 · 3.7083e-3 N·m.
#[test]
fn a_formula_of_ones_own_does_what_it_says() {
    let base = rectangle(AIR);
    let number = "k = { assumed = 0.1, range = [0.0, 0.5], why = 'a try' }\n";
    let moment = rectangle(&format!("{AIR}{}", own("moment", "k * q * chord^2", number)));
    let rate = std::f64::consts::TAU * 20.0 * 30f64.to_radians();
    let expected = 0.1 * 0.5 * 1.2 * rate * rate * 4e-4 * (0.13f64.powi(3) - 0.03f64.powi(3)) / 3.0;
    let (before, after) = (air(&base), air(&moment));
    assert!(
        ((after.1 - before.1) / expected - 1.0).abs() < 1e-4,
        "{after:?} {before:?} {expected}"
    );
    assert!((after.0 - before.0).abs() < 1e-12);
    // 2 x N/m over the span of 100 mm: 0.1 N
    let force = rectangle(&format!("{AIR}{}", own("force", "2 * x", "")));
    assert!((air(&force).0 - before.0 - 0.1).abs() < 1e-6);
    // half of the factor's way from 1 to 3
    let lift = rectangle(&format!(
        "{AIR}{}",
        own("lift", "3", "").replace("= 1.0", "= 0.5")
    ));
    let drag = rectangle(&format!(
        "{AIR}{}",
        own("drag", "3", "").replace("= 1.0", "= 0.5")
    ));
    let (lift, drag) = (air(&lift).0, air(&drag).0);
    assert!(((lift + drag) / (3.0 * before.0) - 1.0).abs() < 1e-12);
    let shift = rectangle(&format!("{AIR}{}", own("centre-of-pressure", "0.255", "")));
    assert!((air(&shift).1 / before.1 - 2.0).abs() < 1e-9);
}

/// θ = ∫ T/GJ dx, GJ' = GJ / (1 + x): 1.5 times the twist of the plain rod.
#[test]
fn a_stiffness_of_ones_own_varies_along_the_rod() {
    let load = "[[load]]\nat_mm = 100.0\nmoment_n_m = [0.001, 0.0, 0.0]\n";
    let turn = |more: &str| {
        let solution = solve(&rectangle(&format!("{load}{more}")));
        solution.state.rotation[*solution.mesh.rod_nodes().last().unwrap()]
            .scaled_axis()
            .x
    };
    let ratio = turn(&own("torsion", "1 / (1 + x)", "")) / turn("");
    assert!((ratio - 1.5).abs() < 1e-9, "{ratio}");
}

#[test]
fn wrong_tables_of_ones_own_are_refused_with_a_cure() {
    for (table, said) in [
        (own("moment", "k * q", ""), "'k * q', column 1: there is no k; "),
        (own("momentum", "q", ""), "write one of moment, force"),
        (
            own("moment", "q", "k = 1.0\n"),
            "effects.mine.k: the formula does not use it",
        ),
        (own("moment", "q * r", "r = 1.0\n"), "the name is taken"),
        (
            own("moment", "k * q", "k = 'soft'\n"),
            "effects.mine.k: \"soft\" is no number",
        ),
        (
            own(
                "moment",
                "k * q",
                "k = { assumed = 2.0, range = [0.0, 1.0], why = '' }\n",
            ),
            "outside its own range 0 … 1",
        ),
        (own("torsion", "1 - 2 * x", ""), "stays positive"),
        (own("torsion", "1 + alpha", ""), "a rod has no alpha"),
        (own("spars", "1 - 2 * along", ""), "stays positive"),
        (own("spars", "along - 0.1", ""), "at x = 0.00, along = 0.00"),
        (own("torsion", "1 + along", ""), "a rod has no along"),
        (own("lift", "1 + along", ""), "a strip of the wing has no along"),
        (own("moment", "1 / x", ""), "stays finite"),
        (
            "[effects.mine]\nstrength = 1.0\n".to_string(),
            "kind = \"custom\"",
        ),
        (
            "[effects.mine]\nkind = 'custom'\nacts_on = 'force'\nexpression = 'q'\n".to_string(),
            "give its strength",
        ),
        (
            "[effects.mine]\nkind = 'custom'\nacts_on = 'force'\nstrength = 1.0\n".to_string(),
            "there is no formula",
        ),
        (
            "[effects.mine]\nkind = 'other'\nstrength = 1.0\n".to_string(),
            "no kind of effect",
        ),
    ] {
        let error = bind(&rectangle(&format!("{AIR}{table}")))
            .expect_err(&table)
            .to_string();
        assert!(error.contains(said), "{error}");
    }
}

#[test]
fn the_example_of_ones_own_acts() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/effect_of_ones_own.toml");
    let table = std::fs::read_to_string(path).unwrap();
    let design = rectangle(&format!("{AIR}{table}"));
    let bound = bind(&design).unwrap();
    assert_eq!(bound.len(), 1);
    assert_eq!(bound[0].effect.card().name, "glue-seam");
    assert_eq!(design.assumptions().len(), 1);
    // its number can be set like any other, and no twist is no moment
    let mut other = design.clone();
    other.set("effects.glue-seam.k", 1.5).unwrap();
    assert_eq!(other.get("effects.glue-seam.k"), Some(1.5));
    assert!((air(&design).1 - air(&rectangle(AIR)).1).abs() < 1e-12);
    assert!(other.set("effects.glue-seam.k", 1.0).is_ok() && bind(&other).is_ok());
}

/// A formula over the twist rate takes it from the wing without the formula.
#[test]
fn a_formula_of_ones_own_may_brake_by_the_twist_rate() {
    let plate = AIR.replace("0.01", "0.15") + "[mesh]\nrefine = 0.5\n";
    let braked = rectangle(&format!("{plate}{}", own("moment", "-2e-4 * twist_rate", "")));
    let (_, mesh) = for_design(&braked, None).unwrap();
    let wing = closed_forms::wing(&braked, &mesh);
    let motion = wing.motion.clone().unwrap();
    let shapes = wing.strips.shapes(&State::at_rest(mesh.nodes.len()));
    let sum = |wing: &Wing| -> f64 {
        let force = wing.air_force(&wing.strip_air(&shapes, false).unwrap());
        force
            .iter()
            .zip(&mesh.nodes)
            .map(|(force, x)| force.z * x[1])
            .sum()
    };
    let plain = Wing::new(&rectangle(&plate), &mesh, None).unwrap();
    let rates = wing
        .strips
        .strips
        .iter()
        .map(|strip| motion.twist_rate_rad_s(strip.r_m) * strip.width_m);
    let expected = -2e-4 * rates.sum::<f64>();
    assert!(((sum(&wing) - sum(&plain)) / expected - 1.0).abs() < 1e-9);
}
