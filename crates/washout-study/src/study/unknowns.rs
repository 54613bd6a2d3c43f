//! What a study may move, and where each of its unknowns acts.

use super::case::PreparedCase;
use super::error::StudyError;
use super::forward::{Observable, Unknown, UnknownKind};
use super::unnamed::UNNAMED;
use crate::effects::{Card, Effect, OWN_ERROR, Places, acting, named};
use crate::input::Design;
use crate::input::study::{LoadedStudy, Ruler, RulerKind, Uncertain};

/// Half-width of the range of an unknown that states none, in standard deviations.
const WIDE: f64 = 4.0;

/// The number by which an effect on the rod says where it begins, as a fraction of the rod's length.
const ALONG_ROD: &str = "from";

/// Where an unknown acts.
#[derive(Debug, Clone, PartialEq)]
pub enum Target {
    /// On a key of the designs of some cases.
    Key {
        /// Dotted key.
        key: String,
        /// Indices of the cases.
        cases: Vec<usize>,
    },
    /// On the strength of an effect that the designs lack, at a place of its own.
    Placed {
        /// Dotted key of the strength.
        key: String,
        /// Dotted key of the place.
        place: String,
        /// Index of the unknown that is the place.
        at: usize,
        /// Other numbers of the effect: dotted key, value.
        fixed: Vec<(String, f64)>,
        /// Indices of the cases.
        cases: Vec<usize>,
    },
    /// On the place of an effect.
    Place {
        /// Dotted key.
        key: String,
        /// Index of the unknown that is the effect's strength.
        strength: usize,
        /// Indices of the cases.
        cases: Vec<usize>,
    },
    /// On the reading of some observables.
    Ruler {
        /// What it does.
        kind: RulerKind,
        /// Indices of the observables.
        rows: Vec<usize>,
    },
}

/// The unknowns of a study with their targets.
#[derive(Debug, Clone, Default)]
pub struct Targets {
    /// The unknowns.
    pub unknowns: Vec<Unknown>,
    /// Where each acts.
    pub targets: Vec<Target>,
    /// Where each starts.
    pub start: Vec<f64>,
}

impl Target {
    /// Whether it acts on a case when the unknowns stand at `at`; the ruler acts on none.
    pub fn touches(&self, case: usize, at: &[f64]) -> bool {
        match self {
            Target::Key { cases, .. } | Target::Placed { cases, .. } => cases.contains(&case),
            Target::Place { cases, strength, .. } => at[*strength] != 0.0 && cases.contains(&case),
            Target::Ruler { .. } => false,
        }
    }

    /// The numbers of the design of a case that it sets to act with `value`: dotted key, number.
    pub fn sets(&self, case: usize, value: f64, at: &[f64]) -> Vec<(String, f64)> {
        match self {
            Target::Key { key, cases } if cases.contains(&case) => vec![(key.clone(), value)],
            Target::Placed {
                key,
                place,
                at: unknown,
                fixed,
                cases,
            } if cases.contains(&case) && value != 0.0 => {
                let mut sets = fixed.clone();
                sets.extend([(place.clone(), at[*unknown]), (key.clone(), value)]);
                sets
            }
            _ => Vec::new(),
        }
    }
}

impl Targets {
    /// Inputs first, then the ruler, then effects: those of the study, then the candidates; what has no name.
    ///
    /// # Errors
    /// If no design has an input, or it states no prior.
    pub fn new(
        study: &LoadedStudy,
        cases: &[PreparedCase],
        observables: &[Observable],
        candidates: &[&str],
    ) -> Result<Targets, StudyError> {
        let mut found = Targets::default();
        for uncertain in &study.study.uncertain {
            found.add_input(uncertain, cases)?;
        }
        for ruler in &study.study.ruler {
            found.add_ruler(ruler, observables);
        }
        for effect in &study.study.effect {
            let with_it = |case: &&PreparedCase| case.design.effects.contains_key(&effect.name);
            let Some(case) = cases.iter().find(with_it) else {
                let reason = format!("effect {} acts on none of the designs of the study", effect.name);
                return Err(StudyError::Unknown { reason });
            };
            let table = &case.design.effects[&effect.name];
            let known = acting(&effect.name, table, &case.design).map_err(|error| case.failed(error))?;
            let sigma = effect.sigma.unwrap_or(0.0);
            let has = |case: &PreparedCase| case.design.effects.contains_key(&effect.name);
            found.add_effect(&known.card(), cases, (effect.strength, sigma), has);
        }
        for name in candidates {
            if !study.study.effect.iter().any(|effect| effect.name == *name)
                && let Some(effect) = named(name)
            {
                match effect.places() {
                    Some(places) => found.add_places(effect, &places, cases),
                    None => {
                        let card = effect.card();
                        let sigma = 1.5 * card.parameters[0].scale();
                        found.add_effect(&card, cases, (0.0, sigma), |case| case.tries(name));
                    }
                }
            }
        }
        if !candidates.is_empty() {
            found.add_unnamed(cases);
        }
        Ok(found)
    }

    /// Causes without a name, off.
    fn add_unnamed(&mut self, cases: &[PreparedCase]) {
        for cause in &UNNAMED {
            let measures = cases.iter().map(|case| cause.measure(&case.design));
            let measure = measures.fold(0.0, f64::max);
            for (order, number) in cause.all_numbers().enumerate() {
                let key = cause.key(number);
                let has = |&index: &usize| cases[index].design.get(&key).is_some();
                let touched: Vec<usize> = (0..cases.len()).filter(has).collect();
                if touched.is_empty() || measure == 0.0 {
                    continue;
                }
                let unit = if order == 0 { measure } else { 1.0 };
                let unknown = Unknown {
                    name: key.clone(),
                    unit: number.unit.to_string(),
                    kind: UnknownKind::Unnamed {
                        cause: cause.name.to_string(),
                    },
                    mean: number.mean,
                    sigma: number.sigma * unit,
                    range: number.range.map(|end| end * unit),
                };
                self.add(unknown, Target::Key { key, cases: touched }, number.mean);
            }
        }
    }

    fn add(&mut self, unknown: Unknown, target: Target, start: f64) {
        self.unknowns.push(unknown);
        self.targets.push(target);
        self.start.push(start);
    }

    fn add_input(&mut self, uncertain: &Uncertain, cases: &[PreparedCase]) -> Result<(), StudyError> {
        let key = &uncertain.key;
        let concerns = |case: &PreparedCase| {
            let designs = uncertain.designs.as_ref();
            designs.is_none_or(|designs| designs.contains(&case.design.name))
                && case.design.get(key).is_some()
        };
        let touched: Vec<usize> = (0..cases.len())
            .filter(|&index| concerns(&cases[index]))
            .collect();
        let Some(&first) = touched.first() else {
            let reason = format!("uncertain {key}: no design of the study has a number there");
            return Err(StudyError::Unknown { reason });
        };
        let design = &cases[first].design;
        let assumed = design
            .assumptions()
            .into_iter()
            .find(|assumption| assumption.key == *key);
        let own = design.get(key).unwrap_or_default();
        let mean = uncertain.mean.unwrap_or(own);
        let width = assumed
            .as_ref()
            .map(|a| (a.range[1] - a.range[0]) / 12.0_f64.sqrt());
        let stated = uncertain.range.map(|[low, high]| (high - low) / 12.0_f64.sqrt());
        let Some(sigma) = uncertain.sigma.or(stated).or(width).filter(|sigma| *sigma > 0.0) else {
            let reason = format!(
                "uncertain {key}: the designs state it as a fact, so give the sigma of its prior here, or its range"
            );
            return Err(StudyError::Unknown { reason });
        };
        let wide = [mean - WIDE * sigma, mean + WIDE * sigma];
        let unknown = Unknown {
            name: key.clone(),
            unit: unit_of(key),
            kind: UnknownKind::Input,
            mean,
            sigma,
            range: uncertain.range.or(assumed.map(|a| a.range)).unwrap_or(wide),
        };
        let target = Target::Key {
            key: key.clone(),
            cases: touched,
        };
        self.add(unknown, target, mean);
        Ok(())
    }

    /// One nuisance for the runs that are named, or one for every run.
    fn add_ruler(&mut self, ruler: &Ruler, observables: &[Observable]) {
        let mut groups: Vec<Vec<String>> = Vec::new();
        match &ruler.runs {
            Some(runs) => groups.push(runs.clone()),
            None => {
                for observable in observables.iter().filter(|o| o.channel == ruler.channel) {
                    let own = vec![observable.run.clone()];
                    if !groups.contains(&own) {
                        groups.push(own);
                    }
                }
            }
        }
        for runs in groups {
            let belongs = |o: &Observable| o.channel == ruler.channel && runs.contains(&o.run);
            let rows: Vec<usize> = (0..observables.len())
                .filter(|&row| belongs(&observables[row]))
                .collect();
            let (word, unit) = match ruler.kind {
                RulerKind::Offset => ("offset", ruler.channel.unit()),
                RulerKind::Scale => ("scale", "1"),
            };
            let of = match runs.join(", ") {
                names if names.is_empty() => String::new(),
                names if runs.len() > 1 => format!(" of runs {names}"),
                names => format!(" of run {names}"),
            };
            if rows.is_empty() {
                continue;
            }
            let unknown = Unknown {
                name: format!("{word} of {}{of}", ruler.channel.name()),
                unit: unit.to_string(),
                kind: UnknownKind::Ruler,
                mean: 0.0,
                sigma: ruler.sigma,
                range: [-10.0 * ruler.sigma, 10.0 * ruler.sigma],
            };
            let kind = ruler.kind;
            self.add(unknown, Target::Ruler { kind, rows }, 0.0);
        }
    }

    /// An effect in the cases that have it; nowhere, no unknown. Without a sigma it is held.
    fn add_effect(
        &mut self,
        card: &Card,
        cases: &[PreparedCase],
        (strength, sigma): (f64, f64),
        has: impl Fn(&PreparedCase) -> bool,
    ) {
        let touched: Vec<usize> = (0..cases.len()).filter(|&index| has(&cases[index])).collect();
        if touched.is_empty() || sigma == 0.0 {
            return;
        }
        let key = format!("effects.{}.strength", card.name);
        let unknown = strength_of(card, key.clone(), sigma);
        self.add(unknown, Target::Key { key, cases: touched }, strength);
    }

    /// An effect that the designs lack, at each of its places, on all wings and on each alone: a strength, and where it sits, for
    /// each.
    fn add_places(&mut self, effect: &dyn Effect, places: &Places, cases: &[PreparedCase]) {
        let card = effect.card();
        let has = |index: &usize| cases[*index].tries(card.name);
        let all: Vec<usize> = (0..cases.len()).filter(has).collect();
        let wing_of = |index: usize| cases[index].design.name.as_str();
        let mut wings: Vec<&str> = all.iter().map(|&index| wing_of(index)).collect();
        wings.sort_unstable();
        wings.dedup();
        if wings.len() == 1 || !places.of_one_wing {
            wings.clear();
        }
        let spars_of = |index: usize| cases[index].design.spar.len();
        let most = all.iter().map(|&index| spars_of(index)).max().unwrap_or(0);
        let spars: Vec<Option<usize>> = match places.spar {
            Some(_) => (0..most).map(Some).collect(),
            None => vec![None],
        };
        for wing in [None].into_iter().chain(wings.into_iter().map(Some)) {
            for &spar in &spars {
                let is_on = |index: &&usize| {
                    wing.is_none_or(|wing| wing == wing_of(**index))
                        && spar.is_none_or(|spar| spar < spars_of(**index))
                };
                let touched: Vec<usize> = all.iter().filter(is_on).copied().collect();
                if touched.is_empty() {
                    continue;
                }
                let rod_mm = rod_mm(touched.iter().map(|&index| &cases[index].design));
                for &place in places.at {
                    let at = (place, spar, wing);
                    self.add_place(&card, places, at, rod_mm, touched.clone());
                }
            }
        }
    }

    /// An effect near `place`, on the spar and the wing that are named.
    fn add_place(
        &mut self,
        card: &Card,
        places: &Places,
        (place, spar, wing): (f64, Option<usize>, Option<&str>),
        rod_mm: Option<f64>,
        cases: Vec<usize>,
    ) {
        let key = |parameter: usize| format!("effects.{}.{}", card.name, card.parameters[parameter].name);
        let parameter = &card.parameters[places.parameter];
        let counts = places.spar.zip(spar);
        let of_spar = spar.map_or(String::new(), |spar| format!(" spar {spar}"));
        let on_wing = wing.map_or(String::new(), |wing| format!(" on {wing}"));
        let name = format!("{},{of_spar} {} {place}{on_wing}", key(0), parameter.name);
        let (strength, at) = (self.unknowns.len(), self.unknowns.len() + 1);
        let target = Target::Placed {
            key: key(0),
            place: key(places.parameter),
            at,
            fixed: counts
                .iter()
                .map(|&(counts, spar)| (key(counts), spar as f64))
                .collect(),
            cases: cases.clone(),
        };
        let unknown = strength_of(card, name.clone(), 1.5 * card.parameters[0].scale());
        self.add(unknown, target, 0.0);
        let [low, high] = parameter.plausible;
        let numbers = counts
            .iter()
            .map(|&(counts, spar)| (card.parameters[counts].name.to_string(), spar as f64));
        let unknown = Unknown {
            name: format!("{},{of_spar} near {place}{on_wing}", key(places.parameter)),
            unit: parameter.unit.to_string(),
            kind: UnknownKind::Place {
                of: name,
                parameter: parameter.name.to_string(),
                numbers: numbers.collect(),
                wing: wing.map(str::to_string),
                rod_mm: rod_mm.filter(|_| parameter.name == ALONG_ROD),
            },
            mean: place,
            sigma: places.reach,
            range: [
                (place - 2.0 * places.reach).max(low.min(place)),
                (place + 2.0 * places.reach).min(high.max(place)),
            ],
        };
        let key = key(places.parameter);
        self.add(unknown, Target::Place { key, strength, cases }, place);
    }
}

/// Length of the rod, mm; none where designs differ in it.
fn rod_mm<'a>(designs: impl Iterator<Item = &'a Design>) -> Option<f64> {
    let mut lengths = designs.map(|design| design.rod.last().map(|last| last.to_mm.value()));
    let first = lengths.next()??;
    lengths.all(|other| other == Some(first)).then_some(first)
}

/// The strength of an effect, as an unknown of that name.
fn strength_of(card: &Card, name: String, sigma: f64) -> Unknown {
    let parameter = &card.parameters[0];
    Unknown {
        name,
        unit: parameter.unit.to_string(),
        kind: UnknownKind::Effect {
            effect: card.name.to_string(),
            family: card.family.to_string(),
            scale: parameter.scale(),
            plausible: parameter.plausible,
            one_sided: parameter.is_one_sided(),
            has_switch: card.has_switch,
            all_or_none: named(card.name).is_some_and(|effect| effect.is_all_or_none()),
            own_error: named(card.name).map_or(OWN_ERROR, |effect| effect.own_error()),
        },
        mean: 0.0,
        sigma,
        range: parameter.range,
    }
}

/// Unit in the name of a key; `1` if there is none.
fn unit_of(key: &str) -> String {
    let last = key.rsplit('.').next().unwrap_or(key);
    crate::input::unit_symbol(last).unwrap_or("1").to_string()
}
