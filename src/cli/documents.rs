//! The JSON documents that verbs print.

use crate::blind::Scoreboard;
use crate::diagnose::Plan;
use crate::effects::card::Card;
use crate::export::diagnosis::DiagnosisReport;
use crate::export::difference::Difference;
use crate::export::explanation::ExplanationReport;
use crate::export::modes::ModesSummary;
use crate::export::study::StudyReport;
use crate::export::summary::RunSummary;
use crate::export::sweep::SweepSummary;
use crate::export::verification::VerifyReport;
use crate::synthesize::Answer;
use clap::ValueEnum;
use schemars::{JsonSchema, Schema};
use serde_json::{Map, Value, json as value};

use super::effects::ShownCard;
use crate::export::json;

/// The list of documents: the enum, the kind of each, its schema.
macro_rules! documents {
    ($($(#[$doc:meta])* $name:ident $kind:literal $of:ty,)*) => {
        /// Verbs whose JSON document has a schema.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
        pub enum Output {
            $($(#[$doc])* $name,)*
        }

        $(impl json::Document for $of {
            const KIND: &'static str = $kind;
        })*

        impl Output {
            /// The schema of the document.
            pub fn schema(self) -> Schema {
                match self {
                    $(Output::$name => schema::<$of>(),)*
                }
            }
        }
    };
}

documents! {
    /// `washout solve --json`, and `summary.json`
    Solve "solve" RunSummary,
    /// `washout compare --json`
    Compare "compare" crate::export::compare_report::CompareReport,
    /// `washout lift --json`
    Lift "lift" crate::export::lift::LiftSummary,
    /// `washout pareto --json`
    Pareto "pareto" crate::export::pareto::ParetoSummary,
    /// `washout sweep --json`
    Sweep "sweep" SweepSummary,
    /// `washout design --json`
    Design "design" crate::export::layouts::LayoutSummary,
    /// `washout divergence --json`
    Divergence "divergence" crate::wing::divergence::DivergenceReport,
    /// `washout check --json`
    Check "check" crate::export::check::RunCheck,
    /// `washout diff --json`
    Diff "diff" Difference,
    /// `washout modes --json`
    Modes "modes" ModesSummary,
    /// `washout mesh --json`
    Mesh "mesh" super::mesh::MeshReport,
    /// `washout measure --json`
    Measure "measure" crate::export::video::MeasureReport,
    /// `washout init --json`
    Init "init" super::init::InitReport,
    /// `washout doctor --json`
    Doctor "doctor" super::doctor::DoctorReport,
    /// `washout compare STUDY --json`
    Study "study" StudyReport,
    /// `washout diagnose --json`
    Diagnose "diagnose" DiagnosisReport,
    /// `washout live --json`
    Live "live" super::live::LiveReport,
    /// `washout explain --json`
    Explain "explain" ExplanationReport,
    /// `washout add --json`
    Add "add" crate::export::added::AddReport,
    /// `washout diagnose --plan --json`
    Plan "plan" Plan,
    /// `washout synthesize --json`
    Synthesize "synthesize" super::synthesize::SynthesizeReport,
    /// answer.json of `washout synthesize`
    Answer "answer" Answer,
    /// `washout blind --json`
    Blind "blind" Scoreboard,
    /// `washout effects --json`: a list; of one effect its item
    Effects "effects" Vec<Card<'_>>,
    /// `washout report --json`
    Report "report" super::report::ReportMade,
    /// `washout plot --json`, and `plot.json`
    Plot "plot" super::plot::Plotted,
    /// `washout export --json`
    Export "export" super::export::ExportReport,
    /// `washout verify --json`, and `verify.json`
    Verify "verify" VerifyReport,
}

impl json::Document for ShownCard<'_> {
    const KIND: &'static str = "effect";
}

/// The schema of one document; never inlined, or all of them become one function of 200 kB.
#[inline(never)]
fn schema<D: json::Document + JsonSchema>() -> Schema {
    headed(schemars::schema_for!(D), D::KIND, D::FORMAT)
}

/// A schema with the kind and the format that stand first in the document; a list stands below its kind.
fn headed(mut schema: Schema, kind: &str, format: u32) -> Schema {
    if schema.get("type").and_then(Value::as_str) == Some("array") {
        let object = schema.as_object().cloned().unwrap_or_default();
        let outside = |key: &str| key.starts_with('$') || key == "title";
        let (outer, list): (Map<String, Value>, Map<String, Value>) =
            object.into_iter().partition(|(key, _)| outside(key));
        schema = Schema::from(outer);
        schema.insert("type".to_string(), "object".into());
        schema.insert("properties".to_string(), value!({ kind: list }));
        schema.insert("required".to_string(), value!([kind]));
    }
    let head = value!({
        "kind": { "description": "What the document is.", "const": kind },
        "format": { "description": "The version of its form.", "const": format },
    });
    let whole = schema.ensure_object();
    let mut properties = head.as_object().cloned().unwrap_or_default();
    if let Some(own) = whole.get("properties").and_then(Value::as_object) {
        properties.extend(own.clone());
    }
    whole.insert("properties".to_string(), properties.into());
    let own = whole.get("required").and_then(Value::as_array);
    let required = [value!("kind"), value!("format")]
        .into_iter()
        .chain(own.into_iter().flatten().cloned());
    let required: Vec<Value> = required.collect();
    whole.insert("required".to_string(), required.into());
    schema
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_document_says_its_kind_which_is_what_schema_calls_it_and_no_field_hides_it() {
        for output in Output::value_variants() {
            let schema = output.schema();
            let name = output.to_possible_value().expect("shown").get_name().to_string();
            assert_eq!(schema.pointer("/properties/kind/const"), Some(&value!(name)));
            assert_eq!(
                schema.pointer("/properties/format/const"),
                Some(&value!(1)),
                "{name}"
            );
        }
    }
}
