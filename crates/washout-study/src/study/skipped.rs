//! Measured rows that take no part, and why not: nothing is dropped in silence.

use std::fmt;

use crate::input::measurement::Channel;
use crate::input::study::UnusedRows;

/// A measured row that takes no part.
#[derive(Debug, Clone, PartialEq)]
pub struct SkippedRow {
    /// Name of the case.
    pub case: String,
    /// Line of the measurement file.
    pub line: usize,
    /// Channel.
    pub channel: Channel,
    /// Why.
    pub reason: String,
}

impl fmt::Display for SkippedRow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (case, line, channel) = (&self.case, self.line, self.channel.name());
        write!(f, "{case}, line {line}, {channel}: {}", self.reason)
    }
}

/// All of them in words.
pub fn in_words(skipped: &[SkippedRow], unused: &[UnusedRows]) -> Vec<String> {
    let skipped = skipped.iter().map(SkippedRow::to_string);
    skipped.chain(unused.iter().map(UnusedRows::to_string)).collect()
}
