//! The root edge of the film, held otherwise than the design says: whether the readings of a table are nearer to that.
//!
//! How it is held is a choice of two, which no fit reaches from the other and few bench books state.

use crate::compare::ladder::ladder;
use crate::compare::{ComparedStudy, StudyComparison};
use crate::input::design::RootChord;
use crate::input::sheet::DesignReadings;
use crate::input::study::LoadedStudy;
use crate::progress::{Cancelled, Progress};

use super::digits::short;
use super::error::{DiagnoseError, where_solved};

/// Name of the step of the error that is meant.
const CALIBRATED: &str = "calibrated";

/// How near the calibrated model comes to the readings of a table with the root edge of the film held one way and the other.
#[derive(Debug, Clone, PartialEq)]
pub struct RootEdge {
    /// As the design has it.
    pub own: RootChord,
    /// Root mean square error of what was fitted, in its stated standard deviations; none where that cannot be calibrated.
    pub own_sigma: Option<f64>,
    /// The same with the edge held otherwise; none where that cannot be calibrated.
    pub otherwise_sigma: Option<f64>,
}

impl RootEdge {
    /// Calibrates both, where the wing has a film; `sets` change the design.
    ///
    /// # Errors
    /// If the study cannot be read, or the user asked to stop.
    pub fn of_table(
        table: &DesignReadings,
        sets: &[String],
        progress: &Progress,
    ) -> Result<Option<RootEdge>, DiagnoseError> {
        let study = table.study(sets)?;
        let film = study
            .cases
            .first()
            .filter(|case| case.loaded.design.film.is_some());
        let Some(own) = film.map(|case| case.loaded.design.root.chord) else {
            return Ok(None);
        };
        let with_other: Vec<String> = sets.iter().cloned().chain([setting(other(own))]).collect();
        let error_sigma = |study: &LoadedStudy| -> Result<Option<f64>, Cancelled> {
            let compared = where_solved(ComparedStudy::new(study, &progress.unseen()))?;
            Ok(compared.and_then(|found| error_sigma(found.comparison)))
        };
        progress.say("the root edge of the film as it is, and otherwise");
        Ok(Some(RootEdge {
            own,
            own_sigma: error_sigma(&study)?,
            otherwise_sigma: error_sigma(&table.study(&with_other)?)?,
        }))
    }

    /// Whether the readings are nearer to the other way.
    pub fn is_otherwise_nearer(&self) -> bool {
        let both = self.own_sigma.zip(self.otherwise_sigma);
        both.is_some_and(|(own, otherwise)| otherwise < own)
    }

    /// What it says, and what to ask where the other way is nearer.
    pub fn words(&self) -> String {
        let (own, other) = (word(self.own), word(other(self.own)));
        let taken = format!("The root edge of the film is taken as {own}.");
        let Some(as_taken) = self.own_sigma else {
            return format!(
                "{taken} Whether it is nearer as {other} is not known: no fit of the model settled."
            );
        };
        let Some(otherwise) = self.otherwise_sigma else {
            return format!("{taken} Were it {other}, no fit of the model would settle.");
        };
        let both = [otherwise, as_taken].map(short);
        if both[0] == both[1] {
            return format!(
                "{taken} Were it {other}, the calibrated model would miss by as much, {} sigma (rms).",
                both[0]
            );
        }
        let nearer = match self.is_otherwise_nearer() {
            true => format!(". Look at the wing, and ask with it: --set root.chord={other}"),
            false => String::new(),
        };
        format!(
            "{taken} Were it {other}, the calibrated model would miss by {} sigma instead of {} (rms){nearer}.",
            both[0], both[1]
        )
    }
}

/// The other way.
fn other(own: RootChord) -> RootChord {
    match own {
        RootChord::Free => RootChord::Clamped,
        RootChord::Clamped => RootChord::Free,
    }
}

/// As a design has it.
fn word(own: RootChord) -> &'static str {
    match own {
        RootChord::Free => "free",
        RootChord::Clamped => "clamped",
    }
}

/// What changes a design to it.
fn setting(own: RootChord) -> String {
    format!("root.chord=\"{}\"", word(own))
}

/// Root mean square error of what was fitted, as calibrated, in its stated standard deviations; none if nothing was.
fn error_sigma(comparison: StudyComparison) -> Option<f64> {
    let steps = ladder(&[(CALIBRATED.to_string(), comparison)]);
    steps.iter().find(|step| step.name == CALIBRATED)?.in_sample_sigma
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_other_way_is_asked_for_where_the_readings_are_nearer_to_it() {
        let mut edge = RootEdge {
            own: RootChord::Free,
            own_sigma: Some(2.5),
            otherwise_sigma: Some(0.75),
        };
        assert_eq!(
            edge.words(),
            "The root edge of the film is taken as free. Were it clamped, the calibrated model would miss by 0.750 sigma instead of 2.50 \
             (rms). Look at the wing, and ask with it: --set root.chord=clamped."
        );
        edge.otherwise_sigma = Some(2.75);
        assert!(!edge.words().contains("--set"), "{}", edge.words());
        edge.otherwise_sigma = None;
        assert!(edge.words().contains("clamped, no fit"), "{}", edge.words());
        edge.own_sigma = None;
        assert!(edge.words().contains("is not known"), "{}", edge.words());
    }
}
