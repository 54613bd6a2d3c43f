//! The air that strips meet: its laws, its flow, and the effects that act on both.

use std::sync::Arc;

use super::strips::{Strip, Strips};
use crate::aero::{AeroError, AirLaw, Flow, LiftingLine, SectionAir, SectionChange, SectionCoefficients};
use crate::effects::{self, Bound, Dual, EffectError, Motion, Seam, StripPlace};
use crate::input::design::Design;

/// The air that strips meet.
#[derive(Debug, Clone)]
pub struct Air {
    /// Density and laws.
    pub law: AirLaw,
    /// The flow; a bench has still air.
    pub flow: Flow,
    /// Share of large turns: 0 takes small turns about the wing at rest, 1 the turned strip.
    pub large_share: f64,
    acting: Option<Acting>,
}

/// Effects at the seam of the air, and what they need to know.
#[derive(Debug, Clone)]
struct Acting {
    effects: Vec<Bound>,
    motion: Option<Arc<Motion>>,
    design: Design,
    flow: Option<Flow>,
    tip_m: f64,
    mean_chord_m: f64,
    lifting_lines: Option<[LiftingLine; 2]>,
}

impl Air {
    /// The air of a design; none without flow, unless an effect acts on the strips all the same.
    ///
    /// # Errors
    /// If its laws cannot be set up.
    pub fn new(
        design: &Design,
        strips: &Strips,
        effects: &[Bound],
        large_share: f64,
        air_table: Option<&[[f64; 3]]>,
    ) -> Result<Option<Air>, AeroError> {
        let flow = Flow::from_design(design);
        let at_air = |bound: &&Bound| bound.effect.card().seam == Seam::Air;
        let effects: Vec<Bound> = effects.iter().filter(at_air).cloned().collect();
        if flow.is_none() && effects.is_empty() {
            return Ok(None);
        }
        let still = Flow::Steady {
            speed_m_s: 0.0,
            root_angle_rad: 0.0,
            sweep_rad: 0.0,
        };
        let span = strips.strips.iter();
        let (width, area) = span.fold((0.0, 0.0), |(width, area), strip| {
            (width + strip.width_m, area + strip.width_m * strip.chord_m)
        });
        let chord_m = |r_m: f64| strips.chord_m(r_m);
        let acting = Acting {
            lifting_lines: lifting_lines(strips.tip_m(), chord_m, flow.as_ref(), &effects),
            effects,
            motion: None,
            design: design.clone(),
            flow,
            tip_m: strips.tip_m(),
            mean_chord_m: if width > 0.0 { area / width } else { 0.0 },
        };
        Ok(Some(Air {
            law: AirLaw::from_design(design, air_table)?,
            flow: flow.unwrap_or(still),
            large_share,
            acting: (!acting.effects.is_empty()).then_some(acting),
        }))
    }

    /// The same with what the stroke does at the phase of the design.
    #[must_use]
    pub fn with_motion(mut self, motion: Option<Arc<Motion>>) -> Self {
        if let Some(acting) = &mut self.acting {
            acting.motion = motion;
        }
        self
    }

    /// Names of the effects that act on strips, in the order in which they act.
    pub(super) fn effects(&self) -> Vec<String> {
        let bound = self.acting.iter().flat_map(|acting| &acting.effects);
        bound.map(|bound| bound.effect.card().name.to_string()).collect()
    }

    /// The same with the first `count` of its effects alone.
    pub(super) fn with_first(&self, count: usize) -> Air {
        let mut fewer = self.clone();
        if let Some(acting) = &mut fewer.acting {
            acting.effects.truncate(count);
        }
        fewer
    }

    /// Refuses a formula of the user's own that is not finite on a strip.
    ///
    /// # Errors
    /// With the strip and the angle at which it is not.
    pub(super) fn try_out(&self, strips: &Strips) -> Result<(), EffectError> {
        for strip in &strips.strips {
            let Some(acting) = self.acting(strip) else {
                return Ok(());
            };
            for bound in acting.effects {
                if let effects::Acting::Own(own) = &bound.effect {
                    own.try_on_strip(&acting.place)?;
                }
            }
        }
        Ok(())
    }

    /// The effects at a strip; none if there are none.
    pub(super) fn acting<'a>(&'a self, strip: &Strip) -> Option<ActingOnStrip<'a>> {
        let acting = self.acting.as_ref()?;
        Some(ActingOnStrip {
            effects: &acting.effects,
            place: StripPlace {
                design: &acting.design,
                flow: acting.flow.as_ref(),
                law: &self.law,
                r_m: strip.r_m,
                tip_m: acting.tip_m,
                chord_m: strip.chord_m,
                mean_chord_m: acting.mean_chord_m,
                density_kg_m3: acting.flow.map_or(0.0, |_| self.law.density_kg_m3),
                root_angle_rad: acting.flow.map_or(0.0, |flow| flow.root_angle_rad()),
                motion: acting.motion.as_deref(),
                lifting_lines: acting.lifting_lines.as_ref(),
            },
        })
    }
}

/// Lifting lines of a wing of this length and chord (m), its root on a wall and free, if it stands in a steady stream with effects that
/// may ask for them.
pub(super) fn lifting_lines(
    length_m: f64,
    chord_m: impl Fn(f64) -> f64,
    flow: Option<&Flow>,
    effects: &[Bound],
) -> Option<[LiftingLine; 2]> {
    if effects.is_empty() || !matches!(flow, Some(Flow::Steady { .. })) {
        return None;
    }
    let line = |has_wall| LiftingLine::new(length_m, &chord_m, has_wall);
    Some([line(true)?, line(false)?])
}

/// The effects that act on one strip or blade element.
#[derive(Debug)]
pub(super) struct ActingOnStrip<'a> {
    pub(super) effects: &'a [Bound],
    pub(super) place: StripPlace<'a>,
}

impl SectionChange<Dual> for ActingOnStrip<'_> {
    fn flow(&self, air: &mut SectionAir<Dual>) {
        for bound in self.effects {
            bound.effect.flow(&bound.values, &self.place, air);
        }
    }

    fn coefficients(&self, air: &SectionAir<Dual>, now: &mut SectionCoefficients<Dual>) {
        for bound in self.effects {
            bound.effect.coefficients(&bound.values, &self.place, air, now);
        }
    }
}
