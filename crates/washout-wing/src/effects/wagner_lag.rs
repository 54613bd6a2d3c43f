//! Lift that builds up with the way travelled since the stroke turned round.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{Flow, SectionAir, SectionCoefficients};

/// See the module.
#[derive(Debug)]
pub struct WagnerLag;

const CARD: Card = Card {
    name: "wagner-lag",
    family: "unsteady",
    summary: "After each reversal the circulation builds up with the way that a section has travelled, so that the load falls short, most near the base and on wide chords.",
    formula: "C_N' = C_N (1 − s (1 − φ(x))), φ(x) = 1 − 0.165 exp(−0.0455 x) − 0.335 exp(−0.3 x), x = 2 Φ (1 + sin phase) r'/c half-chords since the reversal, r' = r + r₀; \
              C_N = C_L cos α + C_D sin α, the force along the chord stays",
    source: "Wagner 1925, Z. angew. Math. Mech. 5, 17, in the form of R. T. Jones 1940, NACA Report 681: half at once, 0.82 after 6 half-chords, 0.90 \
             after 12.5; at mid-stroke x = 2 Φ r'/c",
    when_right: "attached flow: small angles, and film that bulges. Three amplitudes at one tip speed f Φ show it: the twist grows with the \
                 amplitude, where quasi-steady air leaves it alone; and it takes more of the load inboard, where the way is short",
    gets_wrong: "plates at 30 to 60 deg, on which the vortex over the leading edge forms within two chords and hides it (Dickinson & Götz 1993; Sane 2003): a \
                 strength near 0 is right there; what is left of the wake of the stroke before; the growth of the speed over the stroke, as φ is \
                 that of a start at full speed",
    case: "lift_after_the_reversal_is_that_of_wagners_function",
    seam: Seam::Air,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "share of Wagner's lag: 1 is all of it",
        default: 0.0,
        range: [-1.0, 2.0],
        plausible: [0.0, 1.0],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Flapping],
    has_switch: false,
};

impl Effect for WagnerLag {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn depends_on_stroke(&self) -> bool {
        true
    }

    fn coefficients(
        &self,
        values: &Values,
        place: &StripPlace,
        air: &SectionAir<Dual>,
        now: &mut SectionCoefficients<Dual>,
    ) {
        let Some(Flow::Flapping {
            half_amplitude_rad,
            root_offset_m,
            phase_rad,
            ..
        }) = place.flow
        else {
            return;
        };
        if place.chord_m > 0.0 {
            // the frame of the other half-stroke mirrors the first
            let phase_rad = phase_rad - (phase_rad / std::f64::consts::PI).round() * std::f64::consts::PI;
            let way_m = half_amplitude_rad * (1.0 + phase_rad.sin()) * (place.r_m + root_offset_m);
            let missing = 1.0 - built_up(2.0 * way_m / place.chord_m);
            now.lose_normal_force(air.alpha, values.strength() * missing);
        }
    }
}

/// Wagner's function: the share of the circulation after so many half-chords.
fn built_up(half_chords: f64) -> f64 {
    1.0 - 0.165 * (-0.0455 * half_chords).exp() - 0.335 * (-0.3 * half_chords).exp()
}

#[cfg(test)]
mod tests {
    use super::built_up;

    /// Values of Wagner's integral, Fung 1955, An Introduction to the Theory of Aeroelasticity, §6.7.
    #[test]
    fn half_of_the_circulation_is_there_at_once_and_nine_tenths_after_twelve_half_chords() {
        for (half_chords, share) in [(0.0, 0.5), (6.0, 0.82), (12.5, 0.90), (1e3, 1.0)] {
            let found = built_up(half_chords);
            assert!((found - share).abs() < 0.005, "{half_chords}: {found}");
        }
    }
}
