//! ParaView collection (`.pvd`): a series of `.vtu` files along an axis such as load or stroke phase.

use std::fmt::Write;

/// The text of a `.pvd` file; `series` holds the value on the axis and the name of each file beside it.
pub fn collection(series: &[(f64, String)]) -> String {
    let mut text = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  \
         <Collection>\n",
    );
    for (value, file) in series {
        let file = escape(file);
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "    <DataSet timestep=\"{value}\" group=\"\" part=\"0\" file=\"{file}\"/>"
        );
    }
    text.push_str("  </Collection>\n</VTKFile>\n");
    text
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_file_stands_once_with_its_value() {
        let text = collection(&[(0.0, "wing-rest.vtu".into()), (1.5, "a&\"b\".vtu".into())]);
        assert_eq!(text.matches("<DataSet ").count(), 2);
        assert!(
            text.contains("timestep=\"0\" group=\"\" part=\"0\" file=\"wing-rest.vtu\"/>"),
            "{text}"
        );
        assert!(
            text.contains("timestep=\"1.5\" group=\"\" part=\"0\" file=\"a&amp;&quot;b&quot;.vtu\"/>"),
            "{text}"
        );
    }
}
