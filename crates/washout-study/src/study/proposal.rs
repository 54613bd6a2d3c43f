//! A reading that could be added to a study: what it costs, and how it is called.

use super::forward::Observable;
use crate::input::sheet::{Bench, short};
use crate::input::study::LoadedCase;

/// What a reading costs, least first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Cost {
    /// One more station in a condition that was measured.
    Station,
    /// The still wing under a torque.
    Torque,
    /// The same under a small one, which is harder to make and to read: what is loose moves as far under it.
    SmallTorque,
    /// The still wing under a push.
    Push,
    /// How far the still wing is bent by one at its leading edge, where no deflection was read.
    Deflection,
    /// Half the flapping frequency, or half the speed.
    Slower,
    /// The stream from the other side.
    OtherSide,
}

impl Cost {
    /// All, the least first.
    pub const ALL: [Cost; 7] = [
        Cost::Station,
        Cost::Torque,
        Cost::SmallTorque,
        Cost::Push,
        Cost::Deflection,
        Cost::Slower,
        Cost::OtherSide,
    ];

    /// Inputs that such a reading sets itself, so that a study cannot hold them uncertain: how their keys begin.
    pub(super) fn sets(self) -> &'static [&'static str] {
        match self {
            Cost::Station => &[],
            Cost::Torque | Cost::SmallTorque | Cost::Push | Cost::Deflection => {
                &["load[", "flapping.frequency_hz", "steady.speed_m_s"]
            }
            Cost::Slower => &["flapping.frequency_hz", "steady.speed_m_s"],
            Cost::OtherSide => &["steady.root_angle_deg", "observation.", "gravity."],
        }
    }
}

/// A reading that could be added.
#[derive(Debug, Clone)]
pub struct Proposal {
    /// What it costs.
    pub cost: Cost,
    /// The wing in its condition, named in plain words, with rows whose values are yet to come.
    pub(super) case: LoadedCase,
    /// The load on the still wing, of what is measured on a bench.
    pub(super) bench: Option<Bench>,
}

impl Proposal {
    /// The wing in its condition, with rows whose values are yet to come.
    pub fn case(&self) -> &LoadedCase {
        &self.case
    }

    /// What is to be measured, in plain words; `readings`: which of its readings, where each is a proposal of its own.
    pub fn words(&self, readings: &[&Observable]) -> String {
        match (self.cost, readings) {
            (Cost::Station, [reading]) => {
                let channel = reading.channel.name().replace('_', " ");
                let at = short(reading.r_mm.unwrap_or_default());
                format!("{channel} at {at} mm in case {}", self.case.name)
            }
            // how well it is read is assumed
            (Cost::Deflection, _) => {
                let sigma = self.case.rows.first().map_or(0.0, |row| row.sigma);
                format!(
                    "the deflection (read to {} mm) of {}",
                    short(sigma),
                    self.case.name
                )
            }
            _ => self.case.name.clone(),
        }
    }

    /// Head of the column that holds it in a table of readings; none where it is one more station of a column that is there.
    pub fn column(&self) -> Option<String> {
        match self.cost {
            Cost::Station => None,
            Cost::Torque | Cost::SmallTorque | Cost::Push => self.bench.map(|bench| bench.head()),
            Cost::Deflection => self
                .bench
                .map(|bench| format!("deflection at {} (mm)", bench.head())),
            Cost::Slower | Cost::OtherSide => head_in_air(&self.case),
        }
    }

    /// Whether every reading is a proposal of its own.
    pub fn is_of_one_reading(&self) -> bool {
        self.cost == Cost::Station
    }
}

/// Head of a column with the motion of a case, and with the numbers that its study sets besides.
fn head_in_air(case: &LoadedCase) -> Option<String> {
    let design = &case.loaded.design;
    let is_set = |key: &str| case.sets.iter().any(|set| set.starts_with(key));
    if let Some(flapping) = &design.flapping {
        let amplitude = match is_set("flapping.half_amplitude_deg") {
            true => format!(", {} deg", short(flapping.half_amplitude_deg.value())),
            false => String::new(),
        };
        return Some(format!("{} Hz{amplitude}", short(flapping.frequency_hz.value())));
    }
    let steady = design.steady.as_ref()?;
    let (speed, angle) = (steady.speed_m_s.value(), steady.root_angle_deg.value());
    Some(format!("{} m/s, {} deg", short(speed), short(angle)))
}
