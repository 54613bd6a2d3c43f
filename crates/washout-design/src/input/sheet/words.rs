//! Numbers and units as people write them in words: `22 Hz`, `35°`, `1320 rpm`.

/// What a unit in a header or a condition stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// A frequency, Hz.
    Frequency,
    /// An angle, deg: the half amplitude of a flapping wing, the root angle of a steady one.
    Angle,
    /// A speed, m/s.
    Speed,
    /// A length, mm: a station.
    Length,
}

impl Kind {
    /// A number of this kind in words.
    pub fn words(self, value: f64) -> String {
        let unit = match self {
            Kind::Frequency => "Hz",
            Kind::Angle => "deg",
            Kind::Speed => "m/s",
            Kind::Length => "mm",
        };
        format!("{value} {unit}")
    }
}

/// Units as people write them, in lower case, longer ones first; with the factor to the unit of [`Kind`].
pub const UNITS: [(&str, Kind, f64); 14] = [
    ("millimetres", Kind::Length, 1.0),
    ("degrees", Kind::Angle, 1.0),
    ("degree", Kind::Angle, 1.0),
    ("hertz", Kind::Frequency, 1.0),
    ("rpm", Kind::Frequency, 1.0 / 60.0),
    ("deg", Kind::Angle, 1.0),
    ("rad", Kind::Angle, 180.0 / std::f64::consts::PI),
    ("m/s", Kind::Speed, 1.0),
    ("m_s", Kind::Speed, 1.0),
    ("hz", Kind::Frequency, 1.0),
    ("mm", Kind::Length, 1.0),
    ("cm", Kind::Length, 10.0),
    ("°", Kind::Angle, 1.0),
    ("m", Kind::Length, 1000.0),
];

/// The unit that these words begin with, and what follows it.
pub fn unit_at(words: &str) -> Option<(Kind, f64, &str)> {
    UNITS.iter().find_map(|(unit, kind, factor)| {
        let rest = words.strip_prefix(unit)?;
        let ends = !rest.starts_with(|next: char| next.is_alphabetic() || next == '/' || next == '³');
        ends.then_some((*kind, *factor, rest))
    })
}

/// The number that these words begin with, and what follows it without spaces; none inside of a word, of which `before` is the last letter.
pub fn number_at(words: &str, before: Option<char>) -> Option<(f64, &str)> {
    if before.is_some_and(char::is_alphanumeric) {
        return None;
    }
    let is_digit = |c: char| c.is_ascii_digit();
    // a comma between two digits is a decimal one
    let is_decimal = |at: usize| words[..at].ends_with(is_digit) && words[at + 1..].starts_with(is_digit);
    let is_of_number = |(at, c): &(usize, char)| match c {
        ',' => is_decimal(*at),
        _ => is_digit(*c) || "+-.−".contains(*c),
    };
    let length = words.char_indices().take_while(is_of_number);
    let length = length.map(|(at, c)| at + c.len_utf8()).last().unwrap_or(0);
    let number = words[..length].replace('−', "-").replace(',', ".");
    let number = number.parse::<f64>().ok()?;
    Some((number, words[length..].trim_start_matches([' ', '_'])))
}

/// Numbers with a unit in some words, and the words that are left; in lower case.
pub fn numbers(words: &str) -> (Vec<(f64, Kind)>, String) {
    let words = words.to_lowercase();
    let mut found = Vec::new();
    let mut left = String::new();
    let mut rest = words.as_str();
    while let Some(next) = rest.chars().next() {
        if let Some((number, after)) = number_at(rest, left.chars().last())
            && let Some((kind, factor, after)) = unit_at(after)
        {
            found.push((number * factor, kind));
            left.push(' ');
            // 22hz-35deg, as cases are named
            rest = after.strip_prefix('-').unwrap_or(after);
            continue;
        }
        left.push(next);
        rest = &rest[next.len_utf8()..];
    }
    (found, left)
}
