//! A study as a forward model: its cases solved, read as they were measured, with the ruler's nuisances.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use nalgebra::{DMatrix, DVector};
use rayon::iter::{IntoParallelIterator, IntoParallelRefIterator, ParallelIterator};

use super::case::{Asked, PreparedCase, Solved};
use super::error::StudyError;
use super::forward::{Condition, Forward, Linear, MeshError, Observable, Unknown, WarmStart};
use super::skipped::{SkippedRow, in_words};
use super::unknowns::{Target, Targets};
use super::warm_start::{SolvedPoint, Stand};
use super::work::{Tally, Work};
use crate::coupling::Care;
use crate::input::study::{LoadedStudy, RulerKind, UnusedRows};
use crate::progress::Progress;
use crate::structure::Tangent;

/// A study ready to be predicted.
#[derive(Debug)]
pub struct Campaign {
    /// Name of the study.
    pub name: String,
    /// Share of its own prediction by which the model may miss.
    pub discrepancy: f64,
    /// Measured rows that the model cannot be asked for, and why not.
    pub skipped: Vec<SkippedRow>,
    /// Rows of the measurement files that no case uses.
    pub unused: Vec<UnusedRows>,
    pub(super) cases: Vec<PreparedCase>,
    pub(super) targets: Targets,
    pub(super) observables: Vec<Observable>,
    pub(super) conditions: Vec<Condition>,
    pub(super) progress: Progress,
    /// How often all cases were solved, for the progress line.
    pub(super) asked: AtomicUsize,
    pub(super) tally: Tally,
    pub(super) mesh_error: Option<MeshError>,
}

impl Campaign {
    /// Every measured row that takes no part, and why, in words.
    pub fn not_compared(&self) -> Vec<String> {
        in_words(&self.skipped, &self.unused)
    }

    /// A study with its own effects and, off to begin with, those of `candidates` that can act.
    ///
    /// # Errors
    /// If a case has no solution as it stands, or an input or effect is not known.
    ///
    /// # Example
    /// ```
    /// # use washout_study as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use std::path::Path;
    /// # use washout::{input::study::LoadedStudy, progress::Progress};
    /// use washout::{compare::study::compare_study, study::Campaign};
    ///
    /// let study = LoadedStudy::load(Path::new("studies/minguet.toml"), &[])?;
    /// let campaign = Campaign::new(&study, &[], &Progress::quiet())?;
    /// let comparison = compare_study(&campaign, &study.study.title)?;
    /// println!("{}", comparison.words[0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        study: &LoadedStudy,
        candidates: &[&str],
        progress: &Progress,
    ) -> Result<Campaign, StudyError> {
        let cases = study.cases.iter();
        let cases = cases.map(|case| PreparedCase::new(case, study, candidates));
        Campaign::of_prepared(study, cases.collect::<Result<_, _>>()?, candidates, progress)
    }

    /// The cases solved as they stand.
    pub(super) fn of_prepared(
        study: &LoadedStudy,
        mut cases: Vec<PreparedCase>,
        candidates: &[&str],
        progress: &Progress,
    ) -> Result<Campaign, StudyError> {
        progress.say(format_args!(
            "{}: solving {} cases",
            study.study.name,
            cases.len()
        ));
        let tally = Tally::default();
        let solved: Vec<(Vec<Result<f64, String>>, Solved)> = cases
            .par_iter()
            .map(|case| {
                let (solved, _) = case.solve(&case.design, None, &progress.unseen())?;
                tally.add(solved.work());
                Ok((case.read_each(&solved.at)?, solved))
            })
            .collect::<Result<_, StudyError>>()?;
        let (mut observables, mut conditions, mut skipped) = (Vec::new(), Vec::new(), Vec::new());
        for (index, (case, (readings, solved))) in cases.iter_mut().zip(solved).enumerate() {
            case.start_from(solved);
            let mut kept = Vec::new();
            for (row, reading) in case.rows.iter().zip(readings) {
                match reading {
                    Ok(_) => {
                        observables.push(Observable::of(row, index));
                        kept.push(row.clone());
                    }
                    Err(reason) => skipped.push(SkippedRow {
                        case: case.name.clone(),
                        line: row.line,
                        channel: row.channel,
                        reason,
                    }),
                }
            }
            case.rows = kept;
            conditions.push(case.condition());
        }
        if observables.is_empty()
            && let Some(first) = skipped.first()
        {
            return Err(StudyError::NothingRead {
                rows: skipped.len(),
                case: first.case.clone(),
                reason: first.reason.clone(),
            });
        }
        let targets = Targets::new(study, &cases, &observables, candidates)?;
        Ok(Campaign {
            name: study.study.name.clone(),
            discrepancy: study.study.discrepancy,
            skipped,
            unused: study.unused.clone(),
            cases,
            targets,
            observables,
            conditions,
            progress: progress.clone(),
            asked: AtomicUsize::new(0),
            tally,
            mesh_error: None,
        })
    }

    /// What the mesh lacks of a prediction, before the ruler.
    fn correction(&self, row: usize) -> f64 {
        let error = self.mesh_error.as_ref();
        error.map_or(0.0, |error| error.correction[row])
    }

    /// Values with which the unknowns start.
    pub fn start(&self) -> Vec<f64> {
        self.targets.start.clone()
    }

    /// The cases; their measured rows one after the other are the observables.
    pub fn cases(&self) -> &[PreparedCase] {
        &self.cases
    }

    /// Observables of a case, as a range of rows.
    fn rows_of(&self, case: usize) -> std::ops::Range<usize> {
        let before = |case: usize| self.cases[..case].iter().map(|c| c.rows.len()).sum::<usize>();
        before(case)..before(case + 1)
    }

    /// Scale 1 + b and offset of the ruler for an observable.
    fn ruler(&self, at: &[f64], observable: usize) -> (f64, f64) {
        let (mut scale, mut offset) = (1.0, 0.0);
        for (target, value) in self.targets.targets.iter().zip(at) {
            if let Target::Ruler { kind, rows } = target
                && rows.contains(&observable)
            {
                match kind {
                    RulerKind::Offset => offset += value,
                    RulerKind::Scale => scale += value,
                }
            }
        }
        (scale, offset)
    }

    /// Design of a case with these values of the unknowns in it.
    ///
    /// # Errors
    /// If a value is out of the range of its key.
    pub fn design_at(&self, case: usize, at: &[f64]) -> Result<crate::input::Design, StudyError> {
        let prepared = &self.cases[case];
        let mut design = prepared.design.clone();
        for (target, &value) in self.targets.targets.iter().zip(at) {
            for (key, number) in target.sets(case, value, at) {
                if design.get(&key) != Some(number) {
                    design.set(&key, number).map_err(|error| prepared.failed(error))?;
                }
            }
        }
        Ok(design)
    }

    /// A case solved with these values of the unknowns.
    ///
    /// # Errors
    /// If it has no solution there.
    pub fn solved_at(&self, case: usize, at: &[f64]) -> Result<Arc<Solved>, StudyError> {
        let (prepared, design) = (&self.cases[case], self.design_at(case, at)?);
        if let Some(base) = prepared.base_at(&design) {
            return Ok(base);
        }
        let (solved, _) = prepared.solve(&design, None, &self.progress.unseen())?;
        self.tally.add(solved.work());
        Ok(Arc::new(solved))
    }

    /// What each case gives, side by side, solved from `warm_start` if there is one; before the ruler.
    fn each<T: Send>(
        &self,
        warm_start: Option<&WarmStart>,
        at: &[f64],
        give: impl Fn(usize, Stand, Option<Tangent>, &mut Work) -> Result<T, StudyError> + Sync,
    ) -> Result<Vec<T>, StudyError> {
        let times = 1 + self.asked.fetch_add(1, Ordering::Relaxed);
        self.progress.say(format_args!(
            "{}: all {} cases, time {times}",
            self.name,
            self.cases.len()
        ));
        let first_failed = AtomicUsize::new(usize::MAX);
        let give_one = |index: usize| {
            if index > first_failed.load(Ordering::Relaxed) {
                return None;
            }
            let mut work = Work::default();
            let stand = self.stand(index, warm_start, at, &mut work);
            let given = stand.and_then(|(stand, tangent)| give(index, stand, tangent, &mut work));
            if given.is_err() {
                first_failed.fetch_min(index, Ordering::Relaxed);
            }
            Some((work, given))
        };
        let given: Vec<_> = (0..self.cases.len()).into_par_iter().map(give_one).collect();
        // how many cases after the first that fails are begun depends on the threads: they do not count
        let counted = given.into_iter().flatten().map(|(work, given)| {
            self.tally.add(work);
            given
        });
        counted.collect()
    }

    /// A case solved: as it was at the warm start if nothing that acts on it has moved, else from there.
    fn stand(
        &self,
        index: usize,
        warm_start: Option<&WarmStart>,
        at: &[f64],
        work: &mut Work,
    ) -> Result<(Stand, Option<Tangent>), StudyError> {
        let ground = warm_start.and_then(WarmStart::get::<SolvedPoint>);
        let touches = |unknown: usize| self.targets.targets[unknown].touches(index, at);
        let care = warm_start.map_or(Care::Full, WarmStart::care);
        let is_asked = warm_start.is_none_or(|warm_start| warm_start.asks(index));
        let is_left = care.is_rough() && (self.conditions[index].is_held_out || !is_asked);
        if let Some(ground) = ground.filter(|ground| is_left || ground.is_same(at, touches)) {
            return Ok((ground.cases[index].clone(), None));
        }
        let case = &self.cases[index];
        let near = ground.map(|ground| ground.near(index, at, care));
        let design = self.design_at(index, at)?;
        let (solved, tangent) = match case.base_at(&design) {
            Some(solved) => (solved, None),
            None => {
                let (solved, tangent) = case.solve(&design, near.as_ref(), &self.progress.unseen())?;
                *work += solved.work();
                (Arc::new(solved), Some(tangent))
            }
        };
        let stand = Stand {
            reading: Arc::new(case.read(&solved.at)?),
            solved,
            columns: BTreeMap::new(),
        };
        Ok((stand, tangent))
    }

    /// The same with the derivatives that are wanted.
    fn with_columns(
        &self,
        index: usize,
        mut stand: Stand,
        tangent: Option<Tangent>,
        at: &[f64],
        wanted: &[bool],
        work: &mut Work,
    ) -> Result<Stand, StudyError> {
        let design = &stand.solved.at.design;
        let mut asked: Vec<Asked> = Vec::new();
        for (k, target) in self.targets.targets.iter().enumerate() {
            if !wanted[k] || !target.touches(index, at) || stand.columns.contains_key(&k) {
                continue;
            }
            let (key, placed) = match target {
                Target::Key { key, .. } | Target::Place { key, .. } => (key, None),
                Target::Placed {
                    key,
                    place,
                    at: unknown,
                    fixed,
                    ..
                } => {
                    // elsewhere at work already: one place at a time
                    if at[k] == 0.0 && design.get(key) != Some(0.0) {
                        continue;
                    }
                    let mut sets = fixed.clone();
                    sets.push((place.clone(), at[*unknown]));
                    (key, (at[k] == 0.0).then_some(sets))
                }
                Target::Ruler { .. } => continue,
            };
            asked.push(Asked {
                index: k,
                key: key.clone(),
                switch: self.targets.unknowns[k].switch_step(at[k]),
                placed,
            });
        }
        let progress = self.progress.unseen();
        let (columns, more) = self.cases[index].rates(&stand.solved, tangent, &asked, &progress)?;
        *work += more;
        let columns = columns.into_iter().map(|(k, column)| (k, Arc::new(column)));
        stand.columns.extend(columns);
        Ok(stand)
    }
}

impl Forward for Campaign {
    fn mesh_error(&self) -> Option<&MeshError> {
        self.mesh_error.as_ref()
    }

    fn work(&self) -> Work {
        self.tally.so_far()
    }

    fn unknowns(&self) -> &[Unknown] {
        &self.targets.unknowns
    }

    fn observables(&self) -> &[Observable] {
        &self.observables
    }

    fn conditions(&self) -> &[Condition] {
        &self.conditions
    }

    fn predict(&self, at: &[f64]) -> Result<DVector<f64>, StudyError> {
        let raw = self
            .each(None, at, |_, stand, _, _| Ok(stand.reading.to_vec()))?
            .concat();
        let seen = raw.into_iter().enumerate().map(|(row, y)| {
            let (scale, offset) = self.ruler(at, row);
            scale * (y + self.correction(row)) + offset
        });
        Ok(DVector::from_iterator(self.observables.len(), seen))
    }

    fn linearize(&self, at: &[f64], wanted: &dyn Fn(&Unknown) -> bool) -> Result<Linear, StudyError> {
        Ok(self.linearize_from(None, at, wanted)?.0)
    }

    fn linearize_from(
        &self,
        warm_start: Option<&WarmStart>,
        at: &[f64],
        wanted: &dyn Fn(&Unknown) -> bool,
    ) -> Result<(Linear, Option<WarmStart>), StudyError> {
        let wanted: Vec<bool> = self.targets.unknowns.iter().map(wanted).collect();
        let stands = self.each(warm_start, at, |index, stand, tangent, work| {
            self.with_columns(index, stand, tangent, at, &wanted, work)
        })?;
        let size = self.observables.len();
        let mut value = DVector::zeros(size);
        let mut jacobian = DMatrix::zeros(size, wanted.len());
        for (case, stand) in stands.iter().enumerate() {
            let raw = &stand.reading;
            for (place, row) in self.rows_of(case).enumerate() {
                let (scale, offset) = self.ruler(at, row);
                value[row] = scale * (raw[place] + self.correction(row)) + offset;
                for (k, column) in stand.columns.iter().filter(|(k, _)| wanted[**k]) {
                    jacobian[(row, *k)] = scale * column.rates[place];
                }
                for (k, target) in self.targets.targets.iter().enumerate() {
                    if let Target::Ruler { kind, rows } = target
                        && wanted[k]
                        && rows.contains(&row)
                    {
                        jacobian[(row, k)] = match kind {
                            RulerKind::Offset => 1.0,
                            RulerKind::Scale => raw[place] + self.correction(row),
                        };
                    }
                }
            }
        }
        let ground = SolvedPoint {
            at: at.to_vec(),
            cases: stands,
        };
        Ok((Linear { value, jacobian }, Some(WarmStart::new(ground))))
    }

    fn moment_response(&self, at: &[f64], stations: usize) -> Result<DMatrix<f64>, StudyError> {
        self.moment_response_from(None, at, stations)
    }

    fn moment_response_from(
        &self,
        warm_start: Option<&WarmStart>,
        at: &[f64],
        stations: usize,
    ) -> Result<DMatrix<f64>, StudyError> {
        let parts = self.each(warm_start, at, |index, stand, _, _| {
            self.cases[index].moment_response(&stand.solved, stations)
        })?;
        let mut response = DMatrix::zeros(self.observables.len(), stations);
        for (case, part) in parts.into_iter().enumerate() {
            for (place, row) in self.rows_of(case).enumerate() {
                let (scale, _) = self.ruler(at, row);
                for (station, column) in part.iter().enumerate() {
                    response[(row, station)] = scale * column[place];
                }
            }
        }
        Ok(response)
    }
}
