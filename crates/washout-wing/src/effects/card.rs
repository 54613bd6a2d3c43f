//! What an effect says about itself.

use schemars::JsonSchema;
use serde::Serialize;

use crate::input::measurement::Channel;

/// The card of an effect: all that a user must know of it before switching it on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Card<'a> {
    /// Its name: that of its file, of its table in a design, in reports and docs.
    pub name: &'a str,
    /// Rivals (other formulas of the same physics, or the same physics elsewhere) share it.
    pub family: &'a str,
    /// One sentence: what happens.
    pub summary: &'a str,
    /// The formula, in plain text.
    pub formula: &'a str,
    /// Author, year, equation.
    pub source: &'a str,
    /// When it is right, and when to prefer it to its rivals.
    pub when_right: &'a str,
    /// What it gets wrong.
    pub gets_wrong: &'a str,
    /// The case in the full model in which a factor of 2 would be seen: a test of this name.
    pub case: &'a str,
    /// Where it acts.
    pub seam: Seam,
    /// Its numbers; the first is the strength.
    pub parameters: &'a [Parameter<'a>],
    /// What it changes in a coupled wing.
    pub channels: &'a [Channel],
    /// What it needs to act: nothing is changed where the design lacks it.
    pub needs: &'a [Need],
    /// Whether its response has a kink at strength 0.
    pub has_switch: bool,
}

/// A number of an effect.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Parameter<'a> {
    /// Key in the effect's table.
    pub name: &'a str,
    /// Unit; `1` for pure numbers.
    pub unit: &'a str,
    /// What it is; for a strength, what 1 means.
    pub meaning: &'a str,
    /// Value where the table does not give it.
    pub default: f64,
    /// Values that are accepted.
    pub range: [f64; 2],
    /// Values that are plausible in nature.
    pub plausible: [f64; 2],
}

impl Parameter<'_> {
    /// Whether only one sign makes sense.
    pub fn is_one_sided(&self) -> bool {
        self.range[0] >= 0.0 || self.range[1] <= 0.0
    }

    /// Size that is plausible: the larger end of the plausible range, seen from 0.
    pub fn scale(&self) -> f64 {
        self.plausible[0].abs().max(self.plausible[1].abs())
    }
}

/// A number besides the strength that is not known: where along the wing an effect sits, or how far its law reaches. A diagnosis moves it to
/// where the data have it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Places {
    /// Position of the parameter on the card.
    pub parameter: usize,
    /// Places that are looked at first.
    pub at: &'static [f64],
    /// How far from such a place the effect may be, as a standard deviation; twice that at most.
    pub reach: f64,
    /// Position of the parameter that counts spars, each of which is looked at.
    pub spar: Option<usize>,
    /// Whether it may be so on one wing alone: damage may, a law of the air may not.
    pub of_one_wing: bool,
}

/// What an effect on stiffness or mass changes in a coupled wing.
pub const STRUCTURE_CHANNELS: &[Channel] = &[
    Channel::Twist,
    Channel::TwistRate,
    Channel::Deflection,
    Channel::Lift,
    Channel::Drag,
    Channel::Power,
    Channel::Frequency,
];

/// What every effect changes there, for its shape follows the load, and the load its shape: all but natural frequencies.
pub const WING_CHANNELS: &[Channel] = STRUCTURE_CHANNELS.split_at(6).0;

/// What a picture changes: the twist that is read from it.
pub const PICTURE_CHANNELS: &[Channel] = STRUCTURE_CHANNELS.split_at(2).0;

/// Where an effect acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Seam {
    /// Sections, films, joints and supports.
    Structure,
    /// Angle, speed and coefficients of a strip of air.
    Air,
    /// Loads on nodes.
    Load,
    /// Small or large rotations.
    Kinematics,
    /// The picture that a camera takes of the wing; the wing stays as it is.
    Picture,
}

/// What a design must have for an effect to act.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Need {
    /// Air.
    Flow,
    /// Flapping.
    Flapping,
    /// A steady stream.
    Stream,
    /// The periodic motion over the stroke, so flapping.
    Motion,
    /// A stroke phase off mid-stroke.
    OffMidStroke,
    /// A film.
    Film,
    /// A film that wrinkles.
    WrinklingFilm,
    /// A film that carries compression.
    CarryingFilm,
    /// Spars.
    Spars,
    /// A half-round rod.
    HalfRound,
    /// A rod that has a shape, so that its stiffness is not given.
    ShapedRod,
    /// A rod that is a solid: round, half-round, a rectangle or plies.
    SolidRod,
    /// Linear kinematics.
    Linear,
    /// Gravity, as the design or an effect has it, or centrifugal load: what makes mass felt at rest.
    Gravity,
    /// A root that gives in pitch.
    SoftRoot,
    /// A camera whose axis is stated.
    Camera,
}

/// A number as a design states it, or assumes it.
pub(super) fn number(value: &toml::Value) -> Option<f64> {
    let plain = |value: &toml::Value| value.as_float().or(value.as_integer().map(|whole| whole as f64));
    plain(value).or_else(|| plain(value.get("assumed")?))
}
