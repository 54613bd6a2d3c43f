//! What must not matter, or matter in proportion: units of length, speed against density, which side is up, the order of nodes; and in
//! linear kinematics, sums of loads and the exchange of load and reading (Betti).

use fastrand::Rng;
use serde_json::Value;
use washout::input::Design;
use washout::mesh::{BeamElement, Mesh};
use washout::progress::Progress;
use washout::wing::{SolvedWing, WingModel};

use crate::random_wing::random_wing;

/// A plausible wing at random, on a coarse mesh.
fn wing(seed: u64) -> Design {
    Design::from_toml(&random_wing(seed, 0.25), "random.toml").expect("a plausible design")
}

fn solved(model: &WingModel) -> Option<SolvedWing> {
    model.solve(&Progress::quiet()).ok()
}

/// Twist at three places of the span, deg; none where there is no equilibrium.
fn twist_deg(model: &WingModel) -> Option<[f64; 3]> {
    let solved = solved(model)?;
    let long_m = model.planform.length_m();
    let at = |share: f64| solved.twist_at(share * long_m).unwrap_or(f64::NAN).to_degrees();
    Some([0.3, 0.6, 0.9].map(at))
}

/// The design with every number changed as `change` says by its key.
fn with_all(design: &Design, change: impl Fn(&str) -> f64) -> Design {
    fn walk(key: &str, value: &mut Value, change: &dyn Fn(&str) -> f64) {
        match value {
            Value::Object(table) => table.iter_mut().for_each(|(own, value)| walk(own, value, change)),
            Value::Array(list) => list.iter_mut().for_each(|value| walk(key, value, change)),
            Value::Number(number) if change(key) != 1.0 => {
                *value = (number.as_f64().expect("a number") * change(key)).into();
            }
            _ => {}
        }
    }
    let mut tree = serde_json::to_value(design).expect("a tree");
    walk("", &mut tree, &change);
    serde_json::from_value(tree).expect("a design")
}

/// How far the twists of two wings are apart, deg, over seeds for which both have an equilibrium.
fn apart(
    seeds: impl Iterator<Item = u64>,
    other: impl Fn(&Design) -> Option<(WingModel, f64)>,
) -> Vec<(u64, f64)> {
    let of_seed = |seed: u64| {
        let design = wing(seed);
        let (model, sign) = other(&design)?;
        let pair = twist_deg(&WingModel::of_design(design).expect("a wing")).zip(twist_deg(&model))?;
        let difference = |place: usize| (pair.0[place] - sign * pair.1[place]).abs();
        let largest = (0..3)
            .map(difference)
            .fold(0.0, |a: f64, b| if b.is_nan() { b } else { a.max(b) });
        Some((seed, largest))
    };
    seeds.filter_map(of_seed).collect()
}

/// All wings twist alike but those that are known not to; a known one that does is to be taken out of the list.
fn alike_but(known: &[u64], limit_deg: f64, found: &[(u64, f64)]) {
    assert!(found.len() > known.len() + 4, "{found:?}");
    for (seed, apart_deg) in found {
        assert_eq!(
            *apart_deg < limit_deg,
            !known.contains(seed),
            "{seed}: {apart_deg} deg in {found:?}"
        );
    }
}

#[test]
fn air_four_times_as_dense_at_half_the_speed_is_the_same_bit_for_bit() {
    let slower = |design: &Design| {
        let change = |key: &str| match key {
            "density_kg_m3" => 4.0,
            "speed_m_s" | "frequency_hz" => 0.5,
            _ => 1.0,
        };
        let mut other = with_all(design, change);
        // not that of the materials
        other.material = design.material.clone();
        Some((WingModel::of_design(other).expect("a wing"), 1.0))
    };
    let found = apart(0..12, slower);
    assert!(found.len() > 8, "{found:?}");
    assert!(found.iter().all(|(_, apart)| *apart == 0.0), "{found:?}");
}

#[test]
fn a_wing_twice_as_large_under_the_same_pressure_twists_alike() {
    let larger = |design: &Design| {
        let change = |key: &str| match key {
            "force_n" => 4.0,
            "pretension_n_per_m" => 2.0,
            "acceleration_m_s2" | "frequency_hz" => 0.5,
            key if key.ends_with("_mm") => 2.0,
            _ => 1.0,
        };
        Some((
            WingModel::of_design(with_all(design, change)).expect("a wing"),
            1.0,
        ))
    };
    // rounding decides on 6 (0.5 deg apart)
    alike_but(&[6], 1e-4, &apart(0..12, larger));
}

#[test]
fn upside_down_a_wing_in_a_stream_twists_the_other_way() {
    let mirrored = |design: &Design| {
        design.steady.as_ref()?;
        let mut other = design.clone();
        let angle_deg = design.get("steady.root_angle_deg")?;
        other.set("steady.root_angle_deg", -angle_deg).expect("an angle");
        for load in &mut other.load {
            load.force_n[2] = -load.force_n[2];
        }
        other
            .gravity
            .iter_mut()
            .for_each(|gravity| gravity.acceleration_m_s2[2] *= -1.0);
        Some((WingModel::of_design(other).expect("a wing"), -1.0))
    };
    // rounding decides on these: 0.09, 2e-4, 0.05 and 3e-5 deg apart
    alike_but(&[13, 15, 24, 27], 1e-6, &apart(0..30, mirrored));
}

/// The mesh with its nodes in another order.
fn renumbered(mesh: &Mesh, seed: u64) -> Mesh {
    let mut order: Vec<usize> = (0..mesh.nodes.len()).collect();
    Rng::with_seed(seed).shuffle(&mut order);
    let new = |list: &[usize]| list.iter().map(|&node| order[node]).collect();
    let mut nodes = mesh.nodes.clone();
    mesh.nodes
        .iter()
        .zip(&order)
        .for_each(|(place, &at)| nodes[at] = *place);
    let beam = |beam: &BeamElement| BeamElement {
        nodes: beam.nodes.map(|node| order[node]),
        part: beam.part,
    };
    Mesh {
        nodes,
        triangles: mesh
            .triangles
            .iter()
            .map(|nodes| nodes.map(|node| order[node]))
            .collect(),
        beams: mesh.beams.iter().map(beam).collect(),
        root: new(&mesh.root),
        leading_edge: new(&mesh.leading_edge),
        trailing_edge: new(&mesh.trailing_edge),
    }
}

#[test]
fn the_order_of_nodes_does_not_matter() {
    let other = |design: &Design| {
        let mesh = WingModel::of_design(design.clone()).expect("a wing").mesh;
        let mesh = renumbered(&mesh, 7);
        Some((WingModel::on_mesh(design.clone(), mesh).expect("a wing"), 1.0))
    };
    let found = apart(0..12, other);
    assert!(found.len() > 8, "{found:?}");
    assert!(found.iter().all(|(_, apart)| *apart < 1e-6), "{found:?}");
}

/// A wing of the bench in linear kinematics under loads: place (mm), force (N) and moment (N·m).
fn on_the_bench(loads: &[(f64, [f64; 3], [f64; 3])]) -> SolvedWing {
    let rows: String = loads
        .iter()
        .map(|(at_mm, force_n, moment_n_m)| {
            format!("[[load]]\nat_mm = {at_mm:?}\nforce_n = {force_n:?}\nmoment_n_m = {moment_n_m:?}\n")
        })
        .collect();
    let text = format!(
        "format = 1\nname = 'w'\n[planform]\nlength_mm = 70.0\nmean_chord_mm = 20.5\nr2_hat = 0.54\n[mesh]\nrefine = 0.3\n\
         [structure]\nkinematics = 'linear'\n[film]\nmaterial = 'kapton'\nthickness_mm = 0.05\n\
         [[rod]]\nfrom_mm = 0.0\nto_mm = 70.0\nmaterial = 'rod'\nsection = {{ shape = 'round', diameter_mm = 1.0 }}\n\
         [[spar]]\nat_mm = 35.0\nmaterial = 'rod'\nsection = {{ shape = 'round', diameter_mm = 0.3 }}\n\
         [material.kapton]\ne_gpa = 2.5\npoisson = 0.34\ndensity_kg_m3 = 1420.0\n\
         [material.rod]\ne_gpa = 134.0\ng_gpa = 4.0\ndensity_kg_m3 = 1500.0\n{rows}"
    );
    let design = Design::from_toml(&text, "bench.toml").unwrap_or_else(|error| panic!("{error}"));
    let model = WingModel::of_design(design).expect("a wing");
    model.solve(&Progress::quiet()).expect("linear")
}

/// Displacement (m) and rotation vector (rad) of the node of the leading edge at this place.
fn moved(wing: &SolvedWing, at_mm: f64) -> [f64; 6] {
    let mesh = &wing.solution.mesh;
    let near = |node: &&usize| ((mesh.nodes[**node][0] * 1e3 - at_mm).abs() * 1e12) as u64;
    let node = *mesh.leading_edge.iter().min_by_key(near).expect("a node");
    let (u, turned) = (
        wing.solution.state.displacement[node],
        wing.solution.state.rotation[node].scaled_axis(),
    );
    [u.x, u.y, u.z, turned.x, turned.y, turned.z]
}

/// Places of two nodes of the leading edge, mm.
fn two_places() -> [f64; 2] {
    let bare = on_the_bench(&[(35.0, [0.0, 0.0, 1e-3], [0.0; 3])]);
    let mesh = &bare.solution.mesh;
    let edge = &mesh.leading_edge;
    [edge.len() / 3, edge.len() - 2].map(|place| mesh.nodes[edge[place]][0] * 1e3)
}

#[test]
fn in_linear_kinematics_two_loads_do_what_each_does_together() {
    let [inner, outer] = two_places();
    let one = (inner, [0.0, 1e-3, 2e-3], [1e-5, 0.0, 0.0]);
    let other = (outer, [0.0, -1e-3, 1e-3], [-2e-5, 1e-5, 0.0]);
    let [first, second, both] =
        [&[one][..], &[other], &[one, other]].map(|loads| moved(&on_the_bench(loads), outer));
    let size = both.iter().map(|part| part.abs()).fold(0.0, f64::max);
    for part in 0..6 {
        let apart = (first[part] + second[part] - both[part]).abs();
        assert!(apart < 1e-9 * size, "{part}: {apart} of {size}");
    }
}

#[test]
fn what_a_load_does_elsewhere_is_what_the_same_there_does_here() {
    let [inner, outer] = two_places();
    let unit = |part: usize| {
        let mut six = [0.0; 6];
        six[part] = 1e-5;
        ([six[0], six[1], six[2]], [six[3], six[4], six[5]])
    };
    // forces across and along the chord, torque, bending moment
    for (here, there) in [(2, 2), (1, 1), (3, 2), (3, 3), (4, 2), (2, 1)] {
        let ((force, moment), (other_force, other_moment)) = (unit(here), unit(there));
        let at_outer = moved(&on_the_bench(&[(inner, force, moment)]), outer)[there];
        let at_inner = moved(&on_the_bench(&[(outer, other_force, other_moment)]), inner)[here];
        let size = at_outer.abs().max(at_inner.abs());
        assert!(
            (at_outer - at_inner).abs() < 1e-8 * size + 1e-18,
            "{here}, {there}: {at_outer} {at_inner}"
        );
    }
}
