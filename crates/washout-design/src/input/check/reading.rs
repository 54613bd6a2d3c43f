//! Where twist is read, and what is said to be assumed.

use std::collections::HashSet;

use super::refusal::{refuse, round};
use crate::input::assumption::word_at;
use crate::input::design::{Design, Instrument};
use crate::input::document::Node;
use crate::input::error::{InputError, Number};

pub(super) fn check(design: &Design, root: &Node) -> Result<(), InputError> {
    let observation = &design.observation;
    if observation.instrument == Instrument::Camera && observation.camera_axis.is_none() {
        let message = "needs camera_axis";
        let cure =
            "Give camera_axis = \"flapping-axis\" or \"stroke\", the axis along which the camera looks";
        return refuse(
            root,
            "observation.instrument",
            message,
            &["observation.camera_axis"],
            cure,
        );
    }
    let (length, cut) = (design.planform.length_mm.value(), design.planform.tip_cut.value());
    if observation.tip_station > cut {
        let message = format!("lies beyond the tip cut at {} of the length", Number(cut));
        let cure = "Read the tip inboard of planform.tip_cut, usually at 0.97";
        return refuse(
            root,
            "observation.tip_station",
            message,
            &["planform.tip_cut"],
            cure,
        );
    }
    let mut seen = HashSet::new();
    for (number, station) in observation.stations_mm.iter().enumerate() {
        let key = format!("observation.stations_mm[{number}]");
        if *station > length * cut + 1e-9 {
            let message = format!(
                "is off the wing, which is cut at {} mm (length_mm × tip_cut)",
                Number(round(length * cut))
            );
            return refuse(
                root,
                &key,
                message,
                &["planform.length_mm"],
                "Give stations on the wing",
            );
        }
        if !seen.insert((station + 0.0).to_bits()) {
            return refuse(root, &key, "stands twice", &[], "Give every station once");
        }
    }
    if let Some(measured) = &design.measured {
        for (key, text) in [
            ("measured.file", &measured.file),
            ("measured.case", &measured.case),
        ] {
            if text.is_empty() {
                let cure = "Name the CSV file and the case in it, or delete [measured]";
                return refuse(root, key, "must not be empty", &[], cure);
            }
        }
    }
    assumed_choices(design, root)
}

fn assumed_choices(design: &Design, root: &Node) -> Result<(), InputError> {
    if design.assumed_choice.is_empty() {
        return Ok(());
    }
    let value = toml::Value::try_from(design).ok();
    for (number, choice) in design.assumed_choice.iter().enumerate() {
        let known = value.as_ref().and_then(|value| word_at(value, &choice.key));
        if known.is_none() {
            let key = format!("assumed_choice[{number}].key");
            let message = "no word stands under this key in the design";
            let cure = "Give the dotted key of a choice, e.g. \"root.chord\"; assumed numbers are marked \
                        where they stand, { assumed = ..., range = [...] }";
            return refuse(root, &key, message, &[], cure);
        }
    }
    Ok(())
}
