//! The answer in one plain sentence.

use super::digits::short;
use super::hypothesis::Hypothesis;
use super::posterior::SEPARATE;
use super::strengths::{PlaceFound, Strength};
use super::verdict::{Diagnosis, Verdict};

/// Other explanations listed before "and others".
const LISTED: usize = 3;
/// Probability below which an explanation of a set is counted, not named. Assumed; it chooses words.
const WORTH_NAMING: f64 = 0.02;
/// Probability of the first of a set, whatever is beside it, from which on its rivals are no more than not excluded. Assumed; it chooses words.
const FIRM: f64 = 0.95;
/// Probability of an effect, whatever is beside it, from which on the explanations of a set agree on it.
pub const AGREED: f64 = 0.5;
/// Distance between explanations, in standard deviations, from which on a reading that does not decide is told.
const WORTH_SAYING: f64 = 1.0;

/// The answer to a diagnosis whose other parts are complete: what it is, then what the fit had to pull for it.
pub fn sentence(diagnosis: &Diagnosis) -> String {
    let known = diagnosis.hypotheses.iter().find(|h| !h.families.is_empty());
    let answer = match (diagnosis.verdict, known) {
        (Verdict::Nothing, _) => {
            let unseen = match diagnosis.unseen.len() {
                0 => "every effect that was tried would have been seen at its plausible size".to_string(),
                1 => format!("{} could not have been seen", diagnosis.unseen[0]),
                count => format!(
                    "{count} of the {} effects that were tried could not have been seen",
                    diagnosis.tried
                ),
            };
            format!(
                "Nothing detectable is missing (probability {:.2}); {unseen}.",
                diagnosis.p_nothing
            )
        }
        (Verdict::Undecidable, _) => undecided(diagnosis),
        (Verdict::Effect, Some(hypothesis)) => {
            effect(&diagnosis.hypotheses, with_any_second(diagnosis, hypothesis))
        }
        (Verdict::Novel, _) => novel(diagnosis),
        _ => format!("Something is missing: {}.", set(diagnosis)),
    };
    match pulled(diagnosis) {
        pulled if pulled.is_empty() => answer,
        pulled => format!("{answer} {pulled}"),
    }
}

/// What these data leave open: the most probable answer with its probability.
fn undecided(diagnosis: &Diagnosis) -> String {
    let nothing = diagnosis.p_nothing;
    if nothing >= 0.5 {
        return match diagnosis.unseen.len() == diagnosis.tried {
            true => "These data show nothing missing, but could not have shown any known effect of plausible size: measure \
                     more conditions, more stations, or with less noise."
                .into(),
            false => format!(
                "Not decided: most likely nothing is missing (probability {nothing:.2}), but the fit needs an input far from what is \
                 known of it."
            ),
        };
    }
    let other = diagnosis.hypotheses.iter().find(|h| !h.effects.is_empty());
    let of_other = |other: &Hypothesis| format!("{} (probability {:.2})", name(other), other.probability);
    let most = match other {
        Some(other) if other.probability > nothing => {
            format!(
                "most likely {}; that nothing is missing has {nothing:.2}",
                of_other(other)
            )
        }
        Some(other) => {
            format!(
                "most likely nothing is missing (probability {nothing:.2}), or else {}",
                of_other(other)
            )
        }
        None => format!("nothing is missing with probability {nothing:.2}"),
    };
    let experiments = diagnosis.next_experiment.as_ref();
    let best = experiments.and_then(|next| next.best.as_ref());
    let nearest = experiments.and_then(|next| next.candidates.first());
    let groups = diagnosis.misfit.by_condition.iter();
    let worst = groups.max_by(|a, b| a.share.total_cmp(&b.share));
    let worst = worst.map_or(String::new(), |own| format!(" (condition {})", own.condition));
    let next = match (best, nearest) {
        (Some(best), _) => format!("to know it, measure {best}"),
        (None, Some(nearest)) if nearest.separation_sigma >= WORTH_SAYING => format!(
            "to know it, repeat the readings that miss most{worst}; of what could be added, {} comes nearest to a decision ({:.1} standard \
             deviations of {SEPARATE})",
            nearest.name, nearest.separation_sigma
        ),
        _ => format!("to know it, repeat the readings that miss most{worst}"),
    };
    format!("Not decided: {most}; {next}.")
}

/// Inputs that the fit of what is said had to pull far from what is known of them.
fn pulled(diagnosis: &Diagnosis) -> String {
    // with an effect named the fit is another
    if !matches!(diagnosis.verdict, Verdict::Nothing | Verdict::Undecidable) {
        return String::new();
    }
    let pulls = diagnosis.misfit.pulls.iter().filter(|pull| pull.is_flagged);
    let parts: Vec<String> = pulls
        .map(|pull| format!("{} by {:+.1} sigma", pull.unknown, pull.pull))
        .collect();
    match parts.is_empty() {
        true => String::new(),
        false => format!("For that the fit pulls {}.", parts.join(", ")),
    }
}

/// Probability of the first effect of a hypothesis, whatever is missing beside it.
fn with_any_second(diagnosis: &Diagnosis, hypothesis: &Hypothesis) -> f64 {
    let family = hypothesis.families.first();
    family.map_or(hypothesis.probability, |family| probability_of(diagnosis, family))
}

/// One effect that may be named; `probability`: of the effect, alone or with any second.
fn effect(hypotheses: &[Hypothesis], probability: f64) -> String {
    let Some(first) = hypotheses.iter().find(|own| !own.families.is_empty()) else {
        return String::new();
    };
    let beside = first.beside().iter();
    let beside = beside.map(|own| {
        format!(
            "; or {}, which does much the same, with {:.2} of that",
            own.effect, own.probability
        )
    });
    format!(
        "Missing: {} (probability {probability:.2}; {:.2} that it alone is{}); no effect that was tried explains the misfit without it.",
        with_strength(first),
        first.probability,
        beside.collect::<String>()
    )
}

/// The effects of a hypothesis with their strengths.
fn with_strength(hypothesis: &Hypothesis) -> String {
    let parts: Vec<String> = hypothesis.strengths.iter().map(one_strength).collect();
    let plausible = if hypothesis.plausible {
        ""
    } else {
        ", an implausible size"
    };
    format!("{}{plausible}", parts.join(" and "))
}

/// An effect with its strength and place.
pub fn one_strength(strength: &Strength) -> String {
    let unit = if strength.unit == "1" {
        String::new()
    } else {
        format!(" {}", strength.unit)
    };
    let error = match strength.standard_error {
        0.0 => String::new(),
        error => format!(" ± {}", short(error)),
    };
    format!(
        "{} = {}{error}{unit}{}",
        strength.effect,
        short(strength.value),
        strength.place.as_ref().map_or(String::new(), place)
    )
}

/// Where an effect sits, as the end of a phrase.
fn place(place: &PlaceFound) -> String {
    let numbers = place.numbers.iter();
    let numbers: String = numbers.map(|(name, value)| format!(", {name} {value}")).collect();
    let error = place
        .standard_error
        .map_or(String::new(), |error| format!(" ± {}", short(error)));
    let wing = place
        .wing
        .as_ref()
        .map_or(String::new(), |wing| format!(" on {wing}"));
    let unit = match place.unit.as_str() {
        "1" if place.parameter == "from" => {
            let at = place
                .at_mm
                .map_or(String::new(), |mm| format!(" ({} mm)", short(mm)));
            format!(" of the rod's length{at}")
        }
        "1" => String::new(),
        unit => format!(" {unit}"),
    };
    format!(
        "{numbers}, {} {}{error}{unit}{wing}",
        place.parameter,
        short(place.value)
    )
}

fn novel(diagnosis: &Diagnosis) -> String {
    let what = diagnosis
        .novel
        .draft
        .as_ref()
        .map_or("something", |draft| draft.what.as_str());
    let nearest = diagnosis.novel.nearest.first().map_or_else(String::new, |near| {
        format!(
            "; the nearest known signature is {} (cosine {:.2})",
            near.effect, near.cosine
        )
    });
    format!("Something is missing that no known effect explains: {what}{nearest}.")
}

/// The effects of a hypothesis, or that it is an unknown cause.
fn name(hypothesis: &Hypothesis) -> String {
    if hypothesis.families.is_empty() {
        return "an unknown cause".into();
    }
    hypothesis.names(" with ")
}

/// The most probable explanation of several, and the others that these data leave; those with the same effect and a second count with it.
fn set(diagnosis: &Diagnosis) -> String {
    let mut in_set = diagnosis.hypotheses.iter().filter(|own| own.in_set);
    let Some(first) = in_set.next() else {
        return "none of the known effects stands out".into();
    };
    let is_with_first =
        |own: &&Hypothesis| own.families.len() > 1 && own.families.contains(&first.families[0]);
    let is_one = first.families.len() == 1;
    let (with_first, others): (Vec<&Hypothesis>, Vec<&Hypothesis>) =
        in_set.partition(|own| is_one && is_with_first(own));
    let name = name_or_nothing(first);
    let most = match with_first.len() {
        0 => format!(
            "{name} (probability {:.2}{})",
            first.probability,
            shared(diagnosis, first)
        ),
        _ => {
            let whole = with_any_second(diagnosis, first);
            format!(
                "{name} (probability {whole:.2}; {:.2} that it alone is)",
                first.probability
            )
        }
    };
    let is_worth_naming = |own: &&&Hypothesis| own.probability >= WORTH_NAMING;
    let shown = others.iter().filter(is_worth_naming).take(LISTED);
    let mut names: Vec<String> = shown
        .map(|own| format!("{} ({:.2})", name_or_nothing(own), own.probability))
        .collect();
    match others.len() - names.len() {
        0 => {}
        count if names.is_empty() => {
            let first = name_or_nothing(others[0]);
            let all = match count {
                1 => first,
                _ => format!("{first} and others"),
            };
            return format!("most likely {most}; not excluded, each below {WORTH_NAMING}: {all}");
        }
        1 => names.push("one other".into()),
        more => names.push(format!("{more} others")),
    }
    let or_else = match names.as_slice() {
        [] if with_first.is_empty() => return format!("probably {most}"),
        [] => return format!("most likely {most}; which second effect, these data cannot tell"),
        [one] => one.clone(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    };
    let whole = match first.families.as_slice() {
        [_] => with_any_second(diagnosis, first),
        _ => first.probability,
    };
    match whole >= FIRM {
        true => format!("most likely {most}; not excluded: {or_else}"),
        false => format!("most likely {most}, or else {or_else}, which these data cannot tell apart"),
    }
}

/// Of a pair that is first: the effect that most of the probability agrees on, whatever is beside it.
fn shared(diagnosis: &Diagnosis, first: &Hypothesis) -> String {
    let each = first.families.iter().zip(&first.effects);
    let each = each.map(|(family, effect)| (probability_of(diagnosis, family), effect));
    match each.max_by(|a, b| a.0.total_cmp(&b.0)) {
        Some((whole, effect)) if first.families.len() > 1 && whole >= AGREED => {
            format!("; {effect}, alone or with another, has {whole:.2}")
        }
        _ => String::new(),
    }
}

/// Probability that an effect of a family is missing, whatever is beside it.
pub fn probability_of(diagnosis: &Diagnosis, family: &String) -> f64 {
    let with = diagnosis
        .hypotheses
        .iter()
        .filter(|own| own.families.contains(family));
    with.map(|own| own.probability).sum()
}

/// What a hypothesis of a set says.
fn name_or_nothing(hypothesis: &Hypothesis) -> String {
    match hypothesis.effects[..] {
        [] => "nothing after all".into(),
        _ => name(hypothesis),
    }
}
