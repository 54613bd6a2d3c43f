//! A design solved: its summary, its files, and its numbers as NumPy arrays.

use std::path::{Path, PathBuf};

use pyo3::prelude::*;
use pyo3::types::PyDict;
use washout::cli::solve::Run;
use washout::cli::{Failure, Verb};
use washout::export::csv::{STRIPS_HEAD, strip_row};
use washout::export::json;
use washout::export::run::RunFolder;
use washout::input::Design;
use washout::observation::field::twist_at_nodes;
use washout::structure::state::State;
use washout::wing::WingModel;

use crate::arrays::{elements, nodes, numbers, rows};
use crate::failure::{other, raised, refused};
use crate::verb::parsed;
use crate::worker::work;

/// Solves a design; `arguments` are those of `washout solve`, `text` stands for the file where it is given.
#[pyfunction]
#[pyo3(signature = (arguments, text=None, listener=None))]
pub fn solve(
    py: Python<'_>,
    arguments: Vec<String>,
    text: Option<String>,
    listener: Option<Py<PyAny>>,
) -> PyResult<Solved> {
    let command = [vec!["solve".to_string()], arguments].concat();
    let arguments = parsed(command).map_err(|error| refused(py, &error))?;
    let Verb::Solve(asked) = arguments.verb else {
        return Err(other(py, "these are no arguments of washout solve"));
    };
    let run = work(py, listener, move |progress| {
        let loaded = match &text {
            Some(text) => Design::load_text(text, &asked.design.design, &asked.design.set)?,
            None => asked.design.load(&[])?,
        };
        Run::new(&WingModel::new(loaded)?, &asked.asked, progress)
    })?;
    Ok(Solved { run })
}

/// A solved design.
#[pyclass(frozen, module = "washout._washout")]
pub struct Solved {
    run: Run,
}

#[pymethods]
impl Solved {
    /// The document `summary.json`, without files.
    fn summary(&self, py: Python<'_>) -> PyResult<String> {
        json::document(&self.run.summary())
            .and_then(|document| json::text(&document))
            .map_err(|error| other(py, &error.to_string()))
    }

    /// Writes the folder of the run, as `washout solve --output` does.
    fn write(&self, py: Python<'_>, folder: PathBuf, report: bool) -> PyResult<PathBuf> {
        py.detach(|| self.written(&folder, report))
            .map_err(|failure| raised(py, &failure))
    }

    /// The columns of `strips.csv`.
    fn strips<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let strips: Vec<[f64; 10]> = self.run.wing.solution.strips.iter().map(strip_row).collect();
        let columns = PyDict::new(py);
        for (index, name) in STRIPS_HEAD.iter().enumerate() {
            columns.set_item(name, numbers(py, strips.iter().map(|strip| strip[index])))?;
        }
        Ok(columns)
    }

    /// The mesh at rest and deformed, and what acts on it; the fields of `washout.Shape`.
    fn shape<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let solution = &self.run.wing.solution;
        let mesh = &solution.mesh;
        let points_mm = |state: &State| {
            let moved = mesh.nodes.iter().zip(&state.displacement);
            let points = moved.map(|(node, u)| [node[0] + u[0], node[1] + u[1], node[2] + u[2]]);
            rows(py, points.map(|point| point.map(|x_m| x_m * 1e3)))
        };
        let twist = twist_at_nodes(&self.run.wing.model.planform, solution);
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
}

impl Solved {
    fn written(&self, target: &Path, report: bool) -> Result<PathBuf, Failure> {
        let mut folder = RunFolder::create(target, "solve")?;
        self.run.add_files(&mut folder, report)?;
        Ok(folder.commit()?)
    }
}
