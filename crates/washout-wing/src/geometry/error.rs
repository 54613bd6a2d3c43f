//! What can be wrong with the geometry of a design, and the cure.

/// An impossible planform or layout. Lengths in mm, as in the design file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum GeometryError {
    /// A length or fraction is outside its range, or not a number.
    #[error("planform.{key} = {value}: must be {allowed}")]
    Value {
        /// Key below `planform`.
        key: &'static str,
        /// What stands there.
        value: f64,
        /// The allowed range in words.
        allowed: &'static str,
    },
    /// Neither moments nor an outline.
    #[error(
        "planform: no shape; give mean_chord_mm and r2_hat (or r1_hat and r2_hat), or outline = [[r_mm, chord_mm], …]"
    )]
    NoShape,
    /// Two shapes at once.
    #[error("planform: both outline and {key} stand there; keep one of them")]
    TwoShapes {
        /// The key that contradicts the outline.
        key: &'static str,
    },
    /// No beta distribution has these radii.
    #[error(
        "planform.r2_hat = {r2_hat} with r1_hat = {r1_hat:.4}{origin}: no chord distribution has these, it needs \
         r1_hat < r2_hat < √r1_hat{}; leave r1_hat out to have it from r2_hat (between 0.01 and 0.75)",
        if *.r1_hat > 0.0 && *.r1_hat < 1.0 { format!(" = {:.4}", .r1_hat.sqrt()) } else { String::new() }
    )]
    ImpossibleRadii {
        /// First moment.
        r1_hat: f64,
        /// Second moment.
        r2_hat: f64,
        /// Where r1_hat comes from, in words; empty if given.
        origin: &'static str,
    },
    /// An outline that is no outline.
    #[error("planform.outline, point {} [{r_mm}, {chord_mm}]: {problem}", .index + 1)]
    Outline {
        /// Index of the point, from 0.
        index: usize,
        /// Its span position, mm.
        r_mm: f64,
        /// Its chord, mm.
        chord_mm: f64,
        /// What is wrong and the cure.
        problem: &'static str,
    },
    /// A drawn outline that is no wing.
    #[error("{problem}; {cure}")]
    Drawn {
        /// What is wrong with it.
        problem: String,
        /// The cure.
        cure: &'static str,
    },
    /// Too few points.
    #[error("planform.outline has {points} point(s): it needs at least 2, [r_mm, chord_mm] with r rising")]
    ShortOutline {
        /// Number of points.
        points: usize,
    },
    /// The outline does not reach both ends of the built wing.
    #[error(
        "planform.outline runs from {from_mm} to {to_mm} mm, but the wing is built from {needed_from_mm} to \
         {needed_to_mm} mm; add points, or change length_mm, base_closure or tip_cut"
    )]
    OutlineTooShort {
        /// First r of the outline.
        from_mm: f64,
        /// Last r of the outline.
        to_mm: f64,
        /// Where the chord is first needed.
        needed_from_mm: f64,
        /// Where it is last needed.
        needed_to_mm: f64,
    },
    /// The chord runs to zero where an edge is needed.
    #[error(
        "planform: the chord is {chord_mm:.6} mm at r = {at_mm:.3} mm, where the {end} edge stands; {cure}"
    )]
    NoChord {
        /// Place, mm.
        at_mm: f64,
        /// Chord there, mm.
        chord_mm: f64,
        /// "root" or "tip".
        end: &'static str,
        /// What to change.
        cure: &'static str,
    },
    /// A rod piece that does not continue the one before it.
    #[error("rod[{index}].from_mm = {from_mm}: {}; set it to {expected_mm}", if *.from_mm > *.expected_mm { "leaves a gap in the rod" } else { "overlaps the piece before it" })]
    RodJoint {
        /// Index of the piece.
        index: usize,
        /// Where it starts.
        from_mm: f64,
        /// Where it should start.
        expected_mm: f64,
    },
    /// A rod piece without length.
    #[error(
        "rod[{index}] runs from {from_mm} to {to_mm} mm: to_mm must be larger than from_mm and not beyond length_mm = {length_mm}"
    )]
    RodLength {
        /// Index of the piece.
        index: usize,
        /// Start.
        from_mm: f64,
        /// End.
        to_mm: f64,
        /// Length of the wing.
        length_mm: f64,
    },
    /// No rod at all.
    #[error("the design has no rod; add a [[rod]] from_mm = 0")]
    NoRod,
    /// A spar end off the wing.
    #[error(
        "spar[{index}].{key} = {at_mm}: off the wing, which is built from 0 to {tip_mm} mm (length_mm × tip_cut)"
    )]
    SparOffWing {
        /// Index of the spar.
        index: usize,
        /// `at_mm` or `trailing_edge_at_mm`.
        key: &'static str,
        /// What stands there.
        at_mm: f64,
        /// End of the wing as built.
        tip_mm: f64,
    },
    /// Two spars that cross or touch.
    #[error(
        "spar[{first}] and spar[{second}] cross or touch at the {edge} edge ({first_mm} and {second_mm} mm); \
         move one of them so that they keep the same order at both edges"
    )]
    SparsCross {
        /// The spar that is inboard at the leading edge.
        first: usize,
        /// The other one.
        second: usize,
        /// "leading" or "trailing".
        edge: &'static str,
        /// End of the first at that edge.
        first_mm: f64,
        /// End of the second at that edge.
        second_mm: f64,
    },
    /// An oblique spar that touches an end of the wing with one of its ends only.
    #[error(
        "spar[{index}] touches the {end} edge with one end only; set both ends to {at_mm} mm, or keep both off it"
    )]
    SparOnEnd {
        /// Index of the spar.
        index: usize,
        /// "root" or "tip".
        end: &'static str,
        /// Span position of that edge.
        at_mm: f64,
    },
}

/// Metres to mm, rounded to the nanometre, for messages.
pub(super) fn rounded_mm(metres: f64) -> f64 {
    (metres * 1e9).round() / 1e6
}
