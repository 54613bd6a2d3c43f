//! Distributions along the span: lift and drag (the paper's Fig. 6c) and local L/D (Fig. 6d).

use super::effective::EffectiveCoefficients;
use super::means::{StationMeans, StrokeMeans};
use super::ratios::mean_local_lift_to_drag;

/// Stroke means at one station of a distribution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpanPoint {
    /// Span position from the wing base, m.
    pub r_m: f64,
    /// Mean lift, N/m.
    pub lift_n_per_m: f64,
    /// Mean drag, N/m.
    pub drag_n_per_m: f64,
    /// Local lift over drag, over the mean of the reference wing's along its span; absent without drag.
    pub lift_to_drag: Option<f64>,
}

/// The distribution along the span, local L/D scaled so that the reference wing has 1.
pub fn span_distribution(means: &StrokeMeans, reference: &StrokeMeans) -> Vec<SpanPoint> {
    let one = mean_local_lift_to_drag(reference);
    let point = |station: &StationMeans| SpanPoint {
        r_m: station.r_m,
        lift_n_per_m: station.lift_n_per_m,
        drag_n_per_m: station.drag_n_per_m,
        lift_to_drag: (station.drag_n_per_m > 0.0 && one > 0.0)
            .then(|| station.lift_n_per_m / station.drag_n_per_m / one),
    };
    means.stations.iter().map(point).collect()
}

/// The means scaled by effective coefficients, as the paper plots a wing whose lift and power were measured; without
/// an effective drag the drag and power stay as modelled.
pub fn scaled_to_measured(means: &StrokeMeans, effective: &EffectiveCoefficients) -> StrokeMeans {
    let (lift, drag) = (effective.lift, effective.drag.unwrap_or(1.0));
    let stations = means.stations.iter().map(|station| StationMeans {
        lift_n_per_m: station.lift_n_per_m * lift,
        drag_n_per_m: station.drag_n_per_m * drag,
        power_w_per_m: station.power_w_per_m * drag,
        ..*station
    });
    StrokeMeans {
        peak_rate_rad_s: means.peak_rate_rad_s,
        lift_n: means.lift_n * lift,
        drag_n: means.drag_n * drag,
        power_w: means.power_w * drag,
        stations: stations.collect(),
    }
}

/// How far the lift distribution departs from an ellipse over the built span (base to tip) with the same lift: root
/// mean square over the span, as a share of the mean lift per length. `None` without stations or without lift.
pub fn departure_from_ellipse(means: &StrokeMeans) -> Option<f64> {
    let span_m: f64 = means.stations.iter().map(|station| station.width_m).sum();
    if !(span_m > 0.0 && means.lift_n != 0.0) {
        return None;
    }
    let mean_n_per_m = means.lift_n / span_m;
    let square: f64 = means
        .stations
        .iter()
        .map(|station| {
            let from_middle = 2.0 * station.r_m / span_m - 1.0;
            let ellipse = 4.0 / std::f64::consts::PI * (1.0 - from_middle * from_middle).max(0.0).sqrt();
            station.width_m * (station.lift_n_per_m / mean_n_per_m - ellipse).powi(2)
        })
        .sum();
    Some((square / span_m).sqrt())
}

#[cfg(test)]
mod tests {
    use super::{departure_from_ellipse, scaled_to_measured, span_distribution};
    use crate::lift::effective::EffectiveCoefficients;
    use crate::lift::means::StrokeMeans;
    use crate::lift::paper;
    use crate::lift::ratios::{Ratios, mean_local_lift_to_drag};
    use crate::lift::stroke::stroke_means;
    use crate::lift::twist::{TwistAlongSpan, TwistHistory};

    fn means(twist: TwistAlongSpan, frequency_hz: f64) -> StrokeMeans {
        let twist = TwistHistory::paper_ramp(twist);
        stroke_means(
            &paper::planform(),
            &paper::law(),
            &paper::stroke(frequency_hz),
            &twist,
        )
        .expect("means")
    }

    #[test]
    fn the_rigid_wing_lifts_about_its_drag_everywhere_and_its_local_ratio_is_1() {
        let rigid = means(TwistAlongSpan::flat(), 21.0);
        for point in span_distribution(&rigid, &rigid) {
            assert!(
                (point.lift_n_per_m / point.drag_n_per_m - 1.06).abs() < 0.005,
                "{}",
                point.r_m
            );
            assert!((point.lift_to_drag.expect("drag") - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn the_distribution_integrates_to_the_total_and_the_local_ratio_to_the_papers_efficiency() {
        let (rigid, v1) = (
            means(TwistAlongSpan::flat(), 21.0),
            means(paper::twist_v1(), 22.0),
        );
        let points = span_distribution(&v1, &rigid);
        let span_m: f64 = v1.stations.iter().map(|station| station.width_m).sum();
        let weighted = |value: &dyn Fn(usize) -> f64| -> f64 {
            (0..points.len()).map(|i| value(i) * v1.stations[i].width_m).sum()
        };
        assert!((weighted(&|i| points[i].lift_n_per_m) / v1.lift_n - 1.0).abs() < 1e-12);
        let efficiency = weighted(&|i| points[i].lift_to_drag.expect("drag")) / span_m;
        let ratios = Ratios::between(&v1, &rigid).expect("ratios");
        assert!((efficiency / ratios.local_lift_to_drag - 1.0).abs() < 1e-12);
        assert!((efficiency - mean_local_lift_to_drag(&v1) / mean_local_lift_to_drag(&rigid)).abs() < 1e-12);
    }

    #[test]
    fn scaled_to_the_measurement_v1_shows_the_papers_figure_6() {
        let rigid = means(TwistAlongSpan::flat(), 21.0);
        let as_flown = means(paper::twist_v1(), 22.0).at_rate(rigid.peak_rate_rad_s * 22.0 / 21.0 * 0.979);
        let as_flown = as_flown.expect("moves");
        let modelled = Ratios::between(&as_flown, &rigid).expect("ratios");
        let effective = EffectiveCoefficients::new(&modelled, 1.353, Some(1.413)).expect("ratios");
        let v1 = scaled_to_measured(&as_flown, &effective);
        let ratios = Ratios::between(&v1, &rigid).expect("ratios");
        assert!((ratios.lift - 1.353).abs() < 1e-12 && (ratios.lift_per_power - 1.413).abs() < 1e-12);
        let at = |means: &StrokeMeans, r_m: f64| {
            let station = means
                .stations
                .iter()
                .min_by(|a, b| (a.r_m - r_m).abs().total_cmp(&(b.r_m - r_m).abs()));
            *station.expect("stations")
        };
        // More lift at mid-span at similar drag in all; less drag near the tip; nearer to elliptic.
        assert!(at(&v1, 0.035).lift_n_per_m > 1.5 * at(&rigid, 0.035).lift_n_per_m);
        assert!((ratios.drag - 1.0).abs() < 0.03, "{}", ratios.drag);
        assert!(at(&v1, 0.066).drag_n_per_m < 0.5 * at(&rigid, 0.066).drag_n_per_m);
        assert!(departure_from_ellipse(&v1) < departure_from_ellipse(&rigid));
    }

    #[test]
    fn an_elliptic_lift_departs_from_its_ellipse_by_nothing() {
        let mut means = means(TwistAlongSpan::flat(), 21.0);
        let span_m: f64 = means.stations.iter().map(|station| station.width_m).sum();
        means.lift_n = 0.0;
        for station in &mut means.stations {
            let from_middle = 2.0 * station.r_m / span_m - 1.0;
            station.lift_n_per_m = (1.0 - from_middle * from_middle).sqrt();
            means.lift_n += station.lift_n_per_m * station.width_m;
        }
        assert!(departure_from_ellipse(&means).expect("lift") < 1e-4);
        means.stations.clear();
        assert_eq!(departure_from_ellipse(&means), None);
    }
}
