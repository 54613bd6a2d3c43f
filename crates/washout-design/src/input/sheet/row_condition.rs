//! The condition of a row: what its column, its row and its name say, each number once and one that the design can have.

use super::bench::{Bench, FORMS};
use super::cells::Checked;
use super::condition::{Condition, Point, key};
use super::grid::Line;
use super::header::{Column, Role};
use super::rows::Reader;
use super::words::numbers;
use crate::input::error::{InputError, Place};

impl Reader<'_> {
    /// The name of the condition of a reading of which the head names these points, or this load on the still wing.
    pub(super) fn condition(
        &mut self,
        line: &Line,
        of: &Column,
        mut points: Vec<Point>,
        mut bench: Option<Bench>,
    ) -> Checked<String> {
        let in_head = points.len();
        for column in self.cells.columns {
            if let Role::Key(key) = &column.role
                && let Some(value) = self.cells.number(line, column)?
            {
                points.push(Point {
                    key: key.clone(),
                    value,
                });
            }
        }
        let named = self.cells.word(line, "case");
        if let Some((cell, column)) = named {
            let of_name = Bench::of(cell);
            let of_name =
                of_name.map_err(|(message, cure)| self.cells.refuse(line, column, &message, cure))?;
            match of_name {
                Some((load, _)) if bench.is_none_or(|known| known == load) => bench = Some(load),
                Some(_) => {
                    let cure = "State it once, in the head or in the row";
                    return Err(self
                        .cells
                        .refuse(line, column, "names another load than the head", cure));
                }
                None => self.points_of_name(line, (cell, column), &mut points)?,
            }
        }
        if let (Some(_), Some(point)) = (&bench, points.first()) {
            let message = format!("is of the still wing, but sets {} to {}", point.key, point.value);
            let cure = "A wing on the bench neither flaps nor stands in a flow: leave that cell empty, or write no load";
            return Err(self.cells.refuse(line, of, &message, cure));
        }
        let heads = points[..in_head].to_vec();
        let once = self.once(line, points)?;
        let name = named.map_or(self.design.name.as_str(), |(cell, _)| cell);
        let condition = Condition {
            points: once,
            bench,
            name: name.replace(['{', '}'], ""),
        };
        let case = condition.case();
        if !self.conditions.iter().any(|known| known.case() == case) {
            if let Some(bench) = &bench {
                let set = self.design.with(&bench.sets(self.design));
                set.map_err(|error| {
                    self.cannot_be(self.cells.grid.head.number, self.cells.head(of), &error, None)
                })?;
            }
            if condition.points.is_empty() && bench.is_none() {
                self.cells.assume("condition", "the design as it stands");
            }
            for point in &condition.points {
                let number = if heads.contains(point) {
                    self.cells.grid.head.number
                } else {
                    line.number
                };
                self.can_be(number, self.cells.head(of), point)?;
            }
            self.conditions.push(condition);
        }
        Ok(case)
    }

    /// Refuses a number that the design cannot have.
    fn can_be(&self, line: usize, column: &str, point: &Point) -> Checked<()> {
        let is_motion = ["flapping.frequency_hz", "steady.speed_m_s"].contains(&point.key.as_str());
        let is_still = is_motion && point.value == 0.0;
        let cure = is_still.then(|| format!("Of the still wing write what loads it, e.g. {FORMS}"));
        let set = self.design.clone().set(&point.key, point.value);
        set.map_err(|error| self.cannot_be(line, column, &error, cure))
    }

    /// What the design refuses, at its place in the table, with its own cure or another.
    fn cannot_be(&self, line: usize, column: &str, error: &InputError, cure: Option<String>) -> InputError {
        let place = Place {
            file: self.cells.grid.input.file.clone(),
            line: Some(line),
            column: None,
        };
        let key = format!("column \"{column}\": {}", error.key);
        let cure = cure.unwrap_or_else(|| error.cure.clone());
        InputError::new(place, &key, &error.value, error.problem.clone(), cure)
    }

    /// Adds the points that the name of a condition holds.
    fn points_of_name(
        &self,
        line: &Line,
        (cell, column): (&str, &Column),
        points: &mut Vec<Point>,
    ) -> Checked<()> {
        let refuse = |message: &str, cure: String| Err(self.cells.refuse(line, column, message, cure));
        let found = numbers(cell).0;
        if found.is_empty()
            && points.is_empty()
            && cell != self.design.name
            && cell.contains(|c: char| c.is_ascii_digit())
        {
            let digits: String = cell
                .chars()
                .skip_while(|c| !c.is_ascii_digit())
                .take_while(|c| c.is_ascii_digit() || *c == '.')
                .collect();
            let cure = format!(
                "Did you mean {digits} Hz? Write the number with its unit, or name a column frequency (Hz)"
            );
            return refuse("names a condition without a unit", cure);
        }
        for (value, kind) in found {
            match key(kind, self.design) {
                Ok(key) => points.push(Point {
                    key: key.to_string(),
                    value,
                }),
                Err(cure) => {
                    return refuse(
                        &format!("names {}, which the design has not", kind.words(value)),
                        cure,
                    );
                }
            }
        }
        Ok(())
    }

    /// The points, each key once.
    fn once(&self, line: &Line, points: Vec<Point>) -> Checked<Vec<Point>> {
        let mut once: Vec<Point> = Vec::new();
        for point in points {
            match once.iter().find(|known| known.key == point.key) {
                None => once.push(point),
                Some(known) if known.value == point.value => {}
                Some(known) => {
                    let message = format!("sets {} to {} and to {}", point.key, known.value, point.value);
                    let cure = "State it once, in the head or in the row".to_string();
                    let grid = self.cells.grid;
                    return Err(grid.fault(line.number, "condition", "", &message, cure));
                }
            }
        }
        Ok(once)
    }

    /// Conditions that differ by name alone would all be the same wing at the same point.
    pub(super) fn names_differ(&self) -> Checked<()> {
        let mut plain = self
            .conditions
            .iter()
            .filter(|condition| condition.points.is_empty() && condition.bench.is_none());
        let (Some(first), Some(second)) = (plain.next(), plain.next()) else {
            return Ok(());
        };
        let row = self.rows.iter().find(|row| row.case == second.name);
        let message = format!("differs from {} in its name alone", first.name);
        let cure = "Say in what they differ: 22 Hz, or a column frequency (Hz)".to_string();
        let line = row.map_or(self.cells.grid.head.number, |row| row.line);
        Err(self
            .cells
            .grid
            .fault(line, "condition", &second.name, &message, cure))
    }
}
