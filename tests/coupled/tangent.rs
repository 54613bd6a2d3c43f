//! The coupled tangent K − A S and the air's derivatives against differences of what they differentiate.

use washout::coupling::air::Air;
use washout::coupling::feedback::{EXACT, Feedback};
use washout::coupling::recycled::Recycled;
use washout::coupling::strips::{StripShape, Strips};
use washout::coupling::wing::Wing;
use washout::structure::Equilibrium;

use crate::support::{Noise, shipped};

/// Random forces all over the wing, even ones and ones in waves.
fn loads(wing: &Wing, equilibrium: &Equilibrium, noise: &mut Noise) -> Vec<f64> {
    let (a, b) = (noise.vector(), noise.vector());
    let mut loads = vec![0.0; equilibrium.held().len()];
    for (node, x) in wing.model.nodes.iter().enumerate() {
        let at = equilibrium.pattern.freedom(node, 0);
        for k in 0..3 {
            loads[at + k] = a[k] + b[k] * (60.0 * x.x + 90.0 * x.y).sin();
        }
    }
    loads
}

/// Largest error of the coupled tangent in random directions x, which are answers to loads all over the wing: the
/// difference (F(u + h x) − F(u − h x))/2h, put through (K − A S)⁻¹, must give x back. Measured as a displacement, because
/// forces along the rod drown in the rounding of its length.
fn tangent_error(name: &str, refine: &str, move_m: f64) -> f64 {
    let shipped = shipped(name, &[refine, "coupling.residual_tolerance=1e-8"]);
    let solution = shipped.solve();
    let wing = Wing::new(&shipped.design, &shipped.mesh, None).unwrap();
    let mut equilibrium = Equilibrium::new(&wing.model).unwrap();
    let state = &solution.state;
    equilibrium
        .factorize(state, &wing.loads_on(state).unwrap())
        .unwrap();
    let shapes = wing.strips.shapes(state);
    let mut worst = 0.0_f64;
    let mut known = Recycled::new();
    for seed in 0..4 {
        let right = loads(&wing, &equilibrium, &mut Noise(seed));
        let x = Feedback::new(&wing, &mut equilibrium, &shapes)
            .unwrap()
            .solve(&right, EXACT, &mut known)
            .unwrap();
        let step = move_m / x.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let residual = |share: f64| {
            let moved = equilibrium.moved(state, &x, share);
            wing.model
                .residual(&equilibrium.pattern, &moved, &wing.loads_on(&moved).unwrap())
        };
        let (up, down) = (residual(step), residual(-step));
        let slope: Vec<f64> = up
            .iter()
            .zip(&down)
            .map(|(a, b)| (a - b) / (2.0 * step))
            .collect();
        let back = Feedback::new(&wing, &mut equilibrium, &shapes)
            .unwrap()
            .solve(&slope, EXACT, &mut known)
            .unwrap();
        let norm = |v: &mut dyn Iterator<Item = f64>| v.map(|v| v * v).sum::<f64>().sqrt();
        let error = norm(&mut back.iter().zip(&x).map(|(a, b)| a - b)) / norm(&mut x.iter().copied());
        worst = worst.max(error);
    }
    worst
}

#[test]
fn solves_with_the_coupled_tangent_agree_with_differences_of_the_coupled_residual() {
    let error = tangent_error("twist-v2", "mesh.refine=1", 1e-7);
    println!("tangent: {error:.1e}");
    assert!(error < 1e-5, "{error}");
}

#[test]
fn what_solves_before_have_told_spares_work_and_changes_no_digit_that_counts() {
    let shipped = shipped("twist-v2", &["mesh.refine=0.5"]);
    let solution = shipped.solve();
    let wing = Wing::new(&shipped.design, &shipped.mesh, None).unwrap();
    let mut equilibrium = Equilibrium::new(&wing.model).unwrap();
    let state = &solution.state;
    equilibrium
        .factorize(state, &wing.loads_on(state).unwrap())
        .unwrap();
    let shapes = wing.strips.shapes(state);
    // the same wing with its strips turned a little: a feedback nearby
    let turned: Vec<f64> = shapes
        .chunks_exact(6)
        .flat_map(|shape| {
            let mut shape = shape.to_vec();
            shape[2] += 0.01 * shape[1];
            shape
        })
        .collect();
    let mut noise = Noise(7);
    let rights = [(); 3].map(|()| loads(&wing, &equilibrium, &mut noise));
    let mut kept = Recycled::new();
    for (shapes, right, change) in [
        (&shapes, &rights[0], false),
        (&shapes, &rights[1], false),
        (&turned, &rights[2], true),
    ] {
        if change {
            kept.change();
        }
        let mut alone = Recycled::new();
        let fresh = Feedback::new(&wing, &mut equilibrium, shapes)
            .unwrap()
            .solve(right, EXACT, &mut alone)
            .unwrap();
        let (before, is_first) = (kept.len(), kept.is_empty() && !change);
        let again = Feedback::new(&wing, &mut equilibrium, shapes)
            .unwrap()
            .solve(right, EXACT, &mut kept)
            .unwrap();
        let size = fresh.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let apart = fresh
            .iter()
            .zip(&again)
            .fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
        println!(
            "{} directions alone, {} with what is known, {:.1e} apart",
            alone.len(),
            kept.len() - before,
            apart / size
        );
        assert!(apart < 1e-10 * size, "{}", apart / size);
        assert!(is_first || 10 * (kept.len() - before) < 8 * alone.len());
    }
}

#[test]
fn forces_of_the_points_differentiate_exactly_for_random_shapes() {
    let wing = shipped("twist-v2", &["mesh.refine=0.5"]);
    let strips = Strips::new(&wing.mesh);
    let mut air = Air::new(&wing.design, &strips, &[], 1.0, None).unwrap().unwrap();
    let mut noise = Noise(3);
    let mut worst = 0.0_f64;
    for large_share in [1.0, 0.0, 0.4] {
        air.large_share = large_share;
        for strip in &strips.strips {
            let mut shape = StripShape::zeros();
            let chord = noise.vector().normalize() * strip.chord_m;
            let edge = noise.vector().normalize();
            shape.fixed_rows_mut::<3>(0).copy_from(&chord);
            shape.fixed_rows_mut::<3>(3).copy_from(&edge);
            let exact = strip.air_and_derivative(&air, &shape);
            let force = |shape: &StripShape| {
                let air = strip.air(&air, shape);
                air.weights.iter().map(|w| air.total_n * *w).collect::<Vec<_>>()
            };
            for k in 0..6 {
                let unit = if k < 3 { strip.chord_m } else { 1.0 };
                let step = 1e-5 * unit;
                let at = |share: f64| {
                    let mut moved = shape;
                    moved[k] += share * step;
                    force(&moved)
                };
                let size = exact.total_n.norm().max(1e-6) / unit;
                for (point, (up, down)) in at(1.0).iter().zip(at(-1.0)).enumerate() {
                    let slope = (up - down) / (2.0 * step);
                    let error = (slope - exact.by_shape[point].column(k)).norm() / size;
                    worst = worst.max(error);
                }
            }
        }
    }
    println!("by_shape: {worst:.1e}");
    assert!(worst < 1e-5, "{worst}");
}
