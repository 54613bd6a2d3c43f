//! Mesh of a wing without film: its rod at a chord fraction, and stiff ribs that hang leading and trailing edge on it.
//!
//! ```text
//!   leading edge   ┬───┬───┬───┬───┐
//!                  │ ╲ │ ╱ │ ╲ │ ╱ │      triangles carry no force of their own: on them lie the strips of air,
//!   rod            ┿━━━┿━━━┿━━━┿━━━┥      the chord lines of the instruments, and the picture
//!                  │ ╱ │ ╲ │ ╱ │ ╲ │
//!   trailing edge  ┴───┴───┴───┴───┘      a rib on every column
//! ```

use super::error::MeshError;
use super::{BeamElement, BeamPart, Mesh};
use crate::geometry::{Layout, Planform};
use crate::input::design::{Design, Ribs};

/// Most bays between ribs.
const MOST_BAYS: usize = 5000;

/// Meshes a wing of rod and ribs; `ribs.bays` × `mesh.refine` bays, one more where a piece of the rod is left over.
///
/// Errors: impossible layout or density, a rod that ends short of the tip.
pub(super) fn generate(design: &Design, planform: &Planform, ribs: &Ribs) -> Result<Mesh, MeshError> {
    let layout = Layout::from_design(design, planform)?;
    let rod_end_m = layout.rod.last().map_or(0.0, |piece| piece.to_m);
    if rod_end_m < planform.tip_m() * (1.0 - 1e-9) {
        return Err(MeshError::LooseRibs {
            rod_end_mm: rod_end_m * 1e3,
            tip_mm: planform.tip_m() * 1e3,
        });
    }
    let places_m = columns(planform, &layout, bays(design, ribs)?);
    let fraction = ribs.rod_chord_fraction.value();
    let rows = if fraction > 0.0 {
        vec![0.0, fraction, 1.0]
    } else {
        vec![0.0, 1.0]
    };
    let rod_row = rows.len() - 2;
    let node = |column: usize, row: usize| column * rows.len() + row;
    let mut mesh = Mesh::default();
    for &x_m in &places_m {
        let chord_m = planform.chord_m(x_m);
        mesh.nodes
            .extend(rows.iter().map(|eta| [x_m, eta * chord_m, 0.0]));
    }
    for column in 0..places_m.len() - 1 {
        let middle_m = 0.5 * (places_m[column] + places_m[column + 1]);
        let piece = layout.rod_piece_at(middle_m).unwrap_or(0);
        mesh.beams.push(BeamElement {
            nodes: [node(column, rod_row), node(column + 1, rod_row)],
            part: BeamPart::Rod(piece),
        });
        for row in 0..rows.len() - 1 {
            let [a, b] = [node(column, row), node(column + 1, row)];
            let halves = if (column + row) % 2 == 0 {
                [[a, b, b + 1], [a, b + 1, a + 1]]
            } else {
                [[a, b, a + 1], [b, b + 1, a + 1]]
            };
            mesh.triangles.extend(halves);
        }
    }
    for column in 0..places_m.len() {
        mesh.beams.extend((0..rows.len() - 1).map(|row| BeamElement {
            nodes: [node(column, row), node(column, row + 1)],
            part: BeamPart::Rib(column),
        }));
    }
    mesh.root = (0..rows.len()).map(|row| node(0, row)).collect();
    mesh.leading_edge = (0..places_m.len()).map(|column| node(column, 0)).collect();
    mesh.trailing_edge = (0..places_m.len())
        .map(|column| node(column, rows.len() - 1))
        .collect();
    Ok(mesh)
}

fn bays(design: &Design, ribs: &Ribs) -> Result<usize, MeshError> {
    let bays = (ribs.bays as f64 * design.mesh.refine).round();
    if bays >= 1.0 && bays <= MOST_BAYS as f64 {
        return Ok(bays as usize);
    }
    Err(MeshError::Bays {
        bays: ribs.bays,
        refine: design.mesh.refine,
        largest: MOST_BAYS,
    })
}

/// Span positions of the ribs, m: both ends, the ends of rod pieces, kinks of the outline, and evenly between them.
fn columns(planform: &Planform, layout: &Layout, bays: usize) -> Vec<f64> {
    let tip_m = planform.tip_m();
    let mut fixed_m = vec![0.0, tip_m];
    fixed_m.extend(layout.rod_breaks_m(planform));
    fixed_m.extend(planform.kinks_m());
    fixed_m.sort_by(f64::total_cmp);
    fixed_m.dedup_by(|next, kept| *next - *kept < 1e-6 * tip_m);
    let last = fixed_m.len() - 1;
    fixed_m[last] = tip_m;
    let mut places_m = vec![0.0];
    for ends in fixed_m.windows(2) {
        let share = (ends[1] - ends[0]) / tip_m;
        let count = (share * bays as f64 - 1e-6).ceil().max(1.0);
        let inside = (1..count as usize).map(|k| ends[0] + (ends[1] - ends[0]) * k as f64 / count);
        places_m.extend(inside.map(rounded));
        places_m.push(ends[1]);
    }
    places_m
}

/// A length to the picometre, as in the meshes of films.
fn rounded(metres: f64) -> f64 {
    (metres * 1e12).round() / 1e12
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mesh(ribs: &str, rods: &[f64]) -> Mesh {
        let design = design(ribs, rods);
        let planform = Planform::from_design(&design).unwrap();
        super::super::generate(&design, &planform).unwrap()
    }

    fn design(ribs: &str, rods: &[f64]) -> Design {
        let mut text = format!(
            "format = 1\nname = 'w'\n[planform]\nlength_mm = 450.0\noutline = [[0.0, 50.0], [450.0, 50.0]]\n\
             base_closure = 0.0\ntip_cut = 1.0\n[ribs]\n{ribs}\n"
        );
        let mut from = 0.0;
        for to in rods {
            text += &format!(
                "[[rod]]\nfrom_mm = {from:?}\nto_mm = {to:?}\n\
                 section = {{ shape = 'given', ea_n = 1e6, gj_n_m2 = 1.0, ei_flap_n_m2 = 1.0, ei_edge_n_m2 = 1.0 }}\n"
            );
            from = *to;
        }
        Design::from_toml(&text, "w.toml").unwrap_or_else(|error| panic!("{error}"))
    }

    #[test]
    fn the_rod_lies_at_its_chord_fraction_and_every_column_has_a_rib() {
        let mesh = mesh("bays = 10\nrod_chord_fraction = 0.5", &[450.0]);
        assert_eq!(mesh.leading_edge.len(), 11);
        for (column, &node) in mesh.rod_nodes().iter().enumerate() {
            let [x, y, z] = mesh.nodes[node];
            assert!((x - 0.045 * column as f64).abs() < 1e-9 && (y - 0.025).abs() < 1e-12 && z == 0.0);
        }
        assert!((mesh.area_m2() - 0.45 * 0.05).abs() < 1e-12);
        let ribs = mesh
            .beams
            .iter()
            .filter(|beam| matches!(beam.part, BeamPart::Rib(_)));
        assert_eq!(ribs.count(), 22);
    }

    #[test]
    fn a_rod_at_the_leading_edge_needs_no_row_of_its_own() {
        let mesh = mesh("bays = 4", &[450.0]);
        assert_eq!((mesh.nodes.len(), mesh.triangles.len()), (10, 8));
        assert_eq!(mesh.rod_nodes(), mesh.leading_edge);
    }

    #[test]
    fn every_piece_of_the_rod_ends_on_a_rib() {
        let mesh = mesh("bays = 9\nrod_chord_fraction = 0.44", &[20.0, 431.0, 450.0]);
        let x_m: Vec<f64> = mesh
            .leading_edge
            .iter()
            .map(|&node| mesh.nodes[node][0])
            .collect();
        for end_m in [0.020, 0.431, 0.450] {
            assert!(x_m.iter().any(|x| (x - end_m).abs() < 1e-12), "{x_m:?}");
        }
        assert!(x_m.windows(2).all(|w| w[1] - w[0] <= 0.050 + 1e-9));
    }

    #[test]
    fn ribs_beyond_the_end_of_the_rod_are_refused() {
        let mut design = design("bays = 9", &[450.0]);
        design.rod[0].to_mm = 400.0.into();
        let planform = Planform::from_design(&design).unwrap();
        let error = super::super::generate(&design, &planform).unwrap_err();
        assert_eq!(
            error.to_string(),
            "ribs: the rod ends at 400 mm, the wing at 450 mm, and ribs outboard of the rod hang on nothing; \
             let the last [[rod]] end at 450"
        );
    }
}
