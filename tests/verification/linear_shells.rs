//! Linear shells of MacNeal & Harder and others: what the flat triangles (OPT + DKT) make of them, coarse, middle, fine.
//!
//! MacNeal & Harder, Finite Elem. Anal. Des. 1 (1985) 3-20; Scordelis & Lo, J. ACI 61 (1964); Belytschko et al. 1985.
//! Each case gives the ratio of its deflection to the reference on three meshes; bounds are those measured.
//!
//! ```text
//!  twisted beam, curved beam: cantilevers, unit tip load     roof: 80° of a cylinder on diaphragms, own weight
//!  hemisphere with hole: two pairs of forces, free equator   pinched cylinder: two forces, diaphragms
//! ```

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Vector3;
use washout::structure::Loads;

use crate::support::{Grid, line_shares, linear, plate};

/// Ratios printed and held against the bounds of the finest.
fn study(name: &str, meshes: [[usize; 2]; 3], bound: f64, ratio: impl Fn([usize; 2]) -> f64) {
    let ratios = meshes.map(ratio);
    println!("{name}: {meshes:?} {ratios:.4?}");
    assert!((ratios[2] - 1.0).abs() < bound, "{name}: {ratios:?}");
}

/// Deflection along `direction` of the middle of the free end of a cantilever grid, load 1 spread over that end.
fn cantilever(mut grid: Grid, direction: Vector3<f64>) -> f64 {
    for node in grid.side(false) {
        grid.model.clamp(node);
    }
    let end = grid.side(true);
    let shares = line_shares(&grid.model, &end);
    let total: f64 = shares.iter().sum();
    let mut loads = Loads::none(grid.model.nodes.len());
    for (&node, share) in end.iter().zip(&shares) {
        loads.force_n[node] = direction * (share / total);
    }
    linear(&grid.model, &loads)[end[end.len() / 2]][0].dot(&direction)
}

/// L = 12, b = 1.1, E = 29e6, ν = 0.22, pretwist 90°.
fn twisted(count: [usize; 2], thickness: f64) -> Grid {
    Grid::new(count, plate(29e6, 0.22, thickness), |xi, eta| {
        let (sine, cosine) = (FRAC_PI_2 * xi).sin_cos();
        Vector3::new(12.0 * xi, 1.1 * (eta - 0.5) * cosine, 1.1 * (eta - 0.5) * sine)
    })
}

#[test]
fn twisted_beam_of_medium_thickness() {
    let meshes = [[12, 2], [24, 4], [48, 8]];
    study("twisted beam, in plane", meshes, 6e-3, |count| {
        cantilever(twisted(count, 0.32), Vector3::z()) / 5.424e-3
    });
    study("twisted beam, out of plane", meshes, 3e-3, |count| {
        cantilever(twisted(count, 0.32), Vector3::y()) / 1.754e-3
    });
}

#[test]
fn thin_twisted_beam_is_missed_on_sides_of_many_thicknesses() {
    // known weakness: on a warped surface the optimal triangle ties the rotations about its normal to the membrane, which
    // stiffens it until the sides are some ten thicknesses long; wings have no such plate (films are tension fields)
    let ratio = |count: [usize; 2], direction: Vector3<f64>, exact: f64| {
        1e-6 * cantilever(twisted(count, 0.0032), direction) / exact
    };
    for count in [[24, 4], [48, 8], [96, 16]] {
        let both = [
            ratio(count, Vector3::z(), 5.256e-3),
            ratio(count, Vector3::y(), 1.294e-3),
        ];
        println!("thin twisted beam, in and out of plane: {count:?} {both:.4?}");
        // measured: 0.21 and 0.24, 0.73 and 0.73, 0.974 and 0.975
        assert!(
            count[0] < 96 || both.iter().all(|r| (r - 1.0).abs() < 3e-2),
            "{both:?}"
        );
    }
}

#[test]
fn curved_beam() {
    let grid = |count| {
        Grid::new(count, plate(1e7, 0.25, 0.1), |xi, eta| {
            let (sine, cosine) = (FRAC_PI_2 * xi).sin_cos();
            Vector3::new(sine, cosine, 0.0) * (4.12 + 0.2 * eta)
        })
    };
    let meshes = [[12, 2], [24, 2], [48, 4]];
    // exact elasticity (Timoshenko & Goodier), not the 1.4 % lower 0.08734 of 1985
    study("curved beam, in plane", meshes, 3e-3, |count| {
        cantilever(grid(count), Vector3::x()) / 0.088_566
    });
    // twice as wide as thick it is no plate: Kirchhoff's torsion stiffness b t³/3 stands for 0.2287 b t³, so 0.4544 (rod
    // formula with that) is met and not the solid's 0.4983
    let (radius, bending, torsion) = (4.22_f64, 1e7 * 0.2e-3 / 12.0, 4e6 * 0.2e-3 / 3.0);
    let rod = radius.powi(3) * (PI / 4.0 / bending + (0.75 * PI - 2.0) / torsion);
    study("curved beam, out of plane, Kirchhoff", meshes, 1.2e-2, |count| {
        cantilever(grid(count), Vector3::z()) / rod
    });
}

#[test]
fn scordelis_lo_roof() {
    // quarter: R = 25, L/2 = 25, 40°, t = 0.25, E = 4.32e8, ν = 0, weight 90 per area; middle of the free edge −0.3024
    study("Scordelis-Lo roof", [[8, 8], [16, 16], [32, 32]], 6e-3, |count| {
        let mut grid = Grid::new(count, plate(4.32e8, 0.0, 0.25), |xi, eta| {
            let (sine, cosine) = (40.0_f64.to_radians() * eta).sin_cos();
            Vector3::new(25.0 * sine, 25.0 * xi, 25.0 * cosine)
        });
        for node in grid.side(false) {
            // diaphragm
            grid.model.hold(node, [true, false, true, false, true, false]);
        }
        for node in grid.side(true) {
            grid.model.hold(node, [false, true, false, true, false, true]);
        }
        for node in grid.edge(false) {
            grid.model.hold(node, [true, false, false, false, true, true]);
        }
        let mut loads = Loads::none(grid.model.nodes.len());
        for shell in &grid.model.shells {
            for node in shell.nodes {
                loads.force_n[node].z -= 90.0 * shell.area_m2() / 3.0;
            }
        }
        -linear(&grid.model, &loads)[grid.node([count[0], count[1]])][0].z / 0.3024
    });
}

#[test]
fn pinched_hemisphere_with_hole() {
    // quarter: R = 10, t = 0.04, E = 6.825e7, ν = 0.3, hole 18°; forces 1 out along x and in along y; 0.0930
    study(
        "hemisphere with hole",
        [[8, 8], [16, 16], [32, 32]],
        0.02,
        |count| {
            let mut grid = Grid::new(count, plate(6.825e7, 0.3, 0.04), |xi, eta| {
                let (high, round) = (72.0_f64.to_radians() * xi, FRAC_PI_2 * eta);
                10.0 * Vector3::new(high.cos() * round.cos(), high.cos() * round.sin(), high.sin())
            });
            for node in grid.edge(false) {
                grid.model.hold(node, [false, true, false, true, false, true]);
            }
            for node in grid.edge(true) {
                grid.model.hold(node, [true, false, false, false, true, true]);
            }
            let (a, b) = (grid.node([0, 0]), grid.node([0, count[1]]));
            grid.model.hold(a, [false, false, true, false, false, false]);
            let mut loads = Loads::none(grid.model.nodes.len());
            loads.force_n[a].x = 1.0;
            loads.force_n[b].y = -1.0;
            linear(&grid.model, &loads)[a][0].x / 0.0930
        },
    );
}

#[test]
fn pinched_cylinder_with_diaphragms() {
    // eighth: R = 300, L/2 = 300, t = 3, E = 3e6, ν = 0.3; force 1/4; 1.82488e-5
    study("pinched cylinder", [[8, 8], [16, 16], [32, 32]], 5e-3, |count| {
        let mut grid = Grid::new(count, plate(3e6, 0.3, 3.0), |xi, eta| {
            let (sine, cosine) = (FRAC_PI_2 * eta).sin_cos();
            Vector3::new(300.0 * cosine, 300.0 * xi, 300.0 * sine)
        });
        for node in grid.side(false) {
            // middle of the length
            grid.model.hold(node, [false, true, false, true, false, true]);
        }
        for node in grid.side(true) {
            grid.model.hold(node, [true, false, true, false, true, false]);
        }
        for node in grid.edge(false) {
            grid.model.hold(node, [false, false, true, true, true, false]);
        }
        for node in grid.edge(true) {
            grid.model.hold(node, [true, false, false, false, true, true]);
        }
        let loaded = grid.node([0, count[1]]);
        let mut loads = Loads::none(grid.model.nodes.len());
        loads.force_n[loaded].z = -0.25;
        -linear(&grid.model, &loads)[loaded][0].z / 1.82488e-5
    });
}

#[test]
fn raasch_hook() {
    // arcs R = 14 over 60° and R = 46 over 150°, width 20, t = 2, E = 3300, ν = 0.35; unit shear along the width; 5.02201
    // (refined solids). Kirchhoff plates lack the edges' share of torsion, 1 − 0.63 t/b = 0.937, which is what comes out
    study("Raasch hook", [[18, 4], [36, 8], [72, 16]], 7e-2, |count| {
        let (first, second) = (14.0 * PI / 3.0, 46.0 * PI * 5.0 / 6.0);
        let grid = Grid::new(count, plate(3300.0, 0.35, 2.0), |xi, eta| {
            let along = xi * (first + second);
            let place = if along <= first {
                // centre (14, 0, 0), from the wall at the origin upwards
                let angle = along / 14.0;
                Vector3::new(14.0 - 14.0 * angle.cos(), 0.0, 14.0 * angle.sin())
            } else {
                // the bend turns the other way about the common normal at 60°
                let (sine, cosine) = (PI / 3.0).sin_cos();
                let joint = Vector3::new(14.0 - 14.0 * cosine, 0.0, 14.0 * sine);
                let outward = Vector3::new(-cosine, 0.0, sine);
                let ahead = Vector3::new(sine, 0.0, cosine);
                let angle = (along - first) / 46.0;
                joint + 46.0 * (outward * (1.0 - angle.cos()) + ahead * angle.sin())
            };
            place + Vector3::new(0.0, 20.0 * eta, 0.0)
        });
        cantilever(grid, Vector3::y()) / 5.022_013
    });
}
