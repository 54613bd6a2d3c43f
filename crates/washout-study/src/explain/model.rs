//! The model of a study as an explanation moves it: strengths of effects within what is plausible, ratios among the readings.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use crate::input::measurement::{Channel, SigmaKind};
use crate::input::study::LoadedStudy;
use crate::progress::Progress;
use crate::study::{
    Campaign, Condition, Forward, Linear, Observable, StudyError, Unknown, UnknownKind, WarmStart, Work,
};

use super::inputs::widened;
use super::ratios::{Ratio, apart};

/// The model of a study.
#[derive(Debug, Clone)]
pub struct Model {
    campaign: Arc<Campaign>,
    unknowns: Vec<Unknown>,
    observables: Vec<Observable>,
    /// By observable: where its standard deviation comes from.
    kinds: Vec<SigmaKind>,
    /// By observable: what it is made of.
    recipes: Vec<Vec<(usize, i32)>>,
    /// By condition: the conditions without which its readings cannot be had.
    needs: Vec<Vec<usize>>,
    /// Measured ratios that cannot be compared, and why.
    without: Vec<String>,
}

impl Model {
    /// Of a study with every number that its designs assume uncertain, and these effects off to begin with.
    ///
    /// # Errors
    /// As [`Campaign::new`].
    pub fn new(study: &LoadedStudy, candidates: &[&str], progress: &Progress) -> Result<Model, StudyError> {
        let (apart, ratios) = apart(&widened(study));
        let campaign = Campaign::new(&apart, candidates, progress)?;
        let mut model = Model {
            unknowns: campaign.unknowns().iter().map(plausible).collect(),
            observables: Vec::new(),
            kinds: Vec::new(),
            recipes: Vec::new(),
            needs: (0..campaign.conditions().len()).map(|own| vec![own]).collect(),
            without: Vec::new(),
            campaign: Arc::new(campaign),
        };
        for index in 0..study.cases.len() {
            model.add_rows(index);
            for ratio in ratios.iter().filter(|ratio| ratio.case == index) {
                model.add_ratio(ratio);
            }
        }
        Ok(model)
    }

    /// The same model with these values of all readings.
    pub fn with_values(&self, values: &DVector<f64>) -> Model {
        let mut other = self.clone();
        for (observable, value) in other.observables.iter_mut().zip(values.iter()) {
            observable.value = *value;
        }
        other
    }

    /// The readings of a case that the campaign has as they are.
    fn add_rows(&mut self, case: usize) {
        let campaign = Arc::clone(&self.campaign);
        let rows = &campaign.cases()[case].rows;
        let inner = campaign.observables();
        let own = (0..inner.len()).filter(|&row| inner[row].condition == case);
        for (row, measured) in own.zip(rows) {
            if measured.line > 0 {
                self.observables.push(inner[row].clone());
                self.kinds.push(measured.sigma_kind);
                self.recipes.push(vec![(row, 1)]);
            }
        }
    }

    /// A ratio, if its forces can be read.
    fn add_ratio(&mut self, ratio: &Ratio) {
        let inner = self.campaign.observables();
        let find = |case: usize, channel: Channel| {
            inner
                .iter()
                .position(|own| own.condition == case && own.channel == channel && own.line == 0)
        };
        let parts = ratio.factors.iter();
        let recipe = parts.map(|&(case, channel, power)| Some((find(case, channel)?, power)));
        let Some(recipe) = recipe.collect::<Option<Vec<(usize, i32)>>>() else {
            self.without.push(format!(
                "{} of {}, line {}: lift or power of one of the two wings cannot be read",
                ratio.row.channel.name(),
                self.campaign.conditions()[ratio.case].name,
                ratio.row.line
            ));
            return;
        };
        for &(case, _, _) in &ratio.factors {
            if !self.needs[ratio.case].contains(&case) {
                self.needs[ratio.case].push(case);
            }
        }
        self.observables.push(Observable::of(&ratio.row, ratio.case));
        self.kinds.push(ratio.row.sigma_kind);
        self.recipes.push(recipe);
    }

    /// The campaign that it asks.
    pub fn campaign(&self) -> &Campaign {
        &self.campaign
    }

    /// Where all unknowns start.
    pub fn start(&self) -> Vec<f64> {
        self.campaign.start()
    }

    /// By observable: where its standard deviation comes from.
    pub fn kinds(&self) -> &[SigmaKind] {
        &self.kinds
    }

    /// Measured rows that take no part, and why.
    pub fn not_compared(&self) -> Vec<String> {
        let of_campaign = self.campaign.not_compared();
        of_campaign
            .into_iter()
            .chain(self.without.iter().cloned())
            .collect()
    }

    /// Readings and their derivatives from those of the campaign.
    fn readings(&self, inner: &Linear) -> Result<Linear, StudyError> {
        let size = self.observables.len();
        let mut value = DVector::zeros(size);
        let mut jacobian = DMatrix::zeros(size, inner.jacobian.ncols());
        for (row, recipe) in self.recipes.iter().enumerate() {
            if let [(own, 1)] = recipe[..] {
                value[row] = inner.value[own];
                jacobian.row_mut(row).copy_from(&inner.jacobian.row(own));
                continue;
            }
            let mut product = 1.0;
            for &(own, power) in recipe {
                let factor = inner.value[own];
                if factor.is_nan() || factor <= 0.0 {
                    return Err(self.no_ratio(row));
                }
                product *= factor.powi(power);
            }
            value[row] = product;
            for &(own, power) in recipe {
                let share = product * f64::from(power) / inner.value[own];
                let rates = inner.jacobian.row(own) * share;
                let mut target = jacobian.row_mut(row);
                target += rates;
            }
        }
        Ok(Linear { value, jacobian })
    }

    fn no_ratio(&self, row: usize) -> StudyError {
        StudyError::Unsolved {
            case: self.conditions()[self.observables[row].condition].name.clone(),
            reason: "a lift or power that is not positive has no ratio".to_string(),
        }
    }

    /// The same from where an answer was left, with the conditions besides that ratios need.
    fn with_needed(&self, from: &WarmStart) -> WarmStart {
        let count = self.conditions().len();
        let asked: Vec<bool> = (0..count).map(|own| from.asks(own)).collect();
        let is_needed =
            |condition: usize| (0..count).any(|own| asked[own] && self.needs[own].contains(&condition));
        let needed: Vec<bool> = (0..count).map(is_needed).collect();
        match needed.iter().all(|own| *own) {
            true => from.clone(),
            false => from.of_conditions(&needed),
        }
    }
}

impl Forward for Model {
    fn unknowns(&self) -> &[Unknown] {
        &self.unknowns
    }

    fn observables(&self) -> &[Observable] {
        &self.observables
    }

    fn conditions(&self) -> &[Condition] {
        self.campaign.conditions()
    }

    fn predict(&self, at: &[f64]) -> Result<DVector<f64>, StudyError> {
        let value = self.campaign.predict(at)?;
        let jacobian = DMatrix::zeros(value.len(), 0);
        Ok(self.readings(&Linear { value, jacobian })?.value)
    }

    fn linearize(&self, at: &[f64], wanted: &dyn Fn(&Unknown) -> bool) -> Result<Linear, StudyError> {
        Ok(self.linearize_from(None, at, wanted)?.0)
    }

    fn linearize_from(
        &self,
        warm_start: Option<&WarmStart>,
        at: &[f64],
        wanted: &dyn Fn(&Unknown) -> bool,
    ) -> Result<(Linear, Option<WarmStart>), StudyError> {
        let inner = self.campaign.unknowns();
        let asked: Vec<&Unknown> = inner
            .iter()
            .zip(&self.unknowns)
            .filter(|(_, own)| wanted(own))
            .map(|(inner, _)| inner)
            .collect();
        let warm_start = warm_start.map(|from| self.with_needed(from));
        let is_asked = |unknown: &Unknown| asked.contains(&unknown);
        let (linear, left) = self.campaign.linearize_from(warm_start.as_ref(), at, &is_asked)?;
        Ok((self.readings(&linear)?, left))
    }

    fn moment_response(&self, at: &[f64], stations: usize) -> Result<DMatrix<f64>, StudyError> {
        let value = self.campaign.predict(at)?;
        let jacobian = self.campaign.moment_response(at, stations)?;
        Ok(self.readings(&Linear { value, jacobian })?.jacobian)
    }

    fn work(&self) -> Work {
        self.campaign.work()
    }
}

/// An unknown that takes plausible values alone.
fn plausible(unknown: &Unknown) -> Unknown {
    let mut own = unknown.clone();
    if let UnknownKind::Effect { plausible, .. } = unknown.kind {
        let [low, high] = unknown.range;
        own.range = [
            plausible[0].clamp(low, high).min(0.0_f64.max(low)),
            plausible[1].clamp(low, high).max(0.0_f64.min(high)),
        ];
    }
    own
}
