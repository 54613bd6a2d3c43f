//! Documents as JSON. All pass through [`Value`]: each way to write or read a type is compiled by itself, and there are many types.

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use super::ExportError;

/// A document that the program gives to other programs: it says what it is.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no document",
    note = "name it, with its kind, in the list of src/cli/documents.rs"
)]
pub trait Document: Serialize {
    /// What it is: the verb that gives it.
    const KIND: &'static str;
    /// The version of its form.
    const FORMAT: u32 = 1;
}

/// A document with its kind and its format first.
///
/// # Errors
/// If it holds what JSON cannot say.
pub fn document<D: Document>(document: &D) -> Result<Value, ExportError> {
    let mut whole = Map::new();
    whole.insert("kind".to_string(), D::KIND.into());
    whole.insert("format".to_string(), D::FORMAT.into());
    match tree(document)? {
        Value::Object(entries) => whole.extend(entries),
        list => {
            whole.insert(D::KIND.to_string(), list);
        }
    }
    Ok(Value::Object(whole))
}

/// The kind that a document says it is; none in those of versions that did not say it.
pub fn kind(document: &Value) -> Option<&str> {
    document.get("kind")?.as_str()
}

/// A document as a tree.
///
/// # Errors
/// If it holds what JSON cannot say.
pub fn tree(document: &impl Serialize) -> Result<Value, ExportError> {
    serde_json::to_value(document).map_err(encoding)
}

/// A document as text for people, without a line feed at its end.
///
/// # Errors
/// If it holds what JSON cannot say.
pub fn text(document: &impl Serialize) -> Result<String, ExportError> {
    serde_json::to_string_pretty(&tree(document)?).map_err(encoding)
}

/// A document in as few bytes as there can be.
///
/// # Errors
/// If it holds what JSON cannot say.
pub fn bytes(document: &impl Serialize) -> Result<Vec<u8>, ExportError> {
    serde_json::to_vec(&tree(document)?).map_err(encoding)
}

/// The document of a text.
///
/// # Errors
/// If it is no JSON, or another document.
pub fn read<T: DeserializeOwned>(text: &[u8]) -> Result<T, serde_json::Error> {
    of(&serde_json::from_slice(text)?)
}

/// The document of a tree.
///
/// # Errors
/// If it is another document.
pub fn of<T: DeserializeOwned>(tree: &Value) -> Result<T, serde_json::Error> {
    T::deserialize(tree)
}

fn encoding(error: serde_json::Error) -> ExportError {
    ExportError::Encoding {
        format: "JSON",
        reason: error.to_string(),
    }
}
