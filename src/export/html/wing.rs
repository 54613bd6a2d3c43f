//! Wings for the viewer of the page: two shapes, the film, rod and spars, and what they are coloured by.

use crate::coupling::solution::Solution;
use crate::export::ExportError;
use crate::export::vtu::Grid;
use crate::export::wing::{Legend, Shape, solution_grid};
use crate::geometry::Planform;
use crate::input::Design;
use crate::input::design::Section;
use crate::observation::field::twist_at_nodes;
use crate::page::text::significant;

use super::measured::Measured;
use super::numbers::{component_of, finite, joined, micrometres};
use super::stroke::Stroke;
use super::tube::diameter_mm;

/// Colours from the lowest to the highest value: cividis (J. R. Nuñez, C. R. Anderton, R. S. Renslow, PLOS ONE 13 (2018)
/// e0199239), which looks alike to people with and without colour vision and rises in lightness.
pub const MAP: [[u8; 3]; 9] = [
    [0, 34, 78],
    [18, 53, 112],
    [59, 73, 108],
    [87, 93, 109],
    [112, 113, 115],
    [138, 134, 120],
    [165, 156, 116],
    [195, 179, 105],
    [254, 232, 56],
];

/// A wing in one state.
#[derive(Debug, Clone, PartialEq)]
pub struct Wing {
    /// What the viewer calls it.
    pub name: String,
    /// Points without load, mm.
    pub rest_mm: Vec<[f64; 3]>,
    /// Points under load, mm.
    pub loaded_mm: Vec<[f64; 3]>,
    /// Film by points.
    pub triangles: Vec<[usize; 3]>,
    /// Rod (part 1), spars (2) and stiff ribs (3) by points.
    pub lines: Vec<([usize; 2], i32)>,
    /// Diameters of the tubes that the lines are drawn as, mm; 0 where the section says none.
    pub diameters_mm: Vec<f64>,
    /// What it can be coloured by.
    pub fields: Vec<Field>,
    /// Measured twist along the span, run by run.
    pub measured: Vec<Measured>,
    /// Its motion over the stroke, where that was solved.
    pub stroke: Option<Stroke>,
}

/// What a wing can be coloured by.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Its name in words.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Whether it has a value for each point, else for each triangle.
    pub is_on_points: bool,
    /// The values.
    pub values: Vec<f64>,
}

impl Wing {
    /// From the grids of its unloaded and its loaded shape; `sections` are those that the cells number.
    pub fn of_grids(name: &str, rest: &Grid, loaded: &Grid, sections: &[Section]) -> Wing {
        let (points, cells) = (loaded.points_mm.len(), loaded.triangles.len());
        let field = |name, unit, is_on_points, values: Option<Vec<f64>>| {
            // A field that is zero everywhere is none: a wing of ribs has no film that could carry tension.
            let values = values.filter(|values| values.iter().any(|value| *value != 0.0))?;
            Some(Field {
                name,
                unit,
                is_on_points,
                values,
            })
        };
        let (on_points, on_cells) = (&loaded.point_arrays, &loaded.cell_arrays);
        let tension = |component| component_of(on_cells, "principal_tension_n_per_m", component, cells);
        let mut fields: Vec<Field> = [
            field(
                "twist",
                "deg",
                true,
                component_of(on_points, "twist_deg", 0, points),
            ),
            field(
                "pressure",
                "Pa",
                false,
                component_of(on_cells, "pressure_pa", 0, cells),
            ),
            field("film tension", "N/m", false, tension(0)),
            field("smaller film tension", "N/m", false, tension(1)),
        ]
        .into_iter()
        .flatten()
        .collect();
        if fields.is_empty() {
            fields.push(Field {
                name: "twist",
                unit: "deg",
                is_on_points: true,
                values: vec![0.0; points],
            });
        }
        let of_cells = |name| component_of(on_cells, name, 0, cells + loaded.lines.len()).unwrap_or_default();
        let (parts, numbers) = (of_cells("part"), of_cells("section"));
        let part = |line: usize| parts.get(cells + line).map_or(2, |&part| part as i32);
        let section = |line: usize| {
            let number = numbers.get(cells + line).filter(|number| **number >= 0.0)?;
            sections.get(*number as usize)
        };
        Wing {
            name: name.to_string(),
            rest_mm: rest.points_mm.clone(),
            loaded_mm: loaded.points_mm.clone(),
            triangles: loaded.triangles.clone(),
            lines: loaded
                .lines
                .iter()
                .enumerate()
                .map(|(k, &line)| (line, part(k)))
                .collect(),
            diameters_mm: (0..loaded.lines.len())
                .map(|line| section(line).and_then(diameter_mm).unwrap_or(0.0))
                .collect(),
            fields,
            measured: Vec::new(),
            stroke: None,
        }
    }

    /// From a solution.
    pub fn of_solution(name: &str, design: &Design, planform: &Planform, solution: &Solution) -> Wing {
        let twist_deg = twist_at_nodes(planform, solution)
            .into_iter()
            .map(f64::to_degrees);
        let twist_deg: Vec<f64> = twist_deg.collect();
        let [rest, loaded] = [Shape::Unloaded, Shape::Deformed]
            .map(|shape| solution_grid(design, solution, twist_deg.clone(), shape));
        let sections: Vec<Section> = Legend::of(design).sections.into_iter().cloned().collect();
        Wing::of_grids(name, &rest, &loaded, &sections)
    }

    /// As the viewer reads it: lengths in whole micrometres.
    ///
    /// # Errors
    /// If a value is not finite.
    pub fn json(&self) -> Result<String, ExportError> {
        let points = |points: &[[f64; 3]]| micrometres(points.as_flattened());
        let lines = self
            .lines
            .iter()
            .flat_map(|&([a, b], part)| [a as f64, b as f64, f64::from(part)]);
        let lines: Vec<f64> = lines.collect();
        let triangles: Vec<f64> = self.triangles.as_flattened().iter().map(|&n| n as f64).collect();
        let mut fields = Vec::new();
        for field in &self.fields {
            finite(field.name, &field.values)?;
            fields.push(format!(
                "{{\"name\":\"{}\",\"unit\":\"{}\",\"on\":\"{}\",\"values\":[{}]}}",
                field.name,
                field.unit,
                if field.is_on_points { "points" } else { "cells" },
                joined(&field.values, |value| significant(value, 4))
            ));
        }
        let measured: Vec<String> = self.measured.iter().map(Measured::json).collect();
        let stroke = self.stroke.as_ref().map(Stroke::json).transpose()?;
        Ok(format!(
            "{{\"name\":{},\"rest\":[{}],\"loaded\":[{}],\"triangles\":[{}],\"lines\":[{}],\"diameters\":[{}],\"fields\":[{}],\
             \"measured\":[{}],\"stroke\":{}}}",
            serde_json::Value::from(self.name.as_str()),
            points(&self.rest_mm),
            points(&self.loaded_mm),
            joined(&triangles, |n| n.to_string()),
            joined(&lines, |n| n.to_string()),
            micrometres(&self.diameters_mm),
            fields.join(","),
            measured.join(","),
            stroke.as_deref().unwrap_or("null")
        ))
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;
    use crate::export::html::wings::section;
    use crate::export::vtu::Array;

    /// Two triangles and a rod, twisted.
    pub fn wing(name: &str) -> Wing {
        let grid = |lift: f64| Grid {
            points_mm: vec![
                [0.0, 0.0, 0.0],
                [50.0, 0.0, lift],
                [0.0, 20.0, 0.0],
                [50.0, 20.0, 3.0 * lift],
            ],
            triangles: vec![[0, 1, 2], [1, 3, 2]],
            lines: vec![[0, 1]],
            point_arrays: vec![Array::scalar("twist_deg", vec![0.0, 10.0, 0.0, 10.0])],
            cell_arrays: vec![
                Array::index("part", vec![0, 0, 1]),
                Array::index("section", vec![-1, -1, 0]),
                Array::scalar("pressure_pa", vec![1.0, 2.0, 0.0]),
                Array::vector("principal_tension_n_per_m", &[[0.0, 0.0]; 3]),
            ],
        };
        let round = Section::Round {
            diameter_mm: 0.3.into(),
        };
        Wing::of_grids(name, &grid(0.0), &grid(2.0), &[round])
    }

    #[test]
    fn the_viewer_gets_shapes_parts_and_the_fields_that_are_not_zero() {
        let html = section(&[wing("a</script>b")]).expect("a section");
        let data = html.split("id=\"wing-data\">").nth(1).expect("data");
        let data = data.split("</script>").next().expect("data");
        let data: serde_json::Value = serde_json::from_str(data).expect("JSON");
        let wing = &data["wings"][0];
        assert_eq!(wing["name"], "a</script>b");
        assert_eq!(wing["loaded"][5], 2000);
        assert_eq!(wing["lines"], serde_json::json!([0, 1, 1]));
        assert_eq!(wing["diameters"], serde_json::json!([300]));
        let names: Vec<_> = wing["fields"]
            .as_array()
            .expect("fields")
            .iter()
            .map(|f| &f["name"])
            .collect();
        assert_eq!(names, ["twist", "pressure"]);
        assert_eq!(wing["fields"][0]["values"].as_array().map(Vec::len), Some(4));
        assert_eq!(wing["fields"][1]["values"].as_array().map(Vec::len), Some(2));
    }

    #[test]
    fn a_value_that_is_no_number_is_refused() {
        let mut wing = wing("w");
        wing.fields[0].values[1] = f64::NAN;
        assert!(section(&[wing]).is_err());
    }
}
