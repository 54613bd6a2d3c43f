//! Plates of one's own, without a wing: solved here, and written for other programs to solve.
//!
//! ```text
//! cargo run --release --example plates -- bend 30 10          a plate, a mesh: JSON with two displacements
//! cargo run --release --example plates -- film 16 16 DIR      also DIR/film-16x16.inp for CalculiX, .mdpa for Kratos
//! ```
//!
//! `bend`: 70 × 20 × 0.086 mm, E 70 GPa, ν 0, one short edge clamped, a dead force across the other with F L²/(E I) = 4;
//! the elastica says 46.8975 mm up and 23.0259 mm back. `twist`: ν 0.3, a quarter of that force at one corner. `film`:
//! 20 × 20 mm of Kapton, 6 µm, held all around, pre-tensioned by 50 N/m, under 1 kPa.

use std::error::Error;
use std::fs;
use std::path::Path;

use nalgebra::Vector3;

use washout::coupling::vibration::Standing;
use washout::export::{calculix, kratos};
use washout::progress::Progress;
use washout::structure::state::State;
use washout::structure::{Equilibrium, Loads, Model, NewtonSettings, Sheet};
use washout::verify::grid::{Grid, film, plate};

const LENGTH_M: f64 = 0.070;
const WIDTH_M: f64 = 0.020;
const THICKNESS_M: f64 = 86e-6;
const E_PA: f64 = 70e9;

/// A structure, its load, and the two nodes that are looked at.
struct Plate {
    model: Model,
    loads: Loads,
    seen: [usize; 2],
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let (case, along, across, folder) = match arguments[..] {
        [] => ("bend", "30", "10", None),
        [case, along, across] => (case, along, across, None),
        [case, along, across, folder] => (case, along, across, Some(folder)),
        _ => return Err("plates bend|twist|film CELLS_ALONG CELLS_ACROSS [DIR]".into()),
    };
    let count = [along.parse()?, across.parse()?];
    let Plate { model, loads, seen } = match case {
        "bend" => cantilever(count, 0.0, false)?,
        "twist" => cantilever(count, 0.3, true)?,
        "film" => taut(count)?,
        _ => return Err(format!("{case} is none of bend, twist, film").into()),
    };
    let nodes = model.nodes.len();
    let mut state = State::at_rest(nodes);
    let report = Equilibrium::new(&model)?.solve(
        &mut state,
        &Loads::none(nodes),
        &loads,
        &NewtonSettings::default(),
        &Progress::quiet(),
    )?;
    let millimetres = |node: usize| (1e3 * state.displacement[node]).as_slice().to_vec();
    println!(
        "{}",
        serde_json::json!({
            "case": case, "mesh": format!("{along} x {across}"), "nodes": nodes, "free": model.free_freedoms(),
            "steps": report.steps, "increments": report.increments,
            "first_mm": millimetres(seen[0]), "second_mm": millimetres(seen[1]),
            "first_node": seen[0] + 1, "second_node": seen[1] + 1,
        })
    );
    if let Some(folder) = folder {
        let moved_air_kg_m2 = Vec::new();
        let standing = Standing {
            model,
            state,
            loads,
            moved_air_kg_m2,
        };
        let name = format!("{case}-{along}x{across}");
        let path = |ending: &str| Path::new(folder).join(format!("{name}.{ending}"));
        fs::create_dir_all(folder)?;
        fs::write(path("inp"), calculix::deck(&name, &standing, &seen)?.text)?;
        fs::write(path("mdpa"), kratos::model_part(&name, &standing)?.text)?;
    }
    Ok(())
}

/// The cantilever; seen are the corner at the full width, where `twist` is loaded, and the other.
fn cantilever(count: [usize; 2], poisson: f64, at_corner: bool) -> Result<Plate, Box<dyn Error>> {
    let sheet = plate(E_PA, poisson, THICKNESS_M);
    let mut grid = Grid::new(count, sheet, |xi, eta| {
        Vector3::new(LENGTH_M * xi, WIDTH_M * eta, 0.0)
    })?;
    grid.hold(&grid.side(false), [true; 6]);
    let [along, across] = count;
    let seen = [grid.node([along, across]), grid.node([along, 0])];
    let force_n = 4.0 * E_PA * WIDTH_M * THICKNESS_M.powi(3) / 12.0 / LENGTH_M.powi(2);
    let mut loads = grid.end_force(force_n * Vector3::z());
    if at_corner {
        loads = Loads::none(grid.model.nodes.len());
        loads.force_n[seen[0]].z = 0.25 * force_n;
    }
    Ok(Plate {
        model: grid.model,
        loads,
        seen,
    })
}

/// The film; seen are its middle and the middle of its lower left quarter.
fn taut(count: [usize; 2]) -> Result<Plate, Box<dyn Error>> {
    let sheet = Sheet {
        pretension_n_per_m: 50.0,
        ..plate(2.5e9, 0.34, 6e-6)
    };
    let mut grid = Grid::new(count, film(sheet, 1.0), |xi, eta| {
        Vector3::new(WIDTH_M * xi, WIDTH_M * eta, 0.0)
    })?;
    grid.hold(&grid.rim(), [true, true, true, false, false, false]);
    let loads = grid.pressure(1e3 * Vector3::z());
    let seen = [grid.centre(), grid.node(count.map(|cells| cells / 4))];
    Ok(Plate {
        model: grid.model,
        loads,
        seen,
    })
}
