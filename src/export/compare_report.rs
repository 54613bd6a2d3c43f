//! The document of `washout compare DESIGN`, and what it says.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::compare::reference::ModelledRatios;
use crate::compare::{Comparison, DesignComparison};
use crate::page::text::number;
use crate::page::{Digits, Page, Part, Rows, Table};
use crate::program::MadeOf;

use super::comparison;

/// What `washout compare` prints.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CompareReport {
    /// Measured minus modelled.
    pub comparison: Comparison,
    /// The wing against the reference wing, as modelled; absent unless asked for.
    pub ratios: Option<ModelledRatios>,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder, this one among them.
    pub files: Vec<String>,
}

impl CompareReport {
    /// Of a comparison, before files are written.
    pub fn new(found: &DesignComparison) -> CompareReport {
        CompareReport {
            comparison: found.comparison.clone(),
            ratios: found.ratios.clone(),
            made_of: found.made_of.clone(),
            files: Vec::new(),
        }
    }

    /// What it says.
    pub fn page(&self) -> Page {
        let mut page = comparison::page(&self.comparison);
        let ratios = self.page_of_ratios().sections;
        let parts = ratios.iter().flat_map(|section| &section.parts);
        page.brief.extend(parts.cloned());
        page.sections.extend(ratios);
        page
    }

    /// What it says of the reference wing alone.
    pub(super) fn page_of_ratios(&self) -> Page {
        let mut page = Page {
            kind: "comparison",
            ..Page::default()
        };
        let tables = self.ratios.iter().map(|found| Part::Table(table(found)));
        page.section("ratios", "Against the reference wing", tables.collect());
        page
    }
}

/// The ratios; they stand at `ratios` in the document.
fn table(modelled: &ModelledRatios) -> Table {
    let caption = format!(
        "Modelled ratios to {} (20/60/20 ramp; 2πfΦ {} times its)",
        modelled.reference,
        number(modelled.rate_ratio, 4)
    );
    Rows::of("/ratios/ratios", &modelled.ratios)
        .words("ratio", |row| row.name.as_str())
        .number(["as_solved", "as both flap", ""], Digits::After(3), |row| {
            row.as_solved
        })
        .number(
            ["at_equal_rate", "at equal stroke", ""],
            Digits::After(3),
            |row| row.at_equal_rate,
        )
        .caption(&caption)
        .table()
}
