//! Diagnoses of cases whose hidden cause is known, many of them: the figures by which a diagnosis is measured.
//!
//! A development benchmark: its cases are made by the program itself ([`crate::synthesize`]), with other meshes, formulas and
//! background errors than the diagnosis has, but by the same hands. Each case is a function of study, kind and seed alone,
//! so a run can stop and go on, and parts of it can be done elsewhere.

pub mod baselines;

pub mod distance;

pub mod draw;

pub mod error;

pub mod followed;

pub mod kind;

pub mod novel;

pub mod outcome;

pub mod scoreboard;

pub mod setup;

pub mod spot;

pub mod truth;

pub mod twin;

pub use error::BlindError;
pub use kind::Kind;
pub use outcome::{Failed, Outcome};
pub use scoreboard::{Scoreboard, scoreboard};
pub use setup::{Blind, Ranges, Turned};

use std::time::Instant;

use crate::diagnose::{self, Experiments, judged};
use crate::input::study::LoadedStudy;
use crate::progress::Progress;
use crate::study::Campaign;
use crate::synthesize::{Recipe, Synthetic, synthesize};

use distance::turned;

/// Draws for a case before it counts as failed.
const DRAWS: u64 = 12;

impl<'a> Blind<'a> {
    /// Judges the campaign, so that strengths can be drawn by how well they can be seen;
    /// `known`: effects that are not hidden, if they are known from an earlier run.
    ///
    /// # Errors
    /// If the study has no solution.
    pub fn new(
        study: &'a LoadedStudy,
        candidates: Vec<&'a str>,
        ranges: Ranges,
        known: Option<Vec<Turned>>,
        progress: &Progress,
    ) -> Result<Blind<'a>, BlindError> {
        let mut blind = Blind::judged(study, candidates, ranges, progress)?;
        blind.turned = match known {
            Some(known) => known,
            None => {
                progress.say("which effects act on another wing as on this one");
                turned(&blind, progress)?
            }
        };
        Ok(blind)
    }

    /// What is hidden in a case, its measurements, and how often it was drawn anew because a wing had no equilibrium with it, or it was
    /// too faint.
    fn drawn(
        &self,
        kind: Kind,
        seed: u64,
        progress: &Progress,
    ) -> Result<(Recipe, Synthetic, u64), BlindError> {
        let mut attempt = 0;
        loop {
            let made = draw::recipe(self, (kind, seed), attempt, progress)
                .and_then(|recipe| Ok((synthesize(self.study, &recipe, progress)?, recipe)));
            match made {
                Err(error) if !error.is_of_run() && attempt + 1 < DRAWS => attempt += 1,
                made => return made.map(|(made, recipe)| (recipe, made, attempt)),
            }
        }
    }

    /// Makes, diagnoses and judges one case.
    ///
    /// # Errors
    /// If no case of the kind can be drawn, or the user asked to stop.
    pub fn case(&self, kind: Kind, seed: u64, progress: &Progress) -> Result<Outcome, BlindError> {
        let (recipe, made, redrawn) = self.drawn(kind, seed, progress)?;
        let started = Instant::now();
        let (campaign, table) = match self.campaign.with_readings_of(&made.study) {
            Some(campaign) => (campaign, Some(&self.table)),
            None => (Campaign::new(&made.study, &self.candidates, progress)?, None),
        };
        let (baseline, judgement) = judged(&campaign, &self.settings, table, progress)?;
        let experiments = self.experiments.as_ref().filter(|_| kind == Kind::Twin);
        let experiments = experiments.map_or(Experiments::Unknown, |listed| Experiments::Listed(listed));
        let said = diagnose::report::report(&baseline, &judgement, experiments, progress)?;
        let simpler = baselines::answers(&baseline, &judgement);
        let seconds = started.elapsed().as_secs_f64();
        let followed = followed::follow(self, kind, &made.answer, &said, progress)?;
        Ok(outcome::judge(
            (kind, seed),
            (&made.answer, &distance::distances(self, &recipe.hidden)?),
            &said,
            (simpler, followed),
            (seconds, redrawn),
        ))
    }
}
