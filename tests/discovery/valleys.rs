//! An effect that answers to a small strength otherwise than to a large one, so that a fit from zero ends in a wrong valley.

use nalgebra::{DMatrix, DVector};
use washout::diagnose::{Settings, Verdict, diagnose};
use washout::progress::Progress;
use washout::study::draws::Draws;
use washout::study::{Condition, Forward, Linear, Observable, StudyError, Unknown};

use crate::cases::{good_campaign, measure};
use crate::rod::Toy;
use crate::truth::{Hidden, Nature};

const EFFECT: &str = "gravity";
const WRONG: &str = "lift_gain";

/// The toy, in which a strength of u scales acts as (u² − u/10) scales, and as |u|/10 below zero: the derivative at zero points away from
/// large strengths.
struct Bent {
    toy: Toy,
    at: usize,
    scale: f64,
}

impl Bent {
    /// What a strength acts as, and the derivative of that.
    fn acts(&self, strength: f64) -> (f64, f64) {
        let u = strength / self.scale;
        if u > 0.0 {
            (self.scale * (u * u - 0.1 * u), 2.0 * u - 0.1)
        } else {
            (-0.1 * strength, -0.1)
        }
    }

    fn inside(&self, at: &[f64]) -> (Vec<f64>, f64) {
        let mut inside = at.to_vec();
        let (value, slope) = self.acts(at[self.at]);
        inside[self.at] = value;
        (inside, slope)
    }
}

impl Forward for Bent {
    fn unknowns(&self) -> &[Unknown] {
        self.toy.unknowns()
    }
    fn observables(&self) -> &[Observable] {
        self.toy.observables()
    }
    fn conditions(&self) -> &[Condition] {
        self.toy.conditions()
    }
    fn predict(&self, at: &[f64]) -> Result<DVector<f64>, StudyError> {
        self.toy.predict(&self.inside(at).0)
    }
    fn linearize(&self, at: &[f64], wanted: &dyn Fn(&Unknown) -> bool) -> Result<Linear, StudyError> {
        let (inside, slope) = self.inside(at);
        let mut linear = self.toy.linearize(&inside, wanted)?;
        linear.jacobian.column_mut(self.at).scale_mut(slope);
        Ok(linear)
    }
    fn moment_response(&self, at: &[f64], stations: usize) -> Result<DMatrix<f64>, StudyError> {
        self.toy.moment_response(&self.inside(at).0, stations)
    }
}

#[test]
fn an_effect_whose_derivative_at_zero_points_the_wrong_way_is_found_by_finite_steps() {
    let draws = Draws::new(11);
    let mut toy = good_campaign(0.3);
    let at = toy
        .unknowns
        .iter()
        .position(|u| u.name == EFFECT)
        .expect("the effect");
    let scale = toy.unknowns[at].sigma / 1.5;
    let hidden = vec![Hidden::Known(EFFECT, 0.85 * scale)];
    measure(&mut toy, &Nature::drawn(draws, hidden), draws, 1.0);
    let said =
        diagnose(&Bent { toy, at, scale }, &Settings::default(), &Progress::quiet()).expect("a diagnosis");
    println!("{}", said.sentence);
    assert!(
        matches!(said.verdict, Verdict::Effect | Verdict::Set),
        "{}",
        said.sentence
    );
    let row = said
        .effects
        .iter()
        .find(|row| row.effect == EFFECT)
        .expect("a row");
    assert!(row.one_step.unwrap() < 0.0);
    let best = &said.hypotheses[0];
    assert_eq!(best.effects, [EFFECT]);
    let (strength, error) = (
        best.strength.expect("a strength"),
        best.standard_error.expect("an error"),
    );
    assert!(
        (strength - 0.97 * scale).abs() < 3.0 * error,
        "{strength} ± {error} for {}",
        0.97 * scale
    );
}

/// Between two models of one wing the change that an effect makes differs by a tenth and more of itself, smoothly along the span. That is no cause
/// of its own: the effect is in whatever explains the readings, and no cause without a name stands before it.
#[test]
fn an_effect_whose_formula_is_off_by_an_eighth_of_itself_is_in_every_explanation() {
    let draws = Draws::new(17);
    let mut toy = good_campaign(0.2);
    let at = toy
        .unknowns
        .iter()
        .position(|u| u.name == WRONG)
        .expect("the effect");
    let scale = toy.unknowns[at].sigma / 1.5;
    let none: Vec<f64> = toy.unknowns.iter().map(|u| u.mean).collect();
    let mut with = none.clone();
    with[at] = 2.0 * scale;
    let change = toy.predict(&with).expect("a twist") - toy.predict(&none).expect("a twist");
    let hidden = vec![Hidden::Known(WRONG, 2.0 * scale)];
    measure(&mut toy, &Nature::drawn(draws, hidden), draws, 1.0);
    let lengths: Vec<f64> = toy.conditions.iter().map(|own| 1e3 * own.length_m).collect();
    for (row, own) in toy.observables.iter_mut().enumerate() {
        let along = own.r_mm.expect("a station") / lengths[own.condition];
        own.value += 0.125 * change[row] * (7.0 * along).cos();
    }
    let said = diagnose(&toy, &Settings::default(), &Progress::quiet()).expect("a diagnosis");
    println!("{}", said.sentence);
    let with_it = said
        .hypotheses
        .iter()
        .filter(|own| own.effects.iter().any(|name| name == WRONG));
    let probability: f64 = with_it.map(|own| own.probability).sum();
    assert!(probability > 0.95, "{probability}: {}", said.sentence);
    assert!(
        matches!(said.verdict, Verdict::Effect | Verdict::Set),
        "{}",
        said.sentence
    );
}
