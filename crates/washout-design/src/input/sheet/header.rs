//! What the head of a column says: stations, readings at a condition, standard deviations, and the rest.

use super::bench::{Bench, FORMS, is_meant};
use super::condition::{Point, key};
use super::grid::Grid;
use super::words::{Kind, UNITS, numbers, unit_at};
use crate::input::design::Design;
use crate::input::error::InputError;
use crate::input::measurement::{CHANNELS, Channel, OPTIONAL_COLUMNS};
use crate::input::nearest;

/// A column as it was understood.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Which column of the table it is, from 0.
    pub place: usize,
    /// What its cells are.
    pub role: Role,
    /// What its numbers are multiplied by.
    pub factor: f64,
    /// Whether its head names the unit.
    pub has_unit: bool,
}

/// What the cells of a column are.
#[derive(Debug, Clone, PartialEq)]
pub enum Role {
    /// Stations from the wing base.
    Station,
    /// Outer ends of intervals.
    StationTo,
    /// Numbers of this key of the design.
    Key(String),
    /// Readings, or with `is_sigma` their standard deviations.
    Readings {
        /// The condition that the head names.
        points: Vec<Point>,
        /// The load on the still wing that the head names.
        bench: Option<Bench>,
        /// The station that the head names, mm.
        station: Option<f64>,
        /// The channel, if the head names it.
        channel: Option<Channel>,
        /// Whether positive raises the nose; none if the head does not say.
        nose_up: Option<bool>,
        /// Whether it holds standard deviations.
        is_sigma: bool,
    },
    /// A column of a measurement file, by its name there.
    Word(&'static str),
}

/// Names that people give to columns, each beside the name in a measurement file.
const NAMES: [(&str, &[&str]); 12] = [
    (
        "r_mm",
        &[
            "r", "station", "stations", "span", "position", "pos", "distance", "radius", "x", "y", "location",
        ],
    ),
    ("r_to_mm", &["r_to", "to", "station_to"]),
    ("value", &["value", "reading", "measured", "measurement", "mean"]),
    (
        "sigma",
        &[
            "sigma",
            "std",
            "sd",
            "stdev",
            "error",
            "uncertainty",
            "err",
            "standard_deviation",
            "±",
        ],
    ),
    ("case", &["case", "condition", "test"]),
    ("run", &["run", "repeat", "series"]),
    ("channel", &["channel", "quantity"]),
    ("instrument", &["instrument"]),
    ("unit", &["unit"]),
    ("sign", &["sign"]),
    ("sigma_kind", &["sigma_kind"]),
    ("bound", &["bound"]),
];

/// Names of numbers that differ between conditions.
const POINTS: [(&str, Kind); 12] = [
    ("frequency", Kind::Frequency),
    ("freq", Kind::Frequency),
    ("f", Kind::Frequency),
    ("flapping_frequency", Kind::Frequency),
    ("amplitude", Kind::Angle),
    ("half_amplitude", Kind::Angle),
    ("angle_of_attack", Kind::Angle),
    ("root_angle", Kind::Angle),
    ("alpha", Kind::Angle),
    ("speed", Kind::Speed),
    ("velocity", Kind::Speed),
    ("v", Kind::Speed),
];

/// Words of a head that say nothing by themselves.
const FILLERS: [&str; 7] = ["at", "of", "in", "and", "f", "the", "at_f"];

/// All columns of a table; columns without a name must be empty.
pub fn columns(grid: &Grid, design: &Design) -> Result<Vec<Column>, InputError> {
    let mut columns = Vec::new();
    for (place, head) in grid.head.cells.iter().enumerate() {
        let mut cells = grid.lines.iter().map(|line| &line.cells[place]);
        if head.is_empty() && cells.all(String::is_empty) {
            continue;
        }
        let refuse =
            |(message, cure): (String, String)| grid.fault(grid.head.number, head, "", &message, cure);
        let column = column(place, head, design).map_err(refuse)?;
        let again = columns.iter().find(|known: &&Column| known.role == column.role);
        if let Some(again) = again {
            let cure = format!(
                "Column {} says the same; delete one, or add a column run to tell repeats apart",
                again.place + 1
            );
            return Err(refuse(("stands twice".to_string(), cure)));
        }
        columns.push(column);
    }
    Ok(columns)
}

fn column(place: usize, head: &str, design: &Design) -> Result<Column, (String, String)> {
    let made = |role, factor, has_unit| Column {
        place,
        role,
        factor,
        has_unit,
    };
    if head.contains('.') && head.starts_with(|c: char| c.is_ascii_lowercase()) && !head.contains(' ') {
        return Ok(made(Role::Key(head.to_string()), 1.0, true));
    }
    let (bench, head) = match Bench::of(head)? {
        Some((bench, left)) => (Some(bench), left),
        None => (None, head.to_string()),
    };
    let (found, left) = numbers(&head);
    let (name, unit) = parted(&left);
    if let Some(column) = OPTIONAL_COLUMNS.iter().find(|column| **column == name) {
        return Ok(made(Role::Word(column), 1.0, true));
    }
    let (points, station) = condition(found, design)?;
    let is_condition = !points.is_empty() || station.is_some() || bench.is_some();
    let readings = Words::of(&name);
    if let Some(readings) = readings.filter(|words| is_condition || words.says_something()) {
        let channel = readings.channel;
        let factor = reading_factor(unit.as_deref(), channel)?;
        let role = Role::Readings {
            points,
            bench,
            station,
            channel,
            nose_up: readings.nose_up,
            is_sigma: readings.is_sigma,
        };
        return Ok(made(role, factor, unit.is_some()));
    }
    if !is_condition && let Some(column) = named(place, &name, unit.as_deref(), design)? {
        return Ok(column);
    }
    Err(("is not understood".to_string(), cure_of(&head)))
}

/// The points of a condition and the station, mm, that the numbers of a head give.
fn condition(
    found: Vec<(f64, Kind)>,
    design: &Design,
) -> Result<(Vec<Point>, Option<f64>), (String, String)> {
    let mut points = Vec::new();
    let mut station = None;
    for (value, kind) in found {
        match kind {
            Kind::Length => station = Some(value),
            kind => {
                let key = key(kind, design).map_err(|cure| {
                    (
                        format!("names {}, which the design has not", kind.words(value)),
                        cure,
                    )
                })?;
                points.push(Point {
                    key: key.to_string(),
                    value,
                });
            }
        }
    }
    Ok((points, station))
}

/// What a column is by its name alone; none if the name is not known.
fn named(
    place: usize,
    name: &str,
    unit: Option<&str>,
    design: &Design,
) -> Result<Option<Column>, (String, String)> {
    let known = NAMES.iter().find(|(_, names)| names.contains(&name));
    let point = POINTS.iter().find(|(known, _)| *known == name);
    let given = unit.and_then(|unit| unit_at(unit).map(|(kind, factor, _)| (kind, factor)));
    let (role, factor, has_unit) = match (known.map(|(column, _)| *column), point) {
        (Some(column @ ("r_mm" | "r_to_mm")), _) => {
            let role = if column == "r_mm" {
                Role::Station
            } else {
                Role::StationTo
            };
            match (given, unit) {
                (Some((Kind::Length, factor)), _) => (role, factor, true),
                (None, None) => (role, 1.0, false),
                _ => {
                    let message = "has a unit that is no length".to_string();
                    return Err((message, "Write e.g. r (mm), r (m)".to_string()));
                }
            }
        }
        (Some(column @ ("value" | "sigma")), _) => {
            let role = Role::Readings {
                points: Vec::new(),
                bench: None,
                station: None,
                channel: None,
                nose_up: None,
                is_sigma: column == "sigma",
            };
            (role, reading_factor(unit, None)?, unit.is_some())
        }
        (Some(column), _) => (Role::Word(column), 1.0, unit.is_some()),
        (None, Some((_, kind))) => {
            let key =
                key(*kind, design).map_err(|cure| ("sets what the design has not".to_string(), cure))?;
            match (given, unit) {
                (Some((own, factor)), _) if own == *kind => (Role::Key(key.to_string()), factor, true),
                (None, None) => (Role::Key(key.to_string()), 1.0, false),
                _ => {
                    let message = "has another unit than its name".to_string();
                    return Err((message, format!("{key} is meant; give its unit")));
                }
            }
        }
        (None, None) => return Ok(None),
    };
    Ok(Some(Column {
        place,
        role,
        factor,
        has_unit,
    }))
}

/// What to write instead of a head that says nothing.
fn cure_of(head: &str) -> String {
    let digits = head.trim_start_matches(|c: char| !c.is_ascii_digit());
    let end = digits
        .find(|c: char| !(c.is_ascii_digit() || c == '.'))
        .unwrap_or(digits.len());
    let usual = "Heads are understood such as: r (mm), twist (deg), sigma, 22 Hz, \"22 Hz, 35 deg\", frequency (Hz), condition, run, \
                 \"torque 20 uN m at 62 mm\"";
    if is_meant(head) {
        return format!("Is it a load on the still wing? Then write e.g. {FORMS}. {usual}");
    }
    if head.is_empty() {
        return format!("Give the column a name; of the distance from the wing base r (mm). {usual}");
    }
    if ["mm", "cm", "m"].contains(&head) {
        return format!("Is it the distance from the wing base? Then write r ({head}). {usual}");
    }
    if end > 0 {
        let after = digits[end..].trim().to_lowercase();
        let units = UNITS.iter().map(|(unit, ..)| *unit);
        let near = nearest(
            &after,
            units
                .clone()
                .filter(|unit| unit.len() > 1 && unit.len() == after.len()),
        );
        return match near.map(|near| if near == "hz" { "Hz" } else { near }) {
            Some(near) => format!("Did you mean {} {near}? {usual}", &digits[..end]),
            None => format!(
                "Give the number its unit, e.g. {} Hz or {} deg. {usual}",
                &digits[..end],
                &digits[..end]
            ),
        };
    }
    if let Some((name, rest)) = head.split_once(['(', '['])
        && NAMES
            .iter()
            .any(|(_, names)| names.contains(&name.trim().to_lowercase().as_str()))
        && unit_at(&rest.to_lowercase()).is_none()
    {
        let unit = rest.trim_end_matches([')', ']']);
        return format!(
            "{unit} is no unit that is known: lengths are in mm, cm or m, angles in deg or rad. {usual}"
        );
    }
    // of two that are as near, what is read comes first; a letter is near to every letter
    let words = CHANNELS.iter().map(|(name, _)| *name);
    let words = words
        .chain(NAMES.iter().flat_map(|(_, names)| names.iter().copied()))
        .chain(POINTS.iter().map(|(name, _)| *name))
        .filter(|name| name.len() > 1);
    let (_, left) = numbers(head);
    match nearest(&parted(&left).0, words) {
        Some(near) => format!("Did you mean {near}? {usual}"),
        None => usual.to_string(),
    }
}

/// A head as name and unit: `r (mm)`, `r [mm]`, `r_mm`, `r / mm`, `r in mm` are all `r` and `mm`.
fn parted(head: &str) -> (String, Option<String>) {
    let words = head
        .replace(['(', ')', '[', ']', ',', '@', '=', ':', '_'], " ")
        .replace(" / ", " ");
    let mut words: Vec<&str> = words.split_whitespace().filter(|word| *word != "-").collect();
    let units = ["mn", "mw", "n", "w", "%", "1", "deg/mm"];
    let is_unit =
        |word: &str| units.contains(&word) || unit_at(word).is_some_and(|(.., rest)| rest.is_empty());
    // m/s is written m_s in keys
    let joined = words.len() > 2 && words[words.len() - 2..] == ["m", "s"];
    let unit = match words.last().copied() {
        Some(_) if joined => {
            words.truncate(words.len() - 2);
            Some("m/s".to_string())
        }
        Some(last) if is_unit(last) => {
            words.pop();
            Some(last.to_string())
        }
        _ => None,
    };
    words.retain(|word| *word != "in");
    (words.join("_"), unit)
}

/// What the words of a column of readings say.
struct Words {
    channel: Option<Channel>,
    nose_up: Option<bool>,
    is_sigma: bool,
}

impl Words {
    /// None if one of the words is not known.
    fn of(name: &str) -> Option<Words> {
        let mut words = Words {
            channel: None,
            nose_up: None,
            is_sigma: false,
        };
        let mut rest = name.to_string();
        for (text, up) in [("nose_up", true), ("nose_down", false), ("washout", false)] {
            if rest.contains(text) {
                words.nose_up = Some(up);
                rest = rest.replace(text, "_");
            }
        }
        let mut longest: Vec<_> = CHANNELS.to_vec();
        longest.sort_by_key(|(name, _)| std::cmp::Reverse(name.len()));
        // a frequency beside stations is a condition
        let channels = longest
            .iter()
            .filter(|(_, channel)| *channel != Channel::Frequency);
        if let Some((text, channel)) = channels.clone().find(|(text, _)| rest.contains(text)) {
            words.channel = Some(*channel);
            rest = rest.replace(text, "_");
        }
        for word in rest.split('_').filter(|word| !word.is_empty()) {
            let is = |column: &str| {
                NAMES
                    .iter()
                    .any(|(name, names)| *name == column && names.contains(&word))
            };
            match word {
                _ if is("sigma") => words.is_sigma = true,
                _ if is("value") || FILLERS.contains(&word) => {}
                _ => return None,
            }
        }
        Some(words)
    }

    /// Whether it is more than a name that every table has.
    fn says_something(&self) -> bool {
        self.channel.is_some() || self.nose_up.is_some()
    }
}

/// What readings with this unit are multiplied by; an error if their channel has another.
pub fn reading_factor(unit: Option<&str>, channel: Option<Channel>) -> Result<f64, (String, String)> {
    let channel = channel.unwrap_or(Channel::Twist);
    let Some(unit) = unit else { return Ok(1.0) };
    let known = unit_at(unit).map(|(kind, factor, _)| (kind, factor));
    match known {
        _ if unit.eq_ignore_ascii_case(channel.unit()) => Ok(1.0),
        Some((Kind::Angle, factor)) if channel == Channel::Twist => Ok(factor),
        Some((Kind::Length, factor)) if channel.is_displacement() => Ok(factor),
        _ => Err((
            format!("has the unit {unit}, {} is in {}", channel.name(), channel.unit()),
            "Name the channel and its unit, e.g. twist (deg), deflection (mm)".to_string(),
        )),
    }
}

impl Column {
    /// What it was taken for.
    pub fn words(&self) -> String {
        let factor = match self.factor {
            1.0 => String::new(),
            factor => format!(", times {}", (1e6 * factor).round() / 1e6),
        };
        match &self.role {
            Role::Station => format!("station from the wing base, mm{factor}"),
            Role::StationTo => format!("outer end of the interval, mm{factor}"),
            Role::Key(key) => format!("sets {key}{factor}"),
            Role::Word(name) => name.to_string(),
            Role::Readings {
                points,
                bench,
                station,
                channel,
                nose_up,
                is_sigma,
            } => {
                let what = if *is_sigma { "sigma of " } else { "" };
                let mut words = format!("{what}{}{factor}", channel.map_or("twist", Channel::name));
                if let Some(bench) = bench {
                    words += &format!("; the still wing, {}", bench.head());
                }
                for point in points {
                    words += &format!("; {} = {}", point.key, point.value);
                }
                if let Some(station) = station {
                    words += &format!("; at {station} mm");
                }
                match nose_up {
                    Some(true) => words + "; positive is nose up",
                    _ => words,
                }
            }
        }
    }
}
