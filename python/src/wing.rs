//! A wing read and meshed: `wing::WingModel`.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use washout::cli::Failure;
use washout::export::json;
use washout::input::Design;
use washout::export::solved_run::SolvedRun;
use washout::progress::Progress;
use washout::solve::{Asked, OverStroke};
use washout::wing::{WingError, WingModel};

use crate::arrays::{elements, nodes, rows};
use crate::failure::{other, refused};
use crate::run::Run;
use crate::solved::Solved;
use crate::worker::work;

/// A wing that is ready to be solved; it never changes.
#[pyclass(frozen, module = "washout._washout")]
pub struct Wing {
    model: Arc<WingModel>,
}

#[pymethods]
impl Wing {
    /// Reads a design, with keys set as `KEY=VALUE`, and meshes the wing; `text` stands for the file where it is given.
    #[staticmethod]
    #[pyo3(signature = (path, sets, text=None))]
    fn open(py: Python<'_>, path: PathBuf, sets: Vec<String>, text: Option<String>) -> PyResult<Wing> {
        let model = work(py, None, move |_| -> Result<_, Failure> {
            let loaded = match &text {
                Some(text) => Design::load_text(text, &path, &sets)?,
                None => Design::load(&path, &sets)?,
            };
            Ok(WingModel::new(loaded)?)
        })?;
        Ok(Wing::new(model))
    }

    /// The same wing with one key of its design set to another number, in the key's unit.
    fn with_value(&self, py: Python<'_>, key: String, value: f64) -> PyResult<Wing> {
        self.changed(py, move |model| model.with(&key, value))
    }

    /// The same wing with an effect of the library at a strength.
    fn with_effect(&self, py: Python<'_>, effect: String, strength: f64) -> PyResult<Wing> {
        self.changed(py, move |model| model.with_effect(&effect, strength))
    }

    /// The loaded shape.
    #[pyo3(signature = (listener=None))]
    fn solve(&self, py: Python<'_>, listener: Option<Py<PyAny>>) -> PyResult<Solved> {
        let model = Arc::clone(&self.model);
        let wing = work(py, listener, move |progress| -> Result<_, Failure> {
            progress.say(format_args!("solving {}", model.design().name));
            Ok(model.solve(progress)?)
        })?;
        Ok(Solved::new(wing))
    }

    /// What `washout solve` makes of it: the error of the mesh, stresses and masses, and what is asked for besides.
    ///
    /// A number that no option can take is brought to the nearest one that the option can hold, which the library refuses.
    #[pyo3(signature = (stroke=None, stroke_quasi_static=None, uncertainty=None, listener=None))]
    fn run(
        &self,
        py: Python<'_>,
        stroke: Option<i64>,
        stroke_quasi_static: Option<i64>,
        uncertainty: Option<i64>,
        listener: Option<Py<PyAny>>,
    ) -> PyResult<Run> {
        let phases = |count: i64| count.clamp(0, u16::MAX.into()) as u16;
        let stroke = match (stroke, stroke_quasi_static) {
            (Some(_), Some(_)) => {
                let reason = "stroke_quasi_static does not go together with stroke; leave one out";
                return Err(refused(py, reason));
            }
            (Some(count), None) => Some(OverStroke::Periodic(phases(count))),
            (None, Some(count)) => Some(OverStroke::QuasiStatic(phases(count))),
            (None, None) => None,
        };
        let asked = Asked {
            uncertainty: uncertainty.map(|count| count.max(0) as usize),
            stroke,
            ..Asked::default()
        };
        let model = Arc::clone(&self.model);
        let run = work(py, listener, move |progress: &Progress| {
            SolvedRun::new::<Failure>(&model, &asked, progress)
        })?;
        Ok(Run::new(run))
    }

    /// The design as JSON, with every default, material and setting resolved.
    fn design(&self, py: Python<'_>) -> PyResult<String> {
        json::text(self.model.design()).map_err(|error| other(py, &error.to_string()))
    }

    /// Lengths and area of the outline, by names with units.
    fn outline<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let planform = &self.model.planform;
        let outline = PyDict::new(py);
        outline.set_item("length_mm", planform.length_m() * 1e3)?;
        outline.set_item("mean_chord_mm", planform.mean_chord_m() * 1e3)?;
        outline.set_item("area_mm2", planform.area_m2() * 1e6)?;
        Ok(outline)
    }

    /// The mesh; the fields of `washout.Mesh`.
    fn mesh<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let mesh = &self.model.mesh;
        let fields = PyDict::new(py);
        let points = mesh.nodes.iter().map(|node| node.map(|x_m| x_m * 1e3));
        fields.set_item("nodes_mm", rows(py, points))?;
        fields.set_item("triangles", elements(py, mesh.triangles.iter().copied()))?;
        fields.set_item("beams", elements(py, mesh.beams.iter().map(|beam| beam.nodes)))?;
        fields.set_item("leading_edge", nodes(py, &mesh.leading_edge))?;
        fields.set_item("trailing_edge", nodes(py, &mesh.trailing_edge))?;
        Ok(fields)
    }
}

impl Wing {
    fn new(model: WingModel) -> Wing {
        Wing {
            model: Arc::new(model),
        }
    }

    fn changed(
        &self,
        py: Python<'_>,
        change: impl FnOnce(&WingModel) -> Result<WingModel, WingError> + Send + 'static,
    ) -> PyResult<Wing> {
        let model = Arc::clone(&self.model);
        let changed = work(py, None, move |_| -> Result<_, Failure> { Ok(change(&model)?) })?;
        Ok(Wing::new(changed))
    }
}
