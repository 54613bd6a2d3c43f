//! Effects of the library as strengths that can be moved.

use serde::Serialize;

use crate::effects::{Effect, Seam, all, is_applicable};
use crate::input::Design;

use super::inputs::step;

/// An effect and its strength.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Strength {
    /// Its name.
    pub name: &'static str,
    /// The name as words.
    pub title: String,
    /// What happens, in one sentence.
    pub sentence: String,
    /// Where it acts, in words.
    pub acts_on: &'static str,
    /// The number that is moved.
    pub parameter: &'static str,
    /// What that means.
    pub meaning: String,
    /// Its unit; empty for a pure number.
    pub unit: String,
    /// The strength without it.
    pub none: f64,
    /// Its strength; none if it is not in the model.
    pub value: Option<f64>,
    /// Lower end of its slider.
    pub low: f64,
    /// Upper end of its slider.
    pub high: f64,
    /// Step of its slider.
    pub step: f64,
    /// Strengths that are accepted.
    pub allowed: [f64; 2],
    /// Strengths that are plausible in nature.
    pub plausible: [f64; 2],
    /// Whether it is there wholly or not at all.
    pub all_or_none: bool,
}

/// All effects that can act on one of these designs, in the order of the library; `value` says the strength that one has.
pub fn strengths<'a>(
    designs: impl Iterator<Item = &'a Design> + Clone,
    value: impl Fn(&str) -> Option<f64>,
) -> Vec<Strength> {
    let can_act = |effect: &&'static dyn Effect| {
        let card = effect.card();
        value(card.name).is_some() || designs.clone().any(|design| is_applicable(&card, design))
    };
    all()
        .filter(can_act)
        .map(|effect| strength(effect, value(effect.card().name)))
        .collect()
}

fn strength(effect: &'static dyn Effect, value: Option<f64>) -> Strength {
    let card = effect.card();
    let parameter = card.parameters[0];
    let [from, to] = parameter.plausible;
    let size = parameter.scale();
    // as far again beyond what is plausible, and to nothing
    let [least, most] = parameter.range;
    let low = (from - 0.5 * size).min(0.0).min(value.unwrap_or(0.0)).max(least);
    let high = (to + 0.5 * size).max(0.0).max(value.unwrap_or(0.0)).min(most);
    let name: &'static str = card.name;
    Strength {
        name,
        title: name.replace('-', " "),
        sentence: card.summary.to_string(),
        acts_on: seam(card.seam),
        parameter: parameter.name,
        meaning: parameter.meaning.to_string(),
        unit: match parameter.unit {
            "1" => String::new(),
            unit => unit.to_string(),
        },
        none: 0.0,
        value,
        low,
        high,
        step: step(high - low),
        allowed: parameter.range,
        plausible: parameter.plausible,
        all_or_none: effect.is_all_or_none(),
    }
}

fn seam(seam: Seam) -> &'static str {
    match seam {
        Seam::Structure => "structure",
        Seam::Air => "air strip",
        Seam::Load => "nodal load",
        Seam::Kinematics => "kinematics",
        Seam::Picture => "picture",
    }
}
