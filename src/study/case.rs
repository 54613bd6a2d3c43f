//! One case of a study: its design solved, and read as it was measured.

use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::fmt::Display;
use std::sync::Arc;

use nalgebra::Vector3;

use super::admitted::admit;
use super::error::StudyError;
use super::footing::Column;
use super::forward::{Condition, Observable};
use super::work::Work;
use crate::aero::Flow;
use crate::coupling::sensitivity::{Nearby, Rate};
use crate::coupling::solution::Solution;
use crate::coupling::strips::Strips;
use crate::coupling::wing::Wing;
use crate::coupling::{self, BladeAir, CouplingError, Sensitivity};
use crate::effects::{acting, is_applicable, named};
use crate::geometry::Planform;
use crate::input::Design;
use crate::input::measurement::{Channel, Row};
use crate::input::study::{CaseNumber, LoadedCase, LoadedStudy};
use crate::lift::LiftReport;
use crate::mesh::{Mesh, MeshError, MeshFile, for_design};
use crate::observation::{Observer, read_channel};
use crate::progress::Progress;
use crate::structure::Tangent;

/// A case with its effects in place.
#[derive(Debug, Clone)]
pub struct PreparedCase {
    /// Name of the case.
    pub name: String,
    /// The form of its family, such as `bending-{mass}`.
    pub family: String,
    /// The numbers in which it differs from others of its family.
    pub numbers: Vec<CaseNumber>,
    /// Design, with a table for every effect that may act.
    pub design: Design,
    /// Measured rows.
    pub rows: Vec<Row>,
    is_held_out: bool,
    /// The case as it stands, from which it is solved with other values: fixed by the study, so that results are too.
    base: Option<Arc<Solved>>,
    air_table: Option<Vec<[f64; 3]>>,
    mesh_file: Option<(String, Vec<u8>)>,
}

/// How a case answers, for the index of a column.
pub type Columns = Vec<(usize, Column)>;

/// A derivative that is asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Asked {
    /// Index of the column.
    pub index: usize,
    /// Dotted key of the design.
    pub key: String,
    /// Finite step, if the response has a kink at zero.
    pub switch: Option<f64>,
    /// Numbers of an effect that is off, with which it would act: dotted key, value.
    pub placed: Option<Vec<(String, f64)>>,
}

/// Where a solve starts.
#[derive(Debug)]
pub struct Near<'a> {
    /// A solution of the case with other values.
    pub solution: &'a Solution,
    /// Step by freedom from there to where the shape is expected.
    pub step: Option<Vec<f64>>,
}

/// A solved case: design, outline and solution, and the wing that was solved.
#[derive(Debug, Clone)]
pub struct Solved {
    /// Design, outline and solution.
    pub at: Nearby,
    wing: Wing,
}

impl Solved {
    /// What it took.
    pub fn work(&self) -> Work {
        Work {
            solves: 1,
            newton_steps: self.at.solution.report.newton_steps,
            ..Work::default()
        }
    }
}

impl PreparedCase {
    /// The case of a study with the study's effects on, and `candidates` that can act at strength 0.
    ///
    /// # Errors
    /// If an effect is not known or cannot act, or the mesh file cannot be read.
    pub fn new(case: &LoadedCase, study: &LoadedStudy, candidates: &[&str]) -> Result<Self, StudyError> {
        let mut design = case.loaded.design.clone();
        let failed = |reason: String| StudyError::Case {
            case: case.name.clone(),
            reason,
        };
        for effect in &study.study.effect {
            let concerns = effect.designs.as_ref();
            if concerns.is_some_and(|designs| !designs.contains(&design.name)) {
                continue;
            }
            let mut table = effect.numbers.clone();
            table.insert("strength".to_string(), toml::Value::Float(effect.strength));
            let acting = acting(&effect.name, &table, &design).map_err(|error| failed(error.to_string()))?;
            match is_applicable(&acting.card(), &design) {
                true => {
                    design.effects.insert(effect.name.clone(), table);
                }
                false if concerns.is_none() => {}
                false => {
                    let reason = format!(
                        "effect {} can do nothing here, and the study names this design",
                        effect.name
                    );
                    return Err(failed(reason));
                }
            }
        }
        for name in candidates {
            let Some(effect) = named(name) else {
                return Err(failed(format!("there is no effect {name} (washout effects)")));
            };
            if !design.effects.contains_key(*name) && is_applicable(&effect.card(), &design) {
                let strength = [("strength".to_string(), toml::Value::Float(0.0))];
                design
                    .effects
                    .insert(name.to_string(), strength.into_iter().collect());
            }
        }
        if !candidates.is_empty() {
            admit(&mut design);
        }
        let mesh_file = case
            .loaded
            .read_mesh_file()
            .map_err(|error| failed(error.to_string()))?;
        Ok(PreparedCase {
            name: case.name.clone(),
            family: case.family.clone(),
            numbers: case.numbers.clone(),
            design,
            rows: case.rows.clone(),
            is_held_out: case.is_held_out,
            base: None,
            air_table: case.loaded.air_table.clone(),
            mesh_file,
        })
    }

    /// What the case is as a condition.
    pub fn condition(&self) -> Condition {
        let design = &self.design;
        let flow = Flow::from_design(design);
        let length_m = 1e-3 * design.planform.length_mm.value();
        let speed = flow.map_or(0.0, |flow| flow.velocity(length_m).norm());
        let flapping = design.flapping.as_ref();
        Condition {
            name: self.name.clone(),
            wing: design.name.clone(),
            is_held_out: self.is_held_out,
            frequency_hz: flapping.map(|flapping| flapping.frequency_hz.value()),
            half_amplitude_deg: flapping.map(|flapping| flapping.half_amplitude_deg.value()),
            dynamic_pressure_pa: 0.5 * design.air.density_kg_m3.value() * speed * speed,
            length_m,
        }
    }

    /// Starts every further solve from this one.
    pub fn start_from(&mut self, solved: Solved) {
        self.base = Some(Arc::new(solved));
    }

    /// The case as it stands, if `design` is just that.
    pub fn base_at(&self, design: &Design) -> Option<Arc<Solved>> {
        self.base.clone().filter(|base| base.at.design == *design)
    }

    /// A failure of this case.
    pub fn failed(&self, reason: impl Display) -> StudyError {
        StudyError::Case {
            case: self.name.clone(),
            reason: reason.to_string(),
        }
    }

    fn unsolved(&self, error: CouplingError) -> StudyError {
        match error {
            CouplingError::Interrupted(cancelled) => StudyError::Cancelled(cancelled),
            error if error.is_not_converged() => StudyError::Unsolved {
                case: self.name.clone(),
                reason: error.to_string(),
            },
            error => self.failed(error),
        }
    }

    /// Solves the case with a design of its own, from `near` or else from the case as it stands; leaves the tangent there.
    ///
    /// # Errors
    /// If there is no solution.
    pub fn solve(
        &self,
        design: &Design,
        near: Option<&Near>,
        progress: &Progress,
    ) -> Result<(Solved, Tangent), StudyError> {
        progress.check()?;
        let (planform, mesh) = self.mesh(design).map_err(|error| self.failed(error))?;
        let base = self.base.as_deref();
        let start = near.map(|near| (near.solution, near.step.as_deref()));
        let start = start.or(base.map(|base| (&base.at.solution, None)));
        let alike = base.filter(|base| base.at.solution.mesh == mesh);
        let (alike, nearby) = (alike.map(|base| &base.wing), start.map(|(nearby, _)| nearby));
        let wing = Wing::near(design, &mesh, self.air_table.as_deref(), alike, nearby)
            .map_err(|error| self.unsolved(error))?;
        let solution = coupling::solve_wing(design, &wing, &mesh, start, progress);
        let (solution, tangent) = solution.map_err(|error| self.unsolved(error))?;
        let at = Nearby {
            design: design.clone(),
            planform,
            solution,
        };
        Ok((Solved { at, wing }, tangent))
    }

    fn mesh(&self, design: &Design) -> Result<(Planform, Mesh), MeshError> {
        let file = self
            .mesh_file
            .as_ref()
            .map(|(name, bytes)| MeshFile { name, bytes });
        for_design(design, file)
    }

    /// What the solved case gives for every row, or why it gives nothing.
    ///
    /// # Errors
    /// If the instrument cannot be set up.
    pub fn read_each(&self, solved: &Nearby) -> Result<Vec<Result<f64, String>>, StudyError> {
        let Nearby {
            design,
            planform,
            solution,
        } = solved;
        let own = Observer::new(design, planform, solution).map_err(|error| self.failed(error))?;
        let whole = self.whole_wing(solved)?;
        let own_profile = OnceCell::new();
        let mut readings = Vec::new();
        for row in &self.rows {
            let reading = match row
                .instrument
                .filter(|instrument| *instrument != own.instrument())
            {
                None => read_channel(row, &own, own_profile.get_or_init(|| own.profile()), &whole),
                Some(instrument) => match own.seen_by(instrument) {
                    Ok(other) => read_channel(row, &other, &other.profile(), &whole),
                    Err(error) => Err(error.to_string()),
                },
            };
            readings.push(reading.map(|reading| reading.value));
        }
        Ok(readings)
    }

    /// What the solved case gives for every row.
    ///
    /// # Errors
    /// If a row cannot be read any more.
    pub fn read(&self, solved: &Nearby) -> Result<Vec<f64>, StudyError> {
        let readings = self.read_each(solved)?.into_iter().zip(&self.rows);
        let value = |(reading, row): (Result<f64, String>, &Row)| {
            reading.map_err(|reason| self.failed(format!("line {} of its measurement: {reason}", row.line)))
        };
        readings.map(value).collect()
    }

    fn whole_wing(&self, solved: &Nearby) -> Result<BTreeMap<Channel, f64>, StudyError> {
        let wanted = [Channel::Lift, Channel::Drag, Channel::Power];
        let mut whole = BTreeMap::new();
        let Some(flow) = Flow::from_design(&solved.design) else {
            return Ok(whole);
        };
        if !self.rows.iter().any(|row| wanted.contains(&row.channel)) {
            return Ok(whole);
        }
        let table = self.air_table.as_deref();
        let law = BladeAir::new(&solved.design, &solved.planform, table);
        let law = law.map_err(|error| self.failed(error))?;
        let report = LiftReport::new(&solved.planform, &law, &flow, &solved.solution.strips);
        let report = report.map_err(|error| self.failed(error))?;
        if let Some(mean) = &report.stroke_mean {
            whole.extend(
                wanted
                    .into_iter()
                    .zip([mean.lift_mn, mean.drag_mn, mean.power_mw]),
            );
        }
        Ok(whole)
    }

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
        let mut sensitivity = match tangent {
            Some(tangent) => Sensitivity::with_tangent(design, wing, table, solution, &remesh, tangent),
            None => Sensitivity::new(design, wing, table, solution, &remesh)
                .map_err(|error| self.failed(error))?,
        };
        let mut rates = Vec::new();
        for Asked {
            index,
            key,
            switch,
            placed,
        } in columns
        {
            progress.check()?;
            if let Some(sets) = placed {
                let mut design = solved.design.clone();
                for (key, number) in sets {
                    design.set(key, *number).map_err(|error| self.failed(error))?;
                }
                let mut placed = Sensitivity::new(&design, wing, table, solution, &remesh)
                    .map_err(|error| self.failed(error))?;
                work.derivatives += 1;
                work.factorizations += 1;
                let column = self.column(&mut placed, key, &here)?;
                rates.push((*index, column));
                continue;
            }
            let column = match switch {
                Some(step) => {
                    let mut design = solved.design.clone();
                    design.set(key, *step).map_err(|error| self.failed(error))?;
                    // its derivative to the side of the step leads part of the way
                    let rate = sensitivity.rate(key).ok();
                    let way = |rate: Rate| rate.state.iter().map(|change| change * step).collect();
                    let from = Near {
                        solution: &solved.solution,
                        step: rate.filter(|rate| !rate.moves_mesh).map(way),
                    };
                    let (there, _) = self.solve(&design, Some(&from), progress)?;
                    work += there.work();
                    let there = self.read(&there.at)?;
                    let rates = there.iter().zip(&here);
                    Column {
                        rates: rates.map(|(there, here)| (there - here) / step).collect(),
                        shape: None,
                    }
                }
                None => {
                    work.derivatives += 1;
                    self.column(&mut sensitivity, key, &here)?
                }
            };
            rates.push((*index, column));
        }
        Ok((rates, work))
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

impl Observable {
    /// A measured row of a condition.
    pub fn of(row: &Row, condition: usize) -> Observable {
        Observable {
            condition,
            line: row.line,
            channel: row.channel,
            run: row.run.clone(),
            r_mm: row.r_mm,
            r_to_mm: row.r_to_mm,
            value: row.value,
            sigma: row.sigma,
            bound: row.bound,
        }
    }
}
