//! What is missing, asked of the model as it stands: how far the answer is, and what it says.

use std::sync::Arc;
use std::time::Instant;

use serde::Serialize;

use crate::progress::Progress;

use super::found::{Answer, Found};
use super::refusal::Refusal;

/// A question and its answer.
#[derive(Default)]
pub struct Question {
    /// Rises whenever what is said differs.
    serial: u64,
    stage: String,
    /// Share of the stage that is done, where it counts.
    done: Option<f64>,
    stage_since: Option<Instant>,
    running: Option<Progress>,
    /// What fits an effect now.
    fitting: Option<Progress>,
    /// Revision of the state that it was asked of.
    revision: u64,
    found: Option<Arc<Found>>,
    error: Option<String>,
}

/// How far a question is, as the page reads it.
#[derive(Debug, Serialize)]
pub struct Told<'a> {
    serial: u64,
    running: bool,
    stage: &'a str,
    done: Option<f64>,
    seconds_left: Option<f64>,
    answer: Option<&'a Answer>,
    error: Option<&'a str>,
    revision: u64,
}

impl Question {
    /// Asks whoever works on it to stop.
    pub fn stop(&mut self) {
        self.running
            .iter()
            .chain(&self.fitting)
            .for_each(Progress::cancel);
    }

    /// An effect is fitted, cancelled by this; `false` if one is already.
    pub fn work(&mut self, progress: Progress) -> bool {
        let is_free = self.fitting.is_none();
        if is_free {
            self.fitting = Some(progress);
        }
        is_free
    }

    /// No effect is fitted any more.
    pub fn rest(&mut self) {
        self.fitting = None;
    }

    /// What is said, if that is newer than `after`; as JSON.
    pub fn told(&self, after: Option<u64>) -> Option<String> {
        if after.is_some_and(|after| self.serial <= after) {
            return None;
        }
        let done = self.done.filter(|_| self.running.is_some());
        let left = self.stage_since.zip(done).filter(|(_, done)| *done > 0.0);
        let told = Told {
            serial: self.serial,
            running: self.running.is_some(),
            stage: &self.stage,
            done,
            seconds_left: left.map(|(since, done)| since.elapsed().as_secs_f64() * (1.0 / done - 1.0)),
            answer: self.found.as_ref().map(|found| &found.answer),
            error: self.error.as_deref(),
            revision: self.revision,
        };
        serde_json::to_string(&told).ok()
    }

    /// What was found.
    pub fn found(&self) -> Option<Arc<Found>> {
        self.found.clone()
    }

    /// What is done now. A count of what a stage repeats within it is not told: it would hide the stage.
    pub fn say(&mut self, line: &str) {
        if line.contains(" cases, time ") || self.stage == line {
            return;
        }
        let counts = share(line);
        if counts.is_none() || self.done.is_none() {
            self.stage_since = Some(Instant::now());
        }
        self.done = counts;
        self.stage = line.to_string();
        self.serial += 1;
    }

    /// Starts anew; `false` while an earlier one is worked on.
    pub fn begin(&mut self, revision: u64, progress: Progress) -> bool {
        if self.running.is_some() {
            return false;
        }
        self.serial += 1;
        self.running = Some(progress);
        (self.done, self.stage_since) = (None, None);
        (self.stage, self.error, self.revision) = ("reading".to_string(), None, revision);
        self.found = None;
        true
    }

    /// Ends with what was found, or why nothing was.
    pub fn end(&mut self, found: Result<Found, Refusal>) {
        self.serial += 1;
        self.running = None;
        self.stage.clear();
        match found {
            Ok(found) => self.found = Some(Arc::new(found)),
            Err(refusal) => self.error = Some(refusal.message),
        }
    }
}

/// Share done, where a stage counts: `3 of 11 cases`, `effect 3 of 79`.
fn share(stage: &str) -> Option<f64> {
    let words: Vec<&str> = stage.split_whitespace().collect();
    let counts = words.windows(3).find_map(|three| match three {
        [done, "of", all] => Some((done.parse::<f64>().ok()?, all.parse::<f64>().ok()?)),
        _ => None,
    });
    let (done, all) = counts?;
    (all > 0.0 && done <= all).then(|| done / all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stage_that_counts_says_its_share() {
        assert_eq!(share("3 of 12 cases"), Some(0.25));
        assert_eq!(share("three-rods: all 11 cases, time 2"), None);
        assert_eq!(share("effect 3 of 60"), Some(0.05));
        assert_eq!(share("5 of them"), None);
    }
}
