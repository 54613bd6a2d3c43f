//! Two known effects at once: their changes add, with a share of their product, and so do the errors of their formulas. The best are found among all pairs with effects
//! taken as exact, and among those with one of the best single effects, whose error is then counted; these are weighed with both errors.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, DVector};
use rayon::iter::{IntoParallelIterator, IntoParallelRefIterator, ParallelIterator};

use super::error::DiagnoseError;
use super::evidence::ln_sum;
use super::library::Trial;
use super::model_error::OWN_SIZES;
use super::responses::Node;
use super::weights::{Member, Weights, strength};

/// Strengths of an effect that are looked at among all pairs.
const GLANCES: usize = 6;
/// Pairs of the search among all that are weighed with the errors of both effects; of those with one of the best single effects, twice as many.
const WEIGHED: usize = 12;
/// Single effects with which all others are paired.
const FIRST: usize = 6;
/// Rounds in which the strengths at which own errors are taken settle.
const ROUNDS: usize = 3;
/// Pairs that are weighed with what both make at once.
const TOGETHER: usize = 6;
/// ln of prior times evidence, over that of the best explanation, from which on a pair is solved.
const IN_THE_RUNNING: f64 = -3.5;
/// How often the best are looked at again, for what was solved falls behind others.
const RETURNS: usize = 3;
/// What two effects make besides the sum of what each makes, over their product by what the wing reads, and how well that is known: of 22
/// pairs that were solved on three rods, half lie between 0.45 and 0.77, the median is 0.65.
const PRODUCT: f64 = 0.6;
const INTERPLAY: f64 = 0.4;
/// Share to which what two effects make besides is known, where it was solved at one pair of strengths; assumed.
const OWN_OF_BOTH: f64 = 0.2;

/// Change of the fitted readings by two effects, each with a strength; none if the model has no solution there.
pub type Both<'a> = dyn Fn([(usize, f64); 2]) -> Result<Option<DVector<f64>>, DiagnoseError> + Sync + 'a;

/// A pair: positions of its effects among the missing, nodes where it was best.
type Found = ([usize; 2], [usize; 2]);

/// Weighs pairs of effects of different families; `prior`: of two effects, shared among pairs of families by their `shares`.
///
/// # Errors
/// If a covariance is not positive definite.
pub fn pairs(
    weights: &Weights,
    members: &[Member],
    singles: &[Trial],
    shares: &[f64],
    prior: f64,
) -> Result<Vec<Trial>, DiagnoseError> {
    if shares.len() < 2 {
        return Ok(Vec::new());
    }
    // a member's own prior holds the share of its family; those of all pairs of families sum to this
    let of_pairs = 0.5 * (1.0 - shares.iter().map(|share| share * share).sum::<f64>());
    let ln_prior = prior.ln() - of_pairs.ln();
    let ln_prior_of = |pair: [usize; 2]| ln_prior + members[pair[0]].ln_prior + members[pair[1]].ln_prior;
    let visible: Vec<usize> = singles
        .iter()
        .map(|trial| trial.members[0])
        .filter(|&k| !members[k].nodes.is_empty())
        .collect();
    let glances = glances(members, &visible);
    if glances.is_empty() {
        return Ok(Vec::new());
    }
    let glanced = DMatrix::from_columns(
        &glances
            .iter()
            .map(|&(k, node)| members[k].changes.column(node).into_owned())
            .collect::<Vec<_>>(),
    );
    let mut chosen: Vec<Found> = best_of_all(weights, members, &glances, &glanced, &ln_prior_of)?;
    let with_first: Vec<Vec<(f64, Found)>> = best_singles(singles, &visible)
        .into_par_iter()
        .map(|trial| beside(weights, members, trial, &glances, &glanced, &ln_prior_of))
        .collect::<Result<_, _>>()?;
    let mut rough: Vec<(f64, Found)> = with_first.concat();
    rough.sort_by(|a, b| b.0.total_cmp(&a.0));
    chosen.extend(rough.iter().take(2 * WEIGHED).map(|(_, found)| *found));
    let mut distinct: BTreeMap<[usize; 2], [usize; 2]> = BTreeMap::new();
    for (pair, nodes) in chosen {
        distinct.entry(pair).or_insert(nodes);
    }
    let mut trials: Vec<Trial> = distinct
        .iter()
        .collect::<Vec<_>>()
        .into_par_iter()
        .map(|(&pair, &nodes)| weighed(weights, members, (pair, nodes), None, ln_prior_of(pair)))
        .collect::<Result<_, _>>()?;
    for (ln_weight, (pair, nodes)) in rough {
        if distinct.insert(pair, nodes).is_none() {
            trials.push(of_nodes(members, (pair, nodes), [ln_prior_of(pair), ln_weight]));
        }
    }
    Ok(trials)
}

/// Strengths of the `visible` effects that are looked at: position of the effect, node.
fn glances(members: &[Member], visible: &[usize]) -> Vec<(usize, usize)> {
    let of_effect = |&k: &usize| {
        let count = members[k].nodes.len();
        let mut nodes: Vec<usize> = (0..GLANCES.min(count))
            .map(|glance| (2 * glance + 1) * count / (2 * GLANCES.min(count)))
            .collect();
        nodes.dedup();
        nodes.into_iter().map(move |node| (k, node))
    };
    visible.iter().flat_map(of_effect).collect()
}

fn best_singles<'a>(singles: &'a [Trial], visible: &[usize]) -> Vec<&'a Trial> {
    let mut first: Vec<&Trial> = singles
        .iter()
        .filter(|trial| visible.contains(&trial.members[0]))
        .collect();
    first.sort_by(|a, b| b.ln_weight.total_cmp(&a.ln_weight));
    first.truncate(FIRST);
    first
}

/// Weighs the best pairs anew with what the model reads with both at once: what two effects make together is not the sum of what each makes
/// alone, least of all where one of them is stiff. `with`: change of the fitted
/// readings by two effects at given strengths; `most`: ln of prior times evidence of the best other explanation. Gives the pairs that have no
/// solution together, which stay as they were.
///
/// # Errors
/// If a covariance is not positive definite, or the user asked to stop.
pub fn together(
    weights: &Weights,
    members: &[Member],
    pairs: &mut [Trial],
    most: f64,
    with: &Both,
) -> Result<Vec<Vec<usize>>, DiagnoseError> {
    let mut solved: Vec<Vec<usize>> = Vec::new();
    let mut unsolved: Vec<Vec<usize>> = Vec::new();
    for _ in 0..RETURNS {
        pairs.sort_by(|a, b| b.ln_weight.total_cmp(&a.ln_weight));
        let first = pairs.first().map_or(most, |first| first.ln_weight.max(most));
        let is_open =
            |trial: &&mut Trial| trial.ln_weight > first + IN_THE_RUNNING && !solved.contains(&trial.members);
        let open: Vec<&mut Trial> = pairs.iter_mut().take(TOGETHER).filter(is_open).collect();
        solved.extend(open.iter().map(|trial| trial.members.clone()));
        let anew: Vec<Option<Trial>> = open
            .par_iter()
            .map(|trial| solved_together(weights, members, trial, with))
            .collect::<Result<_, _>>()?;
        for (trial, anew) in open.into_iter().zip(anew) {
            match anew {
                Some(anew) => *trial = anew,
                None => unsolved.push(trial.members.clone()),
            }
        }
    }
    Ok(unsolved)
}

/// A pair weighed with what the model reads with both at their best strengths; none if there is no solution.
fn solved_together(
    weights: &Weights,
    members: &[Member],
    trial: &Trial,
    with: &Both,
) -> Result<Option<Trial>, DiagnoseError> {
    let pair = [trial.members[0], trial.members[1]];
    let at = [trial.best[0], trial.best[1]];
    let Some(both) = with([(pair[0], at[0]), (pair[1], at[1])])? else {
        return Ok(None);
    };
    let nodes = [0, 1].map(|own| {
        let mut nodes = members[pair[own]].nodes.iter();
        let is_its = |node: &Node| node.is_in_place && node.strength == at[own];
        nodes.position(is_its).unwrap_or(0)
    });
    let alone = |own: usize| members[pair[own]].changes.column(nodes[own]);
    let mixed = Mixed {
        change: both - alone(0) - alone(1),
        at,
    };
    weighed(weights, members, (pair, nodes), Some(&mixed), trial.ln_prior).map(Some)
}

/// What two effects at these strengths make besides the sum of what each makes alone; in proportion to both.
struct Mixed {
    change: DVector<f64>,
    at: [f64; 2],
}

/// The best pairs of all, effects taken as exact.
fn best_of_all(
    weights: &Weights,
    members: &[Member],
    glances: &[(usize, usize)],
    changes: &DMatrix<f64>,
    ln_prior: &(dyn Fn([usize; 2]) -> f64 + Sync),
) -> Result<Vec<Found>, DiagnoseError> {
    let count = glances.len();
    let mut best: Vec<f64> = vec![f64::NEG_INFINITY; count * count];
    let mut columns = changes.clone().insert_column(count, 0.0);
    columns.set_column(count, weights.residual);
    for level in &weights.levels {
        let root = level.root(None)?;
        let (ln_size, whitened) = (level.ln_size(&root), root.whiten(&columns));
        let gram = whitened.transpose() * &whitened;
        let q0 = gram[(count, count)];
        for i in 0..count {
            let own = gram[(i, i)] - 2.0 * gram[(i, count)];
            for j in 0..i {
                let q = q0 + own + gram[(j, j)] - 2.0 * gram[(j, count)] + 2.0 * gram[(i, j)];
                let ln = ln_size - 0.5 * q;
                let known = &mut best[i * count + j];
                *known = known.max(ln);
            }
        }
    }
    let mut of_pair: BTreeMap<[usize; 2], (f64, [usize; 2])> = BTreeMap::new();
    for i in 0..count {
        for j in 0..i {
            let (a, b) = (glances[j], glances[i]);
            if members[a.0].family == members[b.0].family {
                continue;
            }
            let (pair, nodes) = ordered(a, b);
            let ln = best[i * count + j];
            let known = of_pair.entry(pair).or_insert((f64::NEG_INFINITY, nodes));
            if ln > known.0 {
                *known = (ln, nodes);
            }
        }
    }
    let mut found: Vec<(f64, Found)> = of_pair
        .into_iter()
        .map(|(pair, (ln, nodes))| (ln + ln_prior(pair), (pair, nodes)))
        .collect();
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    Ok(found.into_iter().take(WEIGHED).map(|(_, found)| found).collect())
}

fn ordered(a: (usize, usize), b: (usize, usize)) -> Found {
    match a.0 < b.0 {
        true => ([a.0, b.0], [a.1, b.1]),
        false => ([b.0, a.0], [b.1, a.1]),
    }
}

/// Every pair with the effect of `trial`, the error of whose formula is counted at its best strength: prior times evidence, where best.
fn beside(
    weights: &Weights,
    members: &[Member],
    trial: &Trial,
    glances: &[(usize, usize)],
    changes: &DMatrix<f64>,
    ln_prior: &(dyn Fn([usize; 2]) -> f64 + Sync),
) -> Result<Vec<(f64, Found)>, DiagnoseError> {
    let first = trial.members[0];
    let own = &members[first];
    let best = own
        .nodes
        .iter()
        .enumerate()
        .min_by(|(_, a), (_, b)| {
            let off = |node: &Node| (node.strength - trial.best[0]).abs();
            off(a).total_cmp(&off(b))
        })
        .map_or(0, |(best, _)| best);
    if own.nodes.is_empty() {
        return Ok(Vec::new());
    }
    let more = weights
        .error
        .own(&own.changes.column(best).into_owned(), own.own_error, 1.0);
    let block = block(weights, Some(&more), [&own.changes, changes], None)?;
    let mut found: BTreeMap<[usize; 2], (Vec<f64>, f64, [usize; 2])> = BTreeMap::new();
    for (column, &(other, node)) in glances.iter().enumerate() {
        if members[other].family == own.family {
            continue;
        }
        for (row, ln) in block.column(column).iter().enumerate() {
            let (pair, nodes) = ordered((first, row), (other, node));
            let (all, most, at) = found
                .entry(pair)
                .or_insert((Vec::new(), f64::NEG_INFINITY, nodes));
            all.push(ln + own.nodes[row].ln_prior);
            if *ln > *most {
                (*most, *at) = (*ln, nodes);
            }
        }
    }
    let found = found.into_iter().map(|(pair, (all, _, nodes))| {
        // the other's strengths that are looked at stand for all, evenly
        let looked_at = (all.len() / own.nodes.len()) as f64;
        (
            ln_prior(pair) + ln_sum(all.into_iter()) - looked_at.ln(),
            (pair, nodes),
        )
    });
    Ok(found.collect())
}

/// ln of the density of the readings with changes of two effects, sizes summed over: a row for each strength of the first. `mixed`: what
/// both make besides, and the shares of it at their strengths.
fn block(
    weights: &Weights,
    more: Option<&DMatrix<f64>>,
    [a, b]: [&DMatrix<f64>; 2],
    mixed: Option<(&DVector<f64>, [Vec<f64>; 2])>,
) -> Result<DMatrix<f64>, DiagnoseError> {
    let mut most = DMatrix::from_element(a.ncols(), b.ncols(), f64::NEG_INFINITY);
    let mut sum: DMatrix<f64> = DMatrix::zeros(a.ncols(), b.ncols());
    let residuals = weights.less(a);
    for level in &weights.levels {
        let root = level.root(more)?;
        let ln_size = level.ln_size(&root);
        let (left, other) = (root.whiten(&residuals), root.whiten(b));
        let besides = mixed.as_ref().map(|(change, shares)| {
            let own = root.whiten(&DMatrix::from_column_slice(change.len(), 1, change.as_slice()));
            let own = own.column(0).into_owned();
            (left.tr_mul(&own), other.tr_mul(&own), own.norm_squared(), shares)
        });
        let cross = left.transpose() * &other;
        let q_left: Vec<f64> = left.column_iter().map(|own| own.norm_squared()).collect();
        let q_other: Vec<f64> = other.column_iter().map(|own| own.norm_squared()).collect();
        for j in 0..b.ncols() {
            for i in 0..a.ncols() {
                let mut q = q_left[i] + q_other[j] - 2.0 * cross[(i, j)];
                if let Some((of_left, of_other, square, [of_a, of_b])) = &besides {
                    let share = of_a[i] * of_b[j];
                    q += share * (share * square - 2.0 * of_left[i] + 2.0 * of_other[j]);
                }
                let ln = ln_size - 0.5 * q;
                let (most, sum) = (&mut most[(i, j)], &mut sum[(i, j)]);
                if ln > *most {
                    *sum = *sum * (*most - ln).exp() + 1.0;
                    *most = ln;
                } else {
                    *sum += (ln - *most).exp();
                }
            }
        }
    }
    Ok(most.zip_map(&sum, |most, sum| most + sum.ln()))
}

/// A pair weighed with the errors of both effects.
fn weighed(
    weights: &Weights,
    members: &[Member],
    (pair, mut nodes): Found,
    mixed: Option<&Mixed>,
    ln_prior: f64,
) -> Result<Trial, DiagnoseError> {
    let [a, b] = pair.map(|k| &members[k]);
    let mut trial: Option<Trial> = None;
    for _ in 0..ROUNDS {
        let block = with_own_errors(weights, [a, b], nodes, mixed)?;
        let ln_weight = ln_prior + ln_sum(block.iter().copied());
        let of_a: Vec<f64> = block.row_iter().map(|row| ln_sum(row.iter().copied())).collect();
        let of_b: Vec<f64> = block
            .column_iter()
            .map(|own| ln_sum(own.iter().copied()))
            .collect();
        if trial.as_ref().is_none_or(|known| ln_weight > known.ln_weight) {
            let [first, second] = [strength(a, &of_a), strength(b, &of_b)];
            trial = Some(Trial {
                best: vec![first[0], second[0]],
                strength: vec![first[1], second[1]],
                error: vec![first[2], second[2]],
                ..of_nodes(members, (pair, nodes), [ln_prior, ln_weight])
            });
        }
        let (row, column) = place_of_largest(&block);
        if [row, column] == nodes {
            break;
        }
        nodes = [row, column];
    }
    Ok(trial.unwrap_or_else(|| of_nodes(members, (pair, nodes), [ln_prior, f64::NEG_INFINITY])))
}

/// [`block`] with the errors of both effects at these nodes, summed over how badly their formulas are known, and with the priors of their
/// strengths.
fn with_own_errors(
    weights: &Weights,
    [a, b]: [&Member; 2],
    nodes: [usize; 2],
    mixed: Option<&Mixed>,
) -> Result<DMatrix<f64>, DiagnoseError> {
    let change = |member: &Member, node: usize| member.changes.column(node).into_owned();
    let changes = [change(a, nodes[0]), change(b, nodes[1])];
    let interplay = match mixed {
        None => weights.error.interplay(&changes[0], &changes[1]) * INTERPLAY.powi(2),
        Some(mixed) => weights.error.own(&mixed.change, OWN_OF_BOTH, 1.0),
    };
    let guess = Mixed {
        change: weights.error.product(&changes[0], &changes[1]) * PRODUCT,
        at: [a.nodes[nodes[0]].strength, b.nodes[nodes[1]].strength],
    };
    let mixed = mixed.unwrap_or(&guess);
    let of = |own: &Member, at: f64| own.nodes.iter().map(|node| node.strength / at).collect();
    let shares = Some((&mixed.change, [of(a, mixed.at[0]), of(b, mixed.at[1])]));
    let mut sum = DMatrix::from_element(a.nodes.len(), b.nodes.len(), f64::NEG_INFINITY);
    for size in OWN_SIZES {
        let own = |of: usize, member: &Member| weights.error.own(&changes[of], member.own_error, size.factor);
        let more = own(0, a) + own(1, b) + &interplay;
        let part = block(weights, Some(&more), [&a.changes, &b.changes], shares.clone())?;
        sum.zip_apply(&part, |sum, ln| {
            *sum = ln_sum([*sum, ln + size.ln_prior].into_iter())
        });
    }
    for (j, mut column) in sum.column_iter_mut().enumerate() {
        for (i, ln) in column.iter_mut().enumerate() {
            *ln += a.nodes[i].ln_prior + b.nodes[j].ln_prior;
        }
    }
    Ok(sum)
}

/// A pair at its best strengths.
fn of_nodes(members: &[Member], (pair, nodes): Found, [ln_prior, ln_weight]: [f64; 2]) -> Trial {
    let at = [0, 1].map(|own| members[pair[own]].nodes[nodes[own]].strength);
    let mut families: Vec<usize> = pair.iter().filter_map(|&k| members[k].family).collect();
    families.sort_unstable();
    Trial {
        members: pair.to_vec(),
        families,
        ln_prior,
        ln_weight,
        best: at.to_vec(),
        strength: at.to_vec(),
        error: vec![0.0; 2],
        size: None,
    }
}

fn place_of_largest(matrix: &DMatrix<f64>) -> (usize, usize) {
    let rows = matrix.nrows();
    let place = (0..matrix.len())
        .max_by(|&a, &b| matrix[a].total_cmp(&matrix[b]))
        .unwrap_or(0);
    (place % rows, place / rows)
}
