//! Names of the sets in mesh files: `rod-0`, `spar-2`, `rib-1`, `membrane`, `root`, `leading-edge`, `trailing-edge`.

use std::fmt;

use super::BeamPart;

/// A named set of a mesh file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum SetName {
    /// Root chord.
    Root,
    /// Leading edge.
    LeadingEdge,
    /// Trailing edge.
    TrailingEdge,
    /// The film's triangles.
    Membrane,
    /// A rod piece, a spar or a rib.
    Beam(BeamPart),
}

impl SetName {
    /// The set with this name.
    pub fn parse(name: &str) -> Option<SetName> {
        // Only plain digits without leading zeros: one name per set.
        let index = |digits: &str| {
            digits
                .parse::<usize>()
                .ok()
                .filter(|n| n.to_string() == digits && *n < 10_000)
        };
        Some(match name {
            "root" => SetName::Root,
            "leading-edge" => SetName::LeadingEdge,
            "trailing-edge" => SetName::TrailingEdge,
            "membrane" => SetName::Membrane,
            _ => SetName::Beam(match name.split_once('-')? {
                ("rod", digits) => BeamPart::Rod(index(digits)?),
                ("spar", digits) => BeamPart::Spar(index(digits)?),
                ("rib", digits) => BeamPart::Rib(index(digits)?),
                _ => return None,
            }),
        })
    }
}

impl fmt::Display for BeamPart {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            BeamPart::Rod(index) => write!(f, "rod-{index}"),
            BeamPart::Spar(index) => write!(f, "spar-{index}"),
            BeamPart::Rib(index) => write!(f, "rib-{index}"),
        }
    }
}

impl fmt::Display for SetName {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            SetName::Root => f.write_str("root"),
            SetName::LeadingEdge => f.write_str("leading-edge"),
            SetName::TrailingEdge => f.write_str("trailing-edge"),
            SetName::Membrane => f.write_str("membrane"),
            SetName::Beam(part) => part.fmt(f),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_read_back_and_no_other() {
        let parts = [BeamPart::Rod(0), BeamPart::Rod(12), BeamPart::Spar(3)].map(SetName::Beam);
        let fixed = [
            SetName::Root,
            SetName::LeadingEdge,
            SetName::TrailingEdge,
            SetName::Membrane,
        ];
        for name in parts.into_iter().chain(fixed) {
            assert_eq!(SetName::parse(&name.to_string()), Some(name));
        }
        for wrong in [
            "",
            "rod",
            "rod-",
            "rod-01",
            "rod-+1",
            "rod--1",
            "Spar-1",
            "spar_1",
            "film",
            "rod-99999999999999",
        ] {
            assert_eq!(SetName::parse(wrong), None, "{wrong}");
        }
    }
}
