//! The periodic motion of a flapping wing over its stroke: modes about the loaded shape, driven off the shape that
//! would stand still.
//!
//! u(τ) = standing path + Σ φ x(τ). The standing path has the coupled shape of mid-stroke and its exact rate with the
//! dynamic pressure, so that without inertia it is the whole answer. Inertia of the path, of the sweep and of the flips
//! drives the modes (wing and moved air), and the air damps both; it damps and stiffens the modes, linear about mid-stroke.
//!
//! Idealised: the rate at which the rod flips between its stops is a raised cosine; motion across the wing changes sign with the
//! half-stroke; stiffness is that of the loaded shape all the way, also while the film goes slack about the reversal.

use nalgebra::{DMatrix, DVector};

use super::air_resistance::AirResistance;
use super::error::CouplingError;
use super::fields::Fields;
use super::harmonic_balance::{Harmonics, Oscillators, StrokeWork};
use super::mid_stroke::at_mid_stroke;
use super::solution::Solution;
use super::strip_path::{StripPath, strip_paths};
use super::stroke::{Stroke, standing_path};
use super::wing::Wing;
use super::{Care, Near, solve_wing};
use crate::effects::bind;
use crate::input::design::Design;
use crate::mesh::Mesh;
use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Loads, Mode, Vibration, lowest_modes};

/// How the periodic motion is computed.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicSettings {
    /// Odd harmonics that are balanced.
    pub orders: Vec<usize>,
    /// Modes.
    pub modes: usize,
    /// Damping of the structure over the critical one, in every mode.
    pub damping_ratio: f64,
    /// Share of the stroke that each flip takes.
    pub flip_share: f64,
    /// Share of the air that moves with the wing: 1 is a cylinder on the chord.
    pub moved_air: f64,
    /// Share of the air's damping: 1 is that of the quasi-steady law.
    pub air_damping: f64,
}

impl Default for PeriodicSettings {
    fn default() -> Self {
        PeriodicSettings {
            orders: vec![1, 3, 5, 7, 9, 11, 13],
            modes: 8,
            damping_ratio: 0.02,
            flip_share: 0.2,
            moved_air: 1.0,
            air_damping: 1.0,
        }
    }
}

impl PeriodicSettings {
    /// With the numbers that an effect of a design states.
    ///
    /// # Errors
    /// If its effects are not what their cards ask for.
    pub fn of_design(design: &Design) -> Result<Self, CouplingError> {
        let stated = bind(design)?
            .iter()
            .find_map(|bound| bound.effect.motion(&bound.values));
        let plain = PeriodicSettings::default();
        Ok(stated.map_or(plain.clone(), |stated| PeriodicSettings {
            damping_ratio: stated.damping_ratio,
            flip_share: stated.flip_share,
            ..plain
        }))
    }
}

/// The motion over a stroke, in the rod's frame at the stop of the first half-stroke (phases −π/2 to π/2).
#[derive(Debug, Clone)]
pub struct Periodic {
    /// How it was computed.
    pub settings: PeriodicSettings,
    /// How the rod is driven.
    pub stroke: Stroke,
    /// The modes about the loaded shape at mid-stroke.
    pub modes: Vec<Mode>,
    /// Their amplitudes off the standing path.
    pub motion: Harmonics,
    /// Work over one stroke, J.
    pub work: StrokeWork,
    /// Mid-stroke as it would stand still.
    pub still: Solution,
    /// The wing of [`Periodic::still`].
    pub wing: Wing,
    /// Where and how each strip turns.
    strips: Vec<StripPath>,
    pub(super) fields: Fields,
}

/// The periodic motion of a flapping design on a mesh. Effects that are themselves made from it are left out.
///
/// # Errors
/// If the design does not flap, has no equilibrium at mid-stroke, or none that is stable.
pub fn periodic(
    design: &Design,
    mesh: &Mesh,
    air_table: Option<&[[f64; 3]]>,
    settings: &PeriodicSettings,
    progress: &Progress,
) -> Result<Periodic, CouplingError> {
    periodic_near(design, mesh, air_table, settings, None, progress)
}

/// The same from a solution of a design nearby.
///
/// # Errors
/// As [`periodic`].
pub fn periodic_near(
    design: &Design,
    mesh: &Mesh,
    air_table: Option<&[[f64; 3]]>,
    settings: &PeriodicSettings,
    nearby: Option<&Solution>,
    progress: &Progress,
) -> Result<Periodic, CouplingError> {
    let design = at_mid_stroke(design)?;
    let wing = Wing::new(&design, mesh, air_table)?;
    let stroke = wing
        .air
        .as_ref()
        .and_then(|air| Stroke::of(&air.flow, settings.flip_share));
    let stroke = stroke.ok_or(CouplingError::NoPeriodic {
        reason: "the wing does not flap",
    })?;
    let near = nearby.map(|solution| Near {
        solution,
        step: None,
        care: Care::Full,
    });
    let (still, _) = solve_wing(&design, &wing, mesh, near.as_ref(), progress)?;
    let (about, loads) = if wing.linear {
        (still.rest.clone(), Loads::none(mesh.nodes.len()))
    } else {
        (still.state.clone(), wing.loads_on(&still.state)?)
    };
    let air = moved_air(&wing, settings.moved_air);
    let mut equilibrium = wing.equilibrium()?;
    let modes = lowest_modes(&mut equilibrium, &about, &loads, &air, settings.modes, progress)?;
    let modes = stable(modes)?;
    let fields = Fields::new(&wing, &mut equilibrium, &still, &about, &air, &modes)?;
    let air_resistance = AirResistance::new(&wing, &still.state, &modes, settings.air_damping)?;
    let system = oscillators(&wing, &still.state, &stroke, settings, &modes, &air_resistance)?;
    let force = fields.driving(&stroke, &system, &air_resistance);
    let motion = system
        .balance(&settings.orders, &force)
        .ok_or(CouplingError::NoPeriodic {
            reason: "a mode without damping is driven at its own frequency",
        })?;
    let work = system.work(&motion, &force);
    Ok(Periodic {
        strips: strip_paths(&wing, &still, &fields),
        settings: settings.clone(),
        stroke,
        modes,
        motion,
        work,
        still,
        wing,
        fields,
    })
}

/// The modes of a wing that can swing.
fn stable(vibration: Vibration) -> Result<Vec<Mode>, CouplingError> {
    let reason = match vibration {
        Vibration::Stable(modes) if !modes.is_empty() => return Ok(modes),
        Vibration::Stable(_) => "the wing has no mass; give its materials a density",
        Vibration::Unstable { .. } => "the loaded shape is not stable",
    };
    Err(CouplingError::NoPeriodic { reason })
}

impl Periodic {
    /// Twist at a span position (m) and a phase (rad), and its first and second derivatives by time: rad, rad/s, rad/s²,
    /// in the rod's frame, that is positive for washout in the first half-stroke; linear between strips. `None` off the film.
    pub fn twist(&self, r_m: f64, phase: f64) -> Option<[f64; 3]> {
        let after = self.strips.partition_point(|strip| strip.r_m < r_m).max(1);
        let (inner, outer) = (
            self.strips.get(after - 1)?,
            self.strips.get(after).or(self.strips.last())?,
        );
        let share = if outer.r_m > inner.r_m {
            (r_m - inner.r_m) / (outer.r_m - inner.r_m)
        } else {
            0.0
        };
        let (inner, outer) = (self.strip_twist(inner, phase), self.strip_twist(outer, phase));
        let share = share.clamp(0.0, 1.0);
        Some(std::array::from_fn(|k| inner[k] + share * (outer[k] - inner[k])))
    }

    /// The twist that would stand still at a phase, rad; as [`Periodic::twist`].
    pub fn standing_twist(&self, r_m: f64, phase: f64) -> Option<f64> {
        let near = self
            .strips
            .iter()
            .min_by(|a, b| (a.r_m - r_m).abs().total_cmp(&(b.r_m - r_m).abs()))?;
        let [first, second] = standing_path(phase);
        Some(near.standing[0] * first[0] + near.standing[1] * second[0])
    }

    /// Span positions of the strips, m.
    pub fn stations_m(&self) -> Vec<f64> {
        self.strips.iter().map(|strip| strip.r_m).collect()
    }

    fn strip_twist(&self, strip: &StripPath, phase: f64) -> [f64; 3] {
        let [first, second] = standing_path(phase);
        let moved = [
            self.motion.value(phase),
            self.motion.slope(phase),
            self.motion.curve(phase),
        ];
        let rate = self.stroke.rate_rad_s;
        std::array::from_fn(|k| {
            let along = strip.standing[0] * first[k] + strip.standing[1] * second[k];
            (along + strip.by_mode.dot(&moved[k])) * rate.powi(k as i32)
        })
    }

    /// Acceleration of the deformation by freedom at a phase, m/s² and rad/s².
    pub(super) fn acceleration(&self, phase: f64) -> Vec<f64> {
        let [first, second] = standing_path(phase);
        let square = self.stroke.rate_rad_s.powi(2);
        let curve = self.motion.curve(phase);
        let mut sum = vec![0.0; self.fields.pattern.len()];
        let mut add = |field: &[f64], weight: f64| {
            sum.iter_mut()
                .zip(field)
                .for_each(|(sum, x)| *sum += square * weight * x);
        };
        add(&self.fields.standing[0], first[2]);
        add(&self.fields.standing[1], second[2]);
        for (mode, weight) in self.fields.modes.iter().zip(curve.iter()) {
            add(mode, *weight);
        }
        sum
    }
}

/// Mass of the air that moves with each shell along its normal, kg/m²: ρ π/4 c, spread evenly over the chord.
fn moved_air(wing: &Wing, share: f64) -> Vec<f64> {
    let density = share * wing.air.as_ref().map_or(0.0, |air| air.law.density_kg_m3);
    let middle = |corners: [usize; 3]| corners.iter().map(|&n| wing.model.nodes[n].x).sum::<f64>() / 3.0;
    let shells = wing.model.shells.iter();
    shells
        .map(|shell| density * std::f64::consts::FRAC_PI_4 * wing.strips.chord_m(middle(shell.nodes)))
        .collect()
}

/// The equations of the modes: air linear about mid-stroke.
fn oscillators(
    wing: &Wing,
    state: &State,
    stroke: &Stroke,
    settings: &PeriodicSettings,
    modes: &[Mode],
    air_resistance: &AirResistance,
) -> Result<Oscillators, CouplingError> {
    let count = modes.len();
    let angular = |mode: &Mode| std::f64::consts::TAU * mode.frequency_hz;
    let shapes = wing.strips.shapes(state);
    let air = wing.strip_air(&shapes, true)?;
    let mut air_stiffness = DMatrix::zeros(count, count);
    for (column, mode) in modes.iter().enumerate() {
        let change = wing.air_force_change(&air, &wing.strips.shape_changes(&mode.displacement));
        for (row, other) in modes.iter().enumerate() {
            let work: f64 = other
                .displacement
                .iter()
                .zip(&change)
                .map(|(u, f)| u.dot(f))
                .sum();
            air_stiffness[(row, column)] = -work;
        }
    }
    let mut air_damping = DMatrix::zeros(count, count);
    for (column, mode) in modes.iter().enumerate() {
        air_damping.set_column(column, &air_resistance.on_modes(&mode.displacement));
    }
    let own = modes
        .iter()
        .map(|mode| 2.0 * settings.damping_ratio * angular(mode));
    Ok(Oscillators {
        rate_rad_s: stroke.rate_rad_s,
        stiffness: DVector::from_iterator(count, modes.iter().map(|mode| angular(mode).powi(2))),
        damping: DMatrix::from_diagonal(&DVector::from_iterator(count, own)),
        air_damping,
        air_stiffness,
    })
}
