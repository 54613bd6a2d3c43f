//! What fabrication does to a layout: its twist with each diameter, shear modulus and break off by its tolerance.

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::explore::error::ExploreError;
use crate::input::design::Design;
use crate::lift::TwistAlongSpan;
use crate::progress::Progress;

use super::layout::Layout;
use super::search::{Candidate, Workshop, distance_deg, read_twist};

/// How exactly a wing can be built.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerances {
    /// A break may be off by so much, mm.
    pub break_mm: f64,
    /// A shear modulus that has no assumed range of its own may be off by this share.
    pub shear_modulus_share: f64,
}

/// The twist of a layout with its tolerance.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// Twist rate of each piece of the rod.
    pub pieces: Vec<PieceBand>,
    /// Span position (m), twist and half the width of its band (rad), where the twist is read.
    pub stations: Vec<[f64; 3]>,
    /// Root mean square over the span of half the band, deg.
    pub rms_deg: f64,
    /// The same by diameters and breaks alone: a shear modulus that is off is so in every layout of these rods.
    pub built_deg: f64,
    /// What was moved, and by how much it changes the twist over the span (root mean square, deg).
    pub causes: Vec<(String, f64)>,
}

/// Twist rate of one piece with its tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PieceBand {
    /// From, mm.
    pub from_mm: f64,
    /// To, mm.
    pub to_mm: f64,
    /// Mean twist rate, deg/mm.
    pub rate_deg_per_mm: f64,
    /// Half the width of its band, deg/mm: causes added as if they were independent.
    pub tolerance_deg_per_mm: f64,
}

/// A wing that is off in one thing.
enum Off {
    Layout(Layout),
    Modulus(String, f64),
}

/// What is off, and the wings that are off in it either way.
type Moved = (String, [Off; 2]);

/// The twist of a layout with each thing off by its tolerance, one at a time, either way.
///
/// # Errors
/// If one of these wings has no equilibrium that is found.
pub fn band(
    workshop: &Workshop,
    best: &Candidate,
    tolerances: Tolerances,
    progress: &Progress,
) -> Result<Band, ExploreError> {
    let layout = &best.layout;
    let mut moved = moved_pieces(layout, tolerances.break_mm);
    moved.extend(moved_moduli(workshop, layout, tolerances.shear_modulus_share));
    let twists = Twists {
        best: &best.twist,
        by_cause: twists_by_cause(workshop, layout, &moved, progress)?,
    };
    let causes: Vec<(String, f64)> = moved
        .iter()
        .zip(&twists.by_cause)
        .map(|((name, _), pair)| {
            (
                name.clone(),
                0.5 * distance_deg(&pair[0], &pair[1], workshop.tip_m),
            )
        })
        .collect();
    let built = moved
        .iter()
        .zip(&causes)
        .filter(|((_, pair), _)| matches!(pair[0], Off::Layout(_)));
    let built_deg = built.map(|(_, (_, cause))| cause * cause).sum::<f64>().sqrt();
    let rms_deg = causes.iter().map(|(_, cause)| cause * cause).sum::<f64>().sqrt();
    Ok(Band {
        pieces: twists.pieces(layout),
        stations: twists.stations(),
        rms_deg,
        built_deg,
        causes,
    })
}

/// The diameter and the outer end of each piece.
fn moved_pieces(layout: &Layout, break_mm: f64) -> Vec<Moved> {
    let mut moved = Vec::new();
    for (index, piece) in layout.pieces.iter().enumerate() {
        let by_mm = piece.rod.tolerance_mm;
        if let (Some(less), Some(more)) = (
            layout.with_diameter(index, -by_mm),
            layout.with_diameter(index, by_mm),
        ) {
            let name = format!("diameter of {} ± {by_mm} mm", piece.rod.name);
            moved.push((name, [Off::Layout(less), Off::Layout(more)]));
        }
        let at = |mm: f64| layout.with_break(index, piece.to_mm + mm);
        if let (Some(inner), Some(outer)) = (at(-break_mm), at(break_mm)) {
            let name = format!("break at {:.1} ± {break_mm} mm", piece.to_mm);
            moved.push((name, [Off::Layout(inner), Off::Layout(outer)]));
        }
    }
    moved
}

/// The shear modulus of each material, over its assumed range or else by a share.
fn moved_moduli(workshop: &Workshop, layout: &Layout, share: f64) -> Vec<Moved> {
    let mut moved = Vec::new();
    let mut materials: Vec<&String> = layout.pieces.iter().map(|piece| &piece.rod.material).collect();
    materials.sort();
    materials.dedup();
    for material in materials {
        let key = format!("material.{material}.g_gpa");
        let range = workshop
            .wing
            .design()
            .assumptions()
            .into_iter()
            .find(|known| known.key == key)
            .map(|known| known.range);
        let stated = workshop.wing.design().get(&key);
        let range = range.or_else(|| stated.map(|value| [value * (1.0 - share), value * (1.0 + share)]));
        if let Some([low, high]) = range {
            let name = format!("shear modulus of {material} {low:.1} to {high:.1} GPa");
            moved.push((name, [Off::Modulus(key.clone(), low), Off::Modulus(key, high)]));
        }
    }
    moved
}

fn twists_by_cause(
    workshop: &Workshop,
    layout: &Layout,
    moved: &[Moved],
    progress: &Progress,
) -> Result<Vec<Vec<TwistAlongSpan>>, ExploreError> {
    progress.say("tolerances");
    let unseen = progress.unseen();
    let jobs: Vec<(usize, &Off)> = moved
        .iter()
        .enumerate()
        .flat_map(|(index, (_, pair))| pair.iter().map(move |off| (index, off)))
        .collect();
    let twists: Vec<Result<(usize, TwistAlongSpan), ExploreError>> = jobs
        .into_par_iter()
        .map(|(index, off)| Ok((index, twist_of(workshop, layout, off, &unseen)?)))
        .collect();
    progress.check()?;
    let mut by_cause: Vec<Vec<TwistAlongSpan>> = vec![Vec::new(); moved.len()];
    for twist in twists {
        let (index, twist) = twist?;
        by_cause[index].push(twist);
    }
    Ok(by_cause)
}

/// The twist of a layout, and that with each thing off either way.
struct Twists<'a> {
    best: &'a TwistAlongSpan,
    by_cause: Vec<Vec<TwistAlongSpan>>,
}

impl Twists<'_> {
    /// Half the width of the band of a number: causes added as if they were independent.
    fn half(&self, of: &dyn Fn(&TwistAlongSpan) -> f64) -> f64 {
        let squares = self
            .by_cause
            .iter()
            .map(|pair| (0.5 * (of(&pair[0]) - of(&pair[1]))).powi(2));
        squares.sum::<f64>().sqrt()
    }

    fn stations(&self) -> Vec<[f64; 3]> {
        self.best
            .points()
            .iter()
            .map(|&[r_m, twist]| [r_m, twist, self.half(&|t| t.twist_rad(r_m))])
            .collect()
    }

    fn pieces(&self, layout: &Layout) -> Vec<PieceBand> {
        let reach_mm = self.best.points().last().map_or(0.0, |last| last[0] * 1e3);
        let mut from_mm = 0.0;
        let pieces = layout.pieces.iter().map(|piece| {
            let to_mm = piece.to_mm.min(reach_mm);
            let rate = |twist: &TwistAlongSpan| {
                let rise = twist.twist_rad(to_mm * 1e-3) - twist.twist_rad(from_mm * 1e-3);
                rise.to_degrees() / (to_mm - from_mm)
            };
            let found = PieceBand {
                from_mm,
                to_mm,
                rate_deg_per_mm: rate(self.best),
                tolerance_deg_per_mm: self.half(&rate),
            };
            from_mm = to_mm;
            found
        });
        pieces.collect()
    }
}

fn twist_of(
    workshop: &Workshop,
    layout: &Layout,
    off: &Off,
    progress: &Progress,
) -> Result<TwistAlongSpan, ExploreError> {
    let design: Design = match off {
        Off::Layout(layout) => layout.applied(workshop.wing.design())?,
        Off::Modulus(key, value) => {
            let mut design = layout.applied(workshop.wing.design())?;
            design.set(key, *value)?;
            design
        }
    };
    read_twist(&workshop.solved(design, progress)?)
}
