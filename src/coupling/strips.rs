//! Strips of air on the mesh: how they see the shape, and how their force reaches the nodes.
//!
//! Two strips stand over each element of the leading edge, each cut at a Gauss point of the element, so that a twist
//! that is linear between the nodes does its exact work on a load that is linear too: cut in the middle instead, eight
//! elements miss the divergence of a uniform wing by 0.64 %, so by 0.32 %. A strip's points are the crossings of its plane
//! with the film's edges, each a linear interpolation of two nodes. The same weights carry shape one way and force the
//! other, so force, moment and virtual work are kept for every shape.

use super::air::Air;
use crate::aero::{
    Number, SectionChange, StripForce, alpha_linear, pressure_weights, strip_force, strip_force_linear,
};
use crate::effects::Dual;
use crate::mesh::{ChordLines, ChordPoint, Mesh};
use crate::structure::state::State;
use nalgebra::{SMatrix, SVector, Vector3};

/// What a strip sees of the shape: chord vector from leading to trailing edge (m) and leading-edge tangent (per rest
/// length), wing frame.
pub type StripShape = SVector<f64, 6>;

/// Places of the two Gauss points on an element from −1 to 1: ±1/√3.
const GAUSS: [f64; 2] = [-0.577_350_269_189_625_8, 0.577_350_269_189_625_8];

/// Strips of a mesh, from base to tip.
#[derive(Debug, Clone, Default)]
pub struct Strips {
    /// The strips.
    pub strips: Vec<Strip>,
}

/// One strip.
#[derive(Debug, Clone)]
pub struct Strip {
    /// Span position of its plane at rest, m.
    pub r_m: f64,
    /// Width at rest, m: half the element's.
    pub width_m: f64,
    /// Chord at rest, m.
    pub chord_m: f64,
    /// Points from leading to trailing edge.
    pub points: Vec<ChordPoint>,
    /// Chord fraction of each point.
    pub eta: Vec<f64>,
    /// Nodes of the leading edge on either side.
    pub edge: [usize; 2],
    /// Chord vector and leading-edge tangent at rest.
    pub rest: StripShape,
}

/// Force of a strip on its points.
#[derive(Debug, Clone)]
pub struct StripAir {
    /// The section force, per length.
    pub force: StripForce<f64>,
    /// Force on the whole strip, N.
    pub total_n: Vector3<f64>,
    /// Share of each point.
    pub weights: Vec<f64>,
    /// Force on the last point, and against it on the first, that makes the moment besides the pressure's, N.
    pub couple_n: Vector3<f64>,
    /// Derivative of each point's force (3) with the strip's shape (6), if asked for.
    pub by_shape: Vec<SMatrix<f64, 3, 6>>,
}

impl Strips {
    /// Two strips over each element of the leading edge that meets the film.
    pub fn new(mesh: &Mesh) -> Self {
        if mesh.triangles.is_empty() {
            return Strips::default();
        }
        let lines = ChordLines::new(mesh);
        let strip = |pair: &[usize], place: f64| {
            let [a, b] = [pair[0], pair[1]].map(|node| Vector3::from(mesh.nodes[node]));
            let length_m = b.x - a.x;
            let r_m = 0.5 * (a.x + b.x) + 0.5 * place * length_m;
            let line = lines.at(r_m)?;
            let place = |p: &ChordPoint| {
                let [m, n] = p.nodes.map(|node| Vector3::from(mesh.nodes[node]));
                p.weights[0] * m + p.weights[1] * n
            };
            let (first, last) = (line.points.first()?, line.points.last()?);
            let chord = place(last) - place(first);
            let chord_m = last.y_m - first.y_m;
            let tangent = (b - a) / length_m;
            let eta = line
                .points
                .iter()
                .map(|p| (p.y_m - first.y_m) / chord_m)
                .collect();
            let rest =
                StripShape::from_column_slice(&[chord.x, chord.y, chord.z, tangent.x, tangent.y, tangent.z]);
            (length_m > 0.0 && chord_m > 0.0).then(|| Strip {
                r_m,
                width_m: 0.5 * length_m,
                chord_m,
                eta,
                points: line.points,
                edge: [pair[0], pair[1]],
                rest,
            })
        };
        Strips {
            strips: (mesh.leading_edge.windows(2))
                .flat_map(|pair| GAUSS.map(|place| strip(pair, place)))
                .flatten()
                .collect(),
        }
    }

    /// Span position of the outer end of the last strip, m; 0 without strips.
    pub fn tip_m(&self) -> f64 {
        // the last two strips share an element, at a ± h/√3 from its middle
        match self.strips.as_slice() {
            [.., inner, outer] => 0.5 * (inner.r_m + outer.r_m) + outer.width_m,
            [only] => only.r_m + 0.5 * only.width_m,
            [] => 0.0,
        }
    }

    /// Chord at rest at a span position, m; linear between strips, and beyond the ends that of the end.
    pub fn chord_m(&self, r_m: f64) -> f64 {
        let strips = &self.strips;
        let after = strips.partition_point(|strip| strip.r_m < r_m);
        let near = strips.get(after).or(strips.last());
        let before = strips.get(after.saturating_sub(1)).or(near);
        match (before, near) {
            (Some(a), Some(b)) if b.r_m > a.r_m => {
                let share = ((r_m - a.r_m) / (b.r_m - a.r_m)).clamp(0.0, 1.0);
                a.chord_m + share * (b.chord_m - a.chord_m)
            }
            (_, Some(only)) => only.chord_m,
            _ => 0.0,
        }
    }

    /// Shapes of all strips, six values each.
    pub fn shapes(&self, state: &State) -> Vec<f64> {
        self.strips
            .iter()
            .flat_map(|strip| strip.shape(&state.displacement).data.0[0])
            .collect()
    }

    /// Change of the shapes with a change of the displacements (the linear part of [`Strips::shapes`]).
    pub fn shape_changes(&self, displacement: &[Vector3<f64>]) -> Vec<f64> {
        self.strips
            .iter()
            .flat_map(|strip| strip.shape_change(displacement).data.0[0])
            .collect()
    }
}

impl Strip {
    /// Shape of the strip under nodal displacements, m.
    pub fn shape(&self, displacement: &[Vector3<f64>]) -> StripShape {
        self.rest + self.shape_change(displacement)
    }

    fn shape_change(&self, displacement: &[Vector3<f64>]) -> StripShape {
        let at = |p: &ChordPoint| {
            p.weights[0] * displacement[p.nodes[0]] + p.weights[1] * displacement[p.nodes[1]]
        };
        let chord = at(&self.points[self.points.len() - 1]) - at(&self.points[0]);
        let tangent = (displacement[self.edge[1]] - displacement[self.edge[0]]) / (2.0 * self.width_m);
        StripShape::from_column_slice(&[chord.x, chord.y, chord.z, tangent.x, tangent.y, tangent.z])
    }

    /// The air's force in a shape.
    pub fn air(&self, air: &Air, shape: &StripShape) -> StripAir {
        self.air_at(air, &air.flow.velocity(self.r_m), shape)
    }

    /// The same in air that comes with another velocity (m/s, wing frame) than the flow's.
    pub fn air_at(&self, air: &Air, velocity: &Vector3<f64>, shape: &StripShape) -> StripAir {
        match air.acting(self) {
            None => self.valued(&self.force(air, velocity, shape, &())),
            Some(acting) => self.valued(&self.force(air, velocity, &shape.map(Dual::from), &acting).real()),
        }
    }

    /// The same with derivatives.
    pub fn air_and_derivative(&self, air: &Air, shape: &StripShape) -> StripAir {
        let seeded = SVector::<Dual, 6>::from_fn(|i, _| Dual::from_re(shape[i]).derivative(i));
        let velocity = air.flow.velocity(self.r_m);
        let force = match air.acting(self) {
            None => self.force(air, &velocity, &seeded, &()),
            Some(acting) => self.force(air, &velocity, &seeded, &acting),
        };
        let by_shape = |point: Vector3<Dual>| {
            SMatrix::<f64, 3, 6>::from_fn(|i, j| {
                point[i]
                    .eps
                    .unwrap_generic(nalgebra::Const::<6>, nalgebra::Const::<1>)[j]
            })
        };
        StripAir {
            by_shape: (0..force.weights.len()).map(|k| by_shape(force.at(k))).collect(),
            ..self.valued(&force.real())
        }
    }

    fn valued(&self, force: &Spread<f64>) -> StripAir {
        StripAir {
            force: force.section,
            total_n: force.total_n,
            weights: force.weights.clone(),
            couple_n: force.couple_n,
            by_shape: Vec::new(),
        }
    }

    fn force<D: Number>(
        &self,
        air: &Air,
        velocity: &Vector3<f64>,
        shape: &SVector<D, 6>,
        change: &impl SectionChange<D>,
    ) -> Spread<D> {
        let chord = Vector3::new(shape[0], shape[1], shape[2]);
        let span = Vector3::new(shape[3], shape[4], shape[5]);
        let linear = || {
            let alpha = alpha_linear(velocity, &chord, &span, self.chord_m);
            let force = strip_force_linear(&air.law, velocity, alpha, self.chord_m, change);
            (force, D::from(self.chord_m))
        };
        let large = || {
            let velocity = velocity.map(D::from);
            let force = strip_force(&air.law, &velocity, &chord, &span, self.chord_m, change);
            (force, chord.dot(&chord).sqrt())
        };
        let (section, lever) = match air.large_share {
            0.0 => linear(),
            1.0 => large(),
            share => {
                let ((a, short), (b, long)) = (linear(), large());
                (mixed(share, &a, &b), short * (1.0 - share) + long * share)
            }
        };
        let pair = section.moment_n * self.width_m / lever;
        Spread {
            weights: pressure_weights(section.centre_of_pressure, &self.eta),
            total_n: section.force_n_per_m.map(|f| f * self.width_m),
            couple_n: section.normal.map(|n| n * pair),
            section,
        }
    }

    /// Hands the forces of the points to the nodes: `take(node, share of the point, point)`.
    pub fn spread(&self, mut take: impl FnMut(usize, f64, usize)) {
        for (index, point) in self.points.iter().enumerate() {
            for (node, weight) in point.nodes.into_iter().zip(point.weights) {
                if weight != 0.0 {
                    take(node, weight, index);
                }
            }
        }
    }
}

/// Force of a strip before it is spread over its points.
struct Spread<D> {
    section: StripForce<D>,
    total_n: Vector3<D>,
    weights: Vec<D>,
    couple_n: Vector3<D>,
}

impl<D: Number> Spread<D> {
    /// Force on a point, N.
    fn at(&self, point: usize) -> Vector3<D> {
        let force = self.total_n.map(|f| f * self.weights[point]);
        on_point(force, self.couple_n, point, self.weights.len())
    }
}

impl StripAir {
    /// Force on a point, N.
    pub fn on_point_n(&self, point: usize) -> Vector3<f64> {
        let force = self.total_n * self.weights[point];
        on_point(force, self.couple_n, point, self.weights.len())
    }
}

/// A point's share of the force, with its part of the couple between the first point and the last.
fn on_point<D: Number>(force: Vector3<D>, couple: Vector3<D>, point: usize, points: usize) -> Vector3<D> {
    match point {
        0 => force - couple,
        _ if point + 1 == points => force + couple,
        _ => force,
    }
}

impl Spread<Dual> {
    fn real(&self) -> Spread<f64> {
        Spread {
            section: real(&self.section),
            total_n: self.total_n.map(|f| f.re),
            weights: self.weights.iter().map(|w| w.re).collect(),
            couple_n: self.couple_n.map(|f| f.re),
        }
    }
}

/// The share `large` of `b` and the rest of `a`.
fn mixed<D: Number>(large: f64, a: &StripForce<D>, b: &StripForce<D>) -> StripForce<D> {
    let one = |a: &D, b: &D| *a * (1.0 - large) + *b * large;
    let three = |a: &Vector3<D>, b: &Vector3<D>| Vector3::from_fn(|i, _| one(&a[i], &b[i]));
    StripForce {
        alpha: one(&a.alpha, &b.alpha),
        speed: one(&a.speed, &b.speed),
        cl: one(&a.cl, &b.cl),
        cd: one(&a.cd, &b.cd),
        centre_of_pressure: one(&a.centre_of_pressure, &b.centre_of_pressure),
        moment_n: one(&a.moment_n, &b.moment_n),
        normal_n_per_m: one(&a.normal_n_per_m, &b.normal_n_per_m),
        tangential_n_per_m: one(&a.tangential_n_per_m, &b.tangential_n_per_m),
        normal: three(&a.normal, &b.normal),
        chord: three(&a.chord, &b.chord),
        force_n_per_m: three(&a.force_n_per_m, &b.force_n_per_m),
    }
}

fn real(force: &StripForce<Dual>) -> StripForce<f64> {
    StripForce {
        alpha: force.alpha.re,
        speed: force.speed.re,
        cl: force.cl.re,
        cd: force.cd.re,
        centre_of_pressure: force.centre_of_pressure.re,
        moment_n: force.moment_n.re,
        normal_n_per_m: force.normal_n_per_m.re,
        tangential_n_per_m: force.tangential_n_per_m.re,
        normal: force.normal.map(|x| x.re),
        chord: force.chord.map(|x| x.re),
        force_n_per_m: force.force_n_per_m.map(|x| x.re),
    }
}
