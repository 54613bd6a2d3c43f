//! Effects of a damaged rod: for each the case of its card, a closed form in the full model.

use washout::coupling::wing::Wing;
use washout::input::design::{Design, Flat, Section};
use washout::mesh::for_design;

use crate::closed_forms::{rectangle, with};
use crate::structure_forms::{
    FORCE, TORQUE, also, assert_near, end_of_rod, relative_deflection, relative_twist,
};

/// Half of it at half the stiffness: ½ + ½ · 2; with the station inside an element: 0.53 + 0.47 · 2.
#[test]
fn a_rod_that_is_half_as_stiff_from_the_middle_on_twists_by_half_more() {
    let from = |station: f64| {
        let design = with(rectangle(TORQUE), "rod-ends-early", 0.5);
        relative_twist(&also(design, "effects.rod-ends-early.from", station))
    };
    assert_near(from(0.5), 1.5, 1e-9);
    assert_near(from(0.53), 1.47, 1e-9);
    assert_near(from(0.5371), 1.4629, 1e-9);
}

/// A tenth of GJ is left from 0.3 to 0.7 of the length: 0.6 + 0.4 · 10; with the station inside an element as well. From 0.5 to the tip
/// 0.5 + 0.5 · 10.
#[test]
fn a_rod_that_lost_torsion_between_two_stations_twists_more_there_and_bends_as_before() {
    let lost = |load: &str, from: f64, to: f64| {
        let design = with(rectangle(load), "rod-torsion-loss", 0.9);
        let design = also(design, "effects.rod-torsion-loss.from", from);
        also(design, "effects.rod-torsion-loss.to", to)
    };
    assert_near(relative_twist(&lost(TORQUE, 0.3, 0.7)), 4.6, 1e-9);
    assert_near(relative_twist(&lost(TORQUE, 0.3371, 0.7)), 4.2661, 1e-9);
    assert_near(relative_twist(&lost(TORQUE, 0.5, 1.0)), 5.5, 1e-9);
    assert_near(relative_twist(&lost(TORQUE, 0.7, 0.7)), 1.0, 1e-9);
    assert_near(
        relative_deflection(&lost(FORCE, 0.0, 1.0)),
        relative_deflection(&rectangle(FORCE)),
        1e-6,
    );
}

/// δ = F/EI ∫ (L − x)² dx with a tenth of EI from 0.3 to 0.7 of the length: 1 + 9 (0.7³ − 0.3³) = 3.844 times as far.
#[test]
fn a_rod_that_lost_bending_between_two_stations_bends_more_there_and_twists_as_before() {
    let lost = |load: &str, from: f64, to: f64| {
        let design = with(rectangle(load), "rod-bending-loss", 0.9);
        let design = also(design, "effects.rod-bending-loss.from", from);
        also(design, "effects.rod-bending-loss.to", to)
    };
    assert_near(relative_deflection(&lost(FORCE, 0.3, 0.7)), 3.844, 2e-3);
    assert_near(relative_deflection(&lost(FORCE, 0.0, 1.0)), 10.0, 1e-3);
    assert_near(relative_twist(&lost(TORQUE, 0.0, 1.0)), 1.0, 1e-9);
    let edgewise = "[[load]]\nat_mm = 100.0\nforce_n = [0.0, 1e-6, 0.0]\n";
    let across = |design: &Design| end_of_rod(design).1.y;
    let softer = across(&lost(edgewise, 0.0, 1.0)) / across(&rectangle(edgewise));
    assert_near(softer, 10.0, 1e-3);
}

/// J: 1.5708 over 2 · 0.29756 a⁴; I: 0.7854 over 2 · 0.10976 a⁴.
#[test]
fn a_split_rod_twists_by_the_ratio_of_two_halves_to_the_whole() {
    let split = |load: &str| {
        let design = with(rectangle(load), "rod-split", 1.0);
        also(design, "effects.rod-split.from", 0.0)
    };
    assert_near(relative_twist(&split(TORQUE)), 2.6395, 1e-4);
    assert_near(relative_deflection(&split(FORCE)), 3.5779, 1e-3);
}

/// Three strips of a rectangle, s = (3² − 1)/3, keep a ninth in bending, exactly. Two of a strip of 10 × 0.1 mm a quarter in torsion but for its
/// ends: J = β b t³, 4 · 0.331233 / 0.332283; of half a circle, flat in the plane, 1/3.007.
#[test]
fn strips_of_a_split_rod_keep_one_over_their_number_squared() {
    let of = |section: Section, strength: f64, read: &dyn Fn(&Design) -> f64| {
        let split = |strength: f64, load: &str| {
            let mut design = rectangle(load);
            design.rod[0].section = section.clone();
            let design = with(design, "rod-split", strength);
            also(design, "effects.rod-split.from", 0.0)
        };
        let [load, other] = [FORCE, TORQUE].map(|load| [0.0, strength].map(|s| read(&split(s, load))));
        [load[1] / load[0], other[1] / other[0]]
    };
    let bent = |design: &Design| end_of_rod(design).1.z;
    let turned = |design: &Design| end_of_rod(design).0.x;
    let strip = |width: f64, thickness: f64| Section::Rectangle {
        width_mm: width.into(),
        thickness_mm: thickness.into(),
    };
    let [bending, _] = of(strip(2.0, 0.5), 8.0 / 3.0, &bent);
    assert_near(bending, 9.0, 1e-3);
    let [_, torsion] = of(strip(10.0, 0.1), 1.0, &turned);
    assert_near(torsion, 4.0 * 0.331_233 / 0.332_283, 1e-4);
    let half = Section::HalfRound {
        diameter_mm: 1.0.into(),
        flat: Flat::InPlane,
    };
    let [_, torsion] = of(half, 1.0, &turned);
    assert_near(torsion, 3.007, 1e-4);
}

#[test]
fn a_tube_and_a_beam_of_given_stiffness_do_not_split() {
    let mut design = rectangle(TORQUE);
    design.rod[0].section = Section::Tube {
        outer_diameter_mm: 1.0.into(),
        inner_diameter_mm: 0.6.into(),
    };
    let split = with(design, "rod-split", 1.0);
    let (_, mesh) = for_design(&split, None).unwrap();
    let refused = Wing::new(&split, &mesh, None).unwrap_err().to_string();
    assert!(refused.contains("no solid rod"), "{refused}");
}
