//! A missing field as a formula, to start an effect of one's own from.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::fields::Law;
use super::novel::{FieldProfile, Reconstruction};
use super::verdict::Draft;
use super::words::short;
use crate::study::Condition;

/// Highest power of r/R in a draft.
const POWERS: usize = 4;
/// A spring's field is per degree of twist, formulas know twist in rad.
const PER_DEGREE: &str = " * (0 - 57.29578 * twist)";

/// Draft of a reconstruction in these conditions; none if it has no field.
pub fn draft(reconstruction: &Reconstruction, conditions: &[Condition]) -> Option<Draft> {
    let profile = reconstruction
        .field
        .iter()
        .max_by(|a, b| a.total.abs().total_cmp(&b.total.abs()))?;
    // the field is that of one condition, or at the largest of both
    let there = |condition: &&Condition| {
        profile
            .condition
            .as_ref()
            .is_none_or(|name| condition.name == *name)
    };
    let largest =
        |of: fn(&Condition) -> Option<f64>| conditions.iter().filter(there).filter_map(of).reduce(f64::max);
    let f1 = largest(|condition| condition.frequency_hz);
    let phi1 = largest(|condition| condition.half_amplitude_deg).map(f64::to_radians);
    let shape = polynomial(profile)?;
    let place = format!("centred at {:.2} of the span", profile.centroid);
    let (factor, what) = match (reconstruction.law, reconstruction.scaling) {
        (Law::Load { .. } | Law::Free, Some(scaling)) => {
            let ([a, da], [b, db]) = (scaling.frequency, scaling.amplitude);
            (
                format!("{}{}", power("f", f1, a), power("Phi", phi1, b)),
                format!(
                    "a moment per length {place}, as frequency to the power {a:.1} ± {da:.1} and amplitude to the \
                     power {b:.1} ± {db:.1}"
                ),
            )
        }
        (Law::Load { .. }, None) => (
            String::new(),
            format!("a moment per length {place}, the same in all conditions"),
        ),
        (Law::Free, None) => (
            String::new(),
            format!("a moment per length {place}, different in every condition"),
        ),
        (Law::Spring, _) => (PER_DEGREE.into(), format!("a spring against twist {place}")),
        (Law::Compliance, _) => (String::new(), format!("a softer (or stiffer) stretch {place}")),
        (Law::Sensor, _) => (
            String::new(),
            format!("an error of the reading, the same in all conditions, {place}"),
        ),
    };
    let (acts_on, expression) = match reconstruction.law {
        Law::Compliance => (Some("torsion"), format!("1 / max(1 + {shape}, 0.05)")),
        Law::Sensor => (None, shape),
        _ => (Some("moment"), format!("({shape}){factor}")),
    };
    let effect = acts_on.map(|acts_on| {
        format!(
            "[effects.missing]\nkind = \"custom\"\nacts_on = \"{acts_on}\"\nexpression = \"{expression}\"\nstrength = 1.0\n\
             summary = \"{what}\"\n"
        )
    });
    Some(Draft {
        expression,
        what,
        effect,
    })
}

/// ` * (f / 26.0)^2.0`; nothing where no condition has the number.
fn power(name: &str, largest: Option<f64>, power: f64) -> String {
    largest.map_or(String::new(), |largest| {
        format!(" * ({name} / {largest:.4})^({power:.1})")
    })
}

/// Polynomial in x = r/R through the field, weighted by its errors.
fn polynomial(profile: &FieldProfile) -> Option<String> {
    let size = POWERS + 1;
    let largest = profile
        .points
        .iter()
        .map(|p| p.value.abs())
        .fold(f64::MIN_POSITIVE, f64::max);
    let mut normal = DMatrix::identity(size, size) * 1e-9;
    let mut right = DVector::zeros(size);
    for point in &profile.points {
        let weight = 1.0 / (point.standard_deviation / largest).max(0.01).powi(2);
        let row = DVector::from_fn(size, |power, _| point.r_over_length.powi(power as i32));
        normal += &row * row.transpose() * weight;
        right += row * (weight * point.value / largest);
    }
    let best = Cholesky::new(normal)?.solve(&right) * largest;
    let terms: Vec<String> = best
        .iter()
        .enumerate()
        .map(|(power, value)| match power {
            0 => short(*value),
            1 => format!("{} * x", short(*value)),
            _ => format!("{} * x^{power}", short(*value)),
        })
        .collect();
    Some(terms.join(" + ").replace("+ -", "- "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::novel::{FieldPoint, Scaling};
    use crate::effects::custom::VARIABLES;
    use crate::input::Expression;

    fn condition(name: &str, frequency_hz: f64) -> Condition {
        Condition {
            name: name.into(),
            wing: "w".into(),
            is_held_out: false,
            frequency_hz: Some(frequency_hz),
            half_amplitude_deg: Some(30.0),
            dynamic_pressure_pa: 50.0,
            length_m: 0.07,
        }
    }

    #[test]
    fn a_draft_gives_the_field_back_in_the_condition_that_it_is_of() {
        let field = |x: f64| 0.01 * x * (1.0 - x);
        let points = (0..=10).map(|k| f64::from(k) / 10.0).map(|x| FieldPoint {
            r_over_length: x,
            value: field(x),
            standard_deviation: 1e-4,
        });
        let mut reconstruction = Reconstruction {
            law: Law::Free,
            laws: Vec::new(),
            unit: "N m/m".into(),
            field: vec![FieldProfile {
                condition: Some("slow".into()),
                points: points.collect(),
                total: 0.0017,
                centroid: 0.5,
            }],
            scaling: Some(Scaling {
                frequency: [2.0, 0.1],
                amplitude: [-1.0, 0.1],
            }),
        };
        let conditions = [condition("slow", 20.0), condition("fast", 40.0)];
        let twist_rad = 0.1;
        let at = |expression: &str, f: f64| {
            let mut values = [0.0; VARIABLES.len()];
            for (name, value) in [
                ("x", 0.4),
                ("twist", twist_rad),
                ("f", f),
                ("Phi", 30.0_f64.to_radians()),
            ] {
                values[VARIABLES.iter().position(|known| *known == name).unwrap()] = value;
            }
            Expression::parse(expression, &VARIABLES).unwrap().value(&values)
        };
        let per_degree = -twist_rad.to_degrees();
        for (law, f, expected) in [
            (Law::Free, 20.0, field(0.4)),
            (Law::Free, 40.0, 4.0 * field(0.4)),
            (Law::Spring, 20.0, per_degree * field(0.4)),
            (Law::Compliance, 20.0, 1.0 / (1.0 + field(0.4))),
        ] {
            reconstruction.law = law;
            let effect = draft(&reconstruction, &conditions).unwrap().effect.unwrap();
            let table: toml::Table = effect.parse().unwrap();
            let expression = table["effects"]["missing"]["expression"].as_str().unwrap();
            let found = at(expression, f);
            assert!(
                (found / expected - 1.0).abs() < 0.02,
                "{law:?}: {expression}: {found} {expected}"
            );
        }
        reconstruction.law = Law::Sensor;
        assert_eq!(draft(&reconstruction, &conditions).unwrap().effect, None);
    }
}
