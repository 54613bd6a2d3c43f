//! Families of cases: `bending-{mass}` stands for every measured case of that form, and its numbers for settings.

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

/// A setting with its numbers put in: `{mass}` or `{mass*0.001}`; the error says which number there is not.
pub(super) fn put_in(setting: &str, numbers: &[(&str, f64)]) -> Result<String, String> {
    let mut text = String::new();
    let mut rest = setting;
    while let Some((before, after)) = rest.split_once('{') {
        text.push_str(before);
        let Some((inside, next)) = after.split_once('}') else {
            return Err("a brace is opened and never closed".to_string());
        };
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
    fn settings_take_numbers_and_multiples_of_them() {
        let numbers = [("mass", 200.0)];
        assert_eq!(
            put_in("load[0].mass_kg={mass*0.001}", &numbers).unwrap(),
            "load[0].mass_kg=0.2"
        );
        assert_eq!(put_in("x={mass}", &numbers).unwrap(), "x=200.0");
        assert!(put_in("x={m}", &numbers).unwrap_err().contains("no number {m}"));
        assert!(put_in("x={mass*y}", &numbers).is_err());
    }
}
