//! The evolving population on fronts that are known: ZDT (Zitzler, Deb & Thiele 2000) and DTLZ (Deb et al. 2002).

use std::f64::consts::{FRAC_PI_2, PI};

use washout::explore::nsga2::{Evaluation, Individual, Nsga2, Problem};
use washout::explore::{hypervolume, non_dominated};
use washout::progress::Progress;

struct Known {
    variables: usize,
    bounds: [f64; 2],
    objectives: fn(&[f64]) -> Vec<f64>,
}

impl Problem for Known {
    fn bounds(&self) -> Vec<[f64; 2]> {
        let mut bounds = vec![self.bounds; self.variables];
        bounds[0] = [0.0, 1.0];
        bounds
    }

    fn evaluate(&self, variables: &[f64]) -> Evaluation {
        Evaluation {
            objectives: (self.objectives)(variables),
            violation: 0.0,
        }
    }
}

fn zdt_g(x: &[f64]) -> f64 {
    1.0 + 9.0 * x[1..].iter().sum::<f64>() / (x.len() - 1) as f64
}

fn zdt1(x: &[f64]) -> Vec<f64> {
    let g = zdt_g(x);
    vec![x[0], g * (1.0 - (x[0] / g).sqrt())]
}

fn zdt2(x: &[f64]) -> Vec<f64> {
    let g = zdt_g(x);
    vec![x[0], g * (1.0 - (x[0] / g).powi(2))]
}

fn zdt3(x: &[f64]) -> Vec<f64> {
    let g = zdt_g(x);
    let share = x[0] / g;
    vec![x[0], g * (1.0 - share.sqrt() - share * (10.0 * PI * x[0]).sin())]
}

fn zdt6(x: &[f64]) -> Vec<f64> {
    let first = 1.0 - (-4.0 * x[0]).exp() * (6.0 * PI * x[0]).sin().powi(6);
    let g = 1.0 + 9.0 * (x[1..].iter().sum::<f64>() / (x.len() - 1) as f64).powf(0.25);
    vec![first, g * (1.0 - (first / g).powi(2))]
}

/// The sphere, with 10 variables of distance.
fn dtlz2(x: &[f64]) -> Vec<f64> {
    let g: f64 = x[2..].iter().map(|x| (x - 0.5).powi(2)).sum();
    let [a, b] = [x[0] * FRAC_PI_2, x[1] * FRAC_PI_2];
    vec![
        (1.0 + g) * a.cos() * b.cos(),
        (1.0 + g) * a.cos() * b.sin(),
        (1.0 + g) * a.sin(),
    ]
}

/// The plane Σ f = ½.
fn dtlz1(x: &[f64]) -> Vec<f64> {
    let rough = |x: &f64| (x - 0.5).powi(2) - (20.0 * PI * (x - 0.5)).cos();
    let g = 100.0 * ((x.len() - 2) as f64 + x[2..].iter().map(rough).sum::<f64>());
    vec![
        0.5 * x[0] * x[1] * (1.0 + g),
        0.5 * x[0] * (1.0 - x[1]) * (1.0 + g),
        0.5 * (1.0 - x[0]) * (1.0 + g),
    ]
}

fn found(problem: &Known, generations: usize, seed: u64) -> Vec<Individual> {
    let algorithm = Nsga2 {
        generations,
        seed,
        ..Nsga2::default()
    };
    algorithm
        .front(problem, &[], &Progress::quiet())
        .expect("a front")
}

/// Area of the found front over that of a fine sampling of the exact one, up to the corner (1.1, 1.1) past its ends.
fn share_of_area(objectives: fn(&[f64]) -> Vec<f64>, variables: usize) -> f64 {
    let problem = Known {
        variables,
        bounds: [0.0, 1.0],
        objectives,
    };
    let pair = |f: &[f64]| [f[0], f[1]];
    let front: Vec<[f64; 2]> = found(&problem, 250, 3)
        .iter()
        .map(|i| pair(&i.evaluation.objectives))
        .collect();
    let exact: Vec<[f64; 2]> = (0..=4000)
        .map(|k| {
            let mut x = vec![0.0; variables];
            x[0] = f64::from(k) / 4000.0;
            pair(&objectives(&x))
        })
        .collect();
    let corner = [1.1, 1.1];
    hypervolume(&front, corner) / hypervolume(&exact, corner)
}

#[test]
fn zdt_fronts_are_found_to_a_percent_of_their_area() {
    for (name, objectives, variables, least) in [
        ("ZDT1", zdt1 as fn(&[f64]) -> Vec<f64>, 30, 0.99),
        ("ZDT2", zdt2, 30, 0.98),
        ("ZDT3", zdt3, 30, 0.99),
        ("ZDT6", zdt6, 10, 0.95),
    ] {
        let share = share_of_area(objectives, variables);
        assert!((least..=1.0005).contains(&share), "{name}: {share}");
    }
}

#[test]
fn dtlz_fronts_of_three_aims_are_reached() {
    let sphere = Known {
        variables: 12,
        bounds: [0.0, 1.0],
        objectives: dtlz2,
    };
    let radii: Vec<f64> = found(&sphere, 250, 1)
        .iter()
        .map(|i| i.evaluation.objectives.iter().map(|f| f * f).sum::<f64>().sqrt())
        .collect();
    let mean = radii.iter().sum::<f64>() / radii.len() as f64;
    assert!(
        radii.len() > 90 && (mean - 1.0).abs() < 0.03,
        "{mean} of {}",
        radii.len()
    );
    let plane = Known {
        variables: 7,
        bounds: [0.0, 1.0],
        objectives: dtlz1,
    };
    let mut sums: Vec<f64> = found(&plane, 600, 1)
        .iter()
        .map(|i| i.evaluation.objectives.iter().sum())
        .collect();
    sums.sort_by(f64::total_cmp);
    assert!((sums[sums.len() / 2] - 0.5).abs() < 0.03, "{sums:?}");
}

#[test]
fn the_same_seed_gives_the_same_front_at_any_number_of_threads_and_another_seed_another() {
    let problem = Known {
        variables: 30,
        bounds: [0.0, 1.0],
        objectives: zdt1,
    };
    let with = |threads: usize, seed: u64| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("threads");
        pool.install(|| found(&problem, 40, seed))
    };
    assert_eq!(with(1, 5), with(4, 5));
    assert_ne!(with(2, 5), with(2, 6));
}

#[test]
fn constraints_hold_on_the_front() {
    struct Constr;
    // Deb et al. 2002: f = (x, (1 + y)/x) with y + 9x ≥ 6, −y + 9x ≥ 1
    impl Problem for Constr {
        fn bounds(&self) -> Vec<[f64; 2]> {
            vec![[0.1, 1.0], [0.0, 5.0]]
        }

        fn evaluate(&self, v: &[f64]) -> Evaluation {
            let [x, y] = [v[0], v[1]];
            Evaluation {
                objectives: vec![x, (1.0 + y) / x],
                violation: (6.0 - y - 9.0 * x).max(0.0) + (1.0 + y - 9.0 * x).max(0.0),
            }
        }
    }
    let front = Nsga2::default()
        .front(&Constr, &[], &Progress::quiet())
        .expect("a front");
    assert!(front.len() > 90);
    // the exact front: y = max(0, 6 − 9x), which begins at x = 7/18
    let exact: Vec<[f64; 2]> = (0..=4000)
        .map(|k| 7.0 / 18.0 + 11.0 / 18.0 * f64::from(k) / 4000.0)
        .map(|x| [x, (1.0 + (6.0 - 9.0 * x).max(0.0)) / x])
        .collect();
    let found: Vec<[f64; 2]> = front
        .iter()
        .map(|i| [i.evaluation.objectives[0], i.evaluation.objectives[1]])
        .collect();
    assert!(front.iter().all(|i| i.variables[0] > 7.0 / 18.0 - 1e-3));
    let share = hypervolume(&found, [1.1, 10.0]) / hypervolume(&exact, [1.1, 10.0]);
    assert!((0.99..=1.0005).contains(&share), "{share}");
}

#[test]
fn hypervolume_of_steps_is_their_area_and_dominated_points_add_nothing() {
    let points = [[0.0, 2.0], [1.0, 1.0], [2.0, 0.0], [1.5, 1.5], [9.0, 9.0]];
    assert!((hypervolume(&points, [3.0, 3.0]) - 6.0).abs() < 1e-12);
    assert_eq!(hypervolume(&[], [1.0, 1.0]), 0.0);
    let many: Vec<Vec<f64>> = points.iter().map(|p| p.to_vec()).collect();
    assert_eq!(non_dominated(&many), [0, 1, 2]);
}
