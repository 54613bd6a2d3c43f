//! Pictures in the page: SVG as it is, on a light card of its own.

use crate::export::ExportError;
use crate::export::pictures::write::sheets;
use crate::plot::Figure;

/// The picture; nothing if it has no panels.
///
/// # Errors
/// If a number in it is not finite.
pub fn picture(figure: &Figure) -> Result<String, ExportError> {
    let mut html = String::new();
    for sheet in sheets(figure) {
        html.push_str(&format!(
            "<div class=\"picture\">{}</div>\n",
            sheet.to_svg()?.trim_end()
        ));
    }
    Ok(html)
}
