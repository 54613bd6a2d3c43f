//! What one case of a sweep gives.

use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::error::SweepError;
use crate::compare::study::compare_study;
use crate::coupling::solution::Solution;
use crate::input::study::LoadedStudy;
use crate::input::{Design, Loaded};
use crate::observation::Place;
use crate::progress::{Cancelled, Progress};
use crate::study::{Campaign, StudyError};
use crate::wing::{WingError, WingModel};

/// One number that a case gives.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Figure {
    /// Its name, with unit.
    pub name: String,
    /// Its value.
    pub value: f64,
}

/// One case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Row {
    /// Its number, from 0.
    pub case: usize,
    /// Values of the axes.
    pub values: Vec<String>,
    /// What it gives; nothing where it failed.
    pub figures: Vec<Figure>,
    /// Why it gives nothing.
    pub failure: Option<String>,
    /// Whether it gives nothing because its input is at fault.
    pub is_refused: bool,
}

impl Row {
    /// A figure by its name.
    pub fn figure(&self, name: &str) -> Option<f64> {
        let own = self.figures.iter().find(|figure| figure.name == name)?;
        Some(own.value)
    }
}

/// What is varied, as it stands.
#[derive(Debug)]
pub enum Base {
    /// A design, with its loaded shape, from which all others are solved; none if it has no equilibrium itself.
    Design(Box<Loaded>, Option<Box<Solution>>),
    /// A study.
    Study(Box<LoadedStudy>),
}

impl Base {
    /// Reads a design, or a study, with changes for all cases.
    ///
    /// # Errors
    /// If it is refused.
    pub fn load(path: &Path, sets: &[String]) -> Result<Base, SweepError> {
        if LoadedStudy::is_study(path)? {
            let study = LoadedStudy::load(path, sets)?;
            return Ok(Base::Study(Box::new(study)));
        }
        let loaded = Design::load(path, sets)?;
        Ok(Base::Design(Box::new(loaded), None))
    }

    /// Solves the base itself, so that its cases are found sooner; one that has no equilibrium is left as it is.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn prepare(&mut self, progress: &Progress) -> Result<(), SweepError> {
        if let Base::Design(loaded, solution) = self {
            progress.say("the base as it stands");
            let found = WingModel::new((**loaded).clone()).and_then(|wing| wing.solve(progress));
            progress.check()?;
            *solution = found.ok().map(|solved| Box::new(solved.solution));
        }
        Ok(())
    }

    /// The case with the changes `sets` (which hold those for all cases).
    ///
    /// # Errors
    /// If the user asked to stop; whatever else goes wrong is told in the row.
    pub fn row(
        &self,
        path: &Path,
        (case, values, sets): (usize, &[String], &[String]),
        progress: &Progress,
    ) -> Result<Row, Cancelled> {
        let found = match self {
            Base::Design(_, near) => of_design(path, sets, near.as_deref(), progress),
            Base::Study(_) => of_study(path, sets, progress),
        };
        progress.check()?;
        let found = found.and_then(finite);
        let (figures, failure, is_refused) = match found {
            Ok(figures) => (figures, None, false),
            Err(Nothing::Refused(reason)) => (Vec::new(), Some(reason), true),
            Err(Nothing::Unsolved(reason)) => (Vec::new(), Some(reason), false),
        };
        Ok(Row {
            case,
            values: values.to_vec(),
            figures,
            failure,
            is_refused,
        })
    }
}

/// Why a case gives nothing.
enum Nothing {
    /// Its input is at fault.
    Refused(String),
    /// It has no solution that could be found.
    Unsolved(String),
}

impl Nothing {
    fn of_input(error: impl ToString) -> Nothing {
        Nothing::Refused(error.to_string())
    }
}

fn finite(figures: Vec<Figure>) -> Result<Vec<Figure>, Nothing> {
    match figures.iter().find(|figure| !figure.value.is_finite()) {
        Some(figure) => Err(Nothing::Unsolved(format!(
            "{} is not a finite number",
            figure.name
        ))),
        None => Ok(figures),
    }
}

impl From<WingError> for Nothing {
    fn from(error: WingError) -> Nothing {
        match error.is_not_converged() {
            true => Nothing::Unsolved(error.to_string()),
            false => Nothing::Refused(error.to_string()),
        }
    }
}

fn of_design(
    path: &Path,
    sets: &[String],
    near: Option<&Solution>,
    progress: &Progress,
) -> Result<Vec<Figure>, Nothing> {
    let wing = WingModel::new(Design::load(path, sets).map_err(Nothing::of_input)?)?;
    let solved = match near {
        Some(near) => wing.solve_from(near, &progress.unseen()),
        None => wing.solve(&progress.unseen()),
    }?;
    let mut figures = Vec::new();
    let mut add = |name: &str, value: f64| {
        figures.push(Figure {
            name: name.to_string(),
            value,
        });
    };
    let profile = solved.profile()?;
    let tip = profile
        .readings
        .iter()
        .find(|reading| reading.place == Place::Tip);
    if let Some(tip) = tip {
        add("tip_twist_deg", tip.twist_rad.to_degrees());
        add(
            "mean_twist_rate_deg_per_mm",
            tip.twist_rad.to_degrees() / (tip.r_m * 1e3),
        );
        add("tip_deflection_mm", tip.le_deflection_m * 1e3);
        if let Some(alpha) = tip.alpha_rad {
            add("tip_alpha_deg", alpha.to_degrees());
        }
    }
    if let Some(report) = solved.lift()? {
        let forces = report.stroke_mean.as_ref().unwrap_or(&report.solved);
        add("lift_mn", forces.lift_mn);
        add("drag_mn", forces.drag_mn);
        add("power_mw", forces.power_mw);
        if let Some(ratio) = forces.lift_to_drag {
            add("lift_to_drag", ratio);
        }
        if let Some(ratio) = forces.lift_per_power_n_per_w {
            add("lift_per_power_n_per_w", ratio);
        }
    }
    let report = &solved.solution.report;
    add("root_pitch_moment_mn_mm", report.reaction_moment_n_m[0] * 1e6);
    add("newton_steps", report.newton_steps as f64);
    Ok(figures)
}

fn of_study(path: &Path, sets: &[String], progress: &Progress) -> Result<Vec<Figure>, Nothing> {
    let text = |error: StudyError| match error.exit_code() {
        2 => Nothing::of_input(error),
        _ => Nothing::Unsolved(error.to_string()),
    };
    let mut study = LoadedStudy::load(path, sets).map_err(Nothing::of_input)?;
    // what is set is held, and not calibrated away
    let is_set = |key: &str| {
        sets.iter()
            .any(|set| set.split('=').next().map(str::trim) == Some(key))
    };
    study.study.uncertain.retain(|uncertain| !is_set(&uncertain.key));
    let campaign = Campaign::new(&study, &[], &progress.unseen()).map_err(text)?;
    let found = compare_study(&campaign, &study.study.title).map_err(text)?;
    let mut figures = Vec::new();
    let mut add = |name: String, value: f64| figures.push(Figure { name, value });
    for (when, value) in ["stated", "calibrated"].iter().zip(found.chi_square_per_row) {
        add(format!("chi_square_per_number_{when}"), value);
    }
    for group in &found.groups {
        let part = if group.is_held_out { "held_out" } else { "fitted" };
        let unit = group.unit.replace('/', "_per_");
        for (when, value) in ["stated", "calibrated"].iter().zip(group.rmse) {
            add(
                format!(
                    "rmse_{}_{}_{part}_{when}_{unit}",
                    group.wing,
                    group.channel.name()
                ),
                value,
            );
        }
    }
    Ok(figures)
}
