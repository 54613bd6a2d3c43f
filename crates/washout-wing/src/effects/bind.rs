//! From the raw tables `[effects.NAME]` of a design to effects with checked numbers.

use std::sync::Arc;

use super::card::{Card, Need, number};
use super::custom::Custom;
use super::error::EffectError;
use super::seam::Values;
use super::{Effect, all, named};
use crate::input::design::{Design, FilmCompression, Kinematics, Section};
use crate::input::nearest;
use crate::structure::StructureError;

/// An effect that is on.
#[derive(Debug, Clone)]
pub struct Bound {
    /// The effect.
    pub effect: Acting,
    /// Its numbers.
    pub values: Values,
}

/// An effect of [`all`], or of the user's own.
#[derive(Debug, Clone)]
pub enum Acting {
    /// One that the program knows.
    Known(&'static dyn Effect),
    /// One of the user's own.
    Own(Arc<Custom>),
}

impl std::ops::Deref for Acting {
    type Target = dyn Effect;

    fn deref(&self) -> &Self::Target {
        match self {
            Acting::Known(effect) => *effect,
            Acting::Own(effect) => effect.as_ref(),
        }
    }
}

/// What the strength of an effect is on this wing as something that a bench measures: the number, and its unit with what it is; none if it is
/// nothing of the kind, or the effect is not on.
pub fn stands_for(design: &Design, effect: &str) -> Option<(f64, String)> {
    let bound = bind(design).ok()?;
    let own = bound.iter().find(|own| own.effect.card().name == effect)?;
    let (value, unit) = own.effect.stands_for(&own.values, design)?;
    Some((value, unit.to_string()))
}

/// The effects of a design whose strength is not 0, in the order of [`all`] whatever the order in the file;
/// those of the user's own behind, by name.
///
/// # Errors
/// If a table names no effect, a number is unknown, missing, no number or out of range, or the design lacks what the
/// effect acts on.
pub fn bind(design: &Design) -> Result<Vec<Bound>, EffectError> {
    for (name, table) in &design.effects {
        if named(name).is_none() && !Custom::is_own(name, table) {
            return Err(unknown(name));
        }
    }
    let mut bound = Vec::new();
    for effect in all() {
        let card = effect.card();
        let Some(table) = design.effects.get(card.name) else {
            continue;
        };
        let values = read(&card, table)?;
        if values.strength() == 0.0 {
            continue;
        }
        if let Some(reason) = lacks(&card, design) {
            let name = card.name.to_string();
            return Err(EffectError::NotApplicable { name, reason });
        }
        bound.push(Bound {
            effect: Acting::Known(effect),
            values,
        });
    }
    for (name, table) in &design.effects {
        if named(name).is_some() {
            continue;
        }
        let (own, values) = Custom::parse(name, table)?;
        if values.strength() == 0.0 {
            continue;
        }
        own.try_out(design, values.strength())?;
        if let Some(reason) = lacks(&own.card(), design) {
            let name = name.clone();
            return Err(EffectError::NotApplicable { name, reason });
        }
        bound.push(Bound {
            effect: Acting::Own(Arc::new(own)),
            values,
        });
    }
    Ok(bound)
}

/// The effect that a table of a design stands for, whether it is on or not.
///
/// # Errors
/// If there is none of this name, or one of the user's own cannot be read.
pub fn acting(name: &str, table: &toml::Table, design: &Design) -> Result<Acting, EffectError> {
    match named(name) {
        Some(effect) => Ok(Acting::Known(effect)),
        None if Custom::is_own(name, table) => {
            Ok(Acting::Own(Arc::new(Custom::read(name, table, design)?.0)))
        }
        None => Err(unknown(name)),
    }
}

/// Adds to the table of an effect the numbers that all wings of a study have in common, as far as it does not state them; `first`: the
/// first wing of the study.
///
/// # Errors
/// If a section of that is none.
pub fn with_common_numbers(
    name: &str,
    table: &mut toml::Table,
    first: &Design,
) -> Result<(), StructureError> {
    let Some(effect) = named(name) else {
        return Ok(());
    };
    for (number, value) in effect.common_numbers(first)? {
        table.entry(number).or_insert(toml::Value::Float(value));
    }
    Ok(())
}

/// Whether an effect has something to act on in a design.
pub fn is_applicable(card: &Card, design: &Design) -> bool {
    lacks(card, design).is_none()
}

/// What to say where no effect has this name: the nearest, or all that there are.
pub fn instead_of(name: &str) -> String {
    let names: Vec<&str> = all().map(|effect| effect.card().name).collect();
    // the beginning of a name, whatever stands between its words, or a part of it
    let plain = |text: &str| text.to_lowercase().replace(['-', '_', ' '], "");
    let starts = names
        .iter()
        .copied()
        .find(|known| plain(known).starts_with(&plain(name)));
    let holds = || names.iter().copied().find(|known| known.contains(name));
    let near = starts
        .filter(|_| !plain(name).is_empty())
        .or_else(|| nearest(name, names.iter().copied()));
    match near.or_else(|| holds().filter(|_| name.len() > 2)) {
        Some(near) => format!("did you mean {near}? (washout effects)"),
        None => format!("there are {} (washout effects)", names.join(", ")),
    }
}

fn unknown(name: &str) -> EffectError {
    let cure = match instead_of(name) {
        near if near.starts_with("did") => near,
        all => format!("write kind = \"custom\" for one of your own; {all}"),
    };
    EffectError::Unknown {
        name: name.to_string(),
        cure,
    }
}

fn read(card: &Card, table: &toml::Table) -> Result<Values, EffectError> {
    let name = card.name.to_string();
    let known = |key: &String| card.parameters.iter().any(|parameter| parameter.name == key);
    if let Some(key) = table.keys().find(|key| !known(key)) {
        let known: Vec<&str> = card.parameters.iter().map(|parameter| parameter.name).collect();
        return Err(EffectError::UnknownKey {
            name,
            key: key.clone(),
            known: known.join(", "),
        });
    }
    let mut values = Vec::new();
    for (place, parameter) in card.parameters.iter().enumerate() {
        let [low, high] = parameter.range;
        let value = match table.get(parameter.name) {
            Some(value) => number(value).ok_or_else(|| EffectError::NoNumber {
                name: name.clone(),
                key: parameter.name.to_string(),
                value: value.to_string(),
                meaning: parameter.meaning.to_string(),
                example: parameter.scale(),
            })?,
            None if place == 0 => {
                return Err(EffectError::NoStrength {
                    name,
                    meaning: parameter.meaning.to_string(),
                    example: parameter.scale(),
                });
            }
            None => parameter.default,
        };
        if !(low <= value && value <= high) {
            return Err(EffectError::OutOfRange {
                name,
                key: parameter.name.to_string(),
                value,
                low,
                high,
                unit: if parameter.unit == "1" {
                    String::new()
                } else {
                    format!(" {}", parameter.unit)
                },
                meaning: parameter.meaning.to_string(),
            });
        }
        values.push(value);
    }
    Ok(Values(values))
}

/// What a design lacks for an effect to act in it; none if it can.
pub fn lacks(card: &Card, design: &Design) -> Option<String> {
    let lacking = |need: &Need| {
        let (has, words) = meets(design, need);
        (!has).then(|| words.to_string())
    };
    card.needs.iter().find_map(lacking)
}

/// Whether a design has what is needed, and what to say if not.
fn meets(design: &Design, need: &Need) -> (bool, &'static str) {
    match need {
        Need::Flow => (
            design.flapping.is_some() || design.steady.is_some(),
            "there is no air in this design",
        ),
        Need::Flapping => (design.flapping.is_some(), "the wing does not flap"),
        Need::Stream => (
            design.flapping.is_none() && design.steady.is_some(),
            "the wing is in no steady stream",
        ),
        Need::Motion => (design.flapping.is_some(), "the wing does not flap"),
        Need::OffMidStroke => (
            (design.flapping.as_ref()).is_some_and(|flapping| flapping.phase_deg.value() != 0.0),
            "the wing is looked at in mid-stroke (flapping.phase_deg = 0), where it does not act",
        ),
        Need::Film => (design.film.is_some(), "the wing has no film"),
        Need::WrinklingFilm => (
            film_kept(design).is_some_and(|kept| kept < 1.0),
            "the wing has no film that wrinkles",
        ),
        Need::CarryingFilm => (
            film_kept(design).is_some_and(|kept| kept == 1.0),
            "the wing has no film that carries compression (film.compression = \"carries\")",
        ),
        Need::Spars => (!design.spar.is_empty(), "the wing has no spars"),
        Need::HalfRound => (
            (design.rod.iter()).any(|rod| matches!(rod.section, Section::HalfRound { .. })),
            "the wing has no half-round rod",
        ),
        Need::ShapedRod => (
            (design.rod.iter()).any(|rod| !matches!(rod.section, Section::Given { .. })),
            "the stiffnesses of the wing's rods are given, with whatever is bonded to them and however they are held",
        ),
        Need::SolidRod => (
            design.rod.iter().any(|rod| is_solid(&rod.section)),
            "the wing has no solid rod: its rods are tubes, or given as stiffnesses",
        ),
        Need::Linear => (
            design.structure.kinematics == Kinematics::Linear,
            "the model has large rotation already (structure.kinematics is not linear)",
        ),
        Need::Gravity => (
            design.gravity.is_some() || is_on(design, "gravity") || is_on(design, "centrifugal-load"),
            "mass is not felt in this design: it has no gravity, nor the effect gravity or centrifugal-load",
        ),
        Need::SoftRoot => (
            design.root.pitch_stiffness_n_m_per_rad.is_some(),
            "the root is rigid in pitch (root.pitch_stiffness_n_m_per_rad is missing)",
        ),
        Need::Camera => (
            design.observation.camera_axis.is_some(),
            "no camera looks at this wing (observation.camera_axis is missing)",
        ),
    }
}

/// Share of its stiffness that the film keeps where it is compressed; none without a film.
fn film_kept(design: &Design) -> Option<f64> {
    let film = design.film.as_ref()?;
    Some(match film.compression {
        FilmCompression::TensionField => film.residual_compression.value(),
        FilmCompression::Carries => 1.0,
    })
}

/// Whether an effect of this name has a strength.
fn is_on(design: &Design, effect: &str) -> bool {
    let table = design.effects.get(effect);
    let strength = table.and_then(|table| number(table.get("strength")?));
    strength.is_some_and(|strength| strength != 0.0)
}

fn is_solid(section: &Section) -> bool {
    !matches!(section, Section::Tube { .. } | Section::Given { .. })
}
