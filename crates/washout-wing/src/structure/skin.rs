//! A skin around a beam: helps it to bend out of the wing's plane, until it gives way.
//!
//! It stands beside the section and follows its bending κ: moment D [k κ + (1 − k) κ₀ tanh(κ/κ₀)]. Far below κ₀ that is D κ; far
//! above, a tangent stiffness of k D is left. The change is smooth because the fibres of a skin lie at different heights and
//! do not give way at once.

/// Stiffness of a skin and where it gives way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Skin {
    /// Flapwise bending stiffness D of the unbent skin, N·m².
    pub flap_n_m2: f64,
    /// Bending κ₀ at which it gives way, 1/m.
    pub gives_way_per_m: f64,
    /// Share k of the stiffness that it keeps beyond.
    pub kept: f64,
}

impl Skin {
    /// Energy per length (J/m), moment (N·m) and tangent stiffness (N·m²) at a bending, 1/m.
    pub fn response(&self, bending_per_m: f64) -> [f64; 3] {
        let (given, k) = (1.0 - self.kept, bending_per_m);
        let x = k / self.gives_way_per_m;
        let tanh = x.tanh();
        // ln cosh without overflow
        let ln_cosh = x.abs() + (-2.0 * x.abs()).exp().ln_1p() - std::f64::consts::LN_2;
        let square = self.gives_way_per_m * self.gives_way_per_m;
        [
            self.flap_n_m2 * (0.5 * self.kept * k * k + given * square * ln_cosh),
            self.flap_n_m2 * (self.kept * k + given * self.gives_way_per_m * tanh),
            self.flap_n_m2 * (self.kept + given * (1.0 - tanh * tanh)),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moment_and_tangent_are_the_slopes_of_energy_and_moment() {
        let skin = Skin {
            flap_n_m2: 0.7,
            gives_way_per_m: 1.3,
            kept: 0.2,
        };
        for k in [-40.0, -1.5, -0.1, 0.0, 0.4, 3.0] {
            let h = 1e-5;
            let [low, high] = [skin.response(k - h), skin.response(k + h)];
            let [_, moment, tangent] = skin.response(k);
            let slope = |i: usize| (high[i] - low[i]) / (2.0 * h);
            assert!((slope(0) - moment).abs() < 1e-8 * (1.0 + moment.abs()), "{k}");
            assert!((slope(1) - tangent).abs() < 1e-8, "{k}");
        }
    }
}
