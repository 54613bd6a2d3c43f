//! The toy that is diagnosed: a rod in torsion under an air load that falls with twist, by finite volumes.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};
use washout::input::measurement::{Bound, Channel};
use washout::study::{Condition, Forward, Linear, Observable, StudyError, Unknown, UnknownKind};

use crate::effects::{EFFECTS, NUISANCES};

/// Intervals along the rod.
const CELLS: usize = 48;

/// One wing of the toy.
#[derive(Debug, Clone, Copy)]
pub struct Wing {
    pub name: &'static str,
    pub length_m: f64,
    pub gj_n_m2: f64,
}

/// Root angle of attack, rad.
pub const ROOT_ANGLE: f64 = 55.0 * PI / 180.0;
/// Distance of the base from the axis of flapping, m.
pub const ROOT_OFFSET: f64 = 0.012;

/// Chord at x/length, m.
pub fn chord(xi: f64, length: f64) -> f64 {
    0.3 * length * (1.0 - 0.55 * xi * xi)
}

#[derive(Debug, Clone)]
pub struct Toy {
    pub unknowns: Vec<Unknown>,
    pub observables: Vec<Observable>,
    pub conditions: Vec<Condition>,
    pub wings: Vec<Wing>,
}

impl Toy {
    /// Conditions (wing, Hz, deg, held out) seen at `stations` (x/length) with noise `sigma_deg`.
    pub fn new(wings: &[Wing], runs: &[(usize, f64, f64, bool)], stations: &[f64], sigma_deg: f64) -> Toy {
        let mut toy = Toy {
            unknowns: unknowns(),
            observables: Vec::new(),
            conditions: Vec::new(),
            wings: runs.iter().map(|run| wings[run.0]).collect(),
        };
        for (index, &(wing, frequency, amplitude, is_held_out)) in runs.iter().enumerate() {
            let length = wings[wing].length_m;
            let speed = 2.0 * PI * frequency * amplitude.to_radians() * (ROOT_OFFSET + length);
            toy.conditions.push(Condition {
                name: format!("{}-{frequency}-{amplitude}", wings[wing].name),
                wing: wings[wing].name.into(),
                is_held_out,
                frequency_hz: Some(frequency),
                half_amplitude_deg: Some(amplitude),
                dynamic_pressure_pa: 0.6 * speed * speed,
                length_m: length,
            });
            for &xi in stations {
                toy.observables.push(Observable {
                    condition: index,
                    line: toy.observables.len() + 2,
                    channel: Channel::Twist,
                    run: String::new(),
                    r_mm: Some(1e3 * xi * length),
                    r_to_mm: None,
                    value: 0.0,
                    sigma: sigma_deg,
                    bound: Bound::None,
                });
            }
        }
        toy
    }

    /// Residual of the rod for twist θ (rad) with an extra moment per length.
    fn residual(&self, condition: usize, at: &At, theta: &[f64], extra: &[f64]) -> Vec<f64> {
        let wing = self.wings[condition];
        let c = &self.conditions[condition];
        let f = c.frequency_hz.unwrap_or(0.0) * (1.0 + at.frequency_error);
        let phi = c.half_amplitude_deg.unwrap_or(0.0).to_radians();
        let (length, h) = (wing.length_m, wing.length_m / CELLS as f64);
        let tip = at.tip_mass * 2e-5 * (f / 25.0).powi(2) * phi;
        let torque: Vec<f64> = (0..CELLS)
            .map(|i| {
                let rate = (theta[i + 1] - theta[i]) / h;
                let xi = (i as f64 + 0.5) / CELLS as f64;
                let gj = wing.gj_n_m2 * at.stiffness(xi);
                let secant = gj * (1.0 + at.geometric_stiffening * (rate * length).powi(2));
                let damage = at.damage(xi) / h;
                secant * rate / (1.0 + secant * damage)
            })
            .collect();
        let mut residual = vec![0.0; CELLS + 1];
        residual[0] = wing.gj_n_m2 / length * (theta[0] - (at.root_compliance + at.clamp_slip) * torque[0]);
        for i in 1..=CELLS {
            let xi = i as f64 / CELLS as f64;
            let moment = at.moment(xi, length, f, phi, theta[i]) + extra[i];
            let outer = if i == CELLS { tip } else { torque[i] };
            let width = if i == CELLS { 0.5 * h } else { h };
            residual[i] = outer - torque[i - 1] + moment * width;
        }
        residual
    }

    fn tangent(&self, condition: usize, at: &At, theta: &[f64], extra: &[f64]) -> DMatrix<f64> {
        let size = CELLS + 1;
        let mut tangent = DMatrix::zeros(size, size);
        let step = 1e-6;
        for colour in 0..3 {
            let moved = |sign: f64| {
                let mut moved = theta.to_vec();
                moved
                    .iter_mut()
                    .skip(colour)
                    .step_by(3)
                    .for_each(|value| *value += sign * step);
                self.residual(condition, at, &moved, extra)
            };
            let (up, down) = (moved(1.0), moved(-1.0));
            for column in (colour..size).step_by(3) {
                for row in column.saturating_sub(1)..(column + 2).min(size) {
                    tangent[(row, column)] = (up[row] - down[row]) / (2.0 * step);
                }
            }
        }
        tangent
    }

    fn solve(&self, condition: usize, at: &At) -> Result<Vec<f64>, StudyError> {
        let none = vec![0.0; CELLS + 1];
        let mut theta = vec![0.0; CELLS + 1];
        for _ in 0..40 {
            let residual = DVector::from_vec(self.residual(condition, at, &theta, &none));
            let step = banded(&self.tangent(condition, at, &theta, &none), &residual);
            let largest = step.amax();
            let damping = if largest > 0.5 { 0.5 / largest } else { 1.0 };
            for (value, step) in theta.iter_mut().zip(step.iter()) {
                *value -= damping * step;
            }
            if largest < 1e-11 {
                return Ok(theta);
            }
            if !largest.is_finite() {
                break;
            }
        }
        Err(StudyError::Case {
            case: self.conditions[condition].name.clone(),
            reason: "the rod found no shape".into(),
        })
    }

    /// What the camera reads, deg.
    fn read(&self, row: usize, at: &At, theta: &[f64]) -> f64 {
        let observable = &self.observables[row];
        let length_mm = 1e3 * self.conditions[observable.condition].length_m;
        let xi = observable.r_mm.unwrap_or(0.0) / length_mm;
        let place = xi * CELLS as f64;
        let below = (place as usize).min(CELLS - 1);
        let share = place - below as f64;
        let twist = ((1.0 - share) * theta[below] + share * theta[below + 1]).to_degrees();
        twist * (1.0 + at.camera_scale) + at.camera_offset + at.camera_tilt * xi
    }

    fn rows(&self, condition: usize) -> impl Iterator<Item = usize> {
        (0..self.observables.len()).filter(move |&row| self.observables[row].condition == condition)
    }

    /// Derivatives with the unknowns `columns`, and the values.
    fn derivatives(&self, at: &[f64], columns: &[usize]) -> Result<Linear, StudyError> {
        let size = self.observables.len();
        let mut linear = Linear {
            value: DVector::zeros(size),
            jacobian: DMatrix::zeros(size, self.unknowns.len()),
        };
        let none = vec![0.0; CELLS + 1];
        let here = At::new(at);
        for condition in 0..self.conditions.len() {
            let theta = self.solve(condition, &here)?;
            let tangent = self.tangent(condition, &here, &theta, &none);
            for row in self.rows(condition) {
                linear.value[row] = self.read(row, &here, &theta);
            }
            for &column in columns {
                let step = 1e-5 * self.unknowns[column].sigma;
                let moved = |sign: f64| {
                    let mut moved = at.to_vec();
                    moved[column] += sign * step;
                    moved
                };
                let (up, down) = (moved(1.0), moved(-1.0));
                let (up, down) = (At::new(&up), At::new(&down));
                let residual = |at: &At| DVector::from_vec(self.residual(condition, at, &theta, &none));
                let push = (residual(&up) - residual(&down)) / (2.0 * step);
                let answer = banded(&tangent, &push);
                for row in self.rows(condition) {
                    let shift = |sign: f64, at: &At| {
                        let moved: Vec<f64> = theta
                            .iter()
                            .zip(answer.iter())
                            .map(|(t, a)| t - sign * step * a)
                            .collect();
                        self.read(row, at, &moved)
                    };
                    linear.jacobian[(row, column)] = (shift(1.0, &up) - shift(-1.0, &down)) / (2.0 * step);
                }
            }
        }
        Ok(linear)
    }
}

/// Solves a tridiagonal system.
fn banded(matrix: &DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
    let size = right.len();
    let (mut diagonal, mut x) = (matrix.diagonal(), right.clone());
    for i in 1..size {
        let factor = matrix[(i, i - 1)] / diagonal[i - 1];
        diagonal[i] -= factor * matrix[(i - 1, i)];
        x[i] -= factor * x[i - 1];
    }
    x[size - 1] /= diagonal[size - 1];
    for i in (0..size - 1).rev() {
        x[i] = (x[i] - matrix[(i, i + 1)] * x[i + 1]) / diagonal[i];
    }
    x
}

/// Values of the unknowns by name.
struct At {
    frequency_error: f64,
    tip_mass: f64,
    geometric_stiffening: f64,
    root_compliance: f64,
    clamp_slip: f64,
    camera_scale: f64,
    camera_offset: f64,
    camera_tilt: f64,
    ln_g: f64,
    stiffness: f64,
    taper: f64,
    rod_short: f64,
    inflow_uniform: f64,
    inflow_linear: f64,
    root_angle: f64,
    tip_loss_exponential: f64,
    tip_loss_cutoff: f64,
    coefficient_scale: f64,
    lift_gain: f64,
    stall: f64,
    pressure_centre: f64,
    reynolds: f64,
    ln_cn: f64,
    centrifugal: f64,
    film_tension: f64,
    gravity: f64,
    inertia: f64,
    rotational_damping: f64,
    damages: Vec<(f64, f64)>,
}

impl At {
    fn new(values: &[f64]) -> At {
        let get = |name: &str| {
            let nuisance = NUISANCES.iter().position(|n| n.0 == name);
            let effect = || {
                EFFECTS
                    .iter()
                    .position(|e| e.name == name)
                    .map(|k| k + NUISANCES.len())
            };
            values[nuisance.or_else(effect).expect("a known unknown")]
        };
        At {
            frequency_error: get("frequency_error"),
            tip_mass: get("tip_mass"),
            geometric_stiffening: get("geometric_stiffening"),
            root_compliance: get("root_compliance"),
            clamp_slip: get("clamp_slip"),
            camera_scale: get("camera_scale"),
            camera_offset: get("camera_offset"),
            camera_tilt: get("camera_tilt"),
            ln_g: get("ln_g"),
            stiffness: get("stiffness"),
            taper: get("taper"),
            rod_short: get("rod_short"),
            inflow_uniform: get("inflow_uniform"),
            inflow_linear: get("inflow_linear"),
            root_angle: get("root_angle"),
            tip_loss_exponential: get("tip_loss_exponential"),
            tip_loss_cutoff: get("tip_loss_cutoff"),
            coefficient_scale: get("coefficient_scale"),
            lift_gain: get("lift_gain"),
            stall: get("stall"),
            pressure_centre: get("pressure_centre"),
            reynolds: get("reynolds"),
            ln_cn: get("ln_cn"),
            centrifugal: get("centrifugal"),
            film_tension: get("film_tension"),
            gravity: get("gravity"),
            inertia: get("inertia"),
            rotational_damping: get("rotational_damping"),
            damages: damages(values),
        }
    }

    fn stiffness(&self, xi: f64) -> f64 {
        let end = (-((1.0 - xi) / 0.15).powi(2)).exp();
        self.ln_g.exp()
            * (1.0 + self.stiffness)
            * (1.0 + self.taper * (xi - 0.5))
            * (1.0 - self.rod_short * end)
    }

    fn damage(&self, xi: f64) -> f64 {
        let share = |place: f64| (1.0 - (place - xi).abs() * CELLS as f64).max(0.0);
        self.damages
            .iter()
            .map(|(place, value)| value * share(*place))
            .sum()
    }

    /// Moment per length about the span, N m/m.
    fn moment(&self, xi: f64, length: f64, f: f64, phi: f64, theta: f64) -> f64 {
        let r = ROOT_OFFSET + xi * length;
        let span = ROOT_OFFSET + length;
        let omega = 2.0 * PI * f * phi;
        let speed = omega * r;
        let c = chord(xi, length);
        let inflow = 0.1 * self.inflow_uniform * span / (r + 0.2 * span) + 0.15 * self.inflow_linear * xi;
        let alpha = ROOT_ANGLE + self.root_angle.to_radians() - theta - inflow;
        let loss = self.tip_loss_exponential * (-(1.0 - xi) / 0.12).exp()
            + self.tip_loss_cutoff * (((xi - 0.7) / 0.3).max(0.0)).powi(2);
        let factor = (1.0 + self.coefficient_scale)
            * (1.0 - loss)
            * (1.0 + self.lift_gain * theta)
            * (1.0 - self.stall * (alpha - 0.6).max(0.0))
            * (1.0 + self.pressure_centre * (alpha - 0.7))
            * (1.0 + self.reynolds * (speed / 10.0).max(1e-3).ln());
        let load = 0.6 * speed * speed * c * c * 0.25 * 1.8 * self.ln_cn.exp() * alpha.sin() * factor;
        let rates = f / 25.0;
        load - self.centrifugal * 1e-6 * omega.powi(2) * xi * theta - self.film_tension * 0.01 * theta
            + self.gravity * 2e-3
            + self.inertia * 2e-3 * rates * rates * phi * c / 0.02
            + self.rotational_damping * 2e-3 * rates * phi * (c / 0.02).powi(3) * xi
    }
}

/// Places and strengths of damage; places that move stand behind all other values.
fn damages(values: &[f64]) -> Vec<(f64, f64)> {
    let strengths = EFFECTS.iter().zip(&values[NUISANCES.len()..]);
    let known = strengths.filter_map(|(effect, value)| Some((effect.place?, *value)));
    let mut places = values[NUISANCES.len() + EFFECTS.len()..].iter();
    known
        .map(|(place, value)| (places.next().copied().unwrap_or(place), value))
        .collect()
}

fn unknowns() -> Vec<Unknown> {
    let nuisances = NUISANCES.iter().map(|&(name, unit, sigma)| Unknown {
        name: name.into(),
        unit: unit.into(),
        kind: if name.starts_with("camera") {
            UnknownKind::Ruler
        } else {
            UnknownKind::Input
        },
        mean: 0.0,
        sigma,
        range: [-6.0 * sigma, 6.0 * sigma],
    });
    let effects = EFFECTS.iter().map(|effect| Unknown {
        name: effect.name.into(),
        unit: effect.unit.into(),
        kind: UnknownKind::Effect {
            effect: effect.name.into(),
            family: effect.family.into(),
            scale: effect.scale,
            plausible: [if effect.one_sided { 0.0 } else { -effect.scale }, effect.scale],
            one_sided: effect.one_sided,
            has_switch: false,
            all_or_none: false,
            own_error: 0.05,
        },
        mean: 0.0,
        sigma: 1.5 * effect.scale,
        range: if effect.one_sided {
            [0.0, 6.0 * effect.scale]
        } else {
            [-6.0 * effect.scale, 6.0 * effect.scale]
        },
    });
    nuisances.chain(effects).collect()
}

impl Forward for Toy {
    fn unknowns(&self) -> &[Unknown] {
        &self.unknowns
    }
    fn observables(&self) -> &[Observable] {
        &self.observables
    }
    fn conditions(&self) -> &[Condition] {
        &self.conditions
    }
    fn predict(&self, at: &[f64]) -> Result<DVector<f64>, StudyError> {
        Ok(self.derivatives(at, &[])?.value)
    }
    fn linearize(&self, at: &[f64], wanted: &dyn Fn(&Unknown) -> bool) -> Result<Linear, StudyError> {
        let columns: Vec<usize> = (0..self.unknowns.len())
            .filter(|&i| wanted(&self.unknowns[i]))
            .collect();
        self.derivatives(at, &columns)
    }
    fn moment_response(&self, at: &[f64], stations: usize) -> Result<DMatrix<f64>, StudyError> {
        let here = At::new(at);
        let none = vec![0.0; CELLS + 1];
        let mut response = DMatrix::zeros(self.observables.len(), stations);
        for condition in 0..self.conditions.len() {
            let theta = self.solve(condition, &here)?;
            let tangent = self.tangent(condition, &here, &theta, &none);
            let base = self.residual(condition, &here, &theta, &none);
            for j in 0..stations {
                let hat: Vec<f64> = (0..=CELLS)
                    .map(|i| {
                        let place = i as f64 / CELLS as f64 * (stations - 1) as f64;
                        (1.0 - (place - j as f64).abs()).max(0.0)
                    })
                    .collect();
                let pushed = self.residual(condition, &here, &theta, &hat);
                let push = DVector::from_iterator(CELLS + 1, pushed.iter().zip(&base).map(|(p, b)| p - b));
                let answer = banded(&tangent, &push);
                for row in self.rows(condition) {
                    let moved: Vec<f64> = theta
                        .iter()
                        .zip(answer.iter())
                        .map(|(t, a)| t - 1e-6 * a)
                        .collect();
                    response[(row, j)] =
                        (self.read(row, &here, &moved) - self.read(row, &here, &theta)) / 1e-6;
                }
            }
        }
        Ok(response)
    }
}
