//! The answer in one plain sentence.

use super::null::are_few;
use super::verdict::{Diagnosis, Hypothesis, PlaceFound, Verdict};

/// Names listed before "and others".
const LISTED: usize = 6;

/// One sentence for a diagnosis whose other parts are complete; `level`: probability of a false alarm that is accepted.
pub fn sentence(diagnosis: &Diagnosis, level: f64) -> String {
    let known = diagnosis.hypotheses.iter().find(|h| !h.families.is_empty());
    match (diagnosis.verdict, known) {
        (Verdict::Nothing, _) => {
            let unseen = match diagnosis.unseen.len() {
                0 => "every effect that was tried would have been seen at its plausible size".to_string(),
                1 => format!("{} could not have been seen", diagnosis.unseen[0]),
                count => format!("{count} of the effects that were tried could not have been seen"),
            };
            format!(
                "Nothing detectable is missing (a misfit like this arises by chance with probability {:.2}); {unseen}.",
                diagnosis.significance.p_null
            )
        }
        (Verdict::Undecidable, _)
            if are_few(diagnosis.noise.numbers, level)
                && diagnosis.significance.p_null > level
                && diagnosis.significance.p_misfit < level =>
        {
            format!(
                "The model misses these data, but {} numbers are too few to tell something missing from scatter: measure more \
                 stations or conditions.",
                diagnosis.noise.numbers
            )
        }
        (Verdict::Undecidable, _) if diagnosis.significance.stands_on_few(level) => format!(
            "These data do not decide whether something is missing: the misfit is more than the stated errors allow, but errors of uneven \
             size make such a one by chance with probability {:.2}. If it is real, {} explains it best; more readings, above all \
             repeats of those that miss most, would tell.",
            diagnosis.significance.p_null,
            best(diagnosis)
        ),
        (Verdict::Undecidable, _)
            if diagnosis.significance.p_null > level && diagnosis.p_nothing < level =>
        {
            format!(
                "These data do not decide whether something is missing: a misfit like this arises by chance with probability {:.2}, but \
                 {} explains it far better than nothing does; more readings, above all of what misses most, would tell.",
                diagnosis.significance.p_null,
                best(diagnosis)
            )
        }
        (Verdict::Undecidable, _) if diagnosis.significance.p_null > level => {
            "These data show nothing missing, but could not have shown any known effect of plausible size: measure \
             more conditions, more stations, or with less noise."
                .into()
        }
        (Verdict::Effect, Some(hypothesis)) => format!(
            "Missing: {} (probability {:.2}, {:.2} that nothing else is); no other effect that was tried explains the misfit.",
            with_strength(hypothesis),
            with_any_second(diagnosis, hypothesis),
            hypothesis.probability
        ),
        (Verdict::Pair, Some(hypothesis)) => pair(diagnosis, hypothesis),
        (Verdict::Novel, _) => novel(diagnosis),
        _ => format!("Something is missing: {}.", one_of(&names_in_set(diagnosis))),
    }
}

/// Probability of the first effect of a hypothesis, whatever the data allow beside it.
fn with_any_second(diagnosis: &Diagnosis, hypothesis: &Hypothesis) -> f64 {
    let rows = diagnosis.effects.iter();
    let own = rows.filter(|row| hypothesis.effects.first() == Some(&row.effect));
    own.map(|row| row.probability)
        .fold(hypothesis.probability, f64::max)
}

fn with_strength(hypothesis: &Hypothesis) -> String {
    let parts: Vec<String> = hypothesis
        .strengths
        .iter()
        .map(|strength| {
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
        })
        .collect();
    let plausible = if hypothesis.plausible {
        ""
    } else {
        ", an implausible size"
    };
    format!("{}{plausible}", parts.join(" and "))
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
        "1" => String::new(),
        unit => format!(" {unit}"),
    };
    format!(
        "{numbers}, {} {}{error}{unit}{wing}",
        place.parameter,
        short(place.value)
    )
}

fn pair(diagnosis: &Diagnosis, hypothesis: &Hypothesis) -> String {
    let pairs: Vec<&Hypothesis> = diagnosis
        .hypotheses
        .iter()
        .filter(|h| h.in_set && h.is_shown && h.families.len() == 2)
        .collect();
    let shared = hypothesis
        .families
        .iter()
        .zip(&hypothesis.effects)
        .find(|(family, _)| pairs.iter().all(|other| other.families.contains(family)));
    match shared {
        Some((family, name)) if pairs.len() > 1 => {
            let seconds: Vec<String> = pairs
                .iter()
                .filter_map(|other| {
                    let second = other.families.iter().position(|f| f != family)?;
                    other.effects.get(second).cloned()
                })
                .collect();
            format!(
                "Two effects are missing: {name} for certain; the second is {}.",
                one_of(&seconds)
            )
        }
        _ => format!("Two effects are missing: {}.", with_strength(hypothesis)),
    }
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
    if diagnosis.novel.as_weighed < 0.5 {
        let known = diagnosis.hypotheses.iter().find(|h| !h.families.is_empty());
        let left = diagnosis
            .significance_after
            .map(|left| (2.0 * left.p_misfit.min(left.p_field)).min(1.0));
        let best = known.zip(left).map_or_else(String::new, |(known, left)| {
            format!(
                " Of the known ones, {} does best, and what it leaves arises by chance with a probability of no more than {}.",
                with_strength(known),
                short(left)
            )
        });
        return format!(
            "Something is missing that no known effect explains, and nothing smooth along the span does well; nearest \
             comes {what}{nearest}.{best}"
        );
    }
    format!("Something is missing that no known effect explains: {what}{nearest}.")
}

/// The effects of a hypothesis, or that it is none that is known.
fn name(hypothesis: &Hypothesis) -> String {
    if hypothesis.families.is_empty() {
        return "none that is known".into();
    }
    hypothesis.effects.join(" with ")
}

/// What explains the data best, if anything is missing; the best of the known effects besides, if it is none of them.
fn best(diagnosis: &Diagnosis) -> String {
    let mut missing = diagnosis.hypotheses.iter().filter(|h| !h.effects.is_empty());
    let first = missing.next();
    let known = missing.find(|h| !h.families.is_empty());
    match (first, known) {
        (Some(first), Some(known)) if first.families.is_empty() => {
            format!("{} (or else {})", name(first), name(known))
        }
        (Some(first), _) => name(first),
        (None, _) => "none that is known".into(),
    }
}

fn names_in_set(diagnosis: &Diagnosis) -> Vec<String> {
    diagnosis
        .hypotheses
        .iter()
        .filter(|h| h.in_set && h.is_shown)
        .map(|h| match h.effects[..] {
            [] => "nothing after all".into(),
            _ => name(h),
        })
        .collect()
}

fn one_of(names: &[String]) -> String {
    match names {
        [] => "none of the known effects stands out".into(),
        [one] => format!("probably {one}"),
        _ if names.len() > LISTED => format!(
            "one of {} and {} others, which these data cannot tell apart",
            names[..LISTED].join(", "),
            names.len() - LISTED
        ),
        [most @ .., last] => format!(
            "one of {} or {last}, which these data cannot tell apart",
            most.join(", ")
        ),
    }
}

/// Three digits that count.
pub fn short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let digits = (2 - value.abs().log10().floor() as i32).clamp(0, 9) as usize;
    if !(1e-4..1e6).contains(&value.abs()) {
        format!("{value:.2e}")
    } else {
        format!("{value:.digits$}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_three_digits() {
        assert_eq!(
            [short(0.123456), short(12.3456), short(1234.6)],
            ["0.123", "12.3", "1235"]
        );
        assert_eq!([short(-2.5e-6), short(0.0)], ["-2.50e-6", "0"]);
    }
}
