//! What the assumed ranges do to a result, for people: the band, and which inputs it comes from.

use crate::page::Digits::{After, Significant};
use crate::page::text::number;
use crate::page::{Part, Rows};
use crate::study::{Output, OutputBand, Uncertainty};

/// The band, which stands at `/uncertainty` in the document of a run.
pub fn band(band: &Uncertainty) -> Vec<Part> {
    let solved = band.samples - band.failures.len();
    let table = Rows::of("/uncertainty/outputs", &band.outputs)
        .words("result", |output| output.name.as_str())
        .number(["nominal", "as solved", ""], Significant(3), |output| {
            output.nominal
        })
        .number(["q05", "5 %", ""], Significant(3), |output| output.q05)
        .number(["median", "median", ""], Significant(3), |output| output.median)
        .number(["q95", "95 %", ""], Significant(3), |output| output.q95)
        .number(["mesh_error", "mesh ±", ""], Significant(2), |output| {
            output.mesh_error
        })
        .caption(&format!(
            "Band from the assumed ranges ({solved} solves; {}): 5 to 95 %",
            band.distribution
        ))
        .table();
    let mut parts = vec![Part::Table(table)];
    let failures = Rows::of("/uncertainty/failures", &band.failures)
        .number(["sample", "sample", ""], After(0), |failure| {
            failure.sample as f64
        })
        .words("why", |failure| failure.reason.as_str())
        .caption(&format!(
            "{} of {} samples gave no result and are left out",
            band.failures.len(),
            band.samples
        ))
        .most_in_text(1)
        .folded(3, "Samples without a result");
    parts.push(Part::Table(failures.table()));
    parts.extend(
        outermost(band)
            .into_iter()
            .flat_map(|index| shares(index, &band.outputs[index])),
    );
    parts
}

/// The same without what it says of twist further inboard.
pub fn band_at_the_tip(found: &Uncertainty) -> Vec<Part> {
    let mut parts = band(found);
    if let (Some(Part::Table(table)), Some(outermost)) = (parts.first_mut(), outermost(found)) {
        table.rows.drain(..outermost);
    }
    parts
}

/// The place of the outermost twist among the results.
fn outermost(band: &Uncertainty) -> Option<usize> {
    let is_twist = |output: &OutputBand| matches!(output.output, Output::Twist { .. });
    band.outputs.iter().rposition(is_twist)
}

/// Which inputs a result owes its variance to; it is the one at `index` of the band.
fn shares(index: usize, output: &OutputBand) -> Vec<Part> {
    let table = Rows::of(&format!("/uncertainty/outputs/{index}/shares"), &output.shares)
        .words("input", |share| share.key.as_str())
        .number(
            ["first_order", "share of variance, alone", ""],
            After(3),
            |share| share.first_order,
        )
        .number(["total", "with others", ""], After(3), |share| share.total)
        .caption(&format!(
            "Inputs by their share in the variance of the {}",
            output.name
        ))
        .table();
    let quality = output.surrogate.as_ref().map(|quality| {
        Part::Text(format!(
            "From a polynomial of {} terms: R² {}, and {} for samples left out.",
            quality.terms,
            number(quality.r_squared, 3),
            number(quality.predictive_r_squared, 3)
        ))
    });
    [Part::Table(table)].into_iter().chain(quality).collect()
}
