//! Lines in any order and direction, put end to end.

use std::collections::BTreeMap;

/// The chain that edges form, from the end for which `first` prefers: places and directions of the edges.
///
/// Each entry is the edge's place in `edges` and its nodes in running order. An error says how it fails.
pub fn chain(
    edges: &[[usize; 2]],
    first: impl Fn(usize, usize) -> std::cmp::Ordering,
) -> Result<Vec<(usize, [usize; 2])>, &'static str> {
    let mut at_node: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (place, &[a, b]) in edges.iter().enumerate() {
        if a == b {
            return Err("has an element without length");
        }
        at_node.entry(a).or_default().push(place);
        at_node.entry(b).or_default().push(place);
    }
    if at_node.values().any(|places| places.len() > 2) {
        return Err("branches, or an element stands twice");
    }
    let ends = at_node
        .iter()
        .filter(|(_, places)| places.len() == 1)
        .map(|(&node, _)| node);
    let Some(mut node) = ends.min_by(|&a, &b| first(a, b)) else {
        return Err("is closed");
    };
    let mut ordered: Vec<(usize, [usize; 2])> = Vec::with_capacity(edges.len());
    let mut before = usize::MAX;
    while let Some(&place) = at_node[&node].iter().find(|&&place| place != before) {
        let [a, b] = edges[place];
        let next = if a == node { b } else { a };
        ordered.push((place, [node, next]));
        (before, node) = (place, next);
    }
    if ordered.len() == edges.len() {
        Ok(ordered)
    } else {
        Err("is interrupted")
    }
}

#[cfg(test)]
mod tests {
    use super::chain;

    #[test]
    fn edges_in_any_order_and_direction_are_put_end_to_end() {
        let ordered = chain(&[[7, 3], [9, 2], [3, 2]], |a, b| b.cmp(&a)).unwrap();
        assert_eq!(ordered, [(1, [9, 2]), (2, [2, 3]), (0, [3, 7])]);
    }

    #[test]
    fn what_is_no_chain_is_refused() {
        let order = |a: usize, b: usize| a.cmp(&b);
        assert_eq!(
            chain(&[[1, 2], [2, 3], [2, 4]], order),
            Err("branches, or an element stands twice")
        );
        assert_eq!(chain(&[[1, 2], [2, 3], [3, 1]], order), Err("is closed"));
        assert_eq!(chain(&[[1, 2], [3, 4]], order), Err("is interrupted"));
        assert_eq!(
            chain(&[[1, 2], [3, 4], [4, 5], [5, 3]], order),
            Err("is interrupted")
        );
        assert_eq!(chain(&[[1, 1]], order), Err("has an element without length"));
        // The same edge twice closes upon itself.
        assert_eq!(chain(&[[1, 2], [2, 1]], order), Err("is closed"));
    }
}
