//! A wing solved: `wing::SolvedWing`, and its numbers as NumPy arrays.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde::Serialize;
use washout::cli::Failure;
use washout::compare::{ModelledStages, Reading};
use washout::export::collect::{self, summarize, write_files};
use washout::export::csv::{STRIPS_HEAD, strip_row};
use washout::export::json;
use washout::export::run::RunFolder;
use washout::export::summary::ProfileRow;
use washout::observation::TwistReading;
use washout::observation::field::twist_at_nodes;
use washout::progress::Progress;
use washout::structure::state::State;
use washout::wing::{DiscretizationError, SolvedWing, WingError};

use crate::arrays::{elements, nodes, numbers, rows};
use crate::failure::{other, raised};
use crate::worker::work;

/// A wing and its loaded shape.
#[pyclass(frozen, module = "washout._washout")]
pub struct Solved {
    wing: Arc<SolvedWing>,
}

#[pymethods]
impl Solved {
    /// Twist (deg) at places along the span (mm), as the instrument of the design reads it; NaN where it cannot be read.
    fn twist_at<'py>(
        &self,
        py: Python<'py>,
        r_mm: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        // a copy: other threads may write into that array while the lock is free
        let places_mm = r_mm.as_array().to_vec();
        let twist_deg = self.read(py, |wing| {
            let observer = wing.observer()?;
            let twist_deg = |r_mm: f64| {
                let reading = observer.twist(r_mm / 1e3);
                reading.map_or(f64::NAN, |reading| reading.twist_rad.to_degrees())
            };
            Ok(places_mm.into_iter().map(twist_deg).collect::<Vec<f64>>())
        })?;
        Ok(twist_deg.into_pyarray(py))
    }

    /// Twist of the tip station, deg; none where it cannot be read.
    fn tip_twist_deg(&self, py: Python<'_>) -> PyResult<Option<f64>> {
        self.read(py, SolvedWing::tip_twist_deg)
    }

    /// Rows of the twist at the stations of the design, as JSON.
    fn profile(&self, py: Python<'_>) -> PyResult<String> {
        let profile = self.read(py, SolvedWing::profile)?;
        text(py, &profile_rows(&profile.readings))
    }

    /// The same with places evenly between, as JSON.
    fn along_span(&self, py: Python<'_>) -> PyResult<String> {
        let readings = self.read(py, |wing| Ok(wing.observer()?.along_span()))?;
        text(py, &profile_rows(&readings))
    }

    /// Rows of the fitted stages, as JSON; none where the profile carries no fit.
    fn stages(&self, py: Python<'_>) -> PyResult<String> {
        let fit = self.read(py, |wing| Ok(ModelledStages::of(&wing.profile()?)))?;
        text(py, &fit.map_or(Vec::new(), |fit| fit.stages))
    }

    /// Lift, drag and power, as JSON; null without flow.
    fn lift(&self, py: Python<'_>) -> PyResult<String> {
        text(py, &self.read(py, SolvedWing::lift)?)
    }

    /// The columns of `strips.csv`.
    fn strips<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let strips: Vec<[f64; 10]> = self.wing.solution.strips.iter().map(strip_row).collect();
        let columns = PyDict::new(py);
        for (index, name) in STRIPS_HEAD.iter().enumerate() {
            columns.set_item(name, numbers(py, strips.iter().map(|strip| strip[index])))?;
        }
        Ok(columns)
    }

    /// The mesh at rest and deformed, and what acts on it; the fields of `washout.Shape`.
    fn shape<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let solution = &self.wing.solution;
        let mesh = &solution.mesh;
        let points_mm = |state: &State| {
            let moved = mesh.nodes.iter().zip(&state.displacement);
            let points = moved.map(|(node, u)| [node[0] + u[0], node[1] + u[1], node[2] + u[2]]);
            rows(py, points.map(|point| point.map(|x_m| x_m * 1e3)))
        };
        let twist = twist_at_nodes(&self.wing.model.planform, solution);
        let shape = PyDict::new(py);
        shape.set_item("rest_mm", points_mm(&solution.rest))?;
        shape.set_item("deformed_mm", points_mm(&solution.state))?;
        shape.set_item("twist_deg", numbers(py, twist.into_iter().map(f64::to_degrees)))?;
        let force = solution.air_force_n.iter();
        shape.set_item(
            "air_force_mn",
            rows(py, force.map(|force| force.map(|n| n * 1e3))),
        )?;
        shape.set_item("triangles", elements(py, mesh.triangles.iter().copied()))?;
        shape.set_item("pressure_pa", numbers(py, solution.pressure_pa.iter().copied()))?;
        shape.set_item("beams", elements(py, mesh.beams.iter().map(|beam| beam.nodes)))?;
        shape.set_item("leading_edge", nodes(py, &mesh.leading_edge))?;
        shape.set_item("trailing_edge", nodes(py, &mesh.trailing_edge))?;
        Ok(shape)
    }

    /// Writes the folder of a run, with the stresses; the error of the mesh is not among it. `report`: the HTML report too.
    #[pyo3(signature = (folder, report=false, listener=None))]
    fn write(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        report: bool,
        listener: Option<Py<PyAny>>,
    ) -> PyResult<PathBuf> {
        let wing = Arc::clone(&self.wing);
        work(py, listener, move |progress| {
            written(&wing, &folder, report, progress)
        })
    }
}

impl Solved {
    pub fn new(wing: SolvedWing) -> Solved {
        Solved { wing: Arc::new(wing) }
    }

    /// What the wing answers, without Python's lock.
    fn read<T: Send>(
        &self,
        py: Python<'_>,
        ask: impl FnOnce(&SolvedWing) -> Result<T, WingError> + Send,
    ) -> PyResult<T> {
        py.detach(|| ask(&self.wing))
            .map_err(|error| raised(py, &error.into()))
    }
}

fn written(wing: &SolvedWing, target: &Path, report: bool, progress: &Progress) -> Result<PathBuf, Failure> {
    let mut folder = RunFolder::create(target, "solve")?;
    let other_equilibrium = wing.with_usual_options(progress)?;
    let solved = collect::Solved {
        wing,
        reading: &Reading::of(wing, &BTreeMap::new())?,
        mesh_error: &DiscretizationError {
            unknown_because: Some("the wing was solved on one mesh only".to_string()),
            ..DiscretizationError::default()
        },
        other_equilibrium: other_equilibrium.as_ref(),
        uncertainty: None,
        engineering: &wing.engineering(progress)?,
    };
    write_files(&mut folder, &solved, &mut summarize(&solved), report)?;
    progress.check()?;
    Ok(folder.commit()?)
}

fn profile_rows(readings: &[TwistReading]) -> Vec<ProfileRow> {
    readings.iter().map(ProfileRow::of).collect()
}

fn text(py: Python<'_>, document: &impl Serialize) -> PyResult<String> {
    json::text(document).map_err(|error| other(py, &error.to_string()))
}
