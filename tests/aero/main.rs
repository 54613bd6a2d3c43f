//! Air and lift on the three designs as they stand in `designs/`: rooms together, against the paper's numbers.

use std::path::Path;

use washout::aero::{AirLaw, Flow, pressure_weights, strip_force};
use washout::geometry::Planform;
use washout::input::Design;
use washout::input::design::Coefficients;
use washout::lift::{
    Ratios, Stroke, StrokeMeans, TwistAlongSpan, TwistHistory, implied_amplitude_ratio, stroke_means,
};

/// A wing of the paper with its planform, air and stroke.
struct Wing {
    planform: Planform,
    law: AirLaw,
    flow: Flow,
}

fn wing(name: &str) -> Wing {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("designs").join(name);
    let loaded = Design::load(&path, &[]).expect("a design of this repository");
    Wing {
        planform: Planform::from_design(&loaded.design).expect("a planform"),
        law: AirLaw::from_design(&loaded.design, None).expect("an air law"),
        flow: Flow::from_design(&loaded.design).expect("a flapping wing"),
    }
}

/// Stroke means with the paper's ramp to a twist in stages `[length_mm, rate_deg_per_mm]`.
fn means(name: &str, stages: &[[f64; 2]]) -> StrokeMeans {
    let wing = wing(name);
    let stroke = Stroke::from_flow(&wing.flow).expect("a stroke");
    let twist = TwistHistory::paper_ramp(TwistAlongSpan::from_stages(stages).expect("stages"));
    stroke_means(&wing.planform, &wing.law, &stroke, &twist).expect("means")
}

fn close(value: f64, expected: f64, relative: f64, what: &str) {
    assert!(
        (value / expected - 1.0).abs() < relative,
        "{what}: {value}, expected {expected}"
    );
}

/// Twist as the paper states it first.
const TWIST_V1: [[f64; 2]; 2] = [[48.0, 0.29], [22.0, 1.39]];
const TWIST_V2: [[f64; 2]; 2] = [[20.0, 0.0], [50.0, 0.46]];

#[test]
fn the_designs_with_the_measured_twist_give_the_papers_amplitude_free_ratios() {
    let rigid = means("rigid.toml", &[]);
    let cases = [
        (
            "twist-v1.toml",
            &TWIST_V1,
            22.0 / 21.0,
            1.353 / 1.636,
            [0.786, 0.579, 1.357, 1.481, 1.414, 0.979],
        ),
        (
            "twist-v2.toml",
            &TWIST_V2,
            23.0 / 21.0,
            1.177 / 1.133,
            [0.905, 0.701, 1.290, 1.375, 1.255, 0.978],
        ),
    ];
    for (name, twist, frequency, quasi_steady_lift, expected) in cases {
        let at_equal_amplitude = Ratios::between(&means(name, twist), &rigid).expect("ratios");
        close(
            at_equal_amplitude.rate_ratio,
            frequency,
            1e-12,
            "the designs flap at the paper's frequencies",
        );
        let equal = at_equal_amplitude.at_rate_ratio(1.0).expect("equal fΦ");
        close(equal.lift, expected[0], 5e-3, "lift at equal fΦ");
        close(equal.drag, expected[1], 5e-3, "drag at equal fΦ");
        close(equal.lift_to_drag, expected[2], 5e-3, "lift to drag");
        close(
            equal.lift_per_power,
            expected[3],
            5e-3,
            "lift per power at equal fΦ",
        );
        close(
            at_equal_amplitude.lift_per_power,
            expected[4],
            5e-3,
            "lift per power at equal Φ",
        );
        let amplitude = implied_amplitude_ratio(quasi_steady_lift, equal.lift, frequency).expect("a ratio");
        close(amplitude, expected[5], 5e-3, "implied amplitude ratio");
    }
}

#[test]
fn the_rigid_design_lifts_26_5_millinewtons_at_its_assumed_amplitude() {
    close(
        means("rigid.toml", &[]).lift_n,
        26.5e-3,
        5e-3,
        "mean lift of the rigid wing",
    );
}

#[test]
fn both_air_rooms_agree_on_a_blade_element() {
    // `lift` writes its blade elements in coefficients, `aero` in vectors: same force along the flapping axis.
    let wing = wing("twist-v2.toml");
    let stroke = Stroke::from_flow(&wing.flow).expect("a stroke");
    let twist = TwistAlongSpan::from_stages(&TWIST_V2).expect("stages");
    let history = TwistHistory::paper_ramp(twist.clone());
    let by_lift =
        washout::lift::forces_at_phase(&wing.planform, &wing.law, &stroke, &history, 0.0).expect("forces");
    let count = 2000;
    let width_m = wing.planform.tip_m() / f64::from(count);
    let (mut lift_n, mut drag_n, mut power_w) = (0.0, 0.0, 0.0);
    for i in 0..count {
        let r_m = (f64::from(i) + 0.5) * width_m;
        let (sin, cos) = twist.twist_rad(r_m).sin_cos();
        let chord_m = wing.planform.chord_m(r_m);
        let velocity = wing.flow.velocity(r_m);
        let chord = nalgebra::Vector3::new(0.0, cos, sin) * chord_m;
        let force = strip_force(
            &wing.law,
            &velocity,
            &chord,
            &nalgebra::Vector3::x(),
            chord_m,
            &(),
        );
        lift_n += force.force_n_per_m.dot(&wing.flow.lift_direction()) * width_m;
        drag_n += force.force_n_per_m.dot(&velocity.normalize()) * width_m;
        power_w += force.force_n_per_m.dot(&velocity) * width_m;
    }
    close(lift_n, by_lift.lift_n, 1e-5, "lift");
    close(drag_n, by_lift.drag_n, 1e-5, "drag");
    close(power_w, by_lift.power_w, 1e-5, "power");
}

#[test]
fn the_pressure_on_every_chord_line_of_the_mesh_keeps_force_and_centre() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("designs/twist-v2.toml");
    let design = Design::load(&path, &[]).expect("a design").design;
    let planform = Planform::from_design(&design).expect("a planform");
    let mesh = washout::mesh::generate(&design, &planform).expect("a mesh");
    let mut lines = 0;
    for step in 1..200 {
        let r_m = planform.tip_m() * f64::from(step) / 200.0;
        let Some(line) = washout::mesh::chord_line(&mesh, r_m) else {
            continue;
        };
        lines += 1;
        let (first, last) = (&line.points[0], &line.points[line.points.len() - 1]);
        let chord_m = last.y_m - first.y_m;
        let eta: Vec<f64> = line
            .points
            .iter()
            .map(|point| (point.y_m - first.y_m) / chord_m)
            .collect();
        for x_cp in [0.05, 0.255, 0.46, 0.8] {
            let weights: Vec<f64> = pressure_weights(x_cp, &eta);
            let force: f64 = weights.iter().sum();
            let centre: f64 = weights
                .iter()
                .zip(&eta)
                .map(|(weight, fraction)| weight * fraction)
                .sum();
            assert!(
                (force - 1.0).abs() < 1e-12 && (centre - x_cp).abs() < 1e-12,
                "{r_m}: {force} {centre}"
            );
        }
    }
    assert!(lines > 190, "only {lines} of 199 chord lines found");
}

/// A table is read by monotone cubics (Fritsch and Carlson 1980, with the three-point slopes at the ends of Fritsch and Butland 1984).
/// Values of SciPy's `PchipInterpolator` between uneven knots; the ends of lift have the slope 0 and three times the secant, those of
/// drag the slope of three points.
#[test]
fn a_table_of_coefficients_is_read_as_scipy_reads_it() {
    let table = [
        [-10.0, -0.5, 0.4],
        [-4.0, -0.3, 0.1],
        [1.0, 0.2, 0.5],
        [8.0, 0.9, 0.45],
        [20.0, 0.7, 0.1],
    ];
    let expected = [
        [-9.0, -0.492236467236, 0.293813131313],
        [-6.0, -0.39698005698, 0.12404040404],
        [-2.0, -0.135446153846, 0.2408],
        [5.0, 0.697959183673, 0.480352624782],
        [10.0, 0.899074074074, 0.420906855745],
        [14.0, 0.875, 0.323271133527],
        [19.0, 0.745949074074, 0.142250440976],
    ];
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("designs/twist-v2.toml");
    let mut design = Design::load(&path, &[])
        .expect("a design of this repository")
        .design;
    design.air.coefficients = Coefficients::Table;
    let law = AirLaw::from_design(&design, Some(&table)).expect("a law");
    for [alpha_deg, lift, drag] in expected {
        let (own_lift, own_drag) = law.coefficients.lift_and_drag(f64::to_radians(alpha_deg));
        assert!(
            (own_lift - lift).abs() < 1e-11,
            "{alpha_deg} deg: lift {own_lift}, {lift}"
        );
        assert!(
            (own_drag - drag).abs() < 1e-11,
            "{alpha_deg} deg: drag {own_drag}, {drag}"
        );
    }
}
