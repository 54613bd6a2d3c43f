//! Mixed Newton steps: the strains of a film are unknowns of their own, which each element eliminates before assembly.
//!
//! A film hardly stretches and hardly resists bending, so the turn of a Newton step stretches it to second order by far more
//! than the loads do. A step that takes law and tension from that false stretch crawls. Here they stand at the strain that
//! the last step led to in first order, ê: force σ(ê) + C(ê) (ε(u) − ê), tension σ(ê) (which is never negative). Where
//! ε(u) = ê this is the film's own force, so equilibrium is the same; on the way a few steps do what took dozens.
//!
//! Source of the idea: Magisano, Leonetti & Garcea, Comput. Methods Appl. Mech. Eng. 313 (2017) 986-1005 (for linear laws);
//! with three fields (Washizu) it holds for a law that is not linear.

use nalgebra::{SVector, UnitQuaternion, Vector3};

use super::StructureError;
use super::corotational::Response;
use super::equilibrium::Equilibrium;
use super::largest::larger;
use super::loads::Loads;
use super::model::{Aid, Guess};
use super::newton::TURN_OF_FILM;
use super::regularisation::Regularisation;
use super::sheet::{Compression, Sheet};
use super::shell::Shell;
use super::state::State;

/// Way to equilibrium by mixed steps.
#[derive(Debug, Clone, Default)]
pub struct Mixed {
    /// Strains and forces that the last step led to, to first order.
    aid: Aid,
    /// Share by which the diagonal is raised.
    raise: f64,
}

/// How far a state is from equilibrium.
#[derive(Debug, Clone, PartialEq)]
pub struct Distance {
    /// Residual relative to the load.
    pub relative: f64,
    /// What rounding alone makes of it.
    pub rounding: f64,
    /// Right-hand side of the next step, N and N·m by freedom.
    pub right: Vec<f64>,
}

impl Mixed {
    /// At the start of a way.
    pub fn new() -> Self {
        Mixed {
            aid: Aid {
                is_mixed: true,
                ..Aid::default()
            },
            raise: 0.0,
        }
    }
}

impl Equilibrium<'_> {
    /// Assembles residual and tangent of the next mixed step; [`Equilibrium::factorize_mixed`] goes on from here.
    pub fn assemble_mixed(&mut self, state: &State, loads: &Loads, way: &Mixed) -> Distance {
        self.values.fill(0.0);
        let assembled = self
            .model
            .assemble(&self.pattern, state, loads, Some(&way.aid), &mut self.values);
        let scale = self.scale(state, loads);
        Distance {
            relative: self.relative(&assembled.residual, scale),
            rounding: self.rounding_at(state, scale),
            right: self.descent(&assembled.linearized),
        }
    }

    /// Factorizes what [`Equilibrium::assemble_mixed`] left, with a fictitious tension of the films (N/m).
    ///
    /// # Errors
    /// If it is singular.
    pub fn factorize_mixed(
        &mut self,
        state: &State,
        tension_n_per_m: f64,
        way: &mut Mixed,
    ) -> Result<(), StructureError> {
        self.factorize_raised(state, tension_n_per_m, false, &mut way.raise)
    }

    /// The state after as much of a step as turns no node too far.
    pub fn move_mixed(&self, state: &State, step: &mut [f64], way: &mut Mixed) -> State {
        let length = self.longest(step, TURN_OF_FILM);
        step.iter_mut().for_each(|s| *s *= length);
        way.aid.guess = Some(self.model.guess(&self.pattern, state, step, true));
        self.moved(state, step, 1.0)
    }

    /// Tension that holds flat films of the structure against the first step under `loads`, N/m; 0 without films.
    pub fn starting_tension_n_per_m(&self, state: &State, loads: &Loads) -> f64 {
        let (force, moment) = loads.size(state);
        Regularisation::new(self.model, larger(force, moment / self.extent_m)).tension_n_per_m()
    }
}

impl Guess {
    /// Of the shell `index`, if it has one.
    pub(super) fn shell(&self, index: usize) -> Option<&SVector<f64, 18>> {
        self.shells.get(index)
    }
}

impl Shell {
    /// Writes the response of the law that is linear about the local freedoms `about`; gives the element's own force.
    pub(super) fn mixed_response(
        &self,
        sheet: &Sheet,
        (u, q): (&[Vector3<f64>; 3], &[UnitQuaternion<f64>; 3]),
        about: &SVector<f64, 18>,
        response: &mut Response<18>,
    ) -> SVector<f64, 18> {
        if matches!(sheet.compression, Compression::Carries) {
            // its law is linear
            self.respond(sheet, (u, q), Some(about), 0.0, response);
            return response.force;
        }
        let frame = self.frame(u);
        let p = frame.local_freedoms(&self.rest, u, q);
        let film = self.local(sheet, about, 0.0, response);
        let carry = frame.carry(&p);
        carry.response(response);
        let linearized = self.local_force_by(film.as_ref(), about, &p);
        response.force = carry.force(&linearized);
        let (energy, force) = self.local_force(sheet, &p);
        response.energy = energy;
        carry.force(&force)
    }
}
