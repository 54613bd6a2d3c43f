//! For each effect of the picture the case of its card, on a wing that is solved: lines of sight from a camera to its edges.

use std::fs;
use std::path::Path;

use nalgebra::Vector3;
use washout::coupling::BladeAir;
use washout::coupling::sensitivity::Nearby;
use washout::effects::ALL;
use washout::input::design::{Design, Instrument};
use washout::input::study::LoadedStudy;
use washout::observation::Observer;
use washout::progress::Progress;
use washout::study::{Campaign, Forward};

use super::closed_forms::with;
use super::{ribs, solve};

/// Length, chord, root angle, flapping axis and half of the stroke of [`ribs`].
const LENGTH_M: f64 = 0.07;
const CHORD_M: f64 = 0.02;
const ROOT_RAD: f64 = std::f64::consts::FRAC_PI_4;
const OFFSET_M: f64 = 0.038;
const HALF_AMPLITUDE_DEG: f64 = 34.5;
const AXES: [&str; 2] = ["stroke", "flapping-axis"];

fn seen_along(axis: &str) -> Design {
    ribs(&format!(
        "[observation]\ninstrument = 'camera'\ncamera_axis = '{axis}'\n"
    ))
}

fn read_deg(solved: &Nearby, instrument: Instrument, share: f64) -> f64 {
    let observer = Observer::new(&solved.design, &solved.planform, &solved.solution).unwrap();
    let observer = observer.seen_by(instrument).unwrap();
    observer.twist(share * LENGTH_M).unwrap().twist_rad.to_degrees()
}

/// Leading and trailing edge at a share of the span, at rest and as the wing is.
fn edges(solved: &Nearby, share: f64) -> [[Vector3<f64>; 2]; 2] {
    let r_m = share * LENGTH_M;
    let observer = Observer::new(&solved.design, &solved.planform, &solved.solution).unwrap();
    let rest = [0.0, CHORD_M].map(|y| Vector3::new(r_m, y, 0.0));
    let moved = [0.0, 1.0].map(|fraction| observer.displacement(r_m, fraction).unwrap());
    [rest, [rest[0] + moved[0], rest[1] + moved[1]]]
}

/// Stroke (downstream) and flapping axis (toward lift).
fn directions() -> [Vector3<f64>; 2] {
    let (sin, cos) = ROOT_RAD.sin_cos();
    [Vector3::new(0.0, cos, sin), Vector3::new(0.0, -sin, cos)]
}

/// Twist that an observer reads who draws lines of sight from the camera and cuts them with the plane through its aim.
fn by_lines_of_sight(
    axis: &str,
    nearness_per_m: f64,
    swing_rad: f64,
    [rest, loaded]: [[Vector3<f64>; 2]; 2],
) -> f64 {
    let [stroke, flapping] = directions();
    let (along, across) = match axis {
        "stroke" => (stroke, flapping),
        _ => (flapping, stroke),
    };
    let aim = Vector3::new(0.5 * LENGTH_M, 0.0, 0.0);
    let shown = |point: Vector3<f64>| {
        if nearness_per_m == 0.0 {
            return point;
        }
        let camera = aim + along / nearness_per_m;
        let sight = point - camera;
        camera + sight * ((aim - camera).dot(&along) / sight.dot(&along))
    };
    // the wing runs against the stream
    let swung = |point: Vector3<f64>| {
        let (x, w, u) = (point.x + OFFSET_M, point.dot(&stroke), point.dot(&flapping));
        let (sin, cos) = swing_rad.sin_cos();
        let (x, w) = (x * cos + w * sin, w * cos - x * sin);
        Vector3::new(x - OFFSET_M, 0.0, 0.0) + stroke * w + flapping * u
    };
    let length = |[leading, trailing]: [Vector3<f64>; 2]| {
        let chord = shown(trailing) - shown(leading);
        chord.x.hypot(chord.dot(&across))
    };
    let ratio = length(loaded.map(swung)) / length(rest);
    let alpha = match axis {
        "stroke" => (ratio * ROOT_RAD.sin()).asin(),
        _ => (ratio * ROOT_RAD.cos()).min(1.0).acos(),
    };
    (ROOT_RAD - alpha).to_degrees()
}

/// 250 mm and 500 mm away, on either side: the wing is the same, what is read of it goes by lines of sight.
#[test]
fn a_near_camera_shows_what_comes_nearer_larger() {
    for axis in AXES {
        let base = solve(&seen_along(axis));
        for nearness in [4.0, 2.0, -4.0] {
            let near = solve(&with(seen_along(axis), "camera-perspective", nearness));
            assert_eq!(near.solution.state, base.solution.state);
            for share in [0.3, 0.6, 0.97] {
                let found = read_deg(&near, Instrument::Camera, share);
                let expected = by_lines_of_sight(axis, nearness, 0.0, edges(&base, share));
                let far = read_deg(&base, Instrument::Camera, share);
                println!("{axis} {nearness} {share}: {far:.3} {found:.3} {expected:.3}");
                assert!((found - expected).abs() < 1e-6, "{found} {expected}");
                assert!((found - far).abs() > 0.05, "{found} {far}");
                // the turn of the chord is no picture
                let turn = |solved: &Nearby| read_deg(solved, Instrument::ChordRotation, share);
                assert_eq!(turn(&near), turn(&base));
            }
        }
    }
}

/// θ is wrong by −(1 − tan α/tan α_root) s along the stroke, by (tan α_root/tan α − 1) s along the flapping axis.
#[test]
fn a_tilted_camera_reads_twist_wrong_by_its_share() {
    for axis in AXES {
        let base = solve(&seen_along(axis));
        let tilted = |deg: f64| solve(&with(seen_along(axis), "camera-tilt", deg));
        let both = [tilted(0.5), tilted(-0.5)];
        assert_eq!(both[0].solution.state, base.solution.state);
        for share in [0.3, 0.6, 0.97] {
            let [more, less] = [&both[0], &both[1]].map(|wing| read_deg(wing, Instrument::Camera, share));
            let twist = read_deg(&base, Instrument::Camera, share);
            let ratio = (ROOT_RAD - twist.to_radians()).tan() / ROOT_RAD.tan();
            let expected = match axis {
                "stroke" => ratio - 1.0,
                _ => 1.0 / ratio - 1.0,
            };
            println!("{axis} {share}: {twist:.2} {} {expected}", more - less);
            // what bending adds along the span does not turn
            assert!(
                ((more - less) / expected - 1.0).abs() < 0.03,
                "{more} {less} {expected}"
            );
        }
    }
}

/// 20 deg late: cos² 20 deg of the load, and the wing 34.5 deg · sin 20 deg further on.
#[test]
fn a_late_frame_shows_the_load_and_the_place_of_its_phase() {
    let swing_rad = (HALF_AMPLITUDE_DEG * 20.0f64.to_radians().sin()).to_radians();
    for axis in AXES {
        let late = solve(&with(seen_along(axis), "frame-timing", 20.0));
        let mut stated = seen_along(axis);
        stated.set("flapping.phase_deg", 20.0).unwrap();
        let stated = solve(&stated);
        for share in [0.3, 0.6, 0.97] {
            let turn = |solved: &Nearby| read_deg(solved, Instrument::ChordRotation, share);
            assert!((turn(&late) - turn(&stated)).abs() < 1e-6);
            let found = read_deg(&late, Instrument::Camera, share);
            let expected = by_lines_of_sight(axis, 0.0, swing_rad, edges(&stated, share));
            let unswung = read_deg(&stated, Instrument::Camera, share);
            println!("{axis} {share}: {unswung:.3} {found:.3} {expected:.3}");
            assert!((found - expected).abs() < 1e-5, "{found} {expected}");
            if axis == "stroke" {
                // as a chord that lies across the span: d² = c² (sin² α + cos² α sin² ψ)
                let alpha = ROOT_RAD - unswung.to_radians();
                let shown = alpha.sin().hypot(alpha.cos() * swing_rad.sin()).asin();
                let rigid = (ROOT_RAD - shown).to_degrees() - unswung;
                assert!(
                    ((found - unswung) / rigid - 1.0).abs() < 0.4,
                    "{found} {unswung} {rigid}"
                );
            }
        }
    }
}

#[test]
fn the_mean_over_the_stroke_knows_nothing_of_when_a_frame_was_taken() {
    let late = solve(&with(ribs(""), "frame-timing", 20.0));
    let air = |design: &Design| BladeAir::new(design, &late.planform, None).unwrap();
    assert!(air(&late.design).plain().is_some());
    assert!(air(&with(ribs(""), "phase-lag", 20.0)).plain().is_none());
}

/// A study of the wing at two frequencies, read by `instrument`.
fn study(folder: &Path, instrument: &str) -> LoadedStudy {
    let design = seen_along("stroke");
    fs::write(folder.join("ribs.toml"), design.to_toml()).unwrap();
    let mut rows =
        String::from("case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n");
    let mut cases = String::new();
    for hz in [14, 22] {
        for r_mm in [20, 45, 68] {
            rows += &format!("at-{hz},twist,{instrument},deg,washout,,{r_mm},,10.0,0.5,stated,none\n");
        }
        cases += &format!(
            "[[case]]\ndesign = 'ribs.toml'\nset = ['flapping.frequency_hz={hz}']\n\
             measurement = 'read.csv'\nmeasured = 'at-{hz}'\n"
        );
    }
    fs::write(folder.join("read.csv"), rows).unwrap();
    let text = format!("format = 1\nname = 'ribs'\n{cases}");
    let path = folder.join("study.toml");
    fs::write(&path, text).unwrap();
    LoadedStudy::load(&path, &[]).unwrap_or_else(|error| panic!("{error}"))
}

const OF_PICTURE: [&str; 3] = ["camera-perspective", "camera-tilt", "frame-timing"];

#[test]
fn effects_of_the_picture_are_tried_where_a_camera_reads_and_nowhere_else() {
    let named = ALL.iter().filter(|effect| effect.is_of_picture());
    let mut found: Vec<&str> = named.map(|effect| effect.card().name).collect();
    found.sort_unstable();
    assert_eq!(found, OF_PICTURE);
    let folder = tempfile::tempdir().unwrap();
    for (instrument, is_tried) in [("camera", true), ("chord_rotation", false)] {
        let study = study(folder.path(), instrument);
        let campaign = Campaign::new(&study, &OF_PICTURE, &Progress::quiet()).unwrap();
        for name in OF_PICTURE {
            let key = format!("effects.{name}.strength");
            let is_there = campaign.unknowns().iter().any(|unknown| unknown.name == key);
            assert_eq!(is_there, is_tried, "{name} by {instrument}");
        }
    }
}

/// A campaign's derivatives are those of its own predictions at finite strengths.
#[test]
fn what_a_campaign_says_of_the_picture_is_what_it_reads_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let study = study(folder.path(), "camera");
    let campaign = Campaign::new(&study, &OF_PICTURE, &Progress::quiet()).unwrap();
    let at = campaign.start();
    for (name, off, step) in [
        ("camera-perspective", 0.0, 0.05),
        ("camera-tilt", 0.0, 0.05),
        ("frame-timing", 10.0, 0.05),
    ] {
        let key = format!("effects.{name}.strength");
        let place = campaign
            .unknowns()
            .iter()
            .position(|unknown| unknown.name == key)
            .unwrap();
        let moved = |by: f64| {
            let mut at = at.clone();
            at[place] = off + by;
            at
        };
        let linear = campaign
            .linearize(&moved(0.0), &|unknown| unknown.name == key)
            .unwrap();
        let [more, less] = [step, -step].map(|by| campaign.predict(&moved(by)).unwrap());
        let slope = (more - less) / (2.0 * step);
        let rates = linear.jacobian.column(place).clone_owned();
        println!("{name} {:.4?} {:.4?}", rates.as_slice(), slope.as_slice());
        assert!(rates.norm() > 0.05, "{name}: {rates:?}");
        assert!(
            (&rates - &slope).norm() < 2e-3 * rates.norm(),
            "{name}: {rates:?} {slope:?}"
        );
    }
}
