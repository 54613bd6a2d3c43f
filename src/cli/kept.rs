//! Tables of campaigns, kept between runs in the user's cache folder under what they were made of. They are made anew where one is lost or
//! damaged; nobody is told.

use std::fs;
use std::io::Write;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::diagnose::table::Table;
use crate::diagnose::{DiagnoseError, Settings};
use crate::input::study::LoadedStudy;
use crate::origin::{program_sha256, sha256};
use crate::progress::Progress;
use crate::study::{Campaign, Forward, MeshError, Work};

/// Tables that are kept at most; those used longest ago go.
const MOST: usize = 64;
/// Variable that names another folder to keep tables in; empty: none are.
const FOLDER: &str = "WASHOUT_CACHE";

/// What is kept of a campaign.
#[derive(Serialize, Deserialize)]
struct Kept {
    mesh: Option<MeshError>,
    table: Table,
}

/// A campaign corrected for its mesh, its table, and what that took less what the campaign counts itself.
pub struct Prepared {
    /// The campaign.
    pub campaign: Campaign,
    /// Its table.
    pub table: Table,
    /// What the table took, the campaign's own count of it left out.
    pub beside: Work,
}

/// Corrects a campaign for its mesh and finds how it answers, or takes that from an earlier run.
///
/// # Errors
/// As [`Table::new`].
pub fn prepared(
    campaign: Campaign,
    study: &LoadedStudy,
    candidates: &[&str],
    settings: &Settings,
    progress: &Progress,
) -> Result<Prepared, DiagnoseError> {
    let made_of = format!(
        "{}{}{:?}",
        program_sha256(),
        campaign.made_of(),
        (&settings.start, settings.stations, settings.switch_step)
    );
    let file = folder().map(|folder| folder.join(format!("{}.json", sha256(made_of.as_bytes()))));
    let known = file.as_ref().and_then(|file| read(file, &campaign));
    if let Some(Kept { mesh, table }) = known {
        let campaign = match mesh {
            Some(mesh) => campaign.with_mesh_error(mesh),
            None => campaign,
        };
        let beside = table.work;
        return Ok(Prepared {
            campaign,
            table,
            beside,
        });
    }
    let campaign = campaign.on_two_meshes(study, candidates, progress)?;
    let before = campaign.work();
    let table = Table::new(&campaign, settings, progress)?;
    let beside = table.work - (campaign.work() - before);
    let kept = Kept {
        mesh: campaign.mesh_error().cloned(),
        table,
    };
    if let Some(file) = &file {
        // to keep it is a convenience: what cannot be written is made anew
        let _ = write(file, &kept);
    }
    Ok(Prepared {
        campaign,
        table: kept.table,
        beside,
    })
}

fn folder() -> Option<PathBuf> {
    let named = |variable: &str| std::env::var_os(variable);
    let folder = match (named(FOLDER), named("XDG_CACHE_HOME"), named("HOME")) {
        (Some(own), ..) if own.is_empty() => return None,
        (Some(own), ..) => PathBuf::from(own),
        (None, Some(cache), _) if !cache.is_empty() => PathBuf::from(cache).join("washout"),
        (None, _, Some(home)) => PathBuf::from(home).join(".cache/washout"),
        _ => return None,
    };
    Some(folder)
}

fn read(file: &PathBuf, campaign: &Campaign) -> Option<Kept> {
    let kept: Kept = serde_json::from_slice(&fs::read(file).ok()?).ok()?;
    let rows = campaign.observables().len();
    let is_whole = kept
        .mesh
        .as_ref()
        .is_none_or(|mesh| mesh.correction.len() == rows && mesh.deviation.len() == rows);
    // used just now
    let _ = fs::File::options()
        .append(true)
        .open(file)
        .and_then(|file| file.set_modified(std::time::SystemTime::now()));
    (is_whole && kept.table.observables() == Some(rows)).then_some(kept)
}

fn write(file: &std::path::Path, kept: &Kept) -> std::io::Result<()> {
    let folder = file.parent().unwrap_or(file);
    fs::create_dir_all(folder)?;
    let mut whole = tempfile::NamedTempFile::new_in(folder)?;
    whole.write_all(&serde_json::to_vec(kept)?)?;
    whole.persist(file).map_err(|error| error.error)?;
    let mut all: Vec<(std::time::SystemTime, PathBuf)> = fs::read_dir(folder)?
        .filter_map(|entry| {
            Some((
                entry.as_ref().ok()?.metadata().ok()?.modified().ok()?,
                entry.ok()?.path(),
            ))
        })
        .filter(|(_, path)| path.extension().is_some_and(|own| own == "json"))
        .collect();
    all.sort();
    let surplus = all.len().saturating_sub(MOST);
    for (_, path) in all.into_iter().take(surplus) {
        fs::remove_file(path)?;
    }
    Ok(())
}
