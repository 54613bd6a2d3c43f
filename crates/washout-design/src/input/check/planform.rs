//! The outline: one shape, possible radii, rising points.

use super::refusal::refuse;
use crate::input::design::Planform;
use crate::input::document::Node;
use crate::input::error::{InputError, Number};

/// Without a shape of its own, a design with a mesh file takes the outline of the mesh.
pub(super) fn check(planform: &Planform, has_mesh_file: bool, root: &Node) -> Result<(), InputError> {
    let has_shape =
        planform.mean_chord_mm.is_some() || planform.r1_hat.is_some() || planform.r2_hat.is_some();
    let (closure, cut) = (planform.base_closure.value(), planform.tip_cut.value());
    if closure >= cut {
        let message = format!("must be smaller than tip_cut = {}", Number(cut));
        let cure =
            "The base is closed inboard of base_closure, the tip cut at tip_cut; usual are 0.02 and 0.99";
        return refuse(
            root,
            "planform.base_closure",
            message,
            &["planform.tip_cut"],
            cure,
        );
    }
    match &planform.outline {
        Some(points) => outline(planform, points, root),
        None if has_mesh_file && !has_shape => Ok(()),
        None => moments(planform, root),
    }
}

fn outline(planform: &Planform, points: &[[f64; 2]], root: &Node) -> Result<(), InputError> {
    stands_alone(planform, root)?;
    let whole = "planform.outline";
    if points.len() < 2 {
        let cure = "Give two points [r_mm, chord_mm] or more, r rising from 0 to the length";
        return refuse(root, whole, "needs at least two points", &[], cure);
    }
    let length = planform.length_mm.value();
    let mut before = f64::NEG_INFINITY;
    for (number, [r, chord]) in points.iter().enumerate() {
        let key = |part: usize| format!("{whole}[{number}][{part}]");
        if *r <= before {
            let message = format!("r must rise, but the point before is at {} mm", Number(before));
            return refuse(
                root,
                &key(0),
                message,
                &[],
                "Sort the points by r, one point per r",
            );
        }
        if !(0.0..=length).contains(r) {
            let message = format!("r must lie in 0 … {} mm", Number(length));
            let cure = "Points run from the wing base (0) to the tip (length_mm)";
            return refuse(root, &key(0), message, &["planform.length_mm"], cure);
        }
        if *chord < 0.0 {
            let cure = "Give the chord in millimetres, 0 or more";
            return refuse(root, &key(1), "the chord must not be negative", &[], cure);
        }
        before = *r;
    }
    let (first, last) = (points[0][0], before);
    let needed = [
        planform.base_closure.value() * length,
        planform.tip_cut.value() * length,
    ];
    if first > needed[0] + 1e-9 * length || last < needed[1] - 1e-9 * length {
        let message = format!(
            "must run from 0 to {} mm, but runs from {first} to {last}",
            Number(length)
        );
        let cure = "Add points at the wing base and at the tip";
        return refuse(root, whole, message, &["planform.length_mm"], cure);
    }
    Ok(())
}

/// Refuses what an outline has by itself.
fn stands_alone(planform: &Planform, root: &Node) -> Result<(), InputError> {
    for (key, given) in [
        ("mean_chord_mm", planform.mean_chord_mm.is_some()),
        ("r2_hat", planform.r2_hat.is_some()),
        ("r1_hat", planform.r1_hat.is_some()),
    ] {
        if given {
            let key = format!("planform.{key}");
            let cure =
                "Keep the outline, or mean_chord_mm and r2_hat; the outline has its own mean chord and radii";
            return refuse(
                root,
                &key,
                "cannot stand together with outline",
                &["planform.outline"],
                cure,
            );
        }
    }
    Ok(())
}

/// A beta distribution with radii r̂₁ and r̂₂ exists where r̂₁ < r̂₂ < √r̂₁.
fn moments(planform: &Planform, root: &Node) -> Result<(), InputError> {
    for (key, missing) in [
        ("mean_chord_mm", planform.mean_chord_mm.is_none()),
        ("r2_hat", planform.r2_hat.is_none()),
    ] {
        if missing {
            let cure = "Give mean_chord_mm and r2_hat for a beta chord, or outline = [[r_mm, chord_mm], ...]";
            return refuse(
                root,
                &format!("planform.{key}"),
                "is needed without an outline",
                &["planform.outline"],
                cure,
            );
        }
    }
    let r2 = planform.r2_hat.as_ref().map_or(0.0, |r2| r2.value());
    // Ellington 1984, part II: r2 = 0.929 r1^0.732.
    let r1 = planform
        .r1_hat
        .as_ref()
        .map_or((r2 / 0.929).powf(1.0 / 0.732), |r1| r1.value());
    if r1 < r2 && r2 < r1.sqrt() {
        return Ok(());
    }
    let (key, other) = match planform.r1_hat {
        Some(_) => ("planform.r1_hat", "planform.r2_hat"),
        None => ("planform.r2_hat", "planform.r1_hat"),
    };
    let message = format!("no chord distribution has r1_hat = {r1:.4} and r2_hat = {r2:.4}");
    let cure = format!(
        "r1_hat must lie between r2_hat squared and r2_hat, {:.4} … {r2:.4}; without it Ellington's regression gives it for r2_hat up to 0.75",
        r2 * r2
    );
    refuse(root, key, message, &[other], cure)
}
