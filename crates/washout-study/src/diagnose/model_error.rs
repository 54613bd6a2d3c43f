//! The error that is expected between measurement and model, in one place.
//!
//! y = f(x, ψ) + b + δ + ε (f(x, ψ) − f(x, 0)) + e: what the mesh leaves b, an error of the formulation δ, an error of the effect's own
//! formula ε, and the scatter of the readings e (Kennedy & O'Hagan, J. R. Stat. Soc. B 63 (2001) 425, with a discrepancy that has a size
//! and a shape, so that it cannot take up what is missing). The share of formulation error and the scale of the scatter are not known:
//! evidences are sums over both ([`Size`]).
//!
//! The correlations were read off two models of one wing that share no code (geometrically exact beams with strain triangles against
//! shells): calibrated, they differ by 0.06 to 0.24° rms of 5 to 24° of twist, alike in all conditions of a wing.

use nalgebra::{DMatrix, DVector};

use crate::input::measurement::Channel;
use crate::study::{Forward, MeshError};

use super::data::Data;

/// How a smooth error goes together: length along the span over that of the wing, correlation between conditions of one wing, and
/// between wings.
#[derive(Debug, Clone, Copy)]
struct Kernel {
    length: f64,
    conditions: f64,
    wings: f64,
}

/// Error of the formulation: half a bay long, alike in all conditions of a wing.
const FORMULATION: Kernel = Kernel {
    length: 0.12,
    conditions: 0.9,
    wings: 0.3,
};
/// What the mesh leaves, and what two models differ by where the mesh decides: within a bay.
const MESH: Kernel = Kernel {
    length: 0.06,
    conditions: 0.95,
    wings: 0.3,
};
/// How far about a station what two meshes differ by counts, over the length of the wing: at one station the difference may vanish by chance.
const ABOUT: f64 = 0.1;
/// Error of an effect's own formula.
const OWN: Kernel = Kernel {
    length: 0.15,
    conditions: 0.9,
    wings: 0.5,
};
/// The same of an effect whose formula is known badly, for it acts through the film: within a bay, and much alike on all wings, whose spars are
/// the same. Read off three tensions of the film in two models of three wings.
const OWN_IN_FILM: Kernel = Kernel {
    length: 0.05,
    conditions: 0.95,
    wings: 0.7,
};
/// The share of a change by which it is wrong at most; assumed.
const WORST: f64 = 0.7;
/// Own errors from which on an effect counts as acting through the film.
const BADLY_KNOWN: f64 = 0.2;
/// Causes without a name: how far they reach along the span, and how they go together between conditions of one wing and between wings: a
/// cause that is always there, and one that comes and goes.
const UNKNOWN_LENGTHS: [f64; 3] = [0.15, 0.3, 0.6];
const UNKNOWN_TOGETHER: [[f64; 2]; 2] = [[0.97, 0.6], [0.8, 0.3]];
/// Sizes of a cause without a name, over the root mean square of the readings of its channel.
const UNKNOWN_SIZES: [f64; 3] = [0.12, 0.36, 1.0];
/// A reading near zero has the formulation error of one of this share of the root mean square of its channel.
const FLOOR: f64 = 0.25;
/// Where an effect moves a reading less than its neighbours, its own error is that of this share of the root mean square of its condition.
const OWN_FLOOR: f64 = 0.5;
/// Shares of formulation error that are summed over, for a typical one of 1, with the median and the spread (ln) of their prior.
const SHARES: [f64; 6] = [0.4, 0.7, 1.2, 2.0, 3.5, 6.0];
const MEDIAN_SHARE: f64 = 1.3;
const SHARE_SPREAD: f64 = 0.7;
/// Scales of the scatter that are summed over, if it is not known.
const SCALES: [f64; 6] = [0.6, 0.75, 1.0, 1.33, 1.8, 2.4];

/// How badly the formula of an effect is known, over what its card says: log-normal with a median of 1 and a spread (ln) of 0.7, assumed:
/// the changes of most effects differ by 4 to 15 % between two models of a wing, where their cards say 5 %.
pub const OWN_SIZES: [OwnSize; 3] = [
    OwnSize {
        factor: 0.6,
        ln_prior: -0.98,
    },
    OwnSize {
        factor: 1.3,
        ln_prior: -0.78,
    },
    OwnSize {
        factor: 2.8,
        ln_prior: -1.79,
    },
];

/// One size of the error of an effect's own formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OwnSize {
    /// Over what the card of the effect says.
    pub factor: f64,
    /// Logarithm of its prior probability.
    pub ln_prior: f64,
}

impl OwnSize {
    /// A formula that is exact.
    pub const EXACT: OwnSize = OwnSize {
        factor: 0.0,
        ln_prior: 0.0,
    };
}

/// One size of the errors that are not known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Size {
    /// Share of formulation error.
    pub share: f64,
    /// Factor on the stated standard deviations of the readings.
    pub scale: f64,
    /// Logarithm of its prior probability.
    pub ln_prior: f64,
}

/// What a diagnosis expects between measurement and model, about one fit.
#[derive(Debug, Clone)]
pub struct ModelError {
    /// Stated variances, outliers widened.
    stated: DVector<f64>,
    /// What the uncertain inputs of the model move.
    inputs: DMatrix<f64>,
    /// What the mesh leaves.
    mesh: Option<DMatrix<f64>>,
    /// Its standard deviation over what the model reads.
    mesh_share: DVector<f64>,
    /// Formulation error for a share of 1.
    formulation: DMatrix<f64>,
    /// Of the rows: channel, condition, wing, place.
    places: Vec<Place>,
    /// Root mean square of the readings of each row's channel.
    typical: DVector<f64>,
    /// What the model reads, those near zero as a share of what is typical.
    local: DVector<f64>,
    /// The same with its sign.
    read: DVector<f64>,
    /// How errors of effects' own formulas go together, those of effects that act through the film, and what the mesh leaves.
    own: DMatrix<f64>,
    own_in_film: DMatrix<f64>,
    of_mesh: DMatrix<f64>,
}

/// Where a reading was taken.
#[derive(Debug, Clone, PartialEq)]
struct Place {
    channel: Channel,
    condition: usize,
    wing: String,
    /// Over the length of the wing; none for what has no place.
    along: Option<f64>,
}

impl Kernel {
    /// How a smooth error goes together at these places.
    fn correlation(&self, places: &[Place]) -> DMatrix<f64> {
        DMatrix::from_fn(places.len(), places.len(), |i, j| {
            let (a, b) = (&places[i], &places[j]);
            if a.channel != b.channel {
                return 0.0;
            }
            let between = match (a.condition == b.condition, a.wing == b.wing) {
                (true, _) => 1.0,
                (false, true) => self.conditions,
                (false, false) => self.wings,
            };
            let along = match (a.along, b.along) {
                (Some(x), Some(y)) => (-0.5 * ((x - y) / self.length).powi(2)).exp(),
                _ => 1.0,
            };
            between * along
        })
    }
}

/// Covariance of errors of these sizes that go together so.
fn sized(correlation: &DMatrix<f64>, size: &DVector<f64>) -> DMatrix<f64> {
    let mut covariance = correlation.clone();
    for (mut column, of_column) in covariance.column_iter_mut().zip(size.iter()) {
        for (own, of_row) in column.iter_mut().zip(size.iter()) {
            *own *= of_row * of_column;
        }
    }
    covariance
}

impl Size {
    /// The median of the prior, for a typical share of `discrepancy`.
    pub fn typical(discrepancy: f64, scale: Option<f64>) -> Size {
        Size {
            share: MEDIAN_SHARE * discrepancy,
            scale: scale.unwrap_or(1.0),
            ln_prior: 0.0,
        }
    }
}

impl ModelError {
    /// About predictions `value` of all observables; `widening`: factors on the stated deviations of the fitted ones; `slopes`: their
    /// derivatives with the uncertain inputs, per prior standard deviation.
    pub fn new(
        forward: &dyn Forward,
        data: &Data,
        value: &DVector<f64>,
        widening: &[f64],
        slopes: &DMatrix<f64>,
    ) -> ModelError {
        let (observables, conditions) = (forward.observables(), forward.conditions());
        let place = |&row: &usize| {
            let own = &observables[row];
            let condition = &conditions[own.condition];
            let middle = |inner: f64| 0.5 * (inner + own.r_to_mm.unwrap_or(inner));
            Place {
                channel: own.channel,
                condition: own.condition,
                wing: condition.wing.clone(),
                along: own.r_mm.map(|inner| middle(inner) / (1e3 * condition.length_m)),
            }
        };
        let places: Vec<Place> = data.rows.iter().map(place).collect();
        let rows = &data.rows;
        let typical = DVector::from_fn(rows.len(), |i, _| {
            let own = (0..rows.len()).filter(|&j| places[j].channel == places[i].channel);
            let squares: Vec<f64> = own.map(|j| value[rows[j]].powi(2)).collect();
            (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
        });
        let local = DVector::from_fn(rows.len(), |i, _| value[rows[i]].abs().max(FLOOR * typical[i]));
        let stated = rows.iter().zip(widening);
        let stated = stated.map(|(&row, wider)| (observables[row].sigma * wider).powi(2));
        let mut error = ModelError {
            stated: DVector::from_iterator(rows.len(), stated),
            inputs: slopes * slopes.transpose(),
            mesh: None,
            mesh_share: DVector::zeros(rows.len()),
            formulation: DMatrix::zeros(0, 0),
            typical,
            read: DVector::from_fn(rows.len(), |i, _| local[i].copysign(value[rows[i]])),
            local,
            own: OWN.correlation(&places),
            own_in_film: OWN_IN_FILM.correlation(&places),
            of_mesh: MESH.correlation(&places),
            places,
        };
        error.formulation = sized(&FORMULATION.correlation(&error.places), &error.local);
        if let Some(MeshError { deviation, .. }) = forward.mesh_error() {
            let left = DVector::from_iterator(rows.len(), rows.iter().map(|&row| deviation[row]));
            let about = error.about(&left);
            error.mesh_share = about.zip_map(
                &error.local,
                |left, read| if read > 0.0 { left / read } else { 0.0 },
            );
            error.mesh = Some(sized(&error.of_mesh, &about));
        }
        error
    }

    /// Root mean square of `each` about every row: along the span, within its condition and channel.
    fn about(&self, each: &DVector<f64>) -> DVector<f64> {
        let count = self.places.len();
        DVector::from_fn(count, |i, _| {
            let (mut sum, mut weights) = (0.0, 0.0);
            for j in 0..count {
                let (a, b) = (&self.places[i], &self.places[j]);
                if a.channel != b.channel || a.condition != b.condition {
                    continue;
                }
                let weight = match (a.along, b.along) {
                    (Some(x), Some(y)) => (-0.5 * ((x - y) / ABOUT).powi(2)).exp(),
                    _ => 1.0,
                };
                sum += weight * each[j].powi(2);
                weights += weight;
            }
            (sum / weights).sqrt()
        })
    }

    /// The sizes that are summed over: shares for a typical one of `discrepancy`; `scale`: that of the scatter, if it is known; `trust`: how many
    /// numbers the statement of the scatter is worth.
    pub fn sizes(discrepancy: f64, scale: Option<f64>, trust: usize) -> Vec<Size> {
        let spread = (2.0 * trust as f64).sqrt().recip();
        let scales: Vec<(f64, f64)> = match scale {
            Some(known) => vec![(known, 0.0)],
            None => SCALES
                .iter()
                .map(|&scale| (scale, -0.5 * (scale.ln() / spread).powi(2)))
                .collect(),
        };
        let mut sizes: Vec<Size> = Vec::new();
        for share in SHARES {
            let off = (share / MEDIAN_SHARE).ln() / SHARE_SPREAD;
            for &(scale, ln_scale) in &scales {
                sizes.push(Size {
                    share: share * discrepancy,
                    scale,
                    ln_prior: ln_scale - 0.5 * off * off,
                });
            }
        }
        let whole: f64 = sizes.iter().map(|size| size.ln_prior.exp()).sum();
        for size in &mut sizes {
            size.ln_prior -= whole.ln();
        }
        sizes
    }

    /// Covariance of scatter, mesh and formulation: what a fit of the uncertain inputs weighs the readings by.
    pub fn of_readings(&self, size: &Size) -> DMatrix<f64> {
        let mut covariance = &self.formulation * size.share.powi(2);
        if let Some(mesh) = &self.mesh {
            covariance += mesh;
        }
        for (i, stated) in self.stated.iter().enumerate() {
            covariance[(i, i)] += stated * size.scale.powi(2);
        }
        covariance
    }

    /// Covariance of everything.
    pub fn of_all(&self, size: &Size) -> DMatrix<f64> {
        self.of_readings(size) + &self.inputs
    }

    /// What two changes make besides their sum, if one scales what the other makes.
    pub fn product(&self, a: &DVector<f64>, b: &DVector<f64>) -> DVector<f64> {
        let of = |i: usize| match self.read[i] {
            0.0 => 0.0,
            read => a[i] * b[i] / read,
        };
        DVector::from_fn(a.len(), |i, _| of(i))
    }

    /// Error of taking two changes to add: what one scales, the other changes in proportion.
    pub fn interplay(&self, a: &DVector<f64>, b: &DVector<f64>) -> DMatrix<f64> {
        sized(&self.own, &self.product(a, b))
    }

    /// Error of an effect's own formula, whose card says that it is known to `share` of the `change` that it makes, and which is known so many
    /// times worse (`factor`); where the mesh decides, the change is as uncertain as the reading.
    pub fn own(&self, change: &DVector<f64>, share: f64, factor: f64) -> DMatrix<f64> {
        let (size, worst) = (self.places.len(), (share * factor).min(WORST));
        let mean_square = |condition: usize, channel: Channel| {
            let is_its =
                |i: &usize| self.places[*i].condition == condition && self.places[*i].channel == channel;
            let squares: Vec<f64> = (0..size).filter(is_its).map(|i| change[i].powi(2)).collect();
            squares.iter().sum::<f64>() / squares.len() as f64
        };
        let local = DVector::from_fn(size, |i, _| {
            let own = &self.places[i];
            let typical = OWN_FLOOR * OWN_FLOOR * mean_square(own.condition, own.channel);
            worst * (change[i].powi(2) + typical).sqrt()
        });
        let together = if share > BADLY_KNOWN {
            &self.own_in_film
        } else {
            &self.own
        };
        sized(together, &local) + sized(&self.of_mesh, &change.component_mul(&self.mesh_share))
    }

    /// Covariances of causes without a name: in all channels, and in each alone.
    pub fn unknown(&self) -> Vec<DMatrix<f64>> {
        let mut channels: Vec<Channel> = self.places.iter().map(|place| place.channel).collect();
        channels.sort_unstable();
        channels.dedup();
        let alone = channels.iter().filter(|_| channels.len() > 1).copied().map(Some);
        let mut fields = Vec::new();
        for channel in [None].into_iter().chain(alone) {
            let typical = DVector::from_fn(self.places.len(), |i, _| match channel {
                Some(channel) if self.places[i].channel != channel => 0.0,
                _ => self.typical[i],
            });
            for length in UNKNOWN_LENGTHS {
                for [conditions, wings] in UNKNOWN_TOGETHER {
                    let kernel = Kernel {
                        length,
                        conditions,
                        wings,
                    };
                    let together = kernel.correlation(&self.places);
                    fields.extend(UNKNOWN_SIZES.map(|size| sized(&together, &(&typical * size))));
                }
            }
        }
        fields
    }
}
