//! JSON made safe for a page: whatever a user wrote stays text.

/// JSON for a `<script>` of data: nothing in it can end the script.
pub fn in_script(json: &str) -> String {
    json.replace('<', "\\u003c").replace('>', "\\u003e")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::pen::escaped;

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
