//! Which readings would refute a set: the cheapest of which it says otherwise than the other sets.

use crate::study::quantile::quantile;

use super::forecast::Effort;
use super::report::{Forecast, Refuting};

/// Standard deviations by which a reading separates two sets.
const APART: f64 = 3.0;
/// Readings that are named for one set.
const NAMED: usize = 2;

/// For the set at `own`, the cheapest readings of which it says otherwise than at least half of the other sets; where there are none, the one
/// that comes nearest. `forecasts`: by set, what it says of the readings, alike in all sets.
pub fn refuting(own: usize, forecasts: &[Vec<Forecast>], effort: &[Effort]) -> Vec<Refuting> {
    let mut found: Vec<(Effort, Refuting)> = Vec::new();
    for (place, forecast) in forecasts[own].iter().enumerate() {
        let Some(with_set) = forecast.with_set else {
            continue;
        };
        let mut others: Vec<f64> = forecasts
            .iter()
            .enumerate()
            .filter(|(set, _)| *set != own)
            .filter_map(|(_, other)| other.get(place)?.with_set)
            .collect();
        others.sort_by(f64::total_cmp);
        let against = others
            .iter()
            .filter(|other| (*other - with_set).abs() >= APART * forecast.sigma);
        let against = against.count();
        let Some(median) = quantile(&others, 0.5) else {
            continue;
        };
        found.push((
            effort[place],
            Refuting {
                condition: forecast.condition.clone(),
                channel: forecast.channel,
                r_mm: forecast.r_mm,
                with_set,
                sigma: forecast.sigma,
                against,
                others: others.len(),
                apart_sigma: (with_set - median).abs() / forecast.sigma,
            },
        ));
    }
    let decides = |own: &Refuting| 2 * own.against >= own.others && own.against > 0;
    let mut best: Vec<(Effort, Refuting)> = found.iter().filter(|own| decides(&own.1)).cloned().collect();
    best.sort_by(|a, b| {
        let more = b.1.against.cmp(&a.1.against);
        a.0.cmp(&b.0)
            .then(more)
            .then_with(|| b.1.apart_sigma.total_cmp(&a.1.apart_sigma))
    });
    // the second is of another kind, or it would say the same again
    let mut named: Vec<(Effort, Refuting)> = Vec::new();
    for own in best {
        if named.iter().all(|known| known.0 != own.0) && named.len() < NAMED {
            named.push(own);
        }
    }
    if named.is_empty() {
        found.retain(|own| own.1.against > 0);
        found.sort_by(|a, b| {
            b.1.against
                .cmp(&a.1.against)
                .then_with(|| b.1.apart_sigma.total_cmp(&a.1.apart_sigma))
        });
        named.extend(found.into_iter().take(1));
    }
    named.into_iter().map(|own| own.1).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::measurement::Channel;

    fn says(values: [f64; 2]) -> Vec<Forecast> {
        let of = |with_set: f64| Forecast {
            condition: "c".into(),
            channel: Channel::Twist,
            r_mm: None,
            sigma: 1.0,
            stated: None,
            with_set: Some(with_set),
        };
        values.map(of).to_vec()
    }

    #[test]
    fn the_cheapest_reading_that_sets_a_set_apart_from_half_of_the_others_is_named_first() {
        let all = [says([0.0, 0.0]), says([1.0, 9.0]), says([5.0, 9.0])];
        let kinds = [Effort::Picture, Effort::Experiment];
        let found = refuting(0, &all, &kinds);
        assert_eq!([found[0].against, found[0].others, found[1].against], [1, 2, 2]);
        // nothing sets the second apart from half of the others by the cheap reading, but from both by none
        let found = refuting(1, &all, &kinds);
        assert!(found.iter().all(|own| own.against >= 1), "{found:?}");
    }
}
