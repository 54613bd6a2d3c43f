//! Tables of `washout lift`: units in the head.

use super::LiftSummary;
use crate::export::ExportError;
use crate::export::csv::table;

/// `lift.csv`: the wings.
pub fn wings(summary: &LiftSummary) -> Result<Vec<u8>, ExportError> {
    let head = [
        "wing",
        "frequency_hz",
        "half_amplitude_deg",
        "stop_angle_deg",
        "tip_twist_deg",
        "lift_mn",
        "drag_mn",
        "power_mw",
        "lift_to_drag",
        "lift_per_power_n_per_w",
        "local_lift_to_drag",
        "departure_from_ellipse",
    ];
    let rows = summary.wings.iter().map(|wing| {
        (
            wing.name.clone(),
            wing.frequency_hz,
            wing.half_amplitude_deg,
            wing.stop_angle_deg,
            wing.tip_twist_deg,
            wing.mean.lift_mn,
            wing.mean.drag_mn,
            wing.mean.power_mw,
            wing.mean.lift_to_drag,
            wing.mean.lift_per_power_n_per_w,
            wing.local_lift_to_drag,
            wing.departure_from_ellipse,
        )
    });
    table(&head, &rows.collect::<Vec<_>>())
}

/// `ratios.csv`: every ratio under its condition.
pub fn ratios(summary: &LiftSummary) -> Result<Vec<u8>, ExportError> {
    let mut rows = Vec::new();
    for wing in &summary.ratios {
        for (condition, set) in [
            ("as_flown", &wing.as_flown),
            ("equal_amplitude", &wing.equal_amplitude),
            ("equal_frequency_times_amplitude", &wing.equal_rate),
        ] {
            for (_, name, value) in set.named() {
                rows.push((
                    wing.name.clone(),
                    summary.reference.clone(),
                    condition,
                    name,
                    value,
                ));
            }
        }
    }
    table(&["wing", "reference", "condition", "ratio", "value"], &rows)
}

/// `span.csv`: means over the stroke along the span.
pub fn span(summary: &LiftSummary) -> Result<Vec<u8>, ExportError> {
    let head = [
        "wing",
        "r_mm",
        "twist_deg",
        "lift_mn_per_mm",
        "drag_mn_per_mm",
        "lift_to_drag_over_reference",
    ];
    let mut rows = Vec::new();
    for curve in &summary.span {
        for (index, r_mm) in curve.r_mm.iter().enumerate() {
            rows.push((
                curve.wing.clone(),
                *r_mm,
                curve.twist_deg[index],
                curve.lift_mn_per_mm[index],
                curve.drag_mn_per_mm[index],
                curve.lift_to_drag[index],
            ));
        }
    }
    table(&head, &rows)
}

/// `stroke.csv`: forces over one half-stroke.
pub fn stroke(summary: &LiftSummary) -> Result<Vec<u8>, ExportError> {
    let mut rows = Vec::new();
    for curve in &summary.stroke {
        for (index, phase_deg) in curve.phase_deg.iter().enumerate() {
            rows.push((
                curve.wing.clone(),
                *phase_deg,
                curve.lift_mn[index],
                curve.drag_mn[index],
                curve.power_mw[index],
            ));
        }
    }
    table(&["wing", "phase_deg", "lift_mn", "drag_mn", "power_mw"], &rows)
}

/// `sweep.csv`: means for rising amplitudes.
pub fn sweep(summary: &LiftSummary) -> Result<Vec<u8>, ExportError> {
    let mut rows = Vec::new();
    for curve in &summary.sweep {
        for (index, half_amplitude_deg) in curve.half_amplitude_deg.iter().enumerate() {
            rows.push((
                curve.wing.clone(),
                *half_amplitude_deg,
                curve.lift_mn[index],
                curve.drag_mn[index],
                curve.power_mw[index],
            ));
        }
    }
    let head = ["wing", "half_amplitude_deg", "lift_mn", "drag_mn", "power_mw"];
    table(&head, &rows)
}

/// `sensitivity.csv`: ratios with what is not known.
pub fn sensitivity(summary: &LiftSummary) -> Result<Vec<u8>, ExportError> {
    let head = [
        "wing",
        "what",
        "value",
        "lift_to_drag",
        "lift_at_equal_rate",
        "lift_per_power_at_equal_rate",
        "lift_per_power_at_equal_amplitude",
    ];
    let rows = summary.sensitivity.iter().map(|row| {
        (
            row.wing.clone(),
            row.what.clone(),
            row.value.clone(),
            row.lift_to_drag,
            row.lift_at_equal_rate,
            row.lift_per_power_at_equal_rate,
            row.lift_per_power_at_equal_amplitude,
        )
    });
    table(&head, &rows.collect::<Vec<_>>())
}
