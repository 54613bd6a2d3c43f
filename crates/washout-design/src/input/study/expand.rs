//! Families of cases: `bending-{mass}` stands for every measured case of that form, and its numbers for settings.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::unit::{unit_symbol, without_unit};

/// A number that differs between the cases of a family.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CaseNumber {
    /// What it is: the last part of the key that it sets, in words; its name in the form, if it sets none.
    pub name: String,
    /// Unit of the key that it sets; empty if it has none.
    pub unit: String,
    /// Its value in that unit.
    pub value: f64,
}

/// The numbers of a case as what they set; each by the first of the settings that takes it.
pub(super) fn case_numbers(settings: &[String], numbers: &[(&str, f64)]) -> Vec<CaseNumber> {
    let found = |(name, value): &(&str, f64)| {
        let set = settings.iter().find_map(|setting| {
            let (key, text) = setting.split_once('=')?;
            let inside = text.split('{').skip(1).filter_map(|part| part.split('}').next());
            let factor = |inside: &str| match inside.split_once('*') {
                None => (inside == *name).then_some(1.0),
                Some((of, factor)) => (of.trim() == *name).then(|| factor.trim().parse().ok())?,
            };
            let factor: f64 = inside.filter_map(factor).next()?;
            let last = key.trim().rsplit('.').next()?;
            Some((last, factor))
        });
        let Some((key, factor)) = set else {
            return CaseNumber {
                name: name.replace('_', " "),
                unit: String::new(),
                value: *value,
            };
        };
        CaseNumber {
            name: without_unit(key).replace('_', " "),
            unit: unit_symbol(key).unwrap_or_default().to_string(),
            value: value * factor,
        }
    };
    numbers.iter().map(found).collect()
}

/// A form such as `aero-{angle}-{speed}`: literals with named numbers between.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Form<'a> {
    parts: Vec<Part<'a>>,
}

#[derive(Debug, Clone, PartialEq)]
enum Part<'a> {
    Literal(&'a str),
    Number(&'a str),
}

impl<'a> Form<'a> {
    /// Reads a form; the error says what is wrong with it.
    pub fn parse(text: &'a str) -> Result<Form<'a>, String> {
        let mut parts = Vec::new();
        let mut rest = text;
        while let Some((literal, after)) = rest.split_once('{') {
            let Some((name, next)) = after.split_once('}') else {
                return Err("a brace is opened and never closed".to_string());
            };
            if name.is_empty() || !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
                return Err(format!(
                    "\"{name}\" is no name for a number (letters, digits and _)"
                ));
            }
            if !literal.is_empty() {
                parts.push(Part::Literal(literal));
            }
            parts.push(Part::Number(name));
            rest = next;
        }
        if !rest.is_empty() {
            parts.push(Part::Literal(rest));
        }
        Ok(Form { parts })
    }

    /// The numbers in a name that has this form; none if it has not.
    pub fn read(&self, name: &'a str) -> Option<Vec<(&'a str, f64)>> {
        let mut numbers = Vec::new();
        let mut rest = name;
        for part in &self.parts {
            match part {
                Part::Literal(literal) => rest = rest.strip_prefix(literal)?,
                Part::Number(key) => {
                    let digits = rest.bytes().enumerate();
                    let belongs = |(at, b): &(usize, u8)| {
                        b.is_ascii_digit() || *b == b'.' || (*at == 0 && (*b == b'-' || *b == b'+'))
                    };
                    let end = digits.take_while(belongs).count();
                    numbers.push((*key, rest[..end].parse().ok()?));
                    rest = &rest[end..];
                }
            }
        }
        rest.is_empty().then_some(numbers)
    }
}

/// A setting with its numbers put in: `{mass}` or `{mass*0.001}`; braces that hold `=` are an inline table and stay. The error says
/// which number there is not.
pub(super) fn put_in(setting: &str, numbers: &[(&str, f64)]) -> Result<String, String> {
    let mut text = String::new();
    let mut rest = setting;
    while let Some((before, after)) = rest.split_once('{') {
        text.push_str(before);
        let Some((inside, next)) = after.split_once('}') else {
            return Err("a brace is opened and never closed".to_string());
        };
        if inside.contains('=') {
            text.push('{');
            rest = after;
            continue;
        }
        let (name, factor) = match inside.split_once('*') {
            None => (inside, 1.0),
            Some((name, factor)) => {
                let factor = factor.trim().parse();
                (
                    name.trim(),
                    factor.map_err(|_| format!("{{{inside}}} must be {{NAME*NUMBER}}"))?,
                )
            }
        };
        let found = numbers.iter().find(|(key, _)| *key == name);
        let (_, value): &(&str, f64) =
            found.ok_or_else(|| format!("there is no number {{{name}}} in measured"))?;
        text.push_str(&format!("{:?}", value * factor));
        rest = next;
    }
    text.push_str(rest);
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_form_reads_its_numbers_and_refuses_other_names() {
        let form = Form::parse("aero-{angle}-{speed}").unwrap();
        assert_eq!(
            form.read("aero-2.2-30"),
            Some(vec![("angle", 2.2), ("speed", 30.0)])
        );
        for other in ["aero-2.2", "aero-2.2-30x", "gravity-1-2", "aero--", "aero-x-1"] {
            assert_eq!(form.read(other), None, "{other}");
        }
        assert_eq!(
            Form::parse("twist-v2").unwrap().read("twist-v2"),
            Some(Vec::new())
        );
        assert!(Form::parse("a-{b").is_err() && Form::parse("a-{}").is_err());
    }

    #[test]
    fn the_numbers_of_a_case_are_named_after_what_they_set() {
        let settings = [
            "load[0].mass_kg={mass*0.001}".to_string(),
            "steady.root_angle_deg={angle}".to_string(),
            "gravity.root_pitch_deg={angle}".to_string(),
        ];
        let found = case_numbers(&settings, &[("angle", 2.5), ("mass", 200.0), ("lot_number", 7.0)]);
        let shown: Vec<(&str, &str, f64)> = found
            .iter()
            .map(|n| (n.name.as_str(), n.unit.as_str(), n.value))
            .collect();
        assert_eq!(
            shown,
            [
                ("root angle", "deg", 2.5),
                ("mass", "kg", 0.2),
                ("lot number", "", 7.0)
            ]
        );
        let in_list = ["load[0].moment_n_m=[{m*0.001}, 0, 0]".to_string()];
        let found = case_numbers(&in_list, &[("m", 3.0)]);
        assert_eq!(
            (found[0].name.as_str(), found[0].unit.as_str()),
            ("moment", "N·m")
        );
        assert!((found[0].value - 0.003).abs() < 1e-15);
    }

    #[test]
    fn settings_take_numbers_and_multiples_of_them() {
        let numbers = [("mass", 200.0)];
        assert_eq!(
            put_in("load[0].mass_kg={mass*0.001}", &numbers).unwrap(),
            "load[0].mass_kg=0.2"
        );
        assert_eq!(put_in("x={mass}", &numbers).unwrap(), "x=200.0");
        assert!(put_in("x={m}", &numbers).unwrap_err().contains("no number {m}"));
        assert!(put_in("x={mass*y}", &numbers).is_err());
        assert_eq!(
            put_in("load=[{at_mm={mass}, force_n=[0,0,1]}]", &numbers).unwrap(),
            "load=[{at_mm=200.0, force_n=[0,0,1]}]",
            "an inline table is no number"
        );
    }
}
