//! What a planned campaign could tell, as text.

use crate::diagnose::Plan;
use crate::diagnose::plan::PlannedEffect;
use crate::diagnose::screening::ENOUGH_POWER;

use crate::page::text::{Table, number, significant, wrapped};

/// The page of `washout diagnose --plan`.
pub fn page(study: &str, plan: &Plan) -> String {
    let mut table = Table::new([
        "effect",
        "plausible_size",
        "standard_error",
        "detectable",
        "power",
        "absorbed",
        "cannot be told from (sigma apart)",
        "unit",
    ]);
    for effect in &plan.effects {
        table.row([
            effect.effect.clone(),
            significant(effect.scale, 3),
            significant(effect.standard_error, 2),
            number(effect.detectability, 1),
            format!("{:.0} %", 100.0 * effect.power),
            format!("{:.0} %", 100.0 * effect.absorbed),
            look_alikes(effect),
            effect.unit.clone(),
        ]);
    }
    format!(
        "{study}: {} numbers planned\n\n{}\nEffects (detectable: distance from none in sigma at the plausible size; absorbed: share of its signature\nthat the model's own unknowns could take up)\n{}{}",
        plan.numbers,
        wrapped(&plan.sentence, 0),
        table.render(),
        without_solution(&plan.effects)
    )
}

/// What is said of effects at whose plausible size the model has no solution.
fn without_solution(effects: &[PlannedEffect]) -> String {
    let names = effects.iter().filter(|effect| effect.has_no_solution);
    let names: Vec<&str> = names.map(|effect| effect.effect.as_str()).collect();
    match names.is_empty() {
        true => String::new(),
        false => wrapped(
            &format!(
                "The model has no solution at the plausible size of {}: detectable is what the derivative says.",
                names.join(", ")
            ),
            0,
        ),
    }
}

/// Those that could be seen and yet not be told apart; nothing where the effect itself is not seen.
fn look_alikes(effect: &PlannedEffect) -> String {
    if effect.power < ENOUGH_POWER {
        return "not seen".to_string();
    }
    let mut names: Vec<String> = effect
        .confused_with
        .iter()
        .take(3)
        .map(|other| format!("{} ({:.1})", other.effect, other.separation_sigma))
        .collect();
    if effect.confused_with.len() > names.len() {
        names.push(format!("{} more", effect.confused_with.len() - names.len()));
    }
    names.join(", ")
}
