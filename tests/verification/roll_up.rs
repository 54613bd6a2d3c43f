//! Roll-up of a cantilever by an end moment.
//!
//! Closed form: M = n 2π EI / L bends a beam of length L into n circles; tip displacement u = L (sin φ / φ − 1),
//! w = L (1 − cos φ) / φ with φ = M L / EI.

use nalgebra::Vector3;
use washout::progress::Progress;
use washout::structure::state::State;
use washout::structure::{Equilibrium, Loads, Model, NewtonSettings, Section};

#[test]
fn beam_rolls_up_to_the_circle() {
    let (length, count) = (10.0, 16);
    let nodes = (0..=count)
        .map(|i| Vector3::new(length * i as f64 / count as f64, 0.0, 0.0))
        .collect();
    let mut model = Model::new(nodes);
    let section = model.add_section(Section::uncoupled(1e6, 80.0, 100.0, 100.0));
    for i in 0..count {
        model.add_beam([i, i + 1], &Vector3::z(), section).unwrap();
    }
    model.clamp(0);
    let mut equilibrium = Equilibrium::new(&model).unwrap();
    for turns in [0.25, 1.0, 2.0] {
        let phi = turns * std::f64::consts::TAU;
        let mut loads = Loads::none(model.nodes.len());
        loads.moment_n_m[count] = Vector3::new(0.0, -phi * 100.0 / length, 0.0);
        let none = Loads::none(model.nodes.len());
        let mut state = State::at_rest(model.nodes.len());
        let report = equilibrium
            .solve(
                &mut state,
                &none,
                &loads,
                &NewtonSettings::default(),
                &Progress::quiet(),
            )
            .unwrap();
        let tip = state.displacement[count];
        let exact = [length * (phi.sin() / phi - 1.0), length * (1.0 - phi.cos()) / phi];
        println!("{turns} {report:?} {tip:?} {exact:?}");
        assert!((tip.x - exact[0]).abs() < 1e-3 * length);
        assert!((tip.z - exact[1]).abs() < 1e-3 * length);
    }
}
