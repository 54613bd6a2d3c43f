//! Singles, pairs and unnamed fields against one another: refits of the best, conditional scores, probabilities.

use crate::progress::Progress;
use crate::study::{Fit, Footing};

use super::baseline::Baseline;
use super::conclude::{conclude, gate};
use super::error::DiagnoseError;
use super::foretold::{Foretold, foretold};
use super::hump::{Hump, Humps, humps};
use super::library::{Family, Scales, Trial, families, heaviest};
use super::novel::{Weighed, weigh};
use super::null::Significance;
use super::pairs::refit_pairs;
use super::posterior::{Belief, Case};
use super::refit::{Explanation, Refits};
use super::screening::{is_one_sided, whole_strength};
use super::second_look::{HALF, HALF_AND_WHOLE, second_look};
use super::strength_error::widen;

/// Explanations this much below the best in ln(prior × evidence) of the linear model are not fitted anew.
const HOPELESS: f64 = 25.0;
/// The same below the best that was fitted anew.
const LOST: f64 = 15.0;
/// Odds against a slip from which on an effect that is all or none may be named.
const SURE: f64 = 20.0;

/// Everything that was weighed.
pub struct Judgement {
    /// Significance of the misfit of the model as it is.
    pub significance: Significance,
    /// Families of the missing effects.
    pub families: Vec<Family>,
    /// Logarithm of the evidence of the model as it is.
    pub ln_nothing: f64,
    /// Explanations by one family.
    pub singles: Vec<Trial>,
    /// Explanations by two.
    pub pairs: Vec<Trial>,
    /// Those fitted anew, with the index of their trial: singles first, then pairs (counted from the end of the singles).
    pub refits: Vec<(usize, Explanation)>,
    /// Trials whose fit settled nowhere.
    pub unsettled: Vec<usize>,
    /// Trials whose standard errors do not hold what a percent of the model moves with their effects.
    pub narrow: Vec<usize>,
    /// Single effects for a step of which the model has no solution, where a second look asked for one.
    pub passed_over: Vec<usize>,
    /// Evidence of each trial (singles, then pairs), with refits where there are.
    pub ln_evidence: Vec<f64>,
    /// Unnamed fields.
    pub weighed: Weighed,
    /// Causes without a name that were tried: none where one effect leaves nothing beyond chance.
    pub humps: Humps,
    /// Hypotheses with probabilities, most probable first.
    pub beliefs: Vec<Belief>,
    /// Significance of what the best single effect leaves.
    pub after_best: Option<Significance>,
    /// Significance of what the best known explanation leaves.
    pub after_known: Option<Significance>,
    /// Whether the best pair may be named.
    pub pair_is_accepted: bool,
    /// Of a misfit that stands on few readings, what an effect with nothing to be fitted says of the first of them.
    pub foretold: Option<Foretold>,
    /// Whether the unnamed fields win.
    pub is_novel: bool,
    /// Probability of none that is known among the explanations that were weighed, before the best known one was checked.
    pub novel_as_weighed: f64,
}

impl Judgement {
    /// Whether the best single effect leaves a misfit that is beyond chance.
    pub fn needs_second(&self, baseline: &Baseline) -> bool {
        let level = baseline.settings.significance;
        self.after_best
            .is_some_and(|left| left.p_null < level || left.p_largest_score.max(left.p_signs) < level)
    }

    /// Whether the heaviest of all that were fitted anew is a pair.
    fn is_best_a_pair(&self) -> bool {
        self.best_refit()
            .is_some_and(|(index, _)| *index >= self.singles.len())
    }

    /// The cause without a name that does best, if it does better than the linear fields.
    pub fn best_hump(&self) -> Option<&Hump> {
        let best = self
            .humps
            .fitted
            .iter()
            .max_by(|a, b| a.ln_evidence.total_cmp(&b.ln_evidence));
        best.filter(|hump| hump.ln_evidence > self.ln_nothing + self.weighed.ln_gain)
    }

    /// Whether it may be that nothing is missing, by the probabilities: a test that asks for nothing in particular may pass what no
    /// hypothesis of nothing explains.
    pub fn believes_nothing(&self, baseline: &Baseline) -> bool {
        let mut nothing = self.beliefs.iter().filter(|belief| belief.case == Case::Nothing);
        nothing.any(|belief| belief.probability >= baseline.settings.significance)
    }

    /// Whether a misfit that stands on few readings is what an effect says that has nothing to be fitted, and no slip.
    pub fn is_foretold(&self) -> bool {
        self.foretold.is_some_and(|foretold| foretold.odds >= SURE)
    }

    /// The trial of that index: singles, then pairs.
    pub fn trial(&self, index: usize) -> &Trial {
        self.singles
            .get(index)
            .unwrap_or_else(|| &self.pairs[index - self.singles.len()])
    }

    /// Logarithm of prior times evidence of a trial.
    pub fn weight(&self, index: usize) -> f64 {
        self.trial(index).ln_prior + self.ln_evidence[index]
    }

    /// Notes what a fit of a trial found, if it settled anywhere, and better than one before; says by how much its evidence rose.
    pub fn take(&mut self, index: usize, found: Option<Explanation>) -> Option<f64> {
        let known = self.refits.iter().position(|(known, _)| *known == index);
        let Some(found) = found else {
            if known.is_none() {
                self.unsettled.push(index);
            }
            return None;
        };
        let rise = found.ln_evidence - self.ln_evidence[index];
        if let Some(known) = known {
            if rise <= 0.0 {
                return None;
            }
            self.refits.remove(known);
        }
        self.ln_evidence[index] = found.ln_evidence;
        self.refits.push((index, found));
        Some(rise)
    }

    /// The heaviest of all that were fitted anew, with its trial.
    pub fn best_refit(&self) -> Option<&(usize, Explanation)> {
        self.refits
            .iter()
            .max_by(|a, b| self.weight(a.0).total_cmp(&self.weight(b.0)))
    }

    /// Whether a trial was fitted anew.
    pub fn is_refitted(&self, index: usize) -> bool {
        self.refits.iter().any(|(known, _)| *known == index)
    }

    /// The heaviest trial of `families` and, if it was fitted anew, its explanation.
    pub fn best_of(&self, families: &[usize]) -> Option<(usize, Option<&Explanation>)> {
        // trials have theirs in ascending order
        let mut families = families.to_vec();
        families.sort_unstable();
        let count = self.singles.len() + self.pairs.len();
        let own = (0..count).filter(|&index| self.trial(index).families == families);
        let weight = |index: usize| self.weight(index);
        let refitted = self
            .refits
            .iter()
            .filter(|(index, _)| self.trial(*index).families == families);
        let best_refit = refitted.max_by(|a, b| weight(a.0).total_cmp(&weight(b.0)));
        if let Some((index, explanation)) = best_refit {
            return Some((*index, Some(explanation)));
        }
        own.max_by(|&a, &b| weight(a).total_cmp(&weight(b)))
            .map(|index| (index, None))
    }

    /// Distance between the best explanations by two families, in standard deviations: how far the data tell them apart
    /// at the strength found.
    pub fn distance(&self, baseline: &Baseline, a: usize, b: usize) -> f64 {
        let (Some((trial_a, fit_a)), Some((trial_b, fit_b))) = (self.best_of(&[a]), self.best_of(&[b]))
        else {
            return f64::INFINITY;
        };
        if let (Some(a), Some(b)) = (fit_a, fit_b) {
            return between_fits(baseline, a, b);
        }
        let (a, b) = (self.trial(trial_a).members[0], self.trial(trial_b).members[0]);
        let directions = &baseline.directions;
        let score = |k: usize| directions.scores[k].abs();
        let unknown = |k: usize| &baseline.forward.unknowns()[baseline.data.missing[k]];
        // an effect of one sign that would need the other explains nothing of what moves the data
        let is_possible = |k: usize| directions.scores[k] > 0.0 || !is_one_sided(unknown(k));
        // what is all or none has no direction at none, but a misfit, and so has the other by the linear model
        for (whole, fit, other) in [(a, fit_a, b), (b, fit_b, a)] {
            if let (Some(fit), Some(_)) = (fit, whole_strength(unknown(whole))) {
                let taken = if is_possible(other) {
                    score(other).powi(2)
                } else {
                    0.0
                };
                return (baseline.whitened.q() - taken - fit.q).max(0.0).sqrt();
            }
        }
        match (is_possible(a), is_possible(b)) {
            (true, true) => {
                let cosine = directions.cosine(a, b);
                score(a).max(score(b)) * (1.0 - cosine * cosine).max(0.0).sqrt()
            }
            (true, false) => score(a),
            (false, true) => score(b),
            (false, false) => score(a).max(score(b)),
        }
    }
}

fn between_fits(baseline: &Baseline, a: &Explanation, b: &Explanation) -> f64 {
    match (&a.fit, &b.fit) {
        (Some(a), Some(b)) => distance_of_fits(baseline, a, b),
        _ => f64::INFINITY,
    }
}

/// Distance between two fits, in standard deviations of data and priors.
pub fn distance_of_fits(baseline: &Baseline, a: &Fit, b: &Fit) -> f64 {
    let unknowns = baseline.forward.unknowns();
    let apart = (&a.residual - &b.residual).norm_squared();
    let pulls: f64 = baseline
        .data
        .model
        .iter()
        .map(|&i| ((a.at[i] - b.at[i]) / unknowns[i].sigma).powi(2))
        .sum();
    (apart + pulls).sqrt()
}

/// Weighs everything against everything.
///
/// # Errors
/// If a derivative is not finite, or the user asked to stop.
pub fn judge(baseline: &Baseline, progress: &Progress) -> Result<Judgement, DiagnoseError> {
    let (settings, data, forward) = (baseline.settings, &baseline.data, baseline.forward);
    let significance = baseline.significance(&baseline.whitened, &baseline.directions);
    let is_null = significance.p_null > settings.significance;
    let families = families(forward, data, &baseline.directions.lengths);
    let scales = Scales::of(baseline);
    let singles = scales.singles(&families, settings.prior.one);
    let pairs = scales.pairs(&families, settings.prior.two);
    let ln_nothing = baseline.likelihood.ln(baseline.whitened.q()) - 0.5 * baseline.whitened.ln_determinant;
    let ln_evidence = singles
        .iter()
        .chain(&pairs)
        .map(|trial| ln_nothing + trial.linear.ln_gain)
        .collect();
    let weighed = weigh(
        &baseline.fields,
        &baseline.seen,
        &baseline.whitened,
        baseline.likelihood,
    );
    let mut judgement = Judgement {
        significance,
        families,
        ln_nothing,
        singles,
        pairs,
        refits: Vec::new(),
        unsettled: Vec::new(),
        narrow: Vec::new(),
        passed_over: Vec::new(),
        ln_evidence,
        weighed,
        humps: Humps::default(),
        beliefs: Vec::new(),
        after_best: None,
        after_known: None,
        pair_is_accepted: false,
        foretold: None,
        is_novel: false,
        novel_as_weighed: 0.0,
    };
    let footing = baseline.footing.as_ref().map(Footing::for_trials);
    let refits = baseline.refits(footing.as_ref());
    let count = if is_null {
        2.min(settings.refits)
    } else {
        settings.refits
    };
    refit_singles(&mut judgement, &refits, count, progress)?;
    if !is_null {
        second_look(&mut judgement, baseline, &refits, &HALF, progress)?;
        refit_pairs(&mut judgement, baseline, &refits, progress)?;
        if judgement.needs_second(baseline) || judgement.is_best_a_pair() {
            judgement.humps = humps(baseline, &refits, progress)?;
        }
    }
    conclude(&mut judgement, baseline);
    if !is_null {
        gate(&mut judgement, baseline)?;
    } else if !judgement.believes_nothing(baseline) {
        second_look(&mut judgement, baseline, &refits, &HALF_AND_WHOLE, progress)?;
        conclude(&mut judgement, baseline);
        judgement.foretold = foretold(baseline, &judgement)?;
        if judgement.is_foretold() {
            gate(&mut judgement, baseline)?;
        }
    }
    if !is_null || judgement.is_foretold() {
        widen(&mut judgement, baseline, progress)?;
    }
    Ok(judgement)
}

fn refit_singles(
    judgement: &mut Judgement,
    refits: &Refits,
    count: usize,
    progress: &Progress,
) -> Result<(), DiagnoseError> {
    let chosen = heaviest(&judgement.singles, count, 2);
    let Some(&first) = chosen.first() else {
        return Ok(());
    };
    // of what is all or none a derivative at none says nothing
    let unknowns = refits.forward.unknowns();
    let is_whole = |member: &usize| whole_strength(&unknowns[refits.data.missing[*member]]).is_some();
    for index in 0..judgement.singles.len() {
        let members = judgement.singles[index].members.clone();
        if members.iter().any(is_whole) {
            progress.check()?;
            let found = refits.refit(&members, &[1.0])?;
            judgement.take(index, found);
        }
    }
    let mut offsets = Vec::new();
    for index in chosen {
        progress.check()?;
        if judgement.is_refitted(index) {
            continue;
        }
        let trial = &judgement.singles[index];
        let fitted = judgement.refits.iter();
        let best = fitted
            .map(|(index, found)| judgement.singles[*index].ln_prior + found.ln_evidence)
            .fold(f64::NEG_INFINITY, f64::max);
        let hoped = trial.ln_prior + judgement.ln_evidence[index];
        if hoped < best - LOST || trial.ln_weight() < judgement.singles[first].ln_weight() - HOPELESS {
            break;
        }
        progress.say(format_args!("refit {} of {count}", judgement.refits.len() + 1));
        let estimates = &trial.linear.estimate[..trial.members.len()];
        let found = refits.refit(&trial.members, estimates)?;
        offsets.extend(judgement.take(index, found));
    }
    // what the linear model promised too much, it promised the others too
    offsets.sort_by(f64::total_cmp);
    let offset = offsets.get(offsets.len() / 2).copied().unwrap_or(0.0).min(0.0);
    for index in 0..judgement.ln_evidence.len() {
        if !judgement.refits.iter().any(|(known, _)| *known == index) {
            judgement.ln_evidence[index] += offset;
        }
    }
    Ok(())
}
