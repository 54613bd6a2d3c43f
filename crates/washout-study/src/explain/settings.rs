//! How wide an explanation is searched.

/// How wide is searched. [`Settings::default`] is what the documentation describes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Settings {
    /// Most changes of a set.
    pub most_changes: usize,
    /// Most sets that are shown.
    pub shown: usize,
    /// Sets of each size, of all choices together, that are solved in the full model as they were found.
    pub solved: usize,
    /// Of these the least costly, which are fitted in it.
    pub fitted: usize,
    /// Sets of each size and choice from which larger ones grow.
    pub grown: usize,
    /// Whether it is told what the sets predict and what would refute them.
    pub predicts: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            most_changes: 4,
            shown: 8,
            solved: 160,
            fitted: 40,
            grown: 40,
            predicts: true,
        }
    }
}
