//! The cases, one file each.

use super::Case;

pub mod cook_membrane;

pub mod elastica;

pub mod hencky_membrane;

pub mod scordelis_lo_roof;

/// Every case.
pub const ALL: &[&Case] = &[
    &scordelis_lo_roof::CASE,
    &cook_membrane::CASE,
    &elastica::CASE,
    &hencky_membrane::CASE,
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
