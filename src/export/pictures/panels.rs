//! Which numbers of a study belong into one panel, and against what they are drawn.
//!
//! Numbers of one wing, one family of cases and one channel belong together. Where a case was read at three stations or
//! more, they are drawn against the station, one panel for each case. Else they are drawn against the number of the
//! family (speed, mass, …) that takes most values; each combination of the others is a curve of its own, and so is each
//! station, place on the chord and run. What has neither a station nor a number to stand over is left to the tables.

use crate::compare::{Comparison, StudyCase, StudyComparison, StudyRow};
use crate::input::measurement::Channel;

use super::{plain, with_unit, words};

/// Stations from which on a case has a profile.
const PROFILE: usize = 3;

/// Measured numbers beside the model, of a study or of a single wing.
#[derive(Debug, Clone, PartialEq)]
pub struct Compared {
    /// Name of the study or wing.
    pub name: String,
    /// Title; may be empty.
    pub title: String,
    /// The cases.
    pub cases: Vec<StudyCase>,
    /// The numbers.
    pub rows: Vec<StudyRow>,
    /// Whether anything was calibrated; else `before` and `after` are the same.
    pub is_calibrated: bool,
}

impl Compared {
    /// A study as compared.
    pub fn of_study(comparison: &StudyComparison) -> Compared {
        Compared {
            name: comparison.study.clone(),
            title: comparison.title.clone(),
            cases: comparison.cases.clone(),
            rows: comparison.rows.clone(),
            is_calibrated: !comparison.unknowns.is_empty(),
        }
    }

    /// A single wing as compared; its model is drawn as stated.
    pub fn of_wing(comparison: &Comparison) -> Compared {
        let row = |row: &crate::compare::ComparedRow| StudyRow {
            case: comparison.case.clone(),
            wing: comparison.wing.clone(),
            line: row.line,
            channel: row.channel,
            run: row.run.clone(),
            r_mm: row.r_mm,
            r_to_mm: row.r_to_mm,
            chord_fraction: row.chord_fraction,
            measured: row.measured,
            sigma: row.sigma,
            bound: row.bound,
            before: row.modelled,
            sigma_of_inputs: 0.0,
            after: row.modelled,
            left_out: None,
            is_held_out: false,
        };
        Compared {
            name: comparison.wing.clone(),
            title: format!("{}, case {}", comparison.file, comparison.case),
            cases: vec![StudyCase {
                name: comparison.case.clone(),
                wing: comparison.wing.clone(),
                family: comparison.case.clone(),
                numbers: Vec::new(),
                is_held_out: false,
            }],
            rows: comparison.rows.iter().map(row).collect(),
            is_calibrated: false,
        }
    }
}

/// A panel.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyPanel {
    /// Its title.
    pub title: String,
    /// What its numbers are drawn against, with unit.
    pub x_label: String,
    /// A place that its axis must show: the base of the wing.
    pub x_includes: Option<f64>,
    /// What was measured.
    pub channel: Channel,
    /// Its curves.
    pub curves: Vec<Curve>,
}

/// Numbers that belong to one line.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// What sets it apart from the other curves; empty if nothing does.
    pub label: String,
    /// The same without the run: curves that share it have one uncalibrated model.
    pub kin: String,
    /// Its numbers, place rising.
    pub places: Vec<Placed>,
}

/// A number at its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// The place.
    pub x: f64,
    /// Outer end, if it is a mean over an interval.
    pub x_to: Option<f64>,
    /// Index of the number among the rows.
    pub row: usize,
}

/// Whether the cases of a family that were read along the span have panels of their own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Profiles {
    /// One panel for each case.
    Apart,
    /// One panel for all, each case a curve.
    Together,
}

/// The panels of a comparison, in the order of its rows.
pub fn panels(compared: &Compared, profiles: Profiles) -> Vec<StudyPanel> {
    let case_of = |row: &StudyRow| {
        compared
            .cases
            .iter()
            .find(|case| case.name == row.case && case.wing == row.wing)
    };
    let mut groups: Vec<Group> = Vec::new();
    for (index, row) in compared.rows.iter().enumerate() {
        let Some(case) = case_of(row) else { continue };
        let key = (case.family.as_str(), row.wing.as_str(), row.channel);
        match groups.iter_mut().find(|group| group.key == key) {
            Some(group) => group.members.push((index, row, case)),
            None => groups.push(Group {
                key,
                members: vec![(index, row, case)],
            }),
        }
    }
    let context = Context::of(compared);
    groups
        .iter()
        .flat_map(|group| group.panels(&context, profiles))
        .collect()
}

/// What titles must name, because it differs within the picture.
struct Context<'a> {
    has_wings: bool,
    families: Vec<(String, String)>,
    cases: &'a [StudyCase],
    /// Whether all was read at one place, which the caption then names.
    has_one_place: bool,
}

impl<'a> Context<'a> {
    fn of(compared: &'a Compared) -> Context<'a> {
        let mut families: Vec<(String, String)> = Vec::new();
        for case in &compared.cases {
            let key = (case.wing.clone(), case.family.clone());
            if !families.contains(&key) {
                families.push(key);
            }
        }
        let has_wings = families.iter().any(|(wing, _)| *wing != families[0].0);
        Context {
            has_wings,
            families,
            cases: &compared.cases,
            has_one_place: only_place(compared).is_some(),
        }
    }

    fn has_families(&self, wing: &str) -> bool {
        self.families.iter().filter(|(of, _)| of == wing).count() > 1
    }
}

type Member<'a> = (usize, &'a StudyRow, &'a StudyCase);

/// Numbers of one family, wing and channel.
struct Group<'a> {
    key: (&'a str, &'a str, Channel),
    members: Vec<Member<'a>>,
}

impl Group<'_> {
    fn panels(&self, context: &Context<'_>, profiles: Profiles) -> Vec<StudyPanel> {
        let cases = distinct(self.members.iter().map(|(_, _, case)| case.name.clone()));
        let stations = |name: &String| {
            let of_case = self.members.iter().filter(|(_, _, case)| case.name == *name);
            distinct(of_case.map(|(_, row, _)| station(row))).len()
        };
        let abscissa = self.abscissa();
        let has_place = self.members.iter().any(|(_, row, _)| row.r_mm.is_some());
        let is_profile =
            has_place && (abscissa.is_none() || cases.iter().map(stations).max() >= Some(PROFILE));
        match (is_profile, abscissa) {
            (true, _) if profiles == Profiles::Apart => cases
                .iter()
                .map(|case| self.profile(context, std::slice::from_ref(case), cases.len() > 1))
                .collect(),
            (true, _) => vec![self.profile(context, &cases, false)],
            (false, Some(number)) => vec![self.sweep(context, number)],
            (false, None) => Vec::new(),
        }
    }

    /// The number of the family that takes most values, if any takes two.
    fn abscissa(&self) -> Option<usize> {
        let count = self.members.first().map_or(0, |(_, _, case)| case.numbers.len());
        let values =
            |index: &usize| distinct(self.members.iter().map(|(_, _, case)| bits(case, *index))).len();
        let best = (0..count).rev().max_by_key(values)?;
        (values(&best) > 1).then_some(best)
    }

    fn profile(&self, context: &Context<'_>, cases: &[String], names_case: bool) -> StudyPanel {
        let of_cases = self
            .members
            .iter()
            .filter(|(_, _, case)| cases.contains(&case.name));
        let members: Vec<Member> = of_cases.copied().collect();
        let mut panel = StudyPanel {
            title: self.title(context, names_case.then(|| cases[0].as_str()), ""),
            x_label: "distance from the wing base (mm)".to_string(),
            x_includes: Some(0.0),
            channel: self.key.2,
            curves: Vec::new(),
        };
        let apart = Apart::of(&members, true);
        for (index, row, case) in &members {
            let Some(r_mm) = row.r_mm else { continue };
            let mut parts = apart.parts(row);
            if cases.len() > 1 {
                parts.insert(0, case.name.clone());
            }
            panel.place(&parts, apart.run(row), (r_mm, row.r_to_mm), *index);
        }
        panel.sorted()
    }

    fn sweep(&self, context: &Context<'_>, number: usize) -> StudyPanel {
        let apart = Apart::of(&self.members, false);
        let at = match self.members.first() {
            Some((_, row, _)) if !apart.station && !context.has_one_place => {
                place_words(row.r_mm, row.r_to_mm)
            }
            _ => String::new(),
        };
        let first = self
            .members
            .first()
            .and_then(|(_, _, case)| case.numbers.get(number));
        let mut panel = StudyPanel {
            title: self.title(context, None, &at),
            x_includes: None,
            x_label: first.map_or_else(String::new, |number| with_unit(&number.name, &number.unit)),
            channel: self.key.2,
            curves: Vec::new(),
        };
        let others: Vec<usize> = (0..self.members.first().map_or(0, |(_, _, case)| case.numbers.len()))
            .filter(|other| *other != number)
            .filter(|other| {
                // In the whole family, so that a curve has its name in every panel.
                let (family, wing, _) = self.key;
                let kin = context
                    .cases
                    .iter()
                    .filter(|case| case.family == family && case.wing == wing);
                distinct(kin.map(|case| bits(case, *other))).len() > 1
            })
            .collect();
        for (index, row, case) in &self.members {
            let Some(x) = case.numbers.get(number) else {
                continue;
            };
            let numbers = others.iter().filter_map(|other| case.numbers.get(*other));
            let mut parts: Vec<String> = numbers
                .map(|other| {
                    format!("{} {} {}", other.name, plain(other.value), other.unit)
                        .trim_end()
                        .to_string()
                })
                .collect();
            parts.extend(apart.parts(row));
            panel.place(&parts, apart.run(row), (x.value, None), *index);
        }
        panel.sorted()
    }

    fn title(&self, context: &Context<'_>, case: Option<&str>, at: &str) -> String {
        let (family, wing, channel) = self.key;
        let mut parts = Vec::new();
        if context.has_wings {
            parts.push(wing.to_string());
        }
        match case {
            Some(case) => parts.push(case.to_string()),
            None if context.has_families(wing) => parts.push(family_words(family)),
            None => {}
        }
        parts.retain(|part| !part.is_empty());
        parts.dedup();
        let what = format!("{}{at}", words(channel));
        match parts.as_slice() {
            [] => what,
            parts => format!("{}: {what}", parts.join(", ")),
        }
    }
}

/// What sets curves of a group apart besides the numbers of the family.
struct Apart {
    station: bool,
    chord: bool,
    run: bool,
}

impl Apart {
    fn of(members: &[Member], is_profile: bool) -> Apart {
        let chord = |row: &StudyRow| row.chord_fraction.map(f64::to_bits);
        Apart {
            station: !is_profile && distinct(members.iter().map(|(_, row, _)| station(row))).len() > 1,
            chord: distinct(members.iter().map(|(_, row, _)| chord(row))).len() > 1,
            run: distinct(members.iter().map(|(_, row, _)| row.run.clone())).len() > 1,
        }
    }

    fn run(&self, row: &StudyRow) -> Option<String> {
        (self.run && !row.run.is_empty()).then(|| format!("run {}", row.run))
    }

    fn parts(&self, row: &StudyRow) -> Vec<String> {
        let mut parts = Vec::new();
        if self.station {
            parts.push(place_words(row.r_mm, row.r_to_mm).trim().to_string());
        }
        if let (true, Some(fraction)) = (self.chord, row.chord_fraction) {
            parts.push(format!("at {} of the chord", plain(fraction)));
        }
        parts
    }
}

impl StudyPanel {
    fn place(&mut self, parts: &[String], run: Option<String>, (x, x_to): (f64, Option<f64>), row: usize) {
        let kin = parts.join(", ");
        let named: Vec<String> = parts.iter().cloned().chain(run).collect();
        let label = named.join(", ");
        let place = Placed { x, x_to, row };
        match self.curves.iter_mut().find(|curve| curve.label == label) {
            Some(curve) => curve.places.push(place),
            None => self.curves.push(Curve {
                label,
                kin,
                places: vec![place],
            }),
        }
    }

    fn sorted(mut self) -> StudyPanel {
        for curve in &mut self.curves {
            curve.places.sort_by(|a, b| a.x.total_cmp(&b.x));
        }
        self
    }
}

/// `bending-{mass}` is "bending".
fn family_words(family: &str) -> String {
    let mut words = String::new();
    let mut depth = 0;
    for c in family.chars() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            c if depth == 0 => words.push(c),
            _ => {}
        }
    }
    let parts: Vec<&str> = words.split(['-', '_']).filter(|part| !part.is_empty()).collect();
    parts.join("-")
}

/// The place at which all numbers with a place were read, if it is one.
pub(super) fn only_place(compared: &Compared) -> Option<&StudyRow> {
    let mut rows = compared.rows.iter().filter(|row| row.r_mm.is_some());
    let first = rows.next()?;
    rows.all(|row| station(row) == station(first)).then_some(first)
}

/// "Read at 549.8 mm. " where that holds for all, for a caption.
pub(super) fn read_words(compared: &Compared) -> String {
    only_place(compared).map_or_else(String::new, |row| {
        format!("Read{}. ", place_words(row.r_mm, row.r_to_mm))
    })
}

/// Where a number was read: " at 549.8 mm", " from 0 to 48 mm"; empty for the whole wing.
pub(super) fn place_words(r_mm: Option<f64>, r_to_mm: Option<f64>) -> String {
    match (r_mm, r_to_mm) {
        (Some(from), Some(to)) => format!(" from {} to {} mm", plain(from), plain(to)),
        (Some(at), None) => format!(" at {} mm", plain(at)),
        _ => String::new(),
    }
}

fn station(row: &StudyRow) -> [Option<u64>; 2] {
    [row.r_mm.map(f64::to_bits), row.r_to_mm.map(f64::to_bits)]
}

fn bits(case: &StudyCase, number: usize) -> Option<u64> {
    case.numbers.get(number).map(|number| number.value.to_bits())
}

/// Without repetitions, in the order of first appearance.
pub(super) fn distinct<T: PartialEq>(values: impl Iterator<Item = T>) -> Vec<T> {
    let mut found = Vec::new();
    for value in values {
        if !found.contains(&value) {
            found.push(value);
        }
    }
    found
}
