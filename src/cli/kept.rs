//! Tables of campaigns, kept between runs in the user's cache folder under what they were made of. They are made anew where one is lost or
//! damaged; nobody is told.

use std::fs;
use std::io::Write;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::diagnose::table::Table;
use crate::diagnose::{DiagnoseError, Settings};
use crate::explain::{Answers, ExplainError, Model};
use crate::export::json;
use crate::input::study::LoadedStudy;
use crate::origin::{program_sha256, sha256};
use crate::progress::Progress;
use crate::study::{Campaign, Forward, MeshError, StudyError, TwoMeshes, Work};

/// Tables that are kept at most; those used longest ago go.
const MOST: usize = 64;
/// Variable that names another folder to keep tables in; empty: none are.
const FOLDER: &str = "WASHOUT_CACHE";

/// What is kept of a campaign.
#[derive(Serialize, Deserialize)]
struct Kept {
    mesh: Option<MeshError>,
    note: Option<String>,
    table: Table,
}

/// A campaign on the coarser of two meshes, corrected by the finer one, its table, and what that took less what the campaign counts itself.
pub struct Prepared {
    /// The campaign.
    pub campaign: Campaign,
    /// The settings, with what the study states of its model.
    pub settings: Settings,
    /// Its table.
    pub table: Table,
    /// What the table took, the campaign's own count of it left out.
    pub beside: Work,
    /// What must be said of the meshes.
    pub note: Option<String>,
}

/// Reads a study, corrects it for its mesh and finds how it answers, or takes that from an earlier run.
///
/// # Errors
/// As [`Campaign::new`] and [`Table::new`].
pub fn prepared(
    study: &LoadedStudy,
    candidates: &[&str],
    settings: Settings,
    progress: &Progress,
) -> Result<Prepared, DiagnoseError> {
    let Meshed {
        campaign,
        finer,
        note,
    } = on_coarser_mesh(study, candidates, progress)?;
    let settings = Settings {
        discrepancy: campaign.discrepancy,
        start: Some(campaign.start()),
        ..settings
    };
    let made_of = format!(
        "{}{}{:?}",
        program_sha256(),
        campaign.made_of(),
        (&settings.start, settings.stations, settings.switch_step)
    );
    let file = folder().map(|folder| folder.join(format!("{}.json", sha256(made_of.as_bytes()))));
    let known = file.as_ref().and_then(|file| read(file, &campaign));
    let with = |campaign: Campaign, mesh: Option<MeshError>| match mesh {
        Some(mesh) => campaign.with_mesh_error(mesh),
        None => campaign,
    };
    if let Some(kept) = known {
        return Ok(Prepared {
            campaign: with(campaign, kept.mesh),
            settings,
            beside: kept.table.work,
            table: kept.table,
            note: kept.note,
        });
    }
    let (mesh, unknown) = match &finer {
        Some(finer) => mesh_error(&campaign, finer, candidates, progress)?,
        None => (None, None),
    };
    let note = unknown.or(note);
    let campaign = with(campaign, mesh.clone());
    let before = campaign.work();
    let table = Table::new(&campaign, &settings, progress)?;
    let beside = table.work - (campaign.work() - before);
    let kept = Kept { mesh, note, table };
    if let Some(file) = &file {
        // to keep it is a convenience: what cannot be written is made anew
        let _ = write(file, &kept);
    }
    Ok(Prepared {
        campaign,
        settings,
        table: kept.table,
        beside,
        note: kept.note,
    })
}

/// How a model answers to every change alone, or that from an earlier run.
///
/// # Errors
/// As [`Answers::new`].
pub fn answers(model: &Model, progress: &Progress) -> Result<Answers, ExplainError> {
    let made_of = format!("{}{}explain", program_sha256(), model.campaign().made_of());
    let file = folder().map(|folder| folder.join(format!("{}.json", sha256(made_of.as_bytes()))));
    let bytes = file.as_ref().and_then(|file| fs::read(file).ok());
    let known: Option<Answers> = bytes.and_then(|bytes| json::read(&bytes).ok());
    if let (Some(known), Some(file)) = (known.filter(|known| known.is_of(model)), &file) {
        used(file);
        return Ok(known);
    }
    let answers = Answers::new(model, progress)?;
    if let Some(file) = &file {
        // to keep it is a convenience: what cannot be written is made anew
        let _ = write(file, &answers);
    }
    Ok(answers)
}

/// A campaign, and the study on the mesh that corrects it.
struct Meshed {
    campaign: Campaign,
    finer: Option<LoadedStudy>,
    note: Option<String>,
}

/// A study on the coarser of two meshes; on its own where it has no solution on that one.
fn on_coarser_mesh(
    study: &LoadedStudy,
    candidates: &[&str],
    progress: &Progress,
) -> Result<Meshed, StudyError> {
    let TwoMeshes { coarser, finer } = TwoMeshes::of(study);
    let refine = |of: &LoadedStudy| of.cases.first().map(|case| case.loaded.design.mesh.refine);
    match Campaign::new(&coarser, candidates, progress) {
        Ok(campaign) => Ok(Meshed {
            campaign,
            finer,
            note: None,
        }),
        Err(error) if matches!(error, StudyError::Cancelled(_)) || refine(&coarser) == refine(study) => {
            Err(error)
        }
        Err(error) => Ok(Meshed {
            campaign: Campaign::new(study, candidates, progress)?,
            finer: None,
            note: Some(not_known("half as fine", &error)),
        }),
    }
}

/// What the mesh leaves, or that it is not known.
fn mesh_error(
    campaign: &Campaign,
    finer: &LoadedStudy,
    candidates: &[&str],
    progress: &Progress,
) -> Result<(Option<MeshError>, Option<String>), StudyError> {
    match campaign.mesh_error_by(finer, candidates, progress) {
        Ok(mesh) => Ok((Some(mesh), None)),
        Err(error @ StudyError::Cancelled(_)) => Err(error),
        Err(error) => Ok((None, Some(not_known("twice as fine", &error)))),
    }
}

fn not_known(mesh: &str, error: &StudyError) -> String {
    format!(
        "What the mesh leaves is not known, and not in any error: on a mesh {mesh} there is no answer ({error})."
    )
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
    let kept: Kept = json::read(&fs::read(file).ok()?).ok()?;
    let rows = campaign.observables().len();
    let is_whole = kept
        .mesh
        .as_ref()
        .is_none_or(|mesh| mesh.correction.len() == rows && mesh.deviation.len() == rows);
    used(file);
    (is_whole && kept.table.observables() == Some(rows)).then_some(kept)
}

/// Marks a table as used just now.
fn used(file: &PathBuf) {
    let _ = fs::File::options()
        .append(true)
        .open(file)
        .and_then(|file| file.set_modified(std::time::SystemTime::now()));
}

fn write(file: &std::path::Path, kept: &impl Serialize) -> std::io::Result<()> {
    let folder = file.parent().unwrap_or(file);
    fs::create_dir_all(folder)?;
    let mut whole = tempfile::NamedTempFile::new_in(folder)?;
    whole.write_all(&json::bytes(kept).map_err(std::io::Error::other)?)?;
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
