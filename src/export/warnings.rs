//! What limits how far the numbers of a run hold.

use super::summary::RunSummary;
use crate::input::design::{Coefficients, Design, FilmCompression, Section};
use crate::page::text::{number, significant};
use crate::wing::OtherEquilibrium;
use crate::wing::stroke::StrokeSummary;

/// Below this ratio of the lowest natural frequency to that of the flapping, the shape does not follow its load.
pub const SLOW_RATIO: f64 = 1.5;

/// Above this swing of the twist about that of standing still, a motion of linear modes is a hint.
pub const LARGE_SWING_DEG: f64 = 15.0;

/// Share of the tip's twist above which what the mesh leaves is said.
const COARSE_SHARE: f64 = 0.02;

/// Twist that no instrument reads, deg: what a mesh leaves below this is nobody's concern.
const READABLE_DEG: f64 = 0.1;

/// Angles below these are as likely meant in radians: of the half amplitude, and of the pitch stop, deg.
const RADIANS_DEG: [f64; 2] = [2.0, 1.6];

/// Sentences for a reader who must not take the numbers for more than they are; none if nothing is the matter.
pub fn warnings(summary: &RunSummary) -> Vec<String> {
    let (solve, numbers) = (&summary.solve, &summary.engineering);
    let mut warnings = Vec::new();
    if solve.negative_pivots > 0 {
        warnings.push(format!(
            "the loaded shape is not stable ({} negative pivots): the real wing would leave it",
            solve.negative_pivots
        ));
    }
    warnings.extend(summary.other_equilibrium.as_ref().map(OtherEquilibrium::words));
    if let Some(ratio) = numbers.frequency_ratio.filter(|ratio| *ratio < SLOW_RATIO) {
        warnings.push(format!(
            "the lowest natural frequency in air is only {} times that of the flapping: twist at mid-stroke is not the \
             quasi-static one (a diagnosis tries that as the effect twist-dynamics)",
            number(ratio, 2)
        ));
    }
    for (part, extreme) in [
        ("rod, in shear", &numbers.rod_shear_stress),
        ("rod, in bending", &numbers.rod_bending_stress),
        ("spars", &numbers.spar_stress),
        ("film", &numbers.film_stress),
    ] {
        let Some(extreme) = extreme
            .as_ref()
            .filter(|peak| peak.margin.is_some_and(|m| m < 1.0))
        else {
            continue;
        };
        warnings.push(format!(
            "{part}: {} MPa at {} mm is beyond the strength of {} MPa",
            significant(extreme.stress_mpa, 3),
            number(extreme.r_mm, 1),
            significant(extreme.strength_mpa.unwrap_or_default(), 3)
        ));
    }
    warnings.extend(of_mesh(summary));
    warnings.extend(of_design(&summary.design, summary.wing.tip_mm));
    warnings
}

/// Density below which a material is lighter than foams, kg/m³.
const LIGHTEST_KG_M3: f64 = 10.0;

/// That the mesh error is not known; or what the mesh leaves of the tip's twist, where that is more than a fiftieth of it and more than any instrument reads.
fn of_mesh(summary: &RunSummary) -> Option<String> {
    if let Some(reason) = &summary.mesh_error.unknown_because {
        return Some(format!("the mesh error is not known: {reason}"));
    }
    let (error, tip) = (summary.mesh_error.tip_twist_deg?, summary.tip.twist_deg?);
    let share = error / tip.abs();
    (share > COARSE_SHARE && error > READABLE_DEG).then(|| {
        format!(
            "mesh error {} deg at the tip ({} %); --accuracy 1 refines to 1 %",
            number(error, 1),
            significant(100.0 * share, 2)
        )
    })
}

/// What limits the numbers of a stroke; none for phases that stand still.
pub fn of_stroke(stroke: &StrokeSummary) -> Vec<String> {
    let Some(periodic) = &stroke.periodic else {
        return Vec::new();
    };
    let mut warnings = Vec::new();
    if periodic.largest_swing_deg > LARGE_SWING_DEG {
        warnings.push(format!(
            "over the stroke the wing swings by up to {} deg about the shape that would stand still, farther than modes hold \
             that are linear about mid-stroke: take from it which way and how hard, not the figure",
            number(periodic.largest_swing_deg, 0)
        ));
    }
    if !periodic.released_deg.is_empty() {
        let stretches = periodic.released_deg.iter();
        let stretches = stretches.map(|[from, to]| format!("{} to {} deg", number(*from, 0), number(*to, 0)));
        warnings.push(format!(
            "over the stroke the stop would have to pull at phases of {} (mid-stroke: 0): the real wing leaves it there",
            stretches.collect::<Vec<_>>().join(", ")
        ));
    }
    if !periodic.left_out.is_empty() {
        warnings.push(format!(
            "the motion over the stroke is found without {}, which it is the source of, or holds itself",
            periodic.left_out.join(", ")
        ));
    }
    warnings
}

/// What in the design is unlikely to be meant, or beyond what a law was measured for; `tip_mm` is where the wing is cut.
fn of_design(design: &Design, tip_mm: f64) -> Vec<String> {
    let mut warnings = Vec::new();
    if let Some(own) = &design.flapping {
        let angles = [
            ("half_amplitude_deg", own.half_amplitude_deg.value()),
            ("stop_angle_deg", own.stop_angle_deg.value()),
        ];
        for ((key, angle), limit) in angles.into_iter().zip(RADIANS_DEG) {
            if angle > 0.0 && angle < limit {
                warnings.push(format!(
                    "flapping.{key} is {angle} deg: is it in radians? Then write {}",
                    significant(angle.to_degrees(), 3)
                ));
            }
        }
    }
    for (name, material) in &design.material {
        let density = material.density_kg_m3.value();
        if density < LIGHTEST_KG_M3 {
            warnings.push(format!(
                "material.{name}.density_kg_m3 is {density}, less than the lightest foam: is it in g/cm³? Then write {}",
                significant(1e3 * density, 4)
            ));
        }
    }
    let rod_end_mm = design.rod.iter().map(|piece| piece.to_mm.value());
    let rod_end_mm = rod_end_mm.fold(0.0, f64::max);
    if !design.rod.is_empty() && rod_end_mm < tip_mm * (1.0 - 1e-9) {
        warnings.push(format!(
            "the rod ends at {} mm and the wing at {} mm: outboard of the rod the film alone makes the leading edge",
            number(rod_end_mm, 1),
            number(tip_mm, 1)
        ));
    }
    let thinnest_mm = design
        .rod
        .iter()
        .filter_map(|piece| smallest_size_mm(&piece.section));
    let thinnest_mm = thinnest_mm.fold(f64::INFINITY, f64::min);
    if let Some(film) = &design.film {
        let thickness_mm = film.thickness_mm.value();
        if film.compression == FilmCompression::TensionField && thickness_mm > thinnest_mm / 3.0 {
            warnings.push(format!(
                "the film is {thickness_mm} mm thick, more than a third of the thinnest rod ({thinnest_mm} mm): it will not \
                 wrinkle as film.compression = \"tension-field\" has it; \"carries\" is nearer, or check the unit"
            ));
        }
    }
    if design.steady.is_some() && design.air.coefficients == Coefficients::Dickinson {
        warnings.push(
            "the Dickinson coefficients were measured on a flapping wing, whose leading-edge vortex does not stall; in a \
             steady stream they promise too much lift at large angles (air.coefficients = \"table\" takes measured ones)"
                .to_string(),
        );
    }
    warnings
}

/// The smallest outer size of a section that has one, mm.
fn smallest_size_mm(section: &Section) -> Option<f64> {
    match section {
        Section::Round { diameter_mm } => Some(diameter_mm.value()),
        Section::HalfRound { diameter_mm, .. } => Some(0.5 * diameter_mm.value()),
        Section::Tube {
            outer_diameter_mm, ..
        } => Some(outer_diameter_mm.value()),
        Section::Rectangle {
            width_mm,
            thickness_mm,
        } => Some(width_mm.value().min(thickness_mm.value())),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn design(steady: bool, film_mm: f64, rod_end_mm: f64) -> Design {
        let steady = if steady {
            "[steady]\nspeed_m_s = 5.0\nroot_angle_deg = 5.0\n"
        } else {
            ""
        };
        let text = format!(
            "format = 1\nname = 'w'\n[planform]\nlength_mm = 100.0\noutline = [[0.0, 20.0], [100.0, 20.0]]\n{steady}\
             [[rod]]\nfrom_mm = 0.0\nto_mm = {rod_end_mm:?}\nmaterial = 'm'\n\
             section = {{ shape = 'round', diameter_mm = 0.6 }}\n\
             [film]\nmaterial = 'm'\nthickness_mm = {film_mm:?}\n\
             [material.m]\ne_gpa = 3.0\ng_gpa = 1.0\ndensity_kg_m3 = 1000.0\n"
        );
        Design::from_toml(&text, "w.toml").unwrap_or_else(|error| panic!("{error}"))
    }

    #[test]
    fn an_outline_whose_tip_has_a_chord_is_not_cut() {
        assert_eq!(design(false, 0.01, 100.0).planform.tip_cut.value(), 1.0);
    }

    #[test]
    fn a_short_rod_a_thick_film_and_flapping_coefficients_in_a_stream_are_minded_and_nothing_else() {
        assert_eq!(
            of_design(&design(false, 0.01, 100.0), 100.0),
            Vec::<String>::new()
        );
        for (wing, words) in [
            (
                design(false, 0.01, 80.0),
                "the rod ends at 80.0 mm and the wing at 100.0 mm",
            ),
            (design(false, 0.3, 100.0), "0.3 mm thick, more than a third"),
            (design(true, 0.01, 100.0), "Dickinson"),
        ] {
            let warnings = of_design(&wing, 100.0);
            assert!(warnings.len() == 1 && warnings[0].contains(words), "{warnings:?}");
        }
    }
}
