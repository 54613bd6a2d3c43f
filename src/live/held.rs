//! Strengths of effects that are held: of a design by its keys, of a study in its text.

use std::sync::Arc;

use crate::add::with_strength;

use super::opened::Opened;
use super::refusal::Refusal;
use super::values::{Step, StudyText, Values};

/// Holds an effect at a strength, or takes it out; `first`: the study as it was opened.
///
/// # Errors
/// If the text of the study cannot be changed so.
pub fn hold(
    opened: &Opened,
    first: Option<&StudyText>,
    values: &mut Values,
    effect: &str,
    strength: Option<f64>,
) -> Result<(), Refusal> {
    match &values.study {
        Some(study) => values.study = Some(Arc::new(with_held(opened, first, study, effect, strength)?)),
        None => {
            let stands = opened.designs()[0].effects.contains_key(effect);
            match strength {
                None if !stands => values.effects.remove(effect),
                strength => values.effects.insert(effect.to_string(), strength.unwrap_or(0.0)),
            };
        }
    }
    Ok(())
}

/// The study with an effect held at a strength, or without it.
fn with_held(
    opened: &Opened,
    first: Option<&StudyText>,
    study: &StudyText,
    effect: &str,
    strength: Option<f64>,
) -> Result<StudyText, Refusal> {
    let is_own = |step: &Step| matches!(step, Step::Held { effect: own, .. } if own == effect);
    let fits = |step: &Step| matches!(step, Step::Fitted { .. });
    let mut steps = study.steps.clone();
    // what was fitted after it was fitted with the strength that it had then
    let since = steps.iter().rposition(fits).map_or(0, |place| place + 1);
    let before = steps[since..].iter().position(is_own).map(|place| since + place);
    let stood = |text: &StudyText| text.loaded.study.effect.iter().any(|own| own.name == effect);
    let is_new = !steps[..since].iter().any(|step| step.effect() == effect) && !first.is_some_and(stood);
    if let Some(place) = before {
        steps.remove(place);
    }
    // one that stands in the file, or was fitted, is held at nothing; one that was put in by hand goes
    let strength = strength.or((!is_new).then_some(0.0));
    if let Some(strength) = strength {
        let step = Step::Held {
            effect: effect.to_string(),
            strength,
        };
        steps.insert(before.unwrap_or(steps.len()), step);
    }
    let text = with_strength(&study.loaded, &study.text, effect, strength).map_err(Refusal::new)?;
    Ok(opened.study(text, steps)?)
}

/// Strength of an effect in what was opened with what was moved; none if it is not in the model.
pub fn strength_in(opened: &Opened, values: &Values, name: &str) -> Option<f64> {
    let found = match &values.study {
        Some(study) => {
            let own = study
                .loaded
                .study
                .effect
                .iter()
                .find(|effect| effect.name == name);
            own.map(|effect| effect.strength)
        }
        None => values.effects.get(name).copied().or_else(|| {
            let table = opened.designs()[0].effects.get(name)?;
            let strength = table.get("strength")?;
            strength
                .as_float()
                .or(strength.as_integer().map(|whole| whole as f64))
        }),
    };
    found.filter(|strength| *strength != 0.0)
}
