//! Changing a design by dotted keys: `--set key=value`, sweeps, uncertainty.

use std::rc::Rc;

use super::checked::design_of;
use super::design::Design;
use super::document::{Node, NodeValue, Source};
use super::error::{InputError, Place, Problem};
use super::keys::{self, Kind};
use super::path::{KeyPath, Step};

/// One `key=value` of the command line, read.
pub(crate) struct Setting {
    path: KeyPath,
    node: Node,
}

const NAME: &str = "--set";

impl Setting {
    /// Reads `key=value`. Words need no quotes.
    pub fn parse(text: &str) -> Result<Setting, InputError> {
        let fault = |message: String, cure: String| {
            let problem = Problem::Syntax { message };
            Err(InputError::new(Place::file(NAME), text, "", problem, cure))
        };
        let example = "Write e.g. --set flapping.frequency_hz=23 or --set 'rod[0].section.diameter_mm=0.8'";
        let Some((key, value)) = text.split_once('=') else {
            return fail_without_equals(text, example);
        };
        let path = match KeyPath::parse(key.trim()) {
            Ok(path) => path,
            Err(message) => return fault(format!("is no dotted key: {message}"), example.to_string()),
        };
        let value = value.trim();
        if value.is_empty() {
            return fault("has no value".to_string(), example.to_string());
        }
        let source = Source::other(NAME);
        let mut node = Node::parse_value(&source, value);
        let wants_word = matches!(keys::design().at(&path), Some(Kind::Text | Kind::Choice(_)));
        if wants_word && node.text().is_none() {
            node = Node::new(&source, NodeValue::Text(value.to_string()));
        }
        Ok(Setting { path, node })
    }

    /// Whether it sets this top-level key.
    pub fn is_for(&self, key: &str) -> bool {
        matches!(&self.path.0[..], [Step::Key(name)] if name == key)
    }

    /// Puts the value into the tree of a design.
    pub fn apply(&self, root: &mut Node) -> Result<(), InputError> {
        put(root, &self.path, self.node.clone())
    }
}

fn fail_without_equals(text: &str, example: &str) -> Result<Setting, InputError> {
    let message = "must be KEY=VALUE".to_string();
    Err(InputError::new(
        Place::file(NAME),
        text,
        "",
        Problem::Syntax { message },
        example,
    ))
}

impl Design {
    /// Sets the number at a dotted key, such as `rod[0].section.diameter_mm`, in the unit of the key.
    ///
    /// An assumed number stays assumed while the value lies in its range; outside of it, it becomes stated.
    /// The design is checked as if it were read anew, and left as it was where the result is refused.
    pub fn set(&mut self, key: &str, value: f64) -> Result<(), InputError> {
        // no other number of a design depends on a plain one of an effect
        if value.is_finite()
            && let Some(number) = self.effect_number(key)
        {
            *number = value;
            return Ok(());
        }
        let source = Source::other("set");
        let path = read_path(&source, key)?;
        let mut root = self.tree(&source)?;
        let number = match keys::design().at(&path) {
            Some(Kind::Count(_)) if value.fract() == 0.0 && value.abs() < 1e15 => {
                NodeValue::Integer(value as i64)
            }
            _ => NodeValue::Float(value),
        };
        let mut node = Node::new(&source, number);
        if let Some(old) = root.at(&path)
            && let Some(kept) = still_assumed(old, value)
        {
            node = kept;
        }
        put(&mut root, &path, node)?;
        *self = design_of(&root)?;
        Ok(())
    }

    /// The design with all of these changes, as `--set` takes them.
    ///
    /// # Errors
    /// If one cannot be read, or the result is refused.
    pub(super) fn with(&self, changes: &[String]) -> Result<Design, InputError> {
        let mut root = self.tree(&Source::other("set"))?;
        for change in changes {
            Setting::parse(change)?.apply(&mut root)?;
        }
        design_of(&root)
    }

    /// The number at a dotted key, in the unit of the key; none where no number stands or may stand there.
    pub fn get(&self, key: &str) -> Option<f64> {
        if let Some((name, number)) = effect_key(key)
            && let Some(toml::Value::Float(value)) =
                self.effects.get(name).and_then(|table| table.get(number))
        {
            return Some(*value);
        }
        let source = Source::other("get");
        let path = KeyPath::parse(key).ok()?;
        let root = self.tree(&source).ok()?;
        let node = root.at(&path)?;
        node.number().or_else(|| node.get("assumed")?.number())
    }

    /// The plain number at a key of an effect's table, if the key is one.
    fn effect_number(&mut self, key: &str) -> Option<&mut f64> {
        let (name, number) = effect_key(key)?;
        match self.effects.get_mut(name)?.get_mut(number)? {
            toml::Value::Float(value) => Some(value),
            _ => None,
        }
    }

    /// The design as a tree without places.
    fn tree(&self, source: &Rc<Source>) -> Result<Node, InputError> {
        let value = toml::Value::try_from(self).map_err(|error| {
            InputError::about_file("set", format!("the design cannot be written: {error}"), "")
        })?;
        Ok(Node::from_value(source, &value))
    }
}

/// Name of an effect and of its number in the key `effects.NAME.NUMBER`.
pub fn effect_key(key: &str) -> Option<(&str, &str)> {
    key.strip_prefix("effects.")?.split_once('.')
}

fn read_path(source: &Rc<Source>, key: &str) -> Result<KeyPath, InputError> {
    KeyPath::parse(key).map_err(|message| {
        let message = format!("is no dotted key: {message}");
        let cure = "Write e.g. flapping.frequency_hz or rod[0].section.diameter_mm";
        InputError::new(source.place(0), key, "", Problem::Syntax { message }, cure)
    })
}

fn still_assumed(old: &Node, value: f64) -> Option<Node> {
    let NodeValue::List(ends) = &old.get("range")?.value else {
        return None;
    };
    let inside = ends.first()?.number()? <= value && value <= ends.get(1)?.number()?;
    let mut kept = old.clone();
    let assumed = old.get("assumed")?.with_value(NodeValue::Float(value));
    kept.put("assumed", assumed);
    inside.then_some(kept)
}

/// Puts `node` at `path`, making tables on the way where keys are absent.
fn put(root: &mut Node, path: &KeyPath, node: Node) -> Result<(), InputError> {
    let shown = node.shown();
    let place = node.file();
    let empty = node.with_value(NodeValue::Table(Vec::new()));
    let fail = |message: String, cure: String| {
        let problem = Problem::Conflict {
            message,
            with: Vec::new(),
        };
        Err(InputError::new(
            place.clone(),
            &path.to_string(),
            &shown,
            problem,
            cure,
        ))
    };
    let mut target = root;
    let mut done = KeyPath::default();
    let Some((last, way)) = path.0.split_last() else {
        return Ok(());
    };
    for step in way {
        if let Step::Key(key) = step
            && target.get(key).is_none()
        {
            target.put(key, empty.clone());
        }
        let before = done.to_string();
        done.0.push(step.clone());
        let entries = target.length();
        match target.child_mut(step) {
            Some(child) => target = child,
            None => return fail(no_entry(step, &before, entries), counted(step, &before, entries)),
        }
    }
    let before = done.to_string();
    let entries = target.length();
    match last {
        Step::Key(key) if target.is_table() => target.put(key, node),
        step => match target.child_mut(step) {
            Some(child) => *child = node,
            None => return fail(no_entry(step, &before, entries), counted(step, &before, entries)),
        },
    }
    Ok(())
}

fn no_entry(step: &Step, before: &str, entries: Option<usize>) -> String {
    match (step, entries) {
        (Step::Index(index), Some(entries)) => {
            format!("there is no {before}[{index}], {before} has {entries}")
        }
        (Step::Index(_), None) => format!("{before} is no list"),
        (Step::Key(_), Some(_)) => format!("{before} is a list, so its entry must be named"),
        (Step::Key(key), None) => format!("{before} has no keys, so no {key}"),
    }
}

fn counted(step: &Step, before: &str, entries: Option<usize>) -> String {
    match (step, entries) {
        (_, Some(0)) => format!("The design has no {before}; add it to the file"),
        (_, Some(1)) => format!("Write {before}[0]"),
        (_, Some(entries)) => format!("Entries count from 0: {before}[0] … {before}[{}]", entries - 1),
        (Step::Index(_), None) => "Leave the number in brackets out".to_string(),
        (Step::Key(_), None) => format!("Set {before} itself"),
    }
}
