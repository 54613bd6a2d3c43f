//! Marks in video frames against the wing that was filmed: what comes back, with which error.

use std::path::Path;

use nalgebra::{Rotation2, Vector2};
use washout::coupling;
use washout::coupling::solution::Solution;
use washout::geometry::Planform;
use washout::input::design::{CameraAxis, Design, Instrument};
use washout::input::study::RulerKind;
use washout::input::video::{
    Along, LoadedVideo, Mark, References, Turn, Video, VideoFrame, VideoStation, View,
};
use washout::mesh::{self, ChordLines};
use washout::observation::camera::Camera;
use washout::observation::edges::{Edges, edges_at};
use washout::observation::{Observer, ruler_hints, twist_from_video};
use washout::progress::Progress;
use washout::study::draws::Draws;

const PX_PER_MM: f64 = 9.0;
const SIGMA_PX: f64 = 0.7;

fn mark(at: Vector2<f64>) -> Mark {
    Mark {
        line: 1,
        x_px: at.x,
        y_px: at.y,
        clicks: 1,
        scatter_px2: 0.0,
    }
}

/// A point on the frame: px, y down, the camera rolled and its corner anywhere.
fn shot(image_m: Vector2<f64>, roll: f64, px_per_mm: f64) -> Mark {
    let at = Rotation2::new(roll) * image_m * (1e3 * px_per_mm);
    mark(Vector2::new(812.0 + at.x, 407.0 - at.y))
}

fn video(view: View, rest: Option<VideoFrame>, frames: Vec<VideoFrame>) -> LoadedVideo {
    LoadedVideo {
        video: Video {
            format: 1,
            name: "test".to_string(),
            source: String::new(),
            marks: "marks.csv".to_string(),
            rest: rest.as_ref().map(|rest| rest.name.clone()),
            sigma_px: Some(SIGMA_PX),
            view,
            references: Some(References {
                distance_mm: Some(30.0),
                sigma_mm: Some(0.2),
            }),
        },
        marks_file: "marks.csv".to_string(),
        rest,
        frames,
    }
}

fn view(along: Along) -> View {
    View {
        along,
        washout: (along == Along::Span).then_some(Turn::Counterclockwise),
        zero_sigma_deg: None,
        root_angle_deg: (along != Along::Span).then_some(45.0),
        root_angle_sigma_deg: (along != Along::Span).then_some(1.0),
    }
}

/// All marks of all frames.
fn marks(video: &mut LoadedVideo) -> Vec<&mut Mark> {
    let frames = video.frames.iter_mut().chain(&mut video.rest);
    let mut all = Vec::new();
    for frame in frames {
        all.extend(frame.references.iter_mut().flatten());
        for station in &mut frame.stations {
            all.push(&mut station.leading);
            all.push(&mut station.trailing);
        }
    }
    all
}

/// The same video clicked again, with errors.
fn clicked(video: &LoadedVideo, draws: &Draws, take: u64) -> LoadedVideo {
    let mut video = video.clone();
    for (index, mark) in marks(&mut video).into_iter().enumerate() {
        mark.x_px += SIGMA_PX * draws.normal(take, 2 * index as u64);
        mark.y_px += SIGMA_PX * draws.normal(take, 2 * index as u64 + 1);
    }
    video
}

/// Twist v2 on a coarse mesh, solved.
fn wing() -> (Design, Planform, Solution) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("designs/twist-v2.toml");
    let loaded = Design::load(&path, &["mesh.chordwise=6".to_string()]).unwrap();
    let planform = Planform::from_design(&loaded.design).unwrap();
    let mesh = mesh::generate(&loaded.design, &planform).unwrap();
    let solution = coupling::solve(&loaded.design, &mesh, None, &Progress::quiet()).unwrap();
    (loaded.design, planform, solution)
}

#[test]
fn a_solved_wing_filmed_along_span_stroke_and_axis_comes_back_as_the_model_reads_it() {
    let (mut design, planform, solution) = wing();
    let stations_mm = [18.9, 35.0, 51.1, 60.0, 67.2];
    let lines = ChordLines::new(&solution.mesh);
    for along in [Along::Span, Along::Stroke, Along::FlappingAxis] {
        // span: y to the right, z up, seen against the span; otherwise span to the right
        let axis = match along {
            Along::FlappingAxis => CameraAxis::FlappingAxis,
            _ => CameraAxis::Stroke,
        };
        design.observation.camera_axis = Some(axis);
        let camera = Camera {
            axis,
            root_angle_rad: 45f64.to_radians(),
            distance_error_m: 0.0,
        };
        let seen = camera.seen_direction();
        let project = |point: &nalgebra::Vector3<f64>| match along {
            Along::Span => Vector2::new(point.y, point.z),
            _ => Vector2::new(point.x, point.dot(&seen)),
        };
        let frame = |name: &str, loaded: bool, roll: f64, px_per_mm: f64| {
            let station = |r_mm: &f64| {
                let shapes = [&solution.rest, &solution.state];
                let r_m = 1e-3 * r_mm;
                let [rest, state] =
                    edges_at(&solution.mesh, &lines, shapes, r_m, planform.chord_m(r_m)).unwrap();
                let edges: Edges = if loaded { state } else { rest };
                VideoStation {
                    r_mm: *r_mm,
                    chord_mm: None,
                    leading: shot(project(&edges.leading_m), roll, px_per_mm),
                    trailing: shot(project(&edges.trailing_m), roll, px_per_mm),
                }
            };
            VideoFrame {
                name: name.to_string(),
                stations: stations_mm.iter().map(station).collect(),
                references: Some([
                    shot(Vector2::new(-0.01, 0.02), roll, px_per_mm),
                    shot(Vector2::new(0.02, 0.02), roll, px_per_mm),
                ]),
            }
        };
        // between the frames the camera rolled by 2 deg and zoomed by 3 %; the references say so
        let rest = frame("rest", false, 0.3, PX_PER_MM);
        let loaded = frame("mid", true, 0.335, 1.03 * PX_PER_MM);
        let video = video(view(along), Some(rest), vec![loaded]);
        let instrument = match along {
            Along::Span => Instrument::ChordRotation,
            _ => Instrument::Camera,
        };
        let observer = Observer::new(&design, &planform, &solution)
            .unwrap()
            .seen_by(instrument)
            .unwrap();
        let exact = twist_from_video(&video);
        let noisy = twist_from_video(&clicked(&video, &Draws::new(3), 0));
        let mut chi_squared = 0.0;
        for ((reading, noisy), r_mm) in exact.readings.iter().zip(&noisy.readings).zip(stations_mm) {
            let model = observer.twist(1e-3 * r_mm).unwrap();
            let off_deg = (reading.twist_rad - model.twist_rad).to_degrees();
            println!(
                "{along:?} {r_mm}: {:.4} deg, off {off_deg:.1e}",
                model.twist_rad.to_degrees()
            );
            assert!(off_deg.abs() < 1e-9, "{along:?} {reading:?} {model:?}");
            assert_eq!(reading.bound, model.bound);
            chi_squared += ((noisy.twist_rad - model.twist_rad) / noisy.sigma_rad).powi(2);
        }
        // 5 degrees of freedom; the error of the references, which all share, is small here
        assert!((0.2..20.0).contains(&chi_squared), "{along:?}: {chi_squared}");
    }
}

/// A chord of 18 mm turned by 12 deg in three views, with and without a frame of the untwisted wing.
fn one_chord(along: Along, has_rest: bool) -> LoadedVideo {
    let (chord_m, root, twist) = (0.018, 45f64.to_radians(), 12f64.to_radians());
    let image = |theta: f64| match along {
        Along::Span => Vector2::new(theta.cos(), theta.sin()) * chord_m,
        Along::Stroke => Vector2::new(0.0, -(root - theta).sin() * chord_m),
        Along::FlappingAxis => Vector2::new(0.0, (root - theta).cos() * chord_m),
    };
    let frame = |name: &str, theta: f64| VideoFrame {
        name: name.to_string(),
        stations: vec![VideoStation {
            r_mm: 40.0,
            chord_mm: Some(1e3 * chord_m),
            leading: shot(Vector2::zeros(), 0.0, PX_PER_MM),
            trailing: shot(image(theta), 0.0, PX_PER_MM),
        }],
        references: Some([
            shot(Vector2::new(0.0, 0.01), 0.0, PX_PER_MM),
            shot(Vector2::new(0.03, 0.01), 0.0, PX_PER_MM),
        ]),
    };
    let rest = has_rest.then(|| frame("rest", 0.0));
    video(view(along), rest, vec![frame("loaded", twist)])
}

#[test]
fn the_errors_to_first_order_are_those_of_many_clicked_videos() {
    let draws = Draws::new(11);
    let takes = 6000;
    for along in [Along::Span, Along::Stroke, Along::FlappingAxis] {
        for has_rest in [true, false] {
            let video = one_chord(along, has_rest);
            let stated = twist_from_video(&video);
            assert!((stated.readings[0].twist_rad.to_degrees() - 12.0).abs() < 1e-9);
            let twist = |take: u64| {
                twist_from_video(&clicked(&video, &draws, take)).readings[0]
                    .twist_rad
                    .to_degrees()
            };
            let found: Vec<f64> = (0..takes).map(twist).collect();
            let mean = found.iter().sum::<f64>() / takes as f64;
            let variance = found.iter().map(|t| (t - mean).powi(2)).sum::<f64>() / (takes - 1) as f64;
            // clicks on the reference points are part of the scatter of one reading
            let clicks = stated
                .shared
                .iter()
                .filter(|shared| shared.why.starts_with("clicks"));
            let shared: f64 = clicks.map(|shared| shared.moves_rad[0].powi(2)).sum();
            let expected = (stated.readings[0].sigma_rad.powi(2) + shared)
                .sqrt()
                .to_degrees();
            println!(
                "{along:?}, at rest {has_rest}: {:.4} deg drawn, {expected:.4} to first order",
                variance.sqrt()
            );
            // 6000 draws tell a standard deviation to 0.9 %
            assert!((variance.sqrt() / expected - 1.0).abs() < 0.03);
            assert!((mean - 12.0).abs() < 0.05 * expected.max(0.1));
        }
    }
}

#[test]
fn shared_errors_are_what_a_wrong_angle_and_a_wrong_distance_do() {
    for along in [Along::Stroke, Along::FlappingAxis] {
        for has_rest in [true, false] {
            let video = one_chord(along, has_rest);
            let stated = twist_from_video(&video);
            let moved = |why: &str| {
                let found = stated.shared.iter().find(|shared| shared.why.starts_with(why));
                found.map_or(0.0, |shared| shared.moves_rad[0].to_degrees())
            };
            let twist = |change: &dyn Fn(&mut LoadedVideo)| {
                let mut video = video.clone();
                change(&mut video);
                twist_from_video(&video).readings[0].twist_rad.to_degrees()
            };
            let turned = |deg: f64| twist(&|v| v.video.view.root_angle_deg = Some(45.0 + deg));
            let slope = (turned(0.01) - turned(-0.01)) / 0.02;
            assert!(
                (moved("root angle") - slope).abs() < 1e-4,
                "{} {slope}",
                moved("root angle")
            );
            let far = |mm: f64| {
                twist(&|v| v.video.references.as_mut().unwrap().distance_mm = Some(30.0 + mm)) - 12.0
            };
            let slope = 0.2 * (far(0.01) - far(-0.01)) / 0.02;
            assert!(
                (moved("distance") - slope).abs() < 1e-4,
                "{} {slope}",
                moved("distance")
            );
            assert_eq!(has_rest, slope == 0.0);
        }
    }
}

#[test]
fn a_wrong_root_angle_is_a_scale_and_a_rolled_camera_an_offset() {
    // root to tip: 2, 6 and 12 deg
    let root = 45f64.to_radians();
    let mut stroke = one_chord(Along::Stroke, true);
    for frame in stroke.frames.iter_mut().chain(&mut stroke.rest) {
        let (is_rest, first) = (frame.name == "rest", frame.stations[0].clone());
        frame.references = None;
        let station = |(k, twist_deg): (usize, f64)| {
            let theta = if is_rest { 0.0 } else { twist_deg.to_radians() };
            let image = Vector2::new(0.0, -(root - theta).sin() * 0.018);
            VideoStation {
                r_mm: 20.0 * (k + 1) as f64,
                trailing: shot(image, 0.0, PX_PER_MM),
                ..first.clone()
            }
        };
        frame.stations = [2.0, 6.0, 12.0].into_iter().enumerate().map(station).collect();
    }
    let hints = ruler_hints(&twist_from_video(&stroke));
    let [hint] = &hints[..] else { panic!("{hints:?}") };
    // to first order in the twist the share is 2 δ / sin 2α_root per δ = 1 deg: 3.5 %
    assert!(
        hint.kind == RulerKind::Scale && (hint.sigma / 0.0349 - 1.0).abs() < 0.25,
        "{hint:?}"
    );
    assert!(hint.same_in_all && hint.leaves_deg < 0.05, "{hint:?}");
    let mut span = one_chord(Along::Span, true);
    span.video.view.zero_sigma_deg = Some(0.5);
    for frame in span.frames.iter_mut().chain(&mut span.rest) {
        frame.references = None;
    }
    let hints = ruler_hints(&twist_from_video(&span));
    let [hint] = &hints[..] else { panic!("{hints:?}") };
    assert!(
        hint.kind == RulerKind::Offset && (hint.sigma - 0.5).abs() < 1e-9 && !hint.same_in_all,
        "{hint:?}"
    );
}

#[test]
fn at_a_fold_the_error_stays_finite_and_the_reading_is_a_bound() {
    let mut video = one_chord(Along::FlappingAxis, true);
    // as long as the chord itself: feathered
    let length = PX_PER_MM * 18.0;
    for long in [0.995, 1.0, 1.01] {
        video.frames[0].stations[0].trailing = mark(Vector2::new(812.0, 407.0 - long * length));
        let reading = &twist_from_video(&video).readings[0];
        println!("{long}: {reading:?}");
        assert!(reading.bound != washout::input::measurement::Bound::None);
        let sigma_deg = reading.sigma_rad.to_degrees();
        // shares √2 0.7 px/162 px and /114.6 px of a chord that is seen whole: √(2 · 0.01058) = 8.3 deg at the fold
        let at_fold_deg = 8.34;
        assert!(
            sigma_deg > 0.7 * at_fold_deg && sigma_deg < 1.02 * at_fold_deg,
            "{sigma_deg}"
        );
    }
}
