//! The names on the command line of where the twist of a design comes from.

use clap::ValueEnum;
use clap::builder::PossibleValue;

use crate::wing::TwistSource;

/// Where the twist comes from, as a word of the command line.
#[derive(Debug, Clone, Copy)]
pub struct TwistFrom(pub TwistSource);

impl ValueEnum for TwistFrom {
    fn value_variants<'a>() -> &'a [TwistFrom] {
        &[
            TwistFrom(TwistSource::Phases),
            TwistFrom(TwistSource::Ramp),
            TwistFrom(TwistSource::Measured),
            TwistFrom(TwistSource::Flat),
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, help) = match self.0 {
            TwistSource::Phases => (
                "phases",
                "Solved at phases of the stroke, each as if it stood still",
            ),
            TwistSource::Ramp => (
                "ramp",
                "Solved at mid-stroke, and ramped up and down over each half-stroke (20/60/20)",
            ),
            TwistSource::Measured => (
                "measured",
                "The measured profile that the design names, on the same ramp",
            ),
            TwistSource::Flat => ("flat", "None"),
        };
        Some(PossibleValue::new(name).help(help))
    }
}
