//! Cases with a hidden cause, made by nature's solver from seeds.

use std::collections::BTreeMap;

use washout::study::draws::Draws;
use washout::study::{Unknown, UnknownKind};

use crate::effects::EFFECTS;
use crate::rod::{Toy, Wing};
use crate::truth::{Hidden, Nature};

/// Kinds of cases.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Null,
    /// Nothing missing, σ stated 30 % too small.
    NullQuiet,
    /// Nothing missing, one number 8 σ off.
    NullOutlier,
    /// Nothing missing, twice the background error: 2 % in chord and stiffness, 3 % in the air law.
    NullRough,
    Single,
    Pair,
    Novel,
    Twin,
}

/// A case and its answer.
pub struct Case {
    pub seed: u64,
    pub toy: Toy,
    pub nature: Nature,
    pub families: Vec<&'static str>,
}

/// The same with damage that moves to where the data have it, from each place that the library knows.
pub fn with_places(mut toy: Toy) -> Toy {
    let places = EFFECTS
        .iter()
        .filter_map(|effect| Some((effect.name, effect.place?)));
    toy.unknowns.extend(places.map(|(name, place)| Unknown {
        name: format!("place of {name}"),
        unit: "1".into(),
        kind: UnknownKind::Place {
            of: name.into(),
            parameter: "place".into(),
            numbers: BTreeMap::new(),
            wing: None,
            rod_mm: None,
        },
        mean: place,
        sigma: 0.05,
        range: [place - 0.1, place + 0.1],
    }));
    toy
}

pub const WINGS: [Wing; 3] = [
    Wing {
        name: "thin",
        length_m: 0.07,
        gj_n_m2: 4.0e-5,
    },
    Wing {
        name: "thick",
        length_m: 0.07,
        gj_n_m2: 8.0e-5,
    },
    Wing {
        name: "short",
        length_m: 0.055,
        gj_n_m2: 3.0e-5,
    },
];

const TWINS: [[&str; 2]; 2] = [
    ["stiffness", "coefficient_scale"],
    ["root_compliance", "clamp_slip"],
];

/// Nine conditions of three wings and two held out, ten stations.
pub fn good_campaign(sigma_deg: f64) -> Toy {
    let mut runs = Vec::new();
    for wing in 0..3 {
        runs.extend([
            (wing, 18.0, 60.0, false),
            (wing, 25.0, 50.0, false),
            (wing, 25.0, 70.0, false),
        ]);
    }
    runs.extend([(0, 28.0, 60.0, true), (1, 28.0, 65.0, true)]);
    let stations: Vec<f64> = (1..=10).map(|i| 0.098 * f64::from(i)).collect();
    Toy::new(&WINGS, &runs, &stations, sigma_deg)
}

/// One wing, two frequencies, six stations.
pub fn poor_campaign(sigma_deg: f64) -> Toy {
    let stations: Vec<f64> = (1..=6).map(|i| 0.16 * f64::from(i)).collect();
    Toy::new(
        &WINGS[..1],
        &[(0, 18.0, 60.0, false), (0, 25.0, 60.0, false)],
        &stations,
        sigma_deg,
    )
}

/// Puts nature's readings with noise of `sigma` times the stated one into the toy.
pub fn measure(toy: &mut Toy, nature: &Nature, draws: Draws, sigma: f64) {
    let readings = nature.readings(toy);
    for (row, (observable, reading)) in toy.observables.iter_mut().zip(readings).enumerate() {
        observable.value = reading + sigma * observable.sigma * draws.normal(20, row as u64);
    }
}

/// A case of `kind`; each seed has its own.
pub fn case(kind: Kind, seed: u64) -> Case {
    let draws = Draws::new(seed.wrapping_mul(1000).wrapping_add(kind as u64));
    let sigma_deg = 0.2 + 0.5 * draws.uniform(1, 0).powi(2) * 1.6;
    let mut toy = good_campaign(sigma_deg);
    let (hidden, families) = hidden(kind, draws);
    let mut nature = Nature::drawn(draws, hidden);
    if kind == Kind::NullRough {
        nature.background[..3].iter_mut().for_each(|error| *error *= 2.0);
    }
    let noise = if kind == Kind::NullQuiet { 1.3 } else { 1.0 };
    measure(&mut toy, &nature, draws, noise);
    if kind == Kind::NullOutlier {
        let row = (draws.uniform(2, 0) * 90.0) as usize;
        toy.observables[row].value += 8.0 * sigma_deg * draws.normal(2, 1).signum();
    }
    Case {
        seed,
        toy,
        nature,
        families,
    }
}

fn hidden(kind: Kind, draws: Draws) -> (Vec<Hidden>, Vec<&'static str>) {
    let twins: Vec<&str> = TWINS.concat();
    let names: Vec<usize> = (0..EFFECTS.len())
        .filter(|&k| !twins.contains(&EFFECTS[k].name))
        .collect();
    let pick = |k: u64| names[(draws.uniform(3, k) * names.len() as f64) as usize];
    match kind {
        Kind::Null | Kind::NullQuiet | Kind::NullOutlier | Kind::NullRough => (Vec::new(), Vec::new()),
        Kind::Single => {
            let k = pick(0);
            (vec![effect(k, draws, 0)], vec![EFFECTS[k].family])
        }
        Kind::Pair => {
            let first = pick(0);
            let second = (1..50)
                .map(pick)
                .find(|&k| EFFECTS[k].family != EFFECTS[first].family)
                .expect("another");
            (
                vec![effect(first, draws, 0), effect(second, draws, 1)],
                vec![EFFECTS[first].family, EFFECTS[second].family],
            )
        }
        Kind::Twin => {
            let name = twins[(draws.uniform(3, 0) * twins.len() as f64) as usize];
            let k = EFFECTS
                .iter()
                .position(|effect| effect.name == name)
                .expect("a twin");
            (vec![effect(k, draws, 0)], vec![EFFECTS[k].family])
        }
        Kind::Novel => (vec![novel(draws)], Vec::new()),
    }
}

/// An effect with 0.4 to 2.4 times its scale.
fn effect(k: usize, draws: Draws, which: u64) -> Hidden {
    let known = &EFFECTS[k];
    let sign = if known.one_sided || draws.uniform(5, which) < 0.5 {
        1.0
    } else {
        -1.0
    };
    let strength = sign * known.scale * (0.4 + 2.0 * draws.uniform(4, which));
    match known.place {
        Some(_) => Hidden::Damage(0.16 + 0.62 * draws.uniform(6, which), strength),
        None => Hidden::Known(known.name, strength),
    }
}

fn novel(draws: Draws) -> Hidden {
    let place = 0.25 + 0.5 * draws.uniform(4, 0);
    let size = 0.6 + 0.8 * draws.uniform(4, 1);
    let sign = if draws.uniform(5, 0) < 0.5 { 1.0 } else { -1.0 };
    let powers = [
        [0.0, 0.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [2.0, 0.0],
        [1.0, 2.0],
        [2.0, 1.0],
    ];
    match (draws.uniform(3, 0) * 6.0) as usize {
        0..=2 => {
            let law = powers[(draws.uniform(3, 1) * 6.0) as usize];
            Hidden::Bump(place, sign * 4e-3 * size, law)
        }
        3 => Hidden::Onset(place, sign * 4e-3 * size, 22.0),
        4 => Hidden::Spring(place, 1.2e-2 * size),
        _ if sign > 0.0 => Hidden::Soft(place, 0.6 * size),
        _ => Hidden::Wave(1.5 * size),
    }
}
