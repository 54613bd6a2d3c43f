//! What a measurement file says of itself if a program made it: how, so that nobody takes it for nature's word.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::error::{InputError, Place, Problem};

const BEGIN: &str = "made by washout synthesize";
const HEAD: &str = "made by washout synthesize:";

/// How measurements were made.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Made {
    /// Factor on the refinement of the meshes of the study.
    pub mesh: f64,
    /// Which formulas the hidden effects had.
    pub formulas: Formulas,
    /// Relative error of outline, stiffness and air law, one standard deviation.
    pub background: f64,
    /// Seed of all that was drawn.
    pub seed: u64,
}

/// Which formulas hidden effects have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Formulas {
    /// Another formula of the same physics, where there is one.
    Other,
    /// Those of the program's own effects.
    Same,
}

impl Formulas {
    /// Its word.
    pub fn word(self) -> &'static str {
        match self {
            Formulas::Other => "other",
            Formulas::Same => "same",
        }
    }
}

/// What a diagnosis and the making of its data have in common.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InCommon {
    /// In words, with the value in the header.
    pub what: String,
    /// How `washout synthesize` makes them without it.
    pub without: String,
}

impl Made {
    /// Reads the comment line that [`Made`] displays as; none if the line does not begin as one.
    ///
    /// # Errors
    /// What is wrong with a line that begins as one.
    pub fn parse(comment: &str) -> Result<Option<Made>, String> {
        let line = comment.split_whitespace().collect::<Vec<_>>().join(" ");
        if !line.to_lowercase().starts_with(BEGIN) {
            return Ok(None);
        }
        let Some(words) = line.strip_prefix(HEAD) else {
            return Err(format!("does not go on as '{HEAD} mesh …'"));
        };
        let value = |key: &str| {
            let parts = words.split(',').map(str::trim);
            let named = parts.filter_map(|part| part.split_once(' ').or(Some((part, ""))));
            let mut values = named
                .filter(|(name, _)| *name == key)
                .map(|(_, value)| value.trim());
            match (values.next(), values.next()) {
                (None, _) => Err(format!("has no {key}")),
                (Some(_), Some(_)) => Err(format!("has {key} twice")),
                (Some(value), None) => Ok(value),
            }
        };
        let number = |key: &str, low: f64, range: &str| {
            let text = value(key)?;
            let found = text
                .parse()
                .ok()
                .filter(|found: &f64| found.is_finite() && *found >= low);
            found.ok_or_else(|| format!("has {key} '{text}', which is no number {range}"))
        };
        Ok(Some(Made {
            mesh: number("mesh", f64::MIN_POSITIVE, "larger than 0")?,
            formulas: match value("formulas")? {
                "other" => Formulas::Other,
                "same" => Formulas::Same,
                word => return Err(format!("has formulas '{word}', which is neither other nor same")),
            },
            background: number("background", 0.0, "from 0 on")?,
            seed: {
                let text = value("seed")?;
                let found = text.parse().ok();
                found.ok_or_else(|| format!("has seed '{text}', which is no whole number from 0 on"))?
            },
        }))
    }

    /// How the file of this text was made; none if no comment line says so.
    pub(in crate::input) fn of_file(text: &str, file: &str) -> Result<Option<Made>, InputError> {
        let mut found: Option<(usize, Made)> = None;
        for (index, line) in text.lines().enumerate() {
            let Some(comment) = line.trim_start().strip_prefix('#') else {
                continue;
            };
            let refuse = |message: String| {
                let place = Place {
                    file: file.to_string(),
                    line: Some(index + 1),
                    column: None,
                };
                let message = format!("the comment '{BEGIN}' {message}");
                let example = Made {
                    mesh: 1.25,
                    formulas: Formulas::Other,
                    background: 0.01,
                    seed: 2,
                };
                let cure = format!(
                    "Restore the line as washout wrote it, e.g. # {example}; if an instrument gave these numbers, let the \
                     comment begin otherwise"
                );
                InputError::new(place, "", "", Problem::File { message }, cure)
            };
            let Some(made) = Made::parse(comment).map_err(refuse)? else {
                continue;
            };
            match found {
                Some((first, before)) if before != made => {
                    return Err(refuse(format!("says otherwise than the one on line {first}")));
                }
                Some(_) => {}
                None => found = Some((index + 1, made)),
            }
        }
        Ok(found.map(|(_, made)| made))
    }

    /// All that a diagnosis with this seed has in common with how they were made, so that it would only be asked what it told
    /// itself; nothing where it can be asked.
    pub fn in_common(&self, seed: u64) -> Vec<InCommon> {
        let same_formulas = self.formulas == Formulas::Same;
        let all = [
            (
                self.mesh == 1.0,
                "the same meshes (mesh 1)".to_string(),
                "--mesh 1.25".to_string(),
            ),
            (
                same_formulas,
                "the same formulas (formulas same)".to_string(),
                "no --same-formulas".to_string(),
            ),
            (
                self.background == 0.0,
                "the same outline, stiffness and air law (background 0)".to_string(),
                "--background 0.01".to_string(),
            ),
            (
                self.seed == seed,
                format!("the same seed (seed {seed})"),
                format!("--seed {}", seed.wrapping_add(1)),
            ),
        ];
        all.into_iter()
            .filter(|(holds, _, _)| *holds)
            .map(|(_, what, without)| InCommon { what, without })
            .collect()
    }
}

impl fmt::Display for Made {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Made {
            mesh,
            formulas,
            background,
            seed,
        } = self;
        let word = formulas.word();
        write!(
            f,
            "{HEAD} mesh {mesh}, formulas {word}, background {background}, seed {seed}"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_and_own_words_are_told() {
        let made = Made {
            mesh: 1.25,
            formulas: Formulas::Other,
            background: 0.01,
            seed: 7,
        };
        assert_eq!(Made::parse(&made.to_string()), Ok(Some(made)));
        assert_eq!(Made::parse("made by hand: mesh 1"), Ok(None));
        assert_eq!(made.in_common(1), []);
        assert_eq!(made.in_common(7).len(), 1);
        for own in [
            Made { mesh: 1.0, ..made },
            Made {
                formulas: Formulas::Same,
                ..made
            },
            Made {
                background: 0.0,
                ..made
            },
        ] {
            assert_eq!(own.in_common(1).len(), 1, "{own}");
            assert_eq!(own.in_common(7).len(), 2, "{own}");
        }
    }

    #[test]
    fn a_line_that_begins_as_one_and_is_none_is_no_word_of_nature() {
        let good = "made by washout synthesize: mesh 1.25, formulas other, background 0.01, seed 7";
        for (from, to, wrong) in [
            (":", "", "does not go on as"),
            ("made", "Made", "does not go on as"),
            ("mesh 1.25, ", "", "has no mesh"),
            (
                "mesh 1.25",
                "mesh",
                "has mesh '', which is no number larger than 0",
            ),
            (
                "mesh 1.25",
                "mesh fine",
                "has mesh 'fine', which is no number larger than 0",
            ),
            (
                "mesh 1.25",
                "mesh 0",
                "has mesh '0', which is no number larger than 0",
            ),
            (
                "other",
                "some",
                "has formulas 'some', which is neither other nor same",
            ),
            (
                "0.01",
                "NaN",
                "has background 'NaN', which is no number from 0 on",
            ),
            (
                "seed 7",
                "seed -7",
                "has seed '-7', which is no whole number from 0 on",
            ),
            ("seed 7", "seed 7, seed 8", "has seed twice"),
        ] {
            let said = Made::parse(&good.replace(from, to)).unwrap_err();
            assert!(said.starts_with(wrong), "{to}: {said}");
        }
        assert!(Made::parse(good).unwrap().is_some());
    }

    #[test]
    fn two_lines_that_disagree_are_refused_wherever_they_stand() {
        let line = |seed: u64| {
            format!("# made by washout synthesize: mesh 1, formulas same, background 0, seed {seed}\n")
        };
        let same = Made::of_file(&(line(1) + "a,b\n" + &line(1)), "m.csv").unwrap();
        assert_eq!(same.map(|made| made.seed), Some(1));
        let below = Made::of_file(&("a,b\n".to_string() + &line(3)), "m.csv").unwrap();
        assert_eq!(below.map(|made| made.seed), Some(3));
        let error = Made::of_file(&(line(1) + "a,b\n" + &line(2)), "m.csv").unwrap_err();
        assert!(
            error
                .to_string()
                .starts_with("m.csv:3: the comment 'made by washout synthesize' says otherwise"),
            "{error}"
        );
    }
}
