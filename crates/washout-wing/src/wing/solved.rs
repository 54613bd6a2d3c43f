//! A wing solved: its loaded shape, and what is read of it.

use crate::aero::Flow;
use crate::coupling::balance::{Balance, at_shape};
use crate::coupling::engineering::engineering;
use crate::coupling::solution::Solution;
use crate::coupling::{Care, CouplingError, Engineering, Near, solve_near};
use crate::lift::{LiftError, LiftReport, Stroke, StrokeMeans, TwistAlongSpan, TwistHistory, stroke_means};
use crate::observation::{Observer, TwistProfile, twist_at};
use crate::progress::Progress;
use crate::structure::state::State;

use super::error::WingError;
use super::model::WingModel;

/// A wing and its loaded shape.
#[derive(Debug, Clone)]
pub struct SolvedWing {
    /// What was solved.
    pub model: WingModel,
    /// The loaded shape.
    pub solution: Solution,
}

impl SolvedWing {
    /// A wing with a shape of its own.
    pub fn new(model: WingModel, solution: Solution) -> SolvedWing {
        SolvedWing { model, solution }
    }

    /// The wing before the instrument of its design.
    ///
    /// # Errors
    /// If that cannot see it.
    pub fn observer(&self) -> Result<Observer<'_>, WingError> {
        let WingModel { loaded, planform, .. } = &self.model;
        Observer::new(&loaded.design, planform, &self.solution).map_err(|error| self.model.fault(error))
    }

    /// Twist along the span at the stations of the design.
    ///
    /// # Errors
    /// As [`SolvedWing::observer`].
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use washout::{progress::Progress, wing::WingModel};
    /// let solved = WingModel::open("designs/twist-v1.toml", &["mesh.refine=0.5"])?.solve(&Progress::quiet())?;
    /// for reading in &solved.profile()?.readings {
    ///     println!("{:5.1} mm {:6.2} deg", 1e3 * reading.r_m, reading.twist_rad.to_degrees());
    /// }
    /// # Ok::<(), washout::wing::WingError>(())
    /// ```
    pub fn profile(&self) -> Result<TwistProfile, WingError> {
        Ok(self.observer()?.profile())
    }

    /// Twist at `r_m` from the base, rad, positive for washout; none where it cannot be read.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use washout::{progress::Progress, wing::WingModel};
    /// let solved = WingModel::open("designs/twist-v1.toml", &["mesh.refine=0.5"])?.solve(&Progress::quiet())?;
    /// assert!(solved.twist_at(0.04) > solved.twist_at(0.02));
    /// # Ok::<(), washout::wing::WingError>(())
    /// ```
    pub fn twist_at(&self, r_m: f64) -> Option<f64> {
        twist_at(self.model.design(), &self.model.planform, &self.solution, r_m)
    }

    /// Lift, drag and power; none without flow.
    ///
    /// # Errors
    /// If the air cannot be set up.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use washout::{progress::Progress, wing::WingModel};
    /// let solved = WingModel::open("designs/twist-v1.toml", &["mesh.refine=0.5"])?.solve(&Progress::quiet())?;
    /// let lift = solved.lift()?.expect("it flaps");
    /// assert!(lift.solved.lift_mn > 0.0);
    /// # Ok::<(), washout::wing::WingError>(())
    /// ```
    pub fn lift(&self) -> Result<Option<LiftReport>, WingError> {
        let Some(flow) = Flow::from_design(self.model.design()) else {
            return Ok(None);
        };
        let law = self.model.air()?;
        let report = LiftReport::new(&self.model.planform, &law, &flow, &self.solution.strips);
        report.map(Some).map_err(|error| self.model.fault(error))
    }

    /// Means over the stroke with the solved twist on the paper's ramp; none for a wing that does not flap.
    ///
    /// # Errors
    /// As [`SolvedWing::lift`].
    pub fn means_on_ramp(&self) -> Result<Option<StrokeMeans>, WingError> {
        self.model.means(|stroke| {
            let full = TwistAlongSpan::from_strips(&self.solution.strips, stroke.stop_angle_rad)?;
            Ok(TwistHistory::paper_ramp(full))
        })
    }

    /// Mass, stiffness, stresses and margins.
    ///
    /// # Errors
    /// If the structure cannot be set up.
    pub fn engineering(&self, progress: &Progress) -> Result<Engineering, WingError> {
        let WingModel { loaded, planform, .. } = &self.model;
        let found = engineering(&loaded.design, planform, &self.solution, progress);
        found.map_err(|source| self.model.unsolved(source))
    }
}

impl WingModel {
    /// The loaded shape.
    ///
    /// # Errors
    /// If there is none that is found, or the pitch stop would have to pull.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use washout::{progress::Progress, wing::WingModel};
    /// let wing = WingModel::open("designs/twist-v2.toml", &["mesh.refine=0.5"])?;
    /// let tip_m = 0.97 * wing.planform.length_m();
    /// let twist_rad = wing.solve(&Progress::quiet())?.twist_at(tip_m);
    /// assert!((twist_rad.unwrap().to_degrees() - 20.5).abs() < 1.0);
    /// # Ok::<(), washout::wing::WingError>(())
    /// ```
    pub fn solve(&self, progress: &Progress) -> Result<SolvedWing, WingError> {
        let solution = self
            .shape(None, progress)
            .map_err(|source| self.unsolved(source))?;
        Ok(SolvedWing::new(self.clone(), solution))
    }

    /// The wing in a shape that is made from its unloaded one, and how well that meets the equations; nothing is solved but the cure.
    ///
    /// # Errors
    /// If the wing cannot be set up, or would not stay in that shape.
    pub fn at_shape(
        &self,
        shape: impl FnOnce(&State) -> State,
        progress: &Progress,
    ) -> Result<(SolvedWing, Balance), WingError> {
        let found = at_shape(self.design(), &self.mesh, self.air_table(), shape, progress);
        let (solution, balance) = found.map_err(|source| self.unsolved(source))?;
        Ok((SolvedWing::new(self.clone(), solution), balance))
    }

    /// As [`WingModel::solve`], found sooner from the shape of a wing nearby.
    ///
    /// # Errors
    /// As [`WingModel::solve`].
    pub fn solve_from(&self, nearby: &Solution, progress: &Progress) -> Result<SolvedWing, WingError> {
        let solution = self.shape(Some(nearby), progress);
        let solution = solution.map_err(|source| self.unsolved(source))?;
        Ok(SolvedWing::new(self.clone(), solution))
    }

    /// As [`WingModel::solve_from`], given up where Newton's method does not settle: for who asks again at once, as after a slider
    /// moved. Of several shapes that the wing can rest in it finds the one that is nearest, not always the one that
    /// [`WingModel::solve`] finds.
    ///
    /// # Errors
    /// As [`WingModel::solve`], and where it is given up.
    pub fn follow(&self, nearby: &Solution, progress: &Progress) -> Result<SolvedWing, WingError> {
        let near = Near {
            solution: nearby,
            step: None,
            care: Care::Trial,
        };
        let found = solve_near(self.design(), &self.mesh, self.air_table(), Some(&near), progress);
        let solution = found.map_err(|source| self.unsolved(source))?;
        let pulls = solution.refuse_pull_of_stop(self.design());
        pulls.map_err(|source| self.unsolved(source))?;
        Ok(SolvedWing::new(self.clone(), solution))
    }

    /// The wing at another phase of its stroke, solved as if it stood still; from a shape nearby if there is one.
    ///
    /// # Errors
    /// As [`WingModel::solve`].
    pub fn at_phase(
        &self,
        phase_deg: f64,
        nearby: Option<&SolvedWing>,
        progress: &Progress,
    ) -> Result<SolvedWing, WingError> {
        self.with("flapping.phase_deg", phase_deg)?
            .at_this_phase(phase_deg, nearby, progress)
    }

    /// The wing at mid-stroke with `part` of its amplitude: the speed of the air that it has at the phase acos(`part`).
    ///
    /// # Errors
    /// As [`WingModel::solve`].
    pub fn at_speed(
        &self,
        part: f64,
        nearby: Option<&SolvedWing>,
        progress: &Progress,
    ) -> Result<SolvedWing, WingError> {
        let mut design = self.design().clone();
        design.set("flapping.phase_deg", 0.0)?;
        if part != 1.0
            && let Some(amplitude_deg) = design.flapping.as_ref().map(|own| own.half_amplitude_deg.value())
        {
            design.set("flapping.half_amplitude_deg", amplitude_deg * part)?;
        }
        self.with_design(design)?
            .at_this_phase(part.min(1.0).acos().to_degrees(), nearby, progress)
    }

    fn at_this_phase(
        self,
        phase_deg: f64,
        nearby: Option<&SolvedWing>,
        progress: &Progress,
    ) -> Result<SolvedWing, WingError> {
        match self.shape(nearby.map(|nearby| &nearby.solution), progress) {
            Ok(solution) => Ok(SolvedWing::new(self, solution)),
            Err(CouplingError::Interrupted(cancelled)) => Err(cancelled.into()),
            Err(source) => Err(WingError::Phase {
                design: self.loaded.path,
                phase_deg,
                source,
            }),
        }
    }

    /// Means over the stroke with the twist that `history` gives; none for a wing that does not flap.
    ///
    /// # Errors
    /// If the air cannot be set up, or there is no such twist.
    pub fn means(
        &self,
        history: impl FnOnce(&Stroke) -> Result<TwistHistory, LiftError>,
    ) -> Result<Option<StrokeMeans>, WingError> {
        if !matches!(Flow::from_design(self.design()), Some(Flow::Flapping { .. })) {
            return Ok(None);
        }
        let (law, stroke) = (self.air()?, self.stroke()?);
        let found = history(&stroke).and_then(|twist| stroke_means(&self.planform, &law, &stroke, &twist));
        found.map(Some).map_err(|error| self.fault(error))
    }
}
