//! The search: every sequence of rods with its break on a few places, the best of them refined, each in the coupled model.

use std::ops::Range;

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use serde::{Deserialize, Serialize};

use crate::explore::error::ExploreError;
use crate::input::design::{Design, Instrument};
use crate::input::stock::StockRod;
use crate::lift::{LiftError, TwistAlongSpan};
use crate::observation::ObservationError;
use crate::progress::Progress;
use crate::wing::{SolvedWing, WingModel};

use super::layout::{Layout, Piece};

/// What a layout is for.
#[derive(Debug, Clone, PartialEq)]
pub enum Aim {
    /// This twist along the span.
    Twist(TwistAlongSpan),
    /// The most lift per power of those that lift so much at the stroke of the design, N, mean over the stroke.
    LiftPerPower {
        /// Least mean lift of one wing, N.
        least_lift_n: f64,
    },
}

/// What may be chosen.
#[derive(Debug, Clone, PartialEq)]
pub struct Choices {
    /// Rods on the shelf.
    pub stock: Vec<StockRod>,
    /// Most pieces of one leading edge: 1 or 2.
    pub pieces: usize,
    /// Places of the spars to try, mm; none: those of the design.
    pub spars_mm: Vec<Option<Vec<f64>>>,
    /// Tensions of the film to try, N/m; none: that of the design.
    pub pretensions_n_per_m: Vec<Option<f64>>,
    /// Factor on the mesh of the first look.
    pub refine: f64,
}

/// A layout with what it gives.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Candidate {
    /// The layout.
    pub layout: Layout,
    /// Twist along the span, read at base, spars and tip.
    pub twist: TwistAlongSpan,
    /// Root mean square distance from the wanted twist over the span, deg; none without one.
    pub distance_deg: Option<f64>,
    /// Mean lift of one wing over the stroke (20/60/20 ramp), N.
    pub lift_n: f64,
    /// Mean aerodynamic power, W.
    pub power_w: f64,
    /// What is to be as small as possible.
    score: f64,
}

/// What the search found.
#[derive(Debug, Clone)]
pub struct Found {
    /// The best layout of each sequence of rods that was looked at closely, best first.
    pub candidates: Vec<Candidate>,
    /// Layouts that were solved.
    pub solved: usize,
    /// Layouts that have no equilibrium, or none that was found.
    pub unsolved: usize,
}

/// Places over the length at which breaks are tried first.
const BREAKS: [f64; 5] = [0.2, 0.35, 0.5, 0.65, 0.8];
/// Sequences of rods that are looked at closely.
const CLOSE: usize = 6;
/// Steps of the golden section on a break, from the distance of two first places down to below half a millimetre of 70.
const STEPS: usize = 8;
/// Stations over which two profiles are compared.
const STATIONS: usize = 60;

/// A design whose layouts are tried.
#[derive(Debug, Clone)]
pub struct Workshop<'a> {
    /// The wing whose outline, film, spar, stroke and materials all have.
    pub wing: &'a WingModel,
    /// What the layout is for.
    pub aim: &'a Aim,
    /// Outer end of the span over which twist is compared, m.
    pub tip_m: f64,
}

impl Workshop<'_> {
    /// Solves a layout on a mesh of the design's refinement times `refine`.
    ///
    /// # Errors
    /// If the design refuses it, or it has no equilibrium that is found.
    pub fn try_layout(
        &self,
        layout: &Layout,
        refine: f64,
        progress: &Progress,
    ) -> Result<Candidate, ExploreError> {
        let mut design = layout.applied(self.wing.design())?;
        design.mesh.refine *= refine;
        self.judged(layout, &self.solved(design, progress)?)
    }

    /// The loaded shape of a design.
    ///
    /// # Errors
    /// If there is none.
    pub fn solved(&self, design: Design, progress: &Progress) -> Result<SolvedWing, ExploreError> {
        Ok(self.wing.with_design(design)?.solve(progress)?)
    }

    fn judged(&self, layout: &Layout, wing: &SolvedWing) -> Result<Candidate, ExploreError> {
        let twist = read_twist(wing)?;
        let means = wing.means_on_ramp()?.ok_or(LiftError::NotFlapping)?;
        let distance_deg = match self.aim {
            Aim::Twist(wanted) => Some(distance_deg(&twist, wanted, self.tip_m)),
            Aim::LiftPerPower { .. } => None,
        };
        let score = match (self.aim, distance_deg) {
            (Aim::LiftPerPower { least_lift_n }, _) => {
                let short = (1.0 - means.lift_n / least_lift_n).max(0.0);
                // too little lift is worse than any efficiency is good
                if short > 0.0 {
                    1e6 * (1.0 + short)
                } else {
                    -means.lift_n / means.power_w.max(1e-12)
                }
            }
            (_, distance) => distance.unwrap_or(f64::INFINITY),
        };
        Ok(Candidate {
            layout: layout.clone(),
            twist,
            distance_deg,
            lift_n: means.lift_n,
            power_w: means.power_w,
            score,
        })
    }
}

impl Candidate {
    /// Whether it gives the lift that is asked for.
    pub fn is_feasible(&self) -> bool {
        self.score < 1e6
    }

    /// How much worse it is than another: deg of distance, or share of lift per power.
    pub fn behind(&self, best: &Candidate) -> f64 {
        match self.distance_deg {
            Some(_) => self.score - best.score,
            None => 1.0 - self.score / best.score,
        }
    }
}

/// Twist as read at base, spar ends and tip, by the rotation of the chord.
///
/// # Errors
/// If it cannot be read.
pub fn read_twist(wing: &SolvedWing) -> Result<TwistAlongSpan, ExploreError> {
    let refused = |error: ObservationError| ExploreError::Design(Box::new(error));
    let observer = wing.observer()?.seen_by(Instrument::ChordRotation);
    let profile = observer.map_err(refused)?.profile();
    let mut points: Vec<[f64; 2]> = Vec::new();
    for reading in &profile.readings {
        if points.last().is_none_or(|last| reading.r_m > last[0] + 1e-9) {
            points.push([reading.r_m, reading.twist_rad]);
        }
    }
    Ok(TwistAlongSpan::from_points(points)?)
}

/// Root mean square difference of two profiles from the base to `tip_m`, deg.
pub fn distance_deg(a: &TwistAlongSpan, b: &TwistAlongSpan, tip_m: f64) -> f64 {
    let square: f64 = (0..STATIONS)
        .map(|k| {
            let r_m = tip_m * (k as f64 + 0.5) / STATIONS as f64;
            (a.twist_rad(r_m) - b.twist_rad(r_m)).to_degrees().powi(2)
        })
        .sum();
    (square / STATIONS as f64).sqrt()
}

/// The search in its steps: a first look at every layout, each by itself; a closer look at the best of them, each by itself.
///
/// Deterministic: every layout is solved from the wing at rest, whatever was solved before.
#[derive(Debug, Clone)]
pub struct Search<'a> {
    workshop: &'a Workshop<'a>,
    refine: f64,
    /// All layouts, each with the number of its sequence of rods, spars and tension.
    pub layouts: Vec<(usize, Layout)>,
}

/// What a closer look at a layout found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Closer {
    /// Layouts that were solved.
    solved: usize,
    /// The best of them.
    best: Option<Candidate>,
}

impl<'a> Search<'a> {
    /// All layouts that can be chosen.
    pub fn new(workshop: &'a Workshop<'a>, choices: &Choices) -> Search<'a> {
        let length_mm = workshop.wing.design().planform.length_mm.value();
        let piece = |rod: &StockRod, to_mm: f64| Piece {
            rod: rod.clone(),
            to_mm,
        };
        let mut sequences: Vec<Vec<Layout>> = Vec::new();
        for spars_mm in &choices.spars_mm {
            for pretension in &choices.pretensions_n_per_m {
                let layout = |pieces: Vec<Piece>| Layout {
                    pieces,
                    spars_mm: spars_mm.clone(),
                    pretension_n_per_m: *pretension,
                };
                for inner in &choices.stock {
                    sequences.push(vec![layout(vec![piece(inner, length_mm)])]);
                    for outer in choices
                        .stock
                        .iter()
                        .filter(|rod| choices.pieces > 1 && rod.name != inner.name)
                    {
                        let at = |share: &f64| {
                            layout(vec![piece(inner, share * length_mm), piece(outer, length_mm)])
                        };
                        sequences.push(BREAKS.iter().map(at).collect());
                    }
                }
            }
        }
        let numbered = sequences.into_iter().enumerate();
        Search {
            workshop,
            refine: choices.refine,
            layouts: numbered
                .flat_map(|(number, layouts)| layouts.into_iter().map(move |layout| (number, layout)))
                .collect(),
        }
    }

    /// The first look at some of the layouts: the score of each, the smaller the better; none where it has no equilibrium that is
    /// found.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn look(&self, layouts: Range<usize>, progress: &Progress) -> Result<Vec<Option<f64>>, ExploreError> {
        let unseen = progress.unseen();
        let score = |(_, layout): &(usize, Layout)| {
            let found = self.workshop.try_layout(layout, self.refine, &unseen);
            found.ok().map(|candidate| candidate.score)
        };
        let scores = self.layouts[layouts].par_iter().map(score).collect();
        progress.check()?;
        Ok(scores)
    }

    /// The layouts that deserve a closer look, best first, from the scores of all.
    ///
    /// # Errors
    /// If none has a score: why the last one has none.
    pub fn best(&self, scores: &[Option<f64>], progress: &Progress) -> Result<Vec<usize>, ExploreError> {
        let sequences = self.layouts.last().map_or(0, |(number, _)| number + 1);
        let mut best: Vec<Option<(f64, usize)>> = vec![None; sequences];
        for (index, ((number, _), score)) in self.layouts.iter().zip(scores).enumerate() {
            if let Some(score) = score
                && best[*number].is_none_or(|(known, _)| *score < known)
            {
                best[*number] = Some((*score, index));
            }
        }
        let mut best: Vec<(f64, usize)> = best.into_iter().flatten().collect();
        if let (true, Some((_, last))) = (best.is_empty(), self.layouts.last()) {
            self.workshop.try_layout(last, self.refine, progress)?;
        }
        best.sort_by(|a, b| a.0.total_cmp(&b.0));
        best.truncate(CLOSE);
        Ok(best.into_iter().map(|(_, index)| index).collect())
    }

    /// A closer look at one of them, on the mesh of the design: its break moved to where it is best.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn closer(&self, index: usize, progress: &Progress) -> Result<Closer, ExploreError> {
        let length_mm = self.workshop.wing.design().planform.length_mm.value();
        let step_mm = 0.5 * (BREAKS[1] - BREAKS[0]) * length_mm;
        let (solved, best) = refine_break(
            self.workshop,
            &self.layouts[index].1,
            step_mm * 2.0,
            &progress.unseen(),
        );
        progress.check()?;
        Ok(Closer { solved, best })
    }

    /// The result, from the scores of all layouts and the closer looks at the best.
    pub fn found(&self, scores: &[Option<f64>], closer: Vec<Closer>) -> Found {
        let first = scores.iter().flatten().count();
        let looks = closer.len();
        let solved = first + closer.iter().map(|closer| closer.solved).sum::<usize>();
        let mut candidates: Vec<Candidate> = closer.into_iter().filter_map(|closer| closer.best).collect();
        candidates.sort_by(|a, b| a.score.total_cmp(&b.score));
        Found {
            solved,
            unsolved: scores.len() - first + looks - candidates.len(),
            candidates,
        }
    }
}

/// Golden section on the break of a layout, within `reach_mm` on either side, on the mesh of the design.
fn refine_break(
    workshop: &Workshop,
    from: &Layout,
    reach_mm: f64,
    progress: &Progress,
) -> (usize, Option<Candidate>) {
    let mut solved = 1;
    let mut best = workshop.try_layout(from, 1.0, progress).ok();
    if from.pieces.len() < 2 {
        return (solved, best);
    }
    let centre_mm = from.pieces[0].to_mm;
    let length_mm = workshop.wing.design().planform.length_mm.value();
    let (mut low, mut high) = (
        (centre_mm - reach_mm).max(0.05 * length_mm),
        (centre_mm + reach_mm).min(0.95 * length_mm),
    );
    let share = 0.5 * (5.0_f64.sqrt() - 1.0);
    let mut at = |mm: f64| -> f64 {
        solved += 1;
        let layout = from.with_break(0, mm);
        let candidate = layout.and_then(|layout| workshop.try_layout(&layout, 1.0, progress).ok());
        let score = candidate
            .as_ref()
            .map_or(f64::INFINITY, |candidate| candidate.score);
        if let Some(candidate) = candidate
            && best.as_ref().is_none_or(|known| candidate.score < known.score)
        {
            best = Some(candidate);
        }
        score
    };
    let (mut a, mut b) = (high - share * (high - low), low + share * (high - low));
    let (mut score_a, mut score_b) = (at(a), at(b));
    for _ in 0..STEPS {
        if progress.is_cancelled() {
            break;
        }
        if score_a <= score_b {
            (high, b, score_b) = (b, a, score_a);
            a = high - share * (high - low);
            score_a = at(a);
        } else {
            (low, a, score_a) = (a, b, score_b);
            b = low + share * (high - low);
            score_b = at(b);
        }
    }
    (solved, best)
}
