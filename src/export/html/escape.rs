//! Text and JSON made safe for a page: whatever a user wrote stays text.

/// Text for an element or an attribute.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c if c.is_control() && c != '\n' => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// JSON for a `<script>` of data: nothing in it can end the script.
pub fn in_script(json: &str) -> String {
    json.replace('<', "\\u003c").replace('>', "\\u003e")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_user_wrote_can_neither_open_a_tag_nor_end_a_script() {
        let name = "</script><img src=x onerror='alert(\"&\")'>";
        let text = escaped(name);
        assert!(!text.contains(['<', '>', '"', '\'']), "{text}");
        let json = in_script(&serde_json::to_string(name).expect("JSON"));
        assert!(!json.contains('<') && !json.contains('>'), "{json}");
        assert_eq!(serde_json::from_str::<String>(&json).expect("JSON"), name);
    }
}
