//! What all cases of a run share.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::diagnose::Settings;
use crate::diagnose::plan::{Outlook, PlannedEffect};
use crate::diagnose::table::Table;
use crate::input::study::LoadedStudy;
use crate::progress::Progress;
use crate::study::Campaign;

use super::error::BlindError;

/// Ranges from which cases are drawn, evenly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ranges {
    /// Detectability of what is hidden, sigma.
    pub detectable: [f64; 2],
    /// Standard deviation of the errors of chord, stiffness and air law that nobody states, as a share.
    pub background: [f64; 2],
}

/// An effect whose signature is another on a wing that differs by a percent.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Turned {
    /// The effect.
    pub effect: String,
    /// Cosine between the two signatures; none if the other wing has no equilibrium with it.
    pub cosine: Option<f64>,
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
    /// Judges the campaign, so that strengths can be drawn by how well they can be seen; no effect counts as turned yet.
    ///
    /// # Errors
    /// If the study has no solution.
    pub fn judged(
        study: &'a LoadedStudy,
        candidates: Vec<&'a str>,
        ranges: Ranges,
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
        Ok(Blind {
            study,
            experiments,
            candidates,
            campaign,
            outlook,
            settings,
            table,
            ranges,
            turned: Vec::new(),
        })
    }

    /// Whether the plausible size of an effect reaches the range from which strengths are drawn.
    pub(super) fn sees(&self, effect: &PlannedEffect) -> bool {
        effect.detectability >= self.ranges.detectable[0]
    }
}
