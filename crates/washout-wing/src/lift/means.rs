//! Means over the stroke: of the whole wing and along the span.

/// Means over the stroke at one station of the span, per length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StationMeans {
    /// Span position from the wing base, m.
    pub r_m: f64,
    /// Weight of the station in an integral along the span, m.
    pub width_m: f64,
    /// Chord, m.
    pub chord_m: f64,
    /// Twist at mid-stroke, rad.
    pub twist_rad: f64,
    /// Mean lift, N/m.
    pub lift_n_per_m: f64,
    /// Mean drag, N/m.
    pub drag_n_per_m: f64,
    /// Mean aerodynamic power, W/m.
    pub power_w_per_m: f64,
}

/// Means over the stroke of one wing; its totals are the weighted sums of its stations.
#[derive(Debug, Clone, PartialEq)]
pub struct StrokeMeans {
    /// Largest angular speed of the stroke, 2πfΦ, rad/s.
    pub peak_rate_rad_s: f64,
    /// Mean lift, N.
    pub lift_n: f64,
    /// Mean drag (its amount: it opposes both half-strokes), N.
    pub drag_n: f64,
    /// Mean aerodynamic power, W.
    pub power_w: f64,
    /// Stations from base to tip.
    pub stations: Vec<StationMeans>,
}

impl StrokeMeans {
    /// Mean lift over mean drag; `None` without drag.
    pub fn lift_to_drag(&self) -> Option<f64> {
        (self.drag_n > 0.0).then(|| self.lift_n / self.drag_n)
    }

    /// Mean lift per mean aerodynamic power, N/W; `None` without power.
    pub fn lift_per_power_n_per_w(&self) -> Option<f64> {
        (self.power_w > 0.0).then(|| self.lift_n / self.power_w)
    }

    /// The same wing with the same twist at another largest angular speed (rad/s): forces grow with its square,
    /// power with its cube. `None` if this stroke stands still.
    pub fn at_rate(&self, peak_rate_rad_s: f64) -> Option<StrokeMeans> {
        if !(self.peak_rate_rad_s > 0.0 && peak_rate_rad_s.is_finite()) {
            return None;
        }
        let factor = peak_rate_rad_s / self.peak_rate_rad_s;
        let (force, power) = (factor.powi(2), factor.powi(2) * factor.abs());
        let stations = self.stations.iter().map(|station| StationMeans {
            lift_n_per_m: station.lift_n_per_m * force,
            drag_n_per_m: station.drag_n_per_m * force,
            power_w_per_m: station.power_w_per_m * power,
            ..*station
        });
        Some(StrokeMeans {
            peak_rate_rad_s,
            lift_n: self.lift_n * force,
            drag_n: self.drag_n * force,
            power_w: self.power_w * power,
            stations: stations.collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use crate::lift::paper;
    use crate::lift::stroke::stroke_means;
    use crate::lift::twist::TwistHistory;

    #[test]
    fn another_rate_scales_forces_by_its_square_and_power_by_its_cube() {
        let (planform, law) = (paper::planform(), paper::law());
        let twist = TwistHistory::paper_ramp(paper::twist_v2());
        let slow = stroke_means(&planform, &law, &paper::stroke(11.5), &twist).expect("means");
        let fast = stroke_means(&planform, &law, &paper::stroke(23.0), &twist).expect("means");
        let scaled = slow.at_rate(fast.peak_rate_rad_s).expect("moves");
        assert!((scaled.lift_n / fast.lift_n - 1.0).abs() < 1e-12);
        assert!((scaled.power_w / fast.power_w - 1.0).abs() < 1e-12);
        assert!((fast.power_w / slow.power_w - 8.0).abs() < 1e-9);
        let still = stroke_means(&planform, &law, &paper::stroke(0.0), &twist).expect("means");
        assert_eq!(
            (
                still.lift_to_drag(),
                still.lift_per_power_n_per_w(),
                still.at_rate(1.0)
            ),
            (None, None, None)
        );
    }
}
