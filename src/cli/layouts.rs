//! The search of `washout design` in tasks: the first look at all layouts, some in each task, and closer looks at the best.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

use crate::explore::ExploreError;
use crate::explore::rods::search::Workshop;
use crate::explore::rods::{Choices, Closer, Found, Search};
use crate::export::tasks::{read_part, write_part};
use crate::progress::Progress;
use crate::task::{key, stretches};

use super::Failure;
use super::tasks::{Work, gone};

/// A search with the folder that its parts are kept in.
pub struct Looks<'a> {
    /// The folder.
    pub folder: PathBuf,
    design: &'a Path,
    search: Search<'a>,
    /// What every part hangs on besides its layouts.
    content: String,
    tasks: Vec<Range<usize>>,
}

impl<'a> Looks<'a> {
    /// A search cut into tasks of `size` layouts; `aim`: what the layouts are for, in words that change with it.
    pub fn new(
        design: &'a Path,
        workshop: &'a Workshop<'a>,
        choices: &Choices,
        (folder, aim, size): (PathBuf, &str, usize),
    ) -> Looks<'a> {
        let search = Search::new(workshop, choices);
        let (tip_m, refine) = (workshop.tip_m, choices.refine);
        Looks {
            content: format!(
                "{}{:?}{aim} {tip_m:?} {refine:?}",
                workshop.wing.design().to_toml(),
                workshop.wing.air_table()
            ),
            tasks: stretches(search.layouts.len(), size).collect(),
            folder,
            design,
            search,
        }
    }

    fn key(&self, what: &str, layouts: Range<usize>) -> String {
        let layouts = format!("{:?}", &self.search.layouts[layouts]);
        key([self.content.as_str(), what, &layouts])
    }

    /// Scores of a task, if it was done.
    fn kept(&self, task: usize) -> Result<Option<Vec<Option<f64>>>, Failure> {
        let layouts = self.tasks[task].clone();
        let scores: Option<Vec<Option<f64>>> =
            read_part(&self.folder, task, &self.key("first", layouts.clone()))?;
        Ok(scores.filter(|scores| scores.len() == layouts.len()))
    }

    fn refused(&self, source: ExploreError) -> Failure {
        Failure::Explore {
            design: self.design.to_path_buf(),
            source,
        }
    }

    /// The layouts that come nearest to the aim, once every task is done.
    ///
    /// # Errors
    /// If no layout can be solved, or the user asked to stop; closer looks that are finished are kept then.
    pub fn found(&self, progress: &Progress) -> Result<Found, Failure> {
        let mut scores = Vec::new();
        for task in 0..self.tasks.len() {
            scores.extend(self.kept(task)?.ok_or_else(|| gone(task))?);
        }
        let best = self.search.best(&scores, progress);
        let best = best.map_err(|source| self.refused(source))?;
        progress.say(format_args!("a closer look at {} of them", best.len()));
        let closer = best.par_iter().map(|index| self.closer(*index, progress));
        let closer = closer.collect::<Result<Vec<Closer>, Failure>>()?;
        Ok(self.search.found(&scores, closer))
    }

    fn closer(&self, index: usize, progress: &Progress) -> Result<Closer, Failure> {
        let folder = self.folder.join("closer");
        let key = self.key("closer", index..index + 1);
        if let Some(known) = read_part(&folder, index, &key)? {
            return Ok(known);
        }
        let found = self.search.closer(index, progress);
        let found = found.map_err(|source| self.refused(source))?;
        write_part(&folder, index, &key, &found)?;
        Ok(found)
    }
}

impl Work for Looks<'_> {
    fn count(&self) -> usize {
        self.tasks.len()
    }

    fn is_done(&self, task: usize) -> Result<bool, Failure> {
        Ok(self.kept(task)?.is_some())
    }

    fn run(&mut self, tasks: &[usize], progress: &Progress) -> Result<(), Failure> {
        let total: usize = tasks.iter().map(|task| self.tasks[*task].len()).sum();
        let done = AtomicUsize::new(0);
        progress.say(format_args!("first look at {total} layouts"));
        tasks.par_iter().try_for_each(|task| {
            let layouts = self.tasks[*task].clone();
            let scores = self.search.look(layouts.clone(), progress);
            let scores = scores.map_err(|source| self.refused(source))?;
            let key = self.key("first", layouts.clone());
            write_part(&self.folder, *task, &key, &scores)?;
            let count = done.fetch_add(layouts.len(), Ordering::Relaxed) + layouts.len();
            progress.count(count, total, "layouts");
            Ok(())
        })
    }
}
