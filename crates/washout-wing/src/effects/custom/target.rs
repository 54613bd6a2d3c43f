//! What a formula of the user's own may act on, and what it may name.

/// What a formula may name besides its own numbers: x (r/R), r and chord (m), alpha, twist and phase (rad),
/// twist_rate (rad/s), U (m/s), q (½ρU², Pa), rho (kg/m³), f (Hz), Phi (half amplitude, rad); of a spar along, its length from the leading
/// edge over the whole.
pub static VARIABLES: [&str; 13] = [
    "x",
    "r",
    "chord",
    "alpha",
    "twist",
    "twist_rate",
    "U",
    "q",
    "rho",
    "f",
    "Phi",
    "phase",
    "along",
];
/// Units of [`VARIABLES`] behind x; along has none.
pub(super) const UNITS: [&str; 12] = [
    "m", "m", "rad", "rad", "rad/s", "m/s", "Pa", "kg/m³", "Hz", "rad", "rad", "",
];
pub(super) const CHORD: usize = 2;
pub(super) const ALPHA: usize = 3;
pub(super) const TWIST: usize = 4;
pub(super) const TWIST_RATE: usize = 5;
pub(super) const SPEED: usize = 6;
pub(super) const PRESSURE: usize = 7;
pub(super) const ALONG: usize = 12;
/// Those that a rod knows.
const OF_A_ROD: [&str; 7] = ["x", "r", "chord", "rho", "f", "Phi", "phase"];
/// Those that a spar knows.
const OF_A_SPAR: [&str; 8] = ["x", "r", "chord", "rho", "f", "Phi", "phase", "along"];

/// What the formula stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Target {
    Moment,
    Force,
    Lift,
    Drag,
    CentreOfPressure,
    Torsion,
    Bending,
    Spars,
}

impl Target {
    /// Whether the formula is a factor of a stiffness, which stays positive.
    pub(super) fn is_stiffness(self) -> bool {
        matches!(self, Target::Torsion | Target::Bending | Target::Spars)
    }

    /// What its formula may name, and what knows no more than that.
    pub(super) fn knows(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Target::Torsion | Target::Bending => ("rod", &OF_A_ROD),
            Target::Spars => ("spar", &OF_A_SPAR),
            _ => ("strip of the wing", &VARIABLES[..ALONG]),
        }
    }
}

/// Words for [`Target`], and what the formula then gives.
pub(super) const TARGETS: [(&str, Target, &str); 8] = [
    (
        "moment",
        Target::Moment,
        "moment about the span that is added, N·m per m, positive: washout",
    ),
    (
        "force",
        Target::Force,
        "force across the chord that is added, N per m, positive: along the load",
    ),
    ("lift", Target::Lift, "factor of the lift coefficient"),
    ("drag", Target::Drag, "factor of the drag coefficient"),
    (
        "centre-of-pressure",
        Target::CentreOfPressure,
        "shift of the centre of pressure toward the trailing edge, chords",
    ),
    (
        "torsion",
        Target::Torsion,
        "factor of the rods' torsional stiffness",
    ),
    (
        "bending",
        Target::Bending,
        "factor of the rods' bending stiffness",
    ),
    ("spars", Target::Spars, "factor of all stiffnesses of the spars"),
];
