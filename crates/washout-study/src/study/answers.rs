//! How a case answers: derivatives of its readings with numbers of its design, and its response to a moment along the span.

use std::cell::OnceCell;

use nalgebra::Vector3;

use super::case::{Asked, PreparedCase, Solved};
use super::columns::{Column, Columns};
use super::error::StudyError;
use super::work::Work;
use crate::coupling::sensitivity::{Nearby, Rate};
use crate::coupling::strips::Strips;
use crate::coupling::{Care, Near, Sensitivity};
use crate::input::{Design, effect_key};
use crate::progress::Progress;
use crate::structure::Tangent;

impl PreparedCase {
    /// Derivatives of the readings with keys of the design: (index, values per row) for each of `columns`; and what it took.
    /// `tangent`: what the solve has left.
    ///
    /// # Errors
    /// If the coupled tangent is singular, or a key is none.
    pub fn rates(
        &self,
        solved: &Solved,
        tangent: Option<Tangent>,
        columns: &[Asked],
        progress: &Progress,
    ) -> Result<(Columns, Work), StudyError> {
        let mut work = Work::default();
        if columns.is_empty() {
            return Ok((Vec::new(), work));
        }
        work.factorizations += 1;
        let Solved { at: solved, wing } = solved;
        let here = self.read(solved)?;
        let remesh = |design: &Design| self.mesh(design);
        let table = self.air_table.as_deref();
        let Nearby { design, solution, .. } = solved;
        let elsewhere = self.elsewhere(design, columns)?;
        let mut sensitivity = match tangent {
            Some(tangent) => Sensitivity::with_tangent(design, wing, table, solution, &remesh, tangent),
            None => Sensitivity::new(design, wing, table, solution, &remesh),
        }
        .map_err(|error| self.failed(error))?;
        let mut rates = Vec::new();
        // answers to an effect are kept, and serve where others are tried: they are the same beside any other
        let (mut effect, mut known) = (None, 0);
        for (
            Asked {
                index, key, switch, ..
            },
            elsewhere,
        ) in columns.iter().zip(&elsewhere)
        {
            progress.check()?;
            let own = effect_key(key).map(|(name, _)| name);
            if own != effect {
                effect = own;
                sensitivity.known().truncate(known);
            }
            sensitivity.of_design(elsewhere.as_ref().unwrap_or(design));
            let column = match switch {
                Some(step) => {
                    let rate = sensitivity.rate(key).ok();
                    let (column, took) = self.switched(solved, (key, *step), rate, &here, progress)?;
                    work += took;
                    column
                }
                None => {
                    work.derivatives += 1;
                    self.column(&mut sensitivity, key, &here)?
                }
            };
            if own.is_none() {
                known = sensitivity.known().len();
            }
            rates.push((*index, column));
        }
        Ok((rates, work))
    }

    /// Change of the readings, which are `here`, per step of a key by the whole step, and what it took. `rate`: its derivative to the side of
    /// the step, if it has one, which leads part of the way.
    fn switched(
        &self,
        solved: &Nearby,
        (key, step): (&str, f64),
        rate: Option<Rate>,
        here: &[f64],
        progress: &Progress,
    ) -> Result<(Column, Work), StudyError> {
        let mut design = solved.design.clone();
        design.set(key, step).map_err(|error| self.failed(error))?;
        let way = |rate: Rate| rate.state.iter().map(|change| change * step).collect();
        let from = Near {
            solution: &solved.solution,
            step: rate.filter(|rate| !rate.moves_mesh).map(way),
            care: Care::Full,
        };
        let (there, _) = self.solve(&design, Some(&from), progress)?;
        let work = there.work();
        let there = self.read(&there.at)?;
        let rates = there.iter().zip(here);
        let column = Column {
            rates: rates.map(|(there, here)| (there - here) / step).collect(),
            shape: None,
        };
        Ok((column, work))
    }

    /// The design with an effect, still off, at the place that a column asks for; none for columns without a place.
    fn elsewhere(&self, design: &Design, columns: &[Asked]) -> Result<Vec<Option<Design>>, StudyError> {
        let of = |asked: &Asked| -> Result<Option<Design>, StudyError> {
            let Some(sets) = &asked.placed else {
                return Ok(None);
            };
            let mut design = design.clone();
            for (key, number) in sets {
                design.set(key, *number).map_err(|error| self.failed(error))?;
            }
            Ok(Some(design))
        };
        columns.iter().map(of).collect()
    }

    /// Derivative of the readings, which are `here`, with a key.
    fn column(&self, sensitivity: &mut Sensitivity, key: &str, here: &[f64]) -> Result<Column, StudyError> {
        let fault = |error| self.failed(format!("{key}: {error}"));
        let rate = sensitivity.rate(key).map_err(fault)?;
        let unread = OnceCell::new();
        let column = sensitivity.read(&rate, |near| {
            self.read(near).unwrap_or_else(|error| {
                let _ = unread.set(error);
                here.to_vec()
            })
        });
        if let Some(error) = unread.into_inner() {
            return Err(error);
        }
        Ok(Column {
            rates: column.map_err(|error| self.failed(error))?,
            shape: (!rate.moves_mesh).then_some(rate.state),
        })
    }

    /// Response of the readings to a unit moment per length about the span axis (N·m/m), spread as a hat around each of
    /// `stations` places from base to tip.
    ///
    /// # Errors
    /// If the coupled tangent is singular.
    pub fn moment_response(&self, solved: &Solved, stations: usize) -> Result<Vec<Vec<f64>>, StudyError> {
        let Solved { at: solved, wing } = solved;
        let remesh = |design: &Design| self.mesh(design);
        let table = self.air_table.as_deref();
        let mut sensitivity = Sensitivity::new(&solved.design, wing, table, &solved.solution, &remesh)
            .map_err(|error| self.failed(error))?;
        let strips = Strips::new(&solved.solution.mesh);
        let here = self.read(solved)?;
        let mut columns = Vec::new();
        for station in 0..stations {
            let spacing = strips.tip_m() / (stations.max(2) - 1) as f64;
            let hat = |r_m: f64| (1.0 - (r_m / spacing - station as f64).abs()).max(0.0);
            let mut force = vec![Vector3::zeros(); solved.solution.mesh.nodes.len()];
            for strip in &strips.strips {
                let shape = strip.shape(&solved.solution.state.displacement);
                let chord = Vector3::new(shape[0], shape[1], shape[2]);
                let normal = Vector3::new(shape[3], shape[4], shape[5])
                    .cross(&chord)
                    .normalize();
                let pair = normal * (hat(strip.r_m) * strip.width_m / chord.norm());
                let last = strip.points.len() - 1;
                strip.spread(|node, share, point| match point {
                    0 => force[node] -= pair * share,
                    _ if point == last => force[node] += pair * share,
                    _ => {}
                });
            }
            let rate = sensitivity
                .load_rate(&force)
                .map_err(|error| self.failed(error))?;
            // a small step keeps the reading linear
            let step = 1e-9;
            let near = sensitivity
                .nearby(&rate, step)
                .map_err(|error| self.failed(error))?;
            let there = self.read(&near)?;
            columns.push(
                there
                    .iter()
                    .zip(&here)
                    .map(|(there, here)| (there - here) / step)
                    .collect(),
            );
        }
        Ok(columns)
    }
}
