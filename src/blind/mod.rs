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

pub mod novel;

pub mod outcome;

pub mod scoreboard;

pub mod spot;

pub mod twin;

pub use distance::Turned;
pub use error::BlindError;
pub use outcome::{Failed, Outcome};
pub use scoreboard::{Scoreboard, scoreboard};

use std::time::Instant;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::diagnose::plan::{Outlook, PlannedEffect};
use crate::diagnose::table::Table;
use crate::diagnose::{self, Experiments, Settings, judged};
use crate::input::study::LoadedStudy;
use crate::progress::Progress;
use crate::study::Campaign;
use crate::synthesize::{Recipe, Synthetic, synthesize};

use distance::turned;

/// Draws for a case before it counts as failed.
const DRAWS: u64 = 12;

/// Kinds of cases.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Nothing is missing.
    Null,
    /// Nothing is missing, and sigma is stated 30 % too small.
    NullQuiet,
    /// Nothing is missing, and one number is 8 sigma off.
    NullOutlier,
    /// One effect.
    Single,
    /// Two effects of different families.
    Pair,
    /// Something that no effect is.
    Novel,
    /// One effect that this campaign cannot tell from another.
    Twin,
}

/// Kinds in the order in which they come around: 29 cases hold 15 without anything missing, 6 single ones, 3 pairs, 3 novel
/// ones and 2 twins.
const ROUND: [Kind; 29] = {
    use Kind::{Novel, Null, NullOutlier, NullQuiet, Pair, Single, Twin};
    [
        Single,
        Null,
        Novel,
        NullQuiet,
        Pair,
        Null,
        Single,
        NullOutlier,
        Twin,
        Null,
        Single,
        Null,
        NullQuiet,
        Pair,
        Null,
        NullOutlier,
        Single,
        Novel,
        Null,
        NullQuiet,
        Single,
        NullOutlier,
        Null,
        Pair,
        NullQuiet,
        Twin,
        Single,
        NullOutlier,
        Novel,
    ]
};

impl Kind {
    /// All kinds.
    pub const ALL: [Kind; 7] = [
        Kind::Null,
        Kind::NullQuiet,
        Kind::NullOutlier,
        Kind::Single,
        Kind::Pair,
        Kind::Novel,
        Kind::Twin,
    ];

    /// Its word.
    pub fn word(self) -> &'static str {
        match self {
            Kind::Null => "null",
            Kind::NullQuiet => "null-quiet",
            Kind::NullOutlier => "null-outlier",
            Kind::Single => "single",
            Kind::Pair => "pair",
            Kind::Novel => "novel",
            Kind::Twin => "twin",
        }
    }

    /// Whether nothing is missing.
    pub fn is_null(self) -> bool {
        matches!(self, Kind::Null | Kind::NullQuiet | Kind::NullOutlier)
    }

    /// The kind of the case at a place of the run.
    pub fn at(index: usize) -> Kind {
        ROUND[index % ROUND.len()]
    }
}

/// Ranges from which cases are drawn, evenly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ranges {
    /// Detectability of what is hidden, sigma.
    pub detectable: [f64; 2],
    /// Standard deviation of the errors of chord, stiffness and air law that nobody states, as a share.
    pub background: [f64; 2],
}

/// What all cases share.
pub struct Blind<'a> {
    /// The study whose campaign is tried.
    pub study: &'a LoadedStudy,
    /// Effects that the diagnosis may try.
    pub candidates: Vec<&'a str>,
    /// Its model.
    pub campaign: Campaign,
    /// What the campaign could see.
    pub outlook: Outlook,
    /// Settings of every diagnosis.
    pub settings: Settings,
    /// How its campaign answers, which all cases share.
    pub table: Table,
    /// What could be measured besides, if the study lists anything.
    pub experiments: Option<Campaign>,
    /// Ranges from which cases are drawn.
    pub ranges: Ranges,
    /// Effects that would be seen but are not hidden: a small error of the wing turns their signature.
    pub turned: Vec<Turned>,
}

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
        let campaign = Campaign::new(study, &candidates, progress)?;
        let settings = Settings {
            discrepancy: campaign.discrepancy,
            start: Some(campaign.start()),
            ..Settings::default()
        };
        let table = Table::new(&campaign, &settings, progress)?;
        let outlook = Outlook::new(&campaign, Some(&table), &settings, progress)?;
        let experiments = Campaign::of_experiments(study, &candidates, progress)?;
        let mut blind = Blind {
            study,
            experiments,
            candidates,
            campaign,
            outlook,
            settings,
            table,
            ranges,
            turned: Vec::new(),
        };
        blind.turned = match known {
            Some(known) => known,
            None => {
                progress.say("which effects act on another wing as on this one");
                turned(&blind, progress)?
            }
        };
        Ok(blind)
    }

    /// Whether the plausible size of an effect reaches the range from which strengths are drawn.
    fn sees(&self, effect: &PlannedEffect) -> bool {
        effect.detectability >= self.ranges.detectable[0]
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
