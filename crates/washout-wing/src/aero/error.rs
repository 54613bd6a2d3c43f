//! What can be wrong with the air of a design.

use thiserror::Error;

/// A mistake in the air of a design, or a strip that left the range of its law.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum AeroError {
    /// `coefficients = "table"` without a table.
    #[error(
        "air.coefficients is \"table\", but no table was given; set air.table to a CSV file with the columns \
         alpha_deg, cl, cd"
    )]
    TableMissing,
    /// Too few rows to interpolate.
    #[error("the table of air coefficients has {rows} row(s); give at least 2, with alpha_deg rising")]
    TableTooShort {
        /// Number of rows found.
        rows: usize,
    },
    /// A row that is not a number.
    #[error(
        "row {row} of the table of air coefficients holds a value that is not finite; correct alpha_deg, cl, cd"
    )]
    TableNotFinite {
        /// Row, counted from 1 below the header.
        row: usize,
    },
    /// Angles that do not rise.
    #[error(
        "row {row} of the table of air coefficients: alpha_deg = {alpha_deg} does not rise above {previous_deg}; \
         sort the rows and remove repeated angles"
    )]
    TableNotRising {
        /// Row, counted from 1 below the header.
        row: usize,
        /// Angle of that row, deg.
        alpha_deg: f64,
        /// Angle of the row before, deg.
        previous_deg: f64,
    },
    /// An angle that no flow has.
    #[error(
        "row {row} of the table of air coefficients: alpha_deg = {alpha_deg} lies outside [-180, 180]; give the \
         angle in degrees within one turn"
    )]
    TableAngle {
        /// Row, counted from 1 below the header.
        row: usize,
        /// Angle of that row, deg.
        alpha_deg: f64,
    },
    /// A strip at an angle that the table does not cover.
    #[error(
        "the angle of attack {alpha_deg:.3} deg lies outside the table of air coefficients, which covers \
         [{low_deg}, {high_deg}] deg; extend the table or choose air.coefficients = \"dickinson\""
    )]
    OutsideTable {
        /// Angle of attack, deg.
        alpha_deg: f64,
        /// Smallest angle that the table covers, deg.
        low_deg: f64,
        /// Largest angle that the table covers, deg.
        high_deg: f64,
    },
    /// A force that is not finite on a section.
    #[error(
        "the force of the air is not finite ({force_n_per_m:?} N/m across and along the stream) at {alpha_deg:.3} deg of attack \
         and {speed_m_s:.3} m/s; {cure}"
    )]
    NotFinite {
        /// Force across the stream and along it, N/m.
        force_n_per_m: [f64; 2],
        /// Angle of attack, deg.
        alpha_deg: f64,
        /// Speed, m/s.
        speed_m_s: f64,
        /// What to do, with the effect that it comes with if one is at fault.
        cure: String,
    },
    /// A quantity outside what the laws can use.
    #[error("{key} = {value} lies outside [{low}, {high}]; {cure}")]
    OutOfRange {
        /// Key in the design file.
        key: &'static str,
        /// Its value, in the unit of the key.
        value: f64,
        /// Smallest value allowed.
        low: f64,
        /// Largest value allowed.
        high: f64,
        /// What to do.
        cure: &'static str,
    },
}
