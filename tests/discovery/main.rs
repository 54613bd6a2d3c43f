//! Hidden causes in a toy rod: what a diagnosis says of them, measured against another solver's data.

mod cases;
mod effects;
mod explained;
mod lessons;
mod pages;
mod rod;
mod scoreboard;
mod truth;
mod valleys;

use washout::diagnose::Settings;

fn number(name: &str, default: f64) -> f64 {
    std::env::var(name)
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(default)
}

#[test]
#[ignore = "minutes: the whole scoreboard"]
fn the_scoreboard() {
    let seed = number("DISCOVERY_SEED", 10_000.0) as u64;
    let settings = Settings::default();
    scoreboard::print(
        seed,
        number("DISCOVERY_SCALE", 1.0),
        &settings,
        number("DISCOVERY_LIST", 0.0) > 0.0,
    );
}
