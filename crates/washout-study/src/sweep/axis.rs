//! One key and the values that it takes.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::error::SweepError;

/// Most values of one axis.
const MOST: usize = 100_000;

/// A dotted key with its values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Axis {
    /// The key, as `--set` takes it.
    pub key: String,
    /// Its values.
    pub values: Values,
}

/// Values of a key.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Values {
    /// One after the other, each as `--set` takes it.
    List(Vec<String>),
    /// Any number between two.
    Range([f64; 2]),
}

impl Axis {
    /// Reads `KEY=LOW..HIGH:COUNT` (evenly spaced), `KEY=A,B,C` (numbers, words or lists in brackets) or `KEY=LOW..HIGH`.
    ///
    /// # Errors
    /// If it is none of these.
    ///
    /// # Example
    /// ```
    /// # use washout_study as washout;
    /// use washout::sweep::{Axis, Values};
    ///
    /// let axis = Axis::parse("flapping.frequency_hz=20..24:3")?;
    /// assert_eq!(axis.values, Values::List(vec!["20.0".into(), "22.0".into(), "24.0".into()]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn parse(text: &str) -> Result<Axis, SweepError> {
        let fault = |problem: String| SweepError::Axis {
            text: text.to_string(),
            problem,
        };
        let Some((key, values)) = text.split_once('=') else {
            return Err(fault("has no '='".to_string()));
        };
        let (key, values) = (key.trim(), values.trim());
        if key.is_empty() || values.is_empty() {
            return Err(fault("has no key or no values".to_string()));
        }
        let Some((low, rest)) = values.split_once("..") else {
            let list = split(values);
            if list.iter().any(String::is_empty) {
                return Err(fault("has an empty value between commas".to_string()));
            }
            return Ok(Axis {
                key: key.to_string(),
                values: Values::List(list),
            });
        };
        let number = |text: &str| -> Result<f64, SweepError> {
            let value: f64 =
                (text.trim().parse()).map_err(|_| fault(format!("'{}' is no number", text.trim())))?;
            match value.is_finite() {
                true => Ok(value),
                false => Err(fault(format!("'{}' is not finite", text.trim()))),
            }
        };
        let (high, count) = match rest.split_once(':') {
            Some((high, count)) => (high, Some(count.trim())),
            None => (rest, None),
        };
        let (low, high) = (number(low)?, number(high)?);
        if low >= high {
            return Err(fault(format!("goes from {low} to {high}, which is not up")));
        }
        let values = match count {
            None => Values::Range([low, high]),
            Some(count) => {
                let count: usize = count
                    .parse()
                    .map_err(|_| fault(format!("'{count}' is no number of values")))?;
                if !(2..=MOST).contains(&count) {
                    return Err(fault(format!("takes {count} values; 2 to {MOST} are possible")));
                }
                let last = (count - 1) as f64;
                let value = |index: usize| low + (high - low) * (index as f64 / last);
                Values::List((0..count).map(|index| shown(value(index))).collect())
            }
        };
        Ok(Axis {
            key: key.to_string(),
            values,
        })
    }

    /// The value at a place between 0 and 1.
    pub fn at(&self, place: f64) -> String {
        match &self.values {
            Values::List(values) => {
                let index = (place * values.len() as f64) as usize;
                values[index.min(values.len() - 1)].clone()
            }
            Values::Range([low, high]) => shown(low + (high - low) * place),
        }
    }
}

/// A number as short as it reads back to itself.
fn shown(value: f64) -> String {
    format!("{value:?}")
}

/// The parts between commas that stand in no brackets or quotes.
fn split(text: &str) -> Vec<String> {
    let (mut parts, mut depth, mut quoted) = (vec![String::new()], 0_i32, false);
    for letter in text.chars() {
        match letter {
            '"' => quoted = !quoted,
            '[' | '{' if !quoted => depth += 1,
            ']' | '}' if !quoted => depth -= 1,
            _ => {}
        }
        match letter {
            ',' if depth == 0 && !quoted => parts.push(String::new()),
            _ => {
                if let Some(part) = parts.last_mut() {
                    part.push(letter);
                }
            }
        }
    }
    parts.iter().map(|part| part.trim().to_string()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(text: &str) -> Vec<String> {
        match Axis::parse(text).unwrap().values {
            Values::List(values) => values,
            Values::Range(_) => Vec::new(),
        }
    }

    #[test]
    fn grids_lists_and_ranges_are_read_as_they_are_written() {
        assert_eq!(
            list("flapping.frequency_hz=18..26:5"),
            ["18.0", "20.0", "22.0", "24.0", "26.0"]
        );
        assert_eq!(list("film.law = tension-field , full"), ["tension-field", "full"]);
        assert_eq!(list("load[0].moment_n_m=[1,0,0],[2,0,0]"), ["[1,0,0]", "[2,0,0]"]);
        let range = Axis::parse("a.b=-1e-3..2").unwrap();
        assert_eq!(range.values, Values::Range([-1e-3, 2.0]));
        assert!((range.at(0.5).parse::<f64>().unwrap() - 0.9995).abs() < 1e-15);
    }

    #[test]
    fn what_is_no_axis_is_refused_with_the_cure() {
        for (text, problem) in [
            ("a.b", "has no '='"),
            ("a.b=", "no values"),
            ("a.b=1,,2", "empty value"),
            ("a.b=3..2", "not up"),
            ("a.b=1..x", "'x' is no number"),
            ("a.b=1..2:1", "takes 1 values"),
            ("a.b=1..inf", "not finite"),
        ] {
            let error = Axis::parse(text).unwrap_err().to_string();
            assert!(
                error.contains(problem) && error.contains("LOW..HIGH:COUNT"),
                "{error}"
            );
        }
    }

    #[test]
    fn every_value_of_a_list_has_an_equal_share_of_the_places() {
        let axis = Axis::parse("k=a,b,c").unwrap();
        let taken: Vec<String> = (0..9).map(|i| axis.at((f64::from(i) + 0.5) / 9.0)).collect();
        assert_eq!(taken.join(""), "aaabbbccc");
    }
}
