//! Sets in words.

use super::report::{ChangeMade, ExplainedSet, Otherwise, Status};

/// A number with so many digits from the first that is not zero.
pub fn short(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".to_string();
    }
    let whole = value.abs().log10().floor() as i64 + 1;
    let after = (digits as i64 - whole).clamp(0, 12) as usize;
    let text = format!("{value:.after$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_string(),
        false => text,
    }
}

/// A change in a few words.
pub fn change(made: &ChangeMade) -> String {
    let unit = if made.unit == "1" {
        String::new()
    } else {
        format!(" {}", made.unit)
    };
    let wings = match made.wings.len() {
        0 => String::new(),
        _ => format!(" on {}", made.wings.join(" and ")),
    };
    let numbers = made
        .numbers
        .iter()
        .map(|(name, value)| format!("{name} {}", short(*value, 3)));
    let numbers: Vec<String> = numbers.collect();
    let at = if numbers.is_empty() {
        String::new()
    } else {
        format!(" ({})", numbers.join(", "))
    };
    format!("{} = {}{unit}{at}{wings}", made.name, short(made.value, 3))
}

/// A set in a few words.
pub fn name(otherwise: &[Otherwise], changes: &[ChangeMade]) -> String {
    let parts: Vec<String> = otherwise
        .iter()
        .map(|own| own.name.clone())
        .chain(changes.iter().map(change))
        .collect();
    match parts.is_empty() {
        true => "nothing".to_string(),
        false => parts.join(" + "),
    }
}

/// The answer in plain words.
pub fn sentence(sets: &[ExplainedSet], numbers: usize, most: usize) -> String {
    let Some(first) = sets.first() else {
        return "No set of changes could be solved.".to_string();
    };
    let reaching = sets.iter().filter(|set| set.status == Status::Reaches).count();
    let rank = "This is what it would take, and no proof that it is so.";
    match (first.status, first.name.as_str()) {
        (Status::Reaches, "nothing") => format!(
            "Nothing needs to change: the model as it stands is as near to all {numbers} numbers as their scatter lets expect."
        ),
        (Status::Reaches, name) => {
            let others = match reaching {
                1 => "No other set that is shown does".to_string(),
                count => format!("{} more are shown that do", count - 1),
            };
            format!("The least that reaches all {numbers} numbers: {name}. {others}. {rank}")
        }
        (Status::Refuted, name) => format!(
            "Every set that reaches all {numbers} numbers is contradicted by a number that was held out. The least of them: {name}. {rank}"
        ),
        (Status::FallsShort, name) => format!(
            "No set of up to {most} plausible changes that was found reaches all {numbers} numbers. The nearest: {name}; its worst reading is {:.1} σ off. {rank}",
            first.worst_sigma
        ),
    }
}

/// What doubled standard deviations change; `first`: the set that comes first then.
pub fn at_twice_sigma(sets: &[ExplainedSet], first: &str) -> String {
    match sets.first() {
        Some(now) if now.name == first => format!("With all σ doubled the same set comes first: {first}."),
        _ => format!(
            "With all σ doubled another set comes first: {first}. What comes first hangs on the size of σ."
        ),
    }
}

/// That fits of shown sets did not settle.
pub fn unfitted(count: usize) -> Option<String> {
    (count > 0).then(|| {
        format!(
            "The fit of {count} of the sets that are shown did not settle. They stand with the sizes at which they were found; better ones may \
             be near."
        )
    })
}

/// What limits the answer.
pub fn notes(numbers: usize, is_assumed: bool) -> Vec<String> {
    let mut notes = Vec::new();
    if is_assumed {
        notes.push(
            "Standard deviations are assumed, so sets are ranked and have no probabilities: ranks rest on these σ and on prices that are \
             stated before the readings."
                .to_string(),
        );
    }
    if numbers < 24 {
        notes.push(format!(
            "{} numbers cannot prove which set it is: sets that are not listed may reach them too, with other effects or more changes.",
            numbers
        ));
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn numbers_are_short() {
        let all = [
            (0.0, "0"),
            (34.567, "34.6"),
            (0.012_345, "0.0123"),
            (1234.5, "1234"),
            (2.0, "2"),
        ];
        for (value, text) in all {
            assert_eq!(short(value, 3), text);
        }
    }
}
