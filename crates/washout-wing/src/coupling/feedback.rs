//! The air's feedback on the structure: its eigenvalues decide stability, its inverse gives sensitivities.
//!
//! With S the shapes that the strips see, K the structure's tangent and A the change of the air's nodal forces with the
//! shapes, the coupled tangent is K − A S. It is singular where the feedback J = S K⁻¹ A, a matrix of six rows a strip,
//! has the eigenvalue 1; and (K − A S)⁻¹ b = K⁻¹ (b + A y) with (I − J) y = S K⁻¹ b (Woodbury).

use std::borrow::Cow;

use faer::diag::DiagMut;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, evd_real, evd_scratch};
use faer::{MatRef, Par, Spec};
use nalgebra::{DMatrix, DVector, Vector3};

use super::error::CouplingError;
use super::recycled::Recycled;
use super::strip_air::StripAir;
use super::wing::Wing;
use crate::structure::finite::each;
use crate::structure::{Equilibrium, refuse_not_finite};

/// Largest number of Krylov vectors.
const KRYLOV: usize = 80;

/// Directions to keep for the right-hand sides to come: the first, which hold most of every answer.
const MOST_KEPT: usize = 64;

/// Residual of a solve, relative to that of no air, where all digits count.
pub const EXACT: f64 = 1e-12;

/// Eigenvalue below which the air does not count as driving the wing toward divergence.
const NEGLIGIBLE: f64 = 1e-2;
/// Steps in a row that must say so.
const CALM: usize = 4;

/// The feedback at a shape whose tangent `equilibrium` has factorized; `air` with derivatives.
#[derive(Debug)]
pub struct Feedback<'a, 'm> {
    wing: &'a Wing,
    equilibrium: &'a mut Equilibrium<'m>,
    air: Cow<'a, [StripAir]>,
}

impl<'a, 'm> Feedback<'a, 'm> {
    /// At the given shapes of the strips.
    ///
    /// # Errors
    /// If the air's force, or its change with the shape, is not finite.
    pub fn new(
        wing: &'a Wing,
        equilibrium: &'a mut Equilibrium<'m>,
        shapes: &[f64],
    ) -> Result<Self, CouplingError> {
        let air = Cow::Owned(wing.strip_air(shapes, true)?);
        Ok(Feedback {
            wing,
            equilibrium,
            air,
        })
    }

    /// With the air on each strip that is known, derivatives included.
    pub fn with_air(wing: &'a Wing, equilibrium: &'a mut Equilibrium<'m>, air: &'a [StripAir]) -> Self {
        Feedback {
            wing,
            equilibrium,
            air: Cow::Borrowed(air),
        }
    }

    /// J y.
    pub fn apply(&mut self, shape_change: &[f64]) -> Vec<f64> {
        let moved = self.moved_by(shape_change);
        self.shapes_at(&moved)
    }

    /// Solves (K − A S) x = b by freedom of the pattern, to a residual of the shapes relative to that of no air, with what is `known`
    /// of this feedback and into it; `None` if the coupled tangent is singular.
    pub fn solve(&mut self, right: &[f64], tolerance: f64, known: &mut Recycled) -> Option<Vec<f64>> {
        let mut x = right.to_vec();
        self.equilibrium.solve_tangent(&mut x, 1);
        if self.air.is_empty() {
            return Some(x);
        }
        let seen = DVector::from_vec(self.shapes_at(&x));
        known.truncate(MOST_KEPT);
        match self.residuals(&seen, tolerance, known) {
            Some(weights) => known.add_moved(weights, &mut x),
            None => {
                let y = self.direct(&seen)?;
                let moved = self.moved_by(&y);
                x.iter_mut().zip(moved).for_each(|(x, moved)| *x += moved);
            }
        }
        Some(x)
    }

    /// (I − J)⁻¹ s by generalized conjugate residuals, as weights of the directions known then.
    fn residuals(&mut self, seen: &DVector<f64>, tolerance: f64, known: &mut Recycled) -> Option<Vec<f64>> {
        let enough = tolerance * seen.norm();
        let mut rest = seen.clone();
        let mut weights = known.take_away(0, &mut rest);
        let mut stands = false;
        for _ in 0..KRYLOV.min(seen.len()) {
            let left = rest.norm();
            if left <= enough {
                return Some(weights);
            }
            // where a direction has not helped, the next of Krylov's space
            let from = known.last_image().filter(|_| stands).unwrap_or(&rest);
            let shape = known.expected(from);
            let moved = self.moved_by(shape.as_slice());
            let image = &shape - DVector::from_vec(self.shapes_at(&moved));
            let first = known.len();
            if !known.keep(shape, image, moved) {
                break;
            }
            weights.extend(known.take_away(first, &mut rest));
            stands = rest.norm() >= 0.9 * left;
        }
        (rest.norm() <= tolerance.max(1e-6) * seen.norm()).then_some(weights)
    }

    /// Critical dynamic pressure over the present one: the inverse of the largest real eigenvalue of J (Arnoldi).
    ///
    /// `None` if there is none within a hundred times that: the air does not drive the wing toward divergence. Exact where the loads are linear in the
    /// shape; an estimate from the present shape elsewhere.
    ///
    /// # Errors
    /// If the feedback is not finite: nothing is known of its stability then.
    pub fn critical_ratio(&mut self) -> Result<Option<f64>, CouplingError> {
        let size = 6 * self.air.len();
        if size == 0 {
            return Ok(None);
        }
        // the response to the present load, and a little of everything so that no direction is left out
        let force = self.wing.air_force(&self.air);
        let moved = self.response(&force);
        let response = DVector::from_vec(self.shapes_at(&moved));
        let everything = DVector::from_fn(size, |i, _| 1e-3 * (1.0 + i as f64).sin());
        let start = &response / response.norm().max(f64::MIN_POSITIVE) + everything;
        let mut basis = vec![start.normalize()];
        let most = KRYLOV.min(size);
        let mut hessenberg = DMatrix::<f64>::zeros(most + 1, most);
        let mut last = f64::NAN;
        let mut calm = 0;
        for k in 0..most {
            let next = self.orthogonal_step(&mut basis, &mut hessenberg, k);
            let column = hessenberg.column(k);
            refuse_not_finite(|| "of the wing", each("the feedback of the air", column.iter()))?;
            // nothing is decided before the eighth
            if next && k < 7 && k + 1 < most {
                continue;
            }
            let largest = largest_real(&hessenberg.view((0, 0), (k + 1, k + 1)).into_owned());
            let settled = (largest - last).abs() <= 1e-7 * largest.abs().max(1e-3);
            // where there is none the largest wanders about zero: enough that it stays far below what counts, and that what the
            // space leaves out is small too
            let leaves = hessenberg[(k + 1, k)];
            calm = if largest < 0.2 * NEGLIGIBLE && leaves < 0.5 * NEGLIGIBLE {
                calm + 1
            } else {
                0
            };
            if !next || (k >= 8 && (settled || calm == CALM)) {
                last = largest;
                break;
            }
            last = largest;
        }
        Ok((last > NEGLIGIBLE).then(|| 1.0 / last))
    }

    /// One step of Arnoldi's method; `false` when the space is exhausted.
    fn orthogonal_step(
        &mut self,
        basis: &mut Vec<DVector<f64>>,
        hessenberg: &mut DMatrix<f64>,
        k: usize,
    ) -> bool {
        let mut next = DVector::from_vec(self.apply(basis[k].as_slice()));
        let before = next.norm();
        for _ in 0..2 {
            for (i, vector) in basis.iter().enumerate() {
                let part = next.dot(vector);
                hessenberg[(i, k)] += part;
                next -= vector * part;
            }
        }
        let size = next.norm();
        hessenberg[(k + 1, k)] = size;
        if size <= 1e-13 * before {
            return false;
        }
        basis.push(next / size);
        true
    }

    /// (I − J)⁻¹ b by the matrix itself: a solve for each of its columns, where the residuals stand.
    fn direct(&mut self, right: &DVector<f64>) -> Option<Vec<f64>> {
        let size = right.len();
        let mut matrix = DMatrix::<f64>::identity(size, size);
        for k in 0..size {
            let unit: Vec<f64> = (0..size).map(|i| f64::from(u8::from(i == k))).collect();
            for (i, answer) in self.apply(&unit).into_iter().enumerate() {
                matrix[(i, k)] -= answer;
            }
        }
        let solution = matrix.clone().lu().solve(right)?;
        let residual = (&matrix * &solution - right).norm();
        (residual <= 1e-9 * right.norm()).then(|| solution.data.into())
    }

    /// K⁻¹ A y by freedom.
    fn moved_by(&mut self, shape_change: &[f64]) -> Vec<f64> {
        let force = self.wing.air_force_change(&self.air, shape_change);
        self.response(&force)
    }

    /// K⁻¹ f by freedom.
    fn response(&mut self, force: &[Vector3<f64>]) -> Vec<f64> {
        let mut moved = self.by_freedom(force);
        self.equilibrium.solve_tangent(&mut moved, 1);
        moved
    }

    /// S x.
    fn shapes_at(&self, moved: &[f64]) -> Vec<f64> {
        let pattern = &self.equilibrium.pattern;
        let displacement: Vec<_> = (0..self.wing.model.nodes.len())
            .map(|node| {
                let at = pattern.freedom(node, 0);
                Vector3::new(moved[at], moved[at + 1], moved[at + 2])
            })
            .collect();
        self.wing.strips.shape_changes(&displacement)
    }

    fn by_freedom(&self, force: &[Vector3<f64>]) -> Vec<f64> {
        let pattern = &self.equilibrium.pattern;
        let mut by_freedom = vec![0.0; pattern.len()];
        for (node, force) in force.iter().enumerate() {
            let at = pattern.freedom(node, 0);
            by_freedom[at..at + 3].copy_from_slice(force.as_slice());
        }
        by_freedom
    }
}

/// Largest eigenvalue that is real; −∞ if none is, or none is found.
///
/// By faer's QR iteration: it ends on every matrix, where that of nalgebra went round on some for ever (it shifts always alike).
fn largest_real(matrix: &DMatrix<f64>) -> f64 {
    let size = matrix.nrows();
    let (no, params) = (ComputeEigenvectors::No, Spec::default());
    let mut memory = MemBuffer::new(evd_scratch::<f64>(size, no, no, Par::Seq, params));
    let (mut re, mut im) = (vec![0.0; size], vec![0.0; size]);
    let found = evd_real(
        MatRef::from_column_major_slice(matrix.as_slice(), size, size),
        DiagMut::from_slice_mut(&mut re),
        DiagMut::from_slice_mut(&mut im),
        None,
        None,
        Par::Seq,
        MemStack::new(&mut memory),
        params,
    );
    if found.is_err() {
        return f64::NEG_INFINITY;
    }
    let is_real = |&(re, im): &(f64, f64)| im.abs() <= 1e-9 * re.hypot(im).max(1e-300);
    let all = re.into_iter().zip(im).filter(is_real);
    all.map(|(re, _)| re).fold(f64::NEG_INFINITY, f64::max)
}

#[cfg(test)]
mod tests {
    use nalgebra::linalg::Schur;

    use super::*;

    /// Columns, down to below the diagonal, of a matrix on which QR steps that always shift alike go round for ever: of a trial
    /// shape that a diagnosis came by.
    #[rustfmt::skip]
    const HELD: [f64; 103] = [
        -0.10460084808280044, 0.014808300723430147, 0.647133640076579, -0.09914498043726029,
        0.0035569533776834425, 2.0919218164542386, -0.31452329826439185, -0.0011527601126244324,
        0.00863136581108768, 0.48720079977627234, -0.11909627143477254, 0.018797691450657912,
        -0.027439947008704727, 0.020812276002089323, 1.1759521609970471, -0.08809487060477059,
        0.02673266389789494, 0.003863805188021848, -0.0404764197155497, 0.012927965046672573,
        -0.08444564545288503, -0.038476690963315005, -0.0036738940913596642, -0.0034340368322962208,
        0.01659648508572336, -0.016097445353089792, 0.00739528541015542, 0.0401754432849566,
        -0.015549981068906014, 0.012713793573344075, -0.01408890414095947, 0.005201765698818894,
        0.012483929650393327, -0.02201849778868625, 0.011646814416559233, -0.38302318144241276,
        -0.0261582564596695, -0.020963722911294523, 0.006400591426430924, 0.0364388462233284,
        -0.013916838827934907, 0.010063222897724263, -0.017592191552720973, 0.003942165989931094,
        -0.3753323134951644, 0.015442977372046227, -0.020899975484329453, 0.0016779993807602088,
        0.0110929515230438, -0.0071634005136270345, 0.001012114530925309, 0.009692599462557195,
        -0.015003766240548645, 0.00888764225116404, -0.05656878395642163, 0.0271579310730408,
        -0.010714581171959562, 0.013554398518431906, -0.006536275457907122, -1.4608455474683453e-5,
        0.0025776912076988187, 0.002328000806994891, 0.00016625944628653237, -0.005348691299483751,
        0.0023378471740751433, -0.1094734985318918, 0.051813820147176205, 0.021052513432740873,
        -0.004010320662224064, -0.01596166617768514, 0.008251585532606081, 0.0009742869066763221,
        -0.011854465841607065, 0.0019019183514685121, 0.0007914996007510931, -0.004741747181876553,
        0.004622208254691737, -0.37252669620724865, 0.08641068800527969, 0.015994996204280115,
        -0.01063777409281328, -0.009252985901178814, 0.013370292432898397, 0.003763822783155886,
        -0.008651811396710599, 0.004104389279553858, -0.0010481853800283264, 0.004377374853500755,
        -0.007013024344050645, 0.002571156797911835, -0.630418098020116, 0.06731049684561166,
        -0.02347388387755968, 0.00851799558071973, 0.008684769936654976, -0.011989885346654794,
        0.0026880379829321848, 0.005809140076136953, -0.0004801123977837162, 0.006898243535228026,
        -0.0029284779813921616, -0.0030303065648828475, -0.008459070073186662,
    ];

    #[test]
    fn the_largest_real_eigenvalue_is_found_also_where_alike_shifts_go_round_for_ever() {
        let mut numbers = HELD.into_iter();
        let mut held = DMatrix::zeros(13, 13);
        for column in 0..13 {
            for row in 0..(column + 2).min(13) {
                held[(row, column)] = numbers.next().expect("a number");
            }
        }
        assert!(Schur::try_new(held.clone(), f64::EPSILON, 10_000).is_none());
        assert!(
            (largest_real(&held) - -0.019824404740230155).abs() < 1e-12,
            "{}",
            largest_real(&held)
        );
        let ring = DMatrix::from_fn(5, 5, |i, j| if i == (j + 1) % 5 { 1.0 } else { 0.0 });
        assert!((largest_real(&ring) - 1.0).abs() < 1e-12);
        let turn = DMatrix::from_row_slice(2, 2, &[0.0, -1.0, 1.0, 0.0]);
        assert_eq!(largest_real(&turn), f64::NEG_INFINITY);
        let upper = DMatrix::from_row_slice(3, 3, &[-4.0, 1.0, 2.0, 0.0, 0.5, 3.0, 0.0, 0.0, -0.1]);
        assert!((largest_real(&upper) - 0.5).abs() < 1e-14);
        assert_eq!(
            largest_real(&DMatrix::from_element(4, 4, f64::NAN)),
            f64::NEG_INFINITY
        );
    }
}
