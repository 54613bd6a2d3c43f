//! How thick the viewer draws a rod or a spar: as a tube of the area of its section.

use std::f64::consts::PI;

use crate::input::design::Section;

/// Diameter of the circle that has the area of a section, mm; the outer one of a tube, none where only stiffnesses are given.
pub fn diameter_mm(section: &Section) -> Option<f64> {
    let of_area = |area_mm2: f64| (4.0 * area_mm2 / PI).sqrt();
    match section {
        Section::Round { diameter_mm } => Some(diameter_mm.value()),
        Section::HalfRound { diameter_mm, .. } => Some(diameter_mm.value() / 2f64.sqrt()),
        Section::Tube {
            outer_diameter_mm, ..
        } => Some(outer_diameter_mm.value()),
        Section::Rectangle {
            width_mm,
            thickness_mm,
        } => Some(of_area(width_mm.value() * thickness_mm.value())),
        Section::Laminate { width_mm, plies } => {
            let thickness_mm: f64 = plies.iter().map(|ply| ply.thickness_mm.value()).sum();
            Some(of_area(width_mm.value() * thickness_mm))
        }
        Section::Given { .. } => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::design::Flat;

    #[test]
    fn a_half_round_has_half_the_area_of_its_rod_and_a_strip_its_own() {
        let area_mm2 = |section: &Section| 0.25 * PI * diameter_mm(section).expect("a diameter").powi(2);
        let [round, half] = [
            Section::Round {
                diameter_mm: 1.0.into(),
            },
            Section::HalfRound {
                diameter_mm: 1.0.into(),
                flat: Flat::InPlane,
            },
        ]
        .map(|section| area_mm2(&section));
        assert!((half - 0.5 * round).abs() < 1e-12);
        let strip = Section::Rectangle {
            width_mm: 1.0.into(),
            thickness_mm: 0.08.into(),
        };
        assert!((area_mm2(&strip) - 0.08).abs() < 1e-12);
    }
}
