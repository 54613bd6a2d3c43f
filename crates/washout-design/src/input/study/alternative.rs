//! What may be otherwise than the cases of a study say: another statement of the readings, labels exchanged, another word of a design.

use std::collections::BTreeSet;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Case, Study};
use crate::input::check::refuse;
use crate::input::document::Node;
use crate::input::error::InputError;

/// Something that may be otherwise than the cases say.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Alternative {
    /// The name by which answers call it.
    #[schemars(extend("examples" = ["labels-exchanged"]))]
    pub name: String,
    /// The probability, before any comparison, that it is so and not as the cases say.
    #[schemars(extend("minimum" = 1e-6, "maximum" = 0.999999, "examples" = [0.05]))]
    pub probability: f64,
    /// The changes of the designs, as `--set` takes them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("examples" = [["root.chord=\"clamped\""]]))]
    pub set: Vec<String>,
    /// The designs, by name, that `set` changes; all where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = [["twist-v1"]]))]
    pub designs: Option<Vec<String>>,
    /// The measurement file from which readings come then, relative to the study: another statement of the same readings.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = ["../measurements/colmenares-as-restated.csv"]))]
    pub measurement: Option<String>,
    /// The measurement file that gives way to it, as the cases name it; all where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = ["../measurements/colmenares-as-stated.csv"]))]
    pub instead_of: Option<String>,
    /// The cases that have another design then.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub case: Vec<CaseOfAlternative>,
    /// Why it may be so.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    #[schemars(extend("examples" = ["the readings fit the other wing as well"]))]
    pub why: String,
}

/// A case with another design.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CaseOfAlternative {
    /// The case, by its `measured`.
    #[schemars(extend("examples" = ["twist-v1"]))]
    pub measured: String,
    /// The design file of these readings then, relative to the study.
    #[schemars(extend("examples" = ["../designs/twist-v2.toml"]))]
    pub design: String,
    /// The changes of that design, as `--set` takes them, in the place of those of the case.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("examples" = [["flapping.frequency_hz=22"]]))]
    pub set: Vec<String>,
}

/// The tables of a study: its cases, and its experiments.
pub(super) type Tables = (Vec<Case>, Vec<Case>);

impl Alternative {
    /// Changes a table of cases whose design has this name.
    pub(super) fn change(&self, table: &mut Case, design: &str, is_experiment: bool) {
        let gives_way = self
            .instead_of
            .as_ref()
            .is_none_or(|old| *old == table.measurement);
        if let Some(file) = self.measurement.as_ref().filter(|_| gives_way && !is_experiment) {
            table.measurement.clone_from(file);
        }
        for other in self.case.iter().filter(|_| !is_experiment) {
            if other.measured == table.measured {
                table.design.clone_from(&other.design);
                table.set.clone_from(&other.set);
            }
        }
        let designs = self.designs.as_ref();
        if designs.is_none_or(|designs| designs.iter().any(|own| own == design)) {
            table.set.extend(self.set.iter().cloned());
        }
    }
}

/// Refuses alternatives of one name, and those that name a case that there is not.
pub(super) fn check(study: &Study, root: &Node) -> Result<(), InputError> {
    let mut names = BTreeSet::new();
    let measured: Vec<&str> = study.case.iter().map(|case| case.measured.as_str()).collect();
    for (index, alternative) in study.alternative.iter().enumerate() {
        let key = |rest: &str| format!("alternative[{index}].{rest}");
        if !names.insert(&alternative.name) {
            let cure = "Give each alternative a name of its own";
            return refuse(root, &key("name"), "stands twice", &[], cure);
        }
        for (place, case) in alternative.case.iter().enumerate() {
            if !measured.contains(&case.measured.as_str()) {
                let cure = format!("Name one of {}, as [[case]] has it", measured.join(", "));
                let key = key(&format!("case[{place}].measured"));
                return refuse(root, &key, "no case has this name", &["case"], cure);
            }
        }
    }
    for (index, case) in study.case.iter().enumerate() {
        if let Some(reference) = &case.reference
            && !measured.contains(&reference.as_str())
        {
            let cure = format!("Name one of {}, as [[case]] has it", measured.join(", "));
            let key = format!("case[{index}].reference");
            return refuse(root, &key, "no case has this name", &["case"], cure);
        }
    }
    Ok(())
}
