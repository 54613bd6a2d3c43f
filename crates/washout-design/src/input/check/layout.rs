//! Rod and spars: no gaps, no overlaps, nothing off the wing, nothing too near.

use super::refusal::{material_is_known, refuse, round};
use super::section::check_section;
use crate::input::design::{Design, Section};
use crate::input::document::Node;
use crate::input::error::{InputError, Number};

/// Ends of spars nearer than this, mm, would make slivers.
const NEAREST_MM: f64 = 0.2;

/// A rod nearer to the leading edge than this share of the chord lies on it.
const NEAREST_FRACTION: f64 = 0.01;

/// Largest thickness of a film over the chord: the elements are those of thin plates.
const THICKEST: f64 = 0.1;

/// Least share of the wing that the rod reaches along. A choice: the farther a film hangs on itself, the longer its shape is searched for;
/// one of 7 m on a rod of 70 mm was searched for ten minutes in vain.
const LEAST_REACH: f64 = 0.8;

pub(super) fn check_rod(design: &Design, root: &Node) -> Result<(), InputError> {
    let length = design.planform.length_mm.value();
    if design.rod.is_empty() {
        let cure = "Add a table [[rod]] with from_mm = 0.0, to_mm and section";
        return refuse(root, "rod", "there is no rod", &[], cure);
    }
    let mut end = 0.0;
    for (number, segment) in design.rod.iter().enumerate() {
        let key = |name: &str| format!("rod[{number}].{name}");
        let (from, to) = (segment.from_mm.value(), segment.to_mm.value());
        if (from - end).abs() > 1e-9 * length {
            let (message, cure) = joint(number, from, end);
            return refuse(root, &key("from_mm"), message, &[], cure);
        }
        if to <= from {
            let message = format!("must be larger than from_mm = {}", Number(from));
            let cure = "Give the outer end of the segment, measured from the wing base";
            return refuse(root, &key("to_mm"), message, &[&key("from_mm")], cure);
        }
        if to > length * (1.0 + 1e-9) {
            let message = format!("runs past the tip at length_mm = {}", Number(length));
            let cure = format!("End the rod at {} mm or before", Number(length));
            return refuse(root, &key("to_mm"), message, &["planform.length_mm"], cure);
        }
        material_of(
            design,
            root,
            segment.material.as_deref(),
            &segment.section,
            &format!("rod[{number}]"),
        )?;
        end = to;
    }
    let tip = length * design.planform.tip_cut.value();
    let last = format!("rod[{}].to_mm", design.rod.len() - 1);
    if design.film.is_some() && end < LEAST_REACH * tip * (1.0 - 1e-9) {
        let message = format!(
            "leaves the leading edge without a rod from {} mm to the tip at {} mm: the film hangs on nothing there",
            Number(end),
            Number(round(tip))
        );
        let cure = format!(
            "Let the last rod end at the tip, or at {} mm at least",
            Number(round(LEAST_REACH * tip))
        );
        return refuse(root, &last, message, &["planform.length_mm"], cure);
    }
    Ok(())
}

fn joint(number: usize, from: f64, end: f64) -> (String, String) {
    let before = number.wrapping_sub(1);
    match number {
        0 => (
            "the rod must start at the wing base, at 0".to_string(),
            "Write from_mm = 0.0 for the first segment".to_string(),
        ),
        _ if from > end => (
            format!(
                "leaves a gap after rod[{before}], which ends at {} mm",
                Number(end)
            ),
            format!("Write from_mm = {end:?}, or let rod[{before}] end at {from:?}"),
        ),
        _ => (
            format!("overlaps rod[{before}], which ends at {} mm", Number(end)),
            format!("Write from_mm = {end:?}, or let rod[{before}] end at {from:?}"),
        ),
    }
}

/// A film is thin beside the chord: what is thicker is a block, and most likely a slip of the unit.
pub(super) fn check_film(design: &Design, root: &Node) -> Result<(), InputError> {
    let Some(film) = &design.film else {
        return Ok(());
    };
    let planform = &design.planform;
    let mean = planform.mean_chord_mm.as_ref().map(|chord| chord.value());
    let widest = planform.outline.iter().flatten().map(|[_, chord]| *chord);
    let chord = mean.unwrap_or_else(|| widest.fold(0.0, f64::max));
    if chord > 0.0 && film.thickness_mm.value() > THICKEST * chord {
        let message = format!(
            "is more than {THICKEST} of the chord of {} mm",
            Number(round(chord))
        );
        let cure = "Give the thickness in mm: 6 micrometres are 0.006";
        return refuse(root, "film.thickness_mm", message, &["planform"], cure);
    }
    Ok(())
}

/// Ribs hold the chord of a wing that is a beam: no film, no spars, a rod up to the tip.
pub(super) fn check_ribs(design: &Design, root: &Node) -> Result<(), InputError> {
    let Some(ribs) = &design.ribs else {
        return Ok(());
    };
    let others = [("film", design.film.is_some()), ("spar", !design.spar.is_empty())];
    if let Some((other, _)) = others.into_iter().find(|(_, stands)| *stands) {
        let message = format!("cannot stand together with {other}");
        let cure = "Keep [ribs] for a wing that is a beam, or [film] and [[spar]] for one of film";
        return refuse(root, "ribs", message, &[other], cure);
    }
    if design.mesh.file.is_some() {
        let cure = "Delete mesh.file; a wing of ribs is meshed by the program";
        return refuse(
            root,
            "mesh.file",
            "cannot stand together with ribs",
            &["ribs"],
            cure,
        );
    }
    let fraction = ribs.rod_chord_fraction.value();
    if fraction > 0.0 && fraction < NEAREST_FRACTION {
        let message = "lies so near to the leading edge that the ribs between them have no length";
        let cure = format!("Write 0 for a rod on the leading edge, or {NEAREST_FRACTION} and more");
        return refuse(root, "ribs.rod_chord_fraction", message, &[], cure);
    }
    let tip = design.planform.length_mm.value() * design.planform.tip_cut.value();
    let number = design.rod.len() - 1;
    let end = design.rod[number].to_mm.value();
    if end < tip * (1.0 - 1e-9) {
        let message = format!(
            "ends short of the tip at {} mm, so that ribs outboard of it hang on nothing",
            Number(round(tip))
        );
        let cure = format!("Let the last segment end at {} mm", Number(round(tip)));
        let with = ["ribs", "planform.tip_cut"];
        return refuse(root, &format!("rod[{number}].to_mm"), message, &with, cure);
    }
    Ok(())
}

pub(super) fn check_spars(design: &Design, root: &Node) -> Result<(), InputError> {
    let tip = design.planform.length_mm.value() * design.planform.tip_cut.value();
    let rod_end = design.rod.last().map_or(0.0, |rod| rod.to_mm.value());
    let mut ends: Vec<[f64; 2]> = Vec::new();
    for (number, spar) in design.spar.iter().enumerate() {
        let at = spar.at_mm.value();
        let trailing = spar.trailing_edge_at_mm.as_ref().map_or(at, |at| at.value());
        for (name, place) in [("at_mm", at), ("trailing_edge_at_mm", trailing)] {
            off_the_wing(root, &format!("spar[{number}].{name}"), place, tip)?;
        }
        if at > rod_end * (1.0 + 1e-9) {
            let message = format!(
                "stands beyond the end of the rod at {} mm: the spar hangs on the film alone",
                Number(rod_end)
            );
            let cure = format!(
                "Let the last rod end at {} mm or beyond, or move the spar inboard",
                Number(at)
            );
            let with = format!("rod[{}].to_mm", design.rod.len().saturating_sub(1));
            return refuse(root, &format!("spar[{number}].at_mm"), message, &[&with], cure);
        }
        for (other, [other_at, other_trailing]) in ends.iter().enumerate() {
            apart(
                root,
                [number, other],
                [at, trailing],
                [*other_at, *other_trailing],
            )?;
        }
        material_of(
            design,
            root,
            spar.material.as_deref(),
            &spar.section,
            &format!("spar[{number}]"),
        )?;
        ends.push([at, trailing]);
    }
    Ok(())
}

fn off_the_wing(root: &Node, key: &str, place: f64, tip: f64) -> Result<(), InputError> {
    if place > tip + 1e-9 {
        let message = format!(
            "is off the wing, which is cut at {} mm (length_mm × tip_cut)",
            Number(round(tip))
        );
        let cure = "Move the spar inboard";
        return refuse(
            root,
            key,
            message,
            &["planform.length_mm", "planform.tip_cut"],
            cure,
        );
    }
    for (edge, distance) in [("the wing base", place), ("the tip cut", tip - place)] {
        if distance > 1e-9 && distance < NEAREST_MM {
            let message = format!(
                "is only {} mm from {edge}, which leaves a sliver",
                Number(round(distance))
            );
            let cure = format!("Keep {NEAREST_MM} mm or more, or lay the spar on the edge itself");
            return refuse(root, key, message, &["planform.tip_cut"], cure);
        }
    }
    Ok(())
}

fn apart(root: &Node, numbers: [usize; 2], own: [f64; 2], other: [f64; 2]) -> Result<(), InputError> {
    let gaps = [own[0] - other[0], own[1] - other[1]];
    if gaps.iter().all(|gap| *gap >= NEAREST_MM) || gaps.iter().all(|gap| *gap <= -NEAREST_MM) {
        return Ok(());
    }
    let [number, earlier] = numbers;
    let key = format!("spar[{number}].at_mm");
    let with = format!("spar[{earlier}].at_mm");
    if gaps == [0.0, 0.0] {
        let cure = "Delete one of them, or move it";
        return refuse(
            root,
            &key,
            format!("spar[{earlier}] stands at the same place"),
            &[&with],
            cure,
        );
    }
    if gaps[0] * gaps[1] < 0.0 {
        let message = format!("crosses spar[{earlier}] between the leading and the trailing edge");
        let cure = "Give spars that do not cross the same order along both edges";
        return refuse(
            root,
            &key,
            message,
            &[&with, &format!("spar[{number}].trailing_edge_at_mm")],
            cure,
        );
    }
    for (gap, edge) in gaps.iter().zip(["leading", "trailing"]) {
        if gap.abs() < NEAREST_MM {
            let message = format!(
                "is only {} mm from spar[{earlier}] at the {edge} edge",
                Number(round(gap.abs()))
            );
            let cure = format!("Keep {NEAREST_MM} mm or more between spars, or merge them into a wider one");
            return refuse(root, &key, message, &[&with], cure);
        }
    }
    Ok(())
}

fn material_of(
    design: &Design,
    root: &Node,
    material: Option<&str>,
    section: &Section,
    part: &str,
) -> Result<(), InputError> {
    let key = format!("{part}.material");
    let needs_none = matches!(section, Section::Laminate { .. } | Section::Given { .. });
    match material {
        Some(name) => material_is_known(design, root, name, &key)?,
        None if needs_none => {}
        None => {
            let cure =
                "Name a material, e.g. material = \"carbon-rod\", and define it under [material.carbon-rod]";
            return refuse(root, &key, "is missing", &[&format!("{part}.section")], cure);
        }
    }
    check_section(design, root, section, &format!("{part}.section"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_segment_is_told_to_start_at_zero() {
        let (message, cure) = joint(0, 2.0, 0.0);
        assert!(message.contains("at 0") && cure.contains("from_mm = 0.0"));
    }

    #[test]
    fn gap_and_overlap_are_told_apart() {
        assert!(joint(1, 41.0, 40.0).0.contains("gap after rod[0]"));
        assert!(joint(1, 39.0, 40.0).0.contains("overlaps rod[0]"));
    }
}
