//! Time and memory of the three wings: coupled solve, mesh, and the parts of one Newton step.
//!
//! `cargo bench`. One thread; "max alloc" is the peak memory of one run.

use std::path::Path;

use divan::counter::ItemsCount;
use divan::{AllocProfiler, Bencher};

use washout::coupling::{solution::Solution, wing::Wing};
use washout::mesh::generate;
use washout::progress::Progress;
use washout::structure::Equilibrium;
use washout::structure::analysis::Analysis;
use washout::structure::factor::Factor;
use washout::verify::{ALL, Extent, run};
use washout::wing::WingModel;

#[global_allocator]
static MEMORY: AllocProfiler = AllocProfiler::system();

const WINGS: [&str; 3] = ["rigid", "twist-v1", "twist-v2"];

fn main() {
    divan::main();
}

fn model(wing: &str) -> WingModel {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("designs/{wing}.toml"));
    WingModel::open(file, &[]).expect("a shipped design")
}

fn shape(model: &WingModel) -> Solution {
    model.shape(None, &Progress::quiet()).expect("an equilibrium")
}

/// The coupled solve as `washout solve` makes it, from the mesh to the converged shape.
#[divan::bench(args = WINGS, sample_count = 5, sample_size = 1)]
fn coupled_solve(bencher: Bencher, wing: &str) {
    let model = model(wing);
    bencher.bench_local(|| shape(&model));
}

/// The mesh of a design.
#[divan::bench(args = WINGS, sample_count = 20)]
fn mesh(bencher: Bencher, wing: &str) {
    let model = model(wing);
    bencher
        .counter(ItemsCount::new(model.mesh.triangles.len()))
        .bench_local(|| generate(model.design(), &model.planform));
}

/// The parts of one Newton step on the loaded shape.
#[divan::bench_group(sample_count = 50, sample_size = 1)]
mod newton_step {
    use super::*;

    /// Stiffness of all elements into the matrix.
    #[divan::bench(args = WINGS)]
    fn assembly(bencher: Bencher, wing: &str) {
        with_loaded(wing, |wing, solution, equilibrium| {
            let loads = wing.loads_on(&solution.state).expect("loads");
            let mut values = equilibrium.tangent_values().to_vec();
            bencher.bench_local(|| {
                values.fill(0.0);
                wing.model
                    .tangent(&equilibrium.pattern, &solution.state, &loads, None, &mut values)
            });
        });
    }

    /// The numbers of the factor; its pattern is analysed once for a mesh.
    #[divan::bench(args = WINGS)]
    fn factorization(bencher: Bencher, wing: &str) {
        with_loaded(wing, |_, _, equilibrium| {
            let mut factor = Factor::new(Analysis::of(equilibrium.model).expect("memory").symbolic);
            bencher.bench_local(|| factor.positive(&equilibrium.pattern, equilibrium.tangent_values()));
        });
    }

    /// Assembly, factorization, solution and the residual of the shape that was reached.
    #[divan::bench(args = WINGS)]
    fn whole(bencher: Bencher, wing: &str) {
        with_loaded(wing, |wing, solution, equilibrium| {
            let loads = wing.loads_on(&solution.state).expect("loads");
            bencher.bench_local(|| {
                let pivots = equilibrium.factorize(&solution.state, &loads).expect("a factor");
                let residual = wing.model.residual(&equilibrium.pattern, &solution.state, &loads);
                let mut step: Vec<f64> = residual.iter().map(|r| -r).collect();
                equilibrium.solve_tangent(&mut step, 1);
                let moved = equilibrium.moved(&solution.state, &step, 1.0);
                (pivots, wing.model.residual(&equilibrium.pattern, &moved, &loads))
            });
        });
    }

    fn with_loaded(name: &str, measure: impl FnOnce(&Wing, &Solution, &mut Equilibrium)) {
        let model = model(name);
        let solution = shape(&model);
        let wing = Wing::new(model.design(), &model.mesh, None).expect("a wing");
        let mut equilibrium = Equilibrium::new(&wing.model).expect("a pattern");
        let loads = wing.loads_on(&solution.state).expect("loads");
        let pivots = equilibrium.factorize(&solution.state, &loads).expect("a factor");
        assert_eq!(pivots, 0, "{name} is stable");
        measure(&wing, &solution, &mut equilibrium);
    }
}

/// `washout verify`: every published case on three meshes, on all cores.
#[divan::bench(sample_count = 1, sample_size = 1)]
fn verification() -> usize {
    let outcomes = run(ALL, Extent::Full, &Progress::quiet()).expect("nobody stops it");
    outcomes.len()
}
