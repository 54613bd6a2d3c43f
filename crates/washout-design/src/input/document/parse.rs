//! From the TOML parser's tree to ours.

use std::rc::Rc;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::{Entry, Node, NodeValue, Source};
use crate::input::error::{InputError, Problem};
use crate::input::syntax;

impl Node {
    /// Reads a whole file.
    pub fn parse_file(file: &str, text: &str) -> Result<Node, InputError> {
        let source = Source::file(file, text);
        let table = DeTable::parse(text).map_err(|error| syntax_error(&source, &error))?;
        let span = table.span();
        Ok(Node {
            value: table_value(&source, table.into_inner()),
            source,
            span,
        })
    }

    /// Reads one value from `source`, which is no file; text that is no TOML value counts as a word.
    pub fn parse_value(source: &Rc<Source>, text: &str) -> Node {
        match DeValue::parse(text) {
            Ok(value) => {
                let mut node = node(source, value);
                node.forget_spans();
                node
            }
            Err(_) => Node::new(source, NodeValue::Text(text.to_string())),
        }
    }
}

fn node(source: &Rc<Source>, value: Spanned<DeValue<'_>>) -> Node {
    let span = value.span();
    let value = match value.into_inner() {
        DeValue::String(text) => NodeValue::Text(text.into_owned()),
        DeValue::Integer(number) => match i64::from_str_radix(number.as_str(), number.radix()) {
            Ok(number) => NodeValue::Integer(number),
            Err(_) => NodeValue::Float(number.as_str().parse().unwrap_or(f64::INFINITY)),
        },
        DeValue::Float(number) => NodeValue::Float(number.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(flag) => NodeValue::Boolean(flag),
        DeValue::Datetime(_) => NodeValue::Date,
        DeValue::Array(items) => NodeValue::List(items.into_iter().map(|item| node(source, item)).collect()),
        DeValue::Table(table) => table_value(source, table),
    };
    Node {
        source: source.clone(),
        span,
        value,
    }
}

fn table_value(source: &Rc<Source>, table: DeTable<'_>) -> NodeValue {
    let entries = table.into_iter().map(|(key, value)| Entry {
        key_start: key.span().start,
        key: key.into_inner().into_owned(),
        node: node(source, value),
    });
    NodeValue::Table(entries.collect())
}

fn syntax_error(source: &Source, error: &toml::de::Error) -> InputError {
    let byte = error.span().map_or(0, |span| span.start);
    let place = source.place(byte);
    let before = source.text.get(..byte).unwrap_or_default();
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = source.text.get(line_start..).and_then(|rest| rest.lines().next());
    let (message, cure) = syntax::explain(
        line.unwrap_or_default(),
        place.column.unwrap_or(1),
        error.message().trim(),
    );
    InputError::new(place, "", "", Problem::Syntax { message }, cure)
}
