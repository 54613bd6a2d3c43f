//! What a set says of readings that were not taken: every wing in flight, and the experiments of the study or those that any study can add.

use std::collections::BTreeMap;

use crate::input::measurement::{Bound, Channel, Row, SigmaKind};
use crate::input::study::{LoadedCase, LoadedStudy};
use crate::progress::Progress;
use crate::study::{Campaign, Cost, Forward, Proposals, StudyError, Unknown};

use super::error::ExplainError;
use super::inputs::widened;
use super::model::Model;
use super::report::Forecast;

/// Standard deviations of readings that the study has none of: twist (deg), displacement (mm); forces and power as a share. Assumed.
const TWIST_DEG: f64 = 1.0;
const DEFLECTION_MM: f64 = 0.5;
const SHARE_OF_FORCE: f64 = 0.05;
/// Stations at which twist in flight is predicted, over the length; the tip station of the design besides.
const STATIONS: [f64; 7] = [0.1, 0.25, 0.4, 0.55, 0.7, 0.8, 0.9];

/// What a reading costs: one more picture, a ruler in flight, a bench, a balance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effort {
    /// Twist in a condition that was measured.
    Picture,
    /// Deflection in a condition that was measured.
    Deflection,
    /// An experiment.
    Experiment,
    /// Lift or power.
    Balance,
}

/// A reading that could be taken.
#[derive(Debug, Clone)]
pub struct Possible {
    /// The wing in its condition, or the experiment.
    pub condition: String,
    /// What would be measured.
    pub row: Row,
    /// What it costs.
    pub effort: Effort,
    case: usize,
    place: usize,
}

/// Readings that could be taken in one choice of words and alternatives.
#[derive(Debug)]
pub struct Forecasts {
    campaign: Campaign,
    /// The readings, alike in all choices.
    pub possible: Vec<Possible>,
    /// Experiments that the model has no answer to as it stands.
    pub left_out: Vec<String>,
}

impl Forecasts {
    /// Of a study; `names`: the effects that may act.
    ///
    /// # Errors
    /// If the study itself has no solution, or the user asked to stop.
    pub fn new(study: &LoadedStudy, names: &[&str], progress: &Progress) -> Result<Forecasts, ExplainError> {
        let mut wide = widened(study);
        for case in &mut wide.cases {
            case.rows.truncate(1);
        }
        let base = wide.cases.len();
        let mut left_out: Vec<String> = Vec::new();
        let mut kept: Vec<(LoadedCase, Option<Effort>)> = Vec::new();
        for extra in in_flight(study).into_iter().chain(experiments(study, names)) {
            let mut alone = wide.clone();
            alone.cases.truncate(base);
            alone.cases.push(extra.0.clone());
            match Campaign::new(&alone, names, &progress.unseen()) {
                Ok(_) => kept.push(extra),
                Err(StudyError::Cancelled(cancelled)) => return Err(cancelled.into()),
                Err(error) => left_out.push(format!("{}: {error}", extra.0.name)),
            }
        }
        wide.cases.extend(kept.iter().map(|own| own.0.clone()));
        let campaign = Campaign::new(&wide, names, &progress.unseen())?;
        let mut possible: Vec<Possible> = Vec::new();
        for (number, (extra, effort)) in kept.iter().enumerate() {
            let case = base + number;
            for (place, row) in campaign.cases()[case].rows.iter().enumerate() {
                possible.push(Possible {
                    condition: extra.name.clone(),
                    row: row.clone(),
                    effort: effort.unwrap_or_else(|| effort_of(row.channel)),
                    case,
                    place,
                });
            }
        }
        let mut found = Forecasts {
            campaign,
            possible,
            left_out,
        };
        let stated = found.read(&found.campaign.start());
        for (own, stated) in found.possible.iter_mut().zip(stated) {
            if let (Channel::Lift | Channel::Power, Some(stated)) = (own.row.channel, stated) {
                own.row.sigma = (SHARE_OF_FORCE * stated.abs()).max(f64::MIN_POSITIVE);
            }
        }
        Ok(found)
    }

    /// What every reading would be with these values of the unknowns of the model of the same choice.
    pub fn at(&self, model: &Model, at: &[f64]) -> Vec<Forecast> {
        let mut there = self.campaign.start();
        let own = numbered(self.campaign.unknowns());
        for (key, i) in numbered(model.campaign().unknowns()) {
            if let Some(&place) = own.get(&key) {
                there[place] = at[i];
            }
        }
        let stated = self.read(&self.campaign.start());
        let with_set = self.read(&there);
        let forecasts = self.possible.iter().zip(stated).zip(with_set);
        forecasts
            .map(|((own, stated), with_set)| Forecast {
                condition: own.condition.clone(),
                channel: own.row.channel,
                r_mm: own.row.r_mm,
                sigma: own.row.sigma,
                stated,
                with_set,
            })
            .collect()
    }

    fn read(&self, at: &[f64]) -> Vec<Option<f64>> {
        let mut read: BTreeMap<usize, Option<Vec<Option<f64>>>> = BTreeMap::new();
        let of = |own: &Possible| {
            let values = read.entry(own.case).or_insert_with(|| {
                let solved = self.campaign.solved_at(own.case, at).ok()?;
                let values = self.campaign.cases()[own.case].read_each(&solved.at).ok()?;
                Some(values.into_iter().map(Result::ok).collect())
            });
            values
                .as_ref()
                .and_then(|values| values.get(own.place).copied().flatten())
        };
        self.possible.iter().map(of).collect()
    }
}

/// Index of each unknown by its name and how many of that name stand before it.
fn numbered(unknowns: &[Unknown]) -> BTreeMap<(&str, usize), usize> {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut found = BTreeMap::new();
    for (i, unknown) in unknowns.iter().enumerate() {
        let count = counts.entry(unknown.name.as_str()).or_default();
        found.insert((unknown.name.as_str(), *count), i);
        *count += 1;
    }
    found
}

fn effort_of(channel: Channel) -> Effort {
    match channel {
        Channel::Twist | Channel::TwistRate => Effort::Picture,
        Channel::Lift | Channel::Drag | Channel::Power => Effort::Balance,
        _ => Effort::Deflection,
    }
}

/// Every wing that was fitted, in its first condition: twist along it, deflection of its tip, lift and power.
fn in_flight(study: &LoadedStudy) -> Vec<(LoadedCase, Option<Effort>)> {
    let mut found: Vec<(LoadedCase, Option<Effort>)> = Vec::new();
    let mut seen: Vec<&str> = Vec::new();
    for case in study
        .cases
        .iter()
        .filter(|case| !case.is_held_out && !case.rows.is_empty())
    {
        if seen.contains(&case.loaded.design.name.as_str()) {
            continue;
        }
        seen.push(&case.loaded.design.name);
        let design = &case.loaded.design;
        let length_mm = design.planform.length_mm.value();
        let twist = |share: f64| row(study, case, Channel::Twist, Some(share * length_mm));
        let tip = design.observation.tip_station;
        let mut rows: Vec<Row> = STATIONS.into_iter().chain([tip]).map(twist).collect();
        rows.push(row(study, case, Channel::Deflection, Some(tip * length_mm)));
        if design.flapping.is_some() {
            rows.push(row(study, case, Channel::Lift, None));
            rows.push(row(study, case, Channel::Power, None));
        }
        let own = LoadedCase {
            name: format!("{} as measured", case.name),
            rows,
            reference: None,
            ..case.clone()
        };
        found.push((own, None));
    }
    found
}

/// The experiments that the study lists, or those on the bench and slower that any study can add.
fn experiments(study: &LoadedStudy, names: &[&str]) -> Vec<(LoadedCase, Option<Effort>)> {
    let listed = study.experiments.iter().cloned();
    let mut found: Vec<LoadedCase> = listed.collect();
    if found.is_empty() {
        let proposals = Proposals::new(study, names);
        let others = proposals.all.iter().filter(|own| own.cost != Cost::Station);
        found.extend(others.map(|own| own.case().clone()));
    }
    found
        .into_iter()
        .map(|case| (case, Some(Effort::Experiment)))
        .collect()
}

/// A row of a case that is yet to be measured, read as the study reads that channel.
fn row(study: &LoadedStudy, case: &LoadedCase, channel: Channel, r_mm: Option<f64>) -> Row {
    let rows = || study.cases.iter().flat_map(|case| &case.rows);
    let like = rows().find(|row| row.channel == channel && row.bound == Bound::None);
    let is_twist = |row: &&Row| matches!(row.channel, Channel::Twist | Channel::TwistRate);
    let instrument = match channel {
        Channel::Twist => rows().find(is_twist).and_then(|row| row.instrument),
        _ => None,
    };
    let assumed = match channel {
        Channel::Twist => TWIST_DEG,
        Channel::Deflection => DEFLECTION_MM,
        _ => 1.0,
    };
    let tenth = |r_mm: f64| (10.0 * r_mm).floor() / 10.0;
    Row {
        line: 1,
        case: case.name.clone(),
        channel,
        instrument,
        run: "forecast".to_string(),
        r_mm: r_mm.map(tenth),
        r_to_mm: None,
        chord_fraction: (channel == Channel::Deflection).then_some(0.0),
        value: 0.0,
        is_planned: true,
        sigma: like.map_or(assumed, |row| row.sigma),
        sigma_kind: SigmaKind::Assumed,
        bound: Bound::None,
    }
}
