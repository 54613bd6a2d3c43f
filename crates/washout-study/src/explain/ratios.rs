//! Measured ratios of one wing to another: what each of them is made of, read from the model as forces of both.

use crate::input::measurement::{Bound, Channel, Row};
use crate::input::study::LoadedStudy;

/// A measured ratio.
#[derive(Debug, Clone, PartialEq)]
pub struct Ratio {
    /// Index of its case.
    pub case: usize,
    /// The measured row.
    pub row: Row,
    /// Its factors: case, channel, exponent.
    pub factors: Vec<(usize, Channel, i32)>,
}

/// The study with forces of both wings as rows (of line 0) in the place of ratios that name their reference, and these ratios.
pub fn apart(study: &LoadedStudy) -> (LoadedStudy, Vec<Ratio>) {
    let mut apart = study.clone();
    let mut ratios: Vec<Ratio> = Vec::new();
    for (index, case) in study.cases.iter().enumerate() {
        let reference = case.reference.as_ref();
        let reference = reference.and_then(|name| study.cases.iter().position(|other| other.name == *name));
        let Some(reference) = reference else {
            continue;
        };
        for row in &case.rows {
            let factors = factors(row.channel, index, reference);
            if !factors.is_empty() {
                ratios.push(Ratio {
                    case: index,
                    row: row.clone(),
                    factors,
                });
            }
        }
        apart.cases[index]
            .rows
            .retain(|row| factors(row.channel, index, reference).is_empty());
    }
    let needed: Vec<(usize, Channel)> = ratios
        .iter()
        .flat_map(|ratio| ratio.factors.iter().map(|&(case, channel, _)| (case, channel)))
        .collect();
    for (place, &(case, channel)) in needed.iter().enumerate() {
        if !needed[..place].contains(&(case, channel)) {
            apart.cases[case].rows.push(force(&ratios[0].row, channel));
        }
    }
    (apart, ratios)
}

/// What a ratio of a case to its reference is made of; nothing where it is none. Efficiency is lift per power, each wing as it flies.
fn factors(channel: Channel, case: usize, reference: usize) -> Vec<(usize, Channel, i32)> {
    match channel {
        Channel::LiftRatio => vec![(case, Channel::Lift, 1), (reference, Channel::Lift, -1)],
        Channel::DragRatio => vec![(case, Channel::Drag, 1), (reference, Channel::Drag, -1)],
        Channel::EfficiencyRatio => vec![
            (case, Channel::Lift, 1),
            (case, Channel::Power, -1),
            (reference, Channel::Lift, -1),
            (reference, Channel::Power, 1),
        ],
        _ => Vec::new(),
    }
}

/// A row that asks for a force of the whole wing.
fn force(like: &Row, channel: Channel) -> Row {
    Row {
        line: 0,
        channel,
        instrument: None,
        r_mm: None,
        r_to_mm: None,
        chord_fraction: None,
        value: 0.0,
        is_planned: true,
        sigma: 1.0,
        bound: Bound::None,
        ..like.clone()
    }
}
