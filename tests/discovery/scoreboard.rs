//! Many cases judged at once: the figures by which a diagnosis is measured.

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use washout::diagnose::{Diagnosis, Settings, Verdict, diagnose};
use washout::progress::Progress;

use crate::cases::{Case, Kind, case};
use crate::truth::Hidden;

/// A case with what was said of it.
pub struct Outcome {
    pub case: Case,
    pub said: Diagnosis,
}

/// A share with its count.
#[derive(Debug, Clone, Copy, Default)]
pub struct Share {
    pub hits: usize,
    pub count: usize,
}

impl Share {
    pub fn of(flags: impl Iterator<Item = bool>) -> Share {
        flags.fold(Share::default(), |share, hit| Share {
            hits: share.hits + usize::from(hit),
            count: share.count + 1,
        })
    }

    pub fn value(&self) -> f64 {
        self.hits as f64 / self.count.max(1) as f64
    }
}

impl std::fmt::Display for Share {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            formatter,
            "{}/{} = {:.1} %",
            self.hits,
            self.count,
            100.0 * self.value()
        )
    }
}

/// Diagnoses `count` cases of `kind` from `seed` on.
pub fn run(kind: Kind, seed: u64, count: u64, settings: &Settings) -> Vec<Outcome> {
    (seed..seed + count)
        .into_par_iter()
        .map(|seed| {
            let case = case(kind, seed);
            let said = diagnose(&case.toy, settings, &Progress::quiet()).expect("a diagnosis");
            Outcome { case, said }
        })
        .collect()
}

impl Outcome {
    pub fn is_alarm(&self) -> bool {
        !matches!(self.said.verdict, Verdict::Nothing | Verdict::Undecidable)
    }

    fn same(&self, families: &[String]) -> bool {
        let mut said: Vec<&str> = families.iter().map(String::as_str).collect();
        let mut truth = self.case.families.clone();
        said.sort_unstable();
        truth.sort_unstable();
        said == truth
    }

    pub fn is_named_right(&self) -> bool {
        self.same(&self.said.hypotheses[0].families)
    }

    pub fn truth_in_set(&self) -> bool {
        self.said
            .hypotheses
            .iter()
            .any(|h| h.in_set && self.same(&h.families) && !h.effects.contains(&"novel".into()))
    }

    /// Whether both of a pair are 5 sigma from none and 3 sigma from each other.
    pub fn is_clear_pair(&self) -> bool {
        let at = |which: usize| {
            let strength = match self.case.nature.hidden[which] {
                Hidden::Known(_, strength) | Hidden::Damage(_, strength) => strength,
                _ => 0.0,
            };
            let own = self
                .said
                .effects
                .iter()
                .filter(|row| row.family == self.case.families[which]);
            let row = own
                .max_by(|a, b| a.score.abs().total_cmp(&b.score.abs()))
                .expect("the true effect");
            ((strength / row.scale * row.detectability).abs(), row)
        };
        let ((first, row), (second, other)) = (at(0), at(1));
        let cosine = row
            .look_alikes
            .iter()
            .find(|l| l.effect == other.effect)
            .map_or(0.0, |l| l.cosine);
        first.min(second) >= 5.0 && first.min(second) * (1.0 - cosine * cosine).sqrt() >= 3.0
    }

    pub fn novel_in_set(&self) -> bool {
        self.said.verdict == Verdict::Novel
            || self
                .said
                .hypotheses
                .iter()
                .any(|h| h.in_set && h.effects == ["novel"])
    }

    pub fn set_size(&self) -> usize {
        self.said.hypotheses.iter().filter(|h| h.in_set).count()
    }

    /// Detectability (squared distance) and separation from the nearest rival at the true strength.
    pub fn truth_at(&self) -> (f64, f64) {
        let strength = match self.case.nature.hidden[0] {
            Hidden::Known(_, strength) | Hidden::Damage(_, strength) => strength,
            _ => 0.0,
        };
        let family = self.case.families[0];
        let own = |row: &&washout::diagnose::effect_row::EffectRow| match self.case.nature.hidden[0] {
            Hidden::Known(name, _) => row.effect == name,
            _ => row.family == family,
        };
        let rows = self.said.effects.iter().filter(own);
        let best = rows
            .max_by(|a, b| a.score.abs().total_cmp(&b.score.abs()))
            .expect("the true effect");
        let distance = (strength / best.scale * best.detectability).abs();
        let cosine = best.look_alikes.first().map_or(0.0, |near| near.cosine);
        (
            distance * distance,
            distance * (1.0 - cosine * cosine).max(0.0).sqrt(),
        )
    }

    /// Held-out error before and after, in units of the noise.
    pub fn held_out(&self) -> Option<[f64; 3]> {
        let rungs = &self.said.ladder;
        let of = |name: &str| rungs.iter().find(|rung| rung.name == name)?.held_out;
        let last = rungs
            .iter()
            .rev()
            .find(|rung| rung.name.starts_with('+'))?
            .held_out?;
        Some([of("calibrated")?, last, of("noise")?])
    }
}

pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Prints the scoreboard.
pub fn print(seed: u64, scale: f64, settings: &Settings, verbose: bool) {
    let count = |cases: u64| ((cases as f64 * scale) as u64).max(2);
    for (kind, name) in [
        (Kind::Null, "null"),
        (Kind::NullQuiet, "null, sigma 30 % short"),
        (Kind::NullOutlier, "null, outlier"),
        (Kind::NullRough, "null, background doubled"),
    ] {
        let outcomes = run(kind, seed, count(50), settings);
        println!(
            "{name}: false alarms {}",
            Share::of(outcomes.iter().map(Outcome::is_alarm))
        );
        list(&outcomes, verbose, &|o| o.is_alarm());
    }
    let mut beliefs: Vec<(f64, bool)> = Vec::new();
    singles(seed, count(60), settings, verbose, &mut beliefs);
    pairs(seed, count(30), settings, verbose, &mut beliefs);
    novels(seed, count(30), settings, verbose, &mut beliefs);
    twins(seed, count(20), settings, verbose);
    calibration(&beliefs);
}

fn list(outcomes: &[Outcome], verbose: bool, which: &dyn Fn(&Outcome) -> bool) {
    for outcome in outcomes.iter().filter(|o| verbose && which(o)) {
        let said = &outcome.said;
        let set: Vec<String> = said
            .hypotheses
            .iter()
            .filter(|h| h.in_set)
            .take(5)
            .map(|h| {
                format!(
                    "{:?} {:.2}",
                    h.families
                        .first()
                        .map_or(h.effects.first(), |_| Some(&h.effects[0]))
                        .map_or("nothing".into(), |_| h.effects.join("+")),
                    h.probability
                )
            })
            .collect();
        println!(
            "   seed {} {:?} other {} s {:.2} Q {:.0} P(nothing) {:.4}, formulation {:.4}: {:?} {}",
            outcome.case.seed,
            outcome.case.nature.hidden,
            outcome.case.nature.other_formulas,
            said.noise.scale,
            said.misfit.q,
            said.p_nothing,
            said.noise.formulation,
            said.verdict,
            set.join(", ")
        );
    }
}

fn believe(outcomes: &[Outcome], beliefs: &mut Vec<(f64, bool)>) {
    for outcome in outcomes.iter().filter(|o| o.is_alarm()) {
        let first = &outcome.said.hypotheses[0];
        let truth = &outcome.case.families;
        let stated = |name: &&str| first.families.iter().any(|f| f == name);
        let right = if truth.is_empty() {
            first.effects == ["novel"]
        } else {
            let named = first.families.iter().all(|f| truth.contains(&f.as_str()));
            named && !first.families.is_empty() && truth.iter().all(stated)
        };
        beliefs.push((first.probability, right));
    }
}

fn singles(seed: u64, count: u64, settings: &Settings, verbose: bool, beliefs: &mut Vec<(f64, bool)>) {
    let outcomes = run(Kind::Single, seed, count, settings);
    let clear = |o: &&Outcome| {
        let (ncp, apart) = o.truth_at();
        ncp >= 25.0 && apart >= 3.0
    };
    let seen: Vec<&Outcome> = outcomes.iter().filter(|o| o.is_alarm()).collect();
    println!(
        "single: seen {}",
        Share::of(outcomes.iter().map(Outcome::is_alarm))
    );
    println!(
        "   named right, where seen {}",
        Share::of(seen.iter().map(|o| o.is_named_right()))
    );
    println!(
        "   named right, detectable and separable {}",
        Share::of(outcomes.iter().filter(clear).map(Outcome::is_named_right))
    );
    println!(
        "   truth in the set, where seen {}",
        Share::of(seen.iter().map(|o| o.truth_in_set()))
    );
    println!(
        "   mean size of the set {:.2}",
        seen.iter().map(|o| o.set_size() as f64).sum::<f64>() / seen.len() as f64
    );
    println!(
        "   verdict effect {}, of these right {}",
        Share::of(seen.iter().map(|o| o.said.verdict == Verdict::Effect)),
        Share::of(
            seen.iter()
                .filter(|o| o.said.verdict == Verdict::Effect)
                .map(|o| o.is_named_right())
        )
    );
    println!(
        "   falsely novel {}",
        Share::of(seen.iter().map(|o| o.said.verdict == Verdict::Novel))
    );
    let right: Vec<&&Outcome> = seen.iter().filter(|o| o.is_named_right()).collect();
    let errors: Vec<[f64; 2]> = right
        .iter()
        .filter_map(|o| match o.case.nature.hidden[0] {
            Hidden::Known(name, strength) => {
                let found = o.said.hypotheses[0].strengths.iter().find(|s| s.effect == name)?;
                Some([
                    (found.value - strength).abs() / strength.abs(),
                    (found.value - strength).abs() / found.standard_error,
                ])
            }
            _ => None,
        })
        .collect();
    println!(
        "   strength: median error {:.1} %, within 2 sigma {}",
        100.0 * median(errors.iter().map(|e| e[0]).collect()),
        Share::of(errors.iter().map(|e| e[1] < 2.0))
    );
    let falls: Vec<[f64; 3]> = right.iter().filter_map(|o| o.held_out()).collect();
    println!(
        "   held out: error falls {:.2}-fold (median), to {:.2} noise, worse {}",
        median(falls.iter().map(|f| f[0] / f[1]).collect()),
        median(falls.iter().map(|f| f[1] / f[2]).collect()),
        Share::of(falls.iter().map(|f| f[1] > f[0]))
    );
    list(&outcomes, verbose, &|o| {
        o.is_alarm() && (!o.is_named_right() || o.said.verdict == Verdict::Novel)
    });
    believe(&outcomes, beliefs);
}

fn pairs(seed: u64, count: u64, settings: &Settings, verbose: bool, beliefs: &mut Vec<(f64, bool)>) {
    let outcomes = run(Kind::Pair, seed, count, settings);
    let seen: Vec<&Outcome> = outcomes.iter().filter(|o| o.is_alarm()).collect();
    let dominant = |o: &&Outcome| {
        o.said
            .hypotheses
            .iter()
            .find(|h| !h.families.is_empty())
            .is_some_and(|h| h.families.iter().any(|f| o.case.families.contains(&f.as_str())))
    };
    println!("pair: seen {}", Share::of(outcomes.iter().map(Outcome::is_alarm)));
    println!("   one of the two right {}", Share::of(seen.iter().map(dominant)));
    println!(
        "   both right {}",
        Share::of(seen.iter().map(|o| o.is_named_right()))
    );
    println!(
        "   truth in the set {}",
        Share::of(seen.iter().map(|o| o.truth_in_set()))
    );
    println!(
        "   mean size of the set {:.2}",
        seen.iter().map(|o| o.set_size() as f64).sum::<f64>() / seen.len() as f64
    );
    let clear: Vec<&&Outcome> = seen.iter().filter(|o| o.is_clear_pair()).collect();
    println!(
        "   both clear: one of the two right {}, both right {}, in the set {}",
        Share::of(clear.iter().map(|o| dominant(o))),
        Share::of(clear.iter().map(|o| o.is_named_right())),
        Share::of(clear.iter().map(|o| o.truth_in_set()))
    );
    println!(
        "   verdict novel {}",
        Share::of(seen.iter().map(|o| o.said.verdict == Verdict::Novel))
    );
    list(&outcomes, verbose, &|o| o.is_alarm() && !o.is_named_right());
    believe(&outcomes, beliefs);
}

fn novels(seed: u64, count: u64, settings: &Settings, verbose: bool, beliefs: &mut Vec<(f64, bool)>) {
    let outcomes = run(Kind::Novel, seed, count, settings);
    let strong: Vec<&Outcome> = outcomes
        .iter()
        .filter(|o| o.said.misfit.q > 90.0 + 100.0)
        .collect();
    println!(
        "novel: seen {}",
        Share::of(outcomes.iter().map(Outcome::is_alarm))
    );
    println!(
        "   recognised, misfit over 10 sigma {}",
        Share::of(strong.iter().map(|o| o.said.verdict == Verdict::Novel))
    );
    println!(
        "   in the set, where seen {}",
        Share::of(
            outcomes
                .iter()
                .filter(|o| o.is_alarm())
                .map(Outcome::novel_in_set)
        )
    );
    let bumps: Vec<[f64; 3]> = strong
        .iter()
        .filter_map(|o| {
            let Hidden::Bump(place, _, [a, b]) = o.case.nature.hidden[0] else {
                return None;
            };
            let found = o.said.novel.reconstruction.as_ref()?;
            let scaling = found.scaling?;
            Some([
                (found.field[0].centroid - place).abs(),
                (scaling.frequency[0] - a).abs(),
                (scaling.amplitude[0] - b).abs(),
            ])
        })
        .collect();
    println!(
        "   centroid within 0.1 {}, powers within 0.5: f {} phi {}",
        Share::of(bumps.iter().map(|b| b[0] < 0.1)),
        Share::of(bumps.iter().map(|b| b[1] < 0.5)),
        Share::of(bumps.iter().map(|b| b[2] < 0.5))
    );
    list(&outcomes, verbose, &|o| {
        o.is_alarm() && o.said.verdict != Verdict::Novel
    });
    believe(&outcomes, beliefs);
}

fn twins(seed: u64, count: u64, settings: &Settings, verbose: bool) {
    let outcomes = run(Kind::Twin, seed, count, settings);
    let seen: Vec<&Outcome> = outcomes.iter().filter(|o| o.is_alarm()).collect();
    let modest = |o: &&Outcome| o.said.hypotheses[0].probability < 0.8;
    println!("twin: seen {}", Share::of(outcomes.iter().map(Outcome::is_alarm)));
    println!(
        "   none at 0.8 or more {}, truth in the set {}",
        Share::of(seen.iter().map(modest)),
        Share::of(seen.iter().map(|o| o.truth_in_set()))
    );
    list(&outcomes, verbose, &|o| o.is_alarm());
}

fn calibration(beliefs: &[(f64, bool)]) {
    let mut error = 0.0;
    for bin in 0..5 {
        let (low, high) = (f64::from(bin) * 0.2, f64::from(bin + 1) * 0.2);
        let own: Vec<&(f64, bool)> = beliefs
            .iter()
            .filter(|b| b.0 >= low && (b.0 < high || bin == 4))
            .collect();
        if own.is_empty() {
            continue;
        }
        let stated = own.iter().map(|b| b.0).sum::<f64>() / own.len() as f64;
        let right = Share::of(own.iter().map(|b| b.1));
        error += (stated - right.value()).abs() * own.len() as f64 / beliefs.len() as f64;
        println!("   stated {stated:.2}: right {right}");
    }
    println!("calibration error {error:.3}");
}
