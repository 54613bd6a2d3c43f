//! `washout init`: a commented design file, or a study with its design and readings, to start from.

use std::path::PathBuf;

use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;

use crate::export::drawn::Drawn;
use crate::export::file::{refuse_any, write_new};
use crate::export::sheet::{files, understood_briefly};
use crate::input::design::INIT;
use crate::input::sheet::{DesignReadings, Sigmas};

use super::{Console, Failure};

const STEADY: &str = include_str!("init_steady.toml");
const STUDY: &str = include_str!("init_study.toml");
const READINGS: &str = include_str!("init_measured.csv");

/// What the design of a study has besides.
const COARSE: &str = "
# Coarse, so that the study runs in seconds; the usual is 12.
[mesh]
chordwise = 6
";

/// Arguments of `washout init`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  # writes my-wing.toml here
  washout init my-wing
  # a wing in a stream, as in a wind tunnel
  washout init my-glider --steady
  # writes designs/my-wing.toml
  washout init my-wing --output designs
  # solves it
  washout solve my-wing.toml
  # writes my-study.toml, my-study-wing.toml and my-study-measured.csv
  washout init my-study --study
  # compares them
  washout compare my-study.toml
  # a design with the outline of a drawing, DXF or SVG
  washout init my-wing --outline wing.dxf
  # a study of your own wing and table, long or wide, .csv or .xlsx
  washout init my-study --study --design my-wing.toml --readings sheet.csv")]
pub struct Init {
    /// Name of the wing or study: letters, digits, '-' and '_'
    pub name: String,
    /// A wing in a steady stream, as in a wind tunnel, instead of one that flaps
    #[arg(long, conflicts_with_all = ["outline", "study"])]
    pub steady: bool,
    /// Take the outline from a drawing, DXF or SVG: its largest closed line, the leading edge level on top, the base at the left
    #[arg(long, value_name = "DRAWING", conflicts_with = "study")]
    pub outline: Option<PathBuf>,
    /// The base is at the right of the drawing
    #[arg(long, requires = "outline")]
    pub base_at_right: bool,
    /// Write a study, with its design and made-up readings, instead of a design
    #[arg(long)]
    pub study: bool,
    /// The design of the study, instead of one to start from
    #[arg(long, value_name = "DESIGN", requires_all = ["study", "readings"])]
    pub design: Option<PathBuf>,
    /// A table of readings that were measured on the design: .csv, .tsv, .xlsx or .ods
    #[arg(long, value_name = "TABLE", requires_all = ["study", "design"])]
    pub readings: Option<PathBuf>,
    /// Standard deviation of readings of the table that state none, e.g. 0.3, or "0.3 deg, 0.05 mm" [default: 0.5 deg, 0.5 mm]
    #[arg(
        long,
        value_name = "SIGMA",
        requires = "readings",
        allow_negative_numbers = true
    )]
    pub sigma: Option<Sigmas>,
    /// A condition of the table that no fit sees, so that it tests what is found, e.g. 22hz; can be given many times
    #[arg(long, value_name = "CONDITION", requires = "readings")]
    pub hold_out: Vec<String>,
    /// Folder to write into [default: this one]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

/// What `washout init` wrote.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct InitReport {
    /// The design file, or the study.
    pub file: String,
    /// The design and the readings of the study.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub beside: Vec<String>,
}

impl Init {
    /// Writes the files, all or none; existing ones are never touched.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let folder = self.output.clone().unwrap_or_default();
        let name = checked(&self.name)?;
        let table = match (&self.readings, &self.design) {
            (Some(readings), Some(design)) => Some(
                DesignReadings::load(readings, design, &self.sigma.clone().unwrap_or_default())?
                    .holding_out(&self.hold_out)?,
            ),
            _ => None,
        };
        let drawn = self
            .outline
            .as_ref()
            .map(|drawing| Drawn::load(drawing, self.base_at_right));
        let drawn = drawn.transpose()?;
        let text = match &drawn {
            Some(drawn) => drawn.design(&design(name)),
            None if self.steady => STEADY.replace("NAME", name),
            None => design(name),
        };
        let files = match &table {
            Some(table) => {
                let made = files(table, name, &folder)?;
                vec![
                    (format!("{name}.toml"), made.study),
                    (format!("{name}-measured.csv"), made.readings),
                ]
            }
            None if self.study => study(name),
            None => vec![(format!("{name}.toml"), text)],
        };
        let files = files
            .into_iter()
            .map(|(file, text)| (folder.join(file), text))
            .collect::<Vec<_>>();
        for (path, _) in &files {
            refuse_any(path)?;
        }
        for (path, text) in &files {
            write_new(path, text.as_bytes())?;
        }
        let mut names = files.iter().map(|(path, _)| path.display().to_string());
        let file = names.next().unwrap_or_default();
        let beside: Vec<String> = names.collect();
        let page = if let Some(table) = &table {
            let with = beside.join(" and ");
            let understood = understood_briefly(&table.sheet);
            format!("{understood}\n{file} written, with {with}; diagnose it with: washout diagnose {file}\n")
        } else if self.study {
            let with = beside.join(" and ");
            format!("{file} written, with {with}; compare them with: washout compare {file}\n")
        } else {
            let understood = drawn.as_ref().map_or(String::new(), Drawn::understood);
            format!("{understood}{file} written; solve it with: washout solve {file}\n")
        };
        console.result(&page, &InitReport { file, beside })
    }
}

/// The text of a design with this name.
fn design(name: &str) -> String {
    INIT.replace("NAME", name)
}

/// The files of a study with this name: the study, its design, its readings.
fn study(name: &str) -> Vec<(String, String)> {
    let wing = format!("{name}-wing");
    vec![
        (format!("{name}.toml"), STUDY.replace("NAME", name)),
        (format!("{wing}.toml"), design(&wing) + COARSE),
        (format!("{name}-measured.csv"), READINGS.replace("NAME", name)),
    ]
}

fn checked(name: &str) -> Result<&str, Failure> {
    let allowed = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if name.starts_with(|c: char| c.is_ascii_alphanumeric()) && name.chars().all(allowed) {
        Ok(name)
    } else {
        Err(Failure::Name {
            name: name.to_string(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::Design;

    #[test]
    fn the_templates_are_designs_without_faults() {
        let found = Design::from_toml(&design("first-wing"), "first-wing.toml");
        let found = found.unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(found.name, "first-wing");
        assert_eq!(found.assumptions().len(), 2);
        let found = Design::from_toml(&STEADY.replace("NAME", "glider"), "glider.toml");
        let found = found.unwrap_or_else(|error| panic!("{error}"));
        assert!(found.steady.is_some() && found.flapping.is_none());
        assert_eq!((found.name.as_str(), found.assumptions().len()), ("glider", 1));
    }

    #[test]
    fn a_name_with_a_path_or_a_space_is_refused() {
        for name in ["", "../wing", "my wing", "-x", "flügel", "a.toml"] {
            assert!(checked(name).is_err(), "{name:?}");
        }
        assert_eq!(checked("twist-v2_b").expect("a name"), "twist-v2_b");
    }
}
