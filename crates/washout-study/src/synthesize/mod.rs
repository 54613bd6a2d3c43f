//! Measurements with a hidden effect, made by the program itself: to try a campaign and its diagnosis before trusting it.
//!
//! So that a diagnosis is not asked what it told itself, the wing that is "measured" differs from the one that is modelled:
//! other meshes, uncertain inputs drawn from their priors, errors of outline, stiffness and air law that nobody states, and
//! another formula of the hidden physics where there is one.

pub mod background;

pub mod error;

pub mod hidden;

pub mod hide;

pub mod rival;

pub use background::Background;
pub use error::SynthesizeError;
pub use hidden::Hidden;
pub use hide::Acted;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::{Formulas, Made};
use crate::input::study::LoadedStudy;
use crate::progress::Progress;
use crate::study::draws::Draws;
use crate::study::{Campaign, Forward, Observable, UnknownKind};

/// Streams of the draws.
const UNKNOWNS: u64 = 1;
const BACKGROUND: u64 = 2;
const NOISE: u64 = 3;
const OUTLIER: u64 = 4;
/// Draws of an unknown before its mean is taken, and how far apart they lie in their stream.
const TRIES: u64 = 100;
const AGAIN: u64 = 1 << 32;

/// What to make.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Recipe {
    /// What is hidden; nothing where empty.
    pub hidden: Vec<Hidden>,
    /// How the wing that is measured is made.
    pub made: Made,
    /// Scatter of the readings over their stated sigma.
    pub noise: f64,
    /// By how many sigma one reading is off, if one is.
    pub outlier: Option<f64>,
}

/// Measurements that were made.
#[derive(Debug, Clone)]
pub struct Synthetic {
    /// The study, its rows with values.
    pub study: LoadedStudy,
    /// What nobody shall know.
    pub answer: Answer,
}

/// What is hidden in measurements that were made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Answer {
    /// The recipe.
    pub recipe: Recipe,
    /// The hidden effects as they acted.
    pub acted: Vec<Acted>,
    /// Uncertain inputs and nuisances of the ruler as they were drawn.
    pub unknowns: Vec<Drawn>,
    /// Errors of outline, stiffness and air law by wing.
    pub background: Vec<Background>,
    /// Measured rows that the wing could not be asked for; they have no value.
    pub unread: Vec<String>,
}

/// A value that was drawn from its prior.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Drawn {
    /// Name of the unknown.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// The value.
    pub value: f64,
}

/// Makes measurements for the rows of a study (their values do not matter, their sigmas do).
///
/// # Errors
/// If an effect is none or acts on nothing, or the wing with all this has no solution.
pub fn synthesize(
    study: &LoadedStudy,
    recipe: &Recipe,
    progress: &Progress,
) -> Result<Synthetic, SynthesizeError> {
    let draws = Draws::new(recipe.made.seed);
    let mut truth = study.clone();
    truth.experiments.clear();
    let acted = hide::hide(&mut truth, &recipe.hidden, recipe.made.formulas)?;
    let background = make_unlike(&mut truth, &recipe.made)?;
    let campaign = Campaign::new(&truth, &[], &progress.unseen())?;
    let at = drawn_unknowns(&campaign, draws);
    let readings = campaign.predict(&at)?;
    let unknowns = campaign
        .unknowns()
        .iter()
        .zip(&at)
        .map(|(unknown, &value)| Drawn {
            name: unknown.name.clone(),
            unit: unknown.unit.clone(),
            value,
        })
        .collect();
    let mut made = study.clone();
    let unread = write_readings(&mut made, recipe, &campaign, readings.as_slice(), draws);
    Ok(Synthetic {
        study: made,
        answer: Answer {
            recipe: recipe.clone(),
            acted,
            unknowns,
            background,
            unread,
        },
    })
}

/// A value of each unknown of the wing that is measured; effects and places of the study stay as stated.
fn drawn_unknowns(campaign: &Campaign, draws: Draws) -> Vec<f64> {
    campaign
        .unknowns()
        .iter()
        .zip(campaign.start())
        .enumerate()
        .map(|(index, (unknown, start))| match unknown.kind {
            UnknownKind::Effect { .. } | UnknownKind::Place { .. } => start,
            _ => {
                let [low, high] = unknown.range;
                // what its range excludes is drawn again
                let mut tries = (0..TRIES).map(|time| {
                    unknown.mean + unknown.sigma * draws.normal(UNKNOWNS, index as u64 + AGAIN * time)
                });
                tries
                    .find(|drawn| (low..=high).contains(drawn))
                    .unwrap_or(unknown.mean)
            }
        })
        .collect()
}

/// Puts scattered readings into the rows of a study; returns the rows that have none, which are taken out.
fn write_readings(
    study: &mut LoadedStudy,
    recipe: &Recipe,
    campaign: &Campaign,
    readings: &[f64],
    draws: Draws,
) -> Vec<String> {
    let outlier = recipe.outlier.map(|sigmas| {
        let count = readings.len() as f64;
        let which = ((draws.uniform(OUTLIER, 0) * count) as usize).min(readings.len().saturating_sub(1));
        (which, sigmas * draws.normal(OUTLIER, 1).signum())
    });
    let mut unread = Vec::new();
    for (index, case) in study.cases.iter_mut().enumerate() {
        case.made = Some(recipe.made);
        case.rows.retain_mut(|row| {
            let is_it =
                |observable: &Observable| observable.condition == index && observable.line == row.line;
            let Some(place) = campaign.observables().iter().position(is_it) else {
                unread.push(format!("{} line {}", case.name, row.line));
                return false;
            };
            let off = outlier
                .filter(|(which, _)| *which == place)
                .map_or(0.0, |(_, off)| off);
            let scatter = recipe.noise * draws.normal(NOISE, place as u64) + off;
            row.value = readings[place] + row.sigma * scatter;
            row.is_planned = false;
            true
        });
    }
    unread
}

/// The study with wings as they are measured: other meshes, and background errors.
///
/// # Errors
/// If a design refuses an error.
pub fn unlike(study: &LoadedStudy, made: &Made) -> Result<LoadedStudy, SynthesizeError> {
    let mut truth = study.clone();
    truth.experiments.clear();
    make_unlike(&mut truth, made)?;
    Ok(truth)
}

fn make_unlike(study: &mut LoadedStudy, made: &Made) -> Result<Vec<Background>, SynthesizeError> {
    let draws = Draws::new(made.seed);
    let mut background = Vec::new();
    let mut wings: Vec<String> = Vec::new();
    for case in &mut study.cases {
        let design = &mut case.loaded.design;
        design.mesh.refine *= made.mesh;
        if !wings.contains(&design.name) {
            wings.push(design.name.clone());
        }
        let wing = wings.iter().position(|wing| *wing == design.name).unwrap_or(0);
        let errors = Background::drawn(design, made.background, draws, BACKGROUND + 8 * wing as u64);
        errors.apply(design)?;
        if !background.contains(&errors) {
            background.push(errors);
        }
    }
    Ok(background)
}

impl Recipe {
    /// Nothing hidden: other meshes, one percent of background error, noise as stated.
    ///
    /// # Example
    /// ```
    /// # use washout_study as washout;
    /// use washout::synthesize::Recipe;
    ///
    /// let recipe = Recipe { noise: 1.5, ..Recipe::new(7) };
    /// assert!(recipe.hidden.is_empty());
    /// ```
    pub fn new(seed: u64) -> Recipe {
        Recipe {
            hidden: Vec::new(),
            made: Made {
                mesh: 1.25,
                formulas: Formulas::Other,
                background: 0.01,
                seed,
            },
            noise: 1.0,
            outlier: None,
        }
    }
}
