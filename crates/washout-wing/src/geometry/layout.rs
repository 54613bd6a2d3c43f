//! Where the rod pieces and the spars lie, in metres.

use super::error::{GeometryError, rounded_mm};
use super::planform::Planform;
use crate::input::design::Design;

/// Rod pieces and spar lines on the wing as built. Metres, frame of [`crate::geometry`].
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// Rod pieces from the base outward, clipped at the tip.
    pub rod: Vec<RodPiece>,
    /// Spars, from the base outward.
    pub spars: Vec<SparLine>,
}

/// A stretch of the leading edge with one rod section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RodPiece {
    /// Index in the design.
    pub index: usize,
    /// Where it starts, m.
    pub from_m: f64,
    /// Where it ends, m.
    pub to_m: f64,
}

/// A straight spar from the leading to the trailing edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SparLine {
    /// Index in the design.
    pub index: usize,
    /// Span position of its end at the leading edge, m.
    pub leading_edge_m: f64,
    /// Span position of its end at the trailing edge, m.
    pub trailing_edge_m: f64,
}

impl Layout {
    /// The layout that a design states, on its planform.
    ///
    /// Errors: rod pieces with a gap or an overlap, spars off the wing, crossing or touching.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use std::path::Path;
    /// # use washout::{geometry::Planform, input::Design};
    /// let design = Design::load(Path::new("designs/twist-v2.toml"), &[])?.design;
    /// let planform = Planform::from_design(&design)?;
    /// let layout = washout::geometry::Layout::from_design(&design, &planform)?;
    /// assert_eq!(layout.rod_piece_at(0.01), Some(0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_design(design: &Design, planform: &Planform) -> Result<Layout, GeometryError> {
        Ok(Layout {
            rod: rod_pieces(design, planform)?,
            spars: spar_lines(design, planform)?,
        })
    }

    /// Index in the design of the rod piece that covers x (m); at a joint the outboard one; `None` beyond the rod.
    pub fn rod_piece_at(&self, x_m: f64) -> Option<usize> {
        self.rod
            .iter()
            .rev()
            .find(|piece| x_m >= piece.from_m && x_m <= piece.to_m)
            .map(|piece| piece.index)
    }

    /// Ends of rod pieces strictly inside the wing, m, rising: a mesh needs a node there.
    pub fn rod_breaks_m(&self, planform: &Planform) -> Vec<f64> {
        let slack_m = 1e-9 * planform.length_m();
        self.rod
            .iter()
            .map(|piece| piece.to_m)
            .filter(|&x| x < planform.tip_m() - slack_m)
            .collect()
    }
}

fn rod_pieces(design: &Design, planform: &Planform) -> Result<Vec<RodPiece>, GeometryError> {
    let length_mm = planform.length_m() * 1000.0;
    let slack_mm = 1e-9 * length_mm;
    let mut expected_mm = 0.0;
    let mut pieces = Vec::new();
    for (index, piece) in design.rod.iter().enumerate() {
        let (from_mm, to_mm) = (piece.from_mm.value(), piece.to_mm.value());
        let joins = (from_mm - expected_mm).abs() <= slack_mm;
        if !joins {
            return Err(GeometryError::RodJoint {
                index,
                from_mm,
                expected_mm,
            });
        }
        if !(to_mm > from_mm + slack_mm && to_mm <= length_mm + slack_mm) {
            return Err(GeometryError::RodLength {
                index,
                from_mm,
                to_mm,
                length_mm,
            });
        }
        // A joint has one position: that of the piece inboard of it.
        let from_m = expected_mm / 1000.0;
        if from_m < planform.tip_m() - slack_mm / 1000.0 {
            pieces.push(RodPiece {
                index,
                from_m,
                to_m: (to_mm / 1000.0).min(planform.tip_m()),
            });
        }
        expected_mm = to_mm;
    }
    if pieces.is_empty() {
        Err(GeometryError::NoRod)
    } else {
        Ok(pieces)
    }
}

fn spar_lines(design: &Design, planform: &Planform) -> Result<Vec<SparLine>, GeometryError> {
    let (tip_m, slack_m) = (planform.tip_m(), 1e-6 * planform.length_m());
    let on_wing = |index: usize, key: &'static str, at_mm: f64| {
        let at_m = at_mm / 1000.0;
        if !(at_m >= 0.0 && at_m <= tip_m + 1e-3 * slack_m) {
            return Err(GeometryError::SparOffWing {
                index,
                key,
                at_mm,
                tip_mm: rounded_mm(tip_m),
            });
        }
        Ok(if at_m < slack_m {
            0.0
        } else if at_m > tip_m - slack_m {
            tip_m
        } else {
            at_m
        })
    };
    let mut spars = Vec::new();
    for (index, spar) in design.spar.iter().enumerate() {
        let leading_edge_m = on_wing(index, "at_mm", spar.at_mm.value())?;
        let trailing_edge_m = match &spar.trailing_edge_at_mm {
            Some(at_mm) => on_wing(index, "trailing_edge_at_mm", at_mm.value())?,
            None => leading_edge_m,
        };
        for (end, at_m) in [("root", 0.0), ("tip", tip_m)] {
            if (leading_edge_m == at_m) != (trailing_edge_m == at_m) {
                return Err(GeometryError::SparOnEnd {
                    index,
                    end,
                    at_mm: rounded_mm(at_m),
                });
            }
        }
        spars.push(SparLine {
            index,
            leading_edge_m,
            trailing_edge_m,
        });
    }
    spars.sort_by(|a, b| a.leading_edge_m.total_cmp(&b.leading_edge_m));
    refuse_crossing(&spars, slack_m)?;
    Ok(spars)
}

/// Refuses spars, in order along the leading edge, that come nearer than `slack_m` at either edge.
fn refuse_crossing(spars: &[SparLine], slack_m: f64) -> Result<(), GeometryError> {
    for w in spars.windows(2) {
        let edges = [
            ("leading", w[0].leading_edge_m, w[1].leading_edge_m),
            ("trailing", w[0].trailing_edge_m, w[1].trailing_edge_m),
        ];
        for (edge, first_m, second_m) in edges {
            if second_m - first_m < slack_m {
                return Err(GeometryError::SparsCross {
                    first: w[0].index,
                    second: w[1].index,
                    edge,
                    first_mm: rounded_mm(first_m),
                    second_mm: rounded_mm(second_m),
                });
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layout(rods: &[[f64; 2]], spars: &str) -> Result<(Layout, Planform), GeometryError> {
        let mut text = String::from(
            "format = 1\nname = 'w'\n[planform]\nlength_mm = 70.0\nmean_chord_mm = 20.5\nr2_hat = 0.54\n",
        );
        for [from, to] in rods {
            text += &format!(
                "[[rod]]\nfrom_mm = {from:?}\nto_mm = {to:?}\nsection = {{ shape = 'round', diameter_mm = 1.0 }}\n"
            );
        }
        for line in spars.split(';').filter(|s| !s.is_empty()) {
            text += &format!(
                "[[spar]]\n{}\nsection = {{ shape = 'round', diameter_mm = 1.0 }}\n",
                line.replace(',', "\n")
            );
        }
        let design: Design = toml::from_str(&text).unwrap();
        let planform = Planform::from_design(&design)?;
        Ok((Layout::from_design(&design, &planform)?, planform))
    }

    #[test]
    fn the_rod_of_twist_v2_changes_its_section_at_57_percent() {
        let (layout, planform) = layout(&[[0.0, 39.9], [39.9, 70.0]], "").unwrap();
        assert_eq!(layout.rod_piece_at(0.0), Some(0));
        assert_eq!(layout.rod_piece_at(0.0398), Some(0));
        assert_eq!(layout.rod_piece_at(0.0400), Some(1));
        assert_eq!(layout.rod_piece_at(planform.tip_m()), Some(1));
        assert_eq!(layout.rod_breaks_m(&planform), vec![0.0399]);
    }

    #[test]
    fn a_rod_may_stop_before_the_tip() {
        let (layout, planform) = layout(&[[0.0, 30.0]], "").unwrap();
        assert_eq!(layout.rod_piece_at(0.031), None);
        assert_eq!(layout.rod_breaks_m(&planform), vec![0.030]);
    }

    #[test]
    fn spars_are_ordered_from_the_base_and_keep_their_index() {
        let (layout, _) = layout(
            &[[0.0, 70.0]],
            "at_mm = 40.0,trailing_edge_at_mm = 50.0;at_mm = 10.0",
        )
        .unwrap();
        assert_eq!(
            layout.spars[0],
            SparLine {
                index: 1,
                leading_edge_m: 0.010,
                trailing_edge_m: 0.010
            }
        );
        assert_eq!(
            layout.spars[1],
            SparLine {
                index: 0,
                leading_edge_m: 0.040,
                trailing_edge_m: 0.050
            }
        );
    }

    #[test]
    fn impossible_layouts_are_refused_with_the_cure() {
        let message = |rods: &[[f64; 2]], spars: &str| layout(rods, spars).unwrap_err().to_string();
        let rod = [[0.0, 70.0]];
        assert_eq!(
            message(&[[0.0, 30.0], [35.0, 70.0]], ""),
            "rod[1].from_mm = 35: leaves a gap in the rod; set it to 30"
        );
        assert_eq!(
            message(&[[0.0, 30.0], [25.0, 70.0]], ""),
            "rod[1].from_mm = 25: overlaps the piece before it; set it to 30"
        );
        assert_eq!(
            message(&[[0.0, 90.0]], ""),
            "rod[0] runs from 0 to 90 mm: to_mm must be larger than from_mm and not beyond length_mm = 70"
        );
        assert_eq!(
            message(&rod, "at_mm = 70.0"),
            "spar[0].at_mm = 70: off the wing, which is built from 0 to 69.3 mm (length_mm × tip_cut)"
        );
        assert_eq!(
            message(&rod, "at_mm = 20.0,trailing_edge_at_mm = 40.0;at_mm = 30.0"),
            "spar[0] and spar[1] cross or touch at the trailing edge (40 and 30 mm); \
             move one of them so that they keep the same order at both edges"
        );
        assert_eq!(
            message(&rod, "at_mm = 0.0,trailing_edge_at_mm = 4.0"),
            "spar[0] touches the root edge with one end only; set both ends to 0 mm, or keep both off it"
        );
    }
}
