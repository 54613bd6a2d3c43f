//! The shape factor in the document of `washout pareto`.

use crate::effects::acting;
use crate::explore::ShapeFactor;
use crate::explore::shape_factor::with_strength;
use crate::export::pareto::{FittedFactor, FittedWing};
use crate::input::Design;
use crate::wing::WingModel;

use super::Failure;

/// It as it stands in the document.
pub(super) fn fitted(case: &WingModel, factor: ShapeFactor) -> Result<FittedFactor, Failure> {
    let design = with_strength(&case.loaded.design, &factor.effect, factor.strength);
    let effect = acting(&factor.effect, &design.effects[&factor.effect], &design);
    let effect = effect.map_err(|error| case.fault(error))?;
    let card = effect.card();
    let is_fitted = !factor.fitted.is_empty();
    Ok(FittedFactor {
        formula: card.formula.to_string(),
        unit: card
            .parameters
            .first()
            .map_or(String::new(), |parameter| parameter.unit.to_string()),
        strength: factor.strength,
        sigma: is_fitted.then_some(factor.sigma),
        chi_squared: is_fitted.then_some(factor.chi_squared),
        freedom: factor.freedom,
        wings: factor
            .fitted
            .into_iter()
            .map(|(wing, fitted)| FittedWing {
                name: wing.name,
                measured: wing.effective,
                sigma: wing.sigma,
                fitted,
            })
            .collect(),
        effect: factor.effect,
    })
}

/// That no strength explains all wings, if so.
pub(super) fn misfit(factor: &ShapeFactor) -> Option<String> {
    (factor.freedom > 0 && factor.chi_squared > 4.0 * factor.freedom as f64).then(|| {
        format!(
            "No single strength of {} explains all measured wings (chi² {:.1} with {} degree(s) of freedom): its form is an \
             assumption, and the front with it follows that form.",
            factor.effect, factor.chi_squared, factor.freedom
        )
    })
}

/// The design with an effect off.
pub(super) fn without(design: &Design, effect: &str) -> Design {
    match design.effects.contains_key(effect) {
        true => with_strength(design, effect, 0.0),
        false => design.clone(),
    }
}
