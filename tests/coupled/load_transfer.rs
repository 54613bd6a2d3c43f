//! Strips hand their whole force to the nodes: force, moment and work on shapes that are anything but flat.
//!
//! Each strip's points are put on a straight line of any direction and length by nodal displacements that are otherwise
//! random. The pressure law says ∫p dη = 1 and ∫p η dη = x_cp, so the force on a strip is F (by hand below), its moment
//! about the deformed leading edge x_cp c′ × F, and its work on a displacement a + b η is (a + b x_cp)·F.

use nalgebra::{DMatrix, Vector3};
use washout::aero::{AirLaw, Flow};
use washout::coupling::air::Air;
use washout::coupling::strips::{Strip, Strips};
use washout::input::design::{CentreOfPressure, Coefficients};

use crate::support::{Noise, Wing, shipped};

/// Nodes of a strip with the matrix that gives the places of its points from those of the nodes.
fn interpolation(strip: &Strip) -> (Vec<usize>, DMatrix<f64>) {
    let mut nodes: Vec<usize> = strip.points.iter().flat_map(|p| p.nodes).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let mut matrix = DMatrix::zeros(strip.points.len(), nodes.len());
    for (row, point) in strip.points.iter().enumerate() {
        for (node, weight) in point.nodes.into_iter().zip(point.weights) {
            matrix[(row, nodes.binary_search(&node).unwrap())] += weight;
        }
    }
    (nodes, matrix)
}

/// Random values at the nodes of a strip that are a + b η at its points.
fn linear_across(strip: &Strip, a: Vector3<f64>, b: Vector3<f64>, noise: &mut Noise) -> DMatrix<f64> {
    let (nodes, matrix) = interpolation(strip);
    let wild = DMatrix::from_fn(nodes.len(), 3, |_, _| 0.01 * noise.number());
    let wanted = DMatrix::from_fn(strip.points.len(), 3, |row, k| a[k] + b[k] * strip.eta[row]);
    let gram = (&matrix * matrix.transpose()).cholesky().unwrap();
    // the second pass takes away what rounding left
    let once = &wild + matrix.transpose() * gram.solve(&(&wanted - &matrix * &wild));
    &once + matrix.transpose() * gram.solve(&(wanted - &matrix * &once))
}

/// Force (N) and centre of pressure of a strip whose chord and leading edge are as given: section 5 of the physics
/// by hand.
fn by_hand(
    strip: &Strip,
    law: &AirLaw,
    flow: &Flow,
    chord: Vector3<f64>,
    edge: Vector3<f64>,
) -> (Vector3<f64>, f64) {
    let along = chord.normalize();
    let span = (edge - along * along.dot(&edge)).normalize();
    let normal = span.cross(&along);
    let wind = flow.velocity(strip.r_m);
    let (wind_n, wind_c) = (wind.dot(&normal), wind.dot(&along));
    let (alpha, speed_squared) = (wind_n.atan2(wind_c), wind_n * wind_n + wind_c * wind_c);
    let (cl, cd) = law.coefficients.lift_and_drag(alpha);
    let load = 0.5 * law.density_kg_m3 * speed_squared * strip.chord_m * strip.width_m;
    let force_n = normal * load * (cl * alpha.cos() + cd * alpha.sin())
        + along * load * (cd * alpha.cos() - cl * alpha.sin());
    (force_n, law.centre_of_pressure.fraction(alpha))
}

/// Largest relative errors of force, moment and work over all strips of a wing in random shapes.
fn worst(wing: &Wing, seed: u64) -> [f64; 3] {
    let strips = Strips::new(&wing.mesh);
    let air_around = Air::new(&wing.design, &strips, &[], 1.0, None).unwrap().unwrap();
    let (law, flow) = (&air_around.law, &air_around.flow);
    let mut noise = Noise(seed);
    let mut worst = [0.0_f64; 3];
    for strip in &strips.strips {
        let nodes = interpolation(strip).0;
        let edge_at = |x: usize| Vector3::from(wing.mesh.nodes[x]);
        // a chord of any direction, half to twice as long, anywhere within a decimetre
        let chord = noise.vector().normalize() * strip.chord_m * 2.0_f64.powf(noise.number());
        let start = 0.1 * noise.vector();
        let places = linear_across(strip, start, chord, &mut noise);
        let mut displacement = vec![Vector3::zeros(); wing.mesh.nodes.len()];
        for (row, &node) in nodes.iter().enumerate() {
            displacement[node] = Vector3::from_fn(|k, _| places[(row, k)]) - edge_at(node);
        }
        let [a, b] = strip.edge.map(|node| edge_at(node) + displacement[node]);
        let air = strip.air(&air_around, &strip.shape(&displacement));
        let (force_n, x_cp) = by_hand(strip, law, flow, chord, b - a);
        let (field_a, field_b) = (noise.vector(), noise.vector());
        let field = linear_across(strip, field_a, field_b, &mut noise);
        let (mut force, mut moment, mut work) = (Vector3::zeros(), Vector3::zeros(), 0.0);
        strip.spread(|node, share, point| {
            let f = air.total_n * (air.weights[point] * share);
            let row = nodes.binary_search(&node).unwrap();
            force += f;
            moment += (edge_at(node) + displacement[node] - start).cross(&f);
            work += (0..3).map(|k| field[(row, k)] * f[k]).sum::<f64>();
        });
        let moment_by_hand = (x_cp * chord).cross(&force_n);
        let work_by_hand = (field_a + x_cp * field_b).dot(&force_n);
        let (size, arm) = (force_n.norm(), x_cp * chord.norm());
        for (worst, error) in worst.iter_mut().zip([
            (force - force_n).norm() / size,
            (moment - moment_by_hand).norm() / (arm * size),
            (work - work_by_hand).abs() / size,
        ]) {
            *worst = worst.max(error);
        }
    }
    worst
}

#[test]
fn force_moment_and_work_of_every_strip_are_those_of_the_pressure_law_on_random_shapes() {
    for name in ["rigid", "twist-v1", "twist-v2"] {
        let mut wing = shipped(name, &[]);
        let laws = [
            (Coefficients::Dickinson, CentreOfPressure::Dickson),
            (Coefficients::WhitneyWood, CentreOfPressure::Purdue),
        ];
        for (seed, (coefficients, centre)) in (0..6).zip(laws.into_iter().cycle()) {
            wing.design.air.coefficients = coefficients;
            wing.design.air.centre_of_pressure = Some(centre);
            let worst = worst(&wing, seed);
            println!("{name} {coefficients:?} {seed}: {worst:?}");
            assert!(worst.iter().all(|error| *error < 1e-10), "{name}: {worst:?}");
        }
    }
}

/// The same for the whole wing at once, all strips sharing nodes: a turned, stretched and sheared wing.
#[test]
fn force_and_moment_on_a_stretched_and_turned_wing_are_the_sums_over_its_strips() {
    for name in ["rigid", "twist-v1", "twist-v2"] {
        let wing = shipped(name, &[]);
        let coupled = washout::coupling::wing::Wing::new(&wing.design, &wing.mesh, None).unwrap();
        let Air { law, flow, .. } = coupled.air.clone().unwrap();
        let mut noise = Noise(7);
        let stretch = nalgebra::Matrix3::from_fn(|_, _| noise.number());
        let mut state = washout::structure::state::State::at_rest(wing.mesh.nodes.len());
        for (u, x) in state.displacement.iter_mut().zip(&wing.mesh.nodes) {
            *u = stretch * Vector3::from(*x) - Vector3::from(*x);
        }
        let air = coupled.strip_air(&coupled.strips.shapes(&state), false).unwrap();
        let nodal = coupled.air_force(&air);
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for ((f, x), u) in nodal.iter().zip(&wing.mesh.nodes).zip(&state.displacement) {
            force += f;
            moment += (Vector3::from(*x) + u).cross(f);
        }
        let (mut force_by_hand, mut moment_by_hand, mut size) = (Vector3::zeros(), Vector3::zeros(), 0.0);
        for strip in &coupled.strips.strips {
            let chord = stretch * Vector3::new(0.0, strip.chord_m, 0.0);
            let (f, x_cp) = by_hand(strip, &law, &flow, chord, stretch * Vector3::x());
            let place = stretch * Vector3::new(strip.r_m, 0.0, 0.0) + x_cp * chord;
            force_by_hand += f;
            moment_by_hand += place.cross(&f);
            size += f.norm();
        }
        let errors = [
            (force - force_by_hand).norm() / size,
            (moment - moment_by_hand).norm() / (size * 0.01),
        ];
        println!("{name}: {errors:?}");
        assert!(errors.iter().all(|error| *error < 1e-10), "{name}: {errors:?}");
    }
}

/// The pressure of the triangles is for pictures and stresses; it stands for the same air as the strips do: force, moment about the base
/// and moment about the leading edge, up to what centroids leave of the integral.
#[test]
fn pressure_on_the_triangles_makes_the_force_and_moments_of_the_strips() {
    let wing = shipped("twist-v2", &[]);
    let solution = wing.solve();
    let mut of_triangles = [0.0; 3];
    for (triangle, pressure_pa) in wing.mesh.triangles.iter().zip(&solution.pressure_pa) {
        let [a, b, c] = triangle.map(|node| Vector3::from(wing.mesh.nodes[node]));
        let (centre, area_m2) = ((a + b + c) / 3.0, 0.5 * (b - a).cross(&(c - a)).norm());
        let behind_m = centre.y - leading_edge_m(&wing, centre.x);
        for (sum, lever) in of_triangles.iter_mut().zip([1.0, centre.x, behind_m]) {
            *sum += lever * pressure_pa * area_m2;
        }
    }
    let mut of_strips = [0.0; 3];
    for strip in &solution.strips {
        let force_n = strip.normal_n_per_m * strip.width_m;
        let behind_m = strip.centre_of_pressure * strip.chord_m;
        for (sum, lever) in of_strips.iter_mut().zip([1.0, strip.r_m, behind_m]) {
            *sum += lever * force_n;
        }
    }
    for (triangles, strips) in of_triangles.iter().zip(of_strips) {
        assert!(
            (triangles / strips - 1.0).abs() < 0.02,
            "{of_triangles:?} {of_strips:?}"
        );
    }
}

/// Chordwise place of the leading edge at a station, m: between the foremost nodes of both neighbours.
fn leading_edge_m(wing: &Wing, x_m: f64) -> f64 {
    let strips = Strips::new(&wing.mesh).strips;
    let at = |strip: &Strip| (strip.r_m, strip.points.first().map_or(0.0, |point| point.y_m));
    let next = strips
        .partition_point(|strip| strip.r_m < x_m)
        .clamp(1, strips.len() - 1);
    let ([x0, y0], [x1, y1]) = (
        <[f64; 2]>::from(at(&strips[next - 1])),
        <[f64; 2]>::from(at(&strips[next])),
    );
    y0 + (y1 - y0) * (x_m - x0) / (x1 - x0)
}
