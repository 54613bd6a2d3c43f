//! How near the solver came: error on each mesh, observed order, verdict.

use super::case::{Answer, Case, Confidence, Level, Order, Quantity, Scale};

/// How far an observed order may be from that of theory.
pub const ORDER_TOLERANCE: f64 = 0.2;

/// Change from the middle to the fine mesh, relative, below which there is no order to observe.
const NO_CHANGE: f64 = 1e-7;

/// A case on the meshes that were run.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The case.
    pub case: &'static Case,
    /// The meshes that gave an answer, coarse first.
    pub meshes: Vec<Meshed>,
    /// One per quantity, in their order; empty if a mesh gave no answer.
    pub judged: Vec<Judged>,
    /// Why a mesh gave no answer.
    pub failure: Option<String>,
}

/// One mesh of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Meshed {
    /// Which.
    pub level: Level,
    /// In words.
    pub mesh: String,
    /// Time on one core, s.
    pub time_s: f64,
}

/// A quantity on the meshes that were run.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// The reference where the error of the finest mesh is largest.
    pub reference: f64,
    /// Ours there.
    pub ours: f64,
    /// Number of points: 1 for a single value.
    pub points: usize,
    /// Largest error on each mesh, relative.
    pub errors: Vec<f64>,
    /// Order from the changes between three meshes; none if they do not shrink steadily or are nothing.
    pub order: Option<f64>,
    /// Whether it passes.
    pub verdict: Verdict,
}

/// Whether a quantity passes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Within tolerance on the finest mesh, and of the expected order if three meshes were run.
    Pass,
    /// Too far off on the finest mesh.
    ErrorFails,
    /// Near enough, but not of the expected order.
    OrderFails,
    /// Its reference is from memory: shown, not judged.
    Excluded,
}

impl Outcome {
    /// Judges the answers of one case, coarse first.
    pub fn new(case: &'static Case, answers: Vec<(Meshed, Answer)>) -> Self {
        let judged = (case.quantities.iter().enumerate())
            .map(|(at, quantity)| {
                let values: Vec<&[f64]> = answers
                    .iter()
                    .map(|(_, answer)| answer.values.get(at).map_or(&[][..], Vec::as_slice))
                    .collect();
                judge(quantity, &values)
            })
            .collect();
        Outcome {
            case,
            meshes: answers.into_iter().map(|(meshed, _)| meshed).collect(),
            judged,
            failure: None,
        }
    }

    /// Whether no quantity fails.
    pub fn passes(&self) -> bool {
        let fails = |judged: &Judged| matches!(judged.verdict, Verdict::ErrorFails | Verdict::OrderFails);
        self.failure.is_none() && !self.judged.iter().any(fails)
    }
}

/// Judges the values of one quantity, coarse mesh first.
fn judge(quantity: &Quantity, values: &[&[f64]]) -> Judged {
    let reference = (quantity.reference)();
    let errors: Vec<(usize, f64)> = values
        .iter()
        .map(|ours| worst(ours, &reference, quantity.scale))
        .collect();
    let &(at, error) = errors.last().unwrap_or(&(0, f64::INFINITY));
    let order = observed_order(values);
    let settled = changes(values).is_some_and(|[_, last]| last < NO_CHANGE);
    let order_holds = match quantity.order {
        Order::Exempt(_) => true,
        Order::Theory(_) if values.len() < 3 || settled => true,
        Order::Theory(theory) => order.is_some_and(|order| (order - theory).abs() <= ORDER_TOLERANCE),
    };
    let verdict = match (quantity.confidence, error <= quantity.tolerance, order_holds) {
        (Confidence::Memory, ..) => Verdict::Excluded,
        (_, false, _) => Verdict::ErrorFails,
        (_, true, false) => Verdict::OrderFails,
        (_, true, true) => Verdict::Pass,
    };
    let value = |list: &[f64]| list.get(at).copied().unwrap_or(f64::NAN);
    Judged {
        reference: value(&reference),
        ours: value(values.last().copied().unwrap_or_default()),
        points: reference.len(),
        errors: errors.into_iter().map(|(_, error)| error).collect(),
        order,
        verdict,
    }
}

/// Errors (relative) that differ by less are equal: rounding must not choose the point of a curve that is shown.
const ROUNDING: f64 = 1e-9;

/// Place and size of the largest error, relative, the last of equals; infinite if the values are not as many as
/// the references, or one of either is no number.
fn worst(ours: &[f64], reference: &[f64], scale: Scale) -> (usize, f64) {
    let mut all = ours.iter().chain(reference);
    if ours.len() != reference.len() || all.any(|value| !value.is_finite()) {
        return (0, f64::INFINITY);
    }
    let largest = reference.iter().fold(0.0_f64, |m, r| m.max(r.abs()));
    let error = |(ours, reference): (&f64, &f64)| {
        let unit = match scale {
            Scale::Own => reference.abs(),
            Scale::Largest => largest,
        };
        (ours - reference).abs() / unit
    };
    let errors = ours.iter().zip(reference).map(error).enumerate();
    errors.fold((0, 0.0), |most, this| {
        let at = if this.1 > most.1 - ROUNDING {
            this.0
        } else {
            most.0
        };
        (at, most.1.max(this.1))
    })
}

/// Changes from coarse to middle and from middle to fine over the size of the fine values (root of the sum of squares).
fn changes(values: &[&[f64]]) -> Option<[f64; 2]> {
    let [coarse, middle, fine] = values else {
        return None;
    };
    let size = fine.iter().map(|v| v * v).sum::<f64>().sqrt();
    let change = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (b - a).powi(2)).sum::<f64>().sqrt();
    Some([change(coarse, middle) / size, change(middle, fine) / size])
}

/// log₂ of the ratio of the changes; a single value must move the same way twice.
fn observed_order(values: &[&[f64]]) -> Option<f64> {
    let [first, last] = changes(values)?;
    if let [[a], [b], [c]] = values
        && (b - a) * (c - b) < 0.0
    {
        return None;
    }
    let order = (first / last).log2();
    (last >= NO_CHANGE && order.is_finite() && order > 0.0).then_some(order)
}

#[cfg(test)]
mod tests {
    use super::*;

    const BASE: Quantity = Quantity {
        reference: || vec![2.0],
        tolerance: 0.011,
        order: Order::Theory(2.0),
        ..Quantity::BLANK
    };

    #[test]
    fn a_value_of_second_order_within_tolerance_passes() {
        let judged = judge(&BASE, &[&[2.32], &[2.08], &[2.02]]);
        assert_eq!(judged.verdict, Verdict::Pass);
        assert!((judged.order.unwrap() - 2.0).abs() < 1e-9);
        assert!((judged.errors[0] - 0.16).abs() < 1e-9 && (judged.errors[2] - 0.01).abs() < 1e-9);
    }

    #[test]
    fn a_reference_that_is_no_number_fails() {
        let none = Quantity {
            reference: || vec![f64::NAN],
            ..BASE
        };
        let judged = judge(&none, &[&[2.32], &[2.08], &[2.02]]);
        assert_eq!(judged.verdict, Verdict::ErrorFails);
    }

    #[test]
    fn an_error_or_an_order_that_misses_fails() {
        assert_eq!(
            judge(&BASE, &[&[2.32], &[2.08], &[2.03]]).verdict,
            Verdict::ErrorFails
        );
        assert_eq!(
            judge(&BASE, &[&[2.04], &[2.02], &[2.01]]).verdict,
            Verdict::OrderFails
        );
        assert_eq!(
            judge(&BASE, &[&[2.04], &[1.98], &[2.0]]).verdict,
            Verdict::OrderFails
        );
        assert_eq!(
            judge(&BASE, &[&[2.0], &[2.0], &[f64::NAN]]).verdict,
            Verdict::ErrorFails
        );
        assert_eq!(judge(&BASE, &[&[]]).verdict, Verdict::ErrorFails);
    }

    #[test]
    fn what_needs_no_mesh_and_the_short_version_have_no_order() {
        assert_eq!(judge(&BASE, &[&[2.0], &[2.0], &[2.0]]).verdict, Verdict::Pass);
        let short = judge(&BASE, &[&[2.01]]);
        assert_eq!((short.verdict, short.order), (Verdict::Pass, None));
    }

    #[test]
    fn a_reference_from_memory_is_never_a_mark() {
        let quantity = Quantity {
            confidence: Confidence::Memory,
            ..BASE
        };
        assert_eq!(judge(&quantity, &[&[9.0]]).verdict, Verdict::Excluded);
        assert_eq!(judge(&quantity, &[&[2.0]]).verdict, Verdict::Excluded);
    }

    #[test]
    fn a_curve_is_judged_where_it_is_worst() {
        let curve = Quantity {
            reference: || vec![1.0, 10.0],
            ..BASE
        };
        let judged = judge(&curve, &[&[1.005, 10.2]]);
        assert_eq!((judged.reference, judged.ours, judged.points), (10.0, 10.2, 2));
        assert!((judged.errors[0] - 0.02).abs() < 1e-12);
        let largest = Quantity {
            scale: Scale::Largest,
            ..curve
        };
        assert!((judge(&largest, &[&[1.1, 10.0]]).errors[0] - 0.01).abs() < 1e-12);
    }

    #[test]
    fn rounding_does_not_choose_the_point_that_is_shown() {
        let curve = Quantity {
            reference: || vec![0.25, 0.5],
            ..BASE
        };
        assert_eq!(judge(&curve, &[&[0.25, 0.5 + 1e-13]]).ours, 0.5 + 1e-13);
        assert_eq!(judge(&curve, &[&[0.25 - 1e-13, 0.5]]).ours, 0.5);
    }
}
