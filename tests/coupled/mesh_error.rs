//! What a mesh leaves of the twist, by the same wing on a mesh half as fine.

use washout::progress::Progress;
use washout::wing::{Meshes, WingError, WingModel};

fn wing(name: &str, refine: f64) -> WingModel {
    let path = format!("{}/designs/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    WingModel::open(path, &[&format!("mesh.refine={refine}")]).expect("a wing")
}

fn tip_deg(model: &WingModel) -> f64 {
    let solved = model.solve(&Progress::quiet()).expect("solved");
    solved.tip_twist_deg().expect("seen").expect("a tip")
}

#[test]
fn what_a_mesh_leaves_is_the_difference_to_the_mesh_half_as_fine() {
    let meshes = Meshes::solve(&wing("twist-v2", 0.5), &Progress::quiet()).expect("solved");
    let found = meshes.error().expect("an error");
    let expected = (tip_deg(&wing("twist-v2", 0.5)) - tip_deg(&wing("twist-v2", 0.25))).abs();
    assert_eq!(found.coarser_refine, Some(0.25));
    assert_eq!(found.tip_twist_deg.map(f64::to_bits), Some(expected.to_bits()));
    assert!(found.largest_twist_deg >= found.tip_twist_deg && found.lift_mn > Some(0.0));
    assert!(expected > 0.1, "{expected}: this wing's free film shows its mesh");
}

#[test]
fn a_mesh_is_refined_until_it_leaves_what_was_asked_for() {
    let coarse = wing("twist-v2", 0.25);
    let meshes = Meshes::until(&coarse, 0.025, &Progress::quiet()).expect("reached");
    let (refine, error) = (
        meshes.wing.model.design().mesh.refine,
        meshes.error().expect("an error"),
    );
    let tip = meshes.wing.tip_twist_deg().expect("seen").expect("a tip");
    assert_eq!((refine, error.coarser_refine), (0.5, Some(0.25)));
    assert!(error.tip_twist_deg <= Some(0.025 * tip));
    assert_eq!(tip.to_bits(), tip_deg(&wing("twist-v2", 0.5)).to_bits());
}

#[test]
fn what_no_mesh_reaches_is_refused_and_a_mesh_too_coarse_to_halve_says_so() {
    let finest = wing("twist-v1", 0.19);
    let error = Meshes::until(&finest, 1e-9, &Progress::quiet()).expect_err("not known");
    assert!(matches!(error, WingError::Question { .. }), "{error}");
    let known = Meshes::solve(&finest, &Progress::quiet())
        .expect("solved")
        .error()
        .expect("an error");
    assert_eq!(known.tip_twist_deg, None);
    assert!(
        known
            .unknown_because
            .is_some_and(|reason| reason.contains("mesh.refine = 0.095"))
    );
}
