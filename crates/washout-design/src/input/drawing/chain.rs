//! Open lines whose ends meet, joined to closed ones.

/// The lines of a drawing.
pub(super) struct Lines {
    /// Those that are closed, mm, x to the right and y upward.
    pub closed: Vec<Vec<[f64; 2]>>,
    /// What a unit of the drawing was taken for, in words.
    pub unit: String,
    /// What of the drawing was not read: its kind, and how many.
    pub left_out: Vec<(String, usize)>,
}

/// Distance of two ends that are one point, over the size of the drawing.
const TOUCH: f64 = 1e-3;

/// Closed lines out of open ones, each the points of one piece in order, and the number of chains that stay open.
pub(super) fn closed(mut open: Vec<Vec<[f64; 2]>>) -> (Vec<Vec<[f64; 2]>>, usize) {
    open.retain(|line| line.len() > 1);
    let touch = TOUCH * size(&open);
    let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) <= touch;
    let (mut found, mut stay_open) = (Vec::new(), 0);
    while let Some(mut chain) = open.pop() {
        loop {
            let (first, last) = (chain[0], chain[chain.len() - 1]);
            if chain.len() > 2 && near(first, last) {
                chain.pop();
                found.push(chain);
                break;
            }
            let next = open
                .iter()
                .position(|line| near(line[0], last) || near(line[line.len() - 1], last));
            let Some(next) = next else {
                stay_open += 1;
                break;
            };
            let mut line = open.swap_remove(next);
            if !near(line[0], last) {
                line.reverse();
            }
            chain.extend_from_slice(&line[1..]);
        }
    }
    (found, stay_open)
}

/// The larger side of the box around all points.
fn size(lines: &[Vec<[f64; 2]>]) -> f64 {
    let extent = |axis: usize| {
        let values = lines.iter().flatten().map(|point| point[axis]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        (high - low).max(0.0)
    };
    extent(0).max(extent(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_in_any_order_and_direction_close_and_what_does_not_is_left() {
        let open = vec![
            vec![[0.0, 0.0], [4.0, 0.0]],
            vec![[4.0, 3.0], [4.0, 0.0]],
            vec![[9.0, 9.0], [8.0, 8.0]],
            vec![[0.0, 0.0], [2.0, 2.0], [4.0, 3.001]],
        ];
        let (found, stay_open) = closed(open);
        assert_eq!((found.len(), stay_open), (1, 1));
        assert_eq!(found[0].len(), 4);
    }
}
