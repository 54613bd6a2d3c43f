//! A study made ready for a diagnosis: meshed, corrected for its mesh, and how it answers to every effect.

use serde::{Deserialize, Serialize};

use crate::input::study::LoadedStudy;
use crate::program::program_sha256;
use crate::progress::Progress;
use crate::study::{Campaign, Forward, MeshLeaves, OnCoarserMesh, Work};

use super::cache::Cache;
use super::error::DiagnoseError;
use super::settings::Settings;
use super::table::Table;

/// A campaign on the coarser of two meshes, corrected by the finer one, its table, and what that took less what the campaign counts itself.
#[derive(Debug)]
pub struct Prepared {
    /// The campaign.
    pub campaign: Campaign,
    /// The settings, with what the study states of its model.
    pub settings: Settings,
    /// How the campaign answers to every effect.
    pub table: Table,
    /// What the table took, the campaign's own count of it left out.
    pub beside: Work,
    /// What must be said of the meshes.
    pub note: Option<String>,
}

/// What is kept of a campaign.
#[derive(Serialize, Deserialize)]
struct Kept {
    mesh: MeshLeaves,
    table: Table,
}

impl Prepared {
    /// Reads a study, corrects it for its mesh and finds how it answers, or takes that from an earlier run.
    ///
    /// # Errors
    /// As [`Campaign::new`] and [`Table::new`].
    pub fn new(
        study: &LoadedStudy,
        candidates: &[&str],
        settings: Settings,
        cache: &Cache,
        progress: &Progress,
    ) -> Result<Prepared, DiagnoseError> {
        settings.check()?;
        let meshed = OnCoarserMesh::new(study, candidates, progress)?;
        let settings = Settings {
            discrepancy: meshed.campaign.discrepancy,
            start: Some(meshed.campaign.start()),
            ..settings
        };
        let made_of = format!(
            "{}{}{:?}",
            program_sha256(),
            meshed.campaign.made_of(),
            (&settings.start, settings.stations, settings.switch_step)
        );
        let rows = meshed.campaign.observables().len();
        if let Some(kept) = cache.read(&made_of).filter(|kept: &Kept| kept.is_of(rows)) {
            return Ok(Prepared {
                campaign: meshed.campaign.with_mesh(&kept.mesh),
                settings,
                beside: kept.table.work,
                table: kept.table,
                note: kept.mesh.note,
            });
        }
        let mesh = meshed.leaves(candidates, progress)?;
        let campaign = meshed.campaign.with_mesh(&mesh);
        let before = campaign.work();
        let table = Table::new(&campaign, &settings, progress)?;
        let beside = table.work - (campaign.work() - before);
        let kept = Kept { mesh, table };
        cache.keep(&made_of, &kept);
        Ok(Prepared {
            campaign,
            settings,
            table: kept.table,
            beside,
            note: kept.mesh.note,
        })
    }
}

impl Kept {
    /// Whether it is of so many rows.
    fn is_of(&self, rows: usize) -> bool {
        let mesh = self.mesh.error.as_ref();
        mesh.is_none_or(|mesh| mesh.correction.len() == rows && mesh.deviation.len() == rows)
            && self.table.observables() == Some(rows)
    }
}
