//! Causes without a name as a fit may try them: one bump somewhere along the span, of a moment, a spring or a softer stretch.
//!
//! They are off, and no part of the model nor of what it is known to lack; only where nothing with a name explains the readings are they
//! fitted together with the rest. They are tried in air only, whose pressure tells how large a load may be: on the bench linear fields
//! stand alone.

use crate::aero::Flow;
use crate::effects::custom::Custom;
use crate::effects::{Effect, is_applicable};
use crate::geometry::Planform;
use crate::input::Design;

/// What kind of thing has no name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A moment per length that grows with powers of frequency and amplitude.
    Moment,
    /// A moment per length against the twist.
    Spring,
    /// A stretch of the rods that twists more easily.
    Softness,
}

impl Kind {
    /// What it is called.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Moment => "unnamed moment",
            Kind::Spring => "unnamed spring",
            Kind::Softness => "unnamed softness",
        }
    }
}

/// What has no name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unnamed {
    /// Name of its table in a design.
    pub name: &'static str,
    /// What kind of thing it is.
    pub kind: Kind,
    /// What the formula acts on.
    pub acts_on: &'static str,
    /// Formula.
    pub formula: &'static str,
    /// How it grows with the motion where the wing flaps: a factor, and its numbers.
    pub growth: Option<(&'static str, &'static [Number])>,
    /// Strength while it is off.
    pub off: f64,
    /// Numbers of its formula, the first of which is its size.
    pub numbers: &'static [Number],
}

/// A number of a cause without a name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number {
    /// Key in its table.
    pub key: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Mean before the data; a size is none.
    pub mean: f64,
    /// Standard deviation before the data; of a load, over the dynamic pressure at the tip times the square of the mean chord.
    pub sigma: f64,
    /// Values that it may take, likewise.
    pub range: [f64; 2],
}

const PLACE: Number = Number {
    key: "place",
    unit: "1",
    mean: 0.5,
    sigma: 0.3,
    range: [0.0, 1.0],
};

const fn size(key: &'static str, unit: &'static str, sigma: f64, range: [f64; 2]) -> Number {
    Number {
        key,
        unit,
        mean: 0.0,
        sigma,
        range,
    }
}

const fn exponent(key: &'static str) -> Number {
    Number {
        key,
        unit: "1",
        mean: 1.0,
        sigma: 1.0,
        range: [0.0, 4.0],
    }
}

/// All of them.
pub const UNNAMED: [Unnamed; 3] = [
    Unnamed {
        name: "unnamed-moment",
        kind: Kind::Moment,
        acts_on: "moment",
        formula: "exp(-((x - place) / 0.15)^2)",
        growth: Some(("(f / 25)^a * (Phi / 0.6)^b", &[exponent("a"), exponent("b")])),
        off: 0.0,
        numbers: &[size("strength", "N m/m", 1.0, [-20.0, 20.0]), PLACE],
    },
    Unnamed {
        name: "unnamed-spring",
        kind: Kind::Spring,
        acts_on: "moment",
        formula: "-twist * exp(-((x - place) / 0.15)^2)",
        growth: None,
        off: 0.0,
        numbers: &[size("strength", "N m/m/rad", 2.0, [-40.0, 40.0]), PLACE],
    },
    Unnamed {
        name: "unnamed-softness",
        kind: Kind::Softness,
        acts_on: "torsion",
        formula: "exp(-k * exp(-((x - place) / 0.1)^2))",
        growth: None,
        off: 1.0,
        numbers: &[size("k", "1", 1.0, [-3.0, 6.0]), PLACE],
    },
];

impl Unnamed {
    /// All its numbers, those of its growth last.
    pub fn all_numbers(&self) -> impl Iterator<Item = &'static Number> {
        self.numbers
            .iter()
            .chain(self.growth.map_or(&[][..], |(_, numbers)| numbers))
    }

    /// Dotted key of one of its numbers.
    pub fn key(&self, number: &Number) -> String {
        format!("effects.{}.{}", self.name, number.key)
    }

    /// What its size is measured by in a design: for loads N m/m.
    pub fn measure(&self, design: &Design) -> f64 {
        if self.kind == Kind::Softness {
            return 1.0;
        }
        let length_m = 1e-3 * design.planform.length_mm.value();
        let speed = Flow::from_design(design).map_or(0.0, |flow| flow.velocity(length_m).norm());
        // a case that was solved has a planform
        let chord_m = Planform::from_design(design).map_or(0.0, |planform| planform.mean_chord_m());
        0.5 * design.air.density_kg_m3.value() * (speed * chord_m).powi(2)
    }
}

/// Puts those that can act into a design that meets air, off.
pub fn place(design: &mut Design) {
    if design.flapping.is_none() && design.steady.is_none() {
        return;
    }
    for cause in &UNNAMED {
        let growth = cause.growth.filter(|_| design.flapping.is_some());
        let (formula, exponents) = match growth {
            Some((factor, exponents)) => (format!("{factor} * {}", cause.formula), exponents),
            None => (cause.formula.to_string(), &[][..]),
        };
        let mut table = Custom::table(cause.acts_on, &formula);
        for number in cause.numbers.iter().chain(exponents) {
            table.insert(number.key.to_string(), toml::Value::Float(number.mean));
        }
        table.insert("strength".to_string(), toml::Value::Float(cause.off));
        if Custom::read(cause.name, &table, design).is_ok_and(|(own, _)| is_applicable(&own.card(), design)) {
            design.effects.insert(cause.name.to_string(), table);
        }
    }
}
