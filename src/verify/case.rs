//! What a case is: its references with their source, how near the solver must come, and how it is run.

use crate::progress::Progress;

use super::VerifyError;

/// A published case, or one with a closed form.
#[derive(Debug, Clone, Copy)]
pub struct Case {
    /// Name, that of its file with `-` for `_`.
    pub name: &'static str,
    /// What it is, in a few words.
    pub title: &'static str,
    /// Whether it asks for the equations or for nature.
    pub kind: Kind,
    /// What is compared.
    pub quantities: &'static [Quantity],
    /// The one mesh of the short version: the coarsest that is within tolerance.
    pub short: Level,
    /// Runs it on one mesh; the values come in the order of `quantities`.
    pub run: fn(Level, &Progress) -> Result<Answer, VerifyError>,
}

/// What a case proves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// That the equations are solved right: against a closed form or another solver of the same equations.
    Verification,
    /// That they are the right equations: against a measurement.
    Validation,
}

/// One number or one curve of a case.
#[derive(Debug, Clone, Copy)]
pub struct Quantity {
    /// What it is, in words.
    pub name: &'static str,
    /// Its unit; "1" if it has none.
    pub unit: &'static str,
    /// The reference: one value, or the points of a curve.
    pub reference: fn() -> Vec<f64>,
    /// Where the reference comes from.
    pub source: &'static str,
    /// How sure the reference is.
    pub confidence: Confidence,
    /// Largest error allowed, relative.
    pub tolerance: f64,
    /// What an error of a curve is relative to.
    pub scale: Scale,
    /// The order of convergence that is expected.
    pub order: Order,
    /// Other references, shown and never judged.
    pub others: &'static [Other],
}

/// How sure a reference is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Confidence {
    /// Read in a public transcription of the publication.
    Seen,
    /// A closed form, or an independent numerical solution.
    Derived,
    /// From memory: shown, never a pass mark.
    Memory,
}

/// What the errors of a curve are relative to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Each to its own reference.
    Own,
    /// All to the largest reference.
    Largest,
}

/// The order at which the error should fall with the size of the elements.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Order {
    /// From theory; the observed one must be within 0.2 of it.
    Theory(f64),
    /// Theory gives none, for this reason.
    Exempt(&'static str),
}

/// A reference beside the one that judges.
#[derive(Debug, Clone, Copy)]
pub struct Other {
    /// Its value, as printed there.
    pub value: &'static str,
    /// Where it stands.
    pub source: &'static str,
    /// How sure it is.
    pub confidence: Confidence,
}

/// One of the three meshes of a case; each has half the element size of the one before.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Coarse.
    Coarse,
    /// Middle.
    Middle,
    /// Fine.
    Fine,
}

/// What the solver makes of a case on one mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The mesh, in words: "16 × 16".
    pub mesh: String,
    /// The values of each quantity.
    pub values: Vec<Vec<f64>>,
}

impl Quantity {
    /// A single value that is exempt from nothing yet: fields are set over it.
    pub const BLANK: Quantity = Quantity {
        name: "",
        unit: "1",
        reference: Vec::new,
        source: "",
        confidence: Confidence::Derived,
        tolerance: 0.0,
        scale: Scale::Own,
        order: Order::Exempt(""),
        others: &[],
    };
}

impl Level {
    /// From coarse to fine.
    pub const ALL: [Level; 3] = [Level::Coarse, Level::Middle, Level::Fine];

    /// 0, 1, 2.
    pub fn index(self) -> usize {
        match self {
            Level::Coarse => 0,
            Level::Middle => 1,
            Level::Fine => 2,
        }
    }

    /// A count that doubles from mesh to mesh.
    pub fn times(self, coarse: usize) -> usize {
        coarse << self.index()
    }

    /// In a word.
    pub fn word(self) -> &'static str {
        match self {
            Level::Coarse => "coarse",
            Level::Middle => "middle",
            Level::Fine => "fine",
        }
    }
}

impl Answer {
    /// One value per quantity.
    pub fn new<const N: usize>(mesh: impl Into<String>, values: [f64; N]) -> Self {
        Answer {
            mesh: mesh.into(),
            values: values.map(|value| vec![value]).to_vec(),
        }
    }

    /// One curve per quantity.
    pub fn curves<const N: usize>(mesh: impl Into<String>, values: [Vec<f64>; N]) -> Self {
        Answer {
            mesh: mesh.into(),
            values: values.to_vec(),
        }
    }
}
