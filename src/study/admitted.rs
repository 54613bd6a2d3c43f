//! What is admitted to be wrong with every wing's model, though nobody says so: chord, air law, centre of pressure, stiffness, each
//! at a level and a tilt along the span. What they do to a reading is no discovery.
//!
//! A study admits a share τ of error (its `slop`). The coefficients of a quasi-steady air law are known less well than a chord or
//! the stiffness of a rod; so they have twice as much.

use crate::effects::custom::Custom;
use crate::effects::{Effect, is_applicable};
use crate::input::Design;

/// One admitted error: an effect at strength 0 whose strength has a standard deviation of `per_share` τ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Admitted {
    /// Name of its table in a design.
    pub name: &'static str,
    /// What the formula acts on.
    pub acts_on: &'static str,
    /// Formula; its factor is the strength.
    pub expression: &'static str,
    /// Standard deviation for a share of 1.
    pub per_share: f64,
}

const fn admitted(
    name: &'static str,
    acts_on: &'static str,
    expression: &'static str,
    per_share: f64,
) -> Admitted {
    Admitted {
        name,
        acts_on,
        expression,
        per_share,
    }
}

/// The key of a design whose relative error is admitted too: τ.
pub const CHORD: &str = "planform.mean_chord_mm";

/// All others; shifts of the centre of pressure in chords, the others relative.
pub const ADMITTED: [Admitted; 10] = [
    admitted("admitted-lift", "lift", "2", 2.0),
    admitted("admitted-lift-tilt", "lift", "1 + 2 * (x - 0.5)", 1.0),
    admitted("admitted-drag", "drag", "2", 2.0),
    admitted("admitted-drag-tilt", "drag", "1 + 2 * (x - 0.5)", 1.0),
    admitted("admitted-centre-of-pressure", "centre-of-pressure", "1", 0.5),
    admitted(
        "admitted-centre-of-pressure-tilt",
        "centre-of-pressure",
        "2 * (x - 0.5)",
        0.25,
    ),
    admitted("admitted-torsion", "torsion", "2", 1.0),
    admitted("admitted-torsion-tilt", "torsion", "1 + 2 * (x - 0.5)", 1.0),
    admitted("admitted-bending", "bending", "2", 1.0),
    admitted("admitted-bending-tilt", "bending", "1 + 2 * (x - 0.5)", 1.0),
];

/// Puts those that can act into a design, at strength 0.
pub fn admit(design: &mut Design) {
    for error in &ADMITTED {
        let mut table = Custom::table(error.acts_on, error.expression);
        table.insert("strength".to_string(), toml::Value::Float(0.0));
        if Custom::read(error.name, &table, design).is_ok_and(|(own, _)| is_applicable(&own.card(), design)) {
            design.effects.insert(error.name.to_string(), table);
        }
    }
}
