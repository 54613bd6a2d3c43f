//! One case of a study: its design solved, and read as it was measured.

use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::fmt::Display;
use std::sync::Arc;

use super::error::StudyError;
use super::forward::{Condition, Observable};
use super::unnamed;
use super::work::Work;
use crate::aero::Flow;
use crate::coupling::mid_stroke::moving;
use crate::coupling::motion::{Motions, motion_needed};
use crate::coupling::sensitivity::Nearby;
use crate::coupling::wing::Wing;
use crate::coupling::{self, BladeAir, Care, CouplingError, Difference, Near};
use crate::effects::{Effect, acting, is_applicable, lacks, named, with_common_numbers};
use crate::geometry::Planform;
use crate::input::Design;
use crate::input::design::Instrument;
use crate::input::measurement::{Channel, Row};
use crate::input::study::{CaseNumber, LoadedCase, LoadedStudy};
use crate::lift::LiftReport;
use crate::mesh::{Mesh, MeshError, MeshFile, for_design};
use crate::observation::{Observer, read_channel};
use crate::origin::InputFile;
use crate::progress::Progress;
use crate::structure::{StructureError, Tangent};

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
    /// Effects that the design states itself: part of the model, and never tried.
    own_effects: Vec<String>,
    /// Effects that joined the design to be tried.
    joined: Vec<String>,
    is_held_out: bool,
    /// The case as it stands, from which it is solved with other values: fixed by the study, so that results are too.
    base: Option<Arc<Solved>>,
    /// What the case as it stands moves as, and its motions over the stroke.
    motions: Option<(Design, Arc<Motions>)>,
    pub(super) air_table: Option<Vec<[f64; 3]>>,
    mesh_file: Option<(String, Arc<[u8]>)>,
}

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

/// A solved case: design, outline and solution, and the wing that was solved.
#[derive(Debug, Clone)]
pub struct Solved {
    /// Design, outline and solution.
    pub at: Nearby,
    pub(super) wing: Wing,
}

impl Solved {
    /// Where its wing differs from that of another solution of the case, the air of both on the shape of that one; none where they are not
    /// on one mesh.
    pub fn difference(&self, other: &Solved) -> Option<Difference> {
        self.wing.difference(&other.wing, &other.at.solution.state)
    }

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
            if design.effects.contains_key(&effect.name) {
                return Err(failed(format!(
                    "effect {0} stands in the study ([[effect]]) and in the design {1} ([effects.{0}]); take it out of one of them",
                    effect.name,
                    case.loaded.path.display()
                )));
            }
            let mut table = effect.numbers.clone();
            table.insert("strength".to_string(), toml::Value::Float(effect.strength));
            common(&effect.name, &mut table, study).map_err(|error| failed(error.to_string()))?;
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
        let mut joined = Vec::new();
        let tried = candidates
            .iter()
            .filter(|_| study.study.is_tried_on(&design.name));
        for name in tried.copied().collect::<Vec<&str>>() {
            let Some(effect) = named(name) else {
                return Err(failed(format!("there is no effect {name} (washout effects)")));
            };
            if !design.effects.contains_key(name) && why_not_tried(effect, &design, &case.rows).is_none() {
                let mut table = toml::Table::new();
                table.insert("strength".to_string(), toml::Value::Float(0.0));
                common(name, &mut table, study).map_err(|error| failed(error.to_string()))?;
                design.effects.insert(name.to_string(), table);
                joined.push(name.to_string());
            }
        }
        if !candidates.is_empty() {
            unnamed::place(&mut design);
        }
        Ok(PreparedCase {
            joined,
            name: case.name.clone(),
            family: case.family.clone(),
            numbers: case.numbers.clone(),
            own_effects: case.loaded.design.effects.keys().cloned().collect(),
            design,
            rows: case.rows.clone(),
            is_held_out: case.is_held_out,
            base: None,
            motions: None,
            air_table: case.loaded.air_table.clone(),
            mesh_file: case.loaded.mesh_file.clone(),
        })
    }

    /// Whether an effect is tried on the case: it is in its design, and was not stated there.
    pub fn tries(&self, effect: &str) -> bool {
        self.design.effects.contains_key(effect) && !self.states(effect)
    }

    /// Whether the design of the case states an effect itself.
    pub fn states(&self, effect: &str) -> bool {
        self.own_effects.iter().any(|own| own == effect)
    }

    /// Why a diagnosis cannot try an effect on the case; none if it can.
    pub fn why_not_tried(&self, effect: &dyn Effect) -> Option<String> {
        why_not_tried(effect, &self.design, &self.rows)
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

    /// What its solution depends on, as text.
    pub(super) fn made_of(&self) -> String {
        let mesh = self
            .mesh_file
            .as_ref()
            .map(|(name, bytes)| InputFile::new(name, bytes));
        format!("{:?}", (&self.design, &self.air_table, mesh))
    }

    /// Whether an effect joined its design to be tried.
    pub(super) fn joined(&self, effect: &str) -> bool {
        self.joined.iter().any(|own| own == effect)
    }

    /// As [`PreparedCase::made_of`], without the effects that joined its design to be tried.
    pub(super) fn made_of_without_tried(&self) -> String {
        let mut own = self.clone();
        own.design.effects.retain(|name, _| !self.joined(name));
        own.made_of()
    }

    /// Starts every further solve from this one.
    pub fn start_from(&mut self, solved: Solved) {
        // a design whose effects are not what their cards ask for was not solved
        self.motions = moving(&solved.at.design)
            .ok()
            .map(|design| (design, Arc::default()));
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
        let from_base = base.map(|base| Near {
            solution: &base.at.solution,
            step: None,
            care: Care::Full,
        });
        let start = near.or(from_base.as_ref());
        let alike = base.filter(|base| base.at.solution.mesh == mesh);
        let (alike, nearby) = (alike.map(|base| &base.wing), start.map(|near| near.solution));
        let air_table = self.air_table.as_deref();
        let moves_as = |other: &Design| moving(design).is_ok_and(|design| design == *other);
        let motion = match (base, &self.motions) {
            (Some(base), Some((other, motions))) if moves_as(other) => {
                motions.needed(design, &mesh, air_table, &base.at.solution, progress)
            }
            _ => motion_needed(design, &mesh, air_table, nearby, progress),
        };
        let wing = motion.and_then(|motion| match alike {
            Some(alike) => alike.beside(design, &mesh, air_table, None, motion),
            None => Wing::with_motion(design, &mesh, air_table, motion),
        });
        let wing = wing.map_err(|error| self.unsolved(error))?;
        let solution = coupling::solve_wing(design, &wing, &mesh, start, progress);
        let (solution, tangent) = solution.map_err(|error| self.unsolved(error))?;
        solution
            .refuse_pull_of_stop(design)
            .map_err(|error| self.unsolved(error))?;
        let at = Nearby {
            design: design.clone(),
            planform,
            solution,
        };
        Ok((Solved { at, wing }, tangent))
    }

    pub(super) fn mesh(&self, design: &Design) -> Result<(Planform, Mesh), MeshError> {
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

/// What the design or the rows of a case lack for an effect to be tried: one of the picture changes what a camera reads.
fn why_not_tried(effect: &dyn Effect, design: &Design, rows: &[Row]) -> Option<String> {
    let is_by_camera = |row: &Row| {
        let instrument = row.instrument.unwrap_or(design.observation.instrument);
        matches!(row.channel, Channel::Twist | Channel::TwistRate) && instrument == Instrument::Camera
    };
    let is_blind = effect.is_of_picture() && !rows.iter().any(is_by_camera);
    let no_camera = || is_blind.then(|| "no twist was read by a camera".to_string());
    lacks(&effect.card(), design).or_else(no_camera)
}

/// Adds the numbers of an effect that all wings of a study have in common.
fn common(name: &str, table: &mut toml::Table, study: &LoadedStudy) -> Result<(), StructureError> {
    match study.cases.first() {
        Some(first) => with_common_numbers(name, table, &first.loaded.design),
        None => Ok(()),
    }
}
