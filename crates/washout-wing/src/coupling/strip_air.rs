//! The force of the air on a strip, and how it changes with the shape.

use super::strips::{Strip, StripShape};
use crate::aero::{
    Number, SectionChange, StripForce, alpha_linear, pressure_weights, strip_force, strip_force_linear,
};
use crate::effects::Dual;
use nalgebra::{SMatrix, SVector, Vector3};

use super::air::Air;

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

impl Strip {
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
