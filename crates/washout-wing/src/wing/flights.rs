//! Wings and profiles flown side by side, with amplitudes at which each flaps besides.

use std::path::PathBuf;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::input::Design;
use crate::lift::{Flight, LiftError};
use crate::progress::Progress;

use super::error::WingError;
use super::flown::{Flown, TwistSource, can_fly, is_profile, of_design, of_profile};
use super::model::WingModel;

/// What is to be flown, and how.
#[derive(Debug, Clone)]
pub struct Flights {
    /// Designs, and twist profiles as CSV.
    pub files: Vec<PathBuf>,
    /// The wing that ratios refer to; the first where none is named.
    pub reference: Option<PathBuf>,
    /// Design whose outline, air and stroke the profiles fly with; the first design where none is named.
    pub on: Option<PathBuf>,
    /// Keys set in every design.
    pub sets: Vec<String>,
    /// Where the twist of the designs comes from.
    pub source: TwistSource,
    /// Phases of the stroke that are solved for [`TwistSource::Phases`].
    pub phases: u16,
    /// Amplitudes besides each wing's own.
    pub sweep: Option<Amplitudes>,
}

/// Amplitudes at which wings flap besides their own, evenly from one to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Amplitudes {
    /// How many, 2 or more.
    pub count: u16,
    /// The half amplitudes, deg; from 70 to 130 % of each wing's own where none are given.
    pub from_to_deg: Option<[f64; 2]>,
}

/// Wings that flew.
#[derive(Debug, Clone)]
pub struct Flew {
    /// The wings, in the order of their files; the reference first where it is not among them.
    pub wings: Vec<Flown>,
    /// Which of them ratios refer to.
    pub reference: usize,
}

/// Wings that are read and checked, before their twist is known.
#[derive(Debug)]
pub struct ReadyToFly {
    wings: Vec<Ready>,
    reference: usize,
}

#[derive(Debug)]
enum Ready {
    Design(Box<WingModel>),
    Profile(Box<Flown>),
}

impl Amplitudes {
    /// Parts of a wing's own amplitude, which is so many degrees.
    fn parts(&self, own_deg: Option<f64>) -> Vec<f64> {
        let [from, to] = match (self.from_to_deg, own_deg) {
            (Some([from, to]), Some(own)) if own > 0.0 => [from / own, to / own],
            (Some(given), _) => given,
            (None, _) => [0.7, 1.3],
        };
        let step = (to - from) / f64::from(self.count - 1);
        (0..self.count).map(|k| from + f64::from(k) * step).collect()
    }

    fn check(&self) -> Result<(), WingError> {
        let is_range = |[from, to]: [f64; 2]| from > 0.0 && to > from && to <= 180.0;
        if self.from_to_deg.is_none_or(is_range) {
            return Ok(());
        }
        Err(WingError::Question {
            question: "--amplitudes",
            reason: "this is no range; give a smaller and a larger half amplitude in degrees, e.g. 24,45"
                .to_string(),
        })
    }
}

impl Flights {
    /// The wings as far as they can be had without solving.
    ///
    /// # Errors
    /// If a file is refused, a wing cannot fly, a profile has no wing to fly on, or two wings have one name.
    pub fn ready(&self) -> Result<ReadyToFly, WingError> {
        if let Some(sweep) = &self.sweep {
            sweep.check()?;
        }
        let mut files = self.files.clone();
        let reference = match &self.reference {
            None => 0,
            Some(file) => files.iter().position(|known| known == file).unwrap_or_else(|| {
                files.insert(0, file.clone());
                0
            }),
        };
        let open = |file: &PathBuf| -> Result<WingModel, WingError> {
            let wing = WingModel::new(Design::load(file, &self.sets)?)?;
            can_fly(&wing)?;
            Ok(wing)
        };
        let designs = files
            .iter()
            .map(|file| (!is_profile(file)).then(|| open(file)).transpose());
        let designs: Vec<Option<WingModel>> = designs.collect::<Result<_, WingError>>()?;
        let on = match &self.on {
            Some(file) => Some(open(file)?),
            None => designs.iter().flatten().next().cloned(),
        };
        let ready = files
            .iter()
            .zip(designs)
            .map(|(file, design)| match (design, &on) {
                (Some(wing), _) => Ok(Ready::Design(Box::new(wing))),
                (None, Some(on)) => Ok(Ready::Profile(Box::new(of_profile(file, on)?))),
                (None, None) => Err(WingError::Question {
                    question: "--on",
                    reason: "a profile has no outline, air and stroke; name a design that gives them"
                        .to_string(),
                }),
            });
        let wings = ready.collect::<Result<Vec<Ready>, WingError>>()?;
        refuse_twice(&wings)?;
        Ok(ReadyToFly { wings, reference })
    }

    /// Solves the twist of the wings, side by side.
    ///
    /// # Errors
    /// If a wing has no solution, or the user asked to stop.
    pub fn fly(&self, ready: ReadyToFly, progress: &Progress) -> Result<Flew, WingError> {
        progress.say("solving");
        let unseen = progress.unseen();
        let fly = |ready: Ready| match ready {
            Ready::Design(wing) => {
                let parts = self.parts_of(&wing);
                of_design(*wing, self.source, self.phases, &parts, &unseen)
            }
            Ready::Profile(flown) => Ok(*flown),
        };
        let wings: Vec<Result<Flown, WingError>> = ready.wings.into_par_iter().map(fly).collect();
        Ok(Flew {
            wings: wings.into_iter().collect::<Result<_, WingError>>()?,
            reference: ready.reference,
        })
    }

    /// A wing at each amplitude of the sweep; none where its twist does not follow the speed alone.
    ///
    /// # Errors
    /// If no flight can be made of its twist.
    pub fn swept(&self, wing: &Flown) -> Option<Result<Vec<Flight>, LiftError>> {
        let parts = self.parts_of(&wing.model).into_iter();
        let flights: Option<Vec<_>> = parts.map(|part| wing.at_amplitude(part, self.source)).collect();
        Some(flights?.into_iter().collect())
    }

    fn parts_of(&self, wing: &WingModel) -> Vec<f64> {
        let flapping = wing.design().flapping.as_ref();
        let own_deg = flapping.map(|own| own.half_amplitude_deg.value());
        let sweep = self.sweep.as_ref();
        sweep.map_or(Vec::new(), |sweep| sweep.parts(own_deg))
    }
}

impl Ready {
    fn name(&self) -> &str {
        match self {
            Ready::Design(wing) => &wing.design().name,
            Ready::Profile(flown) => &flown.name,
        }
    }
}

fn refuse_twice(wings: &[Ready]) -> Result<(), WingError> {
    let is_known = |index: &usize| {
        let before = wings[..*index].iter();
        before.map(Ready::name).any(|name| name == wings[*index].name())
    };
    match (1..wings.len()).find(is_known) {
        None => Ok(()),
        Some(twice) => Err(WingError::Question {
            question: "DESIGN|PROFILE",
            reason: format!(
                "two wings are called '{}'; give one of them another name",
                wings[twice].name()
            ),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amplitudes_in_degrees_are_parts_of_each_wings_own() {
        let sweep = Amplitudes {
            count: 3,
            from_to_deg: Some([20.0, 40.0]),
        };
        assert_eq!(sweep.parts(Some(40.0)), [0.5, 0.75, 1.0]);
        let own = Amplitudes {
            count: 2,
            from_to_deg: None,
        };
        assert_eq!(own.parts(Some(40.0)), [0.7, 1.3]);
        let turned = Amplitudes {
            count: 2,
            from_to_deg: Some([40.0, 20.0]),
        };
        assert!(turned.check().is_err() && sweep.check().is_ok());
    }
}
