//! The summary of a run as a page of text for the person who builds the wing.

use std::fmt::Write;

use super::builder::{engineering, line};
use super::comparison::{rows, sign, stages};
use crate::input::design::FilmCompression;
use crate::lift::{Forces, LiftReport};
use crate::study::{Output, Uncertainty};
use crate::wing::stroke::{StrokeKind, StrokeSummary};

use super::summary::{FlowSummary, RunSummary};
use crate::page::text::{Table, number, significant, wrapped};

/// The page; `folder` is where the files of the run are, if any were written.
pub fn page(summary: &RunSummary, folder: Option<&str>) -> String {
    let mut sections = vec![solved(summary), assumed(summary), twist(summary)];
    sections.extend(summary.uncertainty.as_ref().map(uncertainty));
    sections.extend(summary.lift.as_ref().map(lift));
    sections.extend(summary.stroke.as_ref().map(stroke));
    let film = summary.design.film.as_ref();
    let film_carries = film.is_some_and(|film| film.compression == FilmCompression::Carries);
    sections.push(engineering(&summary.engineering, film_carries));
    if !summary.warnings.is_empty() {
        sections.push(list("Notes", &summary.warnings));
    }
    sections.extend(folder.map(|folder| files(summary, folder)));
    sections.retain(|section| !section.is_empty());
    sections.join("\n")
}

fn solved(summary: &RunSummary) -> String {
    let (wing, mesh, solve) = (&summary.wing, &summary.mesh, &summary.solve);
    let mut text = format!("{}\n", summary.name);
    line(
        &mut text,
        "wing",
        &format!(
            "{} mm long, mean chord {} mm, area {} mm², r1 {}, r2 {} as built (tip cut at {} mm)",
            number(wing.length_mm, 1),
            number(wing.mean_chord_mm, 2),
            number(wing.area_mm2, 0),
            number(wing.r1_hat, 4),
            number(wing.r2_hat, 4),
            number(wing.tip_mm, 1)
        ),
    );
    line(&mut text, "air", &air(summary.flow.as_ref()));
    let source = mesh.file.as_ref().map(|file| format!(", from {file}"));
    line(
        &mut text,
        "mesh",
        &format!(
            "{} nodes, {} triangles, {} beam elements; {} degrees of freedom{}",
            mesh.nodes,
            mesh.triangles,
            mesh.beams,
            solve.dof,
            source.unwrap_or_default()
        ),
    );
    line(
        &mut text,
        "solved",
        &format!(
            "{} iterations, {} Newton steps; residual {}, last change of twist {} deg",
            solve.iterations,
            solve.newton_steps,
            solve
                .residual
                .map_or("–, for there is no load".to_string(), exponent),
            exponent(solve.twist_change_deg)
        ),
    );
    let branch = match solve.negative_pivots {
        0 => "stable (no negative pivot)".to_string(),
        count => format!("NOT stable: {count} negative pivots of the tangent"),
    };
    let divergence = match solve.critical_pressure_ratio {
        // The ratio is an estimate from this shape, so far away it only says that twist takes load off the wing.
        None | Some(100.0..) => "no divergence in sight".to_string(),
        Some(ratio) => format!(
            "divergence at about {} times this dynamic pressure",
            significant(ratio, 3)
        ),
    };
    line(&mut text, "branch", &format!("{branch}; {divergence}"));
    if let Some(moment_mn_mm) = stop_moment_mn_mm(summary) {
        let carries = format!("carries {} mN mm in pitch", significant(moment_mn_mm, 4));
        line(&mut text, "stop", &carries);
    }
    text
}

/// What the pitch stop carries, positive as it pushes; none where a flexure stands between, or nothing flaps.
fn stop_moment_mn_mm(summary: &RunSummary) -> Option<f64> {
    let is_rigid = summary.design.root.pitch_stiffness_n_m_per_rad.is_none();
    let flaps = matches!(summary.flow, Some(FlowSummary::Flapping { .. }));
    (is_rigid && flaps).then(|| -summary.solve.reaction_moment_mn_mm[0])
}

fn air(flow: Option<&FlowSummary>) -> String {
    match flow {
        None => "none; bench loads only".to_string(),
        Some(FlowSummary::Flapping {
            frequency_hz,
            half_amplitude_deg,
            phase_deg,
            root_angle_deg,
            tip_speed_m_s,
            density_kg_m3,
        }) => {
            let phase = if *phase_deg == 0.0 {
                "at mid-stroke".to_string()
            } else {
                format!("at phase {}°", number(*phase_deg, 1))
            };
            format!(
                "flapping at {} Hz, ±{}°, {phase}: tip at {} m/s; root held at {}°; density {} kg/m³",
                significant(*frequency_hz, 3),
                number(*half_amplitude_deg, 1),
                number(*tip_speed_m_s, 2),
                number(*root_angle_deg, 1),
                number(*density_kg_m3, 3)
            )
        }
        Some(FlowSummary::Steady {
            speed_m_s,
            root_angle_deg,
            density_kg_m3,
        }) => format!(
            "steady stream of {} m/s; root held at {}°; density {} kg/m³",
            significant(*speed_m_s, 4),
            number(*root_angle_deg, 2),
            number(*density_kg_m3, 3)
        ),
    }
}

fn assumed(summary: &RunSummary) -> String {
    if summary.assumed.is_empty() && summary.assumed_choices.is_empty() {
        return "Every input is stated as a fact; none is assumed.\n".to_string();
    }
    let mut table = Table::new(["input", "value", "from", "to", "why"]);
    let mut said = "";
    for input in &summary.assumed {
        let [value, low, high] =
            [input.value, input.range[0], input.range[1]].map(|number| number.to_string());
        // A reason that holds for many inputs in a row is said once.
        let why = if input.why == said { "" } else { &input.why };
        said = &input.why;
        table.row([input.key.clone(), value, low, high, why.to_string()]);
    }
    let mut text = "Assumed, not known (--uncertainty says how far these move the result)\n".to_string();
    text.push_str(&table.render());
    let mut table = Table::new(["choice", "value", "why"]);
    for choice in &summary.assumed_choices {
        table.row([choice.key.clone(), choice.value.clone(), choice.why.clone()]);
    }
    if !table.is_empty() {
        let _ = write!(text, "\n{}", table.render());
    }
    text
}

fn twist(summary: &RunSummary) -> String {
    let mut table = Table::new([
        "at",
        "r_mm",
        "chord_mm",
        "twist_deg",
        "alpha_deg",
        "le_deflection_mm",
    ]);
    for row in &summary.profile {
        table.row([
            row.place.clone(),
            number(row.r_mm, 2),
            number(row.chord_mm, 2),
            format!("{}{}", sign(row.bound), number(row.twist_deg, 2)),
            row.alpha_deg.map_or(String::new(), |alpha| number(alpha, 2)),
            number(row.le_deflection_mm, 3),
        ]);
    }
    let mut text = format!("Twist (positive: washout)\n{}", table.render());
    let tip = &summary.tip;
    let at = number(tip.r_mm, 1);
    let read = match (tip.twist_deg, tip.alpha_deg) {
        (Some(twist), Some(alpha)) => {
            format!(
                "{}° at {at} mm, angle of attack {}°",
                number(twist, 2),
                number(alpha, 2)
            )
        }
        (Some(twist), None) => format!("{}° at {at} mm", number(twist, 2)),
        (None, _) => format!("not readable at {at} mm: the chord is too short there"),
    };
    let _ = writeln!(text, "  tip twist {read}");
    text.extend(free_film(summary));
    for skipped in &summary.skipped {
        let _ = writeln!(text, "  not read: {skipped}");
    }
    text.extend(summary.stages.as_ref().map(|fit| format!("\n{}", stages(fit))));
    let measured = summary.measured.as_ref();
    text.extend(measured.map(|comparison| format!("\n{}", rows(comparison))));
    text
}

/// A tip far outboard of the last spar reads the film, not the rod.
fn free_film(summary: &RunSummary) -> Option<String> {
    let mut rows = summary.profile.iter();
    let spar = rows.rfind(|row| row.place.starts_with("spar"))?;
    let is_far = summary.tip.r_mm - spar.r_mm > 0.1 * summary.wing.length_mm;
    (is_far && summary.tip.twist_deg.is_some()).then(|| {
        format!(
            "  outboard of the last spar ({} mm, {}°) the film alone holds the chord\n",
            number(spar.r_mm, 1),
            number(spar.twist_deg, 2)
        )
    })
}

fn uncertainty(band: &Uncertainty) -> String {
    let solved = band.samples - band.failures.len();
    let mut text = format!(
        "Band from the assumed ranges ({solved} solves; {}): 5 to 95 %\n",
        band.distribution
    );
    let mut table = Table::new(["result", "as_solved", "5_%", "median", "95_%"]);
    for output in &band.outputs {
        let [nominal, low, median, high] =
            [output.nominal, output.q05, output.median, output.q95].map(|value| significant(value, 3));
        table.row([output.name.clone(), nominal, low, median, high]);
    }
    text.push_str(&table.render());
    if let Some(failure) = band.failures.first() {
        let left_out = format!(
            "{} of {} samples gave no result and are left out; the first because: {}",
            band.failures.len(),
            band.samples,
            failure.reason
        );
        text.push_str(&wrapped(&left_out, 2));
    }
    let outermost = band
        .outputs
        .iter()
        .rfind(|output| matches!(output.output, Output::Twist { .. }));
    if let Some(output) = outermost {
        let mut table = Table::new(["input", "alone_%", "with_others_%"]);
        for share in &output.shares {
            table.row([
                share.key.clone(),
                number(100.0 * share.first_order, 1),
                number(100.0 * share.total, 1),
            ]);
        }
        if !table.is_empty() {
            let _ = write!(
                text,
                "\nInputs by their share in the variance of the {}\n{}",
                output.name,
                table.render()
            );
        }
        if let Some(quality) = &output.surrogate {
            let [explains, predicts] = [quality.r_squared, quality.predictive_r_squared];
            let _ = writeln!(
                text,
                "  (from a polynomial of {} terms: R² {}, and {} for samples left out)",
                quality.terms,
                number(explains, 3),
                number(predicts, 3)
            );
        }
    }
    text
}

/// A drag below this is rounding (as at a reversal, where the wing stands still), and a ratio to it says nothing.
const ROUNDING_MN: f64 = 1e-6;

fn lift(report: &LiftReport) -> String {
    let mut table = Table::new(["one wing", "lift_mn", "drag_mn", "power_mw", "lift/drag"]);
    for forces in [&report.solved].into_iter().chain(&report.stroke_mean) {
        table.row([
            forces.name.clone(),
            number(forces.lift_mn, 2),
            number(forces.drag_mn, 2),
            number(forces.power_mw, 2),
            forces
                .lift_to_drag
                .filter(|_| forces.drag_mn > ROUNDING_MN)
                .map_or("–".to_string(), |ratio| number(ratio, 3)),
        ]);
    }
    format!("Lift, drag, power\n{}", table.render())
}

fn stroke(stroke: &StrokeSummary) -> String {
    let mut table = Table::new([
        "phase_deg",
        "tip_twist_deg",
        "standing_deg",
        "lift_mn",
        "drag_mn",
        "power_mw",
        "stop_mn_mm",
    ]);
    let shown = |value: Option<f64>, digits| value.map_or(String::new(), |value| number(value, digits));
    for row in &stroke.phases {
        let force = |pick: fn(&Forces) -> f64| shown(row.forces.as_ref().map(pick), 2);
        let moving = row.moving.as_ref();
        let flips = if moving.is_some_and(|moving| moving.is_flipping) {
            " flips"
        } else {
            ""
        };
        table.row([
            number(row.phase_deg, 1),
            shown(row.tip_twist_deg, 2),
            shown(
                moving.map_or(row.tip_twist_deg, |moving| moving.standing_tip_twist_deg),
                2,
            ),
            force(|forces| forces.lift_mn),
            force(|forces| forces.drag_mn),
            force(|forces| forces.power_mw),
            shown(row.stop_moment_mn_mm, 1) + flips,
        ]);
    }
    let head = match stroke.kind {
        StrokeKind::Periodic => {
            "Over the stroke, in motion (standing: if it stood still under the load of the phase)"
        }
        StrokeKind::QuasiStatic => "Over the stroke, each phase as if it stood still",
    };
    let mut text = format!("{head}\n{}", table.render());
    if let Some(mean) = &stroke.mean {
        let [lift, drag, power] = [mean.lift_mn, mean.drag_mn, mean.power_mw].map(|value| number(value, 2));
        let _ = writeln!(
            text,
            "  {}: lift {lift} mN, drag {drag} mN, power {power} mW",
            mean.name
        );
    }
    if let Some(periodic) = &stroke.periodic {
        let modes: Vec<String> = periodic.mode_hz.iter().map(|hz| number(*hz, 0)).collect();
        let _ = writeln!(
            text,
            "  made of modes at {} Hz; assumed: {} % of critical damping, flips that take {} % of the stroke each",
            modes.join(", "),
            number(1e2 * periodic.damping_ratio, 1),
            number(1e2 * periodic.flip_share, 0)
        );
    }
    text
}

fn files(summary: &RunSummary, folder: &str) -> String {
    format!("Files in {folder}: {}\n", summary.files.join(" "))
}

fn list(head: &str, lines: &[String]) -> String {
    lines
        .iter()
        .fold(format!("{head}\n"), |text, line| text + "  " + line + "\n")
}

fn exponent(value: f64) -> String {
    format!("{value:.1e}")
}
