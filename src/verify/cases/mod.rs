//! The cases, one file each.

use super::Case;

pub mod beam_frequencies;

pub mod bend_45_degrees;

pub mod cantilever_plate_frequencies;

pub mod circular_plate;

pub mod clamped_strip_torsion;

pub mod cook_membrane;

pub mod curved_beam;

pub mod drum;

pub mod elastica;

pub mod euler_column;

pub mod goland_wing;

pub mod half_round_section;

pub mod hemisphere;

pub mod hemisphere_with_hole;

pub mod hencky_membrane;

pub mod inflated_membrane;

pub mod lateral_buckling;

pub mod morley_skew_plate;

pub mod pinched_cylinder;

pub mod princeton_beam;

pub mod raasch_hook;

pub mod rectangle_torsion;

pub mod rectangular_plate;

pub mod roll_up;

pub mod scordelis_lo_roof;

pub mod straight_beam;

pub mod supported_plate_frequencies;

pub mod swept_wing_divergence;

pub mod sze_end_moment;

pub mod sze_end_shear;

pub mod sze_pull_out;

pub mod sze_slit_ring;

pub mod tang_dowell_gravity;

pub mod taut_rectangle;

pub mod tension_field;

pub mod thick_cantilever;

pub mod thin_twisted_beam;

pub mod twisted_beam;

pub mod typical_section;

pub mod uniform_wing_divergence;

pub mod uniform_wing_twist;

pub mod uniform_wing_washout;

/// Every case.
pub const ALL: &[&Case] = &[
    &scordelis_lo_roof::CASE,
    &pinched_cylinder::CASE,
    &hemisphere_with_hole::CASE,
    &hemisphere::CASE,
    &twisted_beam::CASE,
    &thin_twisted_beam::CASE,
    &straight_beam::CASE,
    &curved_beam::CASE,
    &raasch_hook::CASE,
    &cook_membrane::CASE,
    &rectangular_plate::CASE,
    &circular_plate::CASE,
    &morley_skew_plate::CASE,
    &sze_end_shear::CASE,
    &sze_end_moment::CASE,
    &sze_slit_ring::CASE,
    &sze_pull_out::CASE,
    &elastica::CASE,
    &roll_up::CASE,
    &bend_45_degrees::CASE,
    &thick_cantilever::CASE,
    &princeton_beam::CASE,
    &lateral_buckling::CASE,
    &euler_column::CASE,
    &hencky_membrane::CASE,
    &inflated_membrane::CASE,
    &taut_rectangle::CASE,
    &tension_field::CASE,
    &half_round_section::CASE,
    &rectangle_torsion::CASE,
    &clamped_strip_torsion::CASE,
    &typical_section::CASE,
    &uniform_wing_twist::CASE,
    &uniform_wing_divergence::CASE,
    &uniform_wing_washout::CASE,
    &swept_wing_divergence::CASE,
    &goland_wing::CASE,
    &beam_frequencies::CASE,
    &cantilever_plate_frequencies::CASE,
    &supported_plate_frequencies::CASE,
    &drum::CASE,
    &tang_dowell_gravity::CASE,
];

/// The case of a name; `_` may stand for `-`.
pub fn named(name: &str) -> Option<&'static Case> {
    let name = name.replace('_', "-");
    ALL.iter().copied().find(|case| case.name == name)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::Path;

    use super::super::{Confidence, Order, Scale};
    use super::*;

    #[test]
    fn every_file_holds_the_case_of_its_name_and_stands_in_all() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/verify/cases");
        let files: BTreeSet<String> = std::fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
            .filter_map(|path| Some(path.file_stem()?.to_str()?.replace('_', "-")))
            .filter(|stem| stem != "mod")
            .collect();
        let names: BTreeSet<String> = ALL.iter().map(|case| case.name.to_string()).collect();
        assert_eq!(files, names);
        assert_eq!(names.len(), ALL.len());
    }

    #[test]
    fn every_quantity_is_filled_in() {
        for case in ALL {
            assert!(
                !case.title.is_empty() && !case.quantities.is_empty(),
                "{}",
                case.name
            );
            for quantity in case.quantities {
                let reference = (quantity.reference)();
                let name = format!("{}: {}", case.name, quantity.name);
                assert!(!quantity.name.is_empty() && !quantity.source.is_empty(), "{name}");
                assert!(
                    !reference.is_empty() && reference.iter().all(|r| r.is_finite()),
                    "{name}"
                );
                assert!(
                    quantity.confidence == Confidence::Memory || quantity.tolerance > 0.0,
                    "{name}"
                );
                assert!(
                    quantity.order != Order::Exempt(""),
                    "{name}: exempt without a reason"
                );
                assert!(
                    quantity.scale == Scale::Largest || reference.iter().all(|r| *r != 0.0),
                    "{name}"
                );
            }
        }
    }
}
