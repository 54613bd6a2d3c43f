//! What nature does: another solver, another mesh, other formulas of the same physics, and a background of small errors.

use std::f64::consts::PI;

use washout::study::draws::Draws;

use crate::rod::{ROOT_ANGLE, ROOT_OFFSET, Toy, chord};

/// Points of nature's mesh, denser toward the ends.
const POINTS: usize = 161;

/// A hidden cause with its strength.
#[derive(Debug, Clone, PartialEq)]
pub enum Hidden {
    /// An effect of the library, by name, perhaps by another formula.
    Known(&'static str, f64),
    /// Damage between the places that the library knows: place, strength.
    Damage(f64, f64),
    /// A bump of moment per length: place, N m/m, powers of frequency and amplitude.
    Bump(f64, f64, [f64; 2]),
    /// A bump of moment per length above a frequency: place, N m/m, Hz.
    Onset(f64, f64, f64),
    /// A local spring: place, N m/m per rad.
    Spring(f64, f64),
    /// A soft stretch: place, share of compliance.
    Soft(f64, f64),
    /// A wave in the reading: deg.
    Wave(f64),
}

/// Everything that is true of one case.
#[derive(Debug, Clone)]
pub struct Nature {
    pub hidden: Vec<Hidden>,
    pub nuisances: [f64; 4],
    pub background: [f64; 4],
    /// Whether formulas differ from those of the library.
    pub other_formulas: bool,
}

impl Nature {
    /// Nuisances from their priors, 1 to 3 % of background error.
    pub fn drawn(draws: Draws, hidden: Vec<Hidden>) -> Nature {
        let normal = |k: u64| draws.normal(7, k).clamp(-2.5, 2.5);
        Nature {
            hidden,
            nuisances: [0.05 * normal(0), 0.06 * normal(1), normal(2), 0.3 * normal(3)],
            background: [
                0.01 * normal(4),
                0.01 * normal(5),
                0.015 * normal(6),
                6.0 * draws.uniform(8, 0),
            ],
            other_formulas: draws.uniform(8, 1) < 0.5,
        }
    }

    fn known(&self, name: &str) -> f64 {
        let strength = |hidden: &Hidden| match hidden {
            Hidden::Known(known, strength) if *known == name => *strength,
            _ => 0.0,
        };
        self.hidden.iter().map(strength).sum()
    }

    /// What the camera reads without noise, for every observable, deg.
    pub fn readings(&self, toy: &Toy) -> Vec<f64> {
        let shapes: Vec<Vec<[f64; 2]>> = (0..toy.conditions.len()).map(|c| self.shape(toy, c)).collect();
        let read = |row: usize| {
            let observable = &toy.observables[row];
            let length = toy.conditions[observable.condition].length_m;
            let xi = observable.r_mm.unwrap_or(0.0) / (1e3 * length);
            let shape = &shapes[observable.condition];
            let after = shape.partition_point(|point| point[0] < xi).clamp(1, POINTS - 1);
            let (left, right) = (shape[after - 1], shape[after]);
            let share = (xi - left[0]) / (right[0] - left[0]);
            let twist = (left[1] + share * (right[1] - left[1])).to_degrees();
            let wave: f64 = self
                .hidden
                .iter()
                .map(|hidden| match hidden {
                    Hidden::Wave(size) => size * (2.0 * PI * xi).sin(),
                    _ => 0.0,
                })
                .sum();
            twist * (1.0 + self.known("camera_scale"))
                + self.nuisances[3]
                + self.known("camera_tilt") * xi
                + wave
        };
        (0..toy.observables.len()).map(read).collect()
    }

    /// Twist (rad) along x/length by repeated integration of the torque from the tip and the twist rate from the base.
    fn shape(&self, toy: &Toy, condition: usize) -> Vec<[f64; 2]> {
        let (wing, c) = (toy.wings[condition], &toy.conditions[condition]);
        let length = wing.length_m;
        let f = c.frequency_hz.unwrap_or(0.0) * (1.0 + self.known("frequency_error"));
        let phi = c.half_amplitude_deg.unwrap_or(0.0).to_radians();
        let xi: Vec<f64> = (0..POINTS)
            .map(|i| 0.5 * (1.0 - (PI * i as f64 / (POINTS - 1) as f64).cos()))
            .collect();
        let mut theta = vec![0.0; POINTS];
        let tip = self.known("tip_mass") * 2e-5 * (f / 25.0).powi(2) * phi;
        for _ in 0..400 {
            let moment: Vec<f64> = (0..POINTS)
                .map(|i| self.moment(xi[i], length, f, phi, theta[i]))
                .collect();
            let mut torque = vec![tip; POINTS];
            for i in (0..POINTS - 1).rev() {
                torque[i] = torque[i + 1] + 0.5 * (moment[i] + moment[i + 1]) * (xi[i + 1] - xi[i]) * length;
            }
            let rate: Vec<f64> = (0..POINTS)
                .map(|i| self.rate(xi[i], torque[i], wing.gj_n_m2, length))
                .collect();
            let mut next =
                vec![(self.known("root_compliance") + self.known("clamp_slip")) * torque[0]; POINTS];
            for i in 1..POINTS {
                next[i] = next[i - 1] + 0.5 * (rate[i] + rate[i - 1]) * (xi[i] - xi[i - 1]) * length;
            }
            for i in 0..POINTS {
                next[i] += self.jumps(xi[i], &xi, &torque);
            }
            let change = next
                .iter()
                .zip(&theta)
                .map(|(n, t)| (n - t).abs())
                .fold(0.0, f64::max);
            for (theta, next) in theta.iter_mut().zip(&next) {
                *theta += 0.5 * (next - *theta);
            }
            if change < 1e-10 {
                break;
            }
        }
        xi.into_iter().zip(theta).map(|(x, t)| [x, t]).collect()
    }

    /// Twist that damages inboard of `xi` add.
    fn jumps(&self, xi: f64, places: &[f64], torque: &[f64]) -> f64 {
        let jump = |place: f64, strength: f64| {
            let at = places.partition_point(|x| *x < place).min(POINTS - 1);
            if xi >= place { strength * torque[at] } else { 0.0 }
        };
        self.hidden
            .iter()
            .map(|hidden| match hidden {
                Hidden::Damage(place, strength) => jump(*place, *strength),
                _ => 0.0,
            })
            .sum()
    }

    fn rate(&self, xi: f64, torque: f64, gj: f64, length: f64) -> f64 {
        let end = if self.other_formulas {
            if xi > 0.88 { 1.0 } else { 0.0 }
        } else {
            (-((1.0 - xi) / 0.15).powi(2)).exp()
        };
        let taper = self.known("taper") * (xi - 0.5);
        let stepped = self.known("taper") * if xi > 0.5 { 0.3 } else { -0.3 };
        let soft: f64 = self
            .hidden
            .iter()
            .map(|hidden| match hidden {
                Hidden::Soft(place, share) => share * (-0.5 * ((xi - place) / 0.1).powi(2)).exp(),
                _ => 0.0,
            })
            .sum();
        let gj = gj
            * self.nuisances[0].exp()
            * (1.0 + self.known("stiffness"))
            * (1.0 + if self.other_formulas { stepped } else { taper })
            * (1.0 - self.known("rod_short") * end)
            * (1.0 + self.background[0] * (5.0 * xi + self.background[3]).sin())
            / (1.0 + soft);
        let stiffening = self.known("geometric_stiffening");
        let mut rate = torque / gj;
        for _ in 0..30 {
            rate = 0.5 * (rate + torque / (gj * (1.0 + stiffening * (rate * length).powi(2))));
        }
        rate
    }

    fn moment(&self, xi: f64, length: f64, f: f64, phi: f64, theta: f64) -> f64 {
        let r = ROOT_OFFSET + xi * length;
        let span = ROOT_OFFSET + length;
        let omega = 2.0 * PI * f * phi;
        let speed = omega * r;
        let c = chord(xi, length) * (1.0 + self.background[1] * (4.0 * xi + self.background[3]).cos());
        let inflow = 0.1 * self.known("inflow_uniform") * span / (r + 0.2 * span)
            + 0.15 * self.known("inflow_linear") * xi;
        let alpha = ROOT_ANGLE + self.nuisances[2].to_radians() - theta - inflow;
        let tip_loss = self.known("tip_loss_exponential");
        let prandtl = 1.0 - 2.0 / PI * (-1.6 * (1.0 - xi) / 0.12 * 0.5).exp().acos();
        let loss = if self.other_formulas {
            tip_loss * prandtl
        } else {
            tip_loss * (-(1.0 - xi) / 0.12).exp()
        } + self.known("tip_loss_cutoff") * (((xi - 0.7) / 0.3).max(0.0)).powi(2);
        let gain = self.known("lift_gain");
        let gained = if self.other_formulas {
            gain * 0.6 * (theta / 0.6).tanh()
        } else {
            gain * theta
        };
        let factor = (1.0 + self.known("coefficient_scale"))
            * (1.0 - loss)
            * (1.0 + gained)
            * (1.0 - self.known("stall") * (alpha - 0.6).max(0.0))
            * (1.0 + self.known("pressure_centre") * (alpha - 0.7))
            * (1.0 + self.known("reynolds") * (speed / 10.0).max(1e-3).ln())
            * (1.0 + self.background[2] * (2.0 * alpha).cos());
        let load = 0.6 * speed * speed * c * c * 0.25 * 1.8 * self.nuisances[1].exp() * alpha.sin() * factor;
        let rates = f / 25.0;
        let near = |place: f64| (-0.5 * ((xi - place) / 0.12).powi(2)).exp();
        let unknown: f64 = self
            .hidden
            .iter()
            .map(|hidden| match hidden {
                Hidden::Bump(place, size, [a, b]) => size * near(*place) * rates.powf(*a) * phi.powf(*b),
                Hidden::Onset(place, size, from) if f > *from => size * near(*place),
                Hidden::Spring(place, size) => -size * near(*place) * theta,
                _ => 0.0,
            })
            .sum();
        load - self.known("centrifugal") * 1e-6 * omega.powi(2) * xi * theta
            - self.known("film_tension") * 0.01 * theta
            + self.known("gravity") * 2e-3
            + self.known("inertia") * 2e-3 * rates * rates * phi * c / 0.02
            + self.known("rotational_damping") * 2e-3 * rates * phi * (c / 0.02).powi(3) * xi
            + unknown
    }
}
