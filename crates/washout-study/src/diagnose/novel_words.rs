//! A missing field as a formula, to start an effect of one's own from.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::digits::short;
use super::fields::{Driver, Law};
use super::novel::{FieldProfile, Reconstruction};
use super::scaling::Scaling;
use super::verdict::Draft;
use crate::study::Condition;

/// Highest power of r/R in a draft.
const POWERS: usize = 4;
/// A spring's field is per degree of twist, formulas know twist in rad.
const PER_DEGREE: &str = " * (0 - 57.29578 * twist)";
/// Most by which the size of a draft may exceed what was found.
const LARGEST: f64 = 3.0;

/// A number of a draft: name, value, range, unit, and why.
struct Number<'a> {
    name: &'static str,
    value: f64,
    range: [f64; 2],
    unit: &'a str,
    why: String,
}

/// Draft of a reconstruction in these conditions; none if it has no field.
pub fn draft(reconstruction: &Reconstruction, conditions: &[Condition]) -> Option<Draft> {
    let profile = largest_profile(reconstruction)?;
    let (shape, size) = polynomial(profile)?;
    let what = what(reconstruction)?;
    let (factor, mut numbers) = growth(reconstruction, profile, conditions);
    let unit = reconstruction.unit.as_str();
    let name = match reconstruction.law {
        Law::Spring => "k",
        Law::Compliance => "c",
        Law::Sensor => "e",
        _ => "m",
    };
    let size = Number {
        name,
        value: size,
        range: [0.0, LARGEST * size],
        unit,
        why: peak(profile, unit)?,
    };
    numbers.insert(0, size);
    let (acts_on, expression) = match reconstruction.law {
        Law::Compliance => (Some("torsion"), format!("1 / max(1 + {name} * ({shape}), 0.05)")),
        Law::Sensor => (None, format!("{name} * ({shape})")),
        Law::Spring => (Some("moment"), format!("{name} * ({shape}){PER_DEGREE}")),
        _ => (Some("moment"), format!("{name} * ({shape}){factor}")),
    };
    let rival = rival(reconstruction).map(|rival| {
        let (factor, numbers) = growth(&rival, profile, conditions);
        let numbers = numbers
            .iter()
            .map(|number| format!("# {}# {} in {}\n", line(number), number.name, number.unit));
        format!(
            "# These data cannot tell it from\n# expression = \"{name} * ({shape}){factor}\"\n{}",
            numbers.collect::<String>()
        )
    });
    let effect = acts_on
        .map(|acts_on| table(acts_on, &expression, &what, &numbers) + rival.as_deref().unwrap_or_default());
    Some(Draft {
        expression,
        what,
        effect,
    })
}

/// The largest value of a field, and where it is, in words.
fn peak(profile: &FieldProfile, unit: &str) -> Option<String> {
    let peak = profile
        .points
        .iter()
        .max_by(|a, b| a.value.abs().total_cmp(&b.value.abs()))?;
    let place = profile
        .condition
        .as_ref()
        .map_or(String::new(), |name| format!(" in {name}"));
    Some(format!(
        "{} ± {} {unit} at r/R = {:.2}{place}",
        short(peak.value.abs()),
        short(peak.standard_deviation),
        peak.r_over_length
    ))
}

/// What is missing, in words; none if it has no field.
pub fn what(reconstruction: &Reconstruction) -> Option<String> {
    let profile = largest_profile(reconstruction)?;
    let place = format!("centred at {:.2} of the span", profile.centroid);
    Some(match (reconstruction.law, reconstruction.scaling) {
        (law @ (Law::Load { .. } | Law::Onset { .. } | Law::Free), Some(scaling)) => {
            format!("a moment per length {place}, {}", scaling.words(law))
        }
        (Law::Load { .. } | Law::Onset { .. }, None) => {
            format!("a moment per length {place}, the same in all conditions")
        }
        (Law::Free, None) => format!("a moment per length {place}, different in every condition"),
        (Law::Spring, _) => format!("a spring against twist {place}"),
        (Law::Compliance, _) => format!("a softer (or stiffer) stretch {place}"),
        (Law::Sensor, _) => format!("an error of the reading, the same in all conditions, {place}"),
    })
}

/// The same load with the onset in what rises together with what it is said to set in at, if that explains the data as well.
fn rival(reconstruction: &Reconstruction) -> Option<Reconstruction> {
    let Law::Onset { .. } = reconstruction.law else {
        return None;
    };
    let (of, [from, _]) = reconstruction.scaling?.onset?.rival()?;
    Some(Reconstruction {
        law: Law::Onset { of, from },
        ..reconstruction.clone()
    })
}

fn largest_profile(reconstruction: &Reconstruction) -> Option<&FieldProfile> {
    let profiles = reconstruction.field.iter();
    profiles.max_by(|a, b| a.total.abs().total_cmp(&b.total.abs()))
}

/// How a moment grows with the motion, as a factor of one in the condition (or at the largest motion) that the field is of.
fn growth(
    reconstruction: &Reconstruction,
    profile: &FieldProfile,
    conditions: &[Condition],
) -> (String, Vec<Number<'static>>) {
    let there = |condition: &&Condition| match &profile.condition {
        Some(name) => condition.name == *name,
        None => !condition.is_held_out,
    };
    let largest = |driver: Driver| {
        let values = conditions
            .iter()
            .filter(there)
            .filter_map(|condition| driver.of(condition));
        values.reduce(f64::max)
    };
    let none = (String::new(), Vec::new());
    let Some(scaling) = reconstruction.scaling else {
        return none;
    };
    match reconstruction.law {
        Law::Load { .. } | Law::Free => by_powers(&scaling, largest),
        Law::Onset { of, from } => match largest(of) {
            Some(largest) => {
                let why = scaling.words(reconstruction.law);
                let (factor, number) = by_onset(&scaling, (of, from), largest, why);
                (factor, vec![number])
            }
            None => none,
        },
        _ => none,
    }
}

/// A driver of the motion as formulas know it: Hz, rad.
fn in_formula(driver: Driver, value: f64) -> f64 {
    match driver {
        Driver::Frequency => value,
        Driver::Amplitude => value.to_radians(),
    }
}

/// Powers of frequency and amplitude over the `largest` of each.
fn by_powers(scaling: &Scaling, largest: impl Fn(Driver) -> Option<f64>) -> (String, Vec<Number<'static>>) {
    let mut factor = String::new();
    let mut numbers = Vec::new();
    let powers = [
        (
            Driver::Frequency,
            "f",
            "a",
            scaling.frequency,
            scaling.frequency_is_told,
        ),
        (
            Driver::Amplitude,
            "Phi",
            "b",
            scaling.amplitude,
            scaling.amplitude_is_told,
        ),
    ];
    for (driver, variable, name, [mean, error], is_told) in powers {
        let Some(largest) = largest(driver) else { continue };
        factor.push_str(&format!(
            " * ({variable} / {:.4})^{name}",
            in_formula(driver, largest)
        ));
        let told = if is_told {
            ""
        } else {
            ", which is not told by the data"
        };
        numbers.push(Number {
            name,
            value: mean,
            range: [mean - 2.0 * error, mean + 2.0 * error],
            unit: "1",
            why: format!("{mean:.1} ± {error:.1}{told}"),
        });
    }
    (factor, numbers)
}

/// What sets in at a value of a driver, and reaches one at its `largest`.
fn by_onset(
    scaling: &Scaling,
    (of, from): (Driver, f64),
    largest: f64,
    why: String,
) -> (String, Number<'static>) {
    let found = scaling.onset.and_then(|onset| onset.at(of));
    let [_, error] = found.unwrap_or([from, 0.0]);
    let (variable, name, unit) = match of {
        Driver::Frequency => ("f", "f_on", "Hz"),
        Driver::Amplitude => ("Phi", "Phi_on", "rad"),
    };
    let [from, error, largest] = [from, error, largest].map(|value| in_formula(of, value));
    let number = Number {
        name,
        value: from,
        range: [
            (from - 2.0 * error).max(0.0),
            (from + 2.0 * error).min(0.5 * (from + largest)),
        ],
        unit,
        why,
    };
    let factor = format!(" * max({variable} - {name}, 0) / ({largest:.4} - {name})");
    (factor, number)
}

fn table(acts_on: &str, expression: &str, what: &str, numbers: &[Number]) -> String {
    let mut text = format!(
        "[effects.missing]\nkind = \"custom\"\nacts_on = \"{acts_on}\"\nexpression = \"{expression}\"\nstrength = 1.0\n\
         summary = \"{what}\"\n"
    );
    for number in numbers {
        text.push_str(&line(number));
    }
    let units = numbers
        .iter()
        .map(|number| format!("{} = \"{}\"", number.name, number.unit));
    text.push_str(&format!(
        "units = {{ {} }}\n",
        units.collect::<Vec<_>>().join(", ")
    ));
    text
}

/// A number with its range, as a table of an effect has it.
fn line(number: &Number) -> String {
    let [low, high] = number.range.map(float);
    format!(
        "{} = {{ assumed = {}, range = [{low}, {high}], why = \"{}\" }}\n",
        number.name,
        float(number.value),
        number.why
    )
}

/// A float as TOML has it.
fn float(value: f64) -> String {
    let text = short(value);
    match text.contains(['.', 'e']) {
        true => text,
        false => text + ".0",
    }
}

/// Polynomial in x = r/R through the field, weighted by its errors, over the largest size of the field; and that size.
fn polynomial(profile: &FieldProfile) -> Option<(String, f64)> {
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
    let best = Cholesky::new(normal)?.solve(&right);
    let terms: Vec<String> = best
        .iter()
        .enumerate()
        .map(|(power, value)| match power {
            0 => short(*value),
            1 => format!("{} * x", short(*value)),
            _ => format!("{} * x^{power}", short(*value)),
        })
        .collect();
    Some((terms.join(" + ").replace("+ -", "- "), largest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::novel::FieldPoint;
    use crate::diagnose::scaling::Onset;
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
                onset: Some(Onset {
                    probability: 1.0,
                    in_frequency: 0.6,
                    frequency_hz: Some([15.0, 1.0]),
                    amplitude_deg: Some([20.0, 1.0]),
                }),
                ..Scaling::of_powers([2.0, 0.1], [-1.0, 0.1])
            }),
        };
        let conditions = [condition("slow", 20.0), condition("fast", 40.0)];
        let twist_rad = 0.1;
        let at = |own: &toml::Table, f: f64| {
            let mut known = vec![
                ("x", 0.4),
                ("twist", twist_rad),
                ("f", f),
                ("Phi", 30.0_f64.to_radians()),
            ];
            for name in own["units"].as_table().unwrap().keys() {
                let number = |key: &str| own[name][key].as_float().unwrap();
                let range = own[name]["range"].as_array().unwrap();
                let [low, high] = [0, 1].map(|end| range[end].as_float().unwrap());
                assert!(low <= number("assumed") && number("assumed") <= high, "{own}");
                known.push((name, number("assumed")));
            }
            let names: Vec<&str> = known.iter().map(|number| number.0).collect();
            let values: Vec<f64> = known.iter().map(|number| number.1).collect();
            let expression = own["expression"].as_str().unwrap();
            Expression::parse(expression, &names).unwrap().value(&values)
        };
        const ONSET: Law = Law::Onset {
            of: Driver::Frequency,
            from: 15.0,
        };
        let per_degree = -twist_rad.to_degrees();
        for (law, f, expected) in [
            (Law::Free, 20.0, field(0.4)),
            (Law::Free, 40.0, 4.0 * field(0.4)),
            (ONSET, 20.0, field(0.4)),
            (ONSET, 40.0, 5.0 * field(0.4)),
            (ONSET, 14.0, 0.0),
            (Law::Spring, 20.0, per_degree * field(0.4)),
            (Law::Compliance, 20.0, 1.0 / (1.0 + field(0.4))),
        ] {
            reconstruction.law = law;
            let effect = draft(&reconstruction, &conditions).unwrap().effect.unwrap();
            let table: toml::Table = effect.parse().unwrap();
            let own = table["effects"]["missing"].as_table().unwrap();
            let found = at(own, f);
            assert!(
                (found - expected).abs() <= 0.02 * expected.abs(),
                "{law:?}: {effect}: {found} {expected}"
            );
        }
        reconstruction.law = ONSET;
        let effect = draft(&reconstruction, &conditions).unwrap().effect.unwrap();
        assert!(effect.contains("# Phi_on = { assumed = 0.349, range"), "{effect}");
        let rival = effect
            .replace("\nexpression", "\n# first")
            .replace("# expression", "expression")
            .replace("# Phi_on =", "Phi_on =")
            .replace("units = { ", "units = { Phi_on = \"rad\", ");
        let table: toml::Table = rival.parse().unwrap();
        let found = at(table["effects"]["missing"].as_table().unwrap(), 99.0);
        assert!((found / field(0.4) - 1.0).abs() < 0.02, "{rival}: {found}");
        reconstruction.law = Law::Sensor;
        assert_eq!(draft(&reconstruction, &conditions).unwrap().effect, None);
    }
}
