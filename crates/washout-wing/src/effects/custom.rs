//! An effect of the user's own: a formula over span, chord, angle and speed, for a moment, a force or a factor.
//!
//! ```toml
//! [effects.hinge-drag]
//! kind = "custom"
//! acts_on = "moment"
//! expression = "k * q * chord^2 * x"
//! strength = 1.0
//! k = { assumed = 0.1, range = [0.0, 0.5], why = "seen on another wing" }
//! units = { k = "1" }
//! ```

mod target;

mod section;

mod trial;

pub use target::VARIABLES;

use num_dual::DualNum;

use section::Section;
use target::{ALONG, ALPHA, CHORD, PRESSURE, SPEED, TARGETS, TWIST, TWIST_RATE, Target};

use super::card::{Card, Need, Parameter, STRUCTURE_CHANNELS, Seam, WING_CHANNELS, number};
use super::{Dual, Effect, EffectError, StripPlace, Structure, Values};
use crate::aero::{SectionAir, SectionCoefficients};
use crate::geometry::Planform;
use crate::input::Expression;
use crate::input::design::Design;
use crate::structure::StructureError;

/// Keys of its table that are no numbers of the formula.
const KEYS: [&str; 6] = ["kind", "acts_on", "expression", "strength", "units", "summary"];

/// An effect of the user's own.
#[derive(Debug, Clone, PartialEq)]
pub struct Custom {
    name: String,
    summary: String,
    target: Target,
    formula: Expression,
    /// Numbers of the formula, behind [`VARIABLES`].
    numbers: Vec<f64>,
}

const STRENGTH: &[Parameter] = &[Parameter {
    name: "strength",
    unit: "1",
    meaning: "share of the formula that acts: 1 is the formula as it is written",
    default: 0.0,
    range: [-1e3, 1e3],
    plausible: [-1.0, 1.0],
}];

impl Custom {
    /// Whether a table of this name is an effect of the user's own.
    pub fn is_own(name: &str, table: &toml::Table) -> bool {
        name == "custom" || table.get("kind").is_some()
    }

    /// A table of such an effect, but for its strength and its numbers.
    pub fn table(acts_on: &str, expression: &str) -> toml::Table {
        [
            ("kind", "custom"),
            ("acts_on", acts_on),
            ("expression", expression),
        ]
        .map(|(key, value)| (key.to_string(), toml::Value::String(value.to_string())))
        .into_iter()
        .collect()
    }

    /// Reads its table and tries its formula on the wing.
    ///
    /// # Errors
    /// If a key is missing or wrong, or the formula cannot be read or computed.
    pub fn read(name: &str, table: &toml::Table, design: &Design) -> Result<(Custom, Values), EffectError> {
        let (own, values) = Custom::parse(name, table)?;
        own.try_out(design, values.strength())?;
        Ok((own, values))
    }

    /// Reads its table.
    ///
    /// # Errors
    /// If a key is missing or wrong, or the formula cannot be read.
    pub(super) fn parse(name: &str, table: &toml::Table) -> Result<(Custom, Values), EffectError> {
        let fail = |(key, problem, cure): Fault| EffectError::Own {
            name: name.to_string(),
            key,
            problem,
            cure,
        };
        let (target, meaning) = target_of(table).map_err(fail)?;
        let Some(text) = table.get("expression").and_then(toml::Value::as_str) else {
            let cure = "give a formula in quotes, e.g. expression = \"0.1 * q * chord^2 * x\"".to_string();
            return Err(fail(fault("expression", "there is no formula", cure)));
        };
        let own: Vec<&String> = table.keys().filter(|key| !KEYS.contains(&key.as_str())).collect();
        let numbers = own_numbers(table, &own).map_err(fail)?;
        let names: Vec<&str> = VARIABLES
            .iter()
            .copied()
            .chain(own.iter().map(|key| key.as_str()))
            .collect();
        let formula = Expression::parse(text, &names).map_err(|error| EffectError::Formula {
            name: name.to_string(),
            error,
        })?;
        uses_what_it_may(&formula, &names, target).map_err(fail)?;
        let strength = table
            .get("strength")
            .and_then(number)
            .ok_or_else(|| EffectError::NoStrength {
                name: name.to_string(),
                meaning: STRENGTH[0].meaning.to_string(),
                example: 1.0,
            })?;
        let [low, high] = STRENGTH[0].range;
        if !(low <= strength && strength <= high) {
            let cure = format!("keep it within {low} … {high}, and the size of the effect in the formula");
            return Err(fail(fault("strength", format!("{strength} is too large"), cure)));
        }
        let custom = Custom {
            name: name.to_string(),
            summary: match table.get("summary").and_then(toml::Value::as_str) {
                Some(summary) => summary.to_string(),
                None => format!("The user's own: {meaning}."),
            },
            target,
            formula,
            numbers,
        };
        Ok((custom, Values(vec![strength])))
    }

    /// Factor of a beam's stiffness in its middle; of a spar `along` it.
    fn factor(
        &self,
        wing: &Structure,
        beam: usize,
        planform: Option<&Planform>,
        along: f64,
        strength: f64,
    ) -> f64 {
        let ends = wing.mesh.beams[beam].nodes;
        let middle_m = 0.5 * ends.iter().map(|&node| wing.mesh.nodes[node][0]).sum::<f64>();
        let mut at = self.constants(wing.design, middle_m);
        at[CHORD] = planform.map_or(0.0, |planform| planform.chord_m(middle_m));
        at[ALONG] = along;
        1.0 + strength * (self.formula.value(&at) - 1.0)
    }

    fn change_spars(&self, strength: f64, wing: &mut Structure) -> Result<(), StructureError> {
        let planform = self.planform(wing.design);
        for spar in 0..wing.mesh.spar_count() {
            let elements = wing.spar_elements(spar);
            let length_m = elements.last().map_or(0.0, |(_, [_, end_m])| *end_m);
            for (beam, [from_m, to_m]) in elements {
                let along = 0.5 * (from_m + to_m) / length_m;
                let factor = self.factor(wing, beam, planform.as_ref(), along, strength);
                wing.model
                    .change_section(beam, |section| section.soften(1.0 / factor - 1.0))?;
            }
        }
        Ok(())
    }

    /// The variables on a strip, then the numbers.
    fn on_strip(&self, section: &Section, alpha: Dual, speed_squared: Dual) -> Vec<Dual> {
        let constants = self.constants(section.design, section.r_m).into_iter();
        let mut at: Vec<Dual> = constants.map(Dual::from).collect();
        at[CHORD] = Dual::from(section.chord_m);
        at[ALPHA] = alpha;
        at[TWIST] = -alpha + section.root_angle_rad;
        at[TWIST_RATE] = Dual::from(section.twist_rate_rad_s);
        // in still air the speed has no derivative, and its square none but zero
        if speed_squared.re != 0.0 {
            if speed_squared.re.is_nan() || speed_squared.re > 0.0 {
                at[SPEED] = speed_squared.sqrt();
            }
            at[PRESSURE] = speed_squared * (0.5 * section.density_kg_m3);
        }
        at
    }

    /// The variables with those known that do not depend on the air, then the numbers.
    fn constants(&self, design: &Design, r_m: f64) -> Vec<f64> {
        let mut at = vec![0.0; VARIABLES.len()];
        (at[0], at[1]) = (r_m / (design.planform.length_mm.value() * 1e-3), r_m);
        at[8] = design.air.density_kg_m3.value();
        if let Some(flapping) = &design.flapping {
            at[9] = flapping.frequency_hz.value();
            at[10] = flapping.half_amplitude_deg.value().to_radians();
            at[11] = flapping.phase_deg.value().to_radians();
        }
        at.extend(&self.numbers);
        at
    }
}

/// What is wrong with a table: the key, the problem, the cure.
type Fault = (String, String, String);

fn fault(key: &str, problem: impl Into<String>, cure: String) -> Fault {
    (key.to_string(), problem.into(), cure)
}

/// What a table acts on, and what that means.
fn target_of(table: &toml::Table) -> Result<(Target, &'static str), Fault> {
    if let Some(kind) = table.get("kind")
        && kind.as_str() != Some("custom")
    {
        let cure = "write kind = \"custom\" for an effect of your own".to_string();
        return Err(fault("kind", format!("{kind} is no kind of effect"), cure));
    }
    let words = TARGETS.map(|(word, _, _)| word).join(", ");
    let word = table
        .get("acts_on")
        .and_then(toml::Value::as_str)
        .unwrap_or_default();
    match TARGETS.iter().find(|(known, _, _)| *known == word) {
        Some((_, target, meaning)) => Ok((*target, meaning)),
        None => {
            let cure = format!("write one of {words}");
            Err(fault(
                "acts_on",
                format!("'{word}' is nothing it can act on"),
                cure,
            ))
        }
    }
}

/// The numbers of a formula, under keys of the user's own.
fn own_numbers(table: &toml::Table, own: &[&String]) -> Result<Vec<f64>, Fault> {
    let mut numbers = Vec::new();
    for key in own {
        if VARIABLES.contains(&key.as_str()) {
            let cure = format!("{key} is known to every formula; give your number another name");
            return Err(fault(key, "the name is taken", cure));
        }
        numbers.push(own_number(&table[*key]).map_err(|(problem, cure)| fault(key, problem, cure))?);
    }
    Ok(numbers)
}

/// Refuses a formula that leaves one of its numbers out, or depends on what its target does not know.
fn uses_what_it_may(formula: &Expression, names: &[&str], target: Target) -> Result<(), Fault> {
    if let Some(place) = (VARIABLES.len()..names.len()).find(|place| !formula.uses(*place)) {
        let cure = format!("use {} in the expression, or delete it", names[place]);
        return Err(fault(names[place], "the formula does not use it", cure));
    }
    let (part, known) = target.knows();
    let stranger = |place: &usize| formula.uses(*place) && !known.contains(&VARIABLES[*place]);
    if let Some(place) = (0..VARIABLES.len()).find(stranger) {
        let cure = format!("the formula of a {part} may depend on {}", known.join(", "));
        let problem = format!("a {part} has no {}", VARIABLES[place]);
        return Err(fault("expression", problem, cure));
    }
    Ok(())
}

/// A number, stated or assumed within its range.
fn own_number(value: &toml::Value) -> Result<f64, (String, String)> {
    let cure = "write a number, or { assumed = 1.0, range = [0.5, 2.0], why = \"...\" }";
    let found = number(value).ok_or_else(|| (format!("{value} is no number"), cure.to_string()))?;
    if !found.is_finite() {
        return Err((format!("{found} is no number"), cure.to_string()));
    }
    let ends = value.get("range").and_then(toml::Value::as_array);
    let ends: Option<Vec<f64>> = ends.map(|ends| ends.iter().filter_map(number).collect());
    match ends.as_deref() {
        Some(&[low, high]) if !(low <= found && found <= high) => {
            let cure = "assume a value inside it, or widen the range".to_string();
            Err((format!("{found} lies outside its own range {low} … {high}"), cure))
        }
        _ => Ok(found),
    }
}

impl Effect for Custom {
    fn card(&self) -> Card<'_> {
        let (_, _, meaning) = TARGETS
            .iter()
            .find(|(_, target, _)| *target == self.target)
            .unwrap_or(&TARGETS[0]);
        Card {
            name: &self.name,
            family: "user's own",
            summary: &self.summary,
            formula: &self.formula.text,
            source: "the user's design file",
            when_right: meaning,
            gets_wrong: "whatever its author overlooked",
            case: "a_formula_of_ones_own_does_what_it_says",
            seam: match self.target {
                target if target.is_stiffness() => Seam::Structure,
                _ => Seam::Air,
            },
            parameters: STRENGTH,
            channels: match self.target {
                target if target.is_stiffness() => STRUCTURE_CHANNELS,
                _ => WING_CHANNELS,
            },
            needs: match self.target {
                Target::Torsion | Target::Bending => &[],
                Target::Spars => &[Need::Spars],
                _ if self.formula.uses(TWIST_RATE) => &[Need::Motion],
                Target::Lift | Target::Drag | Target::CentreOfPressure => &[Need::Flow],
                _ => &[],
            },
            has_switch: false,
        }
    }

    fn is_of_moment(&self) -> bool {
        matches!(self.target, Target::Moment | Target::CentreOfPressure)
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let parts = match self.target {
            Target::Torsion => 3..4,
            Target::Bending => 4..6,
            Target::Spars => return self.change_spars(values.strength(), wing),
            _ => return Ok(()),
        };
        let planform = self.planform(wing.design);
        for (beam, _) in wing.rod_elements() {
            let factor = self.factor(wing, beam, planform.as_ref(), 0.0, values.strength());
            wing.model.change_section(beam, |section| {
                for part in parts.clone() {
                    for k in 0..6 {
                        section.compliance[(part, k)] *= factor.powf(-0.5);
                        section.compliance[(k, part)] *= factor.powf(-0.5);
                    }
                }
            })?;
        }
        Ok(())
    }

    fn coefficients(
        &self,
        values: &Values,
        place: &StripPlace,
        air: &SectionAir<Dual>,
        now: &mut SectionCoefficients<Dual>,
    ) {
        let at = self.on_strip(&Section::of(place), air.alpha, air.speed_squared);
        let value = self.formula.value(&at) * values.strength();
        let factor = value - values.strength() + 1.0;
        match self.target {
            Target::Moment => now.moment_n += value,
            Target::Force => now.normal_n_per_m += value,
            Target::Lift => now.cl *= factor,
            Target::Drag => now.cd *= factor,
            Target::CentreOfPressure => {
                let moved = now.centre_of_pressure + value;
                now.centre_of_pressure = match moved.re {
                    x if x < 0.02 => Dual::from(0.02),
                    x if x > 0.98 => Dual::from(0.98),
                    _ => moved,
                };
            }
            Target::Torsion | Target::Bending | Target::Spars => {}
        }
    }
}
