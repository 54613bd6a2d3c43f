//! The picture on every card: what the effect does to the wing of `washout init`.

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use washout::effects::{Card, all, named};
use washout::explore::signature;
use washout::progress::Progress;

#[test]
fn every_effect_moves_the_example_wing() {
    let cards: Vec<Card> = all().map(|effect| effect.card()).collect();
    let wrong: Vec<String> = cards
        .into_par_iter()
        .filter_map(|card| {
            let name = card.name;
            match signature(&card, &Progress::quiet()) {
                Err(error) => Some(format!("{name}: {error}")),
                Ok(found) => {
                    let twist = found.stations.iter().map(|station| station.change_deg);
                    let all: Vec<f64> = twist.chain([found.tip_deflection_mm, found.lift_mn]).collect();
                    let is_seen = all.iter().any(|change| *change != 0.0);
                    let is_finite = all.iter().all(|change| change.is_finite());
                    (!is_seen || !is_finite || found.stations.len() != 5).then(|| format!("{name}: {all:?}"))
                }
            }
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The root turns all of the wing alike; the air, whose load falls with twist, takes some of that back, the more the farther out.
#[test]
fn a_soft_root_turns_the_whole_example_wing_the_most_at_its_root() {
    let card = named("root-flexure").unwrap().card();
    let found = signature(&card, &Progress::quiet()).unwrap();
    let change: Vec<f64> = found.stations.iter().map(|station| station.change_deg).collect();
    assert!(
        change[1] > change[2] && change[2] > change[4] && change[4] > 0.0,
        "{change:?}"
    );
    assert!(found.lift_mn < 0.0, "{}", found.lift_mn);
}
