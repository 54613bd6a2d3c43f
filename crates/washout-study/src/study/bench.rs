//! The still wing on a bench, under a torque at its tip, a push at a spar, or one that bends it.

use crate::geometry::Planform;
use crate::input::Design;
use crate::input::sheet::{Bench, Load, ON_BENCH};
use crate::input::study::LoadedCase;
use crate::structure::{rod_deflection_m_n, rod_twist_rad_n_m};

/// Deflection for which a push that bends the wing is chosen, over the distance of its place from the base.
const BENT: f64 = 0.1;

/// The still wing under a torque at its tip that twists its rods so far: at its outermost spar, if it has any.
pub fn torque(case: &LoadedCase, twist_deg: f64) -> Option<(Bench, LoadedCase)> {
    let design = &case.loaded.design;
    let at_mm = outermost_mm(design)?;
    let torque_n_m = load_for(rod_twist_rad_n_m(design, at_mm).ok()?, twist_deg.to_radians())?;
    let load = Load::Torque(torque_n_m);
    Some(still(case, Bench { at_mm, load }))
}

/// The still wing pushed at the spar that is nearest to the middle of its span (or there), half a chord behind the leading edge, on a
/// rigid arm.
pub(super) fn push(case: &LoadedCase, twist_deg: f64) -> Option<(Bench, LoadedCase)> {
    let design = &case.loaded.design;
    let middle = 0.5 * tip_mm(design)?;
    let off = |at: &f64| (at - middle).abs();
    let nearest = spars_mm(design).min_by(|a, b| off(a).total_cmp(&off(b)));
    let at_mm = nearest.unwrap_or(middle);
    let planform = Planform::from_design(design).ok()?;
    let behind_mm = (1e3 * 0.5 * planform.chord_m(1e-3 * at_mm)).round();
    let twist_rad_n = 1e-3 * behind_mm * rod_twist_rad_n_m(design, at_mm).ok()?;
    let force_n = load_for(twist_rad_n, twist_deg.to_radians())?;
    let load = Load::Push { force_n, behind_mm };
    Some(still(case, Bench { at_mm, load }))
}

/// The still wing pushed on its leading edge near its tip, so that its rods bend: at its outermost spar, if it has any.
pub(super) fn bend(case: &LoadedCase) -> Option<(Bench, LoadedCase)> {
    let design = &case.loaded.design;
    let at_mm = outermost_mm(design)?;
    let force_n = load_for(rod_deflection_m_n(design, at_mm).ok()?, BENT * 1e-3 * at_mm)?;
    let load = Load::Push {
        force_n,
        behind_mm: 0.0,
    };
    Some(still(case, Bench { at_mm, load }))
}

/// A case without air to speak of, under this load alone, with the masses that the design has and not the case. A name of the wing
/// that says no more than that it is one is not repeated.
fn still(case: &LoadedCase, bench: Bench) -> (Bench, LoadedCase) {
    let mut still = case.clone();
    let design = &mut still.loaded.design;
    let own = std::mem::take(&mut design.load).into_iter().enumerate();
    let own = own.filter(|(place, _)| !is_set_by(case, *place));
    design.load = own.map(|(_, load)| load).collect();
    bench.put(design);
    still
        .rows
        .iter_mut()
        .for_each(|row| row.run = ON_BENCH.to_string());
    let wing = match design.name.as_str() {
        "wing" => "the still wing".to_string(),
        name => format!("the still wing {name}"),
    };
    let name = format!("{wing} {}", bench.words());
    (bench, LoadedCase { name, ..still })
}

/// Whether the case sets the load at this place of the design, such as a mass that is hung to the wing.
fn is_set_by(case: &LoadedCase, place: usize) -> bool {
    let own = format!("load[{place}]");
    let keys = case.sets.iter().filter_map(|set| set.split_once('='));
    keys.map(|(key, _)| key.trim())
        .any(|key| key == "load" || key.starts_with(&own))
}

/// Load under which the rods give way so far (rad, m), which do so by this much for each unit of it: 1, 2 or 5 times a power of ten.
fn load_for(flexibility: f64, so_far: f64) -> Option<f64> {
    let load = so_far / flexibility;
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

fn spars_mm(design: &Design) -> impl Iterator<Item = f64> {
    design.spar.iter().map(|spar| spar.at_mm.value())
}

/// The outermost spar, or the tip of a wing without, mm.
fn outermost_mm(design: &Design) -> Option<f64> {
    let outermost = spars_mm(design).max_by(f64::total_cmp);
    outermost.or_else(|| tip_mm(design))
}

/// Where the built wing ends, mm.
fn tip_mm(design: &Design) -> Option<f64> {
    let planform = Planform::from_design(design).ok()?;
    Some((1e4 * planform.tip_m()).round() / 10.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_still_wing_keeps_its_own_masses_and_not_the_one_that_is_hung_to_it() {
        let path =
            std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("studies/pre-pazy.toml");
        let study = crate::input::study::LoadedStudy::load(&path, &[]).unwrap();
        let case = study
            .cases
            .iter()
            .find(|case| case.name == "bending-1.00")
            .unwrap();
        let masses = |case: &LoadedCase| -> Vec<f64> {
            let loads = case.loaded.design.load.iter();
            loads.map(|own| own.mass_kg.value()).collect()
        };
        let all = masses(case);
        assert_eq!((all.len(), all[0]), (17, 1.0));
        let (_, still) = torque(case, 3.0).unwrap();
        assert_eq!(masses(&still)[..16], all[1..]);
        assert_eq!(masses(&still)[16..], [0.0]);
    }

    #[test]
    fn loads_are_numbers_that_a_bench_has() {
        let [a, b, c] = [0.00037, 4.99, 5.0].map(round);
        assert_eq!([a, b, c], [0.0002, 2.0, 5.0]);
        assert_eq!(round(1.0), 1.0);
        assert_eq!(round(0.1), 0.1);
    }
}
