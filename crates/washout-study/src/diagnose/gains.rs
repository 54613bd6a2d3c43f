//! How much better what is left out is predicted with something more in the model.

use crate::study::left_out::{Local, Others, by_condition, by_wing};

use super::baseline::Baseline;
use super::judge::Judgement;
use super::screening::is_one_sided;

/// How much better each condition, and each wing, is predicted from the others with something more in the model.
pub struct Gains<'a> {
    pub(super) conditions: LeftOutGain<'a>,
    pub(super) wings: LeftOutGain<'a>,
}

impl<'a> Gains<'a> {
    /// Over the model as it is.
    pub fn new(baseline: &'a Baseline) -> Gains<'a> {
        let (forward, rows) = (baseline.forward, &baseline.data.rows);
        Gains {
            conditions: LeftOutGain::new(baseline, by_condition(forward, rows)),
            wings: LeftOutGain::new(baseline, by_wing(forward, rows)),
        }
    }
}

/// How much better each of these groups is predicted from the others.
pub(super) struct LeftOutGain<'a> {
    baseline: &'a Baseline<'a>,
    groups: Vec<Vec<usize>>,
    others: Others,
    ln_density: Option<f64>,
}

impl<'a> LeftOutGain<'a> {
    fn new(baseline: &'a Baseline, groups: Vec<Vec<usize>>) -> LeftOutGain<'a> {
        let others = Others::new(&baseline.local, &baseline.scatter.noise);
        LeftOutGain {
            ln_density: others.ln_density(&groups),
            baseline,
            groups,
            others,
        }
    }

    /// By the fit that `local` is about.
    pub(super) fn with(&self, local: &Local) -> Option<f64> {
        self.over(&Others::new(local, &self.baseline.scatter.noise))
    }

    /// With the effect whose strength is the unknown of this name: as refitted, else by the derivative.
    pub(super) fn of(&self, unknown: &str, judgement: &Judgement) -> Option<f64> {
        let Baseline { data, forward, .. } = self.baseline;
        let k = (data.missing.iter()).position(|&i| forward.unknowns()[i].name == unknown)?;
        let refits = judgement.refits.iter();
        let refit = refits
            .filter(|(index, _)| judgement.trials[*index].members == [k])
            .map(|(_, found)| &found.local)
            .next();
        if let Some(local) = refit {
            return self.with(local);
        }
        // of the wrong sign, the best that it can have is none
        if is_one_sided(&forward.unknowns()[data.missing[k]]) && self.baseline.directions.scores[k] < 0.0 {
            return self.ln_density.map(|_| 0.0);
        }
        let column = self.baseline.slopes.column(k);
        self.over(&self.others.with(&column.select_rows(data.rows.iter())))
    }

    fn over(&self, with: &Others) -> Option<f64> {
        Some(with.ln_density(&self.groups)? - self.ln_density?)
    }
}
