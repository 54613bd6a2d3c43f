//! Dominance, fronts and hypervolume; every objective is to be as small as possible.

/// Whether `a` is at least as good as `b` in everything and better in something.
pub fn dominates(a: &[f64], b: &[f64]) -> bool {
    let mut is_better = false;
    for (x, y) in a.iter().zip(b) {
        if x > y {
            return false;
        }
        is_better |= x < y;
    }
    is_better
}

/// Whether any of `others` dominates the point.
pub fn is_dominated(point: &[f64], others: &[Vec<f64>]) -> bool {
    others.iter().any(|other| dominates(other, point))
}

/// Indices of the points that no other dominates, of equal ones the first.
///
/// # Example
/// ```
/// # use washout_study as washout;
/// use washout::explore::non_dominated;
///
/// // less is better in both: the last is worse than the first
/// let points = [vec![1.0, 3.0], vec![2.0, 1.0], vec![2.0, 4.0]];
/// let mut front = non_dominated(&points);
/// front.sort_unstable();
/// assert_eq!(front, [0, 1]);
/// ```
pub fn non_dominated(points: &[Vec<f64>]) -> Vec<usize> {
    if points.first().is_some_and(|point| point.len() == 2) {
        return non_dominated_pairs(points);
    }
    (0..points.len())
        .filter(|&i| {
            !is_dominated(&points[i], points) && !points[..i].iter().any(|earlier| earlier == &points[i])
        })
        .collect()
}

/// The same by sorting, for two objectives.
fn non_dominated_pairs(points: &[Vec<f64>]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&i, &j| {
        let (a, b) = (&points[i], &points[j]);
        a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(i.cmp(&j))
    });
    let mut lowest = f64::INFINITY;
    order.retain(|&i| {
        let is_lower = points[i][1] < lowest;
        lowest = lowest.min(points[i][1]);
        is_lower
    });
    order
}

/// Area that the points dominate up to a reference point, for two objectives; points beyond it count for nothing.
///
/// # Example
/// ```
/// # use washout_study as washout;
/// use washout::explore::hypervolume;
///
/// assert_eq!(hypervolume(&[[1.0, 3.0], [2.0, 1.0]], [4.0, 4.0]), 7.0);
/// ```
pub fn hypervolume(points: &[[f64; 2]], reference: [f64; 2]) -> f64 {
    let inside: Vec<Vec<f64>> = points
        .iter()
        .filter(|p| p[0] < reference[0] && p[1] < reference[1])
        .map(|p| p.to_vec())
        .collect();
    let front = non_dominated_pairs(&inside);
    let mut area = 0.0;
    for (place, &index) in front.iter().enumerate() {
        let until = front.get(place + 1).map_or(reference[0], |&next| inside[next][0]);
        area += (until - inside[index][0]) * (reference[1] - inside[index][1]);
    }
    area
}

/// Fronts of points by rank: 0 is not dominated, 1 only by rank 0, and so on. A point that breaks a constraint (`violation`
/// above 0) is dominated by each that breaks it less (Deb 2000).
pub(super) fn ranks(points: &[(&[f64], f64)]) -> Vec<usize> {
    let beats = |i: usize, j: usize| {
        let ((a, broken_a), (b, broken_b)) = (points[i], points[j]);
        if broken_a > 0.0 || broken_b > 0.0 {
            return broken_a < broken_b;
        }
        dominates(a, b)
    };
    let count = points.len();
    let mut beaten_by = vec![0_usize; count];
    let mut beaten: Vec<Vec<usize>> = vec![Vec::new(); count];
    for i in 0..count {
        for j in (i + 1)..count {
            if beats(i, j) {
                beaten[i].push(j);
                beaten_by[j] += 1;
            } else if beats(j, i) {
                beaten[j].push(i);
                beaten_by[i] += 1;
            }
        }
    }
    let mut rank = vec![0; count];
    let mut now: Vec<usize> = (0..count).filter(|&i| beaten_by[i] == 0).collect();
    let mut level = 0;
    while !now.is_empty() {
        let mut next = Vec::new();
        for &i in &now {
            rank[i] = level;
            for &j in &beaten[i] {
                beaten_by[j] -= 1;
                if beaten_by[j] == 0 {
                    next.push(j);
                }
            }
        }
        next.sort_unstable();
        (now, level) = (next, level + 1);
    }
    rank
}

/// Crowding distance (Deb et al. 2002) of the points `members`, in their order; ends have infinity.
pub(super) fn crowding(points: &[(&[f64], f64)], members: &[usize]) -> Vec<f64> {
    let mut distance = vec![0.0; members.len()];
    let objectives = members.first().map_or(0, |&first| points[first].0.len());
    for objective in 0..objectives {
        let value = |place: usize| points[members[place]].0[objective];
        let mut order: Vec<usize> = (0..members.len()).collect();
        order.sort_by(|&a, &b| value(a).total_cmp(&value(b)).then(members[a].cmp(&members[b])));
        let (Some(&first), Some(&last)) = (order.first(), order.last()) else {
            break;
        };
        let width = value(last) - value(first);
        distance[first] = f64::INFINITY;
        distance[last] = f64::INFINITY;
        if width > 0.0 {
            for three in order.windows(3) {
                distance[three[1]] += (value(three[2]) - value(three[0])) / width;
            }
        }
    }
    distance
}
