//! The shortest way from a design file to a twist: `cargo run --release --example first_run`.

use std::error::Error;

use washout::progress::Progress;
use washout::wing::WingModel;

fn main() -> Result<(), Box<dyn Error>> {
    let design = concat!(env!("CARGO_MANIFEST_DIR"), "/designs/twist-v2.toml");
    let wing = WingModel::open(design, &["flapping.half_amplitude_deg=30"])?;
    let profile = wing.solve(&Progress::shown())?.profile()?;
    for reading in &profile.readings {
        let (r_mm, twist_deg) = (reading.r_m * 1e3, reading.twist_rad.to_degrees());
        println!("{r_mm:6.1} mm {twist_deg:6.2} deg");
    }

    let tip = profile.tip().ok_or("the tip was not read")?;
    let tip_deg = tip.twist_rad.to_degrees();
    assert!((tip_deg - TIP_DEG).abs() < 0.2, "tip twist {tip_deg:.2} deg");
    Ok(())
}

/// Twist at 97 % of the length; less than at the amplitude of the design, 34.5 deg.
const TIP_DEG: f64 = 18.2;
