//! An effect of one's own in Rust, in two files: this one, and `tapered_rod.rs` with its card and its formula.
//!
//! Without arguments it checks the effect against its closed form:
//! `cargo run --release --example effect_in_rust`. With arguments it is washout with one effect more:
//!
//! ```text
//! cargo run --release --example effect_in_rust -- effects tapered-rod
//! cargo run --release --example effect_in_rust -- solve designs/twist-v2.toml --set effects.tapered-rod.strength=0.3
//! cargo run --release --example effect_in_rust -- diagnose MY-STUDY.toml
//! ```

mod tapered_rod;

use std::error::Error;
use std::process::ExitCode;

use washout::input::Design;
use washout::progress::Progress;
use washout::wing::WingModel;

use tapered_rod::TaperedRod;

/// A round steel rod of 100 mm under a torque at its end.
const ROD: &str = r#"
format = 1
name = "rod"
planform = { length_mm = 100.0, outline = [[0.0, 20.0], [100.0, 20.0]], tip_cut = 1.0 }
ribs = { bays = 20 }
rod = [{ from_mm = 0.0, to_mm = 100.0, material = "steel", section = { shape = "round", diameter_mm = 1.0 } }]
material = { steel = { e_gpa = 200.0, g_gpa = 80.0, poisson = 0.25, density_kg_m3 = 8000.0 } }
load = [{ at_mm = 100.0, moment_n_m = [0.001, 0.0, 0.0] }]
"#;

fn main() -> ExitCode {
    if let Err(error) = washout::effects::register(vec![&TaperedRod]) {
        eprintln!("{error}");
        return ExitCode::FAILURE;
    }
    if std::env::args_os().len() > 1 {
        return washout::cli::main();
    }
    match closed_form() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// With half of its stiffness missing at the tip, a torque there twists the rod by ∫ dξ/(1 − ξ/2) = −2 ln(1 − x/2) up to x = r/L,
/// over x without that: 1.368 times as far at 97 % of the length.
fn closed_form() -> Result<(), Box<dyn Error>> {
    let [r_m, uniform] = tip_twist_rad(0.0)?;
    let [_, tapered] = tip_twist_rad(0.5)?;
    let x = r_m / 0.1;
    let (ratio, expected) = (tapered / uniform, -2.0 * (1.0 - 0.5 * x).ln() / x);
    println!(
        "a rod that is half as stiff at its tip twists {ratio:.4} times as far at {x:.2} of its length; by the closed form {expected:.4}"
    );
    assert!((ratio / expected - 1.0).abs() < 1e-3, "{ratio} {expected}");
    Ok(())
}

/// Where the outermost twist is read (m), and the twist.
fn tip_twist_rad(strength: f64) -> Result<[f64; 2], Box<dyn Error>> {
    let mut design = Design::from_toml(ROD, "rod.toml")?;
    design.set("effects.tapered-rod.strength", strength)?;
    let profile = WingModel::of_design(design)?
        .solve(&Progress::quiet())?
        .profile()?;
    let tip = profile.tip().ok_or("the tip was not read")?;
    Ok([tip.r_m, tip.twist_rad])
}
