//! What a builder chooses: pieces of rod from the shelf, places of the spars, tension of the film.

use serde::{Deserialize, Serialize};

use crate::input::design::{Design, RodSegment, Section};
use crate::input::stock::StockRod;
use crate::input::{InputError, design::Spar};

/// A layout of rod, spars and film.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Layout {
    /// Pieces of the rod, from the base to the tip.
    pub pieces: Vec<Piece>,
    /// Places of the spars, mm; none: those of the design.
    pub spars_mm: Option<Vec<f64>>,
    /// Tension of the film, N/m; none: that of the design.
    pub pretension_n_per_m: Option<f64>,
}

/// A piece of rod.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Piece {
    /// The rod that it is cut from.
    pub rod: StockRod,
    /// Its outer end, mm from the base.
    pub to_mm: f64,
}

impl Layout {
    /// The design with this layout, checked as if it were read anew.
    ///
    /// # Errors
    /// If the design refuses it: a material that it does not know, spars off the wing or too near.
    pub fn applied(&self, design: &Design) -> Result<Design, InputError> {
        let mut changed = design.clone();
        let mut from_mm = 0.0;
        changed.rod = Vec::new();
        for piece in &self.pieces {
            changed.rod.push(RodSegment {
                from_mm: from_mm.into(),
                to_mm: piece.to_mm.into(),
                material: Some(piece.rod.material.clone()),
                section: piece.rod.section.clone(),
            });
            from_mm = piece.to_mm;
        }
        if let (Some(places), Some(first)) = (&self.spars_mm, design.spar.first()) {
            let spar = |at_mm: &f64| Spar {
                at_mm: (*at_mm).into(),
                trailing_edge_at_mm: None,
                ..first.clone()
            };
            changed.spar = places.iter().map(spar).collect();
        }
        if let (Some(tension), Some(film)) = (self.pretension_n_per_m, &mut changed.film) {
            film.pretension_n_per_m = tension.into();
        }
        // choices among words belong to pieces that may be gone
        changed
            .assumed_choice
            .retain(|choice| !choice.key.starts_with("rod") && !choice.key.starts_with("spar"));
        Design::from_toml(&changed.to_toml(), "layout")
    }

    /// The pieces in words: "half-1.0 to 39.9 mm, round-0.3 to 70.0 mm".
    pub fn words(&self) -> String {
        let words = self
            .pieces
            .iter()
            .map(|piece| format!("{} to {:.1} mm", piece.rod.name, piece.to_mm));
        let mut words: Vec<String> = words.collect();
        if let Some(spars) = &self.spars_mm {
            words.push(format!("{} spars", spars.len()));
        }
        if let Some(tension) = self.pretension_n_per_m {
            words.push(format!("film at {tension:.0} N/m"));
        }
        words.join(", ")
    }

    /// The layout with the boundary of two pieces moved; none if a piece would vanish.
    pub fn with_break(&self, index: usize, at_mm: f64) -> Option<Layout> {
        let mut moved = self.clone();
        moved.pieces.get_mut(index)?.to_mm = at_mm;
        let inner = if index == 0 {
            0.0
        } else {
            self.pieces[index - 1].to_mm
        };
        (inner < at_mm && at_mm < self.pieces.get(index + 1)?.to_mm).then_some(moved)
    }

    /// The layout with the diameter of a piece changed by so much; a tube keeps its wall. None if nothing would be left.
    pub fn with_diameter(&self, index: usize, more_mm: f64) -> Option<Layout> {
        let mut changed = self.clone();
        let section = &mut changed.pieces.get_mut(index)?.rod.section;
        let smallest = match section {
            Section::Round { diameter_mm } | Section::HalfRound { diameter_mm, .. } => {
                *diameter_mm = (diameter_mm.value() + more_mm).into();
                diameter_mm.value()
            }
            Section::Tube {
                outer_diameter_mm,
                inner_diameter_mm,
            } => {
                *outer_diameter_mm = (outer_diameter_mm.value() + more_mm).into();
                *inner_diameter_mm = (inner_diameter_mm.value() + more_mm).into();
                inner_diameter_mm.value()
            }
            _ => return None,
        };
        (smallest > 0.0).then_some(changed)
    }
}
