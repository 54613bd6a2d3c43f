//! The fixed point: shapes of the strips → loads → structure → shapes, accelerated.

use super::accelerate::Accelerator;
use super::error::CouplingError;
use super::feedback::Feedback;
use super::near::Care;
use super::wing::Wing;
use crate::input::design::{self, Coupling, Structure};
use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, NewtonSettings, larger, largest, smaller};

/// Angle of attack below which the air hardly loads a strip, rad.
const FEATHERED_RAD: f64 = 5.0 * std::f64::consts::PI / 180.0;

/// Newton steps in all after which it is given up, for each iteration that the design allows.
const PATIENCE: usize = 50;

/// Iterations after which it is given up where the twist still changes by more than this in each, deg: the wing is thrown to and fro.
const THROWN: (usize, f64) = (6, 20.0);

/// A coupled equilibrium.
#[derive(Debug, Clone)]
pub struct Coupled {
    /// The shape.
    pub state: State,
    /// Loads on it.
    pub loads: Loads,
    /// Coupled residual relative to the load.
    pub residual: f64,
    /// Largest change of twist in the last iteration, deg.
    pub twist_change_deg: f64,
    /// Iterations.
    pub iterations: usize,
    /// Newton steps in all.
    pub newton_steps: usize,
    /// Twist of the strips in each iteration, deg.
    pub twist_history_deg: Vec<Vec<f64>>,
    /// Negative pivots of the structure's tangent at the solution.
    pub negative_pivots: usize,
    /// Critical dynamic pressure over the present one; `None`: no divergence.
    pub critical_ratio: Option<f64>,
}

impl Coupled {
    /// Before the first iteration.
    pub(super) fn at(state: State, loads: Loads) -> Self {
        Coupled {
            state,
            loads,
            residual: f64::INFINITY,
            twist_change_deg: f64::INFINITY,
            iterations: 0,
            newton_steps: 0,
            twist_history_deg: Vec::new(),
            negative_pivots: 0,
            critical_ratio: None,
        }
    }

    /// After a step of air and structure together, from where the strips had the shapes `from`; gives those that they have now. `rest_twist`: of the strips
    /// without load, rad.
    pub(super) fn step_to(
        &mut self,
        wing: &Wing,
        state: State,
        from: &[f64],
        rest_twist: &[f64],
    ) -> Vec<f64> {
        self.state = state;
        self.iterations += 1;
        self.newton_steps += 1;
        let moved = wing.strips.shapes(&self.state);
        let (old, new) = (twists(from), twists(&moved));
        self.twist_change_deg = largest_difference(&old, &new).to_degrees();
        let from_rest = new.iter().zip(rest_twist).map(|(t, r)| (t - r).to_degrees());
        self.twist_history_deg.push(from_rest.collect());
        moved
    }
}

/// Iterates from the shape `rest` (in equilibrium without load).
///
/// # Errors
/// If it does not converge, converges beyond divergence or on a shape that is not stable, or the air's load is not finite.
pub fn iterate(
    wing: &Wing,
    equilibrium: &mut Equilibrium,
    rest: &State,
    coupling: &Coupling,
    structure: &Structure,
    progress: &Progress,
) -> Result<Coupled, CouplingError> {
    let mut accelerator = Accelerator::new(coupling.accelerator);
    let mut shapes = wing.strips.shapes(rest);
    let rest_twist = twists(&shapes);
    let mut coupled = Coupled::at(rest.clone(), Loads::none(wing.model.nodes.len()));
    // arms turn with their nodes, so the start has the same arms without force
    coupled.loads.arms.clone_from(&wing.bench.arms);
    for arm in &mut coupled.loads.arms {
        arm.force_n.fill(0.0);
    }
    let mut settings = NewtonSettings {
        increments: structure.load_increments,
        ..NewtonSettings::default()
    };
    let patience = PATIENCE * coupling.max_iterations;
    let mut calmest_deg = f64::INFINITY;
    while coupled.iterations < coupling.max_iterations && coupled.newton_steps < patience {
        progress.check()?;
        coupled.iterations += 1;
        settings.patience = patience - coupled.newton_steps;
        let loads = wing.loads(&shapes)?;
        settings.tolerance = (0.05 * coupled.residual).clamp(1e-9, 0.1);
        if wing.linear {
            coupled.state = equilibrium.solve_linear(rest, &loads)?;
            coupled.newton_steps += 1;
        } else {
            let report =
                equilibrium.solve(&mut coupled.state, &coupled.loads, &loads, &settings, progress)?;
            coupled.newton_steps += report.steps;
        }
        settings.increments = 1;
        let mapped = wing.strips.shapes(&coupled.state);
        let (old, new) = (twists(&shapes), twists(&mapped));
        coupled.twist_change_deg = largest_difference(&old, &new).to_degrees();
        coupled.twist_history_deg.push(
            new.iter()
                .zip(&rest_twist)
                .map(|(t, r)| (t - r).to_degrees())
                .collect(),
        );
        let actual = wing.loads(&mapped)?;
        coupled.residual = residual(wing, equilibrium, &coupled.state, &loads, &actual);
        coupled.loads = loads;
        progress.say(format_args!(
            "fixed point {}: twist changes by {:.1e} deg, residual {:.1e}",
            coupled.iterations, coupled.twist_change_deg, coupled.residual
        ));
        let floor = if wing.linear {
            0.0
        } else {
            2.0 * equilibrium.rounding(&coupled.state, &coupled.loads)
        };
        if coupled.twist_change_deg <= coupling.twist_tolerance_deg
            && coupled.residual <= larger(coupling.residual_tolerance, floor)
        {
            coupled.loads = actual;
            return stable(wing, equilibrium, rest, coupled, Care::Full);
        }
        if !(coupled.twist_change_deg.is_finite() && coupled.residual.is_finite()) {
            break;
        }
        calmest_deg = smaller(calmest_deg, coupled.twist_change_deg);
        if !wing.linear && coupled.iterations >= THROWN.0 && calmest_deg > THROWN.1 {
            break;
        }
        shapes = accelerator.next(&shapes, &mapped);
    }
    patience_lost(wing, equilibrium, rest, coupled, coupling)
}

/// The coupled residual F(u) = internal force − bench loads − air(shape of u), relative to the load.
fn residual(wing: &Wing, equilibrium: &Equilibrium, state: &State, solved: &Loads, actual: &Loads) -> f64 {
    let scale = equilibrium.scale(state, actual);
    if wing.linear {
        // the linear structure stands in equilibrium with `solved` to rounding
        let apart = actual
            .force_n
            .iter()
            .zip(&solved.force_n)
            .map(|(a, b)| (a - b).norm_squared())
            .sum::<f64>();
        return apart.sqrt() / scale.0;
    }
    let residual = wing.model.residual(&equilibrium.pattern, state, actual);
    equilibrium.relative(&residual, scale)
}

/// The solution with what decides its stability.
///
/// # Errors
/// If it stands beyond divergence, is not stable, or the air's load does not change with the shape by finite numbers.
pub(super) fn stable(
    wing: &Wing,
    equilibrium: &mut Equilibrium,
    rest: &State,
    mut coupled: Coupled,
    care: Care,
) -> Result<Coupled, CouplingError> {
    let shapes = wing.strips.shapes(&coupled.state);
    coupled.negative_pivots = if wing.linear {
        equilibrium.factorize(rest, &wing.bench.growing())?
    } else {
        equilibrium.factorize(&coupled.state, &coupled.loads)?
    };
    if care != Care::RoughBetween {
        coupled.critical_ratio = Feedback::new(wing, equilibrium, &shapes)?.critical_ratio()?;
    }
    match coupled.critical_ratio {
        Some(critical_ratio) if critical_ratio <= 1.0 => {
            let linear_film = wing.has_linear_film();
            Err(CouplingError::Diverged {
                critical_ratio,
                linear_film,
            })
        }
        _ if coupled.negative_pivots > 0 => Err(CouplingError::Unstable {
            negative_pivots: coupled.negative_pivots,
        }),
        _ => Ok(coupled),
    }
}

/// A wing on which the iteration does not settle.
#[derive(Debug, Clone, Copy, Default)]
struct Unsettled {
    is_linear: bool,
    film_wrinkles: bool,
    /// Whether most strips stand along the stream.
    is_feathered: bool,
    /// Whether the twist was thrown to and fro to the last: further iterations do not help.
    is_thrown: bool,
}

/// What to try where the iteration does not settle: only what is not in use already.
fn cure(coupling: &Coupling, wing: Unsettled) -> String {
    if wing.film_wrinkles && wing.is_feathered {
        return "Most of the wing stands within 5 deg of the stream, where the air hardly loads the film: it hangs slack, and \
                many shapes are near equilibrium. Try a larger root angle, a film that keeps more in compression \
                (film.residual_compression = 0.01) or carries it (film.compression = \"carries\"), or a coarser mesh \
                (--refine 0.5); they give different twist, so none of them is sure"
            .to_string();
    }
    let others = [
        (design::Accelerator::Newton, "newton"),
        (design::Accelerator::Anderson, "anderson"),
        (design::Accelerator::Aitken, "aitken"),
    ];
    // after Newton's method the fixed point has gone on with Anderson's
    let in_use = |kind| {
        kind == coupling.accelerator
            || (kind == design::Accelerator::Anderson && coupling.accelerator == design::Accelerator::Newton)
            || (kind == design::Accelerator::Newton && wing.is_linear)
    };
    let names: Vec<String> = (others.iter().filter(|(kind, _)| !in_use(*kind)))
        .map(|(_, name)| format!("\"{name}\""))
        .collect();
    let first = if wing.is_thrown {
        "The air throws the wing to and fro, and more iterations do not help. Try"
    } else {
        "Allow more iterations (coupling.max_iterations), try"
    };
    let mut cure = format!(
        "{first} coupling.accelerator = {}, a smaller load",
        names.join(" or ")
    );
    if wing.film_wrinkles {
        cure += ", film.compression = \"carries\" (a film that does not wrinkle)";
    }
    cure + ", or a finer mesh"
}

/// Tells divergence from a mere lack of iterations.
fn patience_lost(
    wing: &Wing,
    equilibrium: &mut Equilibrium,
    rest: &State,
    coupled: Coupled,
    coupling: &Coupling,
) -> Result<Coupled, CouplingError> {
    let (iterations, twist_change_deg, residual) =
        (coupled.iterations, coupled.twist_change_deg, coupled.residual);
    let air = wing.strip_air(&wing.strips.shapes(&coupled.state), false)?;
    let feathered = air
        .iter()
        .filter(|strip| strip.force.alpha.abs() < FEATHERED_RAD)
        .count();
    let unsettled = Unsettled {
        is_linear: wing.linear,
        film_wrinkles: wing.has_film_that_wrinkles(),
        is_feathered: 2 * feathered > air.len(),
        is_thrown: !wing.linear && iterations < coupling.max_iterations && twist_change_deg > THROWN.1,
    };
    match stable(wing, equilibrium, rest, coupled, Care::Full) {
        Err(told @ (CouplingError::Diverged { .. } | CouplingError::NotFinite { .. })) => Err(told),
        _ => Err(CouplingError::OutOfPatience {
            iterations,
            allowed: coupling.max_iterations,
            twist_change_deg,
            residual,
            cure: cure(coupling, unsettled),
        }),
    }
}

/// Twist of each strip's chord vector against the wing plane, rad.
pub(super) fn twists(shapes: &[f64]) -> Vec<f64> {
    shapes
        .chunks_exact(6)
        .map(|shape| shape[2].atan2(shape[1]))
        .collect()
}

/// Largest difference between two lists; not a number if one of them has none.
pub(super) fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    largest(a.iter().zip(b).map(|(a, b)| (a - b).abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn advice_names_no_accelerator_that_is_in_use_and_the_film_only_where_it_wrinkles() {
        let advice = |accelerator, is_linear, film_wrinkles| {
            let coupling = Coupling {
                accelerator,
                ..Coupling::default()
            };
            let wing = Unsettled {
                is_linear,
                film_wrinkles,
                ..Unsettled::default()
            };
            cure(&coupling, wing)
        };
        let newton = advice(design::Accelerator::Newton, false, true);
        assert!(
            newton.contains("accelerator = \"aitken\", a smaller load"),
            "{newton}"
        );
        assert!(newton.contains("film.compression = \"carries\""), "{newton}");
        let anderson = advice(design::Accelerator::Anderson, false, false);
        assert!(anderson.contains("\"newton\" or \"aitken\""), "{anderson}");
        assert!(!anderson.contains("film"), "{anderson}");
        assert!(!advice(design::Accelerator::Aitken, true, false).contains("newton"));
        let feathered = |film_wrinkles| {
            let wing = Unsettled {
                film_wrinkles,
                is_feathered: true,
                ..Unsettled::default()
            };
            cure(&Coupling::default(), wing)
        };
        let thrown = Unsettled {
            is_thrown: true,
            ..Unsettled::default()
        };
        let thrown = cure(&Coupling::default(), thrown);
        assert!(
            !thrown.contains("max_iterations") && thrown.contains("Try coupling"),
            "{thrown}"
        );
        assert!(
            feathered(true).contains("residual_compression"),
            "{}",
            feathered(true)
        );
        assert!(!feathered(false).contains("slack"), "{}", feathered(false));
    }
}
