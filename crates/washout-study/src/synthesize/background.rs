//! Errors that every model has and nobody states: in outline, stiffness and air law, one drawing for each wing.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::error::SynthesizeError;
use super::hidden::Hidden;
use crate::input::Design;
use crate::study::draws::Draws;

/// The errors of one wing: each a level and a tilt along the span.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Background {
    /// Name of the design.
    pub wing: String,
    /// Relative error of the mean chord.
    pub chord: f64,
    /// Relative error of the lift and drag coefficients: 1 + level + tilt (x − ½).
    pub air: [f64; 2],
    /// Error of the centre of pressure, chords, likewise.
    pub centre_of_pressure: [f64; 2],
    /// Relative error of the rods' torsional stiffness, likewise.
    pub torsion: [f64; 2],
    /// Relative error of their bending stiffness, likewise.
    pub bending: [f64; 2],
}

impl Background {
    /// Drawn with a standard deviation of `size`; that of the air law is half as large again, that of the centre of
    /// pressure a quarter of it in chords.
    pub fn drawn(design: &Design, size: f64, draws: Draws, stream: u64) -> Background {
        let draw = |index: u64, share: f64| share * size * draws.normal(stream, index);
        let pair = |index: u64, share: f64| [draw(index, share), draw(index + 1, share)];
        Background {
            wing: design.name.clone(),
            chord: draw(0, 1.0),
            air: pair(1, 1.5),
            centre_of_pressure: pair(3, 0.25),
            torsion: pair(5, 1.0),
            bending: pair(7, 1.0),
        }
    }

    /// Puts the errors into a design.
    ///
    /// # Errors
    /// If the design refuses a value.
    pub fn apply(&self, design: &mut Design) -> Result<(), SynthesizeError> {
        let chord = "planform.mean_chord_mm";
        if let Some(value) = design.get(chord) {
            design
                .set(chord, value * (1.0 + self.chord))
                .map_err(SynthesizeError::Background)?;
        }
        let has_air = design.flapping.is_some() || design.steady.is_some();
        let along = |[level, tilt]: [f64; 2]| format!("({level:?}) + ({tilt:?}) * (x - 0.5)");
        let factor = |errors| format!("1 + {}", along(errors));
        let mut formulas = vec![
            ("background-torsion", "torsion", factor(self.torsion)),
            ("background-bending", "bending", factor(self.bending)),
        ];
        if has_air {
            formulas.extend([
                ("background-lift", "lift", factor(self.air)),
                ("background-drag", "drag", factor(self.air)),
                (
                    "background-centre-of-pressure",
                    "centre-of-pressure",
                    along(self.centre_of_pressure),
                ),
            ]);
        }
        for (name, acts_on, expression) in formulas {
            let mut table = Hidden::own(name, acts_on, &expression).table;
            table.insert("strength".to_string(), toml::Value::Float(1.0));
            design.effects.insert(name.to_string(), table);
        }
        Ok(())
    }
}
