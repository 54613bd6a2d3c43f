//! How wide an explanation is searched.

/// How wide is searched. [`Settings::default`] is what the documentation describes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Settings {
    /// Most changes of a set.
    pub most_changes: usize,
    /// Most sets that are shown.
    pub shown: usize,
    /// Sets of each size, of all choices together, that are solved in full.
    pub solved: usize,
    /// Sets of each size and choice from which larger ones grow.
    pub grown: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            most_changes: 4,
            shown: 8,
            solved: 120,
            grown: 60,
        }
    }
}
