//! The inputs of a wing that somebody would move: which numbers of the design, in which group, and how far a slider goes.

use serde::Serialize;

use crate::input::design::{CentreOfPressure, Coefficients, Section};
use crate::input::{Design, DesignNumber};

/// Groups, in the order in which they are shown.
pub const GROUPS: [&str; 9] = [
    "Motion",
    "Air",
    "Rods",
    "Spars",
    "Film",
    "Root",
    "Mass",
    "Uncertain",
    "Other",
];

/// Steps of a slider from end to end, about.
const STEPS: f64 = 200.0;
/// Standard deviations to each side that are shaded.
const SHADED: f64 = 2.0;
/// Ends of a slider over the value that it has as opened, where nothing says what is plausible.
const REACH: [f64; 2] = [0.4, 2.0];

/// An input that can be moved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Input {
    /// Dotted key of the design by which it is set.
    pub key: String,
    /// Group that it is shown in: one of [`GROUPS`].
    pub group: &'static str,
    /// What it is.
    pub label: String,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// Its value.
    pub value: f64,
    /// Its value as opened.
    pub original: f64,
    /// Lower end of its slider.
    pub low: f64,
    /// Upper end of its slider.
    pub high: f64,
    /// Step of its slider.
    pub step: f64,
    /// Values that can be typed.
    pub allowed: [f64; 2],
    /// Range that is thought possible; none if the value is stated as a fact.
    pub plausible: Option<[f64; 2]>,
    /// Whether only whole numbers are accepted.
    pub integer: bool,
    /// Other keys that move with it: the start of the next piece of the rod.
    pub with: Vec<String>,
}

/// What a study holds uncertain.
#[derive(Debug, Clone, PartialEq)]
pub struct Prior {
    /// Dotted key.
    pub key: String,
    /// Mean; the design's own value where none is stated.
    pub mean: Option<f64>,
    /// Standard deviation.
    pub sigma: Option<f64>,
    /// The values that it may take.
    pub range: Option<[f64; 2]>,
}

impl Prior {
    /// The range that is shaded: as stated, or two standard deviations to each side.
    fn plausible(&self, value: f64) -> Option<[f64; 2]> {
        let mean = self.mean.unwrap_or(value);
        let about = |sigma: f64| [mean - SHADED * sigma, mean + SHADED * sigma];
        self.range.or(self.sigma.map(about))
    }
}

/// The inputs of a design as opened, group by group; `priors`: what a study holds uncertain.
pub fn inputs(design: &Design, priors: &[Prior]) -> Vec<Input> {
    let numbers = design.numbers();
    let inputs = numbers.iter().filter_map(|number| {
        let prior = priors.iter().find(|prior| prior.key == number.key);
        let plausible = prior.and_then(|prior| prior.plausible(number.value));
        let plausible = plausible.or(number.plausible);
        let place = place(design, number, prior.is_some() || number.plausible.is_some())?;
        Some(input(number, place, plausible))
    });
    let mut inputs: Vec<Input> = inputs.collect();
    let order = |input: &Input| GROUPS.iter().position(|group| *group == input.group);
    inputs.sort_by_key(order);
    inputs
}

/// Where an input is shown, and between what it lies where others bound it.
struct PlaceOf {
    group: &'static str,
    label: String,
    with: Vec<String>,
    between: Option<[f64; 2]>,
}

impl PlaceOf {
    fn new(group: &'static str, label: impl Into<String>) -> Option<PlaceOf> {
        Some(PlaceOf {
            group,
            label: label.into(),
            with: Vec::new(),
            between: None,
        })
    }
}

/// Where a number is shown; none if nobody would move it. `is_uncertain`: whether a range is thought possible.
fn place(design: &Design, number: &DesignNumber, is_uncertain: bool) -> Option<PlaceOf> {
    let words = plain(&number.words);
    let key = number.key.as_str();
    let (first, rest) = key.split_once('.')?;
    let (table, index) = match first.split_once('[') {
        None => (first, None),
        Some((table, index)) => (table, index.trim_end_matches(']').parse::<usize>().ok()),
    };
    match (table, index) {
        ("flapping" | "steady", _) => PlaceOf::new("Motion", words),
        ("air", _) => match rest {
            "lift_slope_per_rad" if design.air.coefficients != Coefficients::ThinAirfoil => None,
            "centre_of_pressure_fraction" if design.air.centre_of_pressure() != CentreOfPressure::Fixed => {
                None
            }
            _ => PlaceOf::new("Air", words),
        },
        ("rod", Some(index)) => rod(design, index, rest, &words),
        ("spar", Some(index)) if !rest.contains("plies") => {
            let words = if rest == "at_mm" {
                "position".to_string()
            } else {
                words
            };
            PlaceOf::new("Spars", format!("spar {}: {words}", index + 1))
        }
        ("film", _) if rest != "residual_compression" => PlaceOf::new("Film", words),
        ("root", _) => PlaceOf::new("Root", words),
        ("load" | "gravity", _) => match (number.value != 0.0 || is_uncertain, index) {
            (false, _) => None,
            (true, Some(index)) => PlaceOf::new("Mass", format!("load {}: {words}", index + 1)),
            (true, None) => PlaceOf::new("Mass", words),
        },
        ("material", _) => material(design, rest, &words, is_uncertain),
        ("structure", _) if rest.starts_with("rod_") => PlaceOf::new("Rods", words),
        ("planform", _) if is_uncertain => PlaceOf::new("Uncertain", words),
        ("planform", _) => PlaceOf::new("Other", words),
        _ if is_uncertain => PlaceOf::new("Uncertain", words),
        _ => None,
    }
}

/// Sections of rods, and where one piece ends and the next starts, as one input.
fn rod(design: &Design, index: usize, rest: &str, words: &str) -> Option<PlaceOf> {
    let pieces = &design.rod;
    let piece = pieces.get(index)?;
    if let Some(section) = rest.strip_prefix("section.") {
        let is_ply = section.starts_with("plies");
        return match is_ply {
            true => None,
            false => PlaceOf::new("Rods", format!("rod {}: {words}", index + 1)),
        };
    }
    if rest != "to_mm" {
        return None;
    }
    let (from, to) = (piece.from_mm.value(), piece.to_mm.value());
    let next = pieces.get(index + 1).filter(|next| next.from_mm.value() == to);
    let until = next.map_or(design.planform.length_mm.value(), |next| next.to_mm.value());
    let label = match next {
        Some(_) => format!("break between rod {} and rod {}", index + 1, index + 2),
        None => format!("end of rod {}", index + 1),
    };
    Some(PlaceOf {
        group: "Rods",
        label,
        with: next
            .map(|_| format!("rod[{}].from_mm", index + 1))
            .into_iter()
            .collect(),
        between: Some([from, until]),
    })
}

/// Stiffness and density of what the wing is made of, in the group of what is made of it.
fn material(design: &Design, rest: &str, words: &str, is_uncertain: bool) -> Option<PlaceOf> {
    let (name, number) = rest.rsplit_once('.')?;
    let label = format!("{name}: {words}");
    let is_of = |material: &Option<String>, section: &Section| {
        material.as_deref() == Some(name)
            || match section {
                Section::Laminate { plies, .. } => plies.iter().any(|ply| ply.material == name),
                _ => false,
            }
    };
    let of_rods = design.rod.iter().any(|rod| is_of(&rod.material, &rod.section));
    let of_spars = design
        .spar
        .iter()
        .any(|spar| is_of(&spar.material, &spar.section));
    let of_film = design.film.as_ref().is_some_and(|film| film.material == name);
    if !(of_rods || of_spars || of_film) {
        return None;
    }
    match number {
        "strength_mpa" => None,
        "density_kg_m3" => PlaceOf::new("Mass", label),
        "poisson" if !is_uncertain => None,
        _ if of_rods => PlaceOf::new("Rods", label),
        _ if of_film => PlaceOf::new("Film", label),
        _ => PlaceOf::new("Spars", label),
    }
}

/// Words without what stands in brackets or for whom they hold.
fn plain(words: &str) -> String {
    let words = words.split(" (").next().unwrap_or(words);
    words.split(", for ").next().unwrap_or(words).replace('`', "")
}

fn input(number: &DesignNumber, place: PlaceOf, plausible: Option<[f64; 2]>) -> Input {
    let step = |[low, high]: [f64; 2]| if number.is_whole { 1.0 } else { step(high - low) };
    let [low, high] = match place.between {
        Some(between) => between,
        None => {
            let ends = ends(number, plausible);
            on_steps(ends, step(ends), number)
        }
    };
    Input {
        key: number.key.clone(),
        group: place.group,
        label: place.label,
        unit: number.unit,
        value: number.value,
        original: number.value,
        low,
        high,
        step: step([low, high]),
        allowed: number.allowed,
        plausible,
        integer: number.is_whole,
        with: place.with,
    }
}

/// Ends of a slider: about the plausible range, or about the value, and within what is accepted.
fn ends(number: &DesignNumber, plausible: Option<[f64; 2]>) -> [f64; 2] {
    let [least, most] = number.allowed;
    let value = number.value;
    let of_value = [value * REACH[0], value * REACH[1]];
    let [mut low, mut high] = [of_value[0].min(of_value[1]), of_value[0].max(of_value[1])];
    if let Some([from, to]) = plausible {
        let margin = 0.5 * (to - from);
        (low, high) = (from - margin, to + margin);
        // what cannot be negative by its kind is not made so by a margin
        if from >= 0.0 {
            low = low.max(0.0);
        }
    }
    if low == high {
        (low, high) = match number.unit {
            "deg" => (value - 30.0, value + 30.0),
            _ => (value - 1.0, value + 1.0),
        };
    }
    [low.clamp(least, most), high.clamp(least, most)]
}

/// Ends on whole steps, outside of those that are wanted, and within what is accepted.
fn on_steps([low, high]: [f64; 2], step: f64, number: &DesignNumber) -> [f64; 2] {
    let [least, most] = number.allowed;
    // a division by a whole number is as near to the decimal as can be; a product is not
    let whole = (1.0 / step).round();
    let on_step = |count: f64| if step < 1.0 { count / whole } else { count * step };
    [
        on_step((low / step + 1e-9).floor()).clamp(least, most),
        on_step((high / step - 1e-9).ceil()).clamp(least, most),
    ]
}

/// 1, 2 or 5 times a power of ten, about a two-hundredth of a slider.
pub fn step(width: f64) -> f64 {
    let fine = width / STEPS;
    if !(fine > 0.0 && fine.is_finite()) {
        return 0.01;
    }
    let power = 10f64.powf(fine.log10().floor());
    let digit = [1.0, 2.0, 5.0]
        .into_iter()
        .find(|digit| digit * power >= fine * (1.0 - 1e-9));
    digit.unwrap_or(10.0) * power
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    fn of(name: &str) -> Vec<Input> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("designs").join(name);
        inputs(&Design::load(&path, &[]).expect("a design").design, &[])
    }

    #[test]
    fn every_slider_holds_its_value_and_stays_within_what_is_accepted() {
        for name in [
            "twist-v1.toml",
            "twist-v2.toml",
            "rigid.toml",
            "minguet-1.toml",
            "pre-pazy.toml",
        ] {
            let inputs = of(name);
            assert!(inputs.len() > 5, "{name}: {}", inputs.len());
            for input in inputs {
                assert!(
                    input.low <= input.value && input.value <= input.high,
                    "{name}: {input:?}"
                );
                assert!(
                    input.allowed[0] <= input.low && input.high <= input.allowed[1],
                    "{name}: {input:?}"
                );
                assert!(input.step > 0.0 && input.low < input.high, "{name}: {input:?}");
            }
        }
    }

    #[test]
    fn the_break_of_a_rod_is_one_input_between_its_neighbours() {
        let inputs = of("twist-v2.toml");
        let found = inputs
            .iter()
            .find(|input| input.key == "rod[0].to_mm")
            .expect("a break");
        assert_eq!(found.with, ["rod[1].from_mm"]);
        assert_eq!((found.low, found.high), (0.0, 70.0));
        assert!(inputs.iter().all(|input| input.key != "rod[1].from_mm"));
    }

    #[test]
    fn groups_come_in_their_order() {
        let places = of("twist-v2.toml");
        let places: Vec<usize> = places
            .iter()
            .map(|input| {
                GROUPS
                    .iter()
                    .position(|group| *group == input.group)
                    .expect("a group")
            })
            .collect();
        assert!(places.is_sorted(), "{places:?}");
    }

    #[test]
    fn steps_are_round() {
        assert_eq!([step(36.8), step(2.0), step(100.0)], [0.2, 0.01, 0.5]);
    }
}
