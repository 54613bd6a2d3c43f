//! The picture on every card: what the effect does to the wing of `washout init`.

use crate::{base, mesh, with};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use washout::coupling::wing::Wing;
use washout::effects::{Effect, all, named};
use washout::explore::signature;
use washout::input::design::Design;
use washout::input::measurement::Channel;
use washout::progress::Progress;
use washout::structure::state::State;
use washout::structure::{Equilibrium, Loads, Vibration, lowest_modes};

#[test]
fn every_effect_moves_the_example_wing() {
    let effects: Vec<&dyn Effect> = all().collect();
    let wrong: Vec<String> = effects
        .into_par_iter()
        .filter_map(|effect| {
            let card = effect.card();
            let name = card.name;
            match signature(effect, &Progress::quiet()) {
                Err(error) => Some(format!("{name}: {error}")),
                Ok(found) => {
                    let twist = found.stations.iter().map(|station| station.change_deg);
                    let all: Vec<f64> = twist.chain([found.tip_deflection_mm, found.lift_mn]).collect();
                    let twists = all[..all.len() - 2].iter().any(|change| *change != 0.0);
                    let [deflects, lifts] = [all.len() - 2, all.len() - 1].map(|place| all[place] != 0.0);
                    // drag and power follow the twist
                    let is_seen = card.channels.iter().all(|channel| match channel {
                        Channel::Deflection => deflects,
                        Channel::Lift => lifts,
                        _ => twists,
                    });
                    let is_finite = all.iter().all(|change| change.is_finite());
                    (!is_seen || !is_finite || found.stations.len() != 5).then(|| {
                        format!(
                            "{name}: a channel of its card does not move on the example: {all:?} (twist at five stations, deflection, lift; \
                             `set_on_example` gives what it needs there)"
                        )
                    })
                }
            }
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The root turns all of the wing alike; the air, whose load falls with twist, takes some of that back, the more the farther out.
#[test]
fn a_soft_root_turns_the_whole_example_wing_the_most_at_its_root() {
    let found = signature(named("root-flexure").unwrap(), &Progress::quiet()).unwrap();
    let change: Vec<f64> = found.stations.iter().map(|station| station.change_deg).collect();
    assert!(
        change[1] > change[2] && change[2] > change[4] && change[4] > 0.0,
        "{change:?}"
    );
    assert!(found.lift_mn < 0.0, "{}", found.lift_mn);
}

/// Of the wing at rest and in a vacuum, Hz.
fn frequencies(design: &Design) -> Vec<f64> {
    let (_, mesh) = mesh(design);
    let wing = Wing::new(design, &mesh, None).unwrap();
    let mut equilibrium = Equilibrium::new(&wing.model).unwrap();
    let rest = State::at_rest(mesh.nodes.len());
    let found = lowest_modes(
        &mut equilibrium,
        &rest,
        &Loads::none(mesh.nodes.len()),
        &[],
        12,
        &Progress::quiet(),
    );
    match found.unwrap() {
        Vibration::Stable(modes) => modes.iter().map(|mode| mode.frequency_hz).collect(),
        Vibration::Unstable { .. } => panic!("{} is unstable at rest", design.name),
    }
}

#[test]
fn natural_frequencies_change_with_the_effects_whose_cards_say_so() {
    for effect in all() {
        let card = effect.card();
        if card.channels.contains(&Channel::Frequency) {
            let (base, _) = base(&card);
            let on = with(&base, &card, 0.5 * card.parameters[0].scale());
            let [before, now] = [&base, &on].map(frequencies);
            let moved = before
                .iter()
                .zip(&now)
                .map(|(a, b)| (b / a - 1.0).abs())
                .fold(0.0, f64::max);
            println!("{:24} {moved:.1e}", card.name);
            // modes are good to 1e-8
            assert!(moved > 1e-6, "{}: {before:?} {now:?}", card.name);
        }
    }
}
