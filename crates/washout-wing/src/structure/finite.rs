//! Numbers of a structure that are not finite, found before it is solved: which one, and where it stands.

use std::fmt::Display;

use nalgebra::Vector3;

use super::error::NotFinite;
use super::loads::Loads;
use super::model::Model;
use super::section::Section;
use super::sheet::{Compression, Sheet};
use super::skin::Skin;

/// Refuses numbers of one place that are not finite.
///
/// # Errors
/// The first of them.
pub fn refuse_not_finite<P: Display>(
    place: impl FnOnce() -> P,
    numbers: impl IntoIterator<Item = (&'static str, f64)>,
) -> Result<(), NotFinite> {
    match numbers.into_iter().find(|(_, value)| !value.is_finite()) {
        None => Ok(()),
        Some((quantity, value)) => Err(NotFinite {
            quantity,
            place: place().to_string(),
            value,
        }),
    }
}

/// One quantity over several numbers, as [`refuse_not_finite`] takes them.
pub fn each<'a>(
    quantity: &'static str,
    values: impl IntoIterator<Item = &'a f64> + 'a,
) -> impl Iterator<Item = (&'static str, f64)> + 'a {
    values.into_iter().map(move |value| (quantity, *value))
}

impl Model {
    /// Refuses nodes, sections, films, springs and masses that are not finite.
    ///
    /// # Errors
    /// What it is and where.
    pub fn refuse_not_finite(&self) -> Result<(), NotFinite> {
        for (node, at) in self.nodes.iter().enumerate() {
            let place = || format!("of node {node}");
            refuse_not_finite(place, each("the position (m)", at.iter()))?;
        }
        for beam in &self.beams {
            let [a, b] = beam.nodes.map(|node| self.nodes[node]);
            let place = || format!("of the beam element {}", at((a + b) / 2.0));
            refuse_not_finite(place, numbers_of_section(&self.sections[beam.section]))?;
        }
        for sheet in &self.sheets {
            refuse_not_finite(|| "of the film", numbers_of_sheet(sheet))?;
        }
        for spring in &self.springs {
            let along = each("the stiffness (N/m)", &spring.displacement_n_m);
            let about = each("the stiffness (N·m/rad)", &spring.rotation_n_m_rad);
            let own = spring.stiffening;
            let grown = [("the growth of stiffness", own.growth), ("its power", own.power)];
            let place = || format!("of the spring {}", self.place(spring.node));
            refuse_not_finite(place, along.chain(about).chain(grown))?;
        }
        for mass in &self.masses {
            let arm = each("the arm (m)", mass.arm_m.iter());
            let inertia = each("the moment of inertia (kg·m²)", mass.inertia_kg_m2.iter());
            let numbers = [("the mass (kg)", mass.mass_kg)].into_iter();
            let place = || format!("of the point mass {}", self.place(mass.node));
            refuse_not_finite(place, numbers.chain(arm).chain(inertia))?;
        }
        Ok(())
    }

    /// Where a node stands at rest, in words.
    pub fn place(&self, node: usize) -> String {
        self.nodes
            .get(node)
            .map_or_else(|| format!("at node {node}"), |place| at(*place))
    }
}

impl Loads {
    /// Refuses loads on the nodes of a structure that are not finite.
    ///
    /// # Errors
    /// What it is and where.
    pub fn refuse_not_finite(&self, model: &Model) -> Result<(), NotFinite> {
        for (node, (force, moment)) in self.force_n.iter().zip(&self.moment_n_m).enumerate() {
            let numbers = each("the force (N)", force.iter()).chain(each("the moment (N·m)", moment.iter()));
            refuse_not_finite(|| format!("on the wing {}", model.place(node)), numbers)?;
        }
        for arm in &self.arms {
            let numbers =
                each("the force (N)", arm.force_n.iter()).chain(each("the arm (m)", arm.arm_m.iter()));
            let place = || format!("of the force on an arm {}", model.place(arm.node));
            refuse_not_finite(place, numbers)?;
        }
        for linear in &self.linear {
            let numbers = each("the force (N)", linear.force_n.iter())
                .chain(each("the change of force (N/m)", linear.gradient_n_m.iter()))
                .chain(each("the arm (m)", linear.arm_m.iter()));
            let place = || format!("of the force that follows the wing {}", model.place(linear.node));
            refuse_not_finite(place, numbers)?;
        }
        for twist in &self.twists {
            let place = || match model.beams.get(twist.beam) {
                Some(beam) => format!("of the beam element {}", model.place(beam.nodes[0])),
                None => format!("of the beam element {}", twist.beam),
            };
            refuse_not_finite(place, [("the twist without torque (rad)", twist.angle_rad)])?;
        }
        Ok(())
    }
}

/// A place of the wing, in words.
pub(super) fn at(place: Vector3<f64>) -> String {
    format!("at r = {:.2} mm, y = {:.2} mm", place.x * 1e3, place.y * 1e3)
}

pub(super) fn numbers_of_section(section: &Section) -> impl Iterator<Item = (&'static str, f64)> {
    let Skin {
        flap_n_m2,
        gives_way_per_m,
        kept,
    } = section.skin.unwrap_or(Skin {
        flap_n_m2: 0.0,
        gives_way_per_m: 1.0,
        kept: 0.0,
    });
    each("the compliance (1/N, 1/(N·m²))", section.compliance.iter())
        .chain(each("the moment of inertia (kg·m)", section.inertia_kg_m.iter()))
        .chain([
            ("the mass per length (kg/m)", section.mass_kg_m),
            ("the stiffness of the skin (N·m²)", flap_n_m2),
            ("the bending at which the skin gives way (1/m)", gives_way_per_m),
            ("the stiffness that the skin keeps (1)", kept),
        ])
}

fn numbers_of_sheet(sheet: &Sheet) -> [(&'static str, f64); 8] {
    let (residual, drilling, slack) = match sheet.compression {
        Compression::Carries => (1.0, 1.0, 0.0),
        Compression::TensionField {
            residual,
            drilling_factor,
            slack,
        } => (residual, drilling_factor, slack),
    };
    [
        ("Young's modulus (Pa)", sheet.e_pa),
        ("Poisson's ratio", sheet.poisson),
        ("the thickness (m)", sheet.thickness_m),
        ("the density (kg/m³)", sheet.density_kg_m3),
        ("the pre-tension (N/m)", sheet.pretension_n_per_m),
        ("the stiffness kept in compression (1)", residual),
        ("the drilling factor (1)", drilling),
        ("the slack (1)", slack),
    ]
}
