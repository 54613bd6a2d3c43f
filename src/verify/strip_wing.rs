//! A uniform wing whose strips, elastic axis and stiffnesses are as in the textbooks' strip theory.
//!
//! ```text
//!   LE ━━━━━━━━━━━━━━━━━━━━━━━   rod with given stiffnesses, clamped at x = 0
//!      · · · centre of pressure
//!      ─ ─ ─ elastic axis         behind it
//!   TE └───┴───┴───┴───┴───┘   ribs at every column, stiff; film of next to nothing, which carries nothing
//! ```
//!
//! The rod is the leading edge. Its elastic axis is put behind it by the section's coupling of twist and shear:
//! K_VV = GA, K_VT = GA d, K_TT = GJ + GA d², so that a force at y = d bends without twist. Small rotations, thin-airfoil
//! lift 2π α normal to the leading edge.

use crate::coupling::CouplingError;
use crate::coupling::solution::Solution;
use crate::input::design::Design;
use crate::mesh::{BeamElement, BeamPart, Mesh};
use crate::progress::Progress;
use crate::wing::WingModel;

use super::VerifyError;

/// Triangles across the chord.
const ROWS: usize = 16;

/// What differs between the wings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripWing {
    /// Beam elements, with as many strips.
    pub columns: usize,
    /// Length, m.
    pub length_m: f64,
    /// Chord, m.
    pub chord_m: f64,
    /// Torsional stiffness about the elastic axis, N·m².
    pub gj_n_m2: f64,
    /// Bending stiffness, N·m².
    pub ei_n_m2: f64,
    /// Shear stiffness of the rod, N.
    pub shear_n: f64,
    /// Bending and torsional stiffness of the ribs, N·m².
    pub rib_n_m2: f64,
    /// Elastic axis behind the leading edge, m.
    pub axis_m: f64,
    /// Centre of pressure, fraction of the chord.
    pub centre: f64,
    /// Sweep, deg, positive aft.
    pub sweep_deg: f64,
    /// Pitch stiffness of the root, N·m/rad; clamped if none.
    pub pitch_stiffness_n_m_per_rad: Option<f64>,
    /// Dynamic pressure of the stream, Pa.
    pub q_pa: f64,
    /// Density of the air, kg/m³.
    pub density_kg_m3: f64,
    /// Angle of attack at the root, deg.
    pub root_deg: f64,
}

impl StripWing {
    /// GJ = EI = 10 N·m², L = 1 m, c = 0.2 m, elastic axis in mid-chord, centre of pressure at a quarter, no stream.
    pub const WORKED: StripWing = StripWing {
        columns: 8,
        length_m: 1.0,
        chord_m: 0.2,
        gj_n_m2: 10.0,
        ei_n_m2: 10.0,
        shear_n: 1000.0,
        rib_n_m2: 1e4,
        axis_m: 0.1,
        centre: 0.25,
        sweep_deg: 0.0,
        pitch_stiffness_n_m_per_rad: None,
        q_pa: 0.0,
        density_kg_m3: 1.225,
        root_deg: 0.01,
    };

    /// Elastic axis behind the centre of pressure, m.
    pub fn arm_m(&self) -> f64 {
        self.axis_m - self.centre * self.chord_m
    }

    /// Divergence pressure of the unswept wing, (π/2L)² GJ/(e c a) with a = 2π, Pa.
    pub fn divergence_pa(&self) -> f64 {
        (0.5 * std::f64::consts::PI / self.length_m).powi(2) * self.gj_n_m2
            / (self.arm_m() * self.chord_m * std::f64::consts::TAU)
    }

    /// The wing, meshed.
    ///
    /// # Errors
    /// If the design is refused.
    pub fn build(&self) -> Result<WingModel, VerifyError> {
        let design = Design::from_toml(&self.text(), "strip-wing.toml")?;
        Ok(WingModel::on_mesh(design, self.mesh())?)
    }

    /// The wing in its air.
    ///
    /// # Errors
    /// If there is no equilibrium, as beyond divergence.
    pub fn solve(&self, progress: &Progress) -> Result<Solution, VerifyError> {
        Ok(self.build()?.shape(None, progress)?)
    }

    /// Dynamic pressure at which the wing diverges by the feedback of the air at its own, Pa.
    ///
    /// # Errors
    /// If there is no equilibrium, or nothing drives the wing toward divergence.
    pub fn found_divergence_pa(&self, progress: &Progress) -> Result<f64, VerifyError> {
        let ratio = match self.solve(progress) {
            Ok(solution) => solution.report.critical_pressure_ratio,
            Err(VerifyError::Coupling(CouplingError::Diverged { critical_ratio, .. })) => {
                Some(critical_ratio)
            }
            Err(error) => return Err(error),
        };
        let missing = VerifyError::Missing {
            what: "divergence pressure",
        };
        ratio.map(|ratio| ratio * self.q_pa).ok_or(missing)
    }

    /// Nose-up twist over the root angle at every column.
    pub fn nose_up(&self, solution: &Solution) -> Vec<f64> {
        let mesh = &solution.mesh;
        let ends = mesh.leading_edge.iter().zip(&mesh.trailing_edge);
        ends.map(|(&leading, &trailing)| {
            let [a, b] = [leading, trailing].map(|node| solution.state.displacement[node].z);
            (a - b) / self.chord_m / self.root_deg.to_radians()
        })
        .collect()
    }

    fn text(&self) -> String {
        let (coupling, torsion) = (
            self.shear_n * self.axis_m,
            self.gj_n_m2 + self.shear_n * self.axis_m * self.axis_m,
        );
        let terms = if self.axis_m > 0.0 {
            format!("coupling = [{{ between = ['shear-flap', 'twist'], value = {coupling:?} }}]")
        } else {
            String::new()
        };
        let root = self.pitch_stiffness_n_m_per_rad.map_or(String::new(), |k| {
            format!("[root]\npitch_stiffness_n_m_per_rad = {k:?}\n")
        });
        let (length_mm, chord_mm) = (1e3 * self.length_m, 1e3 * self.chord_m);
        let mut text = format!(
            "format = 1\nname = 'strip-wing'\n\
             [planform]\nlength_mm = {length_mm:?}\noutline = [[0.0, {chord_mm:?}], [{length_mm:?}, {chord_mm:?}]]\n\
             base_closure = 0.0\ntip_cut = 1.0\n\
             [steady]\nspeed_m_s = {:?}\nroot_angle_deg = {:?}\nsweep_deg = {:?}\n\
             [air]\ndensity_kg_m3 = {:?}\ncoefficients = 'thin-airfoil'\ncentre_of_pressure = 'fixed'\n\
             centre_of_pressure_fraction = {:?}\n\
             [structure]\nkinematics = 'linear'\n{root}\
             [film]\nmaterial = 'gauze'\nthickness_mm = 0.0001\n\
             [material.gauze]\ne_gpa = 1e-6\npoisson = 0.3\ndensity_kg_m3 = 0.0\n\
             [[rod]]\nfrom_mm = 0.0\nto_mm = {length_mm:?}\n[rod.section]\nshape = 'given'\nea_n = {:?}\n\
             gj_n_m2 = {torsion:?}\nei_flap_n_m2 = {:?}\nei_edge_n_m2 = {:?}\nga_edge_n = {:?}\nga_flap_n = {:?}\n{terms}\n",
            (2.0 * self.q_pa / self.density_kg_m3).sqrt(),
            self.root_deg,
            self.sweep_deg,
            self.density_kg_m3,
            self.centre,
            1e4 * self.ei_n_m2,
            self.ei_n_m2,
            10.0 * self.ei_n_m2,
            1e4 * self.ei_n_m2,
            self.shear_n,
        );
        let rib = self.rib_n_m2;
        for column in 0..=self.columns {
            let at_mm = length_mm * column as f64 / self.columns as f64;
            text += &format!(
                "[[spar]]\nat_mm = {at_mm:?}\n[spar.section]\nshape = 'given'\nea_n = {:?}\ngj_n_m2 = {rib:?}\n\
                 ei_flap_n_m2 = {rib:?}\nei_edge_n_m2 = {rib:?}\n",
                100.0 * rib
            );
        }
        text
    }

    /// A rectangle of right-angled triangles with a rib on every column; the generator would put columns between the ribs.
    fn mesh(&self) -> Mesh {
        let columns = self.columns;
        let node = |column: usize, row: usize| column * (ROWS + 1) + row;
        let mut mesh = Mesh::default();
        for column in 0..=columns {
            let x = self.length_m * column as f64 / columns as f64;
            mesh.nodes
                .extend((0..=ROWS).map(|row| [x, self.chord_m * row as f64 / ROWS as f64, 0.0]));
        }
        for column in 0..columns {
            mesh.beams.push(BeamElement {
                nodes: [node(column, 0), node(column + 1, 0)],
                part: BeamPart::Rod(0),
            });
            for row in 0..ROWS {
                let [a, b] = [node(column, row), node(column + 1, row)];
                let halves = if (column + row) % 2 == 0 {
                    [[a, b, b + 1], [a, b + 1, a + 1]]
                } else {
                    [[a, b, a + 1], [b, b + 1, a + 1]]
                };
                mesh.triangles.extend(halves);
            }
        }
        for column in 0..=columns {
            mesh.beams.extend((0..ROWS).map(|row| BeamElement {
                nodes: [node(column, row), node(column, row + 1)],
                part: BeamPart::Spar(column),
            }));
        }
        mesh.root = (0..=ROWS).map(|row| node(0, row)).collect();
        mesh.leading_edge = (0..=columns).map(|column| node(column, 0)).collect();
        mesh.trailing_edge = (0..=columns).map(|column| node(column, ROWS)).collect();
        mesh
    }
}
