//! Units at the border: the suffix of a key, its symbol and its name.

/// A unit as it stands at the end of a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Unit {
    /// Suffix of a key, without the leading underscore.
    pub suffix: &'static str,
    /// Symbol, for ranges.
    pub symbol: &'static str,
    /// Name, for sentences.
    pub name: &'static str,
}

/// Symbol of the unit in a key's name, such as mm in `at_mm`; none if it names none.
pub fn unit_symbol(key: &str) -> Option<&'static str> {
    of_key(key).map(|unit| unit.symbol)
}

const fn unit(suffix: &'static str, symbol: &'static str, name: &'static str) -> Unit {
    Unit { suffix, symbol, name }
}

/// Units that design files use; longer suffixes first.
pub(crate) const USED: &[Unit] = &[
    unit("n_m_per_rad", "N·m/rad", "newton metres per radian"),
    unit("n_per_m", "N/m", "newtons per metre"),
    unit("per_rad", "1/rad", "one per radian"),
    unit("kg_m3", "kg/m³", "kilograms per cubic metre"),
    unit("kg_m2_per_m", "kg·m²/m", "kilogram square metres per metre"),
    unit("kg_m2", "kg·m²", "kilogram square metres"),
    unit("kg_m", "kg/m", "kilograms per metre"),
    unit("n_m2", "N·m²", "newton square metres"),
    unit("n_m", "N·m", "newton metres"),
    unit("m_s2", "m/s²", "metres per second squared"),
    unit("m_s", "m/s", "metres per second"),
    unit("mm", "mm", "millimetres"),
    unit("deg", "deg", "degrees"),
    unit("hz", "Hz", "hertz"),
    unit("gpa", "GPa", "gigapascals"),
    unit("mpa", "MPa", "megapascals"),
    unit("kg", "kg", "kilograms"),
    unit("n", "N", "newtons"),
];

/// Suffixes of units that people write but that these files do not use.
const FOREIGN: &[&str] = &[
    "g_cm3",
    "kg_mm3",
    "n_mm_per_rad",
    "n_mm2",
    "n_mm",
    "nmm",
    "nm2",
    "nm",
    "rad_s",
    "km_h",
    "mm_s",
    "cm_s",
    "ft_s",
    "g_m",
    "mn_m",
    "n_mm_1",
    "per_deg",
    "cm",
    "um",
    "micron",
    "microns",
    "inch",
    "in",
    "ft",
    "m",
    "rad",
    "degrees",
    "degree",
    "rpm",
    "khz",
    "ghz",
    "rps",
    "pa",
    "kpa",
    "psi",
    "ksi",
    "msi",
    "g",
    "mg",
    "mn",
    "kn",
    "s",
    "ms",
    "hertz",
    "meters",
    "metres",
    "millimeters",
    "millimetres",
    "percent",
    "kph",
    "mph",
];

/// The unit of a key, by its suffix; none for a pure number.
pub(crate) fn of_key(key: &str) -> Option<Unit> {
    USED.iter().copied().find(|unit| stem(key, unit.suffix).is_some())
}

/// The key without any unit at its end, whether these files use that unit or not.
pub(crate) fn without_unit(key: &str) -> &str {
    let used = USED.iter().map(|unit| unit.suffix);
    let mut best = key;
    for suffix in used.chain(FOREIGN.iter().copied()) {
        if let Some(stem) = stem(key, suffix)
            && stem.len() < best.len()
        {
            best = stem;
        }
    }
    best
}

fn stem<'k>(key: &'k str, suffix: &str) -> Option<&'k str> {
    key.strip_suffix(suffix)?
        .strip_suffix('_')
        .filter(|stem| !stem.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_suffix_is_the_unit() {
        assert_eq!(of_key("pretension_n_per_m").unwrap().symbol, "N/m");
        assert_eq!(of_key("gj_n_m2").unwrap().symbol, "N·m²");
        assert_eq!(of_key("moment_n_m").unwrap().symbol, "N·m");
        assert_eq!(of_key("ea_n").unwrap().symbol, "N");
        assert_eq!(of_key("drilling_factor"), None);
        assert_eq!(of_key("r2_hat"), None);
    }

    #[test]
    fn foreign_units_come_off() {
        assert_eq!(without_unit("length_cm"), "length");
        assert_eq!(without_unit("frequency_rpm"), "frequency");
        assert_eq!(without_unit("gj_n_m2"), "gj");
        assert_eq!(without_unit("pitch_stiffness_n_mm_per_rad"), "pitch_stiffness");
        assert_eq!(without_unit("name"), "name");
    }
}
