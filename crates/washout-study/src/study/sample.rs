//! Points that fill a unit cube evenly: the Owen-scrambled Sobol sequence.

/// Longest sequence that [`unit_points`] can give.
pub const MOST_POINTS: usize = 1 << 16;

/// `count` points in [0, 1) to the power `dimensions`; the same for the same seed on every machine.
///
/// Burley, J. Comput. Graph. Tech. 9(4), 2020. The sequence has 256 dimensions; further ones are scrambled anew.
pub fn unit_points(count: usize, dimensions: usize, seed: u32) -> Vec<Vec<f64>> {
    let block = sobol_burley::NUM_DIMENSIONS as usize;
    let coordinate = |index: usize, dimension: usize| {
        let block_seed = seed.wrapping_add((dimension / block) as u32);
        f64::from(sobol_burley::sample(
            index as u32,
            (dimension % block) as u32,
            block_seed,
        ))
    };
    let point = |index: usize| {
        (0..dimensions)
            .map(|dimension| coordinate(index, dimension))
            .collect()
    };
    (0..count.min(MOST_POINTS)).map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_of_64_equal_slices_holds_one_of_64_points_in_every_dimension() {
        let points = unit_points(64, 40, 1);
        for dimension in 0..40 {
            let mut slices: Vec<usize> = points
                .iter()
                .map(|point| (point[dimension] * 64.0) as usize)
                .collect();
            slices.sort_unstable();
            assert_eq!(slices, (0..64).collect::<Vec<_>>(), "dimension {dimension}");
        }
    }

    #[test]
    fn points_depend_on_the_seed_alone() {
        assert_eq!(unit_points(8, 300, 5), unit_points(8, 300, 5));
        assert_ne!(unit_points(8, 3, 5), unit_points(8, 3, 6));
    }
}
