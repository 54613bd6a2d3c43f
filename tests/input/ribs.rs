//! Wings of ribs, gravity under a pitched root, displacements: what is refused, and with which message.

use washout::input::Design;
use washout::input::measurement::Measurement;

const BEAM: &str = "format = 1
name = \"beam\"

[planform]
length_mm = 450.0
outline = [[0.0, 50.0], [450.0, 50.0]]
base_closure = 0.0
tip_cut = 1.0

[ribs]
bays = 16
rod_chord_fraction = 0.5

[[rod]]
from_mm = 0.0
to_mm = 450.0
section = { shape = \"given\", ea_n = 1e6, gj_n_m2 = 1.0, ei_flap_n_m2 = 0.5, ei_edge_n_m2 = 20.0 }

[[load]]
at_mm = 450.0
mass_kg = 0.1

[gravity]
acceleration_m_s2 = [0.0, 0.0, -9.8]
";

fn message(text: &str) -> String {
    match Design::from_toml(text, "beam.toml") {
        Ok(_) => "(accepted)".to_string(),
        Err(error) => error.to_string(),
    }
}

#[test]
fn a_beam_with_ribs_is_accepted_and_reads_back() {
    let design = Design::from_toml(BEAM, "beam.toml").unwrap_or_else(|error| panic!("{error}"));
    let ribs = design.ribs.expect("ribs");
    assert_eq!((ribs.bays, ribs.rod_chord_fraction.value()), (16, 0.5));
    assert_eq!(ribs.stiffness_ratio, 1e4);
}

#[test]
fn what_does_not_go_with_ribs_is_refused_with_its_message() {
    let cases = [
        (
            "bays = 16",
            "bays = 0",
            "beam.toml:11:8: ribs.bays = 0: must lie in 1 … 1000.\n  \
             Give the number of bays between ribs at `mesh.refine` 1, e.g. bays = 16",
        ),
        (
            "rod_chord_fraction = 0.5",
            "rod_chord_fraction = 1.0",
            "beam.toml:12:22: ribs.rod_chord_fraction = 1.0: must lie in 0 … 0.95.\n  \
             Give the place of the rod behind the leading edge, as a fraction of the chord, e.g. rod_chord_fraction = 0.5",
        ),
        (
            "rod_chord_fraction = 0.5",
            "rod_chord_fraction = 0.001",
            "beam.toml:12:22: ribs.rod_chord_fraction = 0.001: lies so near to the leading edge that the ribs between them have no length.\n  \
             Write 0 for a rod on the leading edge, or 0.01 and more",
        ),
        (
            "to_mm = 450.0",
            "to_mm = 400.0",
            "beam.toml:16:9: rod[0].to_mm = 400.0: ends short of the tip at 450 mm, so that ribs outboard of it hang on nothing.\n  \
             Let the last segment end at 450 mm",
        ),
        (
            "[gravity]",
            "[film]\nmaterial = \"kapton\"\nthickness_mm = 0.006\n[material.kapton]\ne_gpa = 2.5\ndensity_kg_m3 = 1420.0\n[gravity]",
            "beam.toml:10:1: ribs cannot stand together with film.\n  \
             Keep [ribs] for a wing that is a beam, or [film] and [[spar]] for one of film",
        ),
        (
            "[gravity]",
            "[[spar]]\nat_mm = 100.0\nsection = { shape = \"given\", ea_n = 1e6, gj_n_m2 = 1.0, ei_flap_n_m2 = 0.5, ei_edge_n_m2 = 20.0 }\n[gravity]",
            "beam.toml:10:1: ribs cannot stand together with spar.\n  \
             Keep [ribs] for a wing that is a beam, or [film] and [[spar]] for one of film",
        ),
        (
            "[gravity]",
            "[mesh]\nfile = \"beam.msh\"\n[gravity]",
            "beam.toml:24:8: mesh.file = \"beam.msh\": cannot stand together with ribs.\n  \
             Delete mesh.file; a wing of ribs is meshed by the program",
        ),
        (
            "mass_kg = 0.1",
            "chord_offset_mm = 10.0",
            "beam.toml:19:1: load[0] loads nothing.\n  \
             Give force_n, moment_n_m or mass_kg, or delete the table",
        ),
        (
            "[gravity]",
            "[gravity]\nroot_pitch_deg = 200.0",
            "beam.toml:24:18: gravity.root_pitch_deg = 200.0: must lie in -180 … 180 deg.\n  \
             Give the nose-up pitch of the wing's root on its bench, by which the wing turns under the acceleration in degrees, e.g. root_pitch_deg = 45.0",
        ),
        (
            "[gravity]",
            "[observation]\nframe_pitch_deg = 200.0\n[gravity]",
            "beam.toml:24:19: observation.frame_pitch_deg = 200.0: must lie in -180 … 180 deg.\n  \
             Give the nose-up pitch of the wing's root against the frame in which displacements are read (0: the wing frame) in degrees, e.g. frame_pitch_deg = 0.0",
        ),
        // a row of weights starts with no weight
        ("mass_kg = 0.1", "mass_kg = 0.0", "(accepted)"),
    ];
    let mut wrong = Vec::new();
    for (from, to, expected) in cases {
        let found = message(&BEAM.replacen(from, to, 1));
        if found != expected {
            wrong.push(format!("{to}\n  expected: {expected}\n  found:    {found}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

const HEAD: &str =
    "case,channel,instrument,unit,sign,run,r_mm,r_to_mm,chord_fraction,value,sigma,sigma_kind,bound\n";

#[test]
fn a_displacement_has_a_place_on_the_chord_and_other_channels_have_none() {
    let rows = "a,deflection,,mm,,,450,,0.5,-10,1,assumed,none\n\
                a,deflection,,mm,,,450,,,-11,1,assumed,none\n\
                a,chordwise_displacement,,mm,,,450,,1,0.5,0.1,assumed,none\n\
                a,spanwise_displacement,,mm,,,450,,,-4,0.1,assumed,none\n\
                a,twist,chord_rotation,deg,washout,,450,,,0.1,0.01,assumed,none\n";
    let measurement =
        Measurement::from_csv(&format!("{HEAD}{rows}"), "m.csv").unwrap_or_else(|error| panic!("{error}"));
    let fractions: Vec<Option<f64>> = measurement.rows.iter().map(|row| row.chord_fraction).collect();
    assert_eq!(fractions, [Some(0.5), Some(0.0), Some(1.0), Some(0.0), None]);
    for (row, expected) in [
        (
            "a,deflection,,mm,,,450,,1.5,-10,1,assumed,none",
            "m.csv:2: chord_fraction = 1.5: must lie in 0 … 1.\n  \
             Give the place as a fraction of the chord, 0 at the leading edge, 1 at the trailing edge",
        ),
        (
            "a,twist,chord_rotation,deg,washout,,450,,0.5,1,1,assumed,none",
            "m.csv:2: chord_fraction = 0.5: only displacements have a place on the chord, not twist.\n  \
             Leave it empty",
        ),
    ] {
        let error = Measurement::from_csv(&format!("{HEAD}{row}\n"), "m.csv").unwrap_err();
        assert_eq!(error.to_string(), expected);
    }
}
