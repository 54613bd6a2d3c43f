//! What is known of the air's feedback from solves before: directions kept for the right-hand sides and Newton steps to come.
//!
//! (I − J) y = s is solved by generalized conjugate residuals (Eisenstat, Elman & Schultz 1983), which keep each direction
//! u with its image c = (I − J) u, the images orthonormal. For another right-hand side at the same J they are a start that
//! leaves little to do (de Sturler 1996). At a J nearby they tell where to look: (I − J)⁻¹ r ≈ r + Σ (u − c) (c·r).

use nalgebra::DVector;

/// Directions that are kept for a J nearby.
const KEPT: usize = 40;

/// Directions, their images, and how the wing moves with them.
#[derive(Debug, Clone, Default)]
pub struct Recycled {
    /// Of this J, in the order in which they were found.
    exact: Vec<Direction>,
    /// Of those before, the newest first: direction and image.
    nearby: Vec<(DVector<f64>, DVector<f64>)>,
}

/// A direction u with its image: (u′ − Σ parts·u of those before) / size.
#[derive(Debug, Clone)]
struct Direction {
    shape: DVector<f64>,
    image: DVector<f64>,
    /// K⁻¹ A u′ by freedom.
    moved: Vec<f64>,
    parts: Vec<f64>,
    size: f64,
}

impl Recycled {
    /// Nothing known.
    pub fn new() -> Self {
        Recycled::default()
    }

    /// Directions of this J.
    pub fn len(&self) -> usize {
        self.exact.len()
    }

    /// Whether nothing is known of this J.
    pub fn is_empty(&self) -> bool {
        self.exact.is_empty()
    }

    /// J has changed a little: what was known of it tells where to look.
    pub fn change(&mut self) {
        let found = self.exact.drain(..).map(|known| (known.shape, known.image));
        self.nearby.splice(0..0, found.rev());
        self.nearby.truncate(KEPT);
    }

    /// Keeps the first `count` directions of this J.
    pub fn truncate(&mut self, count: usize) {
        self.exact.truncate(count);
    }

    /// Weights with which the directions of this J from `first` on take away what they can of `rest`.
    pub(super) fn take_away(&self, first: usize, rest: &mut DVector<f64>) -> Vec<f64> {
        let weigh = |known: &Direction| {
            let weight = known.image.dot(rest);
            rest.axpy(-weight, &known.image, 1.0);
            weight
        };
        self.exact[first..].iter().map(weigh).collect()
    }

    /// Where the solution for `rest` is to be looked for.
    pub(super) fn expected(&self, rest: &DVector<f64>) -> DVector<f64> {
        let (mut left, mut expected) = (rest.clone(), rest.clone());
        for (shape, image) in &self.nearby {
            let weight = image.dot(&left);
            expected += (shape - image) * weight;
            left.axpy(-weight, image, 1.0);
        }
        expected
    }

    /// The last image.
    pub(super) fn last_image(&self) -> Option<&DVector<f64>> {
        self.exact.last().map(|known| &known.image)
    }

    /// Keeps a direction, with its image and how the wing moves; `false` if it holds nothing new.
    pub(super) fn keep(&mut self, mut shape: DVector<f64>, mut image: DVector<f64>, moved: Vec<f64>) -> bool {
        let before = image.norm();
        let mut parts = vec![0.0; self.exact.len()];
        for _ in 0..2 {
            for (part, known) in parts.iter_mut().zip(&self.exact) {
                let weight = known.image.dot(&image);
                image.axpy(-weight, &known.image, 1.0);
                *part += weight;
            }
        }
        let size = image.norm();
        if size <= 1e-13 * before || !size.is_finite() {
            return false;
        }
        for (part, known) in parts.iter().zip(&self.exact) {
            shape.axpy(-part, &known.shape, 1.0);
        }
        self.exact.push(Direction {
            shape: shape / size,
            image: image / size,
            moved,
            parts,
            size,
        });
        true
    }

    /// Adds how the wing moves with the directions weighted.
    pub(super) fn add_moved(&self, mut weights: Vec<f64>, sum: &mut [f64]) {
        for (at, known) in self.exact.iter().enumerate().rev() {
            let own = weights[at] / known.size;
            for (weight, part) in weights.iter_mut().zip(&known.parts) {
                *weight -= own * part;
            }
            if own != 0.0 {
                sum.iter_mut()
                    .zip(&known.moved)
                    .for_each(|(x, moved)| *x += own * moved);
            }
        }
    }
}
