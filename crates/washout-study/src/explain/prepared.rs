//! A choice of words and alternatives, ready to be searched.

use super::answers::Answers;
use super::choices::Choice;
use super::model::Model;

/// A choice of words and alternatives, its model, and how that answers.
#[derive(Debug)]
pub struct Prepared {
    /// The choice.
    pub choice: Choice,
    /// Its model.
    pub model: Model,
    /// How it answers to every change alone.
    pub answers: Answers,
}
