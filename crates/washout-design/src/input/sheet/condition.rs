//! Conditions such as `22 Hz, 35 deg`: which keys of the design they set, and how their cases are named.

use super::bench::Bench;
use super::words::Kind;
use crate::input::design::Design;
use crate::input::quantity::Quantity;
use crate::input::unit::{of_key, without_unit};

/// Conditions that set the same keys of the design.
#[derive(Debug, Clone, PartialEq)]
pub struct Family {
    /// The form of their names, such as `{frequency}hz`.
    pub form: String,
    /// What they set, such as `flapping.frequency_hz={frequency}`.
    pub set: Vec<String>,
    /// Their names, in the order of the table.
    pub cases: Vec<String>,
}

/// A number of a condition, and the key that it sets.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Dotted key of the design.
    pub key: String,
    /// Its value, in the unit of the key.
    pub value: f64,
}

/// The operating point of some readings; of none, the design as it stands.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Condition {
    /// Its numbers, each key once.
    pub points: Vec<Point>,
    /// The load on the still wing, if it is on a bench; then it has no numbers.
    pub bench: Option<Bench>,
    /// Name of its case if it has no numbers.
    pub name: String,
}

/// The key that a number of this kind sets in a design; what the design takes instead if it has none.
pub fn key(kind: Kind, design: &Design) -> Result<&'static str, String> {
    match (kind, design.flapping.is_some(), design.steady.is_some()) {
        (Kind::Frequency, true, _) => Ok("flapping.frequency_hz"),
        (Kind::Angle, true, _) => Ok("flapping.half_amplitude_deg"),
        (Kind::Angle, _, true) => Ok("steady.root_angle_deg"),
        (Kind::Speed, _, true) => Ok("steady.speed_m_s"),
        (_, true, _) => Err(format!(
            "{} flaps: its conditions are in Hz (frequency) and deg (half amplitude)",
            design.name
        )),
        (_, _, true) => Err(format!(
            "{} stands in a steady flow: its conditions are in m/s and deg (root angle)",
            design.name
        )),
        _ => Err(format!(
            "{} neither flaps nor stands in a flow; name a column after the key that differs, e.g. load[0].mass_kg",
            design.name
        )),
    }
}

/// Name of a key in the forms of cases: `frequency` of `flapping.frequency_hz`; the whole key where it is not the usual one, so
/// that no two are named alike.
fn short(key: &str) -> String {
    match key.split_once('.') {
        Some(("flapping" | "steady", last)) => without_unit(last).to_string(),
        _ => key.replace(|c: char| !c.is_ascii_alphanumeric(), "_"),
    }
}

/// What stands behind the number of a key in the names of cases: `hz`.
fn behind(key: &str) -> String {
    let last = key.rsplit('.').next().unwrap_or(key);
    of_key(last).map_or_else(|| format!("-{last}"), |unit| unit.suffix.to_string())
}

impl Condition {
    /// Name of its case, such as `22hz-35deg`.
    pub fn case(&self) -> String {
        if let Some(bench) = &self.bench {
            return bench.case();
        }
        let parts = self
            .points
            .iter()
            .map(|point| format!("{}{}", point.value, behind(&point.key)));
        match self.points.is_empty() {
            true => self.name.clone(),
            false => parts.collect::<Vec<_>>().join("-"),
        }
    }

    fn form(&self) -> String {
        if self.bench.is_some() {
            return self.case();
        }
        let parts = self
            .points
            .iter()
            .map(|point| format!("{{{}}}{}", short(&point.key), behind(&point.key)));
        match self.points.is_empty() {
            true => self.name.clone(),
            false => parts.collect::<Vec<_>>().join("-"),
        }
    }

    fn set(&self, design: &Design) -> Vec<String> {
        if let Some(bench) = &self.bench {
            return bench.sets(design);
        }
        let sets = self
            .points
            .iter()
            .map(|point| format!("{}={{{}}}", point.key, short(&point.key)));
        sets.collect()
    }
}

/// What moves the wing or its air, and no condition says: the numbers of the design are taken, in words.
pub fn of_design(conditions: &[Condition], design: &Design) -> Vec<[String; 2]> {
    let flapping = design.flapping.iter().flat_map(|own| {
        [
            ("flapping.frequency_hz", &own.frequency_hz, "Hz"),
            ("flapping.half_amplitude_deg", &own.half_amplitude_deg, "deg"),
        ]
    });
    let steady = design.steady.iter().flat_map(|own| {
        [
            ("steady.speed_m_s", &own.speed_m_s, "m/s"),
            ("steady.root_angle_deg", &own.root_angle_deg, "deg"),
        ]
    });
    let is_named = |key: &str| {
        let mut points = conditions.iter().flat_map(|condition| &condition.points);
        points.any(|point| point.key == key)
    };
    let is_any = conditions.iter().any(|condition| !condition.points.is_empty());
    let [on_bench, in_air] = [true, false].map(|is| conditions.iter().any(|own| own.bench.is_some() == is));
    let own = flapping
        .chain(steady)
        .filter(|(key, ..)| (is_any || (on_bench && in_air)) && !is_named(key));
    let range = |quantity: &Quantity| match quantity.assumption() {
        Some(assumed) => format!(" ({} to {})", assumed.range[0], assumed.range[1]),
        None => String::new(),
    };
    // the study of the table leaves out the range of what a case sets
    let is_set = |key: &str| on_bench && ["flapping.frequency_hz", "steady.speed_m_s"].contains(&key);
    let words = |key: &str, quantity: &Quantity, unit: &str| match (is_set(key), quantity.assumption()) {
        (true, Some(_)) => format!(
            "{} {unit}, of the design, without its range: the bench sets another",
            quantity.value()
        ),
        _ => format!("{} {unit}{}, of the design", quantity.value(), range(quantity)),
    };
    own.map(|(key, quantity, unit)| [key.to_string(), words(key, quantity, unit)])
        .collect()
}

/// Conditions by what they set in a design.
pub fn families(conditions: &[Condition], design: &Design) -> Vec<Family> {
    let mut families: Vec<Family> = Vec::new();
    for condition in conditions {
        let (form, case) = (condition.form(), condition.case());
        match families.iter_mut().find(|family| family.form == form) {
            Some(family) => family.cases.push(case),
            None => families.push(Family {
                set: condition.set(design),
                cases: vec![case],
                form,
            }),
        }
    }
    families
}
