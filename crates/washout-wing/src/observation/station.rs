//! Where twist is read: base, spar ends, tip, and places on request.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::geometry::Planform;
use crate::input::design::Design;

/// What stands at a station.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Place {
    /// The clamp.
    Base,
    /// The trailing-edge end of a spar, by its index in the design.
    SparEnd(usize),
    /// A place on request; in a bay the film sags.
    OnRequest,
    /// The place that "tip" means.
    Tip,
}

/// A place along the span where twist is to be read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// What stands there.
    pub place: Place,
    /// Distance from the wing base, m.
    pub r_m: f64,
}

/// A station that was not read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkippedStation {
    /// Where.
    pub station: Station,
    /// Why.
    pub reason: SkipReason,
}

/// Why a station was not read.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SkipReason {
    /// The chord is too small for an angle to have a meaning.
    #[error(
        "the chord of {:.1} mm does not exceed observation.smallest_chord of the mean chord ({:.1} mm)",
        .chord_m * 1e3, .smallest_m * 1e3
    )]
    SmallChord {
        /// Chord there, m.
        chord_m: f64,
        /// Chord that it must exceed, m.
        smallest_m: f64,
    },
    /// The station lies off the wing.
    #[error("it lies off the wing, which ends at {:.1} mm; nothing is extrapolated", .tip_m * 1e3)]
    OffWing {
        /// Where the wing is cut, m.
        tip_m: f64,
    },
    /// The station lies beside or behind a camera that stands near.
    #[error(
        "the camera of the effect camera-perspective stands {:.0} mm from where it is aimed, and does not see it",
        .distance_m * 1e3
    )]
    OutOfSight {
        /// Distance of the camera from where it is aimed, m.
        distance_m: f64,
    },
}

/// Stations of a design, r rising: the base, the trailing-edge end of each spar, the tip station, places on request.
///
/// Between the rod and a spar's trailing-edge end the chord line has firm ends. Of two stations closer than a
/// micrometre the first of that list stays.
pub fn stations(design: &Design, planform: &Planform) -> Vec<Station> {
    let spar_ends = design.spar.iter().enumerate().map(|(index, spar)| Station {
        place: Place::SparEnd(index),
        r_m: spar.trailing_edge_at_mm.as_ref().unwrap_or(&spar.at_mm).value() / 1e3,
    });
    let on_request = design.observation.stations_mm.iter();
    let wanted = std::iter::once(Station {
        place: Place::Base,
        r_m: 0.0,
    })
    .chain(spar_ends)
    .chain([Station {
        place: Place::Tip,
        r_m: design.observation.tip_station * planform.length_m(),
    }])
    .chain(on_request.map(|r_mm| Station {
        place: Place::OnRequest,
        r_m: r_mm / 1e3,
    }));
    let mut stations: Vec<Station> = Vec::new();
    for station in wanted.filter(|station| station.r_m.is_finite()) {
        if stations
            .iter()
            .all(|other| (other.r_m - station.r_m).abs() > 1e-6)
        {
            stations.push(station);
        }
    }
    stations.sort_by(|a, b| a.r_m.total_cmp(&b.r_m));
    stations
}

/// Whether an angle can be read at `r_m`, and if not, why.
pub fn readable(design: &Design, planform: &Planform, r_m: f64) -> Result<(), SkipReason> {
    if !(0.0..=planform.tip_m()).contains(&r_m) {
        return Err(SkipReason::OffWing {
            tip_m: planform.tip_m(),
        });
    }
    let chord_m = planform.chord_m(r_m);
    let smallest_m = design.observation.smallest_chord * planform.mean_chord_m();
    if chord_m > smallest_m {
        Ok(())
    } else {
        Err(SkipReason::SmallChord { chord_m, smallest_m })
    }
}
