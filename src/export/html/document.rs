//! A JSON document that stands in the page, and the numbers that are shown of it.

use serde_json::Value;

use crate::export::{ExportError, json};
pub use crate::page::Digits;

use super::script::in_script;
use crate::plot::pen::escaped;

/// Something that stands in a cell: HTML, and whether it is a number.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Shown {
    /// HTML, escaped already.
    pub html: String,
    /// Whether it is a number, to be set to the right.
    pub is_number: bool,
}

impl Shown {
    /// Text of any origin.
    pub fn text(text: impl AsRef<str>) -> Shown {
        Shown {
            html: escaped(text.as_ref()),
            is_number: false,
        }
    }

    /// The same with something before it, such as the `<` of a bound.
    pub fn after(self, sign: &str) -> Shown {
        Shown {
            html: format!("{}{}", escaped(sign), self.html),
            ..self
        }
    }
}

/// A document of the page.
#[derive(Debug, Clone, PartialEq)]
pub struct Document {
    /// What it is called in the page: `summary`, `comparison`, `diagnosis`.
    pub id: &'static str,
    /// What it holds.
    pub value: Value,
}

impl Document {
    /// A document from what it holds.
    ///
    /// # Errors
    /// If it cannot be written as JSON.
    pub fn new(id: &'static str, content: &impl json::Document) -> Result<Document, ExportError> {
        let value = json::document(content)?;
        Ok(Document { id, value })
    }

    /// A document that was read.
    pub fn of(id: &'static str, value: Value) -> Document {
        Document { id, value }
    }

    /// The number at a place (JSON pointer); nothing where there is none.
    pub fn number(&self, place: &str, digits: Digits) -> Shown {
        match self.value.pointer(place).and_then(Value::as_f64) {
            Some(value) => self.shown(place, digits.show(value)),
            None => Shown {
                html: String::new(),
                is_number: true,
            },
        }
    }

    /// The number at a place as it stands there.
    pub fn exact(&self, place: &str) -> Shown {
        match self.value.pointer(place) {
            Some(Value::Number(value)) => self.shown(place, value.to_string()),
            _ => Shown {
                html: String::new(),
                is_number: true,
            },
        }
    }

    /// The document as an element of the page.
    pub fn element(&self) -> String {
        format!(
            "<script type=\"application/json\" id=\"{}\">{}</script>\n",
            self.id,
            in_script(&self.value.to_string())
        )
    }

    fn shown(&self, place: &str, text: String) -> Shown {
        let value = self
            .value
            .pointer(place)
            .map(Value::to_string)
            .unwrap_or_default();
        Shown {
            html: format!(
                "<data value=\"{}\" data-in=\"{}\" data-of=\"{}\">{}</data>",
                escaped(&value),
                self.id,
                escaped(place),
                escaped(&text)
            ),
            is_number: true,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shown_number_says_where_it_stands_and_keeps_all_its_digits() {
        let document = Document::of("summary", serde_json::json!({"tip": [{"twist_deg": 20.583}]}));
        let shown = document.number("/tip/0/twist_deg", Digits::After(1));
        assert_eq!(
            shown.html,
            "<data value=\"20.583\" data-in=\"summary\" data-of=\"/tip/0/twist_deg\">20.6</data>"
        );
        assert_eq!(document.number("/tip/1/twist_deg", Digits::After(1)).html, "");
    }
}
