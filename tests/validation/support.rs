//! Shipped designs solved and read; cases of shipped measurements compared.

use std::collections::BTreeMap;
use std::path::Path;

use washout::compare::{ComparedRow, compare};
use washout::coupling;
use washout::coupling::solution::Solution;
use washout::geometry::Planform;
use washout::input::design::Design;
use washout::input::measurement::{Channel, Measurement};
use washout::mesh::generate;
use washout::observation::Observer;
use washout::progress::Progress;

/// A solved wing.
pub struct Solved {
    pub design: Design,
    pub planform: Planform,
    pub solution: Solution,
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A shipped design with changes as `--set` has them, solved.
pub fn shipped(name: &str, sets: &[String]) -> Solved {
    let path = root().join("designs").join(format!("{name}.toml"));
    let loaded = Design::load(&path, sets).unwrap_or_else(|error| panic!("{error}"));
    Solved::of(loaded.design)
}

impl Solved {
    pub fn of(design: Design) -> Solved {
        let planform = Planform::from_design(&design).unwrap();
        let mesh = generate(&design, &planform).unwrap();
        let progress = Progress::quiet();
        let solution = coupling::solve(&design, &mesh, None, &progress)
            .unwrap_or_else(|error| panic!("{}: {error}", design.name));
        assert_eq!(solution.report.negative_pivots, 0, "{}", design.name);
        Solved {
            design,
            planform,
            solution,
        }
    }

    pub fn observer(&self) -> Observer<'_> {
        Observer::new(&self.design, &self.planform, &self.solution).unwrap()
    }

    /// Displacement at the middle of the chord, mm, in the frame in which displacements are read.
    pub fn moved_mm(&self, r_m: f64) -> [f64; 3] {
        let moved = self.observer().displacement(r_m, 0.5).unwrap();
        (moved * 1e3).into()
    }

    /// Washout at the tip, deg.
    pub fn tip_twist_deg(&self) -> f64 {
        let tip_m = self.planform.tip_m();
        self.observer().twist(tip_m).unwrap().twist_rad.to_degrees()
    }

    /// The rows of a case of a shipped measurement beside the model.
    pub fn compared(&self, measurement: &str, case: &str) -> Vec<ComparedRow> {
        let path = root().join("measurements").join(format!("{measurement}.csv"));
        let all = Measurement::load(&path).unwrap_or_else(|error| panic!("{error}"));
        let rows = all.case(case);
        assert!(!rows.rows.is_empty(), "{measurement}: no case {case}");
        let comparison = compare(&self.observer(), &rows, &BTreeMap::new());
        assert!(
            comparison.not_compared.is_empty(),
            "{:?}",
            comparison.not_compared
        );
        comparison.rows
    }
}

/// The cases of a shipped measurement whose name starts so.
pub fn cases(measurement: &str, prefix: &str) -> Vec<String> {
    let path = root().join("measurements").join(format!("{measurement}.csv"));
    let all = Measurement::load(&path).unwrap_or_else(|error| panic!("{error}"));
    let found = all.cases().into_iter().filter(|case| case.starts_with(prefix));
    found.map(str::to_string).collect()
}

/// The rows of all cases that start so, each solved at its operating point.
pub fn sweep(
    design: &str,
    measurement: &str,
    prefix: &str,
    sets: impl Fn(&[f64]) -> Vec<String>,
) -> Vec<ComparedRow> {
    let mut rows = Vec::new();
    for case in cases(measurement, prefix) {
        let numbers: Vec<f64> = case.split('-').filter_map(|part| part.parse().ok()).collect();
        rows.extend(shipped(design, &sets(&numbers)).compared(measurement, &case));
    }
    rows
}

/// What hangs a mass at the tip of a Pazy wing, that far behind its leading edge.
pub fn hung(kg: f64, offset_mm: f64) -> Vec<String> {
    vec![
        format!("load[0].mass_kg={kg}"),
        format!("load[0].chord_offset_mm={offset_mm}"),
    ]
}

/// The same at mid-chord.
pub fn bending(numbers: &[f64]) -> Vec<String> {
    hung(numbers[0], 49.45)
}

/// Bias and root mean square of the errors (measured minus modelled) of one channel, and the latter with the weighted
/// mean of the errors taken off, as the zero of a ruler would.
pub fn misfit(rows: &[ComparedRow], channel: Channel, run: &str) -> [f64; 3] {
    let of: Vec<&ComparedRow> = rows
        .iter()
        .filter(|row| row.channel == channel && row.run.starts_with(run))
        .collect();
    let count = of.len() as f64;
    assert!(count > 0.0);
    let weights: f64 = of.iter().map(|row| row.sigma.powi(-2)).sum();
    let zero = of.iter().map(|row| row.error * row.sigma.powi(-2)).sum::<f64>() / weights;
    let rms = |zero: f64| (of.iter().map(|row| (row.error - zero).powi(2)).sum::<f64>() / count).sqrt();
    let bias = of.iter().map(|row| row.error).sum::<f64>() / count;
    [bias, rms(0.0), rms(zero)]
}

/// Fails where a figure has moved by more than 2 % (or 0.02 of its unit) from what stands here.
pub fn stands(name: &str, found: [f64; 3], expected: [f64; 3]) {
    println!("{name}: {found:.3?}");
    for (found, expected) in found.into_iter().zip(expected) {
        let slack = (0.02 * f64::abs(expected)).max(0.02);
        assert!(
            (found - expected).abs() <= slack,
            "{name}: {found} was {expected}"
        );
    }
}

/// Fails where a figure is off by more than `share` of the reference.
pub fn near(name: &str, found: f64, reference: f64, share: f64) {
    println!("{name}: {found:.5}, reference {reference:.5}");
    assert!(
        (found - reference).abs() <= share * reference.abs(),
        "{name}: {found}, reference {reference}"
    );
}
