//! What a planned campaign could tell, for people.

use crate::diagnose::Plan;
use crate::diagnose::plan::PlannedEffect;
use crate::diagnose::screening::ENOUGH_POWER;

use crate::page::Digits::{After, Significant};
use crate::page::{Page, Part, Rows, Table};

/// Effects that a screen shows.
const SHOWN: usize = 10;
/// Of the effects that one is not told from, those that are named.
const NAMED: usize = 3;

/// What `washout diagnose --plan` says.
pub fn page(study: &str, plan: &Plan) -> Page {
    let mut first = table(plan, 1).without(&["standard_error", "power", "absorbed"]);
    first.caption = "Detectable: distance from none at that size.".to_string();
    first.most_in_text = SHOWN;
    let parts = |table: Table| {
        let mut parts = vec![Part::Table(table)];
        parts.extend(without_solution(&plan.effects).map(Part::Text));
        parts
    };
    let mut page = Page {
        title: format!("{study}: {} numbers planned", plan.numbers),
        kind: "plan",
        lead: vec![Part::Sentence(plan.sentence.clone())],
        ..Page::default()
    };
    page.brief = page.lead.clone();
    page.brief.extend(without_solution(&plan.effects).map(Part::Text));
    page.brief.push(Part::Table(first));
    page.section(
        "effects",
        "What could be seen, and told apart",
        parts(table(plan, NAMED)),
    );
    page
}

/// The effects, with this many of those that each is not told from.
fn table(plan: &Plan, named: usize) -> Table {
    Rows::of("/effects", &plan.effects)
        .words("effect", |row| row.effect.as_str())
        .number(["judged_at", "size", ""], Significant(3), |row| row.judged_at)
        .number(["standard_error", "standard error", ""], Significant(2), |row| {
            row.standard_error
        })
        .words("unit", |row| if row.unit == "1" { "" } else { &row.unit })
        .number(["detectability", "detectable", "σ"], After(1), |row| row.detectability)
        .number(["power", "power", ""], After(2), |row| row.power)
        .number(["absorbed", "absorbed", ""], After(2), |row| row.absorbed)
        .words("not told from (σ apart)", |row| look_alikes(row, named))
        .caption(
            "Size: plausible. Detectable: distance from none at that size. Power: share of campaigns that would show it. Absorbed: share of its \
             signature that the model's own unknowns could take up.",
        )
        .table()
}

/// What is said of effects at whose plausible size the model has no solution.
fn without_solution(effects: &[PlannedEffect]) -> Option<String> {
    let names = effects.iter().filter(|effect| effect.has_no_solution);
    let names: Vec<&str> = names.map(|effect| effect.effect.as_str()).collect();
    (!names.is_empty()).then(|| {
        format!(
            "The model has no solution at the plausible size of {}: these are judged at the largest size that has one.",
            names.join(", ")
        )
    })
}

/// Those that could be seen and yet not be told apart, the first by name; nothing where the effect itself is not seen.
fn look_alikes(effect: &PlannedEffect, named: usize) -> String {
    if effect.power < ENOUGH_POWER {
        return "not seen".to_string();
    }
    let mut names: Vec<String> = effect
        .confused_with
        .iter()
        .take(named)
        .map(|other| format!("{} ({:.1})", other.effect, other.separation_sigma))
        .collect();
    if effect.confused_with.len() > names.len() {
        names.push(format!("{} more", effect.confused_with.len() - names.len()));
    }
    names.join(", ")
}
