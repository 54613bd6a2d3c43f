//! Stages of a twist profile: a continuous piecewise-linear fit whose number of stages the data choose.
//!
//! Stages are told apart by one of two rules, in which p counts start value (unless anchored), rates and breaks:
//!
//! - measured points, F-test: a fit with more stages is taken if F = ((RSS_few − RSS_more)/Δp) / (RSS_more/(n − p))
//!   is significant at 0.2 %. Breaks are searched, so the true rate of one stage too many is higher: 0.2 to 1.3 % on
//!   straight or two-stage profiles of 10 to 60 noisy points;
//! - a model's curve has no noise, so there is no level to test at: least BIC = n ln s² + p ln n with
//!   s² = max(RSS/n, resolution²). Once a fit follows the curve within the resolution (0.5 deg, half of what a camera
//!   tells apart) a further stage buys nothing.
//!
//! Standard errors come from the Jacobian (rates and breaks together), s² = RSS/(n − p). Two of them cover the
//! truth in 94 % of cases where the break is known to a fraction of the distance between points, in about 91 %
//! where it is known no better than that distance.

use statrs::distribution::{ContinuousCDF, FisherSnedecor};

use super::broken_line::{self, BrokenLine};

/// Angle per length, from rad/m to deg/mm.
pub const DEG_PER_MM: f64 = 180.0 / std::f64::consts::PI / 1000.0;

/// Settings of a stage fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StageSettings {
    /// Largest number of stages tried.
    pub most_stages: usize,
    /// Fewest points on each stage; a point on a break counts once.
    pub min_points: usize,
    /// Rule by which the number of stages is chosen.
    pub rule: StageRule,
    /// Whether the points are read off a model's smooth curve or were measured.
    pub source: PointSource,
}

/// How the number of stages is chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StageRule {
    /// Another stage if the F-test of its gain is significant at this level.
    FTest {
        /// The level.
        significance: f64,
    },
    /// The least Bayesian information criterion.
    Bic {
        /// Root mean square residual below which nothing is gained any more, rad.
        resolution_rad: f64,
    },
}

/// Where the points of a fit come from; decides what its standard errors mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PointSource {
    /// Read with independent errors: the standard error is the usual one.
    Measured,
    /// Free of noise: the scatter is the curve's distance from a broken line.
    Modelled,
}

impl PointSource {
    /// What the standard errors of a fit mean, in one sentence.
    pub fn meaning_of_errors(self) -> &'static str {
        match self {
            PointSource::Measured => "standard errors from the scatter of the readings about the broken line",
            PointSource::Modelled => {
                "the model curve has no noise: the errors say how far it is from a broken line, not how sure it is"
            }
        }
    }
}

impl StageSettings {
    /// For points read off a model's curve.
    pub const MODELLED: StageSettings = StageSettings {
        most_stages: 4,
        min_points: 2,
        rule: StageRule::Bic {
            resolution_rad: 0.5 * std::f64::consts::PI / 180.0,
        },
        source: PointSource::Modelled,
    };

    /// For points that were measured.
    pub const MEASURED: StageSettings = StageSettings {
        min_points: 3,
        rule: StageRule::FTest { significance: 0.002 },
        source: PointSource::Measured,
        ..StageSettings::MODELLED
    };
}

impl Default for StageSettings {
    fn default() -> Self {
        StageSettings::MODELLED
    }
}

/// A twist profile as stages of constant rate.
#[derive(Debug, Clone, PartialEq)]
pub struct StageFit {
    /// The stages, from base to tip.
    pub stages: Vec<Stage>,
    /// Twist where the first stage starts, rad.
    pub start_twist_rad: f64,
    /// Standard error of each break, m; none where the points do not fix it.
    pub break_error_m: Vec<Option<f64>>,
    /// Root of RSS/(n − p), rad; none where as many parameters as points were fitted.
    pub scatter_rad: Option<f64>,
    /// Number of points fitted, without the anchor.
    pub points: usize,
    /// Whether the line was made to pass the base exactly.
    pub anchored: bool,
    /// Every number of stages that was tried, and what it gained.
    pub trials: Vec<StageTrial>,
    /// Where the points come from.
    pub source: PointSource,
    line: BrokenLine,
}

/// One stage: constant twist rate between two places.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stage {
    /// Where it starts, m from the wing base.
    pub from_m: f64,
    /// Where it ends: the next break, or the last point.
    pub to_m: f64,
    /// Twist rate, rad/m.
    pub rate_rad_per_m: f64,
    /// Its standard error, rad/m; none where the points do not fix it.
    pub rate_error_rad_per_m: Option<f64>,
}

/// One number of stages that was tried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StageTrial {
    /// Number of stages.
    pub stages: usize,
    /// Root mean square residual, rad.
    pub rms_rad: f64,
    /// Whether it was taken over the fits with fewer stages.
    pub is_taken: bool,
}

impl StageFit {
    /// Twist of the fitted line at `r_m`, rad.
    pub fn twist_rad(&self, r_m: f64) -> f64 {
        self.line.value(r_m)
    }

    /// Places of the breaks, m from the wing base.
    pub fn breaks_m(&self) -> &[f64] {
        &self.line.breaks
    }
}

/// Fit of stages to points `[r_m, twist_rad]`, r rising; `base` is a place `[r_m, twist_rad]` that the line
/// passes exactly (the clamp). None with fewer than two points (one with a base), or points out of order.
///
/// # Example
/// ```
/// # use washout_wing as washout;
/// use washout::observation::{StageSettings, fit_stages};
///
/// // 0.1 deg/mm up to 40 mm, then 0.3 deg/mm
/// let twist_rad = |r_m: f64| (100.0 * r_m + 200.0 * (r_m - 0.04).max(0.0)).to_radians();
/// let points: Vec<[f64; 2]> = (1..=14).map(|i| 5e-3 * f64::from(i)).map(|r_m| [r_m, twist_rad(r_m)]).collect();
/// let fit = fit_stages(&points, Some([0.0, 0.0]), StageSettings::MODELLED).unwrap();
/// assert_eq!(fit.stages.len(), 2);
/// assert!((fit.breaks_m()[0] - 0.04).abs() < 1e-3);
/// ```
pub fn fit_stages(points: &[[f64; 2]], base: Option<[f64; 2]>, settings: StageSettings) -> Option<StageFit> {
    let anchored = base.is_some();
    let spare = |stages: usize| points.len().checked_sub(BrokenLine::parameters(stages, anchored));
    let mut held = broken_line::fit(points, base, 1, settings.min_points.min(points.len()))?;
    spare(1)?;
    let trial = |line: &BrokenLine, is_taken: bool| StageTrial {
        stages: line.rates.len(),
        rms_rad: (line.rss / points.len() as f64).sqrt(),
        is_taken,
    };
    let mut trials = vec![trial(&held, true)];
    for stages in 2..=settings.most_stages {
        if spare(stages).is_none_or(|free| free == 0) {
            break;
        }
        let Some(more) = broken_line::fit(points, base, stages, settings.min_points) else {
            break;
        };
        let is_taken = settings.rule.prefers(&more, &held, points.len(), anchored);
        trials.push(trial(&more, is_taken));
        if is_taken {
            held = more;
        }
    }
    Some(summarise(held, points, anchored, trials, settings.source))
}

impl StageRule {
    /// Whether `more` pieces are worth their parameters over `few`, both fitted to `points` points.
    fn prefers(self, more: &BrokenLine, few: &BrokenLine, points: usize, anchored: bool) -> bool {
        let parameters = |line: &BrokenLine| BrokenLine::parameters(line.rates.len(), anchored);
        let (many, less) = (parameters(more), parameters(few));
        match self {
            StageRule::FTest { significance } => {
                let (added, free) = ((many - less) as f64, (points - many) as f64);
                let gain = (few.rss - more.rss) / added / (more.rss / free).max(f64::MIN_POSITIVE);
                let law = FisherSnedecor::new(added, free);
                gain > 0.0 && law.is_ok_and(|law| !gain.is_finite() || law.sf(gain) < significance)
            }
            StageRule::Bic { resolution_rad } => {
                let count = points as f64;
                let bic = |line: &BrokenLine, parameters: usize| {
                    let variance = (line.rss / count).max(resolution_rad.powi(2));
                    count * variance.ln() + parameters as f64 * count.ln()
                };
                bic(more, many) < bic(few, less)
            }
        }
    }
}

fn summarise(
    line: BrokenLine,
    points: &[[f64; 2]],
    anchored: bool,
    trials: Vec<StageTrial>,
    source: PointSource,
) -> StageFit {
    let count = line.rates.len();
    let free = points.len() - BrokenLine::parameters(count, anchored);
    let scatter_rad = (free > 0).then(|| (line.rss / free as f64).sqrt());
    let first = usize::from(!anchored);
    let error = |parameter: usize| {
        let variance = line.unit_variance.as_ref()?[parameter];
        Some(scatter_rad? * variance.sqrt())
    };
    let mut places = vec![line.start_x];
    places.extend(&line.breaks);
    places.push(points[points.len() - 1][0]);
    let stages = (0..count)
        .map(|k| Stage {
            from_m: places[k],
            to_m: places[k + 1],
            rate_rad_per_m: line.rates[k],
            rate_error_rad_per_m: error(first + k),
        })
        .collect();
    StageFit {
        stages,
        start_twist_rad: line.start_y,
        break_error_m: (0..count - 1).map(|bend| error(first + count + bend)).collect(),
        scatter_rad,
        points: points.len(),
        anchored,
        trials,
        source,
        line,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Normal deviates from a fixed seed (splitmix64 and the sum of twelve uniforms).
    struct Noise(u64);

    impl Noise {
        fn next(&mut self) -> f64 {
            let uniform = || {
                self.0 = self.0.wrapping_add(0x9e3779b97f4a7c15);
                let mut z = self.0;
                z = (z ^ (z >> 30)).wrapping_mul(0xbf58476d1ce4e5b9);
                z = (z ^ (z >> 27)).wrapping_mul(0x94d049bb133111eb);
                ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
            };
            std::iter::repeat_with(uniform).take(12).sum::<f64>() - 6.0
        }
    }

    fn broken_twist_rad(r_mm: f64, stages: &[(f64, f64)]) -> f64 {
        let mut from = 0.0;
        let mut twist_deg = 0.0;
        for (to, rate) in stages {
            twist_deg += rate * (r_mm.min(*to) - from).max(0.0);
            from = *to;
        }
        twist_deg.to_radians()
    }

    fn profile(count: usize, stages: &[(f64, f64)]) -> Vec<[f64; 2]> {
        (1..=count)
            .map(|k| 70.0 * k as f64 / count as f64)
            .map(|r_mm| [r_mm / 1000.0, broken_twist_rad(r_mm, stages)])
            .collect()
    }

    #[test]
    fn the_two_stages_of_twist_v1_come_back_from_points_on_its_profile() {
        let points = profile(14, &[(48.0, 0.29), (70.0, 1.39)]);
        for base in [None, Some([0.0, 0.0])] {
            let fit = fit_stages(&points, base, StageSettings::default()).unwrap();
            assert_eq!(fit.stages.len(), 2, "{fit:?}");
            assert!((fit.stages[0].rate_rad_per_m * DEG_PER_MM - 0.29).abs() < 1e-9);
            assert!((fit.stages[1].rate_rad_per_m * DEG_PER_MM - 1.39).abs() < 1e-9);
            assert!((fit.breaks_m()[0] - 0.048).abs() < 1e-9);
            assert!((fit.twist_rad(0.070).to_degrees() - 44.5).abs() < 1e-9);
        }
    }

    #[test]
    fn one_two_three_and_four_stages_are_told_apart_without_noise() {
        let truth: [&[(f64, f64)]; 4] = [
            &[(70.0, 0.5)],
            &[(20.0, 0.0), (70.0, 0.46)],
            &[(20.0, 0.1), (45.0, 0.9), (70.0, 0.3)],
            &[(15.0, 0.1), (33.0, 0.9), (52.0, 0.2), (70.0, 1.1)],
        ];
        for stages in truth {
            let fit = fit_stages(&profile(28, stages), None, StageSettings::default()).unwrap();
            assert_eq!(fit.stages.len(), stages.len(), "{fit:?}");
            for (found, (to, rate)) in fit.stages.iter().zip(stages) {
                assert!((found.rate_rad_per_m * DEG_PER_MM - rate).abs() < 1e-8, "{fit:?}");
                assert!((found.to_m * 1000.0 - to).abs() < 1e-6, "{fit:?}");
            }
        }
    }

    #[test]
    fn two_standard_errors_cover_rates_and_break_of_noisy_profiles_as_often_as_they_should() {
        let (rates, break_mm, trials) = ([0.29, 1.39], 48.0, 1000);
        let clean = profile(24, &[(break_mm, rates[0]), (70.0, rates[1])]);
        let mut noise = Noise(7);
        let (mut right_count, mut covered) = (0, [0usize; 3]);
        for _ in 0..trials {
            let noisy: Vec<[f64; 2]> = clean
                .iter()
                .map(|[r, twist]| [*r, twist + 0.3f64.to_radians() * noise.next()])
                .collect();
            let fit = fit_stages(&noisy, None, StageSettings::MEASURED).unwrap();
            if fit.stages.len() != 2 {
                continue;
            }
            right_count += 1;
            for (k, stage) in fit.stages.iter().enumerate() {
                let miss = (stage.rate_rad_per_m - rates[k] / DEG_PER_MM).abs();
                covered[k] += usize::from(miss <= 2.0 * stage.rate_error_rad_per_m.unwrap());
            }
            let miss = (fit.breaks_m()[0] - break_mm / 1000.0).abs();
            covered[2] += usize::from(miss <= 2.0 * fit.break_error_m[0].unwrap());
        }
        assert!(
            right_count >= 985,
            "{right_count} of {trials} fits have two stages"
        );
        for count in covered {
            let share = count as f64 / right_count as f64;
            assert!(
                (0.915..=0.965).contains(&share),
                "coverage {share} ({covered:?} of {right_count})"
            );
        }
    }

    #[test]
    fn a_straight_noisy_profile_is_seldom_split() {
        let clean = profile(20, &[(70.0, 0.5)]);
        let mut noise = Noise(11);
        let split = (0..400)
            .filter(|_| {
                let noisy: Vec<[f64; 2]> = clean
                    .iter()
                    .map(|[r, twist]| [*r, twist + 0.01 * noise.next()])
                    .collect();
                fit_stages(&noisy, None, StageSettings::MEASURED)
                    .unwrap()
                    .stages
                    .len()
                    > 1
            })
            .count();
        assert!(split <= 6, "{split} of 400 straight profiles were split");
    }

    #[test]
    fn a_smooth_model_curve_says_that_its_errors_are_not_noise() {
        // A uniform rod's parabola at the base, five spar ends and the tip: 9.6 deg at the tip.
        let points = [2.8, 18.9, 35.0, 51.1, 67.2, 67.9].map(|r_mm: f64| {
            [
                r_mm / 1e3,
                9.6f64.to_radians() * (1.0 - (1.0 - r_mm / 70.0).powi(2)),
            ]
        });
        let fit = fit_stages(&points, Some([0.0, 0.0]), StageSettings::MODELLED).unwrap();
        assert_eq!(fit.stages.len(), 2, "{fit:?}");
        assert!(fit.stages[0].rate_rad_per_m > 2.0 * fit.stages[1].rate_rad_per_m);
        assert!(fit.scatter_rad.unwrap() > 0.0);
        assert!(fit.source.meaning_of_errors().contains("not how sure it is"));
        assert!(
            fit.stages
                .iter()
                .all(|stage| stage.rate_error_rad_per_m.is_none_or(f64::is_finite))
        );
    }

    #[test]
    fn too_few_points_give_no_fit_and_two_give_a_line_without_errors() {
        assert!(fit_stages(&[[0.01, 0.1]], None, StageSettings::default()).is_none());
        assert!(fit_stages(&[], Some([0.0, 0.0]), StageSettings::default()).is_none());
        let fit = fit_stages(&[[0.01, 0.1], [0.02, 0.2]], None, StageSettings::default()).unwrap();
        assert_eq!((fit.stages.len(), fit.scatter_rad), (1, None));
        assert!((fit.stages[0].rate_rad_per_m - 10.0).abs() < 1e-12);
    }
}
