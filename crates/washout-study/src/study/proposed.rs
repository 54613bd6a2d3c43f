//! Readings that could be added to any study, made of its own cases: one more station; the still wing under a torque or a push, and how far
//! that deflects it; half the frequency, or half the speed; a stream from the other side.
//!
//! A flapping wing shows the other side of its film in the other half of every stroke, and the model of that half is the mirror image:
//! there is nothing to propose.

use super::bench::{bend, push, torque};
use super::campaign::Campaign;
use super::error::StudyError;
use super::proposal::{Cost, Proposal};
use super::quantile::quantile;
use super::two_meshes::COARSE;
use crate::input::measurement::{Bound, Channel, Row};
use crate::input::quantity::Quantity;
use crate::input::sheet::{Bench, STILL_HZ, short};
use crate::input::study::{LoadedCase, LoadedStudy};
use crate::progress::Progress;

/// Twist for which a bench load is chosen: as much as was measured, but within this, deg.
const MODERATE: [f64; 2] = [2.0, 15.0];
/// Share of that for which a small torque is chosen.
const SMALL: f64 = 0.1;
/// The same where no twist was measured, deg.
const UNKNOWN_TWIST: f64 = 5.0;
/// Standard deviation with which a deflection is held to be read, where none was, mm: that of a table that says nothing. Assumed, and said where it is proposed.
const DEFLECTION_MM: f64 = 0.5;
/// Stations nearer than this to another tell nothing new, over the length.
const NEAR: f64 = 0.05;

/// The readings that could be added to a study.
#[derive(Debug)]
pub struct Proposals<'a> {
    study: &'a LoadedStudy,
    candidates: &'a [&'a str],
    /// All of them, least cost first.
    pub all: Vec<Proposal>,
}

impl<'a> Proposals<'a> {
    /// Those of each wing that was fitted; nothing is solved. `candidates`: effects that the diagnosis tries.
    pub fn new(study: &'a LoadedStudy, candidates: &'a [&'a str]) -> Proposals<'a> {
        let mut all: Vec<Proposal> = Vec::new();
        let fitted = || study.cases.iter().filter(|case| !case.is_held_out);
        let mut wings: Vec<&str> = Vec::new();
        for case in fitted() {
            let wing = case.loaded.design.name.as_str();
            if wings.contains(&wing) {
                continue;
            }
            wings.push(wing);
            let own = fitted().filter(|own| own.loaded.design.name == wing);
            if let Some(clearest) = own.max_by(|a, b| clearness(a).total_cmp(&clearness(b))) {
                all.extend(of_wing(study, clearest));
            }
        }
        all.sort_by_key(|proposal| proposal.cost);
        Proposals {
            study,
            candidates,
            all,
        }
    }

    /// One of them as a condition of the model of the study.
    ///
    /// # Errors
    /// As [`Campaign::new`].
    pub fn campaign(&self, proposal: &Proposal, progress: &Progress) -> Result<Campaign, StudyError> {
        let mut study = self.study.clone();
        let is_set = |key: &str| proposal.cost.sets().iter().any(|own| key.starts_with(own));
        study.study.uncertain.retain(|uncertain| !is_set(&uncertain.key));
        let case = std::slice::from_ref(&proposal.case);
        Campaign::of_others(&study, case, self.candidates, &progress.unseen())
    }
}

/// Numbers of a case that tell how a wing is deformed somewhere.
fn deformations(case: &LoadedCase) -> impl Iterator<Item = &Row> {
    let is_one = |row: &&Row| row.channel.has_station() && row.bound == Bound::None;
    case.rows.iter().filter(is_one)
}

/// How far a case stands out of its scatter; twist goes before all else.
fn clearness(case: &LoadedCase) -> f64 {
    let of = |is_twist: bool| {
        let rows = deformations(case).filter(move |row| (row.channel == Channel::Twist) == is_twist);
        rows.map(|row| (row.value / row.sigma).powi(2)).sum::<f64>()
    };
    match of(true) {
        0.0 => -1.0 / (1.0 + of(false)),
        twist => twist,
    }
}

/// What could be measured of a wing, of which `clearest` is the clearest case.
fn of_wing(study: &LoadedStudy, clearest: &LoadedCase) -> Vec<Proposal> {
    let rows = rows_to_come(study, clearest);
    if rows.is_empty() {
        return Vec::new();
    }
    let twist_deg = moderate_twist(clearest);
    let mut case = clearest.clone();
    let mesh = &mut case.loaded.design.mesh;
    if mesh.refine > COARSE && case.loaded.mesh_file.is_none() {
        mesh.refine *= 0.5;
    }
    case.rows = rows;
    let in_air = |case: LoadedCase| (None, case);
    let on_bench = |(bench, case): (Bench, LoadedCase)| (Some(bench), case);
    let found = [
        (Cost::Station, more_stations(&case).map(in_air)),
        (Cost::Torque, torque(&case, twist_deg).map(on_bench)),
        (Cost::SmallTorque, torque(&case, SMALL * twist_deg).map(on_bench)),
        (Cost::Push, push(&case, twist_deg).map(on_bench)),
        (
            Cost::Deflection,
            deflection(&case).as_ref().and_then(bend).map(on_bench),
        ),
        (Cost::Slower, slower(&case).map(in_air)),
        (Cost::OtherSide, other_side(&case).map(in_air)),
    ];
    let proposal = |(cost, found): (Cost, Option<(Option<Bench>, LoadedCase)>)| {
        let (bench, case) = found?;
        Some(Proposal { cost, case, bench })
    };
    found.into_iter().filter_map(proposal).collect()
}

/// The twist that a bench load is to make, deg.
fn moderate_twist(measured: &LoadedCase) -> f64 {
    let twists = deformations(measured).filter(|row| row.channel == Channel::Twist);
    match twists.map(|row| row.value.abs()).fold(0.0, f64::max) {
        0.0 => UNKNOWN_TWIST,
        most => most.clamp(MODERATE[0], MODERATE[1]),
    }
}

/// The places and instruments of a case once more, values yet to come, each with the median standard deviation that the study has for its
/// channel.
fn rows_to_come(study: &LoadedStudy, case: &LoadedCase) -> Vec<Row> {
    let sigma = |channel: Channel| {
        let fitted = study.cases.iter().filter(|case| !case.is_held_out);
        let rows = fitted.flat_map(deformations).filter(|row| row.channel == channel);
        let mut sigmas: Vec<f64> = rows.map(|row| row.sigma).collect();
        sigmas.sort_by(f64::total_cmp);
        quantile(&sigmas, 0.5)
    };
    let mut rows: Vec<Row> = Vec::new();
    for row in deformations(case) {
        let place = |row: &Row| {
            (
                row.channel,
                row.instrument,
                row.r_mm,
                row.r_to_mm,
                row.chord_fraction,
            )
        };
        if rows.iter().all(|known| place(known) != place(row)) {
            rows.push(Row {
                value: 0.0,
                is_planned: true,
                sigma: sigma(row.channel).unwrap_or(row.sigma),
                ..row.clone()
            });
        }
    }
    rows
}

/// Twist (or what else was read) in the same condition, in the middle between any two stations and at the tip.
fn more_stations(case: &LoadedCase) -> Option<LoadedCase> {
    let single = |row: &&Row| row.r_to_mm.is_none() && row.r_mm.is_some();
    let twist = |row: &&Row| row.channel == Channel::Twist;
    let mut rows = case.rows.iter().filter(single);
    let like = rows.clone().find(twist).or_else(|| rows.next()).cloned()?;
    let is_like = |row: &&Row| row.channel == like.channel && row.chord_fraction == like.chord_fraction;
    let read = case.rows.iter().filter(single).filter(is_like);
    let read: Vec<f64> = read.filter_map(|row| row.r_mm).collect();
    let design = &case.loaded.design;
    let length_mm = design.planform.length_mm.value();
    let places = places_between(&read, length_mm, design.observation.tip_station * length_mm);
    let at = |r_mm: f64| Row {
        r_mm: Some(r_mm),
        ..like.clone()
    };
    let mut more = case.clone();
    more.rows = places.into_iter().map(at).collect();
    (!more.rows.is_empty()).then_some(more)
}

/// The case with a deflection to be read wherever something was, if none was.
fn deflection(case: &LoadedCase) -> Option<LoadedCase> {
    let is_one = |row: &Row| row.channel == Channel::Deflection;
    let mut other = case.clone();
    other.rows.clear();
    for row in case.rows.iter().filter(|row| row.r_to_mm.is_none()) {
        let is_new = other.rows.iter().all(|own| own.r_mm != row.r_mm);
        if is_new {
            other.rows.push(Row {
                channel: Channel::Deflection,
                instrument: None,
                chord_fraction: None,
                sigma: DEFLECTION_MM,
                ..row.clone()
            });
        }
    }
    (!other.rows.is_empty() && !case.rows.iter().any(is_one)).then_some(other)
}

/// Places in the middle between stations, the base being one, and the tip, mm; to a tenth.
fn places_between(read: &[f64], length_mm: f64, tip_mm: f64) -> Vec<f64> {
    let mut ends = read.to_vec();
    ends.push(0.0);
    ends.sort_by(f64::total_cmp);
    let is_far = |from: f64, to: f64| to - from > NEAR * length_mm;
    let pairs = ends.windows(2).filter(|pair| is_far(pair[0], pair[1]));
    let mut places: Vec<f64> = pairs.map(|pair| 0.5 * (pair[0] + pair[1])).collect();
    let last = ends.last().copied().unwrap_or_default();
    if is_far(last, tip_mm) {
        places.push(tip_mm);
    }
    places.iter().map(|place| (10.0 * place).round() / 10.0).collect()
}

/// The condition at half its frequency, or half its speed.
fn slower(case: &LoadedCase) -> Option<LoadedCase> {
    let mut slower = case.clone();
    let design = &mut slower.loaded.design;
    let condition = if let Some(flapping) = &mut design.flapping {
        let half = 0.5 * flapping.frequency_hz.value();
        flapping.frequency_hz = Quantity::Stated(half);
        (half > STILL_HZ).then(|| format!("flapping at {} Hz", short(half)))
    } else {
        let steady = design.steady.as_mut()?;
        let half = 0.5 * steady.speed_m_s.value();
        steady.speed_m_s = Quantity::Stated(half);
        (half > 0.0).then(|| format!("in a stream of {} m/s", short(half)))
    };
    slower.name = format!(
        "the wing {} as in case {}, but {}",
        design.name, case.name, condition?
    );
    Some(slower)
}

/// A wing in a stream at the same angle to the other side; what is pitched with the wing is so with it.
fn other_side(case: &LoadedCase) -> Option<LoadedCase> {
    let mut other = case.clone();
    let design = &mut other.loaded.design;
    let steady = design.steady.as_mut()?;
    let angle = steady.root_angle_deg.value();
    if angle == 0.0 {
        return None;
    }
    steady.root_angle_deg = Quantity::Stated(-angle);
    if design.observation.frame_pitch_deg == angle {
        design.observation.frame_pitch_deg = -angle;
    }
    if let Some(gravity) = &mut design.gravity
        && gravity.root_pitch_deg.value() == angle
    {
        gravity.root_pitch_deg = Quantity::Stated(-angle);
    }
    other.name = format!(
        "the wing {} as in case {}, but at {} deg",
        design.name,
        case.name,
        short(-angle)
    );
    Some(other)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn study(name: &str) -> LoadedStudy {
        let path =
            Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(format!("studies/{name}.toml"));
        LoadedStudy::load_planned(&path, &[]).unwrap()
    }

    #[test]
    fn every_wing_that_was_fitted_has_its_readings_the_cheapest_first() {
        let study = study("three-rods");
        let all = Proposals::new(&study, &[]).all;
        let wings = ["twist-v1", "twist-v2", "thick"];
        let costs = [
            Cost::Station,
            Cost::Torque,
            Cost::SmallTorque,
            Cost::Push,
            Cost::Slower,
        ];
        assert_eq!(all.len(), wings.len() * costs.len());
        for (proposal, place) in all.iter().zip(0..) {
            assert_eq!(proposal.cost, costs[place / wings.len()]);
            let design = &proposal.case.loaded.design;
            assert_eq!(design.name, wings[place % wings.len()]);
            for row in &proposal.case.rows {
                let is_twist = row.channel == Channel::Twist;
                assert!(row.is_planned && row.sigma == if is_twist { 0.4 } else { 0.05 });
            }
            let is_still = matches!(proposal.cost, Cost::Torque | Cost::SmallTorque | Cost::Push);
            let own = design.flapping.as_ref().unwrap().frequency_hz.value();
            assert_eq!(own == STILL_HZ, is_still);
            assert_eq!(design.load.len(), usize::from(is_still));
        }
        assert!(
            all[3]
                .words(&[])
                .starts_with("the still wing twist-v1 under a torque of ")
                && all[3].words(&[]).ends_with("N·m near its tip (67.2 mm)"),
            "{}",
            all[3].words(&[])
        );
        assert!(
            all[9]
                .words(&[])
                .contains(" at 35 mm, 13 mm behind its leading edge")
        );
        assert!(all[12].words(&[]).contains("twist-v1 as in case twist-v1-"));
        let heads: Vec<Option<String>> = [0, 3, 9, 12].map(|place| all[place].column()).into();
        let begins = [None, Some("torque "), Some("push "), Some("")];
        for (head, begin) in heads.iter().zip(begins) {
            let begins = head
                .as_deref()
                .zip(begin)
                .is_none_or(|(head, begin)| head.starts_with(begin));
            assert!(begins && head.is_some() == begin.is_some(), "{head:?}");
        }
        assert!(
            heads[3].as_ref().is_some_and(|head| head.contains(" Hz")),
            "{heads:?}"
        );
    }

    #[test]
    fn a_stream_is_halved_and_turned_with_what_is_pitched_with_it() {
        let study = study("tang-dowell-wind");
        let all = Proposals::new(&study, &[]).all;
        let of = |cost: Cost| {
            let own = all.iter().find(|own| own.cost == cost).unwrap();
            &own.case.loaded.design
        };
        let (slower, other) = (of(Cost::Slower), of(Cost::OtherSide));
        let speed = |design: &crate::input::Design| design.steady.as_ref().unwrap().speed_m_s.value();
        assert!((speed(slower) / speed(other) - 0.5).abs() < 1e-12);
        let turned = all.iter().find(|own| own.cost == Cost::OtherSide).unwrap();
        assert!(
            turned.column().unwrap().ends_with(" m/s, -1 deg"),
            "{:?}",
            turned.column()
        );
        let gravity = other.gravity.as_ref().unwrap();
        assert_eq!(
            [
                other.steady.as_ref().unwrap().root_angle_deg.value(),
                other.observation.frame_pitch_deg,
                gravity.root_pitch_deg.value()
            ],
            [-1.0; 3]
        );
    }

    #[test]
    fn stations_are_added_in_the_middle_and_at_the_tip() {
        assert_eq!(
            places_between(&[60.0, 20.0, 22.0], 100.0, 97.0),
            [10.0, 41.0, 97.0]
        );
        assert_eq!(places_between(&[50.0, 100.0], 100.0, 97.0), [25.0, 75.0]);
        assert!(places_between(&[1.0], 100.0, 3.0).is_empty());
    }

    #[test]
    fn what_has_no_solution_says_what_it_is() {
        let study = study("three-rods");
        let mut proposals = Proposals::new(&study, &[]);
        let torque = proposals.all.iter_mut().find(|own| own.cost == Cost::Torque);
        let torque = torque.unwrap();
        torque.case.loaded.design.rod.clear();
        let torque = torque.clone();
        let error = proposals.campaign(&torque, &Progress::quiet()).unwrap_err();
        assert!(error.to_string().contains(&torque.words(&[])), "{error}");
    }
}
