//! Laminated beams of Minguet and Dugundji: coupled sections against a shooting solution, and the measurement.
//!
//! The shooting solution works in the frame of the source (axis 2 forward, couplings as printed), so that it also
//! checks the signs of the mirrored couplings in the designs.

use washout::input::measurement::Channel;

use crate::support::{misfit, shipped, stands, sweep};

fn sets(numbers: &[f64]) -> Vec<String> {
    let (rotation, grams) = (numbers[1], numbers[2]);
    vec![
        format!("gravity.root_pitch_deg={rotation}"),
        format!("observation.frame_pitch_deg={rotation}"),
        format!("load[0].mass_kg={}", grams / 1e3),
    ]
}

#[test]
fn displacements_at_half_a_metre_are_those_of_the_exact_beam_with_its_couplings() {
    for (beam, rotation, grams, exact) in [
        (1, 0.0, 200.0, [-19.0215, 0.0, -123.8258]),
        (1, 0.0, 400.0, [-58.3051, 0.0, -211.8171]),
        (1, 45.0, 200.0, [-11.2441, 63.0242, -71.4984]),
        (1, 45.0, 400.0, [-44.1452, 102.2967, -153.1352]),
        (2, 0.0, 200.0, [-34.6491, 8.6628, -165.3865]),
        (2, 0.0, 400.0, [-90.5503, 18.8826, -258.2301]),
        (2, 45.0, 200.0, [-17.8985, 84.7579, -84.9708]),
        (2, 45.0, 400.0, [-57.4945, 138.2537, -156.7918]),
        (3, 0.0, 400.0, [-35.3521, 0.0016, -167.2039]),
        (3, 45.0, 200.0, [-5.4476, 46.6911, -47.7017]),
        (3, 45.0, 400.0, [-20.6261, 88.05, -93.7106]),
    ] {
        let wing = shipped(&format!("minguet-{beam}"), &sets(&[0.0, rotation, grams]));
        let [x, y, z] = wing.moved_mm(0.5);
        println!(
            "{beam}-{rotation}-{grams}: {x:.4} {:.4} {z:.4}, exact {exact:?}",
            -y
        );
        // their axis 2 points forward, ours aft
        for (found, exact) in [x, -y, z].into_iter().zip(exact) {
            assert!(
                (found - exact).abs() < 1e-3 * exact.abs() + 0.01,
                "{found} {exact}"
            );
        }
    }
}

#[test]
fn the_figures_against_the_measurement_stand() {
    use Channel::{ChordwiseDisplacement as Sideways, Deflection, SpanwiseDisplacement as Along};
    let rows = |case: &str| sweep(&format!("minguet-{}", &case[..1]), "minguet", case, sets);
    for (case, channel, expected) in [
        ("1-0-", Deflection, [-4.341, 4.772, 2.130]),
        ("1-0-", Along, [-0.051, 3.514, 3.528]),
        ("1-45-", Sideways, [-6.094, 7.421, 4.427]),
        ("1-45-", Deflection, [0.836, 2.383, 2.246]),
        ("2-0-", Sideways, [-2.637, 3.052, 1.538]),
        ("2-0-", Deflection, [1.190, 6.661, 7.163]),
        ("2-45-", Sideways, [-2.021, 2.306, 1.131]),
        ("2-45-", Deflection, [-2.785, 3.817, 2.646]),
        ("3-0-", Deflection, [-8.249, 9.285, 4.846]),
        ("3-45-", Sideways, [-5.524, 6.437, 3.431]),
        ("3-45-", Deflection, [-6.754, 8.169, 4.822]),
    ] {
        let name = format!("{case}{channel:?}, mm");
        stands(&name, misfit(&rows(case), channel, ""), expected);
    }
}
