//! A number that is not finite never counts as an equilibrium: every load path is poisoned once, and the place is told.

mod designs;

mod paths;

mod poison;

use std::sync::Once;

use washout::coupling::{self, CouplingError};
use washout::effects::register;
use washout::input::design::Design;
use washout::mesh::for_design;
use washout::progress::Progress;

use poison::{PoisonedAir, PoisonedKinematics, PoisonedWing};

/// A half-round carbon rod of 70 mm with a film over two spars that flaps, and `more`.
fn wing(more: &str) -> Design {
    static REGISTERED: Once = Once::new();
    REGISTERED.call_once(|| {
        register(vec![&PoisonedWing, &PoisonedAir, &PoisonedKinematics]).expect("the first to register");
    });
    let text = format!(
        "format = 1\nname = 'w'\n[planform]\nlength_mm = 70.0\nroot_offset_mm = 38.0\ntip_cut = 1.0\n\
         outline = [[0.0, 20.0], [70.0, 20.0]]\n[mesh]\nrefine = 0.5\n\
         [[rod]]\nfrom_mm = 0.0\nto_mm = 70.0\nmaterial = 'steel'\nsection = {{ shape = 'round', diameter_mm = 0.7 }}\n\
         [material.steel]\ne_gpa = 200.0\ng_gpa = 80.0\npoisson = 0.25\ndensity_kg_m3 = 8000.0\n\
         [film]\nmaterial = 'steel'\nthickness_mm = 0.05\nresidual_compression = 1.0\n\
         [flapping]\nfrequency_hz = 20.0\nhalf_amplitude_deg = 30.0\n{more}"
    );
    Design::from_toml(&text, "w.toml").unwrap_or_else(|error| panic!("{error}"))
}

/// The same with a poison of a kind (see `poison`).
fn poisoned(name: &str, kind: usize, more: &str) -> Design {
    wing(&format!(
        "{more}[effects.{name}]\nstrength = 1.0\nkind = {kind}\n"
    ))
}

/// What a solve says that must be refused for a number that is not finite.
fn refused(design: &Design, what: &str) -> String {
    let (_, mesh) = for_design(design, None).unwrap_or_else(|error| panic!("{what}: {error}"));
    match coupling::solve(design, &mesh, None, &Progress::quiet()) {
        Ok(solution) => panic!("{what}: solved, residual {:?}", solution.report.residual),
        Err(error) => {
            assert!(
                matches!(error, CouplingError::NotFinite { .. }),
                "{what}: {error}"
            );
            assert!(error.is_not_converged(), "{what}: {error}");
            error.to_string()
        }
    }
}

#[test]
fn the_wing_without_poison_has_an_equilibrium() {
    for name in ["poisoned-air", "poisoned-wing"] {
        let design = wing(&format!("[effects.{name}]\nstrength = 0.0\nkind = 1\n"));
        let (_, mesh) = for_design(&design, None).unwrap();
        let solved = coupling::solve(&design, &mesh, None, &Progress::quiet());
        assert!(solved.unwrap().report.residual.unwrap() < 1e-5);
    }
}
