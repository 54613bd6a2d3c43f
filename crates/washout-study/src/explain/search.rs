//! Sets of changes by adding up what each does alone: all single ones, all pairs, larger ones grown from these.

use nalgebra::DVector;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::changes::Change;

/// Sweeps over the members of a set in which the size of each is chosen anew.
const SWEEPS: usize = 3;

/// What the fitted readings say, in their standard deviations.
#[derive(Debug)]
pub struct Target {
    /// Measured minus modelled as the model stands.
    pub residual: DVector<f64>,
    /// By reading: −1 for an upper bound, 1 for a lower one, 0 for a number.
    pub bounds: Vec<i8>,
}

/// A set of changes with their sizes.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// Positions of the changes and of their sizes, in ascending order.
    pub members: Vec<(usize, usize)>,
    /// What it costs, with standard deviations as they are stated: chi-square, values, prices.
    pub cost: f64,
}

impl Target {
    /// Chi-square with two changes of all readings.
    fn chi_square(&self, rest: &DVector<f64>, change: &DVector<f64>) -> f64 {
        let each = self
            .residual
            .iter()
            .zip(rest.iter())
            .zip(change.iter())
            .zip(&self.bounds);
        each.map(|(((residual, rest), change), bound)| one_sided(residual - rest - change, *bound).powi(2))
            .sum()
    }

    /// What a set costs with standard deviations as they are stated, `offset` being what its full solution differs by from the sum of its
    /// members. A search by what is forgiven where they are assumed would see little of what is far off.
    pub fn cost(&self, changes: &[Change], members: &[(usize, usize)], offset: Option<&DVector<f64>>) -> f64 {
        let sum = self.sum(changes, members, offset);
        let own: f64 = members
            .iter()
            .map(|&(change, size)| changes[change].price + changes[change].sizes[size].cost)
            .sum();
        own + self.chi_square(&sum, &DVector::zeros(self.residual.len()))
    }

    fn sum(
        &self,
        changes: &[Change],
        members: &[(usize, usize)],
        offset: Option<&DVector<f64>>,
    ) -> DVector<f64> {
        let mut sum = offset
            .cloned()
            .unwrap_or_else(|| DVector::zeros(self.residual.len()));
        for &(change, size) in members {
            sum += &changes[change].sizes[size].change;
        }
        sum
    }

    /// Each change alone, at its best size.
    pub fn single(&self, changes: &[Change]) -> Vec<Found> {
        let alone = |change: usize| {
            let none = DVector::zeros(self.residual.len());
            let size = self.best_size(&changes[change], &none)?.0;
            let members = vec![(change, size)];
            let cost = self.cost(changes, &members, None);
            Some(Found { members, cost })
        };
        (0..changes.len()).into_par_iter().filter_map(alone).collect()
    }

    /// Every pair at its best sizes, the `most` least costly.
    pub fn pairs(&self, changes: &[Change], most: usize) -> Vec<Found> {
        let of = |first: usize| {
            let mut found: Vec<Found> = Vec::new();
            for second in first + 1..changes.len() {
                if changes[first].key == changes[second].key {
                    continue;
                }
                let mut best: Option<(f64, usize, usize)> = None;
                for (place, size) in changes[first].sizes.iter().enumerate() {
                    let Some((other, q)) = self.best_size(&changes[second], &size.change) else {
                        continue;
                    };
                    let q = q + size.cost;
                    if best.is_none_or(|(least, ..)| q < least) {
                        best = Some((q, place, other));
                    }
                }
                if let Some((_, size, other)) = best {
                    let members = vec![(first, size), (second, other)];
                    let cost = self.cost(changes, &members, None);
                    found.push(Found { members, cost });
                }
            }
            least(found, most)
        };
        let found: Vec<Vec<Found>> = (0..changes.len()).into_par_iter().map(of).collect();
        least(found.into_iter().flatten().collect(), most)
    }

    /// A set with each other change, all sizes chosen anew; `offset` as in [`Target::cost`].
    pub fn grown(
        &self,
        changes: &[Change],
        from: &[(usize, usize)],
        offset: Option<&DVector<f64>>,
    ) -> Vec<Found> {
        let is_new = |change: usize| {
            from.iter()
                .all(|&(own, _)| changes[own].key != changes[change].key)
        };
        let grow = |change: usize| {
            let sum = self.sum(changes, from, offset);
            let size = self.best_size(&changes[change], &sum)?.0;
            let mut members = from.to_vec();
            members.push((change, size));
            for _ in 0..SWEEPS {
                let before = members.clone();
                for place in 0..members.len() {
                    let (own, size) = members[place];
                    let rest = self.sum(changes, &members, offset) - &changes[own].sizes[size].change;
                    if let Some((better, _)) = self.best_size(&changes[own], &rest) {
                        members[place].1 = better;
                    }
                }
                if members == before {
                    break;
                }
            }
            members.sort_unstable();
            let cost = self.cost(changes, &members, offset);
            Some(Found { members, cost })
        };
        (0..changes.len())
            .filter(|&change| is_new(change))
            .filter_map(grow)
            .collect()
    }

    /// The size of a change that is best beside `rest`, by the sum of chi-square and its cost, and that sum.
    fn best_size(&self, change: &Change, rest: &DVector<f64>) -> Option<(usize, f64)> {
        let mut best: Option<(usize, f64)> = None;
        for (place, size) in change.sizes.iter().enumerate() {
            let q = size.cost + self.chi_square(rest, &size.change);
            if best.is_none_or(|(_, least)| q < least) {
                best = Some((place, q));
            }
        }
        best
    }
}

/// The `most` least costly, least first.
pub fn least(mut found: Vec<Found>, most: usize) -> Vec<Found> {
    found.sort_by(|a, b| a.cost.total_cmp(&b.cost).then_with(|| a.members.cmp(&b.members)));
    found.dedup_by(|a, b| {
        let same = |x: &Found, y: &Found| {
            x.members
                .iter()
                .map(|own| own.0)
                .eq(y.members.iter().map(|own| own.0))
        };
        same(a, b)
    });
    found.truncate(most);
    found
}

fn one_sided(misfit: f64, bound: i8) -> f64 {
    match bound {
        -1 => misfit.min(0.0),
        1 => misfit.max(0.0),
        _ => misfit,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::explain::changes::Size;

    fn change(key: &str, direction: [f64; 3], price: f64) -> Change {
        let sizes = (1..=10).map(|step| {
            let value = 0.1 * f64::from(step);
            Size {
                value,
                cost: value * value,
                change: DVector::from_column_slice(&direction) * value,
            }
        });
        Change {
            unknown: 0,
            key: key.to_string(),
            price,
            sizes: sizes.collect(),
        }
    }

    #[test]
    fn a_pair_that_made_the_residual_is_found_before_all_others() {
        let changes = [
            change("a", [20.0, 0.0, 0.0], 5.0),
            change("b", [0.0, 20.0, 5.0], 5.0),
            change("c", [0.0, 0.0, 20.0], 5.0),
            change("d", [5.0, 5.0, 5.0], 5.0),
        ];
        let target = Target {
            residual: DVector::from_column_slice(&[10.0, 12.0, 3.0]),
            bounds: vec![0; 3],
        };
        let pairs = target.pairs(&changes, 10);
        assert_eq!(pairs[0].members, [(0, 4), (1, 5)]);
        assert!((pairs[0].cost - 10.0 - 0.25 - 0.36).abs() < 1e-9);
        assert!(target.single(&changes).iter().all(|own| own.cost > pairs[0].cost));
        let grown = target.grown(&changes, &pairs[0].members, None);
        assert!(
            grown
                .iter()
                .all(|own| own.cost > pairs[0].cost && own.members.len() == 3)
        );
    }

    #[test]
    fn a_bound_that_is_kept_asks_for_nothing() {
        let target = Target {
            residual: DVector::from_column_slice(&[-2.0, 2.0, 2.0]),
            bounds: vec![-1, -1, 0],
        };
        let none = DVector::zeros(3);
        assert_eq!(target.chi_square(&none, &none), 8.0);
    }
}
