//! The searches of `washout pareto` in tasks: one for each seed, and the front of them all.

use std::path::{Path, PathBuf};

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use crate::explore::twist_front::area;
use crate::explore::{ExploreError, FrontPoint, Nsga2, TwistFront, non_dominated};
use crate::export::pareto::{Exhaustive, Front, Profile};
use crate::export::tasks::{read_part, write_part};
use crate::progress::Progress;
use crate::task::key;

use super::Failure;
use super::tasks::{Work, gone};

/// Searches that differ in their seed, with the folder that their fronts are kept in.
pub struct Searches<'a> {
    /// The folder.
    pub folder: PathBuf,
    /// The design.
    pub design: &'a Path,
    /// The wing without shape factor, and with it, by name.
    pub wings: Vec<(&'static str, TwistFront)>,
    /// The search of the first seed.
    pub algorithm: Nsga2,
    /// How many seeds.
    pub restarts: usize,
    /// All else that a front hangs on.
    pub content: String,
}

impl Searches<'_> {
    fn with_seed(&self, task: usize) -> Nsga2 {
        Nsga2 {
            seed: self.algorithm.seed.wrapping_add(task as u64),
            ..self.algorithm.clone()
        }
    }

    fn key(&self, task: usize) -> String {
        key([self.content.as_str(), &format!("{:?}", self.with_seed(task))])
    }

    /// The fronts of a seed, one for each wing, if they were found.
    fn kept(&self, task: usize) -> Result<Option<Vec<Vec<FrontPoint>>>, Failure> {
        let fronts: Option<Vec<Vec<FrontPoint>>> = read_part(&self.folder, task, &self.key(task))?;
        Ok(fronts.filter(|fronts| fronts.len() == self.wings.len()))
    }

    fn refused(&self, source: ExploreError) -> Failure {
        Failure::Explore {
            design: self.design.to_path_buf(),
            source,
        }
    }

    /// The front of each wing over all seeds, once every task is done; with `exhaustive`, beside that of a coarse family.
    ///
    /// # Errors
    /// If a result went away, or the user asked to stop.
    pub fn fronts(&self, exhaustive: bool, progress: &Progress) -> Result<Vec<Front>, Failure> {
        let mut found: Vec<Vec<FrontPoint>> = vec![Vec::new(); self.wings.len()];
        for task in 0..self.restarts {
            let of_seed = self.kept(task)?.ok_or_else(|| gone(task))?;
            for (all, more) in found.iter_mut().zip(of_seed) {
                all.extend(more);
            }
        }
        let wings = self.wings.iter().zip(found);
        let front = |((name, wing), points): (&(&'static str, TwistFront), Vec<FrontPoint>)| {
            let points = match self.restarts {
                1 => points,
                _ => merged(points),
            };
            self.front(name, wing, points, exhaustive, progress)
        };
        let fronts: Result<Vec<Front>, ExploreError> = wings.map(front).collect();
        fronts.map_err(|source| self.refused(source))
    }

    fn front(
        &self,
        name: &str,
        wing: &TwistFront,
        found: Vec<FrontPoint>,
        exhaustive: bool,
        progress: &Progress,
    ) -> Result<Front, ExploreError> {
        let least = |of: fn(&FrontPoint) -> f64| found.iter().map(of).fold(f64::INFINITY, f64::min);
        let corner = [least(|p| p.lift), least(|p| p.efficiency)];
        let hypervolume = area(&found, corner);
        let exhaustive = if exhaustive {
            let (all, profiles) = wing.exhaust(7, 9, progress)?;
            let theirs = area(&all, corner);
            let on_steps = wing.search_on_steps(&self.algorithm, 7, 9, progress)?;
            Some(Exhaustive {
                profiles,
                hypervolume: theirs,
                found_over_exhaustive: hypervolume / theirs,
                on_steps_over_exhaustive: area(&on_steps, corner) / theirs,
            })
        } else {
            None
        };
        Ok(Front {
            name: name.to_string(),
            points: found.into_iter().map(profile).collect(),
            hypervolume,
            corner,
            exhaustive,
        })
    }
}

impl Work for Searches<'_> {
    fn count(&self) -> usize {
        self.restarts
    }

    fn is_done(&self, task: usize) -> Result<bool, Failure> {
        Ok(self.kept(task)?.is_some())
    }

    fn run(&mut self, tasks: &[usize], progress: &Progress) -> Result<(), Failure> {
        tasks.par_iter().try_for_each(|task| {
            let algorithm = self.with_seed(*task);
            let fronts = self
                .wings
                .iter()
                .map(|(_, wing)| wing.search(&algorithm, progress));
            let fronts: Result<Vec<Vec<FrontPoint>>, ExploreError> = fronts.collect();
            let fronts = fronts.map_err(|source| self.refused(source))?;
            write_part(&self.folder, *task, &self.key(*task), &fronts)?;
            Ok(())
        })
    }
}

/// Points that none of the others beats, by rising lift; of equal ones the first.
fn merged(points: Vec<FrontPoint>) -> Vec<FrontPoint> {
    let aims: Vec<Vec<f64>> = points
        .iter()
        .map(|point| vec![-point.lift, -point.efficiency])
        .collect();
    let kept = non_dominated(&aims).into_iter();
    let mut front: Vec<FrontPoint> = kept.map(|index| points[index].clone()).collect();
    front.sort_by(|a, b| a.lift.total_cmp(&b.lift));
    front
}

fn profile(point: FrontPoint) -> Profile {
    Profile {
        lift: point.lift,
        efficiency: point.efficiency,
        tip_deg: point.tip_deg,
        length_mm: point.stages.iter().map(|stage| stage[0]).collect(),
        rate_deg_per_mm: point.stages.iter().map(|stage| stage[1]).collect(),
    }
}
