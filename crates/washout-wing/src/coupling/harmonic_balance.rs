//! Periodic motion of linear modes with damping and stiffness that vary over the stroke, by harmonic balance.
//!
//! ẍ + (D₀ + |cos τ| D₁) ẋ + (Λ + cos²τ A) x = f(τ), τ = ω t, with x(τ + π) = −x(τ): odd harmonics only. The residual is
//! made orthogonal to every harmonic (Galerkin; Nayfeh & Mook 1979, §2.3). Since ẋ is among them, the energy over a stroke
//! closes whatever the number of harmonics.

use nalgebra::{DMatrix, DVector};

/// Phases of the quadrature over a stroke.
const PHASES: usize = 720;

/// The equations of the modes, each of mass 1 kg.
#[derive(Debug, Clone, PartialEq)]
pub struct Oscillators {
    /// Angular frequency of the stroke ω, rad/s.
    pub rate_rad_s: f64,
    /// Squares of the natural angular frequencies Λ, 1/s².
    pub stiffness: DVector<f64>,
    /// Damping D₀ that is always there, 1/s.
    pub damping: DMatrix<f64>,
    /// Damping D₁ at mid-stroke that goes with |cos τ|, 1/s.
    pub air_damping: DMatrix<f64>,
    /// Stiffness A at mid-stroke that goes with cos²τ, 1/s².
    pub air_stiffness: DMatrix<f64>,
}

/// A motion of odd harmonics: x = Σ a cos hτ + b sin hτ.
#[derive(Debug, Clone, PartialEq)]
pub struct Harmonics {
    /// Orders h.
    pub orders: Vec<usize>,
    /// Amplitudes a of each order, by mode.
    pub cosine: Vec<DVector<f64>>,
    /// Amplitudes b of each order, by mode.
    pub sine: Vec<DVector<f64>>,
}

/// Work over one stroke, J for modes of 1 kg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrokeWork {
    /// Done by the forcing.
    pub forced: f64,
    /// Taken up by the damping, the air's included.
    pub damped: f64,
    /// Taken up by the air's stiffness, which need not be conservative.
    pub air_stiffness: f64,
}

impl Oscillators {
    /// The motion under a forcing (by mode, m/s² for modes of 1 kg) in the given odd orders; `None` where the balance is
    /// singular: a resonance without damping.
    pub fn balance(&self, orders: &[usize], force: impl Fn(f64) -> DVector<f64>) -> Option<Harmonics> {
        let (modes, trials) = (self.stiffness.len(), 2 * orders.len());
        let rate = self.rate_rad_s;
        let mut matrix = DMatrix::<f64>::zeros(modes * trials, modes * trials);
        let mut right = DVector::<f64>::zeros(modes * trials);
        // means over a stroke of trial · derivative of trial, weighed with |cos| and cos²
        let mut means = [(); 4].map(|()| DMatrix::<f64>::zeros(trials, trials));
        let mut second = DMatrix::<f64>::zeros(trials, trials);
        for phase in phases() {
            let [values, slopes, curves] = trial(orders, phase);
            let speed = phase.cos().abs();
            let share = 1.0 / PHASES as f64;
            second += share * &values * curves.transpose();
            means[0] += share * &values * values.transpose();
            means[1] += share * &values * slopes.transpose();
            means[2] += share * speed * &values * slopes.transpose();
            means[3] += share * speed * speed * &values * values.transpose();
            let now = force(phase) * share;
            for i in 0..trials {
                let mut part = right.rows_mut(i * modes, modes);
                part += &now * values[i];
            }
        }
        let identity = DMatrix::<f64>::identity(modes, modes);
        let stiffness = DMatrix::from_diagonal(&self.stiffness);
        for i in 0..trials {
            for j in 0..trials {
                let block = &identity * (rate * rate * second[(i, j)])
                    + &stiffness * means[0][(i, j)]
                    + &self.damping * (rate * means[1][(i, j)])
                    + &self.air_damping * (rate * means[2][(i, j)])
                    + &self.air_stiffness * means[3][(i, j)];
                matrix
                    .view_mut((i * modes, j * modes), (modes, modes))
                    .copy_from(&block);
            }
        }
        let solved = matrix.lu().solve(&right)?;
        if solved.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let part = |trial: usize| solved.rows(trial * modes, modes).into_owned();
        Some(Harmonics {
            orders: orders.to_vec(),
            cosine: (0..orders.len()).map(|k| part(2 * k)).collect(),
            sine: (0..orders.len()).map(|k| part(2 * k + 1)).collect(),
        })
    }

    /// Work over one stroke of a motion under a forcing.
    pub fn work(&self, motion: &Harmonics, force: impl Fn(f64) -> DVector<f64>) -> StrokeWork {
        let mut work = StrokeWork {
            forced: 0.0,
            damped: 0.0,
            air_stiffness: 0.0,
        };
        let step = std::f64::consts::TAU / PHASES as f64;
        for phase in phases() {
            // per radian of phase
            let path = motion.slope(phase) * step;
            let velocity = motion.slope(phase) * self.rate_rad_s;
            let speed = phase.cos().abs();
            work.forced += force(phase).dot(&path);
            work.damped += (&self.damping * &velocity + &self.air_damping * &velocity * speed).dot(&path);
            work.air_stiffness += (&self.air_stiffness * motion.value(phase)).dot(&path) * speed * speed;
        }
        work
    }
}

impl Harmonics {
    /// x at a phase (rad), by mode.
    pub fn value(&self, phase: f64) -> DVector<f64> {
        self.sum(&trial(&self.orders, phase)[0])
    }

    /// dx/dτ at a phase (rad).
    pub fn slope(&self, phase: f64) -> DVector<f64> {
        self.sum(&trial(&self.orders, phase)[1])
    }

    /// d²x/dτ² at a phase (rad).
    pub fn curve(&self, phase: f64) -> DVector<f64> {
        self.sum(&trial(&self.orders, phase)[2])
    }

    fn sum(&self, weights: &DVector<f64>) -> DVector<f64> {
        let modes = self.cosine.first().map_or(0, DVector::len);
        let pairs = self.cosine.iter().zip(&self.sine).enumerate();
        pairs.fold(DVector::zeros(modes), |sum, (k, (cosine, sine))| {
            sum + cosine * weights[2 * k] + sine * weights[2 * k + 1]
        })
    }
}

/// Phases in the middle of equal parts of a stroke, so that none falls on a reversal.
fn phases() -> impl Iterator<Item = f64> {
    (0..PHASES).map(|index| (index as f64 + 0.5) * std::f64::consts::TAU / PHASES as f64)
}

/// cos and sin of each order with their first and second derivatives.
fn trial(orders: &[usize], phase: f64) -> [DVector<f64>; 3] {
    let parts: Vec<[f64; 6]> = orders
        .iter()
        .map(|&order| {
            let h = order as f64;
            let (sin, cos) = (h * phase).sin_cos();
            [cos, sin, -h * sin, h * cos, -h * h * cos, -h * h * sin]
        })
        .collect();
    [0, 2, 4]
        .map(|at| DVector::from_iterator(2 * orders.len(), parts.iter().flat_map(|p| [p[at], p[at + 1]])))
}

#[cfg(test)]
mod tests {
    use super::Oscillators;
    use nalgebra::{DMatrix, DVector};
    use std::f64::consts::PI;

    fn one(natural: f64, damping: f64, rate: f64) -> Oscillators {
        Oscillators {
            rate_rad_s: rate,
            stiffness: DVector::from_element(1, natural * natural),
            damping: DMatrix::from_element(1, 1, damping),
            air_damping: DMatrix::zeros(1, 1),
            air_stiffness: DMatrix::zeros(1, 1),
        }
    }

    /// x = F / (ω₀² − h²ω² + i h ω d) for each harmonic.
    #[test]
    fn an_oscillator_answers_each_harmonic_by_its_transfer_function() {
        let (natural, damping, rate) = (70.0, 4.0, 20.0);
        let system = one(natural, damping, rate);
        let force = |phase: f64| DVector::from_element(1, 3.0 * phase.cos() - 2.0 * (3.0 * phase).sin());
        let motion = system.balance(&[1, 3], force).unwrap();
        for (k, (order, [real, imaginary])) in [(1.0, [3.0, 0.0]), (3.0, [0.0, 2.0])].into_iter().enumerate()
        {
            // F cos − G sin is the real part of (F + iG) e^{iτ}; the answer's is a − ib
            let (below, aside) = (
                natural * natural - order * order * rate * rate,
                order * rate * damping,
            );
            let size = below * below + aside * aside;
            let a = (real * below + imaginary * aside) / size;
            let b = -(imaginary * below - real * aside) / size;
            assert!(
                (motion.cosine[k][0] - a).abs() < 1e-14,
                "{} {a}",
                motion.cosine[k][0]
            );
            assert!((motion.sine[k][0] - b).abs() < 1e-14, "{} {b}", motion.sine[k][0]);
        }
    }

    /// With |cos τ| damping alone and the answer cos τ + sin τ prescribed, the forcing that makes it is known at every phase.
    #[test]
    fn a_made_motion_is_found_again_with_damping_and_stiffness_that_vary() {
        let rate = 5.0;
        let mut system = one(11.0, 0.3, rate);
        system.air_damping[(0, 0)] = 7.0;
        system.air_stiffness[(0, 0)] = -20.0;
        let force = |phase: f64| {
            let (sin, cos) = phase.sin_cos();
            let (x, v) = (cos + sin, rate * (cos - sin));
            let force = -rate * rate * x + (0.3 + 7.0 * cos.abs()) * v + (121.0 - 20.0 * cos * cos) * x;
            DVector::from_element(1, force)
        };
        let motion = system.balance(&[1, 3, 5], force).unwrap();
        for phase in [0.1, 1.0, 2.5, 4.0] {
            assert!((motion.value(phase)[0] - phase.cos() - phase.sin()).abs() < 1e-12);
            assert!((motion.curve(phase)[0] + phase.cos() + phase.sin()).abs() < 1e-11);
        }
    }

    /// Torsion of a uniform rod whose clamp turns by cos τ: the tip turns by 1/cos(kL) in space, k = ω √(I/GJ).
    #[test]
    fn a_rod_twisted_at_its_clamp_turns_as_its_wave_equation_says() {
        let (speed, length, rate) = (10.0, 1.0, 9.0); // √(GJ/I), m/s; m; rad/s
        let count = 400;
        let wave = |n: usize| (2.0 * n as f64 + 1.0) * PI / (2.0 * length);
        let system = Oscillators {
            rate_rad_s: rate,
            stiffness: DVector::from_fn(count, |n, _| (speed * wave(n)).powi(2)),
            damping: DMatrix::zeros(count, count),
            air_damping: DMatrix::zeros(count, count),
            air_stiffness: DMatrix::zeros(count, count),
        };
        // modes √(2/L) sin kx of unit polar inertia; the clamp's acceleration −ω² cos τ drives all of them
        let share = |n: usize| (2.0 / length).sqrt() / wave(n);
        let force = |phase: f64| DVector::from_fn(count, |n, _| share(n) * rate * rate * phase.cos());
        let motion = system.balance(&[1], force).unwrap();
        let tip: f64 = (0..count)
            .map(|n| motion.cosine[0][n] * (2.0 / length).sqrt() * if n % 2 == 0 { 1.0 } else { -1.0 })
            .sum();
        let exact = 1.0 / (rate * length / speed).cos() - 1.0;
        assert!((tip / exact - 1.0).abs() < 1e-5, "{tip} {exact}");
    }

    #[test]
    fn the_energy_over_a_stroke_closes() {
        let two = |a: [f64; 4]| DMatrix::from_row_slice(2, 2, &a);
        let system = Oscillators {
            rate_rad_s: 130.0,
            stiffness: DVector::from_vec(vec![2.1e5, 8.0e5]),
            damping: two([9.0, 0.0, 0.0, 18.0]),
            air_damping: two([60.0, 11.0, 25.0, 80.0]),
            air_stiffness: two([3e4, -8e3, 2e4, 1e4]),
        };
        // all harmonics, those beyond the balance too
        let force = |phase: f64| {
            let wave = phase.cos() * phase.cos().abs();
            DVector::from_vec(vec![100.0 * wave, 30.0 * wave.powi(3) - 50.0 * phase.sin()])
        };
        for orders in [&[1][..], &[1, 3], &[1, 3, 5]] {
            let motion = system.balance(orders, force).unwrap();
            let work = system.work(&motion, force);
            let taken = work.damped + work.air_stiffness;
            assert!(work.damped > 0.0 && work.air_stiffness.abs() > 1e-6 * work.damped);
            assert!((work.forced / taken - 1.0).abs() < 1e-10, "{work:?}");
        }
    }

    #[test]
    fn a_resonance_without_damping_has_no_answer() {
        let force = |phase: f64| DVector::from_element(1, phase.cos());
        let found = one(20.0, 0.0, 20.0).balance(&[1], force);
        assert!(found.is_none_or(|motion| motion.cosine[0][0].abs() > 1e6));
    }
}
