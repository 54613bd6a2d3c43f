//! The answer in one plain sentence.

use super::null::are_few;
use super::verdict::{Diagnosis, Hypothesis, PlaceFound, Strength, Verdict};

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
        (Verdict::Effect, Some(hypothesis)) => {
            effect(&diagnosis.hypotheses, with_any_second(diagnosis, hypothesis))
        }
        (Verdict::Pair, Some(_)) => pair(&diagnosis.hypotheses),
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

/// One effect that may be named, though the most probable of the `hypotheses` about it may have a second one that the data merely allow;
/// `probability`: of the effect, with any second or none.
fn effect(hypotheses: &[Hypothesis], probability: f64) -> String {
    let known: Vec<&Hypothesis> = hypotheses.iter().filter(|own| !own.families.is_empty()).collect();
    let Some(first) = known.first() else {
        return String::new();
    };
    let alone = known.iter().find(|own| own.families[..] == first.families[..1]);
    let more = match &first.effects[..] {
        [_, second] => format!("; {:.2} that {second} is, too", first.probability),
        _ => String::new(),
    };
    format!(
        "Missing: {} (probability {probability:.2}, {:.2} that nothing else is{more}); no other effect that was tried explains the misfit.",
        with_strength(alone.unwrap_or(first)),
        alone.map_or(0.0, |alone| alone.probability)
    )
}

/// The effects of a hypothesis that the data show, with their strengths; two of one family mean something between them.
fn with_strength(hypothesis: &Hypothesis) -> String {
    let shown = if hypothesis.is_shown { 2 } else { 1 };
    let of_family = |family: &String| {
        let own = hypothesis.strengths.iter();
        let own: Vec<String> = own
            .filter(|strength| strength.family == *family)
            .map(one_strength)
            .collect();
        match own.len() {
            0 | 1 => own.concat(),
            _ => format!("something between {}", own.join(" and ")),
        }
    };
    let parts: Vec<String> = hypothesis.families.iter().take(shown).map(of_family).collect();
    let plausible = if hypothesis.plausible {
        ""
    } else {
        ", an implausible size"
    };
    let between = match hypothesis.strengths.len() > parts.len() && hypothesis.is_shown {
        true => ", and ",
        false => " and ",
    };
    format!("{}{plausible}", parts.join(between))
}

fn one_strength(strength: &Strength) -> String {
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
        "1" => String::new(),
        unit => format!(" {unit}"),
    };
    format!(
        "{numbers}, {} {}{error}{unit}{wing}",
        place.parameter,
        short(place.value)
    )
}

/// Two effects, the most probable of the `hypotheses`.
fn pair(hypotheses: &[Hypothesis]) -> String {
    let in_set: Vec<&Hypothesis> = hypotheses.iter().filter(|own| own.in_set).collect();
    let is_pair = |own: &&Hypothesis| own.is_shown && own.families.len() == 2;
    let pairs: Vec<&Hypothesis> = in_set.iter().copied().filter(is_pair).collect();
    let Some(hypothesis) = pairs.first() else {
        return String::new();
    };
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
            let sure = match in_set.iter().all(|other| other.families.contains(family)) {
                true => format!("{name} for certain"),
                false => format!("probably {name}"),
            };
            format!(
                "Two effects are missing: {sure}; the second is {}.",
                one_of(&seconds)
            )
        }
        _ => {
            let others: Vec<String> = in_set.iter().skip(1).map(|other| name(other)).collect();
            let others = match others.len() {
                0 => String::new(),
                more if more > LISTED => {
                    format!(
                        "; or else {} or {} others",
                        others[..LISTED].join(", "),
                        more - LISTED
                    )
                }
                _ => format!("; or else {}", others.join(", ")),
            };
            format!(
                "Two effects are missing: {} (probability {:.2}{others}).",
                with_strength(hypothesis),
                hypothesis.probability
            )
        }
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

    /// A hypothesis of effects with their families and strengths ± 0.1.
    fn hypothesis(strengths: &[(&str, &str, f64)], probability: f64, is_shown: bool) -> Hypothesis {
        let of = |(effect, family, value): &(&str, &str, f64)| {
            serde_json::json!({"effect": effect, "family": family, "unknown": effect, "value": value, "at_end": false,
                "standard_error": 0.1, "unit": "1", "place": null})
        };
        let mut effects: Vec<(&str, &str)> = Vec::new();
        for (effect, family, _) in strengths {
            if effects.iter().all(|(_, known)| known != family) {
                effects.push((effect, family));
            }
        }
        let (effects, families): (Vec<&str>, Vec<&str>) = effects.into_iter().unzip();
        let strengths: Vec<serde_json::Value> = strengths.iter().map(of).collect();
        let whole = serde_json::json!({"effects": effects, "families": families, "strengths": strengths,
            "probability": probability, "is_shown": is_shown, "plausible": true, "in_set": true, "refitted": true});
        serde_json::from_value(whole).unwrap()
    }

    #[test]
    fn a_second_effect_that_the_data_merely_allow_is_not_said_to_be_missing() {
        let coupling = ("bend-twist-coupling", "rod-coupling", -0.38);
        let both = hypothesis(&[coupling, ("skin-yielding", "skin", 0.09)], 0.7, false);
        let alone = hypothesis(&[("bend-twist-coupling", "rod-coupling", -0.41)], 0.3, true);
        let said = effect(&[both.clone(), alone.clone()], 1.0);
        let expected = "Missing: bend-twist-coupling = -0.410 ± 0.100 (probability 1.00, 0.30 that nothing else is; \
                        0.70 that skin-yielding is, too); no other";
        assert!(said.starts_with(expected), "{said}");
        let said = effect(&[alone, both], 1.0);
        assert!(said.contains("1.00, 0.30 that nothing else is); no"), "{said}");
    }

    #[test]
    fn of_two_effects_one_is_certain_only_if_nothing_in_the_set_is_without_it() {
        let [a, b, c] = [("a", "a", 1.0), ("b", "b", 2.0), ("c", "c", 3.0)];
        let pairs = [hypothesis(&[a, b], 0.5, true), hypothesis(&[a, c], 0.4, true)];
        assert_eq!(
            pair(&pairs),
            "Two effects are missing: a for certain; the second is one of b or c, which these data cannot tell apart."
        );
        let with = |more: Hypothesis| pair(&[&pairs[..], &[more]].concat());
        assert!(with(hypothesis(&[a], 0.1, true)).contains("missing: a for certain"));
        assert!(with(hypothesis(&[b], 0.1, true)).contains("missing: probably a; the second"));
        let novel = hypothesis(&[], 0.1, true);
        assert!(with(novel.clone()).contains("missing: probably a; the second"));
        assert_eq!(
            pair(&[pairs[0].clone(), novel]),
            "Two effects are missing: a = 1.00 ± 0.100 and b = 2.00 ± 0.100 (probability 0.50; or else none that is known)."
        );
    }

    #[test]
    fn two_forms_of_one_family_are_something_between_them() {
        let three = [
            ("skin-torsion", "rod-stiffness", 0.867),
            ("leading-edge-frame", "rod-stiffness", 0.384),
            ("film-cure-tension", "film-tension", 39.2),
        ];
        assert_eq!(
            with_strength(&hypothesis(&three, 0.7, true)),
            "something between skin-torsion = 0.867 ± 0.100 and leading-edge-frame = 0.384 ± 0.100, and film-cure-tension = 39.2 ± 0.100"
        );
    }
}
