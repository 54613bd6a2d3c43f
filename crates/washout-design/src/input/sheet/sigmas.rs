//! Standard deviations that are given for the readings of a table which state none.

use std::fmt;
use std::str::FromStr;

use crate::input::measurement::Channel;

/// Standard deviations that a reading can have, in its unit.
const ACCEPTED: [f64; 2] = [1e-9, 1e9];

/// Units of channels, each with how else it is written.
const UNITS: [(&str, &[&str]); 6] = [
    ("deg", &["°", "degree", "degrees"]),
    ("mm", &[]),
    ("deg/mm", &["°/mm"]),
    ("mN", &[]),
    ("mW", &[]),
    ("Hz", &[]),
];

/// Standard deviations by the unit of a channel, and that of all others. `0.3` is of every channel; `0.3 deg, 0.05 mm` of twist and of
/// displacements.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sigmas {
    any: Option<f64>,
    of_unit: Vec<(&'static str, f64)>,
}

impl Sigmas {
    /// That of a channel, in its unit; none if none was given.
    pub fn of(&self, channel: Channel) -> Option<f64> {
        let own = self.of_unit.iter().find(|(unit, _)| *unit == channel.unit());
        own.map(|(_, sigma)| *sigma).or(self.any)
    }

    /// Those that were given with a unit.
    pub fn of_units(&self) -> impl Iterator<Item = (&'static str, f64)> {
        self.of_unit.iter().copied()
    }

    /// The one that was given without a unit.
    pub fn any(&self) -> Option<f64> {
        self.any
    }
}

impl From<f64> for Sigmas {
    fn from(any: f64) -> Sigmas {
        Sigmas {
            any: Some(any),
            of_unit: Vec::new(),
        }
    }
}

impl FromStr for Sigmas {
    type Err = String;

    fn from_str(text: &str) -> Result<Sigmas, String> {
        let mut sigmas = Sigmas::default();
        let mut rest = text.trim();
        while !rest.is_empty() {
            let (number, unit, behind) = first(rest);
            let value: f64 = number
                .replace(',', ".")
                .parse()
                .map_err(|_| "is no number; write e.g. 0.4, 0,4 or \"0.3 deg, 0.05 mm\"".to_string())?;
            let [low, high] = ACCEPTED;
            if !(low..=high).contains(&value) {
                return Err(format!(
                    "must lie in {low:e} … {high:e}; give one standard deviation of a reading, in its unit"
                ));
            }
            let twice = match unit {
                "" => sigmas.any.replace(value).is_some(),
                unit => {
                    let unit = named(unit)?;
                    let twice = sigmas.of_unit.iter().any(|(own, _)| *own == unit);
                    sigmas.of_unit.push((unit, value));
                    twice
                }
            };
            if twice {
                return Err("is given twice for one unit; write e.g. \"0.3 deg, 0.05 mm\"".to_string());
            }
            rest = behind;
        }
        match sigmas == Sigmas::default() {
            true => Err("is no number; write e.g. 0.4, 0,4 or \"0.3 deg, 0.05 mm\"".to_string()),
            false => Ok(sigmas),
        }
    }
}

impl fmt::Display for Sigmas {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let any = self.any.map(|sigma| sigma.to_string());
        let of_unit = self.of_unit.iter().map(|(unit, sigma)| format!("{sigma} {unit}"));
        let parts: Vec<String> = any.into_iter().chain(of_unit).collect();
        f.write_str(&parts.join(", "))
    }
}

/// The first number of a text, its unit, and what stands behind both.
fn first(text: &str) -> (&str, &str, &str) {
    let is_of_number = |c: char| c.is_ascii_digit() || ".,+-eE".contains(c);
    let end = text.find(|c: char| !is_of_number(c)).unwrap_or(text.len());
    let number = text[..end].trim_end_matches(',');
    let behind = &text[number.len()..];
    let unit = behind.trim_start();
    let end = unit.find(|c: char| ",; ".contains(c)).unwrap_or(unit.len());
    let end = if behind.starts_with([',', ';']) { 0 } else { end };
    let next = unit[end..].trim_start_matches([',', ';', ' ']);
    // "0.3 0.05" are two numbers without a unit
    match unit[..end].starts_with(|c: char| c.is_ascii_digit()) {
        true => (number, "", unit),
        false => (number, &unit[..end], next),
    }
}

fn named(unit: &str) -> Result<&'static str, String> {
    let own = UNITS
        .iter()
        .find(|(name, others)| *name == unit || others.contains(&unit));
    own.map(|(name, _)| *name).ok_or_else(|| {
        let names: Vec<&str> = UNITS.iter().map(|(name, _)| *name).collect();
        format!("{unit} is no unit of a reading: {}", names.join(", "))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_number_is_of_all_channels_and_one_with_a_unit_of_its_own() {
        let all: Sigmas = "0,4".parse().expect("a number");
        assert_eq!(
            (all.of(Channel::Twist), all.of(Channel::Deflection)),
            (Some(0.4), Some(0.4))
        );
        for text in [
            "0.3 deg, 0.05 mm",
            "0,3°; 0,05mm",
            "0.05 mm 0.3 degrees",
            "0.3deg,0.05mm",
        ] {
            let two: Sigmas = text.parse().unwrap_or_else(|error| panic!("{text}: {error}"));
            let found = [Channel::Twist, Channel::Deflection, Channel::Lift].map(|channel| two.of(channel));
            assert_eq!(found, [Some(0.3), Some(0.05), None], "{text}");
            assert_eq!(two.to_string().parse(), Ok(two), "{text}");
        }
        let both: Sigmas = "1e-1, 0.05 mm".parse().expect("two");
        assert_eq!(
            (both.of(Channel::Twist), both.of(Channel::Deflection)),
            (Some(0.1), Some(0.05))
        );
    }

    #[test]
    fn what_is_no_standard_deviation_is_refused() {
        for text in [
            "",
            "much",
            "0",
            "-1",
            "nan",
            "inf",
            "1e10",
            "0.3 rad",
            "0.3 0.05",
            "0.3 deg 0.4 deg",
            "mm",
            "0.3 deg,",
        ] {
            let parsed = text.parse::<Sigmas>();
            assert_eq!(parsed.is_ok(), text == "0.3 deg,", "{text}: {parsed:?}");
        }
    }
}
