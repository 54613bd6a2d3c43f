//! `washout verify` as a document, as tables to read, as Markdown and as CSV.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::program::MadeOf;
use crate::verify::{Confidence, Extent, Judged, Kind, Order, Outcome, Quantity, Verdict};

use super::ExportError;
use crate::page::Digits::{After, Significant};
use crate::page::text::{number, significant};
use crate::page::{Page, Part, Rows, Table};

/// Every case and what became of it; `verify.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct VerifyReport {
    /// Whether each case was run on one mesh only, so that no order is observed.
    pub short: bool,
    /// Quantities within tolerance and of the expected order.
    pub passed: usize,
    /// Quantities that are not, and cases that gave no answer.
    pub failed: usize,
    /// Quantities whose only reference is from memory: shown, not judged.
    pub excluded: usize,
    /// Cases against closed forms and other solvers: are the equations solved right?
    pub verification: Vec<CaseReport>,
    /// Cases against measurements: are they the right equations?
    pub validation: Vec<CaseReport>,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files in the folder.
    pub files: Vec<String>,
}

/// A case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CaseReport {
    /// Its name.
    pub name: String,
    /// What it is.
    pub title: String,
    /// Whether nothing in it fails.
    pub passed: bool,
    /// Why it gave no answer; absent if it did.
    pub failure: Option<String>,
    /// The meshes that were run, coarse first.
    pub meshes: Vec<MeshRow>,
    /// What was compared.
    pub quantities: Vec<QuantityReport>,
}

/// A mesh of a case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MeshRow {
    /// coarse, middle or fine.
    pub level: String,
    /// The mesh in words.
    pub mesh: String,
    /// Time on one core.
    pub time_s: f64,
}

/// A quantity of a case; values on the finest mesh that was run, a curve where it is worst.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct QuantityReport {
    /// What it is.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Points of a curve; 1 for a single value.
    pub points: usize,
    /// The reference.
    pub reference: f64,
    /// Where it comes from.
    pub source: String,
    /// seen, derived or memory.
    pub confidence: String,
    /// Other references, shown and never judged.
    pub others: Vec<String>,
    /// Ours; absent if no finite value was found.
    pub ours: Option<f64>,
    /// Largest relative error on each mesh, coarse first; absent as `ours`.
    pub errors: Vec<Option<f64>>,
    /// Relative error allowed on the finest.
    pub tolerance: f64,
    /// Order of convergence that theory gives.
    pub expected_order: Option<f64>,
    /// Why it gives none.
    pub order_exempt: Option<String>,
    /// Order observed on three meshes, against the own extrapolated value.
    pub observed_order: Option<f64>,
    /// pass, error, order or excluded.
    pub verdict: String,
}

/// Columns of `verify.csv`.
const CSV_HEAD: [&str; 17] = [
    "kind",
    "case",
    "quantity",
    "unit",
    "points",
    "reference",
    "source",
    "confidence",
    "ours",
    "error_coarse",
    "error_middle",
    "error_fine",
    "tolerance",
    "expected_order",
    "observed_order",
    "time_s",
    "verdict",
];

impl VerifyReport {
    /// From outcomes.
    pub fn new(outcomes: &[Outcome], extent: Extent) -> Self {
        let of = |kind: Kind| -> Vec<CaseReport> {
            let chosen = outcomes.iter().filter(|outcome| outcome.case.kind == kind);
            chosen.map(CaseReport::new).collect()
        };
        let (verification, validation) = (of(Kind::Verification), of(Kind::Validation));
        let all = || verification.iter().chain(&validation);
        let count = |verdicts: &[&str]| {
            let quantities = all().flat_map(|case| &case.quantities);
            quantities
                .filter(|q| verdicts.contains(&q.verdict.as_str()))
                .count()
        };
        VerifyReport {
            made_of: MadeOf::files([]),
            short: extent == Extent::Short,
            passed: count(&["pass"]),
            failed: count(&["error", "order"]) + all().filter(|case| case.failure.is_some()).count(),
            excluded: count(&["excluded"]),
            verification,
            validation,
            files: Vec::new(),
        }
    }

    /// Every case, verification first.
    pub fn cases(&self) -> impl Iterator<Item = &CaseReport> {
        self.verification.iter().chain(&self.validation)
    }

    /// Names of the cases that fail.
    pub fn failing(&self) -> Vec<String> {
        let failing = self.cases().filter(|case| !case.passed);
        failing.map(|case| case.name.clone()).collect()
    }

    /// What `washout verify` says.
    pub fn page(&self) -> Page {
        let failing: Vec<String> = self.failing();
        let answer = match failing.as_slice() {
            [] => self.summary(),
            names => format!("{} Failing: {}.", self.summary(), names.join(", ")),
        };
        let mut page = Page {
            title: format!("washout {} verify", self.made_of.washout_version),
            kind: "verify",
            lead: vec![Part::Sentence(answer)],
            ..Page::default()
        };
        for (id, title, cases) in self.parts() {
            let gave_none = |case: &CaseReport| {
                let failure = case.failure.as_ref()?;
                Some(format!("{}: no answer: {failure}", case.name))
            };
            let of_part: Vec<(String, Shown)> = shown(id, cases).collect();
            let parts = vec![
                Part::Table(table(&of_part)),
                Part::List(cases.iter().filter_map(gave_none).collect()),
            ];
            page.section(id, title, parts);
        }
        let all = self.parts();
        let mut nearest: Vec<(String, Shown)> =
            all.iter().flat_map(|(id, _, cases)| shown(id, cases)).collect();
        nearest.sort_by(|(_, a), (_, b)| b.share_of_limit().total_cmp(&a.share_of_limit()));
        nearest.truncate(NEAREST);
        let nearest = table(&nearest).without(&["reference", "observed_order", "source"]);
        page.brief = page.lead.clone();
        let nearest_to = "Nearest to their limits, and beyond:".to_string();
        page.brief.extend([Part::Text(nearest_to), Part::Table(nearest)]);
        page
    }

    /// How many pass, in a line.
    pub fn summary(&self) -> String {
        let extent = if self.short {
            "one mesh each, no orders"
        } else {
            "errors on the finest of three meshes"
        };
        format!(
            "{} pass, {} fail, {} excluded (reference from memory only); {extent}.",
            self.passed, self.failed, self.excluded
        )
    }

    /// Both parts with their names and headings.
    pub fn parts(&self) -> [(&'static str, &'static str, &[CaseReport]); 2] {
        [
            (
                "verification",
                "Verification: are the equations solved right?",
                &self.verification,
            ),
            (
                "validation",
                "Validation: are they the right equations?",
                &self.validation,
            ),
        ]
    }

    /// `verify.csv`: one row per quantity.
    ///
    /// # Errors
    /// If the encoder refuses.
    pub fn csv(&self) -> Result<Vec<u8>, ExportError> {
        let refuse = |error: ::csv::Error| ExportError::Encoding {
            format: "CSV",
            reason: error.to_string(),
        };
        let mut writer = ::csv::Writer::from_writer(Vec::new());
        writer.write_record(CSV_HEAD).map_err(refuse)?;
        for (kind, _, cases) in self.parts() {
            for (case, q) in rows(cases) {
                let plain = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
                let [coarse, middle, fine] =
                    ["coarse", "middle", "fine"].map(|level| plain(case.error_at(q, level)));
                let record = [
                    kind.to_string(),
                    case.name.clone(),
                    q.name.clone(),
                    q.unit.clone(),
                    q.points.to_string(),
                    q.reference.to_string(),
                    q.source.clone(),
                    q.confidence.clone(),
                    plain(q.ours),
                    coarse,
                    middle,
                    fine,
                    q.tolerance.to_string(),
                    plain(q.expected_order),
                    plain(q.observed_order),
                    case.time_s().to_string(),
                    q.verdict.clone(),
                ];
                writer.write_record(record).map_err(refuse)?;
            }
        }
        writer.into_inner().map_err(|error| ExportError::Encoding {
            format: "CSV",
            reason: error.to_string(),
        })
    }
}

impl CaseReport {
    fn new(outcome: &Outcome) -> Self {
        let pairs = outcome.case.quantities.iter().zip(&outcome.judged);
        CaseReport {
            name: outcome.case.name.to_string(),
            title: outcome.case.title.to_string(),
            passed: outcome.passes(),
            failure: outcome.failure.clone(),
            meshes: (outcome.meshes.iter())
                .map(|mesh| MeshRow {
                    level: mesh.level.word().to_string(),
                    mesh: mesh.mesh.clone(),
                    time_s: mesh.time_s,
                })
                .collect(),
            quantities: pairs
                .map(|(quantity, judged)| QuantityReport::new(quantity, judged))
                .collect(),
        }
    }

    /// Time of all meshes on one core, s.
    pub fn time_s(&self) -> f64 {
        self.meshes.iter().map(|mesh| mesh.time_s).sum()
    }

    /// Error of a quantity on the mesh of a level, if it was run.
    pub fn error_at(&self, quantity: &QuantityReport, level: &str) -> Option<f64> {
        let at = self.meshes.iter().position(|mesh| mesh.level == level)?;
        quantity.errors.get(at).copied().flatten()
    }
}

impl QuantityReport {
    fn new(quantity: &Quantity, judged: &Judged) -> Self {
        let finite = |value: f64| value.is_finite().then_some(value);
        let (expected_order, order_exempt) = match quantity.order {
            Order::Theory(order) => (Some(order), None),
            Order::Exempt(why) => (None, Some(why.to_string())),
        };
        let other = |other: &crate::verify::Other| {
            format!("{} ({}, {})", other.value, other.source, word(other.confidence))
        };
        QuantityReport {
            name: quantity.name.to_string(),
            unit: quantity.unit.to_string(),
            points: judged.points,
            reference: judged.reference,
            source: quantity.source.to_string(),
            confidence: word(quantity.confidence).to_string(),
            others: quantity.others.iter().map(other).collect(),
            ours: finite(judged.ours),
            errors: judged.errors.iter().map(|error| finite(*error)).collect(),
            tolerance: quantity.tolerance,
            expected_order,
            order_exempt,
            observed_order: judged.order,
            verdict: verdict_word(judged.verdict).to_string(),
        }
    }

    /// Error on the finest mesh.
    pub fn error(&self) -> Option<f64> {
        self.errors.last().copied().flatten()
    }

    /// Its limit in percent; a dash where none is judged.
    pub fn limit(&self) -> String {
        percent((self.verdict != "excluded").then_some(self.tolerance))
    }

    /// What it is, with the number of points of a curve.
    pub fn words(&self) -> String {
        if self.points > 1 {
            format!("{} (worst of {})", self.name, self.points)
        } else {
            self.name.clone()
        }
    }

    /// Observed order, and the expected one if there is one.
    pub fn order_words(&self) -> String {
        let observed = self
            .observed_order
            .map_or("–".to_string(), |order| number(order, 2));
        match self.expected_order {
            Some(expected) if self.observed_order.is_some() => {
                format!("{observed} of {}", number(expected, 0))
            }
            _ => observed,
        }
    }
}

/// How sure a reference is, in a word.
fn word(confidence: Confidence) -> &'static str {
    match confidence {
        Confidence::Seen => "seen",
        Confidence::Derived => "derived",
        Confidence::Memory => "memory",
    }
}

fn verdict_word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Pass => "pass",
        Verdict::ErrorFails => "error",
        Verdict::OrderFails => "order",
        Verdict::Excluded => "excluded",
    }
}

/// Quantities that a terminal shows where all would be too many.
const NEAREST: usize = 8;

/// A quantity with its case.
struct Shown<'a> {
    case: &'a CaseReport,
    quantity: &'a QuantityReport,
}

impl Shown<'_> {
    /// Its error over its limit; what fails is beyond all, and what is not judged or not known is below.
    fn share_of_limit(&self) -> f64 {
        match (self.quantity.verdict.as_str(), self.quantity.error()) {
            ("excluded", _) => f64::NEG_INFINITY,
            ("pass", error) => error.unwrap_or(0.0) / self.quantity.tolerance,
            _ => f64::INFINITY,
        }
    }
}

/// Quantities of cases that stand at `/PART` of the document, each with where it stands below that.
fn shown<'a>(part: &'static str, cases: &'a [CaseReport]) -> impl Iterator<Item = (String, Shown<'a>)> {
    cases.iter().enumerate().flat_map(move |(i, case)| {
        let quantities = case.quantities.iter().enumerate();
        quantities.map(move |(j, quantity)| (format!("{part}/{i}/quantities/{j}"), Shown { case, quantity }))
    })
}

fn table(rows: &[(String, Shown)]) -> Table {
    Rows::keyed("", rows.iter().map(|(place, row)| (place.as_str(), row)))
        .words("case", |row| row.case.name.as_str())
        .words("quantity", |row| row.quantity.words())
        .number(["reference", "reference", ""], Significant(5), |row| {
            row.quantity.reference
        })
        .number(["ours", "ours", ""], Significant(5), |row| row.quantity.ours)
        .words("error (%)", |row| percent(row.quantity.error()))
        .words("limit (%)", |row| row.quantity.limit())
        .number(["observed_order", "order", ""], After(2), |row| {
            row.quantity.observed_order
        })
        .words("verdict", |row| row.quantity.verdict.as_str())
        .words("source", |row| row.quantity.source.as_str())
        .table()
}

/// Every quantity with its case.
pub fn rows(cases: &[CaseReport]) -> impl Iterator<Item = (&CaseReport, &QuantityReport)> {
    cases
        .iter()
        .flat_map(|case| case.quantities.iter().map(move |quantity| (case, quantity)))
}

/// A relative error in percent with two significant digits.
pub fn percent(error: Option<f64>) -> String {
    match error {
        Some(error) if error < 1e-7 => "0".to_string(),
        Some(error) => significant(100.0 * error, 2),
        None => "–".to_string(),
    }
}
