//! A TOML file as a tree in which every value knows where it stands.

mod parse;

use std::ops;
use std::rc::Rc;

use super::error::{Number, Place};
use super::path::{KeyPath, Step};

/// Where values come from: a file, or the command line.
#[derive(Debug)]
pub(crate) struct Source {
    file: String,
    text: String,
    numbered: bool,
}

impl Source {
    /// A file with its text: places have line and column.
    pub fn file(file: &str, text: &str) -> Rc<Source> {
        Rc::new(Source {
            file: file.to_string(),
            text: text.to_string(),
            numbered: true,
        })
    }

    /// Something without lines, such as `--set`.
    pub fn other(name: &str) -> Rc<Source> {
        Rc::new(Source {
            file: name.to_string(),
            text: String::new(),
            numbered: false,
        })
    }

    /// The place of a byte of the text.
    pub fn place(&self, byte: usize) -> Place {
        if !self.numbered {
            return Place::file(&self.file);
        }
        let before = self.text.get(..byte).unwrap_or(&self.text);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Place {
            file: self.file.clone(),
            line: Some(before.matches('\n').count() + 1),
            column: Some(before[line_start..].chars().count() + 1),
        }
    }
}

/// A value with its place.
#[derive(Debug, Clone)]
pub(crate) struct Node {
    source: Rc<Source>,
    span: ops::Range<usize>,
    /// The value.
    pub value: NodeValue,
}

/// What a value can be.
#[derive(Debug, Clone)]
pub(crate) enum NodeValue {
    /// Text.
    Text(String),
    /// Whole number.
    Integer(i64),
    /// Other number, NaN and infinity included.
    Float(f64),
    /// True or false.
    Boolean(bool),
    /// Date or time, which no key wants.
    Date,
    /// List.
    List(Vec<Node>),
    /// Table, in the order of the file.
    Table(Vec<Entry>),
}

/// A key with its value.
#[derive(Debug, Clone)]
pub(crate) struct Entry {
    /// The key.
    pub key: String,
    /// Its value.
    pub node: Node,
    key_start: usize,
}

impl Entry {
    /// Where the key stands.
    pub fn place(&self) -> Place {
        self.node.source.place(self.key_start)
    }
}

impl Node {
    /// A value without a text of its own.
    pub fn new(source: &Rc<Source>, value: NodeValue) -> Node {
        Node {
            source: source.clone(),
            span: 0..0,
            value,
        }
    }

    /// Another value at the same place.
    pub fn with_value(&self, value: NodeValue) -> Node {
        Node {
            source: self.source.clone(),
            span: self.span.clone(),
            value,
        }
    }

    /// The tree of a value that was in memory.
    pub fn from_value(source: &Rc<Source>, value: &toml::Value) -> Node {
        let value = match value {
            toml::Value::String(text) => NodeValue::Text(text.clone()),
            toml::Value::Integer(number) => NodeValue::Integer(*number),
            toml::Value::Float(number) => NodeValue::Float(*number),
            toml::Value::Boolean(flag) => NodeValue::Boolean(*flag),
            toml::Value::Datetime(_) => NodeValue::Date,
            toml::Value::Array(items) => {
                NodeValue::List(items.iter().map(|item| Node::from_value(source, item)).collect())
            }
            toml::Value::Table(table) => NodeValue::Table(
                table
                    .iter()
                    .map(|(key, item)| Entry {
                        key: key.clone(),
                        node: Node::from_value(source, item),
                        key_start: 0,
                    })
                    .collect(),
            ),
        };
        Node::new(source, value)
    }

    /// The plain value for deserialization; as JSON, since documents are read from that too, and each way to read a type is compiled
    /// by itself. A number that is not finite, which [`crate::input::form`] refuses, is null.
    pub fn to_json(&self) -> serde_json::Value {
        match &self.value {
            NodeValue::Text(text) => text.as_str().into(),
            NodeValue::Integer(number) => (*number).into(),
            NodeValue::Float(number) => (*number).into(),
            NodeValue::Boolean(flag) => (*flag).into(),
            NodeValue::Date => self.shown().into(),
            NodeValue::List(items) => items.iter().map(Node::to_json).collect(),
            NodeValue::Table(entries) => (entries.iter())
                .map(|entry| (entry.key.clone(), entry.node.to_json()))
                .collect(),
        }
    }

    /// The plain value.
    pub fn to_value(&self) -> toml::Value {
        match &self.value {
            NodeValue::Text(text) => toml::Value::String(text.clone()),
            NodeValue::Integer(number) => toml::Value::Integer(*number),
            NodeValue::Float(number) => toml::Value::Float(*number),
            NodeValue::Boolean(flag) => toml::Value::Boolean(*flag),
            NodeValue::Date => toml::Value::String(self.shown()),
            NodeValue::List(items) => toml::Value::Array(items.iter().map(Node::to_value).collect()),
            NodeValue::Table(entries) => toml::Value::Table(
                entries
                    .iter()
                    .map(|entry| (entry.key.clone(), entry.node.to_value()))
                    .collect(),
            ),
        }
    }

    /// Where the value stands.
    pub fn place(&self) -> Place {
        self.source.place(self.span.start)
    }

    /// The file that the value stands in, without a line.
    pub fn file(&self) -> Place {
        Place::file(&self.source.file)
    }

    /// The value as it stands in the file; empty for tables that have their own header.
    pub fn shown(&self) -> String {
        let text = self.source.text.get(self.span.clone()).unwrap_or_default();
        match &self.value {
            NodeValue::Table(_) if !text.starts_with('{') => String::new(),
            NodeValue::List(items) if text.starts_with("[[") && items.iter().all(Node::is_table) => {
                String::new()
            }
            _ if !text.is_empty() => text.to_string(),
            NodeValue::Float(number) => Number(*number).to_string(),
            NodeValue::List(_) => {
                let text = self.to_value().to_string();
                text.lines().map(str::trim).collect::<Vec<_>>().join(" ")
            }
            _ => self.to_value().to_string(),
        }
    }

    /// What kind of value it is, with its article.
    pub fn kind(&self) -> &'static str {
        match &self.value {
            NodeValue::Text(_) => "text",
            NodeValue::Integer(_) => "a whole number",
            NodeValue::Float(_) => "a decimal number",
            NodeValue::Boolean(_) => "true or false",
            NodeValue::Date => "a date",
            NodeValue::List(_) => "a list",
            NodeValue::Table(_) => "a table",
        }
    }

    /// The number, if it is one.
    pub fn number(&self) -> Option<f64> {
        match &self.value {
            NodeValue::Integer(number) => Some(*number as f64),
            NodeValue::Float(number) => Some(*number),
            _ => None,
        }
    }

    /// Whether it is a table.
    pub fn is_table(&self) -> bool {
        matches!(self.value, NodeValue::Table(_))
    }

    /// The text, if it is text.
    pub fn text(&self) -> Option<&str> {
        match &self.value {
            NodeValue::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The value of a key, if this is a table that has it.
    pub fn get(&self, key: &str) -> Option<&Node> {
        match &self.value {
            NodeValue::Table(entries) => entries
                .iter()
                .find(|entry| entry.key == key)
                .map(|entry| &entry.node),
            _ => None,
        }
    }

    /// The value at a path, if there is one.
    pub fn at(&self, path: &KeyPath) -> Option<&Node> {
        path.0
            .iter()
            .try_fold(self, |node, step| match (step, &node.value) {
                (Step::Key(key), _) => node.get(key),
                (Step::Index(index), NodeValue::List(items)) => items.get(*index),
                _ => None,
            })
    }

    /// The number of entries, if this is a list.
    pub fn length(&self) -> Option<usize> {
        match &self.value {
            NodeValue::List(items) => Some(items.len()),
            _ => None,
        }
    }

    /// The value one step below, if there is one.
    pub fn child_mut(&mut self, step: &Step) -> Option<&mut Node> {
        match (step, &mut self.value) {
            (Step::Index(index), NodeValue::List(items)) => items.get_mut(*index),
            (Step::Key(key), NodeValue::Table(entries)) => {
                let entry = entries.iter_mut().find(|entry| entry.key == *key);
                entry.map(|entry| &mut entry.node)
            }
            _ => None,
        }
    }

    /// Puts `node` under `key` of this table, in place of what stood there. Nothing if this is no table.
    pub fn put(&mut self, key: &str, node: Node) {
        if let NodeValue::Table(entries) = &mut self.value {
            match entries.iter_mut().find(|entry| entry.key == key) {
                Some(entry) => {
                    entry.key_start = node.span.start;
                    entry.node = node;
                }
                None => entries.push(Entry {
                    key: key.to_string(),
                    key_start: node.span.start,
                    node,
                }),
            }
        }
    }

    /// Calls the key `earlier` of this table by its name of today, unless that stands there too.
    pub fn rename(&mut self, earlier: &str, today: &str) {
        if self.get(today).is_some() {
            return;
        }
        if let NodeValue::Table(entries) = &mut self.value
            && let Some(entry) = entries.iter_mut().find(|entry| entry.key == earlier)
        {
            entry.key = today.to_string();
        }
    }

    /// Adds an entry of another table, which keeps its place. Nothing if this is no table.
    pub fn add(&mut self, entry: Entry) {
        if let NodeValue::Table(entries) = &mut self.value {
            entries.push(entry);
        }
    }

    pub(super) fn forget_spans(&mut self) {
        self.span = 0..0;
        match &mut self.value {
            NodeValue::List(items) => items.iter_mut().for_each(Node::forget_spans),
            NodeValue::Table(entries) => {
                for entry in entries {
                    entry.key_start = 0;
                    entry.node.forget_spans();
                }
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_know_their_place() {
        let text = "# ä\nname = \"x\"\n[a]\nb = { c = -3 }\n[[d]]\ne = [1, 2]\n";
        let root = Node::parse_file("f.toml", text).unwrap();
        let at = |path: &str| root.at(&KeyPath::parse(path).unwrap()).unwrap().clone();
        assert_eq!(at("name").place().to_string(), "f.toml:2:8");
        assert_eq!(at("a.b.c").place().to_string(), "f.toml:4:11");
        assert_eq!(at("a.b.c").shown(), "-3");
        assert_eq!(at("d[0].e[1]").place().to_string(), "f.toml:6:9");
        assert_eq!(at("d[0]").place().to_string(), "f.toml:5:1");
        assert_eq!(at("a").place().to_string(), "f.toml:3:1");
        assert_eq!(at("d").shown(), "");
    }

    #[test]
    fn huge_integers_and_underscored_numbers_become_numbers() {
        let root = Node::parse_file(
            "f.toml",
            "a = 99999999999999999999\nb = 1_000\nc = 0x1f\nd = 1_000.2_5",
        )
        .unwrap();
        assert_eq!(root.get("a").unwrap().number(), Some(1e20));
        assert_eq!(root.get("b").unwrap().number(), Some(1000.0));
        assert_eq!(root.get("c").unwrap().number(), Some(31.0));
        assert_eq!(root.get("d").unwrap().number(), Some(1000.25));
    }

    #[test]
    fn words_on_the_command_line_need_no_quotes() {
        let source = Source::other("--set");
        assert_eq!(Node::parse_value(&source, "linear").text(), Some("linear"));
        assert_eq!(Node::parse_value(&source, "-2.5").number(), Some(-2.5));
    }
}
