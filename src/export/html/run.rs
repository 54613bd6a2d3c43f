//! The report of a run: headline numbers, the wing, twist, air, what a builder wants to know, inputs, how sure.

use std::path::Path;

use crate::export::comparison::sign;
use crate::export::pictures::profile::{self, StripRow};
use crate::export::summary::{FlowSummary, RunSummary};
use crate::export::vtu_read::read_vtu;
use crate::export::{ExportError, builder};
use crate::input::design::FilmCompression;

use super::compared::comparison;
use super::document::{Digits, Document, Shown};
use super::inputs::{all_numbers, inputs};
use super::page::{Page, headline, mind};
use super::picture::picture;
use super::table::{HtmlTable, list, paragraph};
use super::wing::Wing;
use super::wings::section;

const STRIPS: &str = "strips.csv";

/// The report of a run out of the files of its folder; `read` gives one by its name, and `folder` names them in errors.
///
/// # Errors
/// If a file cannot be read or is not of a run, or a number is not finite.
pub fn of_files(
    summary: &RunSummary,
    folder: &Path,
    read: &dyn Fn(&str) -> Result<Vec<u8>, ExportError>,
) -> Result<Page, ExportError> {
    let (wing, strips) = drawn(summary, folder, read)?;
    page(summary, wing, &strips)
}

/// What of a run is drawn: the wing, and the air along its span where that was written; `read` gives a file by its name.
///
/// # Errors
/// If a file cannot be read or is not of a run.
pub fn drawn(
    summary: &RunSummary,
    folder: &Path,
    read: &dyn Fn(&str) -> Result<Vec<u8>, ExportError>,
) -> Result<(Wing, Vec<StripRow>), ExportError> {
    let [rest, loaded] = ["wing-rest.vtu", "wing.vtu"].map(|name| read_vtu(&read(name)?, &folder.join(name)));
    let wing = Wing::of_grids(&summary.name, &rest?, &loaded?);
    let has_strips = summary.files.iter().any(|file| file == STRIPS);
    let strips = has_strips.then(|| read(STRIPS)).transpose()?;
    Ok((wing, strips_of(strips.as_deref().unwrap_or_default(), folder)?))
}

/// The report of a run.
///
/// # Errors
/// If a number is not finite.
pub fn page(summary: &RunSummary, wing: Wing, strips: &[StripRow]) -> Result<Page, ExportError> {
    let document = Document::new("summary", summary)?;
    let mut page = Page {
        title: summary.name.clone(),
        lead: lead(&document, summary),
        ..Page::default()
    };
    page.section("wing", "The wing", section(&[wing])?);
    page.section("twist", "Twist along the span", twist(&document, summary)?);
    if let Some(measured) = &summary.measured {
        page.section(
            "measured",
            "Against the measurement",
            comparison(&document, "/measured", measured)?,
        );
    }
    let mut air = lift(&document, summary);
    air.push_str(&picture(&profile::strips(&summary.name, strips))?);
    page.section("air", "Lift, drag, power", air);
    page.section("stroke", "Over the stroke", stroke(&document, summary)?);
    page.section("builder", "For the builder", for_builder(summary));
    page.section(
        "inputs",
        "Inputs",
        choices(summary) + &inputs(&document, "/design"),
    );
    page.section("sure", "How sure", sure(&document, summary));
    page.section("data", "Data", all_numbers(&document));
    page.documents.push(document);
    Ok(page)
}

fn strips_of(bytes: &[u8], folder: &Path) -> Result<Vec<StripRow>, ExportError> {
    let rows: Result<Vec<StripRow>, csv::Error> = csv::Reader::from_reader(bytes).deserialize().collect();
    rows.map_err(|error| ExportError::ForeignSummary {
        path: folder.join(STRIPS),
        reason: error.to_string(),
    })
}

fn lead(document: &Document, summary: &RunSummary) -> String {
    let number = |place: &str, digits: usize| document.number(place, Digits::After(digits));
    let tip_at = number("/tip/r_mm", 1).html;
    let mut html = format!(
        "<p class=\"quiet\">{} · {} · washout {}</p>\n",
        crate::plot::pen::escaped(&summary.design_file),
        air(document, summary),
        crate::plot::pen::escaped(&summary.made_of.washout_version)
    );
    let error = summary
        .measured
        .as_ref()
        .filter(|measured| !measured.span.is_empty());
    let error = error.map_or(Shown::default(), |_| {
        number("/measured/span/0/rmse_along_span_deg", 1)
    });
    html.push_str(&headline(&[
        ("Tip twist, washout positive", number("/tip/twist_deg", 2), "°"),
        ("Angle of attack at the tip", number("/tip/alpha_deg", 2), "°"),
        ("Error along the span, rms", error, "°"),
        (
            "Lift, one wing, as solved",
            number("/lift/solved/lift_mn", 2),
            "mN",
        ),
        (
            "Mean lift over the stroke",
            number("/lift/stroke_mean/lift_mn", 2),
            "mN",
        ),
        ("Mean power", number("/lift/stroke_mean/power_mw", 1), "mW"),
        (
            "Mean lift over drag",
            number("/lift/stroke_mean/lift_to_drag", 3),
            "",
        ),
        (
            "Mass",
            document.number("/engineering/mass_mg", Digits::Significant(4)),
            "mg",
        ),
        (
            "Lowest frequency, with air",
            number("/engineering/natural_frequencies_in_air_hz/0", 1),
            "Hz",
        ),
    ]));
    html.push_str(&format!(
        "<p class=\"quiet\">The tip is the station at {tip_at} mm.</p>\n"
    ));
    html.push_str(&mind(&summary.warnings));
    html
}

/// The air in a line.
fn air(document: &Document, summary: &RunSummary) -> String {
    let number = |name: &str, digits: usize| {
        document
            .number(&format!("/flow/{name}"), Digits::After(digits))
            .html
    };
    match &summary.flow {
        None => "bench loads only".to_string(),
        Some(FlowSummary::Flapping { .. }) => format!(
            "flapping at {} Hz, ±{}°, phase {}°: tip at {} m/s; root held at {}°",
            number("frequency_hz", 1),
            number("half_amplitude_deg", 1),
            number("phase_deg", 1),
            number("tip_speed_m_s", 2),
            number("root_angle_deg", 1)
        ),
        Some(FlowSummary::Steady { .. }) => format!(
            "steady stream of {} m/s; root held at {}°",
            number("speed_m_s", 2),
            number("root_angle_deg", 2)
        ),
    }
}

fn twist(document: &Document, summary: &RunSummary) -> Result<String, ExportError> {
    let mut html = picture(&profile::twist(summary))?;
    let heads = [
        "at",
        "r (mm)",
        "chord (mm)",
        "twist (deg)",
        "σ of reading (deg)",
        "angle of attack (deg)",
        "LE deflection (mm)",
        "LE sweep (mm)",
    ];
    let mut table =
        HtmlTable::new(&heads).caption("As the design's instrument reads it; positive twist is washout; LE: leading edge, across and in the wing plane");
    for (index, row) in summary.profile.iter().enumerate() {
        let at = |name: &str, digits: usize| {
            document.number(&format!("/profile/{index}/{name}"), Digits::After(digits))
        };
        table.row(vec![
            Shown::text(&row.place),
            at("r_mm", 2),
            at("chord_mm", 2),
            at("twist_deg", 2).after(sign(row.bound)),
            at("sigma_deg", 2),
            at("alpha_deg", 2),
            at("le_deflection_mm", 3),
            at("le_sweep_mm", 3),
        ]);
    }
    html.push_str(&table.html());
    html.push_str(&list(&summary.skipped));
    if let Some(fit) = &summary.stages {
        let heads = ["from (mm)", "to (mm)", "± (mm)", "rate (deg/mm)", "± (deg/mm)"];
        let mut table = HtmlTable::new(&heads).caption("Stages of the modelled profile");
        for index in 0..fit.stages.len() {
            let at = |name: &str, digits: usize| {
                document.number(&format!("/stages/stages/{index}/{name}"), Digits::After(digits))
            };
            table.row(vec![
                at("from_mm", 1),
                at("to_mm", 1),
                at("to_error_mm", 1),
                at("rate_deg_per_mm", 3),
                at("rate_error_deg_per_mm", 3),
            ]);
        }
        html.push_str(&table.html());
        html.push_str(&paragraph(&fit.meaning_of_errors));
    }
    Ok(html)
}

fn lift(document: &Document, summary: &RunSummary) -> String {
    let heads = [
        "one wing",
        "lift (mN)",
        "drag (mN)",
        "power (mW)",
        "lift over drag",
        "lift per power (N/W)",
    ];
    let mut table = HtmlTable::new(&heads);
    let Some(report) = &summary.lift else {
        return String::new();
    };
    let mut places = vec!["/lift/solved"];
    places.extend(report.stroke_mean.as_ref().map(|_| "/lift/stroke_mean"));
    for place in places {
        let at =
            |name: &str, digits: usize| document.number(&format!("{place}/{name}"), Digits::After(digits));
        table.row(vec![
            document.words(&format!("{place}/name")),
            at("lift_mn", 2),
            at("drag_mn", 2),
            at("power_mw", 2),
            at("lift_to_drag", 3),
            at("lift_per_power_n_per_w", 3),
        ]);
    }
    table.html()
}

fn stroke(document: &Document, summary: &RunSummary) -> Result<String, ExportError> {
    let Some(stroke) = &summary.stroke else {
        return Ok(String::new());
    };
    let mut html = picture(&profile::stroke(summary))?;
    let heads = [
        "phase (deg)",
        "tip twist (deg)",
        "standing still (deg)",
        "lift (mN)",
        "drag (mN)",
        "power (mW)",
        "stop carries (mN mm)",
    ];
    let mut table = HtmlTable::new(&heads);
    for index in 0..stroke.phases.len() {
        let at = |name: &str, digits: usize| {
            document.number(&format!("/stroke/phases/{index}/{name}"), Digits::After(digits))
        };
        table.row(vec![
            at("phase_deg", 1),
            at("tip_twist_deg", 2),
            at("moving/standing_tip_twist_deg", 2),
            at("forces/lift_mn", 2),
            at("forces/drag_mn", 2),
            at("forces/power_mw", 2),
            at("stop_moment_mn_mm", 1),
        ]);
    }
    html.push_str(&table.folded(12, "Phases"));
    Ok(html)
}

fn for_builder(summary: &RunSummary) -> String {
    let film = summary.design.film.as_ref();
    let carries = film.is_some_and(|film| film.compression == FilmCompression::Carries);
    let text = builder::engineering(&summary.engineering, carries);
    let mut table = HtmlTable::new(&["", "what"]);
    // The first line is the title of the page of text.
    for line in text.lines().skip(1) {
        let line = line.strip_prefix("  ").unwrap_or(line);
        let (name, what) = line.split_at_checked(12).unwrap_or(("", line));
        table.row(vec![Shown::text(name.trim()), Shown::text(what.trim())]);
    }
    table.html()
}

fn choices(summary: &RunSummary) -> String {
    let mut table = HtmlTable::new(&["assumed choice", "value", "why"]);
    for choice in &summary.assumed_choices {
        let cells = [&choice.key, &choice.value, &choice.why].map(Shown::text);
        table.marked("assumed", cells.to_vec());
    }
    table.html()
}

fn sure(document: &Document, summary: &RunSummary) -> String {
    let exact = |place: &str| document.exact(place).html;
    let small = |place: &str| document.number(place, Digits::Significant(2)).html;
    let branch = match summary.solve.negative_pivots {
        0 => "The branch is stable (no negative pivot of the tangent)".to_string(),
        count => format!("The branch is NOT stable: {count} negative pivots of the tangent"),
    };
    let divergence = match summary.solve.critical_pressure_ratio {
        // The ratio is an estimate from this shape, so far away it only says that twist takes load off the wing.
        None | Some(100.0..) => "no divergence is in sight".to_string(),
        Some(_) => format!(
            "divergence is estimated at {} times this dynamic pressure",
            document
                .number("/solve/critical_pressure_ratio", Digits::Significant(3))
                .html
        ),
    };
    let mut html = format!(
        "<p>Equations: converged in {} updates of the air load and {} Newton steps; coupled residual {} of the load, last change of \
         twist {}°. {branch}; {divergence}.</p>\n<p>Mesh: {} nodes, {} triangles, {} beam elements, {} degrees of freedom. \
         What a finer mesh would change, <code>--refine 2</code> says.</p>\n\
         <p>Physics: quasi-steady air on blade elements, the wing at one instant without its motion, film as the design has it. \
         How far that holds against published cases is said in “How far to trust washout”.</p>\n",
        exact("/solve/iterations"),
        exact("/solve/newton_steps"),
        small("/solve/residual"),
        small("/solve/twist_change_deg"),
        exact("/mesh/nodes"),
        exact("/mesh/triangles"),
        exact("/mesh/beams"),
        exact("/solve/dof"),
    );
    html.push_str(&match &summary.uncertainty {
        None => format!(
            "<p>Inputs: {} are assumed. What their ranges do to the result was not asked for; \
             <code>washout solve --uncertainty</code> gives the band and ranks them.</p>\n",
            summary.assumed.len()
        ),
        Some(_) => band(document, summary),
    });
    html
}

fn band(document: &Document, summary: &RunSummary) -> String {
    let Some(found) = &summary.uncertainty else {
        return String::new();
    };
    let caption = format!(
        "Band from the assumed ranges ({} solves; {}): 5 to 95 %",
        found.samples - found.failures.len(),
        found.distribution
    );
    let mut table = HtmlTable::new(&["result", "as solved", "5 %", "median", "95 %"]).caption(&caption);
    let mut shares = HtmlTable::new(&["input", "alone (share)", "with others (share)"]);
    for (index, output) in found.outputs.iter().enumerate() {
        let at = |name: &str| {
            document.number(
                &format!("/uncertainty/outputs/{index}/{name}"),
                Digits::Significant(3),
            )
        };
        table.row(vec![
            Shown::text(&output.name),
            at("nominal"),
            at("q05"),
            at("median"),
            at("q95"),
        ]);
    }
    let is_twist =
        |output: &&crate::study::OutputBand| matches!(output.output, crate::study::Output::Twist { .. });
    let outermost = found.outputs.iter().rposition(|output| is_twist(&output));
    let mut html = table.html();
    if let Some(outermost) = outermost {
        let output = &found.outputs[outermost];
        shares = shares.caption(&format!(
            "Inputs by their share in the variance of the {}",
            output.name
        ));
        for (index, share) in output.shares.iter().enumerate() {
            let at = |name: &str| {
                document.number(
                    &format!("/uncertainty/outputs/{outermost}/shares/{index}/{name}"),
                    Digits::After(3),
                )
            };
            shares.row(vec![Shown::text(&share.key), at("first_order"), at("total")]);
        }
        html.push_str(&shares.html());
    }
    let failures: Vec<String> = found
        .failures
        .iter()
        .map(|failure| format!("sample {} gave no result: {}", failure.sample, failure.reason))
        .collect();
    html + &list(&failures)
}
