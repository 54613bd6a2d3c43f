//! The figures: each a share with its count and its 95 % interval by Wilson, beside what is asked for.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Kind;
use super::followed::Followed;
use super::outcome::{Failed, Outcome};
use super::setup::Turned;
use super::truth::same;
use crate::diagnose::Verdict;

/// Misfit from which on a novel cause should be recognised, sigma.
const PLAIN: f64 = 10.0;

/// The scoreboard of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Scoreboard {
    /// Cases that came to an answer.
    pub cases: usize,
    /// Cases that did not.
    pub failed: Vec<Failed>,
    /// Effects that would be seen but are not hidden.
    pub turned: Vec<Turned>,
    /// The figures.
    pub rows: Vec<Row>,
    /// How often hypotheses were right that were said to be so probable.
    pub reliability: Vec<Bin>,
    /// Mean distance of stated and observed probability, weighed by count.
    pub calibration_error: f64,
    /// Right answers of simpler methods: over all cases in which something known was hidden or nothing was.
    pub simpler: Vec<Row>,
    /// Median time of a diagnosis, s.
    pub median_seconds: f64,
}

/// One figure.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Row {
    /// What is counted.
    pub what: String,
    /// Hits; none for a figure that is no share.
    pub hits: Option<usize>,
    /// Cases that count.
    pub count: usize,
    /// Share or figure.
    pub value: f64,
    /// 95 % interval by Wilson; for a median, none.
    pub interval: Option<[f64; 2]>,
    /// What is asked for.
    pub asked: String,
}

/// Hypotheses of a range of stated probability.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Bin {
    /// Mean stated probability.
    pub stated: f64,
    /// Hits.
    pub hits: usize,
    /// Hypotheses.
    pub count: usize,
}

/// The 95 % interval of a share by Wilson (1927).
pub fn wilson(hits: usize, count: usize) -> [f64; 2] {
    if count == 0 {
        return [0.0, 1.0];
    }
    let (n, z) = (count as f64, 1.959_964);
    let p = hits as f64 / n;
    let middle = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
    let half = z / (1.0 + z * z / n) * (p * (1.0 - p) / n + z * z / (4.0 * n * n)).sqrt();
    [(middle - half).max(0.0), (middle + half).min(1.0)]
}

fn share<'a>(
    what: &str,
    asked: &str,
    outcomes: impl Iterator<Item = &'a Outcome>,
    hit: impl Fn(&Outcome) -> bool,
) -> Row {
    let flags: Vec<bool> = outcomes.map(hit).collect();
    let hits = flags.iter().filter(|hit| **hit).count();
    Row {
        what: what.to_string(),
        hits: Some(hits),
        count: flags.len(),
        value: hits as f64 / flags.len().max(1) as f64,
        interval: Some(wilson(hits, flags.len())),
        asked: asked.to_string(),
    }
}

fn middle(what: &str, asked: &str, mut values: Vec<f64>) -> Row {
    values.sort_by(f64::total_cmp);
    Row {
        what: what.to_string(),
        hits: None,
        count: values.len(),
        value: values.get(values.len() / 2).copied().unwrap_or(0.0),
        interval: None,
        asked: asked.to_string(),
    }
}

/// The scoreboard of `outcomes`, whatever their order, of the cases that came to none, and of what was not hidden.
pub fn scoreboard(outcomes: &[Outcome], failed: &[Failed], turned: &[Turned]) -> Scoreboard {
    let rows = [
        false_alarms(outcomes),
        single_effects(outcomes),
        pairs(outcomes),
        twins(outcomes),
        novel_causes(outcomes),
        corrections(outcomes),
    ];
    let (reliability, calibration_error) = reliability(outcomes);
    let mut seconds: Vec<f64> = outcomes.iter().map(|o| o.seconds).collect();
    seconds.sort_by(f64::total_cmp);
    Scoreboard {
        cases: outcomes.len(),
        failed: failed.to_vec(),
        turned: turned.to_vec(),
        rows: rows.concat(),
        reliability,
        calibration_error,
        simpler: simpler(outcomes),
        median_seconds: seconds.get(seconds.len() / 2).copied().unwrap_or(0.0),
    }
}

fn of(outcomes: &[Outcome], kind: Kind) -> impl Iterator<Item = &Outcome> {
    outcomes.iter().filter(move |o| o.kind == kind)
}

fn seen(outcomes: &[Outcome], kind: Kind) -> impl Iterator<Item = &Outcome> {
    of(outcomes, kind).filter(|o| o.is_alarm())
}

fn false_alarms(outcomes: &[Outcome]) -> Vec<Row> {
    let share_of_alarms =
        |what: &str, kind: Kind| share(what, "<= 2 %", of(outcomes, kind), Outcome::is_alarm);
    vec![
        share_of_alarms("false alarms, nothing missing", Kind::Null),
        share_of_alarms("false alarms, sigma 30 % short", Kind::NullQuiet),
        share_of_alarms("false alarms, one outlier", Kind::NullOutlier),
        share(
            "false alarms, all of these",
            "<= 2 %",
            outcomes.iter().filter(|o| o.kind.is_null()),
            Outcome::is_alarm,
        ),
    ]
}

fn single_effects(outcomes: &[Outcome]) -> Vec<Row> {
    let clear = |o: &&Outcome| o.is_separable && o.detectability.iter().all(|d| *d >= 5.0);
    let sizes = seen(outcomes, Kind::Single).map(|o| o.set_size as f64);
    let names = seen(outcomes, Kind::Single).map(|o| o.names_in_set as f64);
    vec![
        share(
            "one effect: seen",
            "",
            of(outcomes, Kind::Single),
            Outcome::is_alarm,
        ),
        share(
            "one effect: right name, detectable and separable",
            ">= 90 %",
            of(outcomes, Kind::Single).filter(clear),
            Outcome::is_right,
        ),
        share(
            "one effect: truth in the 95 % set, where seen",
            "88 to 99 %",
            seen(outcomes, Kind::Single),
            |o| o.in_set,
        ),
        mean("one effect: names in the set", "<= 2.5", names.collect()),
        mean("one effect: hypotheses in the set", "", sizes.collect()),
    ]
}

fn pairs(outcomes: &[Outcome]) -> Vec<Row> {
    vec![
        share(
            "two effects: one of them right, where seen",
            ">= 85 %",
            seen(outcomes, Kind::Pair),
            Outcome::has_one_right,
        ),
        share(
            "two effects: both right, where seen",
            ">= 50 %",
            seen(outcomes, Kind::Pair),
            Outcome::is_right,
        ),
        share(
            "two effects: truth in the 95 % set, where seen",
            "88 to 99 %",
            seen(outcomes, Kind::Pair),
            |o| o.in_set,
        ),
    ]
}

fn twins(outcomes: &[Outcome]) -> Vec<Row> {
    vec![
        share(
            "twins: both in the set and no name at 0.8, where seen",
            ">= 90 %",
            seen(outcomes, Kind::Twin),
            |o| o.in_set && o.probability < 0.8,
        ),
        share(
            "twins: the measurement asked for, made, leaves fewer names than another of the list",
            ">= 65 %",
            of(outcomes, Kind::Twin).filter(|o| o.followed.is_some()),
            |o| o.followed.as_ref().is_some_and(Followed::is_better),
        ),
    ]
}

fn novel_causes(outcomes: &[Outcome]) -> Vec<Row> {
    let known = outcomes
        .iter()
        .filter(|o| o.is_alarm() && matches!(o.kind, Kind::Single | Kind::Pair | Kind::Twin));
    vec![
        share(
            "novel: recognised, misfit over 10 sigma",
            ">= 75 %",
            of(outcomes, Kind::Novel).filter(|o| o.misfit_sigma > PLAIN),
            Outcome::is_right,
        ),
        share(
            "novel: in the set, where seen",
            "88 to 99 %",
            seen(outcomes, Kind::Novel),
            |o| o.in_set,
        ),
        share("falsely declared novel", "<= 5 %", known, |o| {
            o.verdict == Verdict::Novel
        }),
    ]
}

/// Strength and held-out error of the effects that were rightly named.
fn corrections(outcomes: &[Outcome]) -> Vec<Row> {
    let right: Vec<&Outcome> = seen(outcomes, Kind::Single).filter(|o| o.is_right()).collect();
    let falls: Vec<[f64; 3]> = right.iter().filter_map(|o| o.held_out).collect();
    let errors: Vec<[f64; 2]> = right.iter().filter_map(|o| o.strength_error).collect();
    vec![
        middle(
            "strength: median relative error",
            "<= 15 %",
            errors.iter().map(|e| e[0]).collect(),
        ),
        share(
            "strength: within 2 standard errors",
            "88 to 99 %",
            right.iter().copied().filter(|o| o.strength_error.is_some()),
            |o| o.strength_error.is_some_and(|e| e[1] < 2.0),
        ),
        middle(
            "held-out error: median fall, right name",
            ">= 3-fold",
            falls.iter().map(|f| f[0] / f[1]).collect(),
        ),
        middle(
            "held-out error after: median over noise",
            "",
            falls.iter().map(|f| f[1] / f[2]).collect(),
        ),
        share(
            "held-out error worse, right name",
            "<= 5 %",
            right.iter().copied().filter(|o| o.held_out.is_some()),
            |o| o.held_out.is_some_and(|f| f[1] > f[0]),
        ),
    ]
}

fn mean(what: &str, asked: &str, values: Vec<f64>) -> Row {
    Row {
        what: what.to_string(),
        hits: None,
        count: values.len(),
        value: values.iter().sum::<f64>() / values.len().max(1) as f64,
        interval: None,
        asked: asked.to_string(),
    }
}

fn reliability(outcomes: &[Outcome]) -> (Vec<Bin>, f64) {
    let alarms: Vec<&Outcome> = outcomes.iter().filter(|o| o.is_alarm()).collect();
    let mut bins = Vec::new();
    let mut error = 0.0;
    for bin in 0..5 {
        let (low, high) = (f64::from(bin) * 0.2, f64::from(bin + 1) * 0.2);
        let own: Vec<&&Outcome> = alarms
            .iter()
            .filter(|o| o.probability >= low && (o.probability < high || bin == 4))
            .collect();
        if own.is_empty() {
            continue;
        }
        let stated = own.iter().map(|o| o.probability).sum::<f64>() / own.len() as f64;
        let hits = own.iter().filter(|o| o.is_right()).count();
        let count = own.len();
        error += (stated - hits as f64 / count as f64).abs() * count as f64 / alarms.len() as f64;
        bins.push(Bin { stated, hits, count });
    }
    (bins, error)
}

fn simpler(outcomes: &[Outcome]) -> Vec<Row> {
    type Answer = fn(&Outcome) -> &[String];
    let methods: [(&str, Answer); 4] = [
        ("calibrate only", |_| &[]),
        ("best-fitting single effect", |o| &o.simpler.best_fitting),
        ("largest score (LM)", |o| &o.simpler.largest_score),
        ("forward selection by AICc", |o| &o.simpler.forward_selection),
    ];
    let mut rows = Vec::new();
    for (name, answer) in methods {
        let nulls = outcomes.iter().filter(|o| o.kind.is_null());
        rows.push(share(&format!("{name}: false alarms"), "", nulls, |o| {
            !answer(o).is_empty()
        }));
        let singles = outcomes.iter().filter(|o| o.kind == Kind::Single);
        rows.push(share(
            &format!("{name}: one effect, right name"),
            "",
            singles,
            |o| same(answer(o), &o.families()),
        ));
        let pairs = outcomes.iter().filter(|o| o.kind == Kind::Pair);
        rows.push(share(
            &format!("{name}: two effects, both right"),
            "",
            pairs,
            |o| same(answer(o), &o.families()),
        ));
        let novel = outcomes.iter().filter(|o| o.kind == Kind::Novel);
        rows.push(share(
            &format!("{name}: novel, a known name claimed"),
            "",
            novel,
            |o| !answer(o).is_empty(),
        ));
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wilson_is_that_of_the_tables() {
        // 0 of 150: 0 to 2.50 %; 9 of 10: 59.6 to 98.2 %
        let none = wilson(0, 150);
        assert!(
            none[0].abs() < 1e-12 && (none[1] - 0.02497).abs() < 1e-4,
            "{none:?}"
        );
        let nine = wilson(9, 10);
        assert!(
            (nine[0] - 0.596).abs() < 1e-3 && (nine[1] - 0.982).abs() < 1e-3,
            "{nine:?}"
        );
    }
}
