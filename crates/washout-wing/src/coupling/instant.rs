//! The wing at one phase of its periodic motion: shape, air on its strips, what its stop carries.
//!
//! All in the rod's frame of the half-stroke that the phase lies in, where washout is positive; the other half-stroke mirrors
//! it. The air meets a strip with the pitch that the rod has then, and with the strip's own velocity at ¾ of the chord.
//! Across the wing the modes are added as they are; in its plane, where displacements grow with the square of those across,
//! with the share of the load, so that the shape does not jump where the half-strokes meet.

use std::f64::consts::PI;

use nalgebra::{Rotation3, UnitQuaternion, Vector3};

use super::error::CouplingError;
use super::finite::refuse_air;
use super::periodic::Periodic;
use super::solution::{Solution, StripLoad};
use super::strip_air::StripAir;
use super::strips::{Strip, StripShape};
use super::stroke::standing_path;
use crate::aero::Flow;
use crate::structure::refuse_not_finite;
use crate::structure::state::State;

/// Phases of the means, in the middle of equal parts of a half-stroke.
const PHASES: usize = 90;

/// The wing at one phase.
#[derive(Debug, Clone)]
pub struct Instant {
    /// Phase as asked for, rad; 0 is mid-stroke.
    pub phase_rad: f64,
    /// Sweep of the rod off mid-stroke, rad, against the air of this half-stroke.
    pub sweep_rad: f64,
    /// Pitch of the rod from upright, rad; at the stop π/2 less the angle of attack.
    pub pitch_rad: f64,
    /// Whether the rod is on its way between the stops.
    pub is_flipping: bool,
    /// Shape.
    pub state: State,
    /// Air on the strips; its angles and speeds hold their own motion.
    pub strips: Vec<StripLoad>,
    /// Pressure on each triangle, Pa.
    pub pressure_pa: Vec<f64>,
    /// Nodal air forces, N.
    pub air_force_n: Vec<[f64; 3]>,
    /// Lift, drag (N) and aerodynamic power against the sweep (W) of one wing.
    pub forces: AirForces,
    /// Moment about the rod's axis at the base by which the stop holds the wing, N·m, positive as it pushes; while the rod
    /// flips, what drives it.
    pub stop_moment_n_m: f64,
    is_first_half: bool,
    root_offset_m: f64,
}

/// Forces of the air on one wing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AirForces {
    /// Across the stream of the sweep, N.
    pub lift_n: f64,
    /// Along it, N.
    pub drag_n: f64,
    /// Drag times the speed of the sweep, W.
    pub power_w: f64,
}

impl Periodic {
    /// The wing at a phase, rad.
    ///
    /// # Errors
    /// If the air's force, or what the stop carries, is not finite.
    pub fn instant(&self, phase_rad: f64) -> Result<Instant, CouplingError> {
        let halves = (phase_rad / PI).round();
        let phase = phase_rad - halves * PI;
        let wing = &self.wing;
        let [pitch_rad, turning, jerking] = self.stroke.pitch(phase);
        let rate = self.stroke.rate_rad_s;
        let state = self.shape(phase);
        let mut moving: Vec<f64> = self.velocity(phase);
        (moving.iter_mut().zip(&self.fields.pitch)).for_each(|(v, pitch)| *v += rate * turning * pitch);
        let moving = self.fields.displacement(&moving);
        let direction = Vector3::new(0.0, pitch_rad.sin(), pitch_rad.cos()) * phase.cos();
        let (air, forces) = self.air(&state, &moving, &direction)?;
        let air_force = wing.air_force(&air);
        let (sweep, pitch) = (self.stroke.sweep_acceleration(phase), rate * rate * jerking);
        let mut acceleration = self.acceleration(phase);
        for (sum, (a, b)) in acceleration
            .iter_mut()
            .zip(self.fields.sweep.iter().zip(&self.fields.pitch))
        {
            *sum += sweep * a + pitch * b;
        }
        let inertia = self.fields.inertia(&self.fields.mass[1], &acceleration);
        let mut moment = self.load_besides_n_m();
        for (node, (force, inertia)) in air_force.iter().zip(&inertia).enumerate() {
            let place = self.place(node, &state);
            moment += place.cross(&(force + inertia.force_n)).x + inertia.moment_n_m.x;
        }
        let numbers = [
            ("the moment of the stop (N·m)", moment),
            ("the lift (N)", forces.lift_n),
            ("the drag (N)", forces.drag_n),
            ("the power (W)", forces.power_w),
        ];
        let place = || format!("at stroke phase {:.1} deg", phase_rad.to_degrees());
        refuse_not_finite(place, numbers)?;
        Ok(Instant {
            phase_rad,
            sweep_rad: self.stroke.half_amplitude_rad * phase.sin(),
            pitch_rad,
            is_flipping: turning != 0.0,
            strips: wing.strip_loads(&air),
            pressure_pa: wing.pressure(&self.still.mesh, &air),
            air_force_n: air_force.into_iter().map(Into::into).collect(),
            forces,
            stop_moment_n_m: moment,
            is_first_half: halves.rem_euclid(2.0) == 0.0,
            root_offset_m: self.root_offset_m(),
            state,
        })
    }

    /// Air on each strip of a shape that moves against the stream of this direction, and the forces of it all.
    fn air(
        &self,
        state: &State,
        moving: &[Vector3<f64>],
        direction: &Vector3<f64>,
    ) -> Result<(Vec<StripAir>, AirForces), CouplingError> {
        let wing = &self.wing;
        let shapes = wing.strips.shapes(state);
        let (mut air, mut forces) = (Vec::new(), AirForces::default());
        for (strip, shape) in wing.strips.strips.iter().zip(shapes.chunks_exact(6)) {
            let Some(law) = &wing.air else { break };
            let shape = StripShape::from_column_slice(shape);
            let stream = law.flow.velocity(strip.r_m).norm() * direction;
            let own = three_quarters(strip, moving) * self.settings.air_damping;
            let met = |velocity: Vector3<f64>| {
                let found = strip.air_at(law, &velocity, &shape);
                refuse_air(strip, law, &velocity, &shape, &found)?;
                Ok::<StripAir, CouplingError>(found)
            };
            let felt = met(stream - own)?;
            forces.add(strip, &met(stream)?, &felt);
            air.push(felt);
        }
        Ok((air, forces))
    }

    /// Means of the air's forces over the stroke.
    ///
    /// # Errors
    /// As [`Periodic::instant`].
    pub fn mean_forces(&self) -> Result<AirForces, CouplingError> {
        let phase = |index: usize| PI * ((index as f64 + 0.5) / PHASES as f64 - 0.5);
        let mut mean = AirForces::default();
        for index in 0..PHASES {
            let now = self.instant(phase(index))?.forces;
            mean.lift_n += now.lift_n / PHASES as f64;
            mean.drag_n += now.drag_n / PHASES as f64;
            mean.power_w += now.power_w / PHASES as f64;
        }
        Ok(mean)
    }

    /// Shape at a phase of the first half-stroke.
    fn shape(&self, phase: f64) -> State {
        let (fields, rest) = (&self.fields, &self.still.rest);
        let path = standing_path(phase).map(|weights| weights[0]);
        let own = self.motion.value(phase);
        let mut state = rest.clone();
        for node in 0..rest.displacement.len() {
            let at = fields.pattern.freedom(node, 0);
            let part =
                |field: &[f64], from: usize| Vector3::from_column_slice(&field[at + from..at + from + 3]);
            let along = |from: usize| -> Vector3<f64> {
                (0..2).map(|k| part(&fields.standing[k], from) * path[k]).sum()
            };
            let by_mode = |from: usize| -> Vector3<f64> {
                fields
                    .modes
                    .iter()
                    .zip(own.iter())
                    .map(|(mode, x)| part(mode, from) * *x)
                    .sum()
            };
            let in_plane = Vector3::new(path[0], path[0], 1.0);
            let moved = along(0) + by_mode(0).component_mul(&in_plane);
            let turned = along(3) + by_mode(3).component_mul(&Vector3::new(1.0, 1.0, path[0]));
            state.displacement[node] += moved;
            state.rotation[node] = UnitQuaternion::from_scaled_axis(turned) * rest.rotation[node];
        }
        state
    }

    /// Velocity of the deformation by freedom, m/s and rad/s.
    fn velocity(&self, phase: f64) -> Vec<f64> {
        let (fields, rate) = (&self.fields, self.stroke.rate_rad_s);
        let path = standing_path(phase).map(|weights| rate * weights[1]);
        let slope = self.motion.slope(phase);
        let mut sum = vec![0.0; fields.pattern.len()];
        let mut add = |field: &[f64], weight: f64| {
            sum.iter_mut().zip(field).for_each(|(sum, x)| *sum += weight * x);
        };
        (0..2).for_each(|k| add(&fields.standing[k], path[k]));
        for (mode, weight) in fields.modes.iter().zip(slope.iter()) {
            add(mode, rate * weight);
        }
        sum
    }

    /// What acts about the rod besides air and inertia, N·m: the same at all phases.
    fn load_besides_n_m(&self) -> f64 {
        let air = self.still.air_force_n.iter().enumerate();
        let by_air = air.map(|(node, force)| {
            self.place(node, &self.still.state)
                .cross(&Vector3::from(*force))
                .x
        });
        -self.still.report.reaction_moment_n_m[0] - by_air.sum::<f64>()
    }

    fn place(&self, node: usize, state: &State) -> Vector3<f64> {
        let at_rest = self.wing.model.nodes[node];
        if self.wing.linear {
            at_rest
        } else {
            at_rest + state.displacement[node]
        }
    }

    fn root_offset_m(&self) -> f64 {
        match self.wing.air.as_ref().map(|air| air.flow) {
            Some(Flow::Flapping { root_offset_m, .. }) => root_offset_m,
            _ => 0.0,
        }
    }
}

impl Instant {
    /// The shape as a solution, for instruments; forces in the structure are left out, and the report is that of
    /// `still`.
    pub fn solution(&self, still: &Solution) -> Solution {
        Solution {
            state: self.state.clone(),
            strips: self.strips.clone(),
            air_force_n: self.air_force_n.clone(),
            pressure_pa: self.pressure_pa.clone(),
            beam_force: Vec::new(),
            membrane_force_n_per_m: Vec::new(),
            ..still.clone()
        }
    }

    /// Where a point of the rod's frame (m) is in space: origin on the stroke axis, x along the span at mid-stroke, y along
    /// the axis toward the trailing edge, z as the air blows in the first half-stroke.
    pub fn in_space(&self, point: &Vector3<f64>) -> Vector3<f64> {
        let pitched = Rotation3::from_axis_angle(&Vector3::x_axis(), self.pitch_rad) * point;
        let on_axis = pitched + Vector3::x() * self.root_offset_m;
        let swept = Rotation3::from_axis_angle(&Vector3::y_axis(), self.sweep_rad) * on_axis;
        let side = if self.is_first_half { 1.0 } else { -1.0 };
        Vector3::new(swept.x, swept.y, side * swept.z)
    }
}

impl Default for AirForces {
    fn default() -> Self {
        AirForces {
            lift_n: 0.0,
            drag_n: 0.0,
            power_w: 0.0,
        }
    }
}

impl AirForces {
    /// Adds a strip's force, taken apart by the stream of the sweep in its section.
    fn add(&mut self, strip: &Strip, swept: &StripAir, felt: &StripAir) {
        let (sin, cos) = swept.force.alpha.sin_cos();
        let [normal, tangential] = [felt.force.normal_n_per_m, felt.force.tangential_n_per_m];
        let drag_n = (normal * sin + tangential * cos) * strip.width_m;
        self.lift_n += (normal * cos - tangential * sin) * strip.width_m;
        self.drag_n += drag_n;
        self.power_w += drag_n * swept.force.speed;
    }
}

/// Velocity of a strip at ¾ of its chord (Pistolesi's rule).
fn three_quarters(strip: &Strip, velocity: &[Vector3<f64>]) -> Vector3<f64> {
    let moved = |point: usize| {
        let point = &strip.points[point];
        point.weights[0] * velocity[point.nodes[0]] + point.weights[1] * velocity[point.nodes[1]]
    };
    moved(0) * 0.25 + moved(strip.points.len() - 1) * 0.75
}
