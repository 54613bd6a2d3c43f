//! What an effect sees and may change at each seam.

use nalgebra::Vector3;
use num_dual::DualSVec64;

use crate::aero::{AirLaw, Flow, LiftingLine};
use crate::input::design::Design;
use crate::mesh::{BeamPart, Mesh};
use crate::structure::Model;

/// Numbers of the air's seam: with derivatives by the six numbers of a strip's shape.
pub type Dual = DualSVec64<6>;

/// The numbers of an effect, in the order of its card.
#[derive(Debug, Clone, PartialEq)]
pub struct Values(pub Vec<f64>);

impl Values {
    /// The strength.
    pub fn strength(&self) -> f64 {
        self.0[0]
    }

    /// The number at a place of the card.
    pub fn at(&self, place: usize) -> f64 {
        self.0[place]
    }
}

/// The structure of a wing, to be changed.
#[derive(Debug)]
pub struct Structure<'a> {
    /// The design.
    pub design: &'a Design,
    /// The mesh; `model.beams[i]` is `mesh.beams[i]`, `model.shells[i]` is `mesh.triangles[i]`.
    pub mesh: &'a Mesh,
    /// The structure.
    pub model: &'a mut Model,
    /// What the stroke does at the phase of the design; none unless an effect needs it.
    pub motion: Option<&'a Motion>,
}

/// A beam element, and how far its ends lie along its part, m.
pub type Element = (usize, [f64; 2]);

impl Structure<'_> {
    /// Elements of the rod, from the base to its end.
    pub fn rod_elements(&self) -> Vec<Element> {
        self.elements(|part| matches!(part, BeamPart::Rod(_)))
    }

    /// Elements of a spar, from the leading to the trailing edge; none if there is no such spar.
    pub fn spar_elements(&self, spar: usize) -> Vec<Element> {
        self.elements(|part| part == BeamPart::Spar(spar))
    }

    /// Elements of the rod between two fractions of its length, each with the share of it that lies there; none if `to` is not
    /// beyond `from`.
    pub fn rod_between(&self, from: f64, to: f64) -> Vec<(usize, f64)> {
        let rod = self.rod_elements();
        let length_m = rod.last().map_or(0.0, |(_, [_, end_m])| *end_m);
        let (inner_m, outer_m) = (from * length_m, to * length_m);
        let share = |(beam, [from_m, to_m]): Element| {
            let covered_m = to_m.min(outer_m) - from_m.max(inner_m);
            (covered_m > 0.0).then(|| (beam, covered_m / (to_m - from_m)))
        };
        rod.into_iter().filter_map(share).collect()
    }

    fn elements(&self, belongs: impl Fn(BeamPart) -> bool) -> Vec<Element> {
        let mut along_m = 0.0;
        let of_part = self.mesh.beams.iter().enumerate();
        of_part
            .filter(|(_, beam)| belongs(beam.part))
            .map(|(index, _)| {
                let from_m = along_m;
                along_m += self.mesh.beam_length_m(index);
                (index, [from_m, along_m])
            })
            .collect()
    }
}

/// Where a strip stands, and in which flow.
#[derive(Debug, Clone, Copy)]
pub struct StripPlace<'a> {
    /// The design.
    pub design: &'a Design,
    /// The flow; none on a bench.
    pub flow: Option<&'a Flow>,
    /// Laws of the coefficients.
    pub law: &'a AirLaw,
    /// Span position, m.
    pub r_m: f64,
    /// Span position of the last strip's outer end, m.
    pub tip_m: f64,
    /// Chord at rest, m.
    pub chord_m: f64,
    /// Mean chord at rest, m.
    pub mean_chord_m: f64,
    /// Density of the air, kg/m³; 0 on a bench.
    pub density_kg_m3: f64,
    /// Angle of attack of the untwisted wing, rad; 0 on a bench.
    pub root_angle_rad: f64,
    /// What the stroke does at the phase of the design; none unless an effect needs it.
    pub motion: Option<&'a Motion>,
    /// Lifting lines of the wing, its root on a wall and free; none but in a steady stream.
    pub lifting_lines: Option<&'a [LiftingLine; 2]>,
}

/// The periodic motion of a flapping wing at the phase of its design, frozen: it comes from the wing without the effects
/// that need it. Wing frame of the half-stroke.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Inertia of the wing's own mass against its deforming, by node.
    pub inertia: Vec<NodeLoad>,
    /// The same of the air that moves with it.
    pub moved_air: Vec<NodeLoad>,
    /// The same of that air against sweep and flip of the rod.
    pub moved_air_of_stroke: Vec<NodeLoad>,
    /// How the strips turn, from base to tip.
    pub strips: Vec<StripMotion>,
    /// Drag torque about the stroke axis at mid-stroke over that of the untwisted wing.
    pub drag_ratio: f64,
}

/// Numbers of the motion over the stroke that nobody measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionNumbers {
    /// Damping of the structure over the critical one, in every mode.
    pub damping_ratio: f64,
    /// Share of the stroke that each flip takes.
    pub flip_share: f64,
}

/// Force and moment on a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeLoad {
    /// Force, N.
    pub force_n: Vector3<f64>,
    /// Moment, N·m.
    pub moment_n_m: Vector3<f64>,
}

/// How a strip turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripMotion {
    /// Span position, m.
    pub r_m: f64,
    /// Rate of the twist, rad/s.
    pub twist_rate_rad_s: f64,
    /// Its own rate, rad/s².
    pub twist_acceleration_rad_s2: f64,
}

/// How a picture of the wing is taken. All zero: a camera far away, on the axis that the design states, in a frame at the
/// stroke phase of the design.
///
/// The axis points along the flapping axis toward lift, or along the stroke the way the air runs past the wing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct View {
    /// One over the distance of the camera from where it is aimed, 1/m; positive where it stands on the side to which the axis
    /// points, negative on the other.
    pub nearness_per_m: f64,
    /// Place on the leading edge of the wing at rest at which it is aimed, m from the base.
    pub aim_m: f64,
    /// Angle by which the camera is turned about the span, rad, positive the way washout turns a chord.
    pub tilt_rad: f64,
    /// Angle about the flapping axis by which the wing has swung on from the phase of the design, rad.
    pub swing_rad: f64,
}

impl Motion {
    /// Rate of the twist at a span position, rad/s; linear between strips.
    pub fn twist_rate_rad_s(&self, r_m: f64) -> f64 {
        let after = self.strips.partition_point(|strip| strip.r_m < r_m);
        match (self.strips.get(after.wrapping_sub(1)), self.strips.get(after)) {
            (Some(inner), Some(outer)) => {
                let share = (r_m - inner.r_m) / (outer.r_m - inner.r_m);
                inner.twist_rate_rad_s + share * (outer.twist_rate_rad_s - inner.twist_rate_rad_s)
            }
            (Some(only), None) | (None, Some(only)) => only.twist_rate_rad_s,
            (None, None) => 0.0,
        }
    }
}

impl StripPlace<'_> {
    /// Rate of the twist here, rad/s; 0 where no motion is known.
    pub fn twist_rate_rad_s(&self) -> f64 {
        self.motion
            .map_or(0.0, |motion| motion.twist_rate_rad_s(self.r_m))
    }
}
