//! What the rods of `washout design` are sought for: a wanted twist, or the most lift per power.

use std::path::Path;

use crate::explore::rods::Aim;
use crate::explore::rods::search::read_twist;
use crate::input::TwistTable;
use crate::lift::TwistAlongSpan;
use crate::origin::InputFile;
use crate::wing::{WingError, WingModel};

use super::design_arguments::DesignArguments;
use super::{Console, Failure};

/// An aim with what is told of it.
pub(super) struct RodAim {
    pub(super) aim: Aim,
    /// The same in words.
    pub(super) words: String,
    /// What it is made of.
    pub(super) content: String,
    /// The files that it is read from.
    pub(super) files: Vec<InputFile>,
}

impl RodAim {
    /// The twist of a table.
    pub(super) fn of_profile(path: &Path) -> Result<RodAim, Failure> {
        let table = TwistTable::load(path)?;
        let [(_, points)] = table.profiles.as_slice() else {
            return Err(Failure::Option {
                option: "--profile",
                reason: format!(
                    "{} has a profile for each of {} phases, and a rod is sought for one; give the one at mid-stroke \
                     (columns r_mm, twist_deg)",
                    path.display(),
                    table.profiles.len()
                ),
            });
        };
        let points = points.iter().map(|[r_mm, deg]| [r_mm * 1e-3, deg.to_radians()]);
        let twist = TwistAlongSpan::from_points(points.collect());
        let twist = twist.map_err(|error| WingError::design(path, error))?;
        let content = format!("{twist:?}");
        Ok(RodAim {
            aim: Aim::Twist(twist),
            words: format!("the twist of {}", path.display()),
            content,
            files: table.input.into_iter().collect(),
        })
    }

    /// The twist of another design, as it solves.
    pub(super) fn of_design(known: &DesignArguments, console: &Console) -> Result<RodAim, Failure> {
        let path = &known.design;
        let known = known.wing(console)?;
        let twist = read_twist(&known.solve(console.progress())?);
        let twist = twist.map_err(|error| WingError::design(path, error))?;
        let known = &known.loaded;
        Ok(RodAim {
            aim: Aim::Twist(twist),
            words: format!("the twist that {} has", known.design.name),
            // not the twist itself: another machine may solve it to other last digits
            content: known.content(),
            files: known.files.clone(),
        })
    }

    /// The most lift per power of those layouts that lift so much.
    pub(super) fn of_lift(least_mn: f64, case: &WingModel) -> RodAim {
        let stroke = case.loaded.design.flapping.as_ref();
        let stroke = stroke.map_or(String::new(), |flapping| {
            format!(
                " at {} Hz, ±{} deg",
                flapping.frequency_hz.value(),
                flapping.half_amplitude_deg.value()
            )
        });
        RodAim {
            aim: Aim::LiftPerPower {
                least_lift_n: least_mn * 1e-3,
            },
            words: format!("the most lift per power from {least_mn} mN of lift on{stroke}"),
            content: format!("{least_mn:?} mN"),
            files: Vec::new(),
        }
    }

    /// The twist that is wanted, if it is one.
    pub(super) fn wanted(&self) -> Option<&TwistAlongSpan> {
        match &self.aim {
            Aim::Twist(twist) => Some(twist),
            Aim::LiftPerPower { .. } => None,
        }
    }
}
