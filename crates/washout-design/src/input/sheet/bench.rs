//! The still wing on a bench as a condition of a table: `torque 20 uN m at 62 mm`, or `push 20 mN at 24 mm, 12 mm behind`.

use super::words::{Kind, number_at, unit_at};
use crate::input::design::{BenchLoad, Design};
use crate::input::quantity::Quantity;

/// Frequency of a stroke without air to speak of, Hz: the lowest that a design may have.
pub const STILL_HZ: f64 = 0.1;
/// Speed of a stream without air to speak of, over that of the design.
const STILL_SPEED: f64 = 0.01;
/// How a condition on a bench is written.
pub const FORMS: &str =
    "\"torque 20 uN m at 62 mm\", or \"push 20 mN at 24 mm, 12 mm behind\" the leading edge";
/// Units of force in lower case, longer ones first, N as a quotient; of a weight in grams, with g = 9.80665 m/s² (CGPM, 1901).
const FORCES: [(&str, f64, f64); 5] = [
    ("un", 1.0, 1e6),
    ("mn", 1.0, 1e3),
    ("gf", 9.80665, 1e3),
    ("n", 1.0, 1.0),
    ("g", 9.80665, 1e3),
];
/// Words around the numbers that say nothing of their own.
const AROUND: [&str; 22] = [
    "a", "aft", "at", "behind", "bench", "by", "edge", "from", "its", "leading", "le", "moment", "near",
    "of", "push", "still", "the", "tip", "torque", "under", "weight", "wing",
];
/// Words of those who mean a load on the still wing and do not write it so.
const MEANT: [&str; 9] = [
    "behind", "bench", "force", "hang", "load", "loaded", "mass", "moment", "still",
];

/// Whether a head seems to name a load on the still wing, though not as it is written.
pub fn is_meant(head: &str) -> bool {
    let head = head.to_lowercase();
    head.split(|c: char| !c.is_alphabetic())
        .any(|word| MEANT.contains(&word))
}

/// A load on the still wing; a torque along the span and a push across the wing make washout where they are positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bench {
    /// Where it acts, mm from the wing base.
    pub at_mm: f64,
    /// What acts there.
    pub load: Load,
}

/// What acts on the still wing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Load {
    /// A torque along the span, N·m.
    Torque(f64),
    /// A push across the wing.
    Push {
        /// The force, N.
        force_n: f64,
        /// How far behind the leading edge, mm.
        behind_mm: f64,
    },
}

impl Bench {
    /// The load that the words of a head or a condition name, and the words that are left; none if they name none.
    ///
    /// # Errors
    /// If they name one in part: what is wrong, and what to write.
    pub fn of(words: &str) -> Result<Option<(Bench, String)>, (String, String)> {
        let words = words.to_lowercase().replace(['µ', 'μ'], "u");
        let is_word = |word: &str| words.split(|c: char| !c.is_alphabetic()).any(|own| own == word);
        let is_push = is_word("push") || is_word("weight");
        if !is_push && !is_word("torque") {
            return Ok(None);
        }
        let (loads, lengths, left) = loads_and_lengths(&words);
        let refuse = |message: &str| Err((message.to_string(), format!("Write e.g. {FORMS}")));
        let load = match (&loads[..], is_push) {
            ([(torque, true)], false) => Load::Torque(*torque),
            ([(force_n, false)], true) => Load::Push {
                force_n: *force_n,
                behind_mm: lengths.get(1).copied().unwrap_or_default(),
            },
            (_, false) => return refuse("names a torque without its number and unit"),
            (_, true) => return refuse("names a push without its number and unit"),
        };
        match (lengths.len(), load) {
            (1, Load::Torque(_)) | (2, Load::Push { .. }) => {}
            (0, _) => return refuse("does not say where the load acts"),
            (1, _) => return refuse("does not say how far behind the leading edge the push acts"),
            _ => return refuse("has more lengths than a load has"),
        }
        let at_mm = lengths[0];
        let left = left.split_whitespace().filter(|word| !AROUND.contains(word));
        let left = left.collect::<Vec<_>>().join(" ");
        Ok(Some((Bench { at_mm, load }, left)))
    }

    /// The head of a column that names it, as [`Bench::of`] reads it.
    pub fn head(&self) -> String {
        self.named().replace('µ', "u").replace('·', " ")
    }

    /// Name of its case: [`Bench::head`] without spaces.
    pub fn case(&self) -> String {
        self.head().to_lowercase().replace(", ", "-").replace(' ', "-")
    }

    fn named(&self) -> String {
        let at = short(self.at_mm);
        match self.load {
            Load::Torque(torque) => format!("torque {} at {at} mm", with_unit(torque, "N·m")),
            Load::Push {
                force_n,
                behind_mm: 0.0,
            } => format!("push {} at {at} mm", with_unit(force_n, "N")),
            Load::Push { force_n, behind_mm } => format!(
                "push {} at {at} mm, {} mm behind",
                with_unit(force_n, "N"),
                short(behind_mm)
            ),
        }
    }

    /// What is done to the wing, in words.
    pub fn words(&self) -> String {
        let at = short(self.at_mm);
        match self.load {
            Load::Torque(torque) => format!(
                "under a torque of {} near its tip ({at} mm)",
                with_unit(torque, "N·m")
            ),
            Load::Push {
                force_n,
                behind_mm: 0.0,
            } => format!(
                "under a push of {} at {at} mm on its leading edge",
                with_unit(force_n, "N")
            ),
            Load::Push { force_n, behind_mm } => format!(
                "under a push of {} at {at} mm, {} mm behind its leading edge",
                with_unit(force_n, "N"),
                short(behind_mm)
            ),
        }
    }

    /// What it sets in a design, as `KEY=VALUE`: the load beside the masses that the wing carries, and motion so slow that the air
    /// does nothing.
    pub fn sets(&self, design: &Design) -> Vec<String> {
        let load = match self.load {
            Load::Torque(torque) => format!("moment_n_m=[{torque:?}, 0.0, 0.0]"),
            Load::Push { force_n, behind_mm } => {
                format!("chord_offset_mm={behind_mm:?}, force_n=[0.0, 0.0, {force_n:?}]")
            }
        };
        let frequency = design
            .flapping
            .iter()
            .map(|_| format!("flapping.frequency_hz={STILL_HZ:?}"));
        let speed = design
            .steady
            .iter()
            .map(|own| format!("steady.speed_m_s={:?}", STILL_SPEED * own.speed_m_s.value()));
        let mut loads: Vec<String> = carried(design).map(inline).collect();
        loads.push(format!("{{at_mm={:?}, {load}}}", self.at_mm));
        let load = format!("load=[{}]", loads.join(", "));
        frequency.chain(speed).chain([load]).collect()
    }

    /// Puts a design on the bench, as [`Bench::sets`] does.
    pub fn put(&self, design: &mut Design) {
        if let Some(flapping) = &mut design.flapping {
            flapping.frequency_hz = Quantity::Stated(STILL_HZ);
        }
        if let Some(steady) = &mut design.steady {
            steady.speed_m_s = Quantity::Stated(STILL_SPEED * steady.speed_m_s.value());
        }
        let nothing = || Quantity::Stated(0.0);
        let mut load = BenchLoad {
            at_mm: Quantity::Stated(self.at_mm),
            chord_offset_mm: nothing(),
            normal_offset_mm: nothing(),
            force_n: [0.0; 3],
            moment_n_m: [0.0; 3],
            mass_kg: nothing(),
            inertia_kg_m2: [0.0; 3],
        };
        match self.load {
            Load::Torque(torque) => load.moment_n_m[0] = torque,
            Load::Push { force_n, behind_mm } => {
                load.force_n[2] = force_n;
                load.chord_offset_mm = Quantity::Stated(behind_mm);
            }
        }
        design.load = carried(design).chain([load]).collect();
    }
}

/// The masses that the wing carries, which are part of it, without what else pulls there.
fn carried(design: &Design) -> impl Iterator<Item = BenchLoad> {
    let masses = design.load.iter().filter(|own| own.mass_kg.value() > 0.0);
    masses.map(|own| BenchLoad {
        force_n: [0.0; 3],
        moment_n_m: [0.0; 3],
        ..own.clone()
    })
}

/// A load as a value of `--set`.
fn inline(load: BenchLoad) -> String {
    toml::Value::try_from(load)
        .expect("a load is a table")
        .to_string()
}

/// Numbers with a unit of force (N), or of force times length (N·m, true); numbers with a unit of length, mm; and the words that are left.
fn loads_and_lengths(words: &str) -> (Vec<(f64, bool)>, Vec<f64>, String) {
    let (mut loads, mut lengths, mut left) = (Vec::new(), Vec::new(), String::new());
    let mut rest = words;
    while let Some(next) = rest.chars().next() {
        if let Some((number, after)) = number_at(rest, left.chars().last()) {
            if let Some((times, over, is_torque, after)) = force_at(after) {
                loads.push((number * times / over, is_torque));
                left.push(' ');
                rest = after;
                continue;
            }
            if let Some((Kind::Length, factor, after)) = unit_at(after) {
                lengths.push(number * factor);
                left.push(' ');
                rest = after;
                continue;
            }
        }
        let is_between = matches!(next, '-' | '_' | ',' | '@');
        left.push(if is_between { ' ' } else { next });
        rest = &rest[next.len_utf8()..];
    }
    (loads, lengths, left)
}

/// The unit of force that these words begin with, N, or of a torque, N·m (true): what a number is multiplied by and divided by, and what
/// follows.
fn force_at(words: &str) -> Option<(f64, f64, bool, &str)> {
    let ends = |rest: &str| !rest.starts_with(|next: char| next.is_alphanumeric() || next == '/');
    FORCES.iter().find_map(|&(unit, times, over)| {
        let rest = words.strip_prefix(unit)?;
        let arm = rest.trim_start_matches([' ', '·', '⋅', '*', '_', '-']);
        let arm = unit_at(arm).filter(|(kind, ..)| *kind == Kind::Length);
        match arm {
            Some((_, mm, rest)) => Some((times * mm, over * 1e3, true, rest)),
            None => ends(rest).then_some((times, over, false, rest)),
        }
    })
}

/// A number with its unit, in thousandths of it or millionths where it is small.
fn with_unit(value: f64, unit: &str) -> String {
    match value.abs() {
        large if large >= 0.1 => format!("{} {unit}", short(value)),
        small if small >= 1e-4 => format!("{} m{unit}", short(1e3 * value)),
        _ => format!("{} µ{unit}", short(1e6 * value)),
    }
}

/// To three places, without zeros at the end.
pub fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(words: &str) -> (Bench, String) {
        Bench::of(words).unwrap().unwrap()
    }

    #[test]
    fn loads_are_read_as_they_are_written() {
        let torque = |torque: f64| Bench {
            at_mm: 62.0,
            load: Load::Torque(torque),
        };
        for words in [
            "torque 20 uN m at 62 mm",
            "Torque of 20 µN·m at 62 mm",
            "torque 0.02 mNm @ 6.2cm",
            "torque-20un-m-at-62mm",
            "20 mN*mm torque near its tip (62 mm)",
        ] {
            let (bench, _) = of(words);
            assert_eq!(bench.at_mm, 62.0, "{words}");
            let Load::Torque(own) = bench.load else {
                panic!("{words}")
            };
            assert!((own - 20e-6).abs() < 1e-15, "{words}: {own}");
        }
        let (bench, left) = of("twist (deg), push of 2 g at 24 mm, 12 mm behind the leading edge");
        assert_eq!(bench.at_mm, 24.0);
        let Load::Push { force_n, behind_mm } = bench.load else {
            panic!()
        };
        assert!((force_n - 0.0196133).abs() < 1e-12 && behind_mm == 12.0);
        assert_eq!(left, "twist (deg)");
        for bench in [torque(20e-6), torque(-3e-4), torque(0.5)] {
            assert_eq!(of(&bench.head()).0, bench, "{}", bench.head());
        }
        assert_eq!(torque(20e-6).head(), "torque 20 uN m at 62 mm");
        assert_eq!(torque(20e-6).case(), "torque-20-un-m-at-62-mm");
        assert_eq!(Bench::of("22 Hz, 35 deg"), Ok(None));
    }

    #[test]
    fn a_load_that_is_named_in_part_says_what_lacks() {
        for (words, lacks) in [
            ("torque at 62 mm", "number and unit"),
            ("torque 20 mN at 62 mm", "number and unit"),
            ("torque 20 mN m", "where"),
            ("push 20 mN at 24 mm", "behind the leading edge"),
            ("push 20 mN m at 24 mm, 12 mm behind", "number and unit"),
            ("torque 20 mN m at 62 mm, 12 mm behind", "more lengths"),
        ] {
            let (message, cure) = Bench::of(words).unwrap_err();
            assert!(
                message.contains(lacks) && cure.contains("uN m at"),
                "{words}: {message}"
            );
        }
    }

    #[test]
    fn a_design_is_put_on_the_bench_as_its_settings_say() {
        let path =
            std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("designs/twist-v2.toml");
        let mass = "load=[{ at_mm = 60, mass_kg = { assumed = 1e-5, range = [0, 2e-5], why = \"a marker\" }, force_n = [0, 0, 1] }]";
        let bare = Design::load(&path, &[]).unwrap().design;
        let marked = bare.with(&[mass.to_string()]).unwrap();
        let words = ["torque 20 uN m at 62 mm", "push 20 mN at 24 mm, 12 mm behind"];
        for (design, words) in [&bare, &marked]
            .into_iter()
            .flat_map(|own| words.map(|words| (own, words)))
        {
            let (bench, _) = of(words);
            let mut put = design.clone();
            bench.put(&mut put);
            assert_eq!(put.load.len(), design.load.len() + 1);
            assert!(put.load[0].force_n[2] < 1.0);
            assert_eq!(
                put.to_toml(),
                design.with(&bench.sets(design)).unwrap().to_toml(),
                "{words}"
            );
        }
    }

    #[test]
    fn small_loads_are_in_small_units() {
        assert_eq!(
            [2e-5, 2e-4, 0.05, 0.5, 20.0].map(|load| with_unit(load, "N·m")),
            ["20 µN·m", "0.2 mN·m", "50 mN·m", "0.5 N·m", "20 N·m"]
        );
        assert_eq!([11.0, 11.5, 0.0].map(short), ["11", "11.5", "0"]);
    }
}
