//! Before any measurement: which effects a planned campaign could see, and which it could tell apart.

use nalgebra::{DMatrix, DVector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::progress::Progress;
use crate::study::left_out::Local;
use crate::study::{Forward, Linear};

use super::baseline::{distance, distances};
use super::data::{Data, start};
use super::effect_row::LookAlike;
use super::error::DiagnoseError;
use super::model_error::{ModelError, Size};
use super::posterior::SEPARATE;
use super::responses::Response;
use super::scatter::Scatter;
use super::screening::{Directions, ENOUGH_POWER, effect_of, family_wise, is_one_sided, power_at_distance};
use super::settings::Settings;
use super::table::Table;
use super::whitened::Whitened;

/// What a planned campaign could tell.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Plan {
    /// The answer in one sentence.
    pub sentence: String,
    /// Numbers that would be measured.
    pub numbers: usize,
    /// Every effect, the most visible first.
    pub effects: Vec<PlannedEffect>,
}

/// What a planned campaign could tell of one effect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PlannedEffect {
    /// The effect.
    pub effect: String,
    /// Its family.
    pub family: String,
    /// Size of strength that is plausible, in `unit`.
    pub scale: f64,
    /// Unit of the strength.
    pub unit: String,
    /// Standard error that its strength would have.
    pub standard_error: f64,
    /// Size at which it is judged: the plausible one, or the largest at which the model has a solution.
    pub judged_at: f64,
    /// Distance from none, in standard deviations, at that size.
    pub detectability: f64,
    /// Whether the model has no solution at the plausible size.
    pub has_no_solution: bool,
    /// Probability to see it at the size at which it is judged.
    pub power: f64,
    /// Share of its signature that the model's own unknowns would absorb.
    pub absorbed: f64,
    /// Effects of other families that could not be told from it at that size, nearest first.
    pub confused_with: Vec<LookAlike>,
}

/// A campaign before it is measured: how far every reading stands out of noise and of what the model could absorb.
pub struct Outlook {
    /// What it could tell.
    pub plan: Plan,
    /// Readings of the model at `start`.
    pub predicted: DVector<f64>,
    /// Values of all unknowns: effects at zero.
    pub start: Vec<f64>,
    data: Data,
    whitened: Whitened,
    directions: Directions,
}

/// Judges the campaign whose observables `forward` lists; their values do not matter, their noise does. `table`: how the campaign
/// answers, if that is known.
///
/// # Errors
/// If there is nothing to measure or no effect to look for, a result is not finite, or the user asked to stop.
pub fn plan(
    forward: &dyn Forward,
    table: Option<&Table>,
    settings: &Settings,
    progress: &Progress,
) -> Result<Plan, DiagnoseError> {
    Ok(Outlook::new(forward, table, settings, progress)?.plan)
}

impl Outlook {
    /// As [`plan`], with what it was judged by.
    ///
    /// # Errors
    /// As [`plan`].
    pub fn new(
        forward: &dyn Forward,
        table: Option<&Table>,
        settings: &Settings,
        progress: &Progress,
    ) -> Result<Outlook, DiagnoseError> {
        settings.check()?;
        let start = start(forward, settings)?;
        let data = Data::new(forward, &start)?;
        let unknowns = forward.unknowns();
        progress.say("derivatives with every effect");
        let is_of_model = |name: &str| data.model.iter().any(|&i| unknowns[i].name == name);
        let linear = forward.linearize(&start, &|unknown| is_of_model(&unknown.name))?;
        progress.check()?;
        let own = match table {
            Some(_) => None,
            None => Some(Table::new(forward, settings, progress)?),
        };
        let Some(Table {
            slopes, responses, ..
        }) = table.or(own.as_ref())
        else {
            return Err(DiagnoseError::NoEffects);
        };
        let size = data.rows.len();
        let (scatter, whitened) = expected(forward, &data, &linear, settings)?;
        let directions = Directions::new(&data, slopes, &whitened);
        let before = scatter
            .noise
            .whiten_columns(&slopes.select_rows(data.rows.iter()));
        let level = family_wise(settings.significance, data.missing.len());
        let distances = distances(forward, &data, responses, &whitened);
        let effects = (0..data.missing.len()).filter_map(|k| {
            let whole = before.column(k).norm();
            let (_, _, scale, _) = effect_of(&forward.unknowns()[data.missing[k]])?;
            let judged = distances[k]
                .map(|distance| (scale, distance))
                .or_else(|| largest(&responses.each[k], &whitened));
            planned(forward, &data, &directions, (k, judged), whole, level)
        });
        let effects = most_visible(effects.collect());
        Ok(Outlook {
            plan: Plan {
                sentence: sentence(&effects),
                numbers: size,
                effects,
            },
            predicted: linear.value,
            start,
            data,
            whitened,
            directions,
        })
    }

    /// Distance of readings from those of the model, in standard deviations, what the model could absorb left out.
    pub fn distance(&self, readings: &DVector<f64>) -> f64 {
        self.seen(&(readings - &self.predicted)).norm()
    }

    /// The same with the effect of another family than `family` left out that is nearest to them.
    pub fn apart(&self, forward: &dyn Forward, readings: &DVector<f64>, family: &str) -> f64 {
        let seen = self.seen(&(readings - &self.predicted));
        let directions = &self.directions;
        let unknown = |k: usize| &forward.unknowns()[self.data.missing[k]];
        let others = (0..self.data.missing.len()).filter(|&k| {
            effect_of(unknown(k)).is_some_and(|(_, other, _, _)| other != family)
                && directions.lengths[k] > 0.0
        });
        directions.beyond(&seen, others.map(|k| (k, is_one_sided(unknown(k)))))
    }

    /// Change of readings in standard deviations, what the model could absorb left out.
    pub fn seen(&self, moved: &DVector<f64>) -> DVector<f64> {
        let moved = DMatrix::from_column_slice(moved.len(), 1, moved.as_slice());
        self.whitened.directions(&moved).column(0).into_owned()
    }
}

/// The scatter that is expected about a model, and the model's own unknowns in it.
fn expected(
    forward: &dyn Forward,
    data: &Data,
    linear: &Linear,
    settings: &Settings,
) -> Result<(Scatter, Whitened), DiagnoseError> {
    let unknowns = forward.unknowns();
    let size = data.rows.len();
    let own = DMatrix::from_fn(size, data.model.len(), |row, k| {
        linear.jacobian[(data.rows[row], data.model[k])] * unknowns[data.model[k]].sigma
    });
    let ones = vec![1.0; size];
    let error = ModelError::new(forward, data, &linear.value, &ones, &own);
    let scatter = Scatter::new(
        &error,
        &Size::typical(settings.discrepancy, settings.noise_scale),
        ones,
    )?;
    let local = Local {
        at_means: DVector::zeros(size),
        slopes: own,
        rows: data.rows.clone(),
        ends: Vec::new(),
    };
    let whitened = Whitened::new(&local, &scatter.noise)?;
    Ok((scatter, whitened))
}

/// What the campaign could tell of effect `k`, which the model sees at this distance. `whole`: length of its signature before the model's own
/// unknowns absorb their part; `level`: significance at which it is looked for.
fn planned(
    forward: &dyn Forward,
    data: &Data,
    directions: &Directions,
    (k, by_model): (usize, Option<(f64, f64)>),
    whole: f64,
    level: f64,
) -> Option<PlannedEffect> {
    let unknown = &forward.unknowns()[data.missing[k]];
    let (effect, family, scale, one_sided) = effect_of(unknown)?;
    let length = directions.lengths[k];
    let by_slope = scale / unknown.sigma * length;
    let (judged_at, detectability) = by_model.unwrap_or((scale, by_slope));
    Some(PlannedEffect {
        effect: effect.to_string(),
        family: family.to_string(),
        scale,
        unit: unknown.unit.clone(),
        standard_error: unknown.sigma / length.max(1e-9),
        judged_at,
        detectability,
        has_no_solution: by_model.is_none_or(|(at, _)| at != scale),
        power: power_at_distance(detectability, one_sided, level),
        absorbed: if whole > 0.0 {
            1.0 - (length / whole).min(1.0)
        } else {
            0.0
        },
        confused_with: confused(forward, data, directions, (k, detectability)),
    })
}

/// The largest size at which the model was solved with an effect, and its distance from none there.
fn largest(response: &Response, whitened: &Whitened) -> Option<(f64, f64)> {
    let [low, high] = response.reach()?;
    let strength = if -low > high { low } else { high };
    (strength != 0.0).then(|| (strength.abs(), distance(response, strength, whitened)))
}

/// The effects, the most visible first; of one that may sit anywhere, its most visible place.
fn most_visible(mut effects: Vec<PlannedEffect>) -> Vec<PlannedEffect> {
    effects.sort_by(|a, b| b.detectability.total_cmp(&a.detectability));
    let mut names: Vec<String> = Vec::new();
    effects.retain(|effect| {
        let is_new = !names.contains(&effect.effect);
        names.push(effect.effect.clone());
        is_new
    });
    effects
}

/// Effects of other families that an effect, seen at this distance, cannot be told from.
fn confused(
    forward: &dyn Forward,
    data: &Data,
    directions: &Directions,
    (k, distance): (usize, f64),
) -> Vec<LookAlike> {
    let unknown = |j: usize| &forward.unknowns()[data.missing[j]];
    let of = |j: usize| effect_of(unknown(j));
    let Some((_, family, ..)) = of(k) else {
        return Vec::new();
    };
    let mut found: Vec<LookAlike> = (0..data.missing.len())
        .filter_map(|j| {
            let (effect, other, _, _) = of(j)?;
            let cosine = directions.cosine(k, j);
            let separation_sigma = distance * (1.0 - cosine * cosine).max(0.0).sqrt();
            // of two effects of one sign, those that move the data oppositely are not alike
            let may = cosine > 0.0 || !is_one_sided(unknown(k)) || !is_one_sided(unknown(j));
            let is_seen = directions.lengths[j] > 0.0;
            (other != family && may && is_seen && separation_sigma < SEPARATE).then(|| LookAlike {
                effect: effect.to_string(),
                cosine,
                separation_sigma,
            })
        })
        .collect();
    found.sort_by(|a, b| b.cosine.abs().total_cmp(&a.cosine.abs()));
    // of an effect that may sit anywhere, the place that is most alike
    let mut names: Vec<String> = Vec::new();
    found.retain(|own| {
        let is_new = !names.contains(&own.effect);
        names.push(own.effect.clone());
        is_new
    });
    found
}

fn sentence(effects: &[PlannedEffect]) -> String {
    let seen: Vec<&PlannedEffect> = effects
        .iter()
        .filter(|effect| effect.power >= ENOUGH_POWER)
        .collect();
    let told = seen
        .iter()
        .filter(|effect| effect.confused_with.is_empty())
        .count();
    format!(
        "Of {} effects of plausible size this campaign could see {} and tell {} of them from every other.",
        effects.len(),
        seen.len(),
        told
    )
}
