//! A design to start from with the outline of a drawing.

use std::path::Path;

use toml_edit::{Array, DocumentMut, Item, Table, Value, value};

use crate::geometry::DrawnWing;
use crate::input::InputError;
use crate::input::drawing::{Drawing, counted};
use crate::page::text::{significant, wrapped};

/// A wing that was drawn, and its drawing.
#[derive(Debug)]
pub struct Drawn {
    drawing: Drawing,
    wing: DrawnWing,
}

impl Drawn {
    /// Reads a drawing; `is_mirrored`: the base of the wing is at its right.
    ///
    /// # Errors
    /// If it cannot be read, or what is drawn is no wing.
    pub fn load(path: &Path, is_mirrored: bool) -> Result<Drawn, InputError> {
        let drawing = Drawing::load(path)?;
        let wing = DrawnWing::of_outline(&drawing.outline_mm, is_mirrored);
        let wing = wing.map_err(|error| {
            let words = error.to_string();
            let (problem, cure) = words.rsplit_once("; ").unwrap_or((&words, ""));
            InputError::about_file(&path.display().to_string(), problem, cure)
        })?;
        Ok(Drawn { drawing, wing })
    }

    /// A design with this outline: rod and spars of `template` are moved along the span with the length.
    pub fn design(&self, template: &str) -> String {
        let Ok(mut design) = template.parse::<DocumentMut>() else {
            return template.to_string();
        };
        let length_mm = rounded(self.wing.length_mm);
        let before = length_of(&design);
        let scale = |number: f64| match number >= before {
            true => length_mm,
            false => (number * length_mm / before * 10.0).round() / 10.0,
        };
        for (tables, keys) in [("rod", ["from_mm", "to_mm"].as_slice()), ("spar", &["at_mm"])] {
            let found = design.get_mut(tables).and_then(Item::as_array_of_tables_mut);
            for table in found.into_iter().flat_map(|tables| tables.iter_mut()) {
                for key in keys {
                    let number = table.get(key).and_then(Item::as_float);
                    number
                        .into_iter()
                        .for_each(|number| put(table, key, scale(number)));
                }
            }
        }
        if let Some(planform) = design.get_mut("planform").and_then(Item::as_table_mut) {
            planform.remove("mean_chord_mm");
            planform.remove("r2_hat");
            put(planform, "length_mm", length_mm);
            let mut outline = Array::new();
            for point in &self.wing.points_mm {
                outline.push(point.iter().map(|v| rounded(*v)).collect::<Array>());
            }
            let points = outline.iter_mut();
            points.for_each(|point| point.decor_mut().set_prefix("\n    "));
            outline.set_trailing("\n");
            planform["outline"] = value(outline);
            planform.decor_mut().set_prefix(format!(
                "\n# Outline: points [r_mm, chord_mm], r from the base to the tip, of {}.\n",
                self.drawing.file.file
            ));
        }
        design.to_string()
    }

    /// What was understood of the drawing.
    pub fn understood(&self) -> String {
        let chord = |of: fn(f64, f64) -> f64, from: f64| {
            let chords = self.wing.points_mm.iter().map(|[_, chord]| *chord);
            significant(chords.fold(from, of), 3)
        };
        let at_ends = [self.wing.points_mm.first(), self.wing.points_mm.last()];
        let [base, tip] = at_ends.map(|point| point.map_or(0.0, |[_, chord]| *chord));
        let left_out = counted(" Not used of the drawing: ", &self.drawing.left_out);
        let words = format!(
            "{}: a wing of {} mm, its chord {} mm at the base, {} mm at most, {} mm at the tip. Units of the drawing: {}.{left_out}{} The \
             leading edge is taken as straight: the drawn one leaves its mean level by up to {} mm. The {} points of the outline leave the \
             drawn chord by up to {} mm. Rod and spars are those of the design to start from, moved along with the length: put in your own.",
            self.drawing.file.file,
            significant(self.wing.length_mm, 4),
            significant(base, 3),
            chord(f64::max, 0.0),
            significant(tip, 3),
            self.drawing.unit,
            if left_out.is_empty() { "" } else { "." },
            significant(self.wing.off_level_mm, 2),
            self.wing.points_mm.len(),
            significant(self.wing.off_chord_mm, 2),
        );
        wrapped(&words, 0) + "\n"
    }
}

/// A number in its place, with the comment that stood there.
fn put(table: &mut Table, key: &str, number: f64) {
    let decor = table
        .get(key)
        .and_then(Item::as_value)
        .map(|old| old.decor().clone());
    let mut new = Value::from(number);
    decor.into_iter().for_each(|decor| *new.decor_mut() = decor);
    table.insert(key, Item::Value(new));
}

fn length_of(design: &DocumentMut) -> f64 {
    let length = design
        .get("planform")
        .and_then(|planform| planform.get("length_mm"));
    length.and_then(Item::as_float).unwrap_or(1.0)
}

/// To a thousandth of a millimetre.
fn rounded(value: f64) -> f64 {
    (value * 1e3).round() / 1e3
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::template::Template;
    use crate::geometry::Planform;
    use crate::input::Design;

    /// A template that washout itself wrote, read back as a drawing.
    fn read_back(ending: &str, of: impl Fn(&Template) -> String) -> (Planform, Drawn) {
        let design = Design::load(Path::new("designs/twist-v2.toml"), &[])
            .expect("a design")
            .design;
        let planform = Planform::from_design(&design).expect("an outline");
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join(format!("wing.{ending}"));
        std::fs::write(&path, of(&Template::new(&design, &planform))).expect("written");
        (planform, Drawn::load(&path, false).expect("a drawing"))
    }

    #[test]
    fn the_cutting_template_of_a_wing_gives_its_outline_back() {
        for (ending, of) in [
            ("dxf", Template::to_dxf as fn(&Template) -> String),
            ("svg", Template::to_svg),
        ] {
            let (planform, drawn) = read_back(ending, of);
            let design = Design::from_toml(&drawn.design(crate::input::design::INIT), "wing.toml");
            let design = design.unwrap_or_else(|error| panic!("{ending}: {error}"));
            let again = Planform::from_design(&design).expect("an outline");
            assert!((again.length_m() - planform.tip_m()).abs() < 1e-5, "{ending}");
            for k in 1..20 {
                let r_m = planform.tip_m() * f64::from(k) / 20.0;
                let (one, other) = (planform.chord_m(r_m), again.chord_m(r_m));
                assert!((one - other).abs() < 1e-4, "{ending}: {r_m}: {one} {other}");
            }
        }
    }

    #[test]
    fn rod_and_spars_move_along_with_the_length_and_comments_stay() {
        let (_, drawn) = read_back("dxf", Template::to_dxf);
        let text = drawn.design(crate::input::design::INIT);
        let design = Design::from_toml(&text, "wing.toml").expect("a design");
        let length_mm = design.planform.length_mm.value();
        assert!((length_mm - 69.3).abs() < 1e-3);
        assert_eq!(design.rod[1].to_mm.value(), length_mm);
        assert_eq!(design.rod[0].to_mm.value(), 39.6);
        assert_eq!(design.spar[2].at_mm.value(), 61.4);
        assert!(text.contains("# from wing base to tip") && text.contains("# Spars from the leading"));
        assert!(
            drawn.understood().contains("millimetres"),
            "{}",
            drawn.understood()
        );
    }
}
