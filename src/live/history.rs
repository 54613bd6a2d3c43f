//! What can be taken back and done again; moves of one gesture are one step.

use super::values::Values;

/// Steps that are kept.
const MOST: usize = 500;

/// A step: what was before it, and what it did in words.
#[derive(Debug, Clone)]
struct Step {
    before: Values,
    after: Values,
    words: String,
    /// What a gesture moves, while it goes on.
    gesture: Option<String>,
}

/// Steps done and taken back.
#[derive(Debug, Clone, Default)]
pub struct History {
    done: Vec<Step>,
    undone: Vec<Step>,
}

impl History {
    /// Adds a step; `gesture`: what is moved, and whether the gesture goes on. What was taken back is forgotten. `words` has what the
    /// whole step did, given the values before it.
    pub fn add(
        &mut self,
        before: &Values,
        after: &Values,
        gesture: Option<(&str, bool)>,
        words: impl Fn(&Values) -> String,
    ) {
        let moved = gesture.map(|(moved, _)| moved);
        let goes_on = |step: &&mut Step| moved.is_some() && step.gesture.as_deref() == moved;
        let open = gesture
            .filter(|(_, more)| *more)
            .map(|(moved, _)| moved.to_string());
        if let Some(step) = self.done.last_mut().filter(goes_on) {
            step.words = words(&step.before);
            step.after = after.clone();
            step.gesture = open;
            if step.before == step.after && step.gesture.is_none() {
                self.done.pop();
            }
        } else if before != after {
            self.close();
            self.done.push(Step {
                words: words(before),
                before: before.clone(),
                after: after.clone(),
                gesture: open,
            });
        } else {
            return;
        }
        self.undone.clear();
        if self.done.len() > MOST {
            self.done.remove(0);
        }
    }

    /// Ends a gesture: the next move is a step of its own.
    pub fn close(&mut self) {
        if let Some(step) = self.done.last_mut() {
            step.gesture = None;
        }
    }

    /// Takes the last step back and gives what was before it.
    pub fn undo(&mut self) -> Option<Values> {
        self.close();
        let step = self.done.pop()?;
        let before = step.before.clone();
        self.undone.push(step);
        Some(before)
    }

    /// Does the last step that was taken back again, and gives what is after it.
    pub fn redo(&mut self) -> Option<Values> {
        let step = self.undone.pop()?;
        let after = step.after.clone();
        self.done.push(step);
        Some(after)
    }

    /// What undo takes back, in words.
    pub fn undo_words(&self) -> Option<&str> {
        self.done.last().map(|step| step.words.as_str())
    }

    /// What redo does again, in words.
    pub fn redo_words(&self) -> Option<&str> {
        self.undone.last().map(|step| step.words.as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(value: f64) -> Values {
        let mut values = Values::default();
        values.numbers.insert("k".to_string(), value);
        values
    }

    fn from(values: &Values) -> String {
        format!("from {}", values.numbers["k"])
    }

    #[test]
    fn moves_of_one_gesture_are_one_step() {
        let mut history = History::default();
        for (before, after, more) in [(1.0, 2.0, true), (2.0, 3.0, true), (3.0, 3.0, false)] {
            history.add(&at(before), &at(after), Some(("k", more)), from);
        }
        history.add(&at(3.0), &at(4.0), Some(("k", false)), from);
        assert_eq!(history.undo_words(), Some("from 3"));
        assert_eq!(history.undo(), Some(at(3.0)));
        assert_eq!(history.undo(), Some(at(1.0)));
        assert_eq!(history.undo(), None);
        assert_eq!(history.redo(), Some(at(3.0)));
        assert_eq!(history.redo(), Some(at(4.0)));
        assert_eq!(history.redo(), None);
    }

    #[test]
    fn a_gesture_that_ends_where_it_began_is_no_step() {
        let mut history = History::default();
        history.add(&at(1.0), &at(2.0), Some(("k", true)), from);
        history.add(&at(2.0), &at(1.0), Some(("k", false)), from);
        assert_eq!(history.undo_words(), None);
    }

    #[test]
    fn a_move_forgets_what_was_taken_back() {
        let mut history = History::default();
        history.add(&at(1.0), &at(2.0), None, from);
        history.undo();
        history.add(&at(1.0), &at(1.0), None, from);
        assert_eq!(history.redo_words(), Some("from 1"));
        history.add(&at(1.0), &at(5.0), None, from);
        assert_eq!(history.redo_words(), None);
    }
}
