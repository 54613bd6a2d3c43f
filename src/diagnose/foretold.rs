//! A misfit that stands on one reading: a slip, or what an effect foretells that has nothing to be fitted?
//!
//! An effect whose strength is fitted fits one far reading whatever it is, so such a reading decides nothing. One that is all or none
//! says beforehand where the reading lies; a slip may fall anywhere. Their odds are
//!
//! P(effect) p(data | effect) / [P(nothing) P(slip) p(data without the reading) p(reading | slip)],
//!
//! with a slip anywhere within twice the distance z that the reading has from the model, at a density of 1/(4 |z|) per standard deviation.

use super::baseline::Baseline;
use super::data::Scatter;
use super::error::DiagnoseError;
use super::judge::Judgement;
use super::posterior::Case;
use super::screening::whole_strength;
use super::whitened::Whitened;

/// Probability that a reading is a slip: misread, mistyped, or of another wing.
const SLIP: f64 = 0.01;
/// Factor on the standard deviation of a reading that takes it out of the fit.
const OUT: f64 = 1e4;

/// The reading on which a misfit stands most, and what an effect that is all or none says of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Foretold {
    /// Index of the observable.
    pub row: usize,
    /// Odds that it is the effect, and no slip.
    pub odds: f64,
}

/// What the most probable explanation foretells, if it is one effect that is all or none.
///
/// # Errors
/// If the slopes of a fit are not finite.
pub fn foretold(baseline: &Baseline, judgement: &Judgement) -> Result<Option<Foretold>, DiagnoseError> {
    let (data, unknowns) = (&baseline.data, baseline.forward.unknowns());
    let Some(Case::One(family)) = judgement.beliefs.first().map(|belief| &belief.case) else {
        return Ok(None);
    };
    let Some((index, Some(effect))) = judgement.best_of(&[*family]) else {
        return Ok(None);
    };
    let is_whole = |&k: &usize| whole_strength(&unknowns[data.missing[k]]).is_some();
    if !effect.members.iter().all(is_whole) {
        return Ok(None);
    }
    let by_reading = baseline.whitened.rotation_to_readings() * &baseline.whitened.residual;
    let farthest = (0..by_reading.len()).max_by(|&a, &b| by_reading[a].abs().total_cmp(&by_reading[b].abs()));
    let Some(farthest) = farthest else {
        return Ok(None);
    };
    let mut widening = baseline.scatter.widening.clone();
    widening[farthest] *= OUT;
    let scale = baseline.scatter.scale;
    let without = Scatter::new(baseline.forward, data, &baseline.admitted, scale, widening)?;
    let without = Whitened::new(&baseline.local, &without.noise)?;
    let density = std::f64::consts::TAU.sqrt() / (4.0 * by_reading[farthest].abs());
    let slip = (baseline.settings.prior.nothing * SLIP * density).ln() + baseline.likelihood.ln(without.q())
        - 0.5 * without.ln_determinant;
    Ok(Some(Foretold {
        row: data.rows[farthest],
        odds: (judgement.weight(index) - slip).exp(),
    }))
}
