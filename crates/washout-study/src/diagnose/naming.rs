//! The verdict, and why an effect that has most of the probability is not named.

use super::baseline::Baseline;
use super::effect_row::EffectRow;
use super::hypothesis::{Hypothesis, is_possible};
use super::judge::Judgement;
use super::misfit::{self, Pull};
use super::posterior::{Belief, Case, SEPARATE};
use super::screening::ENOUGH_POWER;
use super::strengths::name;
use super::verdict::Verdict;

/// Something is said to be missing where nothing has a probability below so many times the accepted one of a false alarm. With 10, seven
/// of 12 readings with errors of uneven size about a fit would raise one (two do), and no case more of 47 of another model would be told.
const ALARM: f64 = 5.0;
/// Probability from which on nothing, or a cause without a name, is the answer.
const BELIEVED: f64 = 0.5;
/// Probability from which on one effect may be named.
const NAMED: f64 = 0.9;
/// Formulation error over what the study states beyond which nothing is named: so much no model should have, and what is named leaves it.
/// Not derived: the 16 effects that were named in 173 cases of another model leave 1.1 to 2.3.
const LEFT_OVER: f64 = 3.5;
/// Pull on an uncertain input, in standard deviations, beyond which it may have taken up what is missing.
const PULLED: f64 = 3.0;

/// What the probabilities say; and, where effects have most of them and are not named, why not.
pub fn verdict(
    baseline: &Baseline,
    judgement: &Judgement,
    effects: &[EffectRow],
    hypotheses: &[Hypothesis],
) -> (Verdict, Option<String>) {
    let nothing = judgement.probability(&Case::Nothing);
    if nothing >= ALARM * baseline.settings.significance {
        let could_see = effects.iter().any(|row| row.power >= ENOUGH_POWER);
        let is_pulled = |pull: &Pull| pull.pull.abs() > PULLED;
        let is_calm = !misfit::of(baseline).pulls.iter().any(is_pulled);
        return match nothing >= BELIEVED && could_see && is_calm {
            true => (Verdict::Nothing, None),
            false => (Verdict::Undecidable, None),
        };
    }
    match judgement.beliefs.first() {
        None => (Verdict::Undecidable, None),
        Some(first) if first.case == Case::Unknown && first.probability >= BELIEVED => (Verdict::Novel, None),
        _ => match (leading(judgement), hypotheses.first()) {
            (Some(held), Some(first)) => match obstacle(baseline, judgement, first, &held) {
                None => (Verdict::Effect, None),
                Some(why) => {
                    let effects = first.names(" with ");
                    (
                        Verdict::Set,
                        Some(format!("Why {effects} is not named for sure: {why}.")),
                    )
                }
            },
            _ => (Verdict::Set, None),
        },
    }
}

/// Families of the most probable explanation, if all explanations with these among them have the probability of what may be named.
fn leading(judgement: &Judgement) -> Option<Vec<usize>> {
    let families = judgement.beliefs.first()?.case.families();
    let holds = |belief: &&Belief| families.iter().all(|own| belief.case.families().contains(own));
    let held = judgement.beliefs.iter().filter(holds);
    let held: f64 = held.map(|belief| belief.probability).sum();
    (!families.is_empty() && held >= NAMED).then_some(families)
}

/// What stands against naming these families.
fn obstacle(
    baseline: &Baseline,
    judgement: &Judgement,
    first: &Hypothesis,
    families: &[usize],
) -> Option<String> {
    let &[family] = families else {
        return Some("two effects at once are as pliable as an unknown cause".into());
    };
    if !first.refitted {
        return Some("no fit settled with it".into());
    }
    if !(first.plausible && is_possible(baseline, first)) {
        return Some("the size that fits best is not plausible".into());
    }
    let needed = baseline.weighing.share / baseline.settings.discrepancy;
    if needed > LEFT_OVER {
        return Some(format!(
            "the error of the model itself would be {needed:.2} times what the study states, where {LEFT_OVER} is the most"
        ));
    }
    let others = (0..baseline.families.len()).filter(|&other| other != family);
    let each = others.map(|other| (judgement.distance(baseline, family, other), other));
    let (distance, other) = each.min_by(|a, b| a.0.total_cmp(&b.0))?;
    if distance >= SEPARATE {
        return None;
    }
    let rival = &judgement.trials[judgement.heaviest(&[other])?];
    Some(format!(
        "{} would make nearly the same of these readings, {distance:.1} standard deviations apart ({SEPARATE} are needed)",
        name(baseline, rival.members[0])
    ))
}
