//! The still wing on a bench, under a torque at its tip or a push at a spar.

use crate::geometry::Planform;
use crate::input::Design;
use crate::input::design::BenchLoad;
use crate::input::quantity::Quantity;
use crate::input::study::LoadedCase;
use crate::structure::rod_twist_rad_n_m;

/// Frequency of a stroke without air to speak of, Hz: the lowest that a design may have.
pub(super) const STILL_HZ: f64 = 0.1;
/// Speed of a stream without air to speak of, over that of the measurement.
const STILL_SPEED: f64 = 0.01;

/// The still wing under a torque at its tip that twists its rods so far: at its outermost spar, if it has any.
pub fn torque(case: &LoadedCase, twist_deg: f64) -> Option<LoadedCase> {
    let design = &case.loaded.design;
    let outermost = spars_mm(design).max_by(f64::total_cmp);
    let at_mm = outermost.or_else(|| tip_mm(design))?;
    let torque_n_m = load_for(1.0, rod_twist_rad_n_m(design, at_mm).ok()?, twist_deg)?;
    let load = BenchLoad {
        moment_n_m: [torque_n_m, 0.0, 0.0],
        ..unloaded(at_mm)
    };
    let words = format!(
        "{} under a torque of {} near its tip ({} mm)",
        still_wing(&design.name),
        with_unit(torque_n_m, "N·m"),
        short(at_mm)
    );
    Some(still(case, load, words))
}

/// The still wing pushed at the spar that is nearest to the middle of its span (or there), half a chord behind the leading edge, on a
/// rigid arm.
pub(super) fn push(case: &LoadedCase, twist_deg: f64) -> Option<LoadedCase> {
    let design = &case.loaded.design;
    let middle = 0.5 * tip_mm(design)?;
    let off = |at: &f64| (at - middle).abs();
    let nearest = spars_mm(design).min_by(|a, b| off(a).total_cmp(&off(b)));
    let at_mm = nearest.unwrap_or(middle);
    let planform = Planform::from_design(design).ok()?;
    let behind_mm = (1e3 * 0.5 * planform.chord_m(1e-3 * at_mm)).round();
    let push_n = load_for(
        1e-3 * behind_mm,
        rod_twist_rad_n_m(design, at_mm).ok()?,
        twist_deg,
    )?;
    let load = BenchLoad {
        chord_offset_mm: Quantity::Stated(behind_mm),
        force_n: [0.0, 0.0, push_n],
        ..unloaded(at_mm)
    };
    let words = format!(
        "{} under a push of {} at {} mm, {} mm behind its leading edge",
        still_wing(&design.name),
        with_unit(push_n, "N"),
        short(at_mm),
        short(behind_mm)
    );
    Some(still(case, load, words))
}

/// The still wing of a name in words; a name that says no more is not repeated.
fn still_wing(name: &str) -> String {
    match name {
        "wing" => "the still wing".to_string(),
        name => format!("the still wing {name}"),
    }
}

/// A case without air to speak of, under this load alone.
fn still(case: &LoadedCase, load: BenchLoad, name: String) -> LoadedCase {
    let mut still = case.clone();
    let design = &mut still.loaded.design;
    if let Some(flapping) = &mut design.flapping {
        flapping.frequency_hz = Quantity::Stated(STILL_HZ);
    }
    if let Some(steady) = &mut design.steady {
        steady.speed_m_s = Quantity::Stated(STILL_SPEED * steady.speed_m_s.value());
    }
    design.load = vec![load];
    LoadedCase { name, ..still }
}

/// Load on an arm (m; 1 for a torque in N·m) that twists the rods so far: 1, 2 or 5 times a power of ten.
fn load_for(arm_m: f64, twist_rad_n_m: f64, twist_deg: f64) -> Option<f64> {
    let load = twist_deg.to_radians() / (twist_rad_n_m * arm_m);
    (load.is_finite() && load > 0.0).then(|| round(load))
}

/// The largest of 1, 2 and 5 times a power of ten that is no larger.
fn round(value: f64) -> f64 {
    let power = value.log10().floor();
    let digit = value / 10.0_f64.powf(power);
    let digit = [5.0, 2.0]
        .into_iter()
        .find(|own| digit >= *own - 1e-9)
        .unwrap_or(1.0);
    // divided by a whole power, so that it is the number that is printed
    match power {
        small if small < 0.0 => digit / 10.0_f64.powf(-small),
        large => digit * 10.0_f64.powf(large),
    }
}

fn unloaded(at_mm: f64) -> BenchLoad {
    let nothing = || Quantity::Stated(0.0);
    BenchLoad {
        at_mm: Quantity::Stated(at_mm),
        chord_offset_mm: nothing(),
        normal_offset_mm: nothing(),
        force_n: [0.0; 3],
        moment_n_m: [0.0; 3],
        mass_kg: nothing(),
        inertia_kg_m2: [0.0; 3],
    }
}

fn spars_mm(design: &Design) -> impl Iterator<Item = f64> {
    design.spar.iter().map(|spar| spar.at_mm.value())
}

/// Where the built wing ends, mm.
fn tip_mm(design: &Design) -> Option<f64> {
    let planform = Planform::from_design(design).ok()?;
    Some((1e4 * planform.tip_m()).round() / 10.0)
}

/// A number with its unit, in thousandths of it or millionths where it is small.
fn with_unit(value: f64, unit: &str) -> String {
    match value {
        large if large >= 0.1 => format!("{} {unit}", short(large)),
        small if small >= 1e-4 => format!("{} m{unit}", short(1e3 * small)),
        tiny => format!("{} µ{unit}", short(1e6 * tiny)),
    }
}

/// To three places, without zeros at the end.
pub(super) fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_are_numbers_that_a_bench_has() {
        let [a, b, c] = [0.00037, 4.99, 5.0].map(round);
        assert_eq!([a, b, c], [0.0002, 2.0, 5.0]);
        assert_eq!(round(1.0), 1.0);
        assert_eq!(round(0.1), 0.1);
        assert_eq!(
            [2e-5, 2e-4, 0.05, 0.5, 20.0].map(|load| with_unit(load, "N·m")),
            ["20 µN·m", "0.2 mN·m", "50 mN·m", "0.5 N·m", "20 N·m"]
        );
        assert_eq!([11.0, 11.5, 0.0].map(short), ["11", "11.5", "0"]);
    }
}
