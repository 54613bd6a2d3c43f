//! Where an effect acts on a wing, found by holding the wing with it against the wing without.

use washout::coupling::wing::Wing;
use washout::coupling::{Difference, solve};
use washout::mesh::BeamPart;
use washout::progress::Progress;
use washout::wing::WingModel;

/// The paper's second twisting wing with keys set, against that without effect; and the wing without.
fn acts(sets: &[&str]) -> (WingModel, Difference) {
    let open = |sets: &[&str]| WingModel::open("designs/twist-v2.toml", sets).unwrap();
    let (view, coarse) = ("observation.camera_axis=stroke", "mesh.refine=0.5");
    let plain = open(&[view, coarse]);
    let with = open(&[&[view, coarse], sets].concat());
    let solution = solve(plain.design(), &plain.mesh, None, &Progress::quiet()).unwrap();
    let [with, without] = [&with, &plain].map(|model| Wing::new(model.design(), &model.mesh, None).unwrap());
    let difference = with.difference(&without, &solution.state).unwrap();
    (plain, difference)
}

#[test]
fn torsion_lost_outboard_changes_the_rod_from_there_on_and_nothing_else() {
    let (wing, found) = acts(&[
        "effects.rod-torsion-loss.strength=0.5",
        "effects.rod-torsion-loss.from=0.6",
    ]);
    let from_m = 0.6 * wing.mesh.nodes[*wing.mesh.rod_nodes().last().unwrap()][0];
    let is_outboard = |beam: &washout::mesh::BeamElement| {
        let outer_m = beam
            .nodes
            .map(|node| wing.mesh.nodes[node][0])
            .into_iter()
            .fold(0.0, f64::max);
        matches!(beam.part, BeamPart::Rod(_)) && outer_m > from_m
    };
    let outboard = (0..wing.mesh.beams.len()).filter(|&beam| is_outboard(&wing.mesh.beams[beam]));
    assert_eq!(found.beams, outboard.collect::<Vec<_>>());
    let rest = Difference {
        beams: Vec::new(),
        ..found
    };
    assert_eq!(rest, Difference::default());
}

#[test]
fn a_root_that_gives_way_changes_the_first_element_though_sections_are_numbered_otherwise() {
    let (wing, found) = acts(&["effects.root-flexure.strength=0.5"]);
    let [only] = found.beams[..] else {
        panic!("{:?}", found.beams);
    };
    assert_eq!(wing.mesh.beams[only].nodes[0], wing.mesh.rod_nodes()[0]);
    assert!(found.triangles.is_empty() && found.nodes.is_empty() && found.air_n_per_m.is_empty());
}

#[test]
fn a_tip_loss_changes_the_air_alone_and_most_at_the_tip() {
    let (_, found) = acts(&["effects.tip-loss-prandtl.strength=1"]);
    assert!(found.beams.is_empty() && found.triangles.is_empty() && found.nodes.is_empty());
    let lost = |row: &[f64; 3]| 1.0 - row[2] / row[1];
    let (first, last) = (
        found.air_n_per_m.first().unwrap(),
        found.air_n_per_m.last().unwrap(),
    );
    assert!(lost(first) < 0.1 && lost(last) > 0.3, "{first:?} {last:?}");
}

#[test]
fn a_tensioned_film_changes_every_triangle_and_a_camera_nothing() {
    let (wing, film) = acts(&["effects.film-cure-tension.strength=2"]);
    assert_eq!(film.triangles.len(), wing.mesh.triangles.len());
    assert!(film.beams.is_empty() && film.air_n_per_m.is_empty());
    let (_, camera) = acts(&["effects.camera-tilt.strength=2"]);
    assert_eq!(camera, Difference::default());
}

#[test]
fn a_wing_knows_whether_its_film_wrinkles() {
    let wrinkles = |sets: &[&str]| {
        let model = WingModel::open("designs/twist-v2.toml", sets).unwrap();
        let wing = Wing::new(model.design(), &model.mesh, None).unwrap();
        wing.has_film_that_wrinkles()
    };
    assert!(wrinkles(&["mesh.refine=0.5"]));
    assert!(!wrinkles(&["mesh.refine=0.5", "film.compression=carries"]));
}
