//! Where two wings on one mesh differ before either is loaded: what an effect acts on.

use std::collections::BTreeSet;
use std::sync::Arc;

use nalgebra::Vector3;

use super::strip_air::StripAir;
use super::strips::Strip;
use super::wing::Wing;
use crate::structure::state::State;
use crate::structure::{Loads, Model};

/// Where a wing differs from another on the same mesh.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Difference {
    /// Beam elements whose section, stiffness or pre-twist differs.
    pub beams: Vec<usize>,
    /// Triangles whose sheet differs.
    pub triangles: Vec<usize>,
    /// Nodes that are held, sprung, weighted or loaded otherwise, but for the air.
    pub nodes: Vec<usize>,
    /// Force of the air across the chord, both wings in the shape of the other: span position, m, force of the other, of this one, N/m.
    /// Empty where no strip differs.
    pub air_n_per_m: Vec<[f64; 3]>,
    /// Whether rotations are large in one and small in the other.
    pub has_other_kinematics: bool,
}

impl Wing {
    /// Where this wing differs from `other`; the air of both is that on the shape `state`. None where they are not on one mesh, or the air
    /// on that shape is not finite.
    pub fn difference(&self, other: &Wing, state: &State) -> Option<Difference> {
        let is_one_mesh = self.model.nodes == other.model.nodes
            && self.model.beams.len() == other.model.beams.len()
            && self.model.shells.len() == other.model.shells.len();
        is_one_mesh.then_some(())?;
        let twists = differing(&self.bench.twists, &other.bench.twists);
        let beams = twists.map(|twist| twist.beam).chain(self.beams_unlike(other));
        Some(Difference {
            beams: in_order(beams),
            triangles: self.triangles_unlike(other),
            nodes: in_order(supports(&self.model, &other.model).chain(loaded(&self.bench, &other.bench))),
            air_n_per_m: self.air_unlike(other, state)?,
            has_other_kinematics: self.linear_share() != other.linear_share(),
        })
    }

    fn beams_unlike(&self, other: &Wing) -> impl Iterator<Item = usize> {
        let (own, of_other) = (&self.model, &other.model);
        (0..own.beams.len()).filter(|&beam| {
            let (mut a, b) = (own.beams[beam].clone(), &of_other.beams[beam]);
            let is_one_section = own.sections[a.section] == of_other.sections[b.section];
            // the same section may have another number
            a.section = b.section;
            !is_one_section || a != *b
        })
    }

    fn triangles_unlike(&self, other: &Wing) -> Vec<usize> {
        let (own, of_other) = (&self.model, &other.model);
        if Arc::ptr_eq(&own.shells, &of_other.shells) && own.sheets == of_other.sheets {
            return Vec::new();
        }
        let is_unlike = |&triangle: &usize| {
            let (a, b) = (&own.shells[triangle], &of_other.shells[triangle]);
            a != b || own.sheets[a.sheet] != of_other.sheets[b.sheet]
        };
        (0..own.shells.len()).filter(is_unlike).collect()
    }

    fn air_unlike(&self, other: &Wing, state: &State) -> Option<Vec<[f64; 3]>> {
        if self.air.is_none() || self.strips.strips.len() != other.strips.strips.len() {
            return Some(Vec::new());
        }
        let shapes = other.strips.shapes(state);
        let [own, of_other] = [self, other].map(|wing| wing.strip_air(&shapes, false));
        let (own, of_other) = (own.ok()?, of_other.ok()?);
        if own.iter().zip(&of_other).all(|(a, b)| a.force == b.force) {
            return Some(Vec::new());
        }
        let strips = self.strips.strips.iter().zip(own.iter().zip(&of_other));
        let row = |(strip, (a, b)): (&Strip, (&StripAir, &StripAir))| {
            [strip.r_m, b.force.normal_n_per_m, a.force.normal_n_per_m]
        };
        Some(strips.map(row).collect())
    }
}

/// Nodes that are held, sprung or weighted otherwise.
fn supports<'a>(own: &'a Model, other: &'a Model) -> impl Iterator<Item = usize> + 'a {
    let held = own.held.iter().zip(&other.held).enumerate();
    let held = held.filter(|(_, (a, b))| a != b).map(|(node, _)| node);
    let springs = differing(&own.springs, &other.springs).map(|spring| spring.node);
    held.chain(springs)
        .chain(differing(&own.masses, &other.masses).map(|mass| mass.node))
}

/// Nodes that are loaded otherwise.
fn loaded<'a>(own: &'a Loads, other: &'a Loads) -> impl Iterator<Item = usize> + 'a {
    let arms = differing(&own.arms, &other.arms).map(|arm| arm.node);
    unlike(&own.force_n, &other.force_n)
        .chain(unlike(&own.moment_n_m, &other.moment_n_m))
        .chain(arms)
        .chain(differing(&own.linear, &other.linear).map(|linear| linear.node))
}

fn unlike<'a>(own: &'a [Vector3<f64>], other: &'a [Vector3<f64>]) -> impl Iterator<Item = usize> + 'a {
    let pairs = own.iter().zip(other).enumerate();
    pairs.filter(|(_, (a, b))| a != b).map(|(node, _)| node)
}

/// What is in one of two lists alone.
fn differing<'a, T: PartialEq>(own: &'a [T], other: &'a [T]) -> impl Iterator<Item = &'a T> {
    let only = |of: &'a [T], not_in: &'a [T]| of.iter().filter(move |item| !not_in.contains(item));
    only(own, other).chain(only(other, own))
}

fn in_order(numbers: impl Iterator<Item = usize>) -> Vec<usize> {
    numbers.collect::<BTreeSet<_>>().into_iter().collect()
}
