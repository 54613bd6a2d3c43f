//! What every effect in `effects::ALL` promises, tried on every one of them: a new effect is tested before its author
//! writes a test.

mod air_forms;

mod closed_forms;

mod damage_forms;

mod motion_forms;

mod own;

mod page;

mod periodic;

mod picture_forms;

mod signatures;

mod stream_forms;

mod structure_forms;

use std::collections::BTreeSet;
use std::path::Path;

use washout::aero::Flow;
use washout::coupling::sensitivity::Nearby;
use washout::coupling::solution::Solution;
use washout::coupling::wing::Wing;
use washout::coupling::{self, Sensitivity};
use washout::effects::{ALL, Card, Effect, Need, Seam, bind, is_applicable};
use washout::geometry::Planform;
use washout::input::design::{Design, Instrument};
use washout::mesh::{Mesh, for_design};
use washout::observation::{Observer, twist_at};
use washout::progress::Progress;

/// Wings on which an effect may act; the first on which it can is used, effects of the film aside, which are tried on films.
/// Ribs and plate have no switches; a film that wrinkles has many, and its rates hold between them.
fn wings() -> Vec<(Design, f64)> {
    let plate = "[film]\nmaterial = 'steel'\nthickness_mm = 0.15\nresidual_compression = 1.0\n\
                 [flapping]\nfrequency_hz = 20.0\nhalf_amplitude_deg = 30.0\n\
                 [[spar]]\nat_mm = 50.0\nmaterial = 'steel'\nsection = { shape = 'rectangle', width_mm = 1.0, thickness_mm = 0.3 }\n";
    let film = |sets: &[&str]| (design("twist-v2", sets), 2e-4);
    vec![
        (ribs(""), 1e-5),
        (closed_forms::rectangle(plate), 1e-5),
        (
            closed_forms::rectangle(&plate.replace("30.0\n", "30.0\nphase_deg = 30.0\n")),
            1e-5,
        ),
        (
            ribs("[gravity]\nacceleration_m_s2 = [0.0, 6.934, -6.934]\n"),
            1e-5,
        ),
        (in_stream(), 1e-5),
        (ribs("[structure]\nkinematics = 'linear'\n"), 1e-5),
        (
            ribs("[observation]\ninstrument = 'camera'\ncamera_axis = 'stroke'\n"),
            1e-5,
        ),
        (ribs("[root]\npitch_stiffness_n_m_per_rad = 0.005\n"), 1e-5),
        film(&[]),
        (thin_plate(), 2e-4),
        film(&["structure.kinematics=linear", "film.pretension_n_per_m=74"]),
    ]
}

/// A plate so thin that its membrane matters and so thick that it does not buckle: a film that carries compression has many
/// shapes in one wind.
fn thin_plate() -> Design {
    let more = "[film]\nmaterial = 'steel'\nthickness_mm = 0.05\ncompression = 'carries'\n[mesh]\nchordwise = 8\n\
                [flapping]\nfrequency_hz = 20.0\nhalf_amplitude_deg = 30.0\n";
    let mut design = closed_forms::rectangle(more);
    design.set("coupling.twist_tolerance_deg", 1e-10).unwrap();
    design.set("coupling.residual_tolerance", 1e-11).unwrap();
    design
}

/// The same wing without flapping, in a stream that turns it by some degrees.
fn in_stream() -> Design {
    half_rod("[steady]\nspeed_m_s = 6.0\nroot_angle_deg = 20.0\n")
}

/// A half-round carbon rod with stiff ribs, which turns its wing by some 20 deg; and `more`.
fn ribs(more: &str) -> Design {
    half_rod(&format!(
        "[flapping]\nfrequency_hz = 22.0\nhalf_amplitude_deg = 34.5\n{more}"
    ))
}

fn half_rod(more: &str) -> Design {
    let text = format!(
        "format = 1\nname = 'ribs'\n[planform]\nlength_mm = 70.0\nroot_offset_mm = 38.0\nbase_closure = 0.0\n\
         tip_cut = 1.0\noutline = [[0.0, 20.0], [70.0, 20.0]]\n[ribs]\nbays = 10\n\
         [[rod]]\nfrom_mm = 0.0\nto_mm = 70.0\nmaterial = 'carbon'\n\
         section = {{ shape = 'half-round', diameter_mm = 1.0 }}\n\
         [material.carbon]\ne_gpa = 134.0\ng_gpa = 4.0\ndensity_kg_m3 = 1500.0\n\
         [coupling]\ntwist_tolerance_deg = 1e-9\nresidual_tolerance = 1e-11\n{more}"
    );
    Design::from_toml(&text, "ribs.toml").unwrap_or_else(|error| panic!("{error}"))
}

const COARSE: [&str; 3] = [
    "mesh.refine=0.5",
    "coupling.twist_tolerance_deg=1e-9",
    "coupling.residual_tolerance=1e-9",
];

fn design(name: &str, sets: &[&str]) -> Design {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("designs")
        .join(format!("{name}.toml"));
    let sets: Vec<String> = COARSE.iter().chain(sets).map(|set| set.to_string()).collect();
    Design::load(&path, &sets)
        .unwrap_or_else(|error| panic!("{error}"))
        .design
}

/// A design on which the effect can act, and how well its rates must hold there.
fn base(card: &Card) -> (Design, f64) {
    let of_film = [Need::Film, Need::WrinklingFilm, Need::CarryingFilm];
    let is_film = |design: &Design| {
        design
            .film
            .as_ref()
            .is_some_and(|film| film.thickness_mm.value() < 0.1)
    };
    let mut able = wings().into_iter().filter(|(design, _)| {
        let asks_film = of_film.iter().any(|need| card.needs.contains(need));
        // the motion over the stroke is that of a film or a plate
        let asks_surface = card.needs.contains(&Need::Motion) && design.ribs.is_some();
        is_applicable(card, design) && (is_film(design) || !asks_film) && !asks_surface
    });
    able.next()
        .unwrap_or_else(|| panic!("{} acts on none of the wings", card.name))
}

fn with(base: &Design, card: &Card, strength: f64) -> Design {
    let mut design = base.clone();
    let key = format!("effects.{}.strength", card.name);
    design
        .set(&key, strength)
        .unwrap_or_else(|error| panic!("{error}"));
    design
}

fn mesh(design: &Design) -> (Planform, Mesh) {
    for_design(design, None).unwrap()
}

fn solve(design: &Design) -> Nearby {
    solve_from(design, None)
}

fn solve_from(design: &Design, nearby: Option<&Solution>) -> Nearby {
    let (planform, mesh) = mesh(design);
    let solution = coupling::solve_from(design, &mesh, None, nearby, &Progress::quiet())
        .unwrap_or_else(|error| panic!("{:?}: {error}", design.effects));
    Nearby {
        design: design.clone(),
        planform,
        solution,
    }
}

/// Twist at three stations (rad) and the force across the stream (N).
fn readings(solved: &Nearby) -> Vec<f64> {
    let length_m = solved.planform.length_m();
    let twist = |share: f64| {
        twist_at(
            &solved.design,
            &solved.planform,
            &solved.solution,
            share * length_m,
        )
    };
    let mut values: Vec<f64> = [0.3, 0.6, 0.97].into_iter().filter_map(twist).collect();
    let flow = Flow::from_design(&solved.design).unwrap();
    let lift = flow.lift_direction();
    values.push(
        solved
            .solution
            .air_force_n
            .iter()
            .map(|f| f[1] * lift.y + f[2] * lift.z)
            .sum(),
    );
    values
}

#[test]
fn names_are_those_of_the_files_and_every_card_is_complete() {
    let mut names = BTreeSet::new();
    for effect in ALL {
        let card = effect.card();
        assert!(names.insert(card.name), "{} stands twice", card.name);
        let file = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("crates/washout-wing/src/effects")
            .join(format!("{}.rs", card.name.replace('-', "_")));
        assert!(file.is_file(), "{} is not in a file of its name", card.name);
        for (what, text) in [
            ("family", card.family),
            ("summary", card.summary),
            ("formula", card.formula),
            ("source", card.source),
            ("when_right", card.when_right),
            ("gets_wrong", card.gets_wrong),
            ("case", card.case),
        ] {
            assert!(!text.trim().is_empty(), "{}: {what} is empty", card.name);
        }
        assert!(card.summary.ends_with('.'), "{}", card.name);
        assert!(!card.channels.is_empty(), "{}", card.name);
        let strength = card
            .parameters
            .first()
            .unwrap_or_else(|| panic!("{} has no strength", card.name));
        assert_eq!(
            (strength.name, strength.default),
            ("strength", 0.0),
            "{}",
            card.name
        );
        for parameter in card.parameters {
            let ([low, high], [from, to]) = (parameter.range, parameter.plausible);
            let sound = low <= from
                && from < to
                && to <= high
                && low <= parameter.default
                && parameter.default <= high;
            assert!(sound, "{}.{}: ranges", card.name, parameter.name);
            assert!(
                parameter.scale() > 0.0 && !parameter.meaning.is_empty(),
                "{}",
                card.name
            );
        }
    }
}

#[test]
fn every_case_that_a_card_names_is_a_test() {
    // in the effect's own file, or here where it takes a whole wing
    let folders = ["crates/washout-wing/src/effects", "tests/effects_contract"];
    let folders = folders.map(|folder| Path::new(env!("CARGO_MANIFEST_DIR")).join(folder));
    let files = folders
        .iter()
        .flat_map(|folder| std::fs::read_dir(folder).unwrap())
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.is_file())
        .map(|path| std::fs::read_to_string(path).unwrap());
    let tests: String = files.collect();
    for effect in ALL {
        let card = effect.card();
        assert!(
            tests.contains(&format!("fn {}()", card.case)),
            "{}: no test {} in crates/washout-wing/src/effects or tests/effects_contract",
            card.name,
            card.case
        );
    }
}

#[test]
fn off_is_bit_for_bit_off() {
    let base = design("twist-v2", &[]);
    let expected = solve(&base);
    let mut all_off = base.clone();
    for effect in ALL {
        all_off = with(&all_off, &effect.card(), 0.0);
    }
    assert_eq!(all_off.effects.len(), ALL.len());
    let found = solve(&all_off);
    assert_eq!(found.solution.state, expected.solution.state);
    assert_eq!(found.solution.air_force_n, expected.solution.air_force_n);
    let by_camera = |solved: &Nearby| {
        let observer = Observer::new(&solved.design, &solved.planform, &solved.solution).unwrap();
        observer.seen_by(Instrument::Camera).unwrap().profile()
    };
    assert_eq!(by_camera(&found), by_camera(&expected));
}

#[test]
fn effects_act_in_the_order_of_the_list_whatever_the_order_in_the_file() {
    let base = design("twist-v2", &[]);
    let able: Vec<Card> = ALL
        .iter()
        .map(|e| e.card())
        .filter(|card| is_applicable(card, &base))
        .collect();
    let mut forward = base.clone();
    for card in &able {
        forward = with(&forward, card, 0.1 * card.parameters[0].scale());
    }
    let names = |design: &Design| -> Vec<String> {
        bind(design)
            .unwrap()
            .iter()
            .map(|bound| bound.effect.card().name.to_string())
            .collect()
    };
    let expected: Vec<String> = able.iter().map(|card| card.name.to_string()).collect();
    assert_eq!(names(&forward), expected);
}

/// With the shape frozen, an effect changes the residual directly at its own seam and nowhere else.
#[test]
fn with_the_shape_frozen_an_effect_acts_at_its_seam_alone() {
    for effect in ALL {
        let card = effect.card();
        let (base, _) = base(&card);
        let on = with(&base, &card, 0.5 * card.parameters[0].scale());
        let (_, mesh) = mesh(&base);
        let [off, on] = [&base, &on].map(|design| closed_forms::wing(design, &mesh));
        let structure_changed = format!("{:?}", off.model.beams) != format!("{:?}", on.model.beams)
            || off.model.sheets != on.model.sheets
            || off.model.springs != on.model.springs
            || off.model.masses != on.model.masses
            || off.model.sections != on.model.sections
            || off.model.held != on.model.held
            || format!("{:?}", off.model.shells) != format!("{:?}", on.model.shells);
        let loads_changed = off.bench != on.bench;
        // washed out by 0.1 rad at the tip
        let mut twisted = washout::structure::state::State::at_rest(mesh.nodes.len());
        let tip_m = mesh.nodes.iter().map(|x| x[0]).fold(0.0, f64::max);
        for (moved, [x, y, _]) in twisted.displacement.iter_mut().zip(&mesh.nodes) {
            moved.z = 0.1 * x / tip_m * y;
        }
        let shapes = off.strips.shapes(&twisted);
        let force = |wing: &Wing| wing.air_force(&wing.strip_air(&shapes, false).unwrap());
        let air = [force(&off), force(&on)];
        let air_changed = air[0] != air[1];
        // a changed structure weighs and hangs differently; that is the structure's doing
        let found = (
            structure_changed,
            loads_changed && !structure_changed,
            air_changed,
        );
        let expected = match card.seam {
            Seam::Structure => (true, false, false),
            Seam::Load => (false, true, false),
            Seam::Air => (false, false, true),
            // the air's law follows the kinematics: the thin airfoil has its suction in large rotation only
            Seam::Kinematics => (false, false, air_changed),
            Seam::Picture => (false, false, false),
        };
        assert_eq!(
            found, expected,
            "{}: whether structure, loads, air change; the card says that it acts on {:?}, and what `Effect` has for that is called alone",
            card.name, card.seam
        );
    }
}

#[test]
fn coupled_an_effect_changes_the_wing_and_its_rate_is_that_of_wings_solved_again() {
    let mut wrong = Vec::new();
    for effect in ALL {
        if let Err(reason) = check_rate(*effect) {
            println!("{reason}");
            wrong.push(reason);
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Differences of fourth order by the larger of two steps, or by the smaller where films switch within the larger.
const STEPS: [f64; 2] = [0.01, 0.001];

fn check_rate(effect: &dyn Effect) -> Result<(), String> {
    let card = effect.card();
    let strength = card.parameters[0];
    // away from the ends of the range and from switches
    let [from, to] = strength.plausible;
    let middle = 0.5 * (from.max(0.0) + to);
    let (base, tolerance) = base(&card);
    let here = solve(&with(&base, &card, middle));
    let at = |value: f64| solve_from(&with(&base, &card, value), Some(&here.solution));
    let wing = closed_forms::wing(&here.design, &here.solution.mesh);
    let remesh = |design: &Design| for_design(design, None);
    let mut sensitivity = Sensitivity::new(&here.design, &wing, None, &here.solution, &remesh).unwrap();
    let rate = sensitivity
        .rate(&format!("effects.{}.strength", card.name))
        .unwrap();
    let rates = sensitivity.read(&rate, readings).unwrap();
    let largest = rates.iter().map(|r| r.abs()).fold(0.0, f64::max);
    if largest == 0.0 {
        return Err(format!("{} changes nothing", card.name));
    }
    let mut errors = Vec::new();
    for step in STEPS {
        let step = step * (to - from);
        let values = [-2.0, -1.0, 1.0, 2.0].map(|k: f64| readings(&at(middle + k * step)));
        let slope = |k: usize| {
            (values[0][k] - 8.0 * values[1][k] + 8.0 * values[2][k] - values[3][k]) / (12.0 * step)
        };
        let error = |k: usize| (rates[k] - slope(k)).abs() / largest;
        let worst = (0..rates.len()).map(error).fold(0.0, f64::max);
        println!("{:26} {} {rates:10.3?} {worst:.1e}", card.name, base.name);
        if worst < tolerance {
            return Ok(());
        }
        errors.push(worst);
    }
    Err(format!("{}: rates {rates:?} are off by {errors:?}", card.name))
}
