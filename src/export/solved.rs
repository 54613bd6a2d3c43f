//! What was solved and how, a line each: wing, air, mesh, steps, and whether the shape stands.

use super::summary::{FlowSummary, RunSummary};
use crate::page::Digits::{After, Significant};
use crate::page::Line;
use crate::page::text::significant;

/// The wing, the air, the mesh, the steps, the branch.
pub fn solved(summary: &RunSummary) -> Vec<Line> {
    let (wing, mesh, solve) = (&summary.wing, &summary.mesh, &summary.solve);
    let counts = [
        ("/mesh/nodes", mesh.nodes, " nodes, "),
        ("/mesh/triangles", mesh.triangles, " triangles, "),
        ("/mesh/beams", mesh.beams, " beam elements; "),
        ("/solve/dof", solve.dof, " degrees of freedom"),
    ];
    let counted = counts
        .iter()
        .fold(Line::new("mesh"), |line, (place, count, words)| {
            line.number(place, *count as f64, After(0)).words(*words)
        });
    let source = mesh.file.as_ref().map(|file| format!(", from {file}"));
    let steps = Line::new("solved")
        .number("/solve/iterations", solve.iterations as f64, After(0))
        .words(" iterations, ")
        .number("/solve/newton_steps", solve.newton_steps as f64, After(0))
        .words(" Newton steps; residual ");
    let steps = match solve.residual {
        Some(residual) => steps.number("/solve/residual", residual, Significant(2)),
        None => steps.words("within rounding"),
    };
    let mut lines = vec![
        Line::new("design").words(format!(
            "{}; washout {}",
            summary.design_file, summary.made_of.washout_version
        )),
        Line::new("wing")
            .number("/wing/length_mm", wing.length_mm, After(1))
            .words(" mm long, mean chord ")
            .number("/wing/mean_chord_mm", wing.mean_chord_mm, After(2))
            .words(" mm, area ")
            .number("/wing/area_mm2", wing.area_mm2, After(0))
            .words(" mm², r1 ")
            .number("/wing/r1_hat", wing.r1_hat, After(4))
            .words(", r2 ")
            .number("/wing/r2_hat", wing.r2_hat, After(4))
            .words(" as built; the tip is the station at ")
            .number("/wing/tip_mm", wing.tip_mm, After(1))
            .words(" mm"),
        air(summary),
        counted.words(source.unwrap_or_default()),
        steps
            .words(", last change of twist ")
            .number("/solve/twist_change_deg", solve.twist_change_deg, Significant(2))
            .words(" deg"),
    ];
    lines.extend(branch(summary));
    lines
}

/// Whether the shape stands, how near divergence is, and what the stop carries.
pub fn branch(summary: &RunSummary) -> Vec<Line> {
    let solve = &summary.solve;
    let branch = match solve.negative_pivots {
        0 => Line::new("branch").words("stable (no negative pivot)"),
        count => Line::new("branch")
            .words("NOT stable: ")
            .number("/solve/negative_pivots", count as f64, After(0))
            .words(" negative pivots of the tangent"),
    };
    let mut lines = vec![match diverges_at(summary) {
        None => branch.words("; no divergence in sight"),
        Some(ratio) => branch
            .words("; divergence at about ")
            .number("/solve/critical_pressure_ratio", ratio, Significant(3))
            .words(" times this dynamic pressure"),
    }];
    lines.extend(
        stop_moment_mn_mm(summary).map(|moment| {
            Line::new("stop").words(format!("carries {} mN mm in pitch", significant(moment, 4)))
        }),
    );
    lines
}

/// How many times this dynamic pressure the wing diverges, if that is in sight: the ratio is an estimate from this shape, so far away it only
/// says that twist takes load off the wing.
pub fn diverges_at(summary: &RunSummary) -> Option<f64> {
    summary
        .solve
        .critical_pressure_ratio
        .filter(|ratio| *ratio < 100.0)
}

/// What the pitch stop carries, positive as it pushes; none where a flexure stands between, or nothing flaps.
fn stop_moment_mn_mm(summary: &RunSummary) -> Option<f64> {
    let is_rigid = summary.design.root.pitch_stiffness_n_m_per_rad.is_none();
    let flaps = matches!(summary.flow, Some(FlowSummary::Flapping { .. }));
    (is_rigid && flaps).then(|| -summary.solve.reaction_moment_mn_mm[0])
}

/// The air and its laws in a line.
fn air(summary: &RunSummary) -> Line {
    let line = stream(summary.flow.as_ref());
    if summary.flow.is_none() {
        return line;
    }
    let air = &summary.design.air;
    let word =
        |word: Result<toml::Value, _>| word.map_or(String::new(), |word: toml::Value| word.to_string());
    let coefficients = word(toml::Value::try_from(air.coefficients));
    let centre = word(toml::Value::try_from(air.centre_of_pressure()));
    line.words(format!(
        "; coefficients {coefficients}, centre of pressure {centre}"
    ))
}

/// The air in a line.
fn stream(flow: Option<&FlowSummary>) -> Line {
    let line = Line::new("air");
    match flow {
        None => line.words("none; bench loads only"),
        Some(FlowSummary::Flapping {
            frequency_hz,
            half_amplitude_deg,
            phase_deg,
            root_angle_deg,
            tip_speed_m_s,
            density_kg_m3,
        }) => {
            let line = line
                .words("flapping at ")
                .number("/flow/frequency_hz", *frequency_hz, Significant(3))
                .words(" Hz, ±")
                .number("/flow/half_amplitude_deg", *half_amplitude_deg, After(1));
            let line = match *phase_deg {
                0.0 => line.words("°, at mid-stroke"),
                phase => line
                    .words("°, at phase ")
                    .number("/flow/phase_deg", phase, After(1))
                    .words("°"),
            };
            line.words(": tip at ")
                .number("/flow/tip_speed_m_s", *tip_speed_m_s, After(2))
                .words(" m/s; root held at ")
                .number("/flow/root_angle_deg", *root_angle_deg, After(1))
                .words("°; density ")
                .number("/flow/density_kg_m3", *density_kg_m3, After(3))
                .words(" kg/m³")
        }
        Some(FlowSummary::Steady {
            speed_m_s,
            root_angle_deg,
            density_kg_m3,
        }) => line
            .words("steady stream of ")
            .number("/flow/speed_m_s", *speed_m_s, Significant(4))
            .words(" m/s; root held at ")
            .number("/flow/root_angle_deg", *root_angle_deg, After(2))
            .words("°; density ")
            .number("/flow/density_kg_m3", *density_kg_m3, After(3))
            .words(" kg/m³"),
    }
}
