//! Kinds of cases, and the order in which they come around.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Kinds of cases.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Nothing is missing.
    Null,
    /// Nothing is missing, and sigma is stated 30 % too small.
    NullQuiet,
    /// Nothing is missing, and one number is 8 sigma off.
    NullOutlier,
    /// One effect.
    Single,
    /// Two effects of different families.
    Pair,
    /// Something that no effect is.
    Novel,
    /// One effect that this campaign cannot tell from another.
    Twin,
}

/// Kinds in the order in which they come around: 29 cases hold 15 without anything missing, 6 single ones, 3 pairs, 3 novel
/// ones and 2 twins.
const ROUND: [Kind; 29] = {
    use Kind::{Novel, Null, NullOutlier, NullQuiet, Pair, Single, Twin};
    [
        Single,
        Null,
        Novel,
        NullQuiet,
        Pair,
        Null,
        Single,
        NullOutlier,
        Twin,
        Null,
        Single,
        Null,
        NullQuiet,
        Pair,
        Null,
        NullOutlier,
        Single,
        Novel,
        Null,
        NullQuiet,
        Single,
        NullOutlier,
        Null,
        Pair,
        NullQuiet,
        Twin,
        Single,
        NullOutlier,
        Novel,
    ]
};

impl Kind {
    /// All kinds.
    pub const ALL: [Kind; 7] = [
        Kind::Null,
        Kind::NullQuiet,
        Kind::NullOutlier,
        Kind::Single,
        Kind::Pair,
        Kind::Novel,
        Kind::Twin,
    ];

    /// Its word.
    pub fn word(self) -> &'static str {
        match self {
            Kind::Null => "null",
            Kind::NullQuiet => "null-quiet",
            Kind::NullOutlier => "null-outlier",
            Kind::Single => "single",
            Kind::Pair => "pair",
            Kind::Novel => "novel",
            Kind::Twin => "twin",
        }
    }

    /// Whether nothing is missing.
    pub fn is_null(self) -> bool {
        matches!(self, Kind::Null | Kind::NullQuiet | Kind::NullOutlier)
    }

    /// The kind of the case at a place of the run.
    pub fn at(index: usize) -> Kind {
        ROUND[index % ROUND.len()]
    }
}
