//! What it would take, for people: the sets side by side, then each on its own.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::explain::Explanation;
use crate::explain::report::{ChangeMade, ExplainedSet, ReadingOfSet, Refuting, Status};
use crate::input::measurement::Bound;
use crate::page::text::significant;
use crate::page::{Digits, Page, Part, Rows, Table};
use crate::program::MadeOf;

use Digits::{After, Significant};

/// What `washout explain` gives; `explain.json` of its folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ExplanationReport {
    /// The explanation.
    #[serde(flatten)]
    pub explanation: Explanation,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder, this one among them.
    pub files: Vec<String>,
}

/// What `washout explain` says of a study.
pub fn page(study: &str, found: &Explanation) -> Page {
    let table = sets(found);
    let mut page = Page {
        title: study.to_string(),
        kind: "explain",
        lead: vec![Part::Sentence(found.sentence.clone()), Part::Text(tried(found))],
        brief: Vec::new(),
        sections: Vec::new(),
    };
    page.brief = page.lead.clone();
    page.brief.push(Part::Table(table.clone()));
    page.brief.push(Part::Text(found.at_twice_sigma.clone()));
    if let Some(first) = found.sets.first() {
        page.brief.extend(of_set(0, first));
    }
    page.brief.push(Part::Notes(found.notes.clone()));
    page.section(
        "sets",
        "Sets of changes",
        vec![Part::Table(table), Part::Text(found.at_twice_sigma.clone())],
    );
    let mut each: Vec<Part> = Vec::new();
    for (place, set) in found.sets.iter().enumerate() {
        each.push(Part::Subtitle(format!("{}. {}", place + 1, set.name)));
        each.extend(of_set(place, set));
        each.push(Part::Table(forecasts(place, set)));
        each.push(Part::Text("By hand:".to_string()));
        each.push(Part::Code(set.by_hand.join("\n")));
    }
    page.section("each", "Each set", each);
    page.section("notes", "Notes", vec![Part::Notes(found.notes.clone())]);
    page
}

fn tried(found: &Explanation) -> String {
    let tried = &found.tried;
    let alternatives = match tried.alternatives.is_empty() {
        true => "no word or alternative".to_string(),
        false => format!(
            "otherwise, at most two at once: {}",
            tried.alternatives.join(", ")
        ),
    };
    format!(
        "{} strengths of effects in {} families, {} numbers within their ranges; {alternatives}. {} sets were weighed, {} solved in the full \
         model{}. χ² per number, of all that are stated: {} as the model stands, {} with the first set.",
        tried.strengths,
        tried.families,
        tried.inputs,
        tried.weighed,
        tried.solved,
        match tried.unsolved {
            0 => String::new(),
            unsolved => format!("; {unsolved} more have no equilibrium"),
        },
        significant(found.chi_square_per_number[0], 3),
        significant(found.chi_square_per_number[1], 3)
    )
}

fn status(set: &ExplainedSet) -> &'static str {
    match set.status {
        Status::Reaches => "reaches",
        Status::Refuted => "refuted",
        Status::FallsShort => "falls short",
    }
}

fn sets(found: &Explanation) -> Table {
    let count = found.numbers;
    Rows::of("/sets", &found.sets)
        .words("changes", |set| set.name.as_str())
        .words("", status)
        .number(["cost", "cost", ""], After(1), |set| set.cost)
        .number(["fit", "fit", ""], After(1), |set| set.fit)
        .number(["chi_square", "χ²", ""], Significant(3), |set| set.chi_square)
        .number(["within_one_sigma", "within 1 σ", ""], After(0), |set| set.within_one_sigma as f64)
        .number(["worst_sigma", "worst", "σ"], After(1), |set| set.worst_sigma)
        .number(["rank_at_twice_sigma", "rank at 2 σ", ""], After(0), |set| {
            set.rank_at_twice_sigma.map(|rank| rank as f64)
        })
        .number(["probability", "probability", ""], Significant(2), |set| set.probability)
        .caption(&format!(
            "Cost: −2 ln of plausibility, of fit, values and prices; a difference of 2 is a factor of e in odds. Reaches: every one of {count} \
             numbers within {} σ. Refuted: a number that was held out is more than 3 σ off.",
            significant(found.reach_sigma, 2)
        ))
        .table()
}

fn of_set(place: usize, set: &ExplainedSet) -> Vec<Part> {
    let mut parts = vec![
        Part::Table(changes(place, set)),
        Part::Table(readings(place, set)),
    ];
    let words = set.refute.iter().map(refuting);
    let words: Vec<String> = words.collect();
    parts.push(match words.is_empty() {
        true => Part::Text("No reading that was looked at tells it from the other sets.".to_string()),
        false => Part::List(words),
    });
    parts
}

fn changes(place: usize, set: &ExplainedSet) -> Table {
    Rows::of(&format!("/sets/{place}/changes"), &set.changes)
        .words("change", |own| own.name.as_str())
        .words("where", at)
        .number(["value", "value", ""], Significant(4), |own| own.value)
        .number(["stated", "stated", ""], Significant(4), |own| own.stated)
        .number(["range/0", "from", ""], Significant(3), |own| own.range[0])
        .number(["range/1", "to", ""], Significant(3), |own| own.range[1])
        .words("unit", |own| if own.unit == "1" { "" } else { own.unit.as_str() })
        .number(["into_range", "into range", ""], After(2), |own| own.into_range)
        .number(["cost", "cost", ""], After(1), |own| own.cost)
        .number(["price", "price", ""], After(1), |own| own.price)
        .table()
}

fn at(own: &ChangeMade) -> String {
    let numbers = own
        .numbers
        .iter()
        .map(|(name, value)| format!("{name} {}", significant(*value, 3)));
    numbers
        .chain(own.wings.iter().cloned())
        .collect::<Vec<_>>()
        .join(", ")
}

fn readings(place: usize, set: &ExplainedSet) -> Table {
    let sign = |own: &ReadingOfSet| match own.bound {
        Bound::None => "",
        Bound::Upper => "<",
        Bound::Lower => ">",
    };
    Rows::of(&format!("/sets/{place}/readings"), &set.readings)
        .words("case", |own| own.case.as_str())
        .words("channel", |own| own.channel.name().replace('_', " "))
        .number(["r_mm", "r", "mm"], Significant(3), |own| own.r_mm)
        .number(["r_to_mm", "to", "mm"], Significant(3), |own| own.r_to_mm)
        .bounded(["measured", "measured", ""], Significant(4), move |own| {
            (sign(own), own.measured)
        })
        .number(["sigma", "σ", ""], Significant(2), |own| own.sigma)
        .number(["stated", "uncalibrated", ""], Significant(3), |own| own.stated)
        .number(["with_set", "with the set", ""], Significant(3), |own| {
            own.with_set
        })
        .number(["misfit_sigma", "off", "σ"], After(1), |own| own.misfit_sigma)
        .words("use", |own| if own.is_held_out { "held out" } else { "fitted" })
        .table()
}

fn forecasts(place: usize, set: &ExplainedSet) -> Table {
    Rows::of(&format!("/sets/{place}/forecasts"), &set.forecasts)
        .words("would be measured", |own| own.condition.as_str())
        .words("channel", |own| own.channel.name().replace('_', " "))
        .number(["r_mm", "r", "mm"], Significant(3), |own| own.r_mm)
        .number(["stated", "uncalibrated", ""], Significant(3), |own| own.stated)
        .number(["with_set", "with the set", ""], Significant(3), |own| {
            own.with_set
        })
        .words("unit", |own| own.channel.unit())
        .folded(12, "What it predicts")
        .table()
}

fn refuting(own: &Refuting) -> String {
    let channel = own.channel.name().replace('_', " ");
    let at = own
        .r_mm
        .map_or(String::new(), |r_mm| format!(" at {} mm", significant(r_mm, 3)));
    format!(
        "To refute it: {channel}{at}, {}. It says {} ± {} {}; {} of {} other sets say otherwise by 3 σ or more.",
        own.condition,
        significant(own.with_set, 3),
        significant(own.sigma, 2),
        own.channel.unit(),
        own.against,
        own.others
    )
}
