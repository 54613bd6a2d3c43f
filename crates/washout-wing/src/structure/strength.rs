//! Stresses of rods, spars and film from the forces in them, and where each is closest to its strength.
//!
//! Stress along a beam: E (ε + κ_flap z − κ_edge y), from the displacement u₁ + θ₂ z − θ₃ y of a fibre at (y, z) along
//! (e₂, e₃). Torsion: the largest shear of the section at its rate of twist. Film: principal stresses at both faces,
//! N/t ± 6 M/t². Concentrations at joints, shear by transverse forces and stresses across the fibres are left out.

use nalgebra::{Matrix3, SVector, Vector2, Vector3, Vector6};

use super::largest::{larger, smaller};
use super::model::Model;
use super::section::Section;
use super::sheet::Sheet;
use super::shell::Shell;
use super::state::State;
use super::{membrane, plate};

/// A stress, where it stands and what the material bears.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// Stress, Pa; tension and compression alike are positive.
    pub stress_pa: f64,
    /// Place at rest, wing frame, m.
    pub place_m: Vector3<f64>,
    /// Strength of the material there, Pa; `None` where it is not stated.
    pub strength_pa: Option<f64>,
}

impl Peak {
    /// Strength over stress; `None` without either.
    pub fn margin(&self) -> Option<f64> {
        let margin = self.strength_pa? / self.stress_pa;
        margin.is_finite().then_some(margin)
    }
}

/// The film's forces and stresses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmStress {
    /// Largest principal stress at either face.
    pub peak: Peak,
    /// Largest principal membrane force, N/m.
    pub tension_max_n_per_m: f64,
    /// Smallest principal membrane force, N/m; below zero there are wrinkles.
    pub tension_min_n_per_m: f64,
    /// Share of the area that is wrinkled or slack (a plate: compressed in some direction).
    pub wrinkled_share: f64,
}

/// Largest bending and axial stress in the beams named, all of their ends; ranked by share of strength where all have one.
///
/// `force`: N, V_edge, V_flap (N), T, M_flap, M_edge (N·m) at the middle of every beam of the model. `strength_pa`: of
/// a beam at a fibre of its section. `None` without beams or without fibres (given stiffnesses).
pub fn bending_peak(
    model: &Model,
    beams: impl Iterator<Item = usize>,
    force: &[[f64; 6]],
    strength_pa: impl Fn(usize, usize) -> Option<f64>,
) -> Option<Peak> {
    let mut peaks = Vec::new();
    for index in beams {
        let beam = &model.beams[index];
        let section = &model.sections[beam.section];
        for end in [0, 1] {
            let strain = strain_at(section, &force[index], (end as f64 - 0.5) * beam.length_m());
            for (fibre, at) in section.fibres.iter().enumerate() {
                let along = strain[0] + strain[4] * at.flap_m - strain[5] * at.edge_m;
                peaks.push(Peak {
                    stress_pa: (at.modulus_pa * along).abs(),
                    place_m: model.nodes[beam.nodes[end]],
                    strength_pa: strength_pa(index, fibre),
                });
            }
        }
    }
    worst(peaks)
}

/// Largest shear stress by torsion in the beams named; shear strengths are not part of a design, so it has none.
///
/// `force` as in [`bending_peak`]. `None` without beams, or where no section gives its shear.
pub fn torsion_peak(model: &Model, beams: impl Iterator<Item = usize>, force: &[[f64; 6]]) -> Option<Peak> {
    let mut peaks = Vec::new();
    for index in beams {
        let beam = &model.beams[index];
        let section = &model.sections[beam.section];
        for end in [0, 1] {
            let strain = strain_at(section, &force[index], (end as f64 - 0.5) * beam.length_m());
            if section.shear_per_twist_rate_pa_m > 0.0 {
                peaks.push(Peak {
                    stress_pa: (section.shear_per_twist_rate_pa_m * strain[3]).abs(),
                    place_m: model.nodes[beam.nodes[end]],
                    strength_pa: None,
                });
            }
        }
    }
    worst(peaks)
}

/// Strains of a section (order of `section`) at a distance from the middle of its beam, m.
fn strain_at(section: &Section, force: &[f64; 6], from_middle_m: f64) -> Vector6<f64> {
    let mut force = Vector6::from(*force);
    // equilibrium of a piece: M′ = −e₁ × (N, V_edge, V_flap)
    force[4] += force[2] * from_middle_m;
    force[5] -= force[1] * from_middle_m;
    section.compliance * force
}

/// Stresses of the film; `None` without one.
///
/// `force_n_per_m`: N_x, N_y, N_xy of every shell, in any axes of its plane. `linear`: `state` holds small rotations
/// about the shape at rest.
pub fn film_stress(
    model: &Model,
    state: &State,
    force_n_per_m: &[[f64; 3]],
    linear: bool,
    strength_pa: Option<f64>,
) -> Option<FilmStress> {
    let mut peaks = Vec::new();
    let (mut largest, mut smallest) = (f64::NEG_INFINITY, f64::INFINITY);
    let (mut area, mut wrinkled) = (0.0, 0.0);
    for (shell, n) in model.shells.iter().zip(force_n_per_m) {
        let sheet = &model.sheets[shell.sheet];
        let [first, second] = principal(n);
        largest = larger(largest, first);
        smallest = smaller(smallest, second);
        area += shell.area_m2();
        // rounding of an unloaded film is no wrinkle
        if second < -1e-15 * sheet.e_pa * sheet.thickness_m {
            wrinkled += shell.area_m2();
        }
        let t = sheet.thickness_m;
        let bending = moment(model, shell, sheet, state, linear);
        let membrane = turned(n, shell);
        let faces = [-1.0, 1.0].map(|side| {
            let stress: [f64; 3] =
                std::array::from_fn(|i| membrane[i] / t + side * 6.0 * bending[i] / (t * t));
            let [a, b] = principal(&stress);
            larger(a.abs(), b.abs())
        });
        let place: Vector3<f64> = shell.nodes.iter().map(|&node| model.nodes[node]).sum();
        peaks.push(Peak {
            stress_pa: larger(faces[0], faces[1]),
            place_m: place / 3.0,
            strength_pa,
        });
    }
    Some(FilmStress {
        peak: worst(peaks)?,
        tension_max_n_per_m: largest,
        tension_min_n_per_m: smallest,
        wrinkled_share: wrinkled / area,
    })
}

/// Membrane force in axes whose x is the projection of the frame's, turned to the shell's axes at rest.
fn turned(n: &[f64; 3], shell: &Shell) -> [f64; 3] {
    let along = shell.axes().transpose() * Vector3::x();
    let (sine, cosine) = (-along.y.atan2(along.x)).sin_cos();
    let (c2, s2, cs) = (cosine * cosine, sine * sine, cosine * sine);
    [
        c2 * n[0] + s2 * n[1] + 2.0 * cs * n[2],
        s2 * n[0] + c2 * n[1] - 2.0 * cs * n[2],
        cs * (n[1] - n[0]) + (c2 - s2) * n[2],
    ]
}

/// Larger and smaller principal value of (a_x, a_y, a_xy).
fn principal(a: &[f64; 3]) -> [f64; 2] {
    let (centre, radius) = (0.5 * (a[0] + a[1]), (0.5 * (a[0] - a[1])).hypot(a[2]));
    [centre + radius, centre - radius]
}

/// Bending moments M_x, M_y, M_xy of a shell at its middle, its axes, N.
fn moment(model: &Model, shell: &Shell, sheet: &Sheet, state: &State, linear: bool) -> SVector<f64, 3> {
    let (u, q) = model.shell_state(shell, state);
    let rest = shell.axes();
    let corners = shell.nodes.map(|node| model.nodes[node]);
    let side = (corners[1] + u[1]) - (corners[0] + u[0]);
    let normal = shell.normal(&u);
    // the first axis runs along the first side, at rest as deformed
    let first = side.normalize();
    let deformed = Matrix3::from_columns(&[first, normal.cross(&first), normal]);
    let mut p = SVector::<f64, 9>::zeros();
    for node in 0..3 {
        let (across, tilt) = if linear {
            let turn = rest.transpose() * q[node].scaled_axis();
            ((rest.transpose() * u[node]).z, [turn.x, turn.y])
        } else {
            let director = deformed.transpose() * (q[node] * rest.column(2));
            (0.0, [-director.y, director.x])
        };
        p[3 * node] = across;
        p[3 * node + 1] = tilt[0];
        p[3 * node + 2] = tilt[1];
    }
    let plane = corners.map(|x| {
        let x = rest.transpose() * (x - corners[0]);
        Vector2::new(x.x, x.y)
    });
    let curvature = plate::strains(&plane, plate::softness_m2(sheet.thickness_m, sheet.poisson))
        .curvature
        .iter()
        .map(|b| b * p)
        .sum::<SVector<f64, 3>>()
        / 3.0;
    membrane::isotropic(sheet.e_pa * sheet.thickness_m.powi(3) / 12.0, sheet.poisson) * curvature
}

/// The peak with the largest share of its strength, or with the largest stress where a strength is missing.
fn worst(peaks: Vec<Peak>) -> Option<Peak> {
    let all = peaks.iter().all(|peak| peak.strength_pa.is_some());
    let rank = |peak: &Peak| match peak.strength_pa {
        Some(strength) if all => peak.stress_pa / strength,
        _ => peak.stress_pa,
    };
    peaks.into_iter().reduce(|a, b| {
        if rank(&a).is_nan() || rank(&a) >= rank(&b) {
            a
        } else {
            b
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Progress;
    use crate::structure::section::BeamMaterial;
    use crate::structure::{Compression, Equilibrium, Loads, NewtonSettings};

    const CARBON: BeamMaterial = BeamMaterial {
        e_pa: 134e9,
        g_pa: 4e9,
        density_kg_m3: 1500.0,
    };

    /// Rod along x of 50 mm in four elements under a force and a moment at its tip.
    fn rod(section: Section, force: Vector3<f64>, moment: Vector3<f64>) -> (Model, Vec<[f64; 6]>) {
        let mut model = Model::new(
            (0..=4)
                .map(|i| Vector3::new(0.0125 * i as f64, 0.0, 0.0))
                .collect(),
        );
        let section = model.add_section(section);
        for i in 0..4 {
            model.add_beam([i, i + 1], &Vector3::z(), section).unwrap();
        }
        model.clamp(0);
        let (none, mut loads) = (Loads::none(5), Loads::none(5));
        loads.force_n[4] = force;
        loads.moment_n_m[4] = moment;
        let mut state = State::at_rest(5);
        Equilibrium::new(&model)
            .unwrap()
            .solve(
                &mut state,
                &none,
                &loads,
                &NewtonSettings::default(),
                &Progress::quiet(),
            )
            .unwrap();
        let force = model.beams.iter().map(|beam| {
            let (u, q) = model.beam_state(beam, &state);
            beam.section_forces(&u, &q, 0.0)
        });
        let force = force.collect();
        (model, force)
    }

    #[test]
    fn clamped_end_of_a_round_rod_carries_the_moment_of_the_tip_force_in_any_direction() {
        let a: f64 = 5e-4;
        let pi = std::f64::consts::PI;
        for degrees in [0.0_f64, 33.0, 90.0] {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let (model, force) = rod(
                Section::round(a, &CARBON),
                1e-3 * Vector3::new(0.0, cosine, sine),
                Vector3::zeros(),
            );
            let peak = bending_peak(&model, 0..4, &force, |_, _| Some(1.5e9)).unwrap();
            // σ = M a / I = 4 F L / (π a³); the points on the circle are 11.25° apart
            let exact = 4.0 * 1e-3 * 0.05 / (pi * a.powi(3));
            assert!(
                (peak.stress_pa / exact - 1.0).abs() < 0.006,
                "{degrees} {peak:?} {exact}"
            );
            assert_eq!(peak.place_m, Vector3::zeros());
            assert!((peak.margin().unwrap() * peak.stress_pa / 1.5e9 - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn signs_of_axial_and_bending_stress_agree() {
        // half-round, flat at −e₃: lifting the tip puts the flat in tension, pulling adds to that
        let a: f64 = 5e-4;
        let section = Section::half_round(a, true, &CARBON);
        let centroid = 4.0 / (3.0 * std::f64::consts::PI) * a;
        let (area, i) = (std::f64::consts::PI / 2.0 * a * a, 0.109_757 * a.powi(4));
        // so small that the pull at the bent tip does not matter: N L²/(2 EI) = 0.003
        let lift = 2e-6;
        for (pull, distance) in [(2e-3, centroid), (-2e-3, a - centroid)] {
            let (model, force) = rod(section.clone(), Vector3::new(pull, 0.0, lift), Vector3::zeros());
            let peak = bending_peak(&model, 0..4, &force, |_, _| None).unwrap();
            let bent = lift * 0.05 * distance / i;
            let exact = pull.abs() / area + bent;
            assert!(
                (peak.stress_pa / exact - 1.0).abs() < 0.01,
                "{pull} {peak:?} {exact}"
            );
            assert_eq!(peak.margin(), None);
        }
        // edgewise: a force along +e₂ stretches the side at −e₂
        let strain = strain_at(&section, &[10.0, 0.0, 0.0, 0.0, 0.0, 0.02], 0.0);
        let along = |edge_m: f64| strain[0] - strain[5] * edge_m;
        assert!(along(-a) > along(a));
    }

    #[test]
    fn torsion_of_a_round_rod_and_of_a_strip_has_the_shear_of_saint_venant() {
        let (torque, pi) = (2e-5, std::f64::consts::PI);
        let cases = [
            (Section::round(5e-4, &CARBON), 2.0 * torque / (pi * 1.25e-10)),
            // thin strip b × t: 3 T/(b t²), less 0.63 t/b
            (
                Section::rectangle(1e-3, 1e-5, &CARBON),
                3.0 * torque / (1e-3 * 1e-10) / (1.0 - 0.63 * 0.01),
            ),
        ];
        for (section, exact) in cases {
            let force = [[0.0, 0.0, 0.0, torque, 0.0, 0.0]];
            let mut model = Model::new(vec![Vector3::zeros(), Vector3::x() * 0.01]);
            let section = model.add_section(section);
            model.add_beam([0, 1], &Vector3::z(), section).unwrap();
            let peak = torsion_peak(&model, 0..1, &force).unwrap();
            assert!((peak.stress_pa / exact - 1.0).abs() < 1e-3, "{peak:?} {exact}");
        }
    }

    #[test]
    fn the_worst_place_is_ranked_by_share_of_strength() {
        let peak = |stress_pa: f64, strength_pa: Option<f64>| Peak {
            stress_pa,
            place_m: Vector3::zeros(),
            strength_pa,
        };
        let found = worst(vec![peak(5.0, Some(100.0)), peak(2.0, Some(10.0))]).unwrap();
        assert_eq!(found.stress_pa, 2.0);
        let found = worst(vec![peak(5.0, None), peak(2.0, Some(10.0))]).unwrap();
        assert_eq!(found.stress_pa, 5.0);
        assert_eq!(worst(Vec::new()), None);
    }

    fn two_triangles(t: f64) -> Model {
        let corners = [
            [0.0, 0.0, 0.0],
            [0.02, 0.0, 0.0],
            [0.02, 0.01, 0.0],
            [0.0, 0.01, 0.0],
        ];
        let mut model = Model::new(corners.map(Vector3::from).to_vec());
        let sheet = model.add_sheet(Sheet {
            e_pa: 2.5e9,
            poisson: 0.34,
            thickness_m: t,
            density_kg_m3: 1420.0,
            pretension_n_per_m: 0.0,
            compression: Compression::Carries,
        });
        for nodes in [[1, 2, 0], [0, 2, 3]] {
            model.add_shell(nodes, sheet).unwrap();
        }
        model
    }

    #[test]
    fn film_forces_are_principal_ones_and_wrinkles_are_shares_of_area() {
        let model = two_triangles(6e-6);
        let forces = [[5.0, 3.0, 2.0], [1.0, -0.1, 0.0]];
        let film = film_stress(&model, &State::at_rest(4), &forces, false, Some(69e6)).unwrap();
        let first = 4.0 + 5.0_f64.sqrt();
        assert!((film.tension_max_n_per_m - first).abs() < 1e-12);
        assert!((film.tension_min_n_per_m + 0.1).abs() < 1e-12);
        assert!((film.wrinkled_share - 0.5).abs() < 1e-12);
        assert!((film.peak.stress_pa - first / 6e-6).abs() < 1e-3);
        assert!((film.peak.margin().unwrap() - 69e6 * 6e-6 / first).abs() < 1e-9);
        assert!(film_stress(&Model::default(), &State::at_rest(0), &[], false, None).is_none());
    }

    #[test]
    fn a_plate_rolled_to_a_cylinder_has_the_stress_of_its_curvature_however_it_is_turned() {
        let (t, kappa) = (2e-4, 3.0);
        let model = two_triangles(t);
        let turn = nalgebra::UnitQuaternion::new(Vector3::new(0.5, -0.9, 0.4));
        for (turn, linear) in [
            (nalgebra::UnitQuaternion::identity(), true),
            (nalgebra::UnitQuaternion::identity(), false),
            (turn, false),
        ] {
            // about y: w = −κ x²/2 … turned by θ_y = κ x, so that κ_x = ∂θ_y/∂x
            let mut state = State::at_rest(4);
            for (node, x) in model.nodes.iter().enumerate() {
                let rolled = x + Vector3::new(0.0, 0.0, -0.5 * kappa * x.x * x.x);
                state.displacement[node] = turn * rolled - x;
                let own = nalgebra::UnitQuaternion::new(Vector3::new(0.0, kappa * x.x, 0.0));
                state.rotation[node] = turn * own;
            }
            let film = film_stress(&model, &state, &[[0.0; 3]; 2], linear, None).unwrap();
            let exact = 2.5e9 * t / 2.0 * kappa / (1.0 - 0.34 * 0.34);
            assert!(
                (film.peak.stress_pa / exact - 1.0).abs() < 2e-3,
                "{linear} {film:?} {exact}"
            );
        }
    }
}
