//! Study files: a list of cases (a design at an operating point, with its measurement), what is uncertain about wing and
//! ruler, and which effects are on.
//!
//! As for designs, these types are the only statement of the format.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::measurement::Channel;

mod alternative;

mod expand;

mod known;

mod load;

mod otherwise;

mod unused;

pub use alternative::{Alternative, CaseOfAlternative};
pub use expand::CaseNumber;
pub use load::{LoadedCase, LoadedStudy};
pub use unused::UnusedRows;

/// A study. Unknown keys are refused.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// The version of the file format.
    #[schemars(extend("examples" = [1]))]
    pub format: u32,
    /// The name of the study (letters, digits, `-`, `_`); it names the folder of its results.
    #[schemars(extend("examples" = ["my-study"]))]
    pub name: String,
    /// The title of the study, one line for reports.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[schemars(extend("examples" = ["Static tests of wing 1 on the bench"]))]
    pub title: String,
    /// The share by which the model may be wrong without anything being missing: of its predictions, and, where a diagnosis tries
    /// effects, of every wing's chord and stiffness, twice that of its air load, half of it in chords of its centre of pressure. Its
    /// earlier name, `slop`, is read on.
    #[serde(default = "discrepancy")]
    #[schemars(extend("minimum" = 0.0, "maximum" = 0.5, "examples" = [0.01]))]
    pub discrepancy: f64,
    /// The cases, one `[[case]]` table each, or one for each family of measured cases.
    pub case: Vec<Case>,
    /// The experiments that could be made next, one `[[experiment]]` table each: as cases, but with measurement files whose
    /// values stand empty.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub experiment: Vec<Case>,
    /// The uncertain inputs of the designs, one `[[uncertain]]` table each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub uncertain: Vec<Uncertain>,
    /// The nuisances of the ruler, which move the reading and not the wing, one `[[ruler]]` table each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub ruler: Vec<Ruler>,
    /// The effects that are on besides those of the designs, one `[[effect]]` table each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub effect: Vec<StudyEffect>,
    /// The names of the effects that a diagnosis may try; all that can act where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = [["tip-loss-prandtl", "root-flexure"]]))]
    pub candidates: Option<Vec<String>>,
    /// The names of effects that cannot be, for a reason that no reading shows, such as an amplitude that was measured: a diagnosis does
    /// not try them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("examples" = [["drive-compliance"]]))]
    pub excluded: Vec<String>,
    /// The designs, by name, on which a diagnosis tries effects: those that may differ from the others; all where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = [["twist-v2"]]))]
    pub candidates_on: Option<Vec<String>>,
    /// What may be otherwise than the cases say, one `[[alternative]]` table each: another statement of the readings, labels exchanged,
    /// a construction. `washout explain` tries them; nothing else does.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub alternative: Vec<Alternative>,
}

impl Study {
    /// Whether a diagnosis tries effects on the design of this name.
    pub fn is_tried_on(&self, design: &str) -> bool {
        self.candidates_on
            .as_ref()
            .is_none_or(|designs| designs.iter().any(|name| name == design))
    }
}

/// One case, or a family of them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// The design file, relative to the study.
    #[schemars(extend("examples" = ["../designs/twist-v2.toml"]))]
    pub design: String,
    /// The changes of the design for this case, as `--set` takes them; `{name}` stands for a number in `measured`, and
    /// `{name*0.001}` for a multiple of it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("examples" = [["flapping.frequency_hz=23"]]))]
    pub set: Vec<String>,
    /// The measurement file, relative to the study.
    #[schemars(extend("examples" = ["../measurements/colmenares-as-stated.csv"]))]
    pub measurement: String,
    /// The case in the measurement file; with numbers in braces, as in `bending-{mass}`, every case of that form.
    #[schemars(extend("examples" = ["twist-v2"]))]
    pub measured: String,
    /// The channels that count; all that were measured where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = [["twist"]]))]
    pub channels: Option<Vec<Channel>>,
    /// The measured case, one of this study, to which measured ratios of these cases refer. `washout explain` needs it to compare ratios.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = ["rigid"]))]
    pub reference: Option<String>,
    /// Whether these cases are fitted or kept for a test.
    #[serde(default, rename = "use")]
    #[schemars(extend("examples" = ["fit"]))]
    pub purpose: Purpose,
    /// The measured cases of this family that are kept for a test.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("examples" = [["bending-0.60"]]))]
    pub held_out: Vec<String>,
}

/// What a case is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Purpose {
    /// It is fitted.
    #[default]
    Fit,
    /// It is kept out of every fit.
    HeldOut,
}

/// An uncertain input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Uncertain {
    /// The dotted key of the input in the designs.
    #[schemars(extend("examples" = ["material.carbon-rod.g_gpa"]))]
    pub key: String,
    /// The mean of its prior, in the unit of the key; the design's own value where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -1e12, "maximum" = 1e12, "examples" = [4.0]))]
    pub mean: Option<f64>,
    /// The standard deviation of its prior; that of the design's assumed range (its width over √12) where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1e-15, "maximum" = 1e12, "examples" = [0.8]))]
    pub sigma: Option<f64>,
    /// The values that it may take; the design's assumed range, or four standard deviations, where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -1e12, "maximum" = 1e12, "examples" = [[3.0, 6.0]]))]
    pub range: Option<[f64; 2]>,
    /// The designs that it moves, by name; all that have the key where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = [["twist-v2"]]))]
    pub designs: Option<Vec<String>>,
    /// Where the prior comes from.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[schemars(extend("examples" = ["maker's data sheet"]))]
    pub why: String,
}

/// A nuisance of the ruler.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ruler {
    /// What it does to the reading.
    #[schemars(extend("examples" = ["offset"]))]
    pub kind: RulerKind,
    /// The channel that it moves.
    #[schemars(extend("examples" = ["twist"]))]
    pub channel: Channel,
    /// The runs of the measurement that it moves, all alike; every run has its own where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = [["bending"]]))]
    pub runs: Option<Vec<String>>,
    /// The standard deviation of its prior: of an offset in the unit of the channel, of a scale as a share.
    #[schemars(extend("minimum" = 1e-15, "maximum" = 1e9, "examples" = [0.5]))]
    pub sigma: f64,
    /// Where the prior comes from.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[schemars(extend("examples" = ["raw readings, with the ruler's own zero"]))]
    pub why: String,
}

/// What a nuisance does to the reading y.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RulerKind {
    /// y + b.
    Offset,
    /// y (1 + b).
    Scale,
}

/// An effect that is on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudyEffect {
    /// The name of the effect, as `washout effects` lists it.
    #[schemars(extend("examples" = ["tip-loss-prandtl"]))]
    pub name: String,
    /// The strength with which it starts.
    #[schemars(extend("minimum" = -1e12, "maximum" = 1e12, "examples" = [0.8]))]
    pub strength: f64,
    /// The standard deviation of the prior of its strength, about 0; without one the strength stays as it is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1e-15, "maximum" = 1e12, "examples" = [0.2]))]
    pub sigma: Option<f64>,
    /// The effect's other numbers.
    #[serde(default, skip_serializing_if = "toml::Table::is_empty")]
    #[schemars(with = "std::collections::BTreeMap<String, serde_json::Value>", extend("examples" = [{"from_mm": 40.0}]))]
    pub numbers: toml::Table,
    /// The designs on which it acts, by name; all on which it can where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = [["twist-v2"]]))]
    pub designs: Option<Vec<String>>,
}

fn discrepancy() -> f64 {
    0.01
}
