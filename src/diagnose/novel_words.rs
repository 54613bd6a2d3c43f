//! A missing field as a formula, to start an effect of one's own from.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::fields::Law;
use super::novel::{FieldProfile, Reconstruction};
use super::verdict::Draft;
use super::words::short;
use crate::study::Condition;

/// Highest power of r/R in a draft.
const POWERS: usize = 4;

/// Draft of a reconstruction in these conditions; none if it has no field.
pub fn draft(reconstruction: &Reconstruction, conditions: &[Condition]) -> Option<Draft> {
    let largest = |of: fn(&Condition) -> Option<f64>| conditions.iter().filter_map(of).reduce(f64::max);
    let f1 = largest(|condition| condition.frequency_hz);
    let phi1 = largest(|condition| condition.half_amplitude_deg).map(f64::to_radians);
    let profile = reconstruction
        .field
        .iter()
        .max_by(|a, b| a.total.abs().total_cmp(&b.total.abs()))?;
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
        (Law::Spring, _) => (" * -twist".into(), format!("a spring against twist {place}")),
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
