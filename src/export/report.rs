//! A solved wing, for people: what it twists by first, then what that rests on.

use crate::compare::ModelledStages;
use crate::input::design::FilmCompression;
use crate::lift::{Forces, LiftReport};
use crate::page::Digits::{After, Significant};
use crate::page::text::number;
use crate::page::{Digits, Fact, Page, Part, Rows, Table};
use crate::wing::stroke::{StrokeKind, StrokeSummary};

use super::band::{band, band_at_the_tip};
use super::comparison::{against, left, said, sign, stages};
use super::engineering::engineering;
use super::pictures::profile::{self, StripRow};
use super::solved::{branch, diverges_at, solved};
use super::summary::{AssumedInput, RunSummary};

/// Rows that a screen shows of a stroke, or of a band and where it comes from.
const FIRST: usize = 3;

/// What `washout solve` says; `strips`: the air along the span, for its figure.
pub fn page(summary: &RunSummary, strips: &[StripRow]) -> Page {
    let mut page = Page {
        title: summary.name.clone(),
        kind: "summary",
        lead: vec![headline(summary), Part::Notes(summary.warnings.clone())],
        brief: brief(summary),
        sections: Vec::new(),
    };
    page.section("solved", "What was solved", vec![Part::Named(solved(summary))]);
    page.section("twist", "Twist (positive: washout)", twist(summary));
    if let Some(found) = &summary.measured {
        let parts = [said(found), against("/measured", found), left(found)].concat();
        page.section("measured", "Against the measurement", parts);
    }
    if let Some(lift) = &summary.lift {
        let mut parts = vec![Part::Table(forces(lift))];
        if !strips.is_empty() {
            parts.push(Part::Figure(profile::strips(&summary.name, strips)));
        }
        page.section("air", "Lift, drag, power", parts);
    }
    if let Some(found) = &summary.stroke {
        let mut parts = stroke(found);
        parts.insert(0, Part::Figure(profile::stroke(summary)));
        page.section("stroke", "Over the stroke", parts);
    }
    let film = summary.design.film.as_ref();
    let film_carries = film.is_some_and(|film| film.compression == FilmCompression::Carries);
    let lines = engineering(&summary.engineering, film_carries);
    if !lines.is_empty() {
        page.section(
            "engineering",
            "Mass, frequencies, stresses",
            vec![Part::Named(lines)],
        );
    }
    page.section("assumed", "Assumed, not known", assumed(summary));
    if let Some(found) = &summary.uncertainty {
        page.section("band", "How far the assumed ranges move it", band(found));
    }
    page
}

/// What counts of a solved wing, what to keep in mind, what was asked for besides, and the twist along the span; how it stands where
/// that is no matter of course.
fn brief(summary: &RunSummary) -> Vec<Part> {
    let mut facts = [twist_facts(summary), lift_facts(summary)].concat();
    facts.extend(mass_and_frequency_facts(summary).into_iter().take(1));
    let mut parts = vec![Part::Headline(facts), Part::Notes(summary.warnings.clone())];
    if summary.solve.negative_pivots > 0 || diverges_at(summary).is_some() {
        parts.push(Part::Named(branch(summary).into_iter().take(1).collect()));
    }
    let asked = summary.stroke.iter().flat_map(stroke);
    for part in asked.chain(summary.uncertainty.iter().flat_map(band_at_the_tip)) {
        if let Part::Table(mut table) = part {
            table.most_in_text = table.most_in_text.min(FIRST);
            table.caption = String::new();
            parts.push(Part::Table(table));
        }
    }
    parts.push(Part::Table(profile(summary)));
    parts
}

fn headline(summary: &RunSummary) -> Part {
    Part::Headline(
        [
            twist_facts(summary),
            lift_facts(summary),
            mass_and_frequency_facts(summary),
        ]
        .concat(),
    )
}

fn fact(place: &str, label: &'static str, value: Option<f64>, unit: &'static str, digits: Digits) -> Fact {
    Fact {
        place: place.to_string(),
        label,
        value,
        unit,
        digits,
    }
}

fn twist_facts(summary: &RunSummary) -> Vec<Fact> {
    let tip = &summary.tip;
    let span = summary.measured.as_ref().and_then(|found| found.span.first());
    vec![
        fact(
            "/tip/twist_deg",
            "Tip twist, washout positive",
            tip.twist_deg,
            "°",
            After(2),
        ),
        fact(
            "/tip/alpha_deg",
            "Angle of attack at the tip",
            tip.alpha_deg,
            "°",
            After(2),
        ),
        fact(
            "/measured/span/0/rmse_along_span_deg",
            "Error along the span, rms",
            span.map(|span| span.rmse_along_span_deg),
            "°",
            After(1),
        ),
        fact(
            "/mesh_error/tip_twist_deg",
            "Mesh error of the tip twist",
            summary.mesh_error.tip_twist_deg,
            "°",
            After(2),
        ),
    ]
}

fn lift_facts(summary: &RunSummary) -> Vec<Fact> {
    let lift = summary.lift.as_ref();
    let mean = lift.and_then(|lift| lift.stroke_mean.as_ref());
    vec![
        fact(
            "/lift/solved/lift_mn",
            "Lift, one wing, as solved",
            lift.map(|lift| lift.solved.lift_mn),
            "mN",
            After(2),
        ),
        fact(
            "/lift/stroke_mean/lift_mn",
            "Mean lift over the stroke",
            mean.map(|mean| mean.lift_mn),
            "mN",
            After(2),
        ),
        fact(
            "/lift/stroke_mean/power_mw",
            "Mean power",
            mean.map(|mean| mean.power_mw),
            "mW",
            After(1),
        ),
    ]
}

fn mass_and_frequency_facts(summary: &RunSummary) -> Vec<Fact> {
    let engineering = &summary.engineering;
    vec![
        fact(
            "/engineering/mass_mg",
            "Mass",
            engineering.mass_mg,
            "mg",
            Significant(4),
        ),
        fact(
            "/engineering/natural_frequencies_in_air_hz/0",
            "Lowest frequency, with air",
            engineering.natural_frequencies_in_air_hz.first().copied(),
            "Hz",
            After(1),
        ),
    ]
}

/// Twist at every station.
fn profile(summary: &RunSummary) -> Table {
    Rows::of("/profile", &summary.profile)
        .words("at", |row| row.place.as_str())
        .number(["r_mm", "r", "mm"], After(2), |row| row.r_mm)
        .number(["chord_mm", "chord", "mm"], After(2), |row| row.chord_mm)
        .bounded(["twist_deg", "twist", "deg"], After(2), |row| {
            (sign(row.bound), row.twist_deg)
        })
        .number(["sigma_deg", "σ of reading", "deg"], After(2), |row| {
            row.sigma_deg
        })
        .number(["alpha_deg", "alpha", "deg"], After(2), |row| row.alpha_deg)
        .number(["le_deflection_mm", "deflection", "mm"], After(3), |row| {
            row.le_deflection_mm
        })
        .number(["le_sweep_mm", "sweep", "mm"], After(3), |row| row.le_sweep_mm)
        .along()
        .table()
}

fn twist(summary: &RunSummary) -> Vec<Part> {
    let tip = &summary.tip;
    let at = number(tip.r_mm, 1);
    let mut parts = vec![
        Part::Figure(profile::twist(summary)),
        Part::Table(profile(summary)),
        Part::Text(
            "As the instrument of the design reads it; alpha: angle of attack of the chord; deflection and sweep: of the leading \
             edge, across and in the wing plane."
                .to_string(),
        ),
    ];
    parts.extend(tip.twist_deg.is_none().then(|| {
        Part::Text(format!(
            "Tip twist is not readable at {at} mm: the chord is too short there."
        ))
    }));
    parts.extend(free_film(summary).map(Part::Text));
    parts.push(Part::List(
        summary
            .skipped
            .iter()
            .map(|skipped| format!("not read: {skipped}"))
            .collect(),
    ));
    let fit: Option<&ModelledStages> = summary.stages.as_ref();
    parts.extend(fit.into_iter().flat_map(|fit| stages("/stages", fit)));
    parts
}

/// A tip far outboard of the last spar reads the film, not the rod.
fn free_film(summary: &RunSummary) -> Option<String> {
    let mut rows = summary.profile.iter();
    let spar = rows.rfind(|row| row.place.starts_with("spar"))?;
    let is_far = summary.tip.r_mm - spar.r_mm > 0.1 * summary.wing.length_mm;
    (is_far && summary.tip.twist_deg.is_some()).then(|| {
        format!(
            "Outboard of the last spar ({} mm, {}°) the film alone holds the chord.",
            number(spar.r_mm, 1),
            number(spar.twist_deg, 2)
        )
    })
}

/// A drag below this is rounding (as at a reversal, where the wing stands still), and a ratio to it says nothing.
const ROUNDING_MN: f64 = 1e-6;

fn forces(report: &LiftReport) -> Table {
    let mean = report.stroke_mean.as_ref().map(|mean| ("stroke_mean", mean));
    let above_rounding = |row: &Forces| row.lift_to_drag.filter(|_| row.drag_mn > ROUNDING_MN);
    Rows::keyed("/lift", [("solved", &report.solved)].into_iter().chain(mean))
        .words("one wing", |row| row.name.as_str())
        .number(["lift_mn", "lift", "mN"], After(2), |row| row.lift_mn)
        .number(["drag_mn", "drag", "mN"], After(2), |row| row.drag_mn)
        .number(["power_mw", "power", "mW"], After(2), |row| row.power_mw)
        .number(["lift_to_drag", "lift over drag", ""], After(3), above_rounding)
        .number(
            ["lift_per_power_n_per_w", "lift per power", "N/W"],
            After(3),
            |row| row.lift_per_power_n_per_w,
        )
        .table()
}

fn stroke(stroke: &StrokeSummary) -> Vec<Part> {
    let head = match stroke.kind {
        StrokeKind::Periodic => "In motion; standing: if it stood still under the load of the phase",
        StrokeKind::QuasiStatic => "Each phase as if it stood still",
    };
    let table = Rows::of("/stroke/phases", &stroke.phases)
        .number(["phase_deg", "phase", "deg"], After(1), |row| row.phase_deg)
        .number(["tip_twist_deg", "tip twist", "deg"], After(2), |row| {
            row.tip_twist_deg
        })
        .number(
            ["moving/standing_tip_twist_deg", "standing", "deg"],
            After(2),
            |row| {
                row.moving
                    .as_ref()
                    .and_then(|moving| moving.standing_tip_twist_deg)
            },
        )
        .number(["forces/lift_mn", "lift", "mN"], After(2), |row| {
            row.forces.as_ref().map(|forces| forces.lift_mn)
        })
        .number(["forces/drag_mn", "drag", "mN"], After(2), |row| {
            row.forces.as_ref().map(|forces| forces.drag_mn)
        })
        .number(["forces/power_mw", "power", "mW"], After(2), |row| {
            row.forces.as_ref().map(|forces| forces.power_mw)
        })
        .number(["stop_moment_mn_mm", "stop carries", "mN mm"], After(1), |row| {
            row.stop_moment_mn_mm
        })
        .words("", |row| {
            match row.moving.as_ref().is_some_and(|moving| moving.is_flipping) {
                true => "flips",
                false => "",
            }
        })
        .caption(head)
        .along()
        .folded(12, "Phases")
        .table();
    let mut parts = vec![Part::Table(table)];
    parts.extend(stroke.mean.as_ref().map(|mean| {
        let [lift, drag, power] = [mean.lift_mn, mean.drag_mn, mean.power_mw].map(|value| number(value, 2));
        Part::Text(format!(
            "{}: lift {lift} mN, drag {drag} mN, power {power} mW",
            mean.name
        ))
    }));
    parts.extend(stroke.periodic.as_ref().map(|periodic| {
        let modes: Vec<String> = periodic.mode_hz.iter().map(|hz| number(*hz, 0)).collect();
        Part::Text(format!(
            "Made of modes at {} Hz; assumed: {} % of critical damping, flips that take {} % of the stroke each.",
            modes.join(", "),
            number(1e2 * periodic.damping_ratio, 1),
            number(1e2 * periodic.flip_share, 0)
        ))
    }));
    parts
}

fn assumed(summary: &RunSummary) -> Vec<Part> {
    if summary.assumed.is_empty() && summary.assumed_choices.is_empty() {
        return vec![Part::Text(
            "Every input is stated as a fact; none is assumed.".to_string(),
        )];
    }
    // a reason that holds for many inputs in a row is said once
    let before = [""]
        .into_iter()
        .chain(summary.assumed.iter().map(|input| input.why.as_str()));
    let inputs: Vec<(&AssumedInput, &str)> = summary
        .assumed
        .iter()
        .zip(before)
        .map(|(input, said)| (input, if input.why == said { "" } else { input.why.as_str() }))
        .collect();
    let table = Rows::of("/assumed", &inputs)
        .words("input", |(input, _)| input.key.as_str())
        .number(["value", "value", ""], Digits::All, |(input, _)| input.value)
        .number(["range/0", "from", ""], Digits::All, |(input, _)| input.range[0])
        .number(["range/1", "to", ""], Digits::All, |(input, _)| input.range[1])
        .words("why", |(_, why)| *why)
        .caption("--uncertainty says how far these move the result")
        .table();
    let choices = Rows::of("/assumed_choices", &summary.assumed_choices)
        .words("choice", |choice| choice.key.as_str())
        .words("value", |choice| choice.value.as_str())
        .words("why", |choice| choice.why.as_str())
        .table();
    vec![Part::Table(table), Part::Table(choices)]
}
