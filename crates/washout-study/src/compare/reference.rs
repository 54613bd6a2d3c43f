//! A wing against a reference wing, both as modelled.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::Channel;
use crate::lift::{Ratios, StrokeMeans};
use crate::progress::Progress;
use crate::wing::{SolvedWing, WingError, WingModel};

/// Modelled ratios of a wing to a reference wing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ModelledRatios {
    /// Name of the reference wing.
    pub reference: String,
    /// Largest angular speed of the stroke over that of the reference.
    pub rate_ratio: f64,
    /// The ratios: as both flap, and with the stroke of the wing set equal to that of the reference.
    pub ratios: Vec<NamedRatio>,
}

/// One ratio under two conditions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NamedRatio {
    /// What it is.
    pub name: String,
    /// Each wing at its own frequency and amplitude.
    pub as_solved: f64,
    /// Both at the same product of frequency and amplitude, with the twist as solved.
    pub at_equal_rate: f64,
}

impl ModelledRatios {
    /// Of a solved wing to a reference wing that is solved here; and what a measurement can be compared with.
    pub(super) fn between(
        wing: &SolvedWing,
        reference: &WingModel,
        progress: &Progress,
    ) -> Result<(ModelledRatios, BTreeMap<Channel, f64>), WingError> {
        let means = wing.means_on_ramp()?;
        let name = &reference.design().name;
        progress.say(format_args!("solving {name}"));
        let of_reference = reference.solve(progress)?.means_on_ramp()?;
        let found = ratios(&wing.model, means, of_reference)?;
        let equal = found
            .at_rate_ratio(1.0)
            .map_err(|error| wing.model.fault(error))?;
        let rows = found.named().into_iter().zip(equal.named());
        let ratios = rows.map(|((_, name, as_solved), (.., at_equal_rate))| NamedRatio {
            name: name.to_string(),
            as_solved,
            at_equal_rate,
        });
        let modelled = ModelledRatios {
            reference: name.clone(),
            rate_ratio: found.rate_ratio,
            ratios: ratios.collect(),
        };
        let channels = BTreeMap::from([
            (Channel::LiftRatio, found.lift),
            (Channel::DragRatio, found.drag),
            (Channel::EfficiencyRatio, found.local_lift_to_drag),
        ]);
        Ok((modelled, channels))
    }
}

fn ratios(
    wing: &WingModel,
    means: Option<StrokeMeans>,
    reference: Option<StrokeMeans>,
) -> Result<Ratios, WingError> {
    match (means, reference) {
        (Some(means), Some(reference)) => {
            Ratios::between(&means, &reference).map_err(|error| wing.fault(error))
        }
        _ => Err(WingError::Question {
            question: "--reference",
            reason: "ratios need two wings that flap; give both a [flapping] table".to_string(),
        }),
    }
}
