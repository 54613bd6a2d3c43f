//! The document of `washout design`, from the layouts that were found.

use crate::explore::rods::{Band, Candidate, Found};
use crate::export::layouts::{BandSummary, Cause, LayoutRow, LayoutSummary, PieceRow};
use crate::input::Design;
use crate::program::MadeOf;
use crate::wing::WingModel;

use super::rod_aim::RodAim;

/// Share of lift per power within which two layouts count as equally good.
const ALIKE: f64 = 0.01;

/// The best layout.
pub(super) struct Best<'a> {
    pub(super) candidate: &'a Candidate,
    /// Its twist with what fabrication can have off.
    pub(super) band: Band,
    /// It as a design.
    pub(super) design: Design,
}

/// The document, as yet without the files of its folder.
pub(super) fn layout_summary(
    case: &WingModel,
    sought: &RodAim,
    found: &Found,
    best: Best,
    made_of: MadeOf,
) -> LayoutSummary {
    let Best {
        candidate,
        band,
        design,
    } = best;
    LayoutSummary {
        name: case.loaded.design.name.clone(),
        aim: sought.words.clone(),
        layouts: found.candidates.iter().map(row).collect(),
        equally_good: alike(found, candidate, band.built_deg),
        wanted_deg: sought.wanted().map_or(Vec::new(), |twist| {
            band.stations
                .iter()
                .map(|[r_m, _, _]| twist.twist_rad(*r_m).to_degrees())
                .collect()
        }),
        band: band_summary(&band),
        solved: found.solved,
        unsolved: found.unsolved,
        warnings: warnings(case, candidate, band.built_deg),
        design,
        made_of,
        files: Vec::new(),
    }
}

fn band_summary(band: &Band) -> BandSummary {
    let stations = &band.stations;
    BandSummary {
        pieces: band
            .pieces
            .iter()
            .map(|piece| PieceRow {
                from_mm: piece.from_mm,
                to_mm: piece.to_mm,
                rate_deg_per_mm: piece.rate_deg_per_mm,
                tolerance_deg_per_mm: piece.tolerance_deg_per_mm,
            })
            .collect(),
        r_mm: stations.iter().map(|s| s[0] * 1e3).collect(),
        twist_deg: stations.iter().map(|s| s[1].to_degrees()).collect(),
        tolerance_deg: stations.iter().map(|s| s[2].to_degrees()).collect(),
        rms_deg: band.rms_deg,
        built_deg: band.built_deg,
        causes: band
            .causes
            .iter()
            .map(|(what, rms_deg)| Cause {
                what: what.clone(),
                rms_deg: *rms_deg,
            })
            .collect(),
    }
}

fn row(candidate: &Candidate) -> LayoutRow {
    let pieces = &candidate.layout.pieces;
    LayoutRow {
        layout: candidate.layout.words(),
        rods: pieces.iter().map(|piece| piece.rod.name.clone()).collect(),
        to_mm: pieces.iter().map(|piece| piece.to_mm).collect(),
        distance_deg: candidate.distance_deg,
        lift_mn: candidate.lift_n * 1e3,
        lift_per_power_n_per_w: if candidate.power_w > 0.0 {
            candidate.lift_n / candidate.power_w
        } else {
            0.0
        },
        is_feasible: candidate.is_feasible(),
    }
}

/// How many candidates are as good as the best within what may be off as they are built.
fn alike(found: &Found, best: &Candidate, built_deg: f64) -> usize {
    let room = if best.distance_deg.is_some() {
        built_deg
    } else {
        ALIKE
    };
    let is_alike = |candidate: &&Candidate| candidate.is_feasible() && candidate.behind(best) <= room;
    found.candidates.iter().take_while(is_alike).count()
}

fn warnings(case: &WingModel, best: &Candidate, built_deg: f64) -> Vec<String> {
    let mut warnings = Vec::new();
    if let Some(distance) = best.distance_deg
        && distance > 2.0 * built_deg
    {
        warnings.push(format!(
            "The best layout stays {distance:.1} deg (root mean square over the span) from what is wanted, more than twice what \
             fabrication can have off: no layout of these rods makes that twist. Add rods to the list, or allow more pieces, \
             spars or tensions."
        ));
    }
    let amplitude = case
        .loaded
        .design
        .flapping
        .as_ref()
        .map(|flapping| &flapping.half_amplitude_deg);
    if amplitude.is_some_and(|amplitude| amplitude.assumption().is_some()) {
        warnings.push(
            "The amplitude is assumed: twist goes with its square over the shear modulus, and so does the layout.".to_string(),
        );
    }
    warnings
}
