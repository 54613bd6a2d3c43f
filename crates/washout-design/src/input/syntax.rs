//! What is wrong with a line that is no TOML, in the words of someone who writes a design.

/// The problem and its cure, from the line, the column of the fault (from 1) and what the parser said.
pub(crate) fn explain(line: &str, column: usize, said: &str) -> (String, String) {
    let line = line.trim_end();
    let from_fault: String = line.chars().skip(column.saturating_sub(1)).collect();
    if said.contains("duplicate key") {
        let name = from_fault
            .split(['=', ']', ' ', '.'])
            .next()
            .unwrap_or_default()
            .trim();
        let cure =
            "Keep one of them; segments, spars and loads are lists, written [[rod]], [[spar]], [[load]]";
        return (format!("{name} is given twice"), cure.to_string());
    }
    if let Some((key, value)) = line.split_once('=') {
        let (key, value) = (key.trim(), value.split('#').next().unwrap_or_default().trim());
        if let Some(found) = bad_value(key, value) {
            return found;
        }
    }
    let cure = "Write keys as `key = value`, words in quotes, numbers without quotes or unit, tables as `[name]`, \
                lists of tables as `[[name]]`";
    (format!("is not TOML: {said}"), cure.to_string())
}

fn bad_value(key: &str, value: &str) -> Option<(String, String)> {
    if value.is_empty() {
        return Some((
            "the value is missing".to_string(),
            format!("Write a value behind {key} =, or delete the line"),
        ));
    }
    let digits = value
        .find(|c: char| !(c.is_ascii_digit() || "+-._".contains(c)))
        .unwrap_or(value.len());
    let (number, rest) = value.split_at(digits);
    if number.parse::<f64>().is_ok() && !rest.is_empty() {
        let decimals = rest.strip_prefix(',').map(str::trim);
        if decimals
            .is_some_and(|decimals| !decimals.is_empty() && decimals.chars().all(|c| c.is_ascii_digit()))
        {
            let cure = format!("Write {key} = {}", value.replacen(',', ".", 1).replace(' ', ""));
            return Some(("a number has a decimal point, not a comma".to_string(), cure));
        }
        let unit = rest.trim_start();
        if unit.starts_with(|c: char| c.is_alphabetic() || c == '%' || c == '°')
            && !unit.starts_with(['e', 'E'])
        {
            let cure = format!("Write {key} = {number}, in the unit that the key names");
            return Some(("a number stands without its unit".to_string(), cure));
        }
    }
    let bare = value.chars().all(|c| c.is_alphanumeric() || "_-./".contains(c));
    if bare && value.starts_with(|c: char| c.is_alphabetic() || c == '.' || c == '/') {
        return Some((
            "words stand in quotes".to_string(),
            format!("Write {key} = \"{value}\""),
        ));
    }
    if value.starts_with('"') && value.matches('"').count() == 1 && !value.starts_with("\"\"\"") {
        return Some((
            "the text has no closing quote".to_string(),
            format!("Write {key} = {value}\""),
        ));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::explain;

    #[test]
    fn frequent_slips_are_named() {
        let problem = |line: &str| explain(line, 1, "?").0;
        assert_eq!(problem("length_mm = 70 mm"), "a number stands without its unit");
        assert_eq!(
            problem("length_mm = 70,5"),
            "a number has a decimal point, not a comma"
        );
        assert_eq!(problem("length_mm = # later"), "the value is missing");
        assert_eq!(problem("material = kapton"), "words stand in quotes");
        assert_eq!(problem("name = \"x"), "the text has no closing quote");
        assert_eq!(problem("a = [1, 2"), "is not TOML: ?");
    }
}
