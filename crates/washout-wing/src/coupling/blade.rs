//! The air on blade elements of given angle and speed, effects included: for a lift model that knows no deformed shape.

use super::air::{ActingOnStrip, lifting_lines};
use super::error::CouplingError;
use super::finite::{OF_DESIGN, with_effect};
use crate::aero::{AeroError, AirLaw, Flow, LiftingLine, SectionAir};
use crate::effects::{Bound, Dual, Motion, Need, Seam, StripMotion, StripPlace, bind};
use crate::geometry::Planform;
use crate::input::design::Design;
use nalgebra::Vector3;

/// The air of a design on blade elements: its laws, its effects at the seam of the air, and the mass of the moved air
/// where the effect `added-mass` is on.
#[derive(Debug, Clone)]
pub struct BladeAir {
    law: AirLaw,
    /// The effects' design; none without effects.
    design: Option<Box<Design>>,
    effects: Vec<Bound>,
    flow: Option<Flow>,
    tip_m: f64,
    mean_chord_m: f64,
    lifting_lines: Option<[LiftingLine; 2]>,
    moved_air: f64,
    wants_motion: bool,
}

/// A blade element at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BladeSection {
    /// Span position, m.
    pub r_m: f64,
    /// Chord, m.
    pub chord_m: f64,
    /// Angle between chord and stream, rad.
    pub alpha_rad: f64,
    /// Speed of the stream, m/s.
    pub speed_m_s: f64,
    /// Stroke phase, rad; 0 is mid-stroke.
    pub phase_rad: f64,
    /// Rate of the twist, rad/s, positive while it washes out more.
    pub twist_rate_rad_s: f64,
    /// Rate of the stream's component across the chord, m/s².
    pub normal_acceleration_m_s2: f64,
    /// Drag torque of the wing at mid-stroke over that of the untwisted wing.
    pub drag_ratio: f64,
}

impl BladeAir {
    /// The air of a design with its effects.
    ///
    /// # Errors
    /// If its laws or effects cannot be set up.
    pub fn new(
        design: &Design,
        planform: &Planform,
        air_table: Option<&[[f64; 3]]>,
    ) -> Result<Self, CouplingError> {
        let bound = bind(design)?;
        let moved_air = bound
            .iter()
            .find(|bound| bound.effect.card().name == "added-mass")
            .map_or(0.0, |bound| bound.values.strength());
        let effects: Vec<Bound> = bound
            .into_iter()
            .filter(|bound| bound.effect.card().seam == Seam::Air)
            .filter(|bound| !bound.effect.is_of_picture() && !bound.effect.is_of_moment())
            .collect();
        let moves = |bound: &Bound| bound.effect.card().needs.contains(&Need::Motion);
        let flow = Flow::from_design(design);
        Ok(BladeAir {
            lifting_lines: lifting_lines(
                planform.tip_m(),
                |r_m| planform.chord_m(r_m),
                flow.as_ref(),
                &effects,
            ),
            law: AirLaw::from_design(design, air_table)?,
            design: (!effects.is_empty() || moved_air != 0.0).then(|| Box::new(design.clone())),
            wants_motion: effects.iter().any(moves),
            effects,
            flow,
            tip_m: planform.tip_m(),
            mean_chord_m: planform.area_m2() / planform.tip_m(),
            moved_air,
        })
    }

    /// The laws without effects.
    pub fn law(&self) -> &AirLaw {
        &self.law
    }

    /// The laws, if nothing acts besides: forces then hang on angle and speed alone, by the square of the speed.
    pub fn plain(&self) -> Option<&AirLaw> {
        self.design.is_none().then_some(&self.law)
    }

    /// Whether an effect acts by the rates of the motion, so that a section needs them.
    pub fn wants_motion(&self) -> bool {
        self.wants_motion || self.moved_air != 0.0
    }

    /// Lift across the stream and drag along it, N/m.
    ///
    /// # Errors
    /// [`AeroError::OutsideTable`] for an angle that a table of coefficients does not cover; [`AeroError::NotFinite`] for a force
    /// that is none.
    pub fn force(&self, section: &BladeSection) -> Result<[f64; 2], AeroError> {
        let force_n_per_m = self.force_with(section, self.effects.len())?;
        if force_n_per_m.iter().all(|part| part.is_finite()) {
            return Ok(force_n_per_m);
        }
        let is_finite = |force: [f64; 2]| force.iter().all(|part| part.is_finite());
        let mut names = self.effects.iter().enumerate();
        let culprit = names.find(|(place, _)| !self.force_with(section, place + 1).is_ok_and(is_finite));
        Err(AeroError::NotFinite {
            force_n_per_m,
            alpha_deg: section.alpha_rad.to_degrees(),
            speed_m_s: section.speed_m_s,
            cure: match culprit {
                Some((_, bound)) => with_effect(bound.effect.card().name),
                None => OF_DESIGN.to_string(),
            },
        })
    }

    /// The same with the first `count` of the effects alone, whether it is finite or not.
    fn force_with(&self, section: &BladeSection, count: usize) -> Result<[f64; 2], AeroError> {
        let BladeSection {
            alpha_rad,
            speed_m_s,
            chord_m,
            ..
        } = *section;
        self.law.check(alpha_rad)?;
        let half = 0.5 * self.law.density_kg_m3 * chord_m;
        let Some(design) = &self.design else {
            let (cl, cd) = self.law.coefficients.lift_and_drag(alpha_rad);
            let load = half * speed_m_s * speed_m_s;
            return Ok([load * cl, load * cd]);
        };
        let flow = self.flow.map(|flow| at_phase(flow, section.phase_rad));
        let motion = self.wants_motion.then(|| still(section));
        let acting = ActingOnStrip {
            effects: &self.effects[..count],
            place: StripPlace {
                design,
                flow: flow.as_ref(),
                law: &self.law,
                r_m: section.r_m,
                tip_m: self.tip_m,
                chord_m,
                mean_chord_m: self.mean_chord_m,
                density_kg_m3: self.law.density_kg_m3,
                root_angle_rad: flow.map_or(0.0, |flow| flow.root_angle_rad()),
                motion: motion.as_ref(),
                lifting_lines: self.lifting_lines.as_ref(),
            },
        };
        let mut air = SectionAir {
            alpha: Dual::from(alpha_rad),
            speed_squared: Dual::from(speed_m_s * speed_m_s),
            normal: Vector3::new(0.0, 0.0, 1.0).map(Dual::from_re),
            chord: Vector3::new(0.0, 1.0, 0.0).map(Dual::from_re),
        };
        let now = self.law.section(&mut air, &acting);
        let load = half * air.speed_squared.re;
        // lift and drag of the section stand on the stream that the effects left
        let (sin, cos) = (air.alpha.re - alpha_rad).sin_cos();
        let (lift, drag) = (load * now.cl.re, load * now.cd.re);
        let moved = std::f64::consts::FRAC_PI_4 * self.law.density_kg_m3 * chord_m * chord_m;
        let normal = now.normal_n_per_m.re + self.moved_air * moved * section.normal_acceleration_m_s2;
        let (sin_alpha, cos_alpha) = alpha_rad.sin_cos();
        Ok([
            lift * cos + drag * sin + normal * cos_alpha,
            drag * cos - lift * sin + normal * sin_alpha,
        ])
    }
}

fn at_phase(flow: Flow, phase: f64) -> Flow {
    match flow {
        Flow::Flapping {
            frequency_hz,
            half_amplitude_rad,
            stop_angle_rad,
            root_offset_m,
            ..
        } => Flow::Flapping {
            frequency_hz,
            half_amplitude_rad,
            stop_angle_rad,
            root_offset_m,
            phase_rad: phase,
        },
        steady => steady,
    }
}

/// The motion as far as one blade element shows it.
fn still(section: &BladeSection) -> Motion {
    Motion {
        inertia: Vec::new(),
        moved_air: Vec::new(),
        moved_air_of_stroke: Vec::new(),
        strips: vec![StripMotion {
            r_m: section.r_m,
            twist_rate_rad_s: section.twist_rate_rad_s,
            twist_acceleration_rad_s2: 0.0,
        }],
        drag_ratio: section.drag_ratio,
    }
}
