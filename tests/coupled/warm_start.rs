//! A solve that starts from a solution nearby finds the same shape, in fewer steps.

use washout::coupling;
use washout::coupling::solution::Solution;
use washout::progress::Progress;

use crate::support::{Wing, apart, shipped};

fn solve_from(wing: &Wing, nearby: &Solution) -> Solution {
    let Wing { design, mesh, .. } = wing;
    coupling::solve_from(design, mesh, None, Some(nearby), &Progress::quiet()).unwrap()
}

#[test]
fn a_start_nearby_gives_the_twist_of_a_start_from_rest_in_less_than_half_the_steps() {
    for (name, spar) in [("rigid", 49.1), ("twist-v1", 35.1), ("twist-v2", 35.1)] {
        let start = shipped(name, &[]).solve();
        // another load, another rod, another place of a spar, which moves the nodes
        let last_spar = if name == "rigid" { "spar[1]" } else { "spar[2]" };
        for set in [
            "flapping.half_amplitude_deg=32".to_string(),
            "material.carbon-rod.g_gpa=4.4".to_string(),
            format!("{last_spar}.at_mm={spar}"),
        ] {
            let wing = shipped(name, &[&set]);
            let (cold, warm) = (wing.solve(), solve_from(&wing, &start));
            let difference = apart(&wing.twists(&warm), &wing.twists(&cold));
            let (warm, cold) = (warm.report.newton_steps, cold.report.newton_steps);
            println!("{name} {set}: {warm} steps for {cold}, apart {difference:.1e}");
            assert!(difference < 1e-7, "{name} {set}: {difference}");
            assert!(2 * warm < cold, "{name} {set}: {warm} steps for {cold}");
        }
    }
}

#[test]
fn a_solution_on_another_pattern_is_no_start_and_does_no_harm() {
    let wing = shipped("twist-v1", &[]);
    let coarse = shipped("twist-v1", &["mesh.refine=0.5"]).solve();
    assert_eq!(solve_from(&wing, &coarse).state, wing.solve().state);
}
