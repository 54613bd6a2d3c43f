//! What stands behind the guard: something that answers what was let pass.

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::live::refusal::Refusal;

use hyper::StatusCode;

use super::answer::{self, Answer};
use super::guard::Passed;
use super::token::Token;

/// What gives the page; its argument is the nonce by which its scripts and styles are known.
pub type Page = fn(nonce: &str) -> String;

/// Why there is no answer.
pub enum Fault {
    /// It is none that can be asked.
    Status(StatusCode),
    /// It is refused, and the page says why.
    Refusal(Refusal),
}

impl From<Refusal> for Fault {
    fn from(refusal: Refusal) -> Fault {
        Fault::Refusal(refusal)
    }
}

/// What answers the questions of a page.
pub trait Service: Send + Sync {
    /// What is asked without changing anything.
    ///
    /// # Errors
    /// If there is no such thing, or it is refused.
    fn get(&self, asked: &Passed) -> Result<Answer, Fault>;

    /// What changes something.
    ///
    /// # Errors
    /// If there is no such thing, or it is refused.
    fn post(&self, path: &str, body: &[u8]) -> Result<Answer, Fault>;
}

/// Answers a request that was let pass.
pub fn answer(service: &dyn Service, asked: &Passed, body: &[u8]) -> Answer {
    let answer = match asked.is_post {
        true => service.post(&asked.path, body),
        false => service.get(asked),
    };
    answer.unwrap_or_else(|fault| match fault {
        Fault::Status(status) => answer::empty(status),
        Fault::Refusal(refusal) => {
            let error = serde_json::json!({ "error": refusal });
            answer::json(StatusCode::UNPROCESSABLE_ENTITY, error.to_string())
        }
    })
}

/// The page, with a nonce of its own.
///
/// # Errors
/// If the system gives no random numbers.
pub fn page(page: Page) -> Result<Answer, Fault> {
    let nonce = Token::random().map_err(|error| Fault::Refusal(Refusal::new(error)))?;
    Ok(answer::page(page(nonce.text()), nonce.text()))
}

/// A value as JSON.
///
/// # Errors
/// If it cannot be written so.
pub fn document(value: &impl Serialize) -> Result<Answer, Fault> {
    let text = serde_json::to_vec(value).map_err(|error| Refusal::new(error.to_string()))?;
    Ok(answer::json(StatusCode::OK, text))
}

/// What is new, or that nothing is.
pub fn news(text: Option<Vec<u8>>) -> Answer {
    match text {
        Some(text) => answer::json(StatusCode::OK, text),
        None => answer::empty(StatusCode::NO_CONTENT),
    }
}

/// A body as a value.
///
/// # Errors
/// If it is none.
pub fn read<T: DeserializeOwned>(body: &[u8]) -> Result<T, Fault> {
    serde_json::from_slice(body).map_err(|_| Fault::Status(StatusCode::BAD_REQUEST))
}

/// A parameter of the query.
pub fn parameter<'a>(asked: &'a Passed, name: &str) -> Option<&'a str> {
    let mut found = asked.query.iter().filter(|(own, _)| own == name);
    found.next().map(|(_, value)| value.as_str())
}

/// A parameter that is a whole number.
///
/// # Errors
/// If it is none.
pub fn whole(asked: &Passed, name: &str) -> Result<Option<u64>, Fault> {
    let value = parameter(asked, name).map(str::parse);
    value
        .transpose()
        .map_err(|_| Fault::Status(StatusCode::BAD_REQUEST))
}
