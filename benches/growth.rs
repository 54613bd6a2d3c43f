//! How time and memory of a coupled solve grow with the mesh, and where they go: `cargo bench --bench growth`.
//!
//! The wing is twist-v2 with a sheet of 0.1 mm Kapton, which carries compression, so that every mesh takes the same few Newton
//! steps. Each mesh is solved by a process of its own, on one thread; `-- --threads 2` adds the factor by two. `-- --most 100000`
//! stops there.

use std::path::Path;
use std::process::Command;
use std::time::Instant;

use faer::sparse::SparseColMat;
use faer::sparse::linalg::solvers::{Llt, SymbolicLlt};
use faer::{Par, Side};
use serde::{Deserialize, Serialize};

use washout::coupling::{solve, wing::Wing};
use washout::geometry::Planform;
use washout::input::{Design, Loaded};
use washout::mesh::generate;
use washout::progress::Progress;
use washout::structure::Equilibrium;
use washout::structure::analysis::Analysis;
use washout::structure::factor::Factor;

/// Refinement in both directions, from 2,000 to half a million freedoms.
const REFINE: [f64; 8] = [0.7, 1.0, 1.4, 2.0, 2.8, 4.0, 8.0, 11.3];

/// One mesh. Times in seconds.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Grown {
    freedoms: usize,
    steps: usize,
    /// The whole coupled solve, from the mesh.
    solve: f64,
    /// Order, pattern, memory of the factor: once for a mesh.
    analysis: f64,
    /// Tangent and residual.
    assembly: f64,
    factorization: f64,
    /// The numeric factorization by faer alone of the same matrix, in an order of its own and in ours.
    faer: f64,
    back_substitution: f64,
    /// Shapes of the strips, and air on the nodes.
    load_transfer: f64,
    /// Peak memory of the process after the solve, and of the factor alone.
    peak_bytes: f64,
    factor_bytes: f64,
    /// The factorization by two threads.
    by_two: Option<f64>,
}

fn main() {
    let words: Vec<String> = std::env::args().collect();
    let after = |name: &str| {
        let at = words.iter().position(|word| word == name)?;
        words.get(at + 1)?.parse::<f64>().ok()
    };
    if let Some(refine) = after("--one") {
        let grown = one(refine, after("--threads").is_some_and(|threads| threads > 1.0));
        println!("{}", serde_json::to_string(&grown).expect("JSON"));
        return;
    }
    let most = after("--most").unwrap_or(f64::INFINITY);
    let own = std::env::current_exe().expect("a path");
    let mut rows: Vec<Grown> = Vec::new();
    println!(
        "| freedoms | steps | solve, s | assembly | factorization | faer alone | back-substitution | load transfer | rest of a step | peak MB | factor MB |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    for refine in REFINE {
        let mut child = Command::new(&own);
        child
            .args(["--one", &refine.to_string()])
            .env("RAYON_NUM_THREADS", "1");
        if let Some(threads) = after("--threads") {
            child.args(["--threads", &threads.to_string()]);
            child.env("RAYON_NUM_THREADS", threads.to_string());
        }
        let said = child.output().expect("a child");
        let Ok(row) = serde_json::from_slice::<Grown>(&said.stdout) else {
            println!("refine {refine}: {}", String::from_utf8_lossy(&said.stderr));
            break;
        };
        println!("{}", line(&row));
        let is_last = row.freedoms as f64 >= most;
        rows.push(row);
        if is_last {
            break;
        }
    }
    exponents(&rows);
}

/// Times as multiples of one numeric factorization of the same matrix.
fn line(row: &Grown) -> String {
    let times = |seconds: f64| format!("{:.2}", seconds / row.factorization);
    let known = row.assembly + row.factorization + row.load_transfer;
    let a_step = (row.solve - row.analysis) / (row.steps + 1) as f64;
    let by_two = row
        .by_two
        .map_or(String::new(), |two| format!(" (by two threads {})", times(two)));
    format!(
        "| {} | {} | {:.3} | {} | {:.4} s{by_two} | {} | {} | {} | {} | {:.0} | {:.0} |",
        row.freedoms,
        row.steps,
        row.solve,
        times(row.assembly),
        row.factorization,
        times(row.faer),
        times(row.back_substitution),
        times(row.load_transfer),
        times(a_step - known),
        row.peak_bytes / 1e6,
        row.factor_bytes / 1e6,
    )
}

/// Slopes of the logarithms over the freedoms by least squares.
fn exponents(rows: &[Grown]) {
    let slope = |of: &dyn Fn(&Grown) -> f64| {
        let points: Vec<[f64; 2]> = rows
            .iter()
            .map(|row| [(row.freedoms as f64).ln(), of(row).ln()])
            .collect();
        let count = points.len() as f64;
        let [x, y] = [0, 1].map(|k| points.iter().map(|point| point[k]).sum::<f64>() / count);
        let up: f64 = points.iter().map(|point| (point[0] - x) * (point[1] - y)).sum();
        up / points.iter().map(|point| (point[0] - x).powi(2)).sum::<f64>()
    };
    let factors = |row: &Grown| (row.steps + 1) as f64 * row.factorization;
    println!("\nexponents over the freedoms:");
    for (name, value) in [
        ("the whole solve", slope(&|row| row.solve)),
        (
            "all but the factorizations",
            slope(&|row| row.solve - factors(row)),
        ),
        ("assembly", slope(&|row| row.assembly)),
        ("factorization", slope(&|row| row.factorization)),
        ("back-substitution", slope(&|row| row.back_substitution)),
        ("load transfer", slope(&|row| row.load_transfer)),
        ("peak memory", slope(&|row| row.peak_bytes)),
    ] {
        println!("  {name}: {value:.2}");
    }
}

fn one(refine: f64, by_two: bool) -> Grown {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("designs/twist-v2.toml");
    let sets = [
        "film.compression=\"carries\"".to_string(),
        "film.thickness_mm=0.1".to_string(),
        format!("mesh.refine={refine}"),
    ];
    let Loaded { design, .. } = Design::load(&file, &sets).expect("a shipped design");
    let planform = Planform::from_design(&design).expect("an outline");
    let mesh = generate(&design, &planform).expect("a mesh");
    let start = Instant::now();
    let solution = solve(&design, &mesh, None, &Progress::quiet()).expect("an equilibrium");
    let solve = start.elapsed().as_secs_f64();
    let peak_bytes = peak_bytes();

    let wing = Wing::new(&design, &mesh, None).expect("a wing");
    let start = Instant::now();
    let mut equilibrium = Equilibrium::new(&wing.model).expect("a pattern");
    let analysis = start.elapsed().as_secs_f64();
    let (load_transfer, loads) = least(|| wing.loads_on(&solution.state).expect("loads"));
    let mut values = equilibrium.tangent_values().to_vec();
    let (assembly, ()) = least(|| {
        values.fill(0.0);
        wing.model
            .tangent(&equilibrium.pattern, &solution.state, &loads, None, &mut values);
        let residual = wing.model.residual(&equilibrium.pattern, &solution.state, &loads);
        assert!(residual.iter().all(|r| r.is_finite()));
    });
    equilibrium.factorize(&solution.state, &loads).expect("a factor");
    let mut factor = Factor::new(Analysis::of(&wing.model).expect("memory").symbolic);
    let pattern = &equilibrium.pattern;
    let (factorization, _) = least(|| assert!(factor.positive(pattern, equilibrium.tangent_values())));
    let factor_bytes = 8.0 * factor.entries() as f64;
    let by_two = by_two.then(|| {
        factor.spread();
        least(|| assert!(factor.positive(pattern, equilibrium.tangent_values()))).0
    });
    drop(factor);
    let faer = by_faer(&equilibrium);
    let mut right = vec![1.0; equilibrium.pattern.len()];
    let (back_substitution, ()) = least(|| equilibrium.solve_tangent(&mut right, 1));
    Grown {
        freedoms: solution.report.dof,
        steps: solution.report.newton_steps,
        solve,
        analysis,
        assembly,
        factorization,
        faer,
        back_substitution,
        load_transfer,
        peak_bytes,
        factor_bytes,
        by_two,
    }
}

/// The least of some runs, s, and what the last gave: as many as fit into a second, three at least.
fn least<T>(mut run: impl FnMut() -> T) -> (f64, T) {
    let mut best = f64::INFINITY;
    let began = Instant::now();
    let mut count = 0;
    loop {
        let start = Instant::now();
        let found = run();
        best = best.min(start.elapsed().as_secs_f64());
        count += 1;
        if count >= 3 && (began.elapsed().as_secs_f64() > 1.0 || count >= 50) {
            return (best, found);
        }
    }
}

/// The numeric factorization as faer makes it, analysed and ordered by itself, of the same matrix.
fn by_faer(equilibrium: &Equilibrium) -> f64 {
    faer::set_global_parallelism(Par::Seq);
    let pattern = equilibrium.pattern.symbolic().to_owned().expect("memory");
    let matrix = SparseColMat::new(pattern, equilibrium.tangent_values().to_vec());
    let symbolic = SymbolicLlt::try_new(matrix.symbolic(), Side::Lower).expect("an analysis");
    let run =
        || Llt::try_new_with_symbolic(symbolic.clone(), matrix.as_ref(), Side::Lower).expect("a factor");
    least(run).0
}

/// Largest memory of this process so far, as Linux tells it; 0 elsewhere.
fn peak_bytes() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.trim().trim_end_matches("kB").trim().parse::<f64>().ok());
    1024.0 * kilobytes.unwrap_or(0.0)
}
