//! Tidy measurement tables: one row per number, with its error and what reported it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::design::{Design, Instrument};
use super::error::{InputError, Place, Problem, Range};
use crate::origin::InputFile;

mod columns;

mod made;

mod read;

mod row;

pub use columns::COLUMN_WORDS;
pub use made::{Formulas, InCommon, Made};

/// What a measurement file holds, or the rows of one case of it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Measurement {
    /// File that it came from, as the user named it.
    pub file: String,
    /// What the file is known by; none of rows that were not read from a file.
    pub input: Option<InputFile>,
    /// Comment lines at the head of the file (source, licence, meaning of columns), without `#`.
    pub comments: Vec<String>,
    /// How a program made them, if the file says so.
    pub made: Option<Made>,
    /// The rows, in the order of the file.
    pub rows: Vec<Row>,
}

/// One measured number.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Line of the file.
    pub line: usize,
    /// Which wing at which condition.
    pub case: String,
    /// What was measured.
    pub channel: Channel,
    /// Instrument that reported a twist; none for other channels.
    pub instrument: Option<Instrument>,
    /// Name of the run, to keep repeats apart; may be empty.
    pub run: String,
    /// Station, or inner end of the interval, mm from the wing base; none for channels of the whole wing.
    pub r_mm: Option<f64>,
    /// Outer end of the interval, mm, for twist rates.
    pub r_to_mm: Option<f64>,
    /// Chord fraction behind the leading edge at which a displacement was read; none for other channels.
    pub chord_fraction: Option<f64>,
    /// The value in the unit of the channel; twist is washout, whatever the sign in the file; 0 where it is only planned.
    pub value: f64,
    /// Whether it is yet to be measured: its value stands empty.
    pub is_planned: bool,
    /// Standard deviation of the value, same unit, positive.
    pub sigma: f64,
    /// Where the standard deviation comes from.
    pub sigma_kind: SigmaKind,
    /// Whether the value is a bound only.
    pub bound: Bound,
}

/// What was measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Channel {
    /// Twist at a station, deg, washout positive.
    Twist,
    /// Mean twist rate over an interval, deg/mm, washout rising toward the tip positive.
    TwistRate,
    /// Deflection across the wing plane at a station, mm, positive toward +z; of the leading edge unless said otherwise.
    Deflection,
    /// Displacement toward the trailing edge at a station, mm.
    ChordwiseDisplacement,
    /// Displacement toward the tip at a station, mm.
    SpanwiseDisplacement,
    /// Mean lift of one wing, mN.
    Lift,
    /// Mean drag of one wing, mN.
    Drag,
    /// Mean aerodynamic power of one wing, mW.
    Power,
    /// Mean lift as a ratio to the rigid wing.
    LiftRatio,
    /// Mean drag as a ratio to the rigid wing.
    DragRatio,
    /// Aerodynamic efficiency as a ratio to the rigid wing.
    EfficiencyRatio,
    /// Effective lift coefficient as a ratio to the rigid wing.
    EffectiveLiftRatio,
    /// Natural frequency, Hz.
    Frequency,
}

/// Where a standard deviation comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SigmaKind {
    /// The source states it.
    Stated,
    /// From repeated measurements.
    Repeats,
    /// Assumed.
    Assumed,
}

/// Whether a value is a bound only.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Bound {
    /// A value.
    #[default]
    None,
    /// The true value lies below.
    Upper,
    /// The true value lies above.
    Lower,
}

/// The columns of a measurement file that hold stations.
pub const STATION_COLUMNS: [&str; 2] = ["r_mm", "r_to_mm"];

/// Columns of a measurement file, in the order in which they are written.
pub const COLUMNS: [&str; 12] = [
    "case",
    "channel",
    "instrument",
    "unit",
    "sign",
    "run",
    "r_mm",
    "r_to_mm",
    "value",
    "sigma",
    "sigma_kind",
    "bound",
];

/// Columns that may be left out.
pub const OPTIONAL_COLUMNS: [&str; 1] = ["chord_fraction"];

/// Channels by their names in the file.
pub const CHANNELS: [(&str, Channel); 13] = [
    ("twist", Channel::Twist),
    ("twist_rate", Channel::TwistRate),
    ("deflection", Channel::Deflection),
    ("chordwise_displacement", Channel::ChordwiseDisplacement),
    ("spanwise_displacement", Channel::SpanwiseDisplacement),
    ("lift", Channel::Lift),
    ("drag", Channel::Drag),
    ("power", Channel::Power),
    ("lift_ratio", Channel::LiftRatio),
    ("drag_ratio", Channel::DragRatio),
    ("efficiency_ratio", Channel::EfficiencyRatio),
    ("effective_lift_ratio", Channel::EffectiveLiftRatio),
    ("frequency", Channel::Frequency),
];

impl Channel {
    /// Name in the file.
    pub fn name(self) -> &'static str {
        CHANNELS
            .iter()
            .find(|(_, channel)| *channel == self)
            .map_or("", |(name, _)| name)
    }

    /// Unit of its values; `1` for ratios.
    ///
    /// # Example
    /// ```
    /// # use washout_design as washout;
    /// use washout::input::measurement::Channel;
    ///
    /// assert_eq!(Channel::Twist.unit(), "deg");
    /// ```
    pub fn unit(self) -> &'static str {
        match self {
            Channel::Twist => "deg",
            Channel::TwistRate => "deg/mm",
            Channel::Deflection | Channel::ChordwiseDisplacement | Channel::SpanwiseDisplacement => "mm",
            Channel::Lift | Channel::Drag => "mN",
            Channel::Power => "mW",
            Channel::LiftRatio
            | Channel::DragRatio
            | Channel::EfficiencyRatio
            | Channel::EffectiveLiftRatio => "1",
            Channel::Frequency => "Hz",
        }
    }

    /// Whether it is a twist, so that it has a sign and an instrument.
    pub fn is_twist(self) -> bool {
        matches!(self, Channel::Twist | Channel::TwistRate)
    }

    /// Whether it is a displacement, so that it has a place on the chord.
    pub fn is_displacement(self) -> bool {
        matches!(
            self,
            Channel::Deflection | Channel::ChordwiseDisplacement | Channel::SpanwiseDisplacement
        )
    }

    /// Whether it is read at a place along the span.
    pub fn has_station(self) -> bool {
        self.is_twist() || self.is_displacement()
    }

    /// Range of values that are no slip of the pen.
    pub(in crate::input) fn range(self) -> Range {
        let (low, high) = match self {
            Channel::Twist => (-180.0, 180.0),
            Channel::TwistRate => (-1000.0, 1000.0),
            Channel::Deflection | Channel::ChordwiseDisplacement | Channel::SpanwiseDisplacement => {
                (-1e5, 1e5)
            }
            Channel::Lift | Channel::Drag | Channel::Power => (-1e9, 1e9),
            Channel::Frequency => (0.0, 1e6),
            _ => (0.0, 1000.0),
        };
        Range {
            low,
            high,
            open: false,
            unit: if self.unit() == "1" { "" } else { self.unit() },
        }
    }
}

/// Refuses rows without a value.
pub(super) fn refuse_planned(file: &str, rows: &[Row]) -> Result<(), InputError> {
    let Some(row) = rows.iter().find(|row| row.is_planned) else {
        return Ok(());
    };
    let place = Place {
        file: file.to_string(),
        line: Some(row.line),
        column: None,
    };
    let cure = "Give the measured value; rows that are yet to be measured are for diagnose --plan, synthesize, and \
                [[experiment]]";
    Err(InputError::new(place, "value", "", Problem::Missing, cure))
}

impl Measurement {
    /// The names of the cases, in the order of the file.
    pub fn cases(&self) -> Vec<&str> {
        let mut cases: Vec<&str> = Vec::new();
        for row in &self.rows {
            if !cases.contains(&row.case.as_str()) {
                cases.push(&row.case);
            }
        }
        cases
    }

    /// The rows of one case.
    pub fn case(&self, case: &str) -> Measurement {
        Measurement {
            file: self.file.clone(),
            input: self.input.clone(),
            comments: self.comments.clone(),
            made: self.made,
            rows: self.rows.iter().filter(|row| row.case == case).cloned().collect(),
        }
    }

    /// Refuses stations that do not lie on the wing.
    pub fn check_stations(&self, design: &Design, columns: [&str; 2]) -> Result<(), InputError> {
        let range = Range {
            low: 0.0,
            high: design.planform.length_mm.value(),
            open: false,
            unit: "mm",
        };
        for row in &self.rows {
            for (column, station) in columns.into_iter().zip([row.r_mm, row.r_to_mm]) {
                if let Some(station) = station
                    && !range.contains(station)
                {
                    let place = Place {
                        file: self.file.clone(),
                        line: Some(row.line),
                        column: None,
                    };
                    let problem = Problem::OutOfRange { range };
                    let cure = format!(
                        "Give the station from the wing base; {} is {} mm long (planform.length_mm)",
                        design.name, range.high
                    );
                    return Err(InputError::new(
                        place,
                        column,
                        &station.to_string(),
                        problem,
                        cure,
                    ));
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "# source: a bench\ncase,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n";

    #[test]
    fn nose_up_becomes_washout_with_its_bound() {
        let text = format!("{HEAD}a,twist,camera,deg,nose_up,1,50,,-4.5,0.5,stated,lower\n");
        let measurement = Measurement::from_csv(&text, "m.csv").unwrap();
        let row = &measurement.rows[0];
        assert_eq!((row.value, row.bound, row.line), (4.5, Bound::Upper, 3));
        assert_eq!(measurement.comments, ["source: a bench"]);
    }

    #[test]
    fn a_rate_needs_an_interval_and_a_ratio_needs_no_station() {
        let text = format!(
            "{HEAD}a,twist_rate,camera,deg/mm,washout,,0,48,0.29,0.04,assumed,none\n\
             a,lift_ratio,,1,,,,,1.353,0.05,assumed,none\n"
        );
        let rows = Measurement::from_csv(&text, "m.csv").unwrap().rows;
        assert_eq!((rows[0].r_mm, rows[0].r_to_mm), (Some(0.0), Some(48.0)));
        assert_eq!((rows[1].r_mm, rows[1].instrument), (None, None));
    }

    #[test]
    fn duplicate_rows_name_the_first() {
        let row = "a,twist,camera,deg,washout,1,50,,4.5,0.5,stated,none\n";
        let error = Measurement::from_csv(&format!("{HEAD}{row}{row}"), "m.csv").unwrap_err();
        assert!(
            error
                .to_string()
                .starts_with("m.csv:4: case = a: repeats the row on line 3"),
            "{error}"
        );
    }
}
