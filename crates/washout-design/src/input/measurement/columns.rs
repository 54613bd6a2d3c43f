//! What each column of a measurement file holds, in words for the reference.

/// Columns in the order of the file, those that may be left out at the end.
pub const COLUMN_WORDS: [(&str, &str); 13] = [
    (
        "case",
        "Which wing at which condition. A design names its case under `[measured]`, a study under `measured`.",
    ),
    ("channel", "What was measured: one of the channels below."),
    (
        "instrument",
        "How a twist was read: `chord_rotation` (angle of the deformed chord line about the span axis) or `camera` (projected \
         distance between the edges in a video frame); empty for other channels.",
    ),
    (
        "unit",
        "The unit of value and sigma, as a check: that of the channel.",
    ),
    (
        "sign",
        "Of twist: `washout` where a positive value lowers the angle of attack, `nose_up` where it raises it; empty for other channels.",
    ),
    (
        "run",
        "Name of the run, to tell repeats apart and readings that share a zero or a scale; may be empty.",
    ),
    (
        "r_mm",
        "Station, or inner end of the interval, from the wing base, mm; empty for channels of the whole wing.",
    ),
    (
        "r_to_mm",
        "Outer end of the interval, mm, for `twist_rate`; empty for others.",
    ),
    (
        "value",
        "The value in the unit of the channel. Empty where it is yet to be measured: for `diagnose --plan`, `synthesize` and \
         `[[experiment]]`.",
    ),
    (
        "sigma",
        "One standard deviation of the value, in its unit, above 0.",
    ),
    (
        "sigma_kind",
        "Where sigma comes from: `stated` by the source, `repeats`, or `assumed`.",
    ),
    (
        "bound",
        "`none`; `upper` or `lower` where the true value lies below or above the one given.",
    ),
    (
        "chord_fraction",
        "Of displacements: the place on the chord, 0 at the leading edge (and where nothing stands), 1 at the trailing edge.",
    ),
];

#[cfg(test)]
mod tests {
    use super::super::{COLUMNS, OPTIONAL_COLUMNS};
    use super::COLUMN_WORDS;

    #[test]
    fn the_words_are_those_of_the_columns_that_are_read() {
        let named = COLUMN_WORDS.map(|(column, _)| column);
        assert_eq!(named.to_vec(), [&COLUMNS[..], &OPTIONAL_COLUMNS[..]].concat());
    }
}
