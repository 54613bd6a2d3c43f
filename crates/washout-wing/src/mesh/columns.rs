//! Columns of a structured mesh: lines from the leading to the trailing edge, spaced so that elements are
//! near-isotropic, with one on every spar and, where there is room, one at every end of a rod piece.

use crate::geometry::{Layout, Planform};

/// A straight mesh line from the leading to the trailing edge, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Column {
    /// Span position of its node on the leading edge.
    pub leading_edge_m: f64,
    /// Span position of its node on the trailing edge.
    pub trailing_edge_m: f64,
    /// Index in the design of the spar that lies on it.
    pub spar: Option<usize>,
}

/// Columns from root to tip.
#[derive(Debug, Clone, PartialEq)]
pub struct Columns {
    /// The columns, root and tip included.
    pub columns: Vec<Column>,
    /// Ends of rod pieces too near to another column for one of their own: the mesh is refined there.
    pub local_breaks_m: Vec<f64>,
}

/// Two columns stand at least this many chordwise element sizes apart: smallest angle atan 0.3 = 17°.
const CLOSEST: f64 = 0.3;

/// An end of a rod piece nearer than this fraction of the wing's length to another column stands on it (0.7 nm on a wing of 70 mm).
const SAME_PLACE: f64 = 1e-8;

/// Lays the columns for `chordwise` elements along each of them.
pub fn lay_columns(planform: &Planform, layout: &Layout, chordwise: usize) -> Columns {
    let mut fixed = ends_and_spars(planform, layout);
    let size = Size { planform, chordwise };
    let mut local_breaks_m = Vec::new();
    for x_m in layout.rod_breaks_m(planform) {
        let bay = fixed
            .partition_point(|column| column.leading_edge_m <= x_m)
            .clamp(1, fixed.len() - 1);
        let (a, b) = (fixed[bay - 1], fixed[bay]);
        let near_m = SAME_PLACE * planform.length_m();
        if (x_m - a.leading_edge_m).abs() <= near_m || (x_m - b.leading_edge_m).abs() <= near_m {
            continue;
        }
        let along = (x_m - a.leading_edge_m) / (b.leading_edge_m - a.leading_edge_m);
        let column = between(a, b, along, Some(x_m), None);
        if size.has_room(a, column) && size.has_room(column, b) {
            fixed.insert(bay, column);
        } else {
            local_breaks_m.push(x_m);
        }
    }
    for x_m in planform.kinks_m() {
        let bay = fixed
            .partition_point(|column| column.trailing_edge_m <= x_m)
            .clamp(1, fixed.len() - 1);
        let (a, b) = (fixed[bay - 1], fixed[bay]);
        let along = (x_m - a.trailing_edge_m) / (b.trailing_edge_m - a.trailing_edge_m);
        let column = between(a, b, along, None, Some(x_m));
        if size.has_room(a, column) && size.has_room(column, b) {
            fixed.insert(bay, column);
        }
    }
    let mut columns = vec![fixed[0]];
    for w in fixed.windows(2) {
        columns.extend(size.fill(w[0], w[1]));
        columns.push(w[1]);
    }
    Columns {
        columns,
        local_breaks_m,
    }
}

/// Columns at the root, on the spars and at the tip.
fn ends_and_spars(planform: &Planform, layout: &Layout) -> Vec<Column> {
    let tip_m = planform.tip_m();
    let straight = |at_m, spar| Column {
        leading_edge_m: at_m,
        trailing_edge_m: at_m,
        spar,
    };
    let mut fixed = vec![straight(0.0, None)];
    for spar in &layout.spars {
        let column = Column {
            leading_edge_m: spar.leading_edge_m,
            trailing_edge_m: spar.trailing_edge_m,
            spar: Some(spar.index),
        };
        if spar.leading_edge_m == 0.0 {
            fixed[0] = column;
        } else {
            fixed.push(column);
        }
    }
    if fixed.last().is_none_or(|last| last.leading_edge_m < tip_m) {
        fixed.push(straight(tip_m, None));
    }
    fixed
}

/// The column at fraction `along` between two; its ends exactly where given, x constant between straight ones.
fn between(a: Column, b: Column, along: f64, leading_m: Option<f64>, trailing_m: Option<f64>) -> Column {
    let is_straight = |c: Column| c.leading_edge_m == c.trailing_edge_m;
    let at = |from: f64, to: f64| from + along * (to - from);
    let leading_edge_m = leading_m.unwrap_or_else(|| at(a.leading_edge_m, b.leading_edge_m));
    let trailing_edge_m = trailing_m.unwrap_or_else(|| at(a.trailing_edge_m, b.trailing_edge_m));
    if is_straight(a) && is_straight(b) {
        let at_m = leading_m.or(trailing_m).unwrap_or(leading_edge_m);
        return Column {
            leading_edge_m: at_m,
            trailing_edge_m: at_m,
            spar: None,
        };
    }
    Column {
        leading_edge_m,
        trailing_edge_m,
        spar: None,
    }
}

/// Element size wanted along the span.
struct Size<'a> {
    planform: &'a Planform,
    chordwise: usize,
}

impl Size<'_> {
    /// Chordwise element size at r, m.
    fn chordwise_m(&self, r_m: f64) -> f64 {
        self.planform.chord_m(r_m) / self.chordwise as f64
    }

    /// Spanwise element size at r, m: isotropic at mid-chord, where mesh lines run at half the slope of the edge.
    fn spanwise_m(&self, r_m: f64) -> f64 {
        let slope = self.planform.chord_and_slope(r_m).1;
        self.chordwise_m(r_m) * (1.0 / (1.0 + 0.5 * slope * slope).sqrt()).max(1.1 * CLOSEST)
    }

    fn has_room(&self, a: Column, b: Column) -> bool {
        let apart = |from_m: f64, to_m: f64| {
            to_m - from_m >= CLOSEST * self.chordwise_m(from_m).min(self.chordwise_m(to_m))
        };
        apart(a.leading_edge_m, b.leading_edge_m) && apart(a.trailing_edge_m, b.trailing_edge_m)
    }

    /// Columns strictly between two, each the same number of wanted sizes from the next.
    fn fill(&self, a: Column, b: Column) -> Vec<Column> {
        const SAMPLES: usize = 256;
        let middle_m = |along: f64| {
            let c = between(a, b, along, None, None);
            0.5 * (c.leading_edge_m + c.trailing_edge_m)
        };
        let length_m = middle_m(1.0) - middle_m(0.0);
        // Number of elements up to each sample.
        let mut count = vec![0.0];
        for sample in 0..SAMPLES {
            let along = (sample as f64 + 0.5) / SAMPLES as f64;
            count.push(count[sample] + length_m / SAMPLES as f64 / self.spanwise_m(middle_m(along)));
        }
        let elements = count[SAMPLES].round().max(1.0);
        (1..elements as usize)
            .map(|k| {
                let wanted = count[SAMPLES] * k as f64 / elements;
                let sample = count.partition_point(|&c| c <= wanted).clamp(1, SAMPLES);
                let part = (wanted - count[sample - 1]) / (count[sample] - count[sample - 1]);
                between(a, b, (sample as f64 - 1.0 + part) / SAMPLES as f64, None, None)
            })
            .collect()
    }
}
