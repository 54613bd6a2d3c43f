//! Errors that many readings share, as the nuisances of a study: an offset or a scale of twist.

use crate::input::study::RulerKind;

use super::video::VideoTwist;
use crate::structure::{largest, smaller};

/// Share of the smallest standard deviation of a reading below which a shared error does not matter.
const NEGLIGIBLE: f64 = 0.1;

/// A nuisance that a study should have.
#[derive(Debug, Clone, PartialEq)]
pub struct RulerHint {
    /// Offset or scale of twist.
    pub kind: RulerKind,
    /// Whether all frames share it; otherwise every frame has its own.
    pub same_in_all: bool,
    /// Standard deviation of its prior: deg for an offset, a share for a scale.
    pub sigma: f64,
    /// Where it comes from.
    pub why: Vec<String>,
    /// What it misses of any reading at most, deg.
    pub leaves_deg: f64,
}

/// The nuisances that describe the shared errors best, by least squares over the readings; errors that do not matter have none.
pub fn ruler_hints(video: &VideoTwist) -> Vec<RulerHint> {
    let theta: Vec<f64> = video.readings.iter().map(|r| r.twist_rad.to_degrees()).collect();
    let weight: Vec<f64> = video.readings.iter().map(|r| r.sigma_rad.powi(-2)).collect();
    let smallest = video
        .readings
        .iter()
        .map(|r| r.sigma_rad)
        .fold(f64::INFINITY, smaller);
    let mut hints: Vec<RulerHint> = Vec::new();
    for shared in &video.shared {
        let moves: Vec<f64> = shared.moves_rad.iter().map(|rad| rad.to_degrees()).collect();
        if shared
            .moves_rad
            .iter()
            .all(|rad| rad.abs() < NEGLIGIBLE * smallest)
        {
            continue;
        }
        let ones = vec![1.0; theta.len()];
        let fits = [(RulerKind::Offset, &ones), (RulerKind::Scale, &theta)];
        let fits = fits.map(|(kind, shape)| {
            let sum = |values: &[f64]| -> f64 {
                let products = weight.iter().zip(values).zip(shape);
                products.map(|((w, v), s)| w * v * s).sum()
            };
            let norm = sum(shape);
            let size = if norm > 0.0 { sum(&moves) / norm } else { 0.0 };
            let left = moves.iter().zip(shape).map(|(m, s)| m - size * s);
            let left: Vec<f64> = left.collect();
            let misfit: f64 = weight.iter().zip(&left).map(|(w, l)| w * l * l).sum();
            let most = largest(left.iter().map(|l| l.abs()));
            (kind, size.abs(), misfit, most)
        });
        let [offset, scale] = fits;
        let (kind, size, _, most) = if scale.2 < offset.2 { scale } else { offset };
        let alike = |hint: &&mut RulerHint| hint.kind == kind && hint.same_in_all == shared.same_in_all;
        match hints.iter_mut().find(alike) {
            Some(hint) => {
                hint.sigma = hint.sigma.hypot(size);
                hint.leaves_deg = hint.leaves_deg.hypot(most);
                hint.why.push(shared.why.clone());
            }
            None => hints.push(RulerHint {
                kind,
                same_in_all: shared.same_in_all,
                sigma: size,
                why: vec![shared.why.clone()],
                leaves_deg: most,
            }),
        }
    }
    hints
}
