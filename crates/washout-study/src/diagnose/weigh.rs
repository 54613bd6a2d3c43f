//! Nothing, one known effect, two, or a cause without a name: how probable each is, all sizes of error and all strengths summed over.
//!
//! Every hypothesis says what the readings should be, y ~ N(f(x₀, 0) + c(ψ), Σ), with the change c that the effect makes at strength ψ and
//! Σ of [`ModelError`](super::model_error::ModelError), in which the uncertain inputs, the error of the formulation, what the mesh leaves and the error of the effect's own
//! formula stand. An unknown cause is a smooth error of reading larger than any formulation should have. Probabilities are priors times
//! sums over strengths and sizes; there is no further test.

use nalgebra::DMatrix;
use rayon::iter::{IntoParallelIterator, IntoParallelRefIterator, ParallelIterator};

use super::error::DiagnoseError;
use super::evidence::{ln_sum, place_of_largest};
use super::library::{Family, Trial};
use super::model_error::{OWN_SIZES, OwnSize, Size};
use super::pairs::{pairs, together};
use super::responses::{Node, Response, Responses, beside};
use super::screening::effect_of;
use super::settings::Settings;
use super::unknown::unknown;
use super::weights::{Level, Member, Seen, Weights, strength};

/// Strengths about which the error of an effect's own formula is taken.
const ANCHORS: usize = 5;
/// ln of the probability of a size, over that of the most probable, below which effects are not weighed with it.
const IMPROBABLE: f64 = -9.0;
/// ln of prior times evidence, over that of the best, below which an effect is not looked at closely.
const HOPELESS: f64 = -14.0;
/// Strengths at which an effect moves the readings by less, in standard deviations, what the uncertain inputs take up left out, cannot be told
/// from none: they belong to *nothing detectable*. Assumed; looked at on 24 cases of another model with 0, 1, 1.5 and 2. The larger, the more
/// probable is nothing where nothing is missing, and the less the right effect where one is.
const DETECTABLE: f64 = 1.5;
/// An own error below this size, in standard deviations, changes nothing.
const TOO_SMALL: f64 = 0.3;

/// How probable everything is, before anything is fitted anew.
#[derive(Debug, Clone)]
pub struct Weighing {
    /// ln of prior times evidence of nothing missing.
    pub ln_nothing: f64,
    /// The same of a cause without a name.
    pub ln_unknown: f64,
    /// Single effects, by position among the missing.
    pub singles: Vec<Trial>,
    /// Pairs that were weighed.
    pub pairs: Vec<Trial>,
    /// Pairs, by positions among the missing, that have no solution together: their changes are added.
    pub unsolved: Vec<Vec<usize>>,
    /// Mean of the share of formulation error.
    pub share: f64,
    /// Mean of the scale of the scatter.
    pub scale: f64,
}

/// Weighs everything that may be missing.
///
/// # Errors
/// If a result is not finite.
pub fn weigh(
    seen: &Seen,
    responses: &Responses,
    families: &[Family],
    settings: &Settings,
) -> Result<Weighing, DiagnoseError> {
    let mut weights = Weights::new(&seen.error, &seen.residual, settings)?;
    let shares = shares_of_families(seen, families);
    let mut members = members(&weights, (seen, responses), families, &shares);
    let shares = shared_by_what_is_detectable(&mut members, families.len());
    let prior = settings.prior;
    let mut of_sizes = vec![f64::NEG_INFINITY; weights.levels.len()];
    let plain = weights.less(&DMatrix::zeros(seen.residual.len(), 1));
    let ln_nothing = take(&mut of_sizes, prior.nothing.ln(), &weights.of(None, &plain)?);
    let by_nothing: Vec<f64> = of_sizes.iter().map(|ln| ln - prior.novel.ln()).collect();
    let of_unknown = unknown(&weights, seen.fields, &by_nothing)?;
    let ln_unknown = take(&mut of_sizes, prior.novel.ln(), &of_unknown);
    // what neither of these makes probable, no effect does: a cause without a name takes up whatever is smooth
    let most = of_sizes.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mut is_looked_at = of_sizes.iter().map(|ln| *ln > most + IMPROBABLE);
    weights.levels.retain(|_| is_looked_at.next() == Some(true));
    of_sizes.retain(|ln| *ln > most + IMPROBABLE);
    let found = all_singles(&weights, &members, prior.one.ln(), &of_sizes)?;
    let mut singles = Vec::new();
    for (k, (member, found)) in members.iter().zip(&found).enumerate() {
        let (Some(family), Some(found)) = (member.family, found) else {
            continue;
        };
        let ln_prior = prior.one.ln() + member.ln_prior;
        let ln_weight = take(&mut of_sizes, ln_prior, found);
        let lns = [ln_prior, ln_weight];
        singles.push(trial(&weights.levels, member, (k, family), lns, found));
    }
    let members: Vec<Member> = members.iter().map(Member::plausible).collect();
    let mut pairs = pairs(&weights, &members, &singles, &shares, prior.two)?;
    let others = singles.iter().map(|trial| trial.ln_weight);
    let most = others
        .chain([ln_nothing, ln_unknown])
        .fold(f64::NEG_INFINITY, f64::max);
    let with = |at: [(usize, f64); 2]| seen.with(at);
    let unsolved = together(&weights, &members, &mut pairs, most, &with)?;
    let of_sizes = DMatrix::from_column_slice(of_sizes.len(), 1, &of_sizes);
    let [share, scale] = mean_size(&weights.levels, &of_sizes);
    Ok(Weighing {
        ln_nothing,
        ln_unknown,
        singles,
        pairs,
        unsolved,
        share,
        scale,
    })
}

/// One effect, with its strength from the densities `found` for every size (row) and strength (column).
fn trial(
    levels: &[Level],
    member: &Member,
    (k, family): (usize, usize),
    [ln_prior, ln_weight]: [f64; 2],
    found: &DMatrix<f64>,
) -> Trial {
    let of_nodes: Vec<f64> = found
        .column_iter()
        .map(|own| ln_sum(own.iter().copied()))
        .collect();
    let [best, strength, error] = strength(member, &of_nodes);
    Trial {
        members: vec![k],
        families: vec![family],
        ln_prior,
        ln_weight,
        best: vec![best],
        strength: vec![strength],
        error: vec![error],
        size: Some(mean_size(levels, found)),
    }
}

/// Mean share of formulation error and scale of the scatter, from densities for every size (row).
fn mean_size(levels: &[Level], found: &DMatrix<f64>) -> [f64; 2] {
    let of_sizes: Vec<f64> = found.row_iter().map(|row| ln_sum(row.iter().copied())).collect();
    let whole = ln_sum(of_sizes.iter().copied());
    let mean = |of: &dyn Fn(&Size) -> f64| {
        let parts = levels.iter().zip(&of_sizes);
        parts
            .map(|(level, ln)| of(&level.size) * (ln - whole).exp())
            .sum()
    };
    [mean(&|size| size.share), mean(&|size| size.scale)]
}

/// ln of prior times evidence of a hypothesis, from its densities for every size (row); it is added to what each size has.
fn take(of_sizes: &mut [f64], ln_prior: f64, found: &DMatrix<f64>) -> f64 {
    for (whole, row) in of_sizes.iter_mut().zip(found.row_iter()) {
        *whole = ln_sum([*whole, ln_prior + ln_sum(row.iter().copied())].into_iter());
    }
    ln_prior + ln_sum(found.iter().copied())
}

/// Shares of the families in the prior of one effect: with the root of how many effects they hold, for these are neither alternatives of one
/// kind nor causes of their own.
fn shares_of_families(seen: &Seen, families: &[Family]) -> Vec<f64> {
    let unknowns = seen.forward.unknowns();
    let effects = |family: &Family| {
        let own = family.members.iter().map(|&k| &unknowns[seen.data.missing[k]]);
        let mut names: Vec<Option<&str>> = own.map(|unknown| effect_of(unknown).map(|of| of.0)).collect();
        names.sort_unstable();
        names.dedup();
        (names.len() as f64).sqrt()
    };
    let roots: Vec<f64> = families.iter().map(effects).collect();
    let whole: f64 = roots.iter().sum();
    roots.into_iter().map(|root| root / whole).collect()
}

/// One effect in the prior is one that can be detected: every share of it becomes as much less as less of its strengths can be, all
/// together as much more. Gives the shares of so many families.
fn shared_by_what_is_detectable(members: &mut [Member], families: usize) -> Vec<f64> {
    let mut shares = vec![0.0; families];
    for member in members.iter() {
        if let Some(family) = member.family {
            let strengths: f64 = member.nodes.iter().map(|node| node.ln_prior.exp()).sum();
            shares[family] += member.ln_prior.exp() * strengths;
        }
    }
    let whole: f64 = shares.iter().sum();
    if whole == 0.0 {
        return shares;
    }
    for member in members {
        member.ln_prior -= whole.ln();
    }
    shares.into_iter().map(|share| share / whole).collect()
}

/// Every missing effect with the strengths at which it is weighed, those that can be detected; the prior of a family (its share in `shares`)
/// is shared evenly among its effects, and then among their places.
fn members(
    weights: &Weights,
    (seen, responses): (&Seen, &Responses),
    families: &[Family],
    shares: &[f64],
) -> Vec<Member> {
    let unknowns = seen.forward.unknowns();
    let missing = &seen.data.missing;
    let effect = |k: usize| effect_of(&unknowns[missing[k]]).map(|(effect, ..)| effect);
    let of_family = |k: usize| families.iter().position(|family| family.members.contains(&k));
    let rows = &seen.data.rows;
    let changes =
        |nodes: &[Node]| DMatrix::from_fn(rows.len(), nodes.len(), |i, node| nodes[node].change[rows[i]]);
    let left = weights.whitened(&weights.less(&DMatrix::zeros(rows.len(), 1)));
    let likely = |nodes: &[Node]| -> Vec<f64> {
        let seen = weights.whitened(&changes(nodes));
        seen.column_iter()
            .map(|own| -(left.column(0) - own).norm_squared())
            .collect()
    };
    (0..missing.len())
        .into_par_iter()
        .map(|k| {
            let unknown = &unknowns[missing[k]];
            let family = of_family(k);
            let nodes = match family {
                Some(_) => {
                    let nodes = responses.each[k].nodes(unknown, likely);
                    let others = beside(unknowns, missing, k).into_iter();
                    let others: Vec<&Response> = others.map(|other| &responses.each[other]).collect();
                    Response::between_places(nodes, &others)
                }
                None => Vec::new(),
            };
            let ln_prior = family.map_or(f64::NEG_INFINITY, |family| {
                let own = &families[family].members;
                let share = shares[family];
                let mut effects: Vec<Option<&str>> = own.iter().map(|&j| effect(j)).collect();
                let places = effects.iter().filter(|other| **other == effect(k)).count();
                effects.sort_unstable();
                effects.dedup();
                share.ln() - ((effects.len() * places) as f64).ln()
            });
            let member = Member {
                changes: changes(&nodes),
                nodes,
                own_error: unknown.own_error(),
                ln_prior,
                family,
            };
            let far = weights.whitened(&member.changes);
            member.at(|node| far.column(node).norm() >= DETECTABLE)
        })
        .collect()
}

/// [`single`] of every effect that the data can see. What is hopeless at the size of errors that is most probable, its own formula known as
/// badly as it may be, is weighed there alone. `of_sizes`: ln of how probable each size is by what is no effect.
fn all_singles(
    weights: &Weights,
    members: &[Member],
    ln_one: f64,
    of_sizes: &[f64],
) -> Result<Vec<Option<DMatrix<f64>>>, DiagnoseError> {
    let seen: Vec<&Member> = members.iter().filter(|member| member.family.is_some()).collect();
    let best = place_of_largest(of_sizes).unwrap_or(0);
    // what an effect leaves may be more than what a cause without a name leaves: the next larger share, too
    let size = |level: usize| weights.levels[level].size;
    let is_wider =
        |&level: &usize| size(level).scale == size(best).scale && size(level).share > size(best).share;
    let wider = (0..weights.levels.len()).filter(is_wider);
    let wider = wider.min_by(|&a, &b| size(a).share.total_cmp(&size(b).share));
    let glanced_at: Vec<usize> = [best].into_iter().chain(wider).collect();
    let [.., widest] = OWN_SIZES;
    let glance = |member: &&Member| single(weights, member, &glanced_at, &[widest]);
    let glanced: Vec<DMatrix<f64>> = seen.par_iter().map(glance).collect::<Result<_, _>>()?;
    let ln_of = |(member, found): (&&Member, &DMatrix<f64>)| {
        ln_one + member.ln_prior + ln_sum(found.iter().copied().filter(|ln| ln.is_finite()))
    };
    let lns: Vec<f64> = seen.iter().zip(&glanced).map(ln_of).collect();
    let most = lns
        .iter()
        .chain(of_sizes)
        .copied()
        .fold(f64::NEG_INFINITY, f64::max);
    let every: Vec<usize> = (0..weights.levels.len()).collect();
    let whole: Vec<DMatrix<f64>> = (0..seen.len())
        .into_par_iter()
        .map(|own| match lns[own] > most + HOPELESS {
            true => single(weights, seen[own], &every, &OWN_SIZES),
            false => Ok(glanced[own].clone()),
        })
        .collect::<Result<_, _>>()?;
    let mut whole = whole.into_iter();
    let of_member = |member: &Member| member.family.and_then(|_| whole.next());
    Ok(members.iter().map(of_member).collect())
}

/// ln of the density of the readings at each strength (column) of one effect for every size (row) in `looked_at`, the prior of the strength
/// in it, summed over how badly its own formula is known (`own_sizes`); −∞ for the other sizes.
fn single(
    weights: &Weights,
    member: &Member,
    looked_at: &[usize],
    own_sizes: &[OwnSize],
) -> Result<DMatrix<f64>, DiagnoseError> {
    let residuals = weights.less(&member.changes);
    let count = residuals.ncols();
    let mut found = DMatrix::from_element(weights.levels.len(), count, f64::NEG_INFINITY);
    let anchors: Vec<usize> = (0..ANCHORS).map(|a| a * (count - 1) / (ANCHORS - 1)).collect();
    let nearest = |node: usize| anchors.iter().min_by_key(|anchor| anchor.abs_diff(node)).copied();
    let largest = weights.whitened(&member.changes);
    let mut done: Vec<usize> = Vec::new();
    for &anchor in &anchors {
        if done.contains(&anchor) {
            continue;
        }
        done.push(anchor);
        let own: Vec<usize> = (0..count).filter(|&node| nearest(node) == Some(anchor)).collect();
        let residuals = residuals.select_columns(own.iter());
        let widest = own_sizes.iter().map(|own| own.factor).fold(0.0, f64::max);
        let matters = widest * member.own_error * largest.column(anchor).norm() > TOO_SMALL;
        let change = member.changes.column(anchor).into_owned();
        let sizes = if matters { own_sizes } else { &[OwnSize::EXACT] };
        for size in sizes {
            let more = matters.then(|| weights.error.own(&change, member.own_error, size.factor));
            for &row in looked_at {
                let level = &weights.levels[row];
                let root = level.root(more.as_ref())?;
                let ln_size = level.ln_size(&root);
                for (&node, left) in own.iter().zip(root.whiten(&residuals).column_iter()) {
                    let ln =
                        size.ln_prior + member.nodes[node].ln_prior + ln_size - 0.5 * left.norm_squared();
                    found[(row, node)] = ln_sum([found[(row, node)], ln].into_iter());
                }
            }
        }
    }
    Ok(found)
}
