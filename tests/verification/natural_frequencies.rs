//! Natural frequencies of plates and of a taut film against closed forms and a Ritz solution.

use std::f64::consts::PI;

use nalgebra::Vector3;
use washout::progress::Progress;
use washout::structure::state::State;
use washout::structure::{Compression, Equilibrium, Loads, Model, Sheet, Vibration, lowest_modes};

/// Lowest natural frequencies about the shape at rest, Hz.
fn frequencies(model: &Model, count: usize) -> Vec<f64> {
    let mut equilibrium = Equilibrium::new(model).unwrap();
    let (state, loads) = (State::at_rest(model.nodes.len()), Loads::none(model.nodes.len()));
    match lowest_modes(&mut equilibrium, &state, &loads, &[], count, &Progress::quiet()).unwrap() {
        Vibration::Stable(modes) => modes.iter().map(|mode| mode.frequency_hz).collect(),
        Vibration::Unstable { negative } => panic!("{negative} negative pivots"),
    }
}

/// Rectangle a × b along x and y of `count` × `count` squares, each cut in two, the cuts alternating.
fn sheet(a: f64, b: f64, count: usize, sheet: Sheet) -> Model {
    let at = |k: usize, length: f64| length * k as f64 / count as f64;
    let index = |i: usize, j: usize| i * (count + 1) + j;
    let nodes = (0..=count).flat_map(|i| (0..=count).map(move |j| Vector3::new(at(i, a), at(j, b), 0.0)));
    let mut model = Model::new(nodes.collect());
    let sheet = model.add_sheet(sheet);
    for i in 0..count {
        for j in 0..count {
            let corners = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
            let cut = if (i + j) % 2 == 0 {
                [[0, 1, 2], [0, 2, 3]]
            } else {
                [[0, 1, 3], [1, 2, 3]]
            };
            for triangle in cut {
                model.add_shell(triangle.map(|k| corners[k]), sheet).unwrap();
            }
        }
    }
    model
}

fn plate() -> Sheet {
    Sheet {
        e_pa: 70e9,
        poisson: 0.3,
        thickness_m: 1e-3,
        density_kg_m3: 2700.0,
        pretension_n_per_m: 0.0,
        compression: Compression::Carries,
    }
}

/// √(D/(ρ t)), m²/s.
fn plate_speed(sheet: &Sheet) -> f64 {
    let bending = sheet.e_pa * sheet.thickness_m.powi(3) / (12.0 * (1.0 - sheet.poisson.powi(2)));
    (bending / (sheet.density_kg_m3 * sheet.thickness_m)).sqrt()
}

fn hold_edges(model: &mut Model, a: f64, flags: [bool; 6]) {
    for node in 0..model.nodes.len() {
        let on = |x: f64| x.abs() < 1e-9 || (x - a).abs() < 1e-9;
        if on(model.nodes[node].x) || on(model.nodes[node].y) {
            model.hold(node, flags);
        }
    }
}

#[test]
fn simply_supported_square_plate_has_navier_frequencies() {
    let a = 0.4;
    let error = |count: usize| {
        let mut model = sheet(a, a, count, plate());
        hold_edges(&mut model, a, [true, true, true, false, false, true]);
        let found = frequencies(&model, 4);
        // ω = π² (m² + n²)/a² √(D/(ρ t))
        let exact = [2.0, 5.0, 5.0, 8.0].map(|s| PI / 2.0 * s / (a * a) * plate_speed(&plate()));
        let pairs = found.iter().zip(exact);
        pairs.map(|(f, e)| f / e - 1.0).collect::<Vec<f64>>()
    };
    let (coarse, fine) = (error(8), error(16));
    for (coarse, fine) in coarse.iter().zip(&fine) {
        // second order: what is left after extrapolation is a tenth of a percent at most
        assert!((coarse / fine).log2() > 1.9, "{coarse} {fine}");
        assert!((fine - (coarse - fine) / 3.0).abs() < 1e-3, "{coarse} {fine}");
    }
}

#[test]
fn cantilevered_plate_has_ritz_frequencies() {
    // λ = ω a² √(ρ t/D), a from the clamp to the free edge: own Ritz solution with 16 × 16 Legendre polynomials,
    // ν = 0.3, which changes by less than 1e-4 from 14 × 14
    for (width_share, exact) in [
        (1.0, [3.4710, 8.5065, 21.285, 27.199]),
        (0.5, [3.4393, 14.802, 21.434, 48.179]),
    ] {
        let a = 0.4;
        let mut model = sheet(a, width_share * a, 16, plate());
        for node in 0..17 {
            model.clamp(node);
        }
        let found = frequencies(&model, 4);
        for (found, exact) in found.iter().zip(exact) {
            let lambda = 2.0 * PI * found * a * a / plate_speed(&plate());
            assert!((lambda / exact - 1.0).abs() < 0.01, "{lambda} {exact}");
        }
    }
}

#[test]
fn taut_film_is_a_drum() {
    let (a, tension) = (0.02, 20.0);
    let compression = Compression::TensionField {
        residual: 1e-4,
        drilling_factor: 1.0,
    };
    let film = Sheet {
        e_pa: 2.5e9,
        poisson: 0.34,
        thickness_m: 6e-6,
        density_kg_m3: 1420.0,
        pretension_n_per_m: tension,
        compression,
    };
    let mut model = sheet(a, a, 16, film);
    hold_edges(&mut model, a, [true, true, true, false, false, false]);
    let found = frequencies(&model, 4);
    // f = √(m² + n²)/(2a) √(N/(ρ t))
    let speed = (tension / (1420.0 * 6e-6)).sqrt();
    for (found, s) in found.iter().zip([2.0_f64, 5.0, 5.0, 8.0]) {
        let exact = s.sqrt() / (2.0 * a) * speed;
        assert!((found / exact - 1.0).abs() < 0.02, "{found} {exact}");
    }
}
