//! NSGA-II (Deb, Pratap, Agarwal & Meyarivan 2002): a front between aims by an evolving population.
//!
//! Simulated binary crossover and polynomial mutation (Deb & Agrawal 1995), constraints by violation (Deb 2000). Random
//! numbers are had by counting, and a generation is evaluated in parallel but varied and chosen in order: the same seed gives
//! the same front at any number of threads.
//!
//! Of the crates, `moors` 0.2.11 is the one that is kept up: its front of ZDT1 is as near, but it brings 117 crates, among them
//! a second `faer`; this file is what is needed of it.

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::progress::Progress;
use crate::study::draws::Draws;

use super::error::ExploreError;
use super::front::{crowding, ranks};

/// What is sought.
pub trait Problem: Sync {
    /// Lower and upper bound of each variable.
    fn bounds(&self) -> Vec<[f64; 2]>;

    /// The objectives of a point, each to be as small as possible.
    fn evaluate(&self, variables: &[f64]) -> Evaluation;
}

/// The objectives of a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Evaluation {
    /// The objectives, each to be as small as possible.
    pub objectives: Vec<f64>,
    /// By how much constraints are broken; 0 if they hold.
    pub violation: f64,
}

/// A point with its objectives.
#[derive(Debug, Clone, PartialEq)]
pub struct Individual {
    /// Its variables.
    pub variables: Vec<f64>,
    /// Its objectives.
    pub evaluation: Evaluation,
}

/// The algorithm with its settings.
#[derive(Debug, Clone, PartialEq)]
pub struct Nsga2 {
    /// Points of a generation; even.
    pub population: usize,
    /// Generations after the first.
    pub generations: usize,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Share of pairs that are crossed.
    pub crossover: f64,
    /// Index of the distribution of crossover: the larger, the nearer are children to their parents.
    pub crossover_index: f64,
    /// The same of mutation; each variable of a child changes with the probability of one over their number.
    pub mutation_index: f64,
}

impl Default for Nsga2 {
    fn default() -> Self {
        Nsga2 {
            population: 100,
            generations: 250,
            seed: 1,
            crossover: 0.9,
            crossover_index: 15.0,
            mutation_index: 20.0,
        }
    }
}

/// Random numbers that one child may take.
const PER_CHILD: u64 = 1 << 16;

impl Nsga2 {
    /// The last generation's points that no other of it dominates, by rising first objective; `starts` join the first
    /// generation.
    ///
    /// # Errors
    /// Settings without sense; if the user asks to stop.
    pub fn front(
        &self,
        problem: &impl Problem,
        starts: &[Vec<f64>],
        progress: &Progress,
    ) -> Result<Vec<Individual>, ExploreError> {
        self.check()?;
        let bounds = problem.bounds();
        let draws = Draws::new(self.seed);
        let points = self.first_generation(starts, &bounds, draws);
        let mut parents = self.chosen(evaluated(problem, points), self.population);
        for generation in 1..=self.generations {
            progress.check()?;
            progress.say(format_args!("generation {generation} of {}", self.generations));
            let pairs = 0..self.population / 2;
            let children = pairs.flat_map(|pair| {
                let mut chance = Chance::new(draws, generation, pair);
                let (a, b) = (
                    self.tournament(&parents, &mut chance),
                    self.tournament(&parents, &mut chance),
                );
                self.children(&a.variables, &b.variables, &bounds, &mut chance)
            });
            let children = evaluated(problem, children.collect());
            let all = parents
                .into_iter()
                .map(|ranked| ranked.individual)
                .chain(children)
                .collect();
            parents = self.chosen(all, self.population);
        }
        let first = parents.into_iter().filter(|ranked| ranked.rank == 0);
        let mut front: Vec<Individual> = first
            .map(|ranked| ranked.individual)
            .filter(|individual| individual.evaluation.violation <= 0.0)
            .collect();
        let key = |individual: &Individual| individual.evaluation.objectives[0];
        front.sort_by(|a, b| key(a).total_cmp(&key(b)));
        front.dedup_by(|a, b| a.variables == b.variables);
        Ok(front)
    }

    fn check(&self) -> Result<(), ExploreError> {
        if self.population < 4 || self.population % 2 == 1 {
            return Err(ExploreError::Setting {
                name: "the size of the population",
                value: self.population as f64,
                cure: "give an even number, at least 4",
            });
        }
        if self.generations == 0 {
            return Err(ExploreError::Setting {
                name: "the number of generations",
                value: 0.0,
                cure: "give at least 1",
            });
        }
        Ok(())
    }

    /// The starts, and points drawn over the bounds.
    fn first_generation(&self, starts: &[Vec<f64>], bounds: &[[f64; 2]], draws: Draws) -> Vec<Vec<f64>> {
        let mut points: Vec<Vec<f64>> = starts.iter().take(self.population).cloned().collect();
        for child in points.len()..self.population {
            let mut chance = Chance::new(draws, 0, child);
            points.push(
                bounds
                    .iter()
                    .map(|[low, high]| low + chance.next() * (high - low))
                    .collect(),
            );
        }
        points
    }

    /// The best of a set by rank, then by crowding.
    fn chosen(&self, all: Vec<Individual>, count: usize) -> Vec<Ranked> {
        let points: Vec<(&[f64], f64)> = all
            .iter()
            .map(|one| (one.evaluation.objectives.as_slice(), one.evaluation.violation))
            .collect();
        let rank = ranks(&points);
        let mut order: Vec<(usize, f64, usize)> = Vec::new();
        let worst = rank.iter().copied().max().unwrap_or(0);
        for level in 0..=worst {
            let members: Vec<usize> = (0..all.len()).filter(|&i| rank[i] == level).collect();
            let crowding = crowding(&points, &members);
            let mut front: Vec<(usize, f64, usize)> = members
                .iter()
                .zip(crowding)
                .map(|(&i, distance)| (level, distance, i))
                .collect();
            front.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.2.cmp(&b.2)));
            order.extend(front);
            if order.len() >= count {
                break;
            }
        }
        order.truncate(count);
        let mut all: Vec<Option<Individual>> = all.into_iter().map(Some).collect();
        let taken = order.into_iter().filter_map(|(rank, distance, index)| {
            let individual = all[index].take()?;
            Some(Ranked {
                individual,
                rank,
                distance,
            })
        });
        taken.collect()
    }

    /// The better of two that are drawn.
    fn tournament<'p>(&self, parents: &'p [Ranked], chance: &mut Chance) -> &'p Individual {
        let (a, b) = (
            &parents[chance.below(parents.len())],
            &parents[chance.below(parents.len())],
        );
        let is_first = a.rank < b.rank || (a.rank == b.rank && a.distance >= b.distance);
        if is_first { &a.individual } else { &b.individual }
    }

    /// Two children of two parents.
    fn children(&self, a: &[f64], b: &[f64], bounds: &[[f64; 2]], chance: &mut Chance) -> [Vec<f64>; 2] {
        let (mut first, mut second) = (a.to_vec(), b.to_vec());
        if chance.next() < self.crossover {
            for (index, bound) in bounds.iter().enumerate() {
                if chance.next() < 0.5 {
                    let pair = self.crossed(a[index], b[index], *bound, chance);
                    (first[index], second[index]) = pair;
                }
            }
        }
        for child in [&mut first, &mut second] {
            for (value, bound) in child.iter_mut().zip(bounds) {
                if chance.next() < 1.0 / bounds.len() as f64 {
                    *value = self.mutated(*value, *bound, chance);
                }
            }
        }
        [first, second]
    }

    /// Simulated binary crossover within bounds.
    fn crossed(&self, a: f64, b: f64, [low, high]: [f64; 2], chance: &mut Chance) -> (f64, f64) {
        let (lower, upper) = (a.min(b), a.max(b));
        let (draw, swap) = (chance.next(), chance.next() < 0.5);
        if upper - lower < 1e-14 * (high - low) {
            return (a, b);
        }
        let power = 1.0 / (self.crossover_index + 1.0);
        let spread = |room: f64| {
            let beta = 1.0 + 2.0 * room / (upper - lower);
            let alpha = 2.0 - beta.powf(-(self.crossover_index + 1.0));
            if draw <= 1.0 / alpha {
                (draw * alpha).powf(power)
            } else {
                (1.0 / (2.0 - draw * alpha)).powf(power)
            }
        };
        let middle = 0.5 * (lower + upper);
        let below = middle - 0.5 * spread(lower - low) * (upper - lower);
        let above = middle + 0.5 * spread(high - upper) * (upper - lower);
        let (below, above) = (below.clamp(low, high), above.clamp(low, high));
        if swap { (above, below) } else { (below, above) }
    }

    /// Polynomial mutation within bounds.
    fn mutated(&self, value: f64, [low, high]: [f64; 2], chance: &mut Chance) -> f64 {
        let (draw, width) = (chance.next(), high - low);
        if width <= 0.0 {
            return value;
        }
        let power = 1.0 / (self.mutation_index + 1.0);
        let share = if draw < 0.5 {
            let room = 1.0 - (value - low) / width;
            (2.0 * draw + (1.0 - 2.0 * draw) * room.powf(self.mutation_index + 1.0)).powf(power) - 1.0
        } else {
            let room = 1.0 - (high - value) / width;
            1.0 - (2.0 * (1.0 - draw) + (2.0 * draw - 1.0) * room.powf(self.mutation_index + 1.0)).powf(power)
        };
        (value + share * width).clamp(low, high)
    }
}

struct Ranked {
    individual: Individual,
    rank: usize,
    distance: f64,
}

/// Random numbers of one child, one after the other.
struct Chance {
    draws: Draws,
    stream: u64,
    index: u64,
}

impl Chance {
    fn new(draws: Draws, generation: usize, child: usize) -> Chance {
        Chance {
            draws,
            stream: generation as u64,
            index: child as u64 * PER_CHILD,
        }
    }

    fn next(&mut self) -> f64 {
        self.index += 1;
        self.draws.uniform(self.stream, self.index)
    }

    fn below(&mut self, count: usize) -> usize {
        ((self.next() * count as f64) as usize).min(count - 1)
    }
}

fn evaluated(problem: &impl Problem, points: Vec<Vec<f64>>) -> Vec<Individual> {
    points
        .into_par_iter()
        .map(|variables| Individual {
            evaluation: problem.evaluate(&variables),
            variables,
        })
        .collect()
}
