//! What depends on which nodes hang together alone, and so is made once for all structures of one mesh: the order of elimination, where each entry of
//! the stiffness stands, and where those of its factor will.

use std::sync::{Arc, OnceLock};

use faer::sparse::linalg::cholesky::SymbolicCholesky;

use super::StructureError;
use super::factor::analysed;
use super::model::Model;
use super::pattern::Pattern;

/// Pattern and symbolic factorization of a structure.
#[derive(Clone)]
pub struct Analysis {
    /// Pattern of its stiffness.
    pub pattern: Arc<Pattern>,
    /// Where the entries of its factor will stand.
    pub symbolic: Arc<SymbolicCholesky<usize>>,
    shells: Arc<[[usize; 3]]>,
    beams: Arc<[[usize; 2]]>,
}

impl std::fmt::Debug for Analysis {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Analysis")
            .field("pattern", &self.pattern)
            .finish()
    }
}

impl Analysis {
    /// Of a structure.
    ///
    /// # Errors
    /// If the analysis runs out of memory.
    pub fn of(model: &Model) -> Result<Analysis, StructureError> {
        let pattern = model.pattern();
        Ok(Analysis {
            symbolic: Arc::new(analysed(&pattern)?),
            pattern: Arc::new(pattern),
            shells: model.shells.iter().map(|shell| shell.nodes).collect(),
            beams: model.beams.iter().map(|beam| beam.nodes).collect(),
        })
    }

    /// Whether the nodes of a structure hang together as those that were analysed.
    pub fn is_of(&self, model: &Model) -> bool {
        6 * model.nodes.len() == self.pattern.len()
            && model
                .shells
                .iter()
                .map(|shell| shell.nodes)
                .eq(self.shells.iter().copied())
            && model
                .beams
                .iter()
                .map(|beam| beam.nodes)
                .eq(self.beams.iter().copied())
    }
}

/// An analysis that structures of one mesh share; the first that asks makes it.
#[derive(Debug, Clone, Default)]
pub struct SharedAnalysis(Arc<OnceLock<Analysis>>);

impl SharedAnalysis {
    /// Of a structure: the shared one if it is of it.
    ///
    /// # Errors
    /// As [`Analysis::of`].
    pub fn of(&self, model: &Model) -> Result<Analysis, StructureError> {
        if let Some(known) = self.0.get().filter(|known| known.is_of(model)) {
            return Ok(known.clone());
        }
        let own = Analysis::of(model)?;
        // of two that ask first at once, either is as good
        let _ = self.0.set(own.clone());
        Ok(own)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::structure::{Beam, Section};

    fn chain(of: [[usize; 2]; 2]) -> Model {
        let mut model = Model::new((0..3).map(|i| Vector3::new(f64::from(i), 0.0, 0.0)).collect());
        model.sections.push(Section::uncoupled(1.0, 1.0, 1.0, 1.0));
        for nodes in of {
            let ends = nodes.map(|node| model.nodes[node]);
            let beam = Beam::new(nodes, ends, &Vector3::z(), 0, &model.sections[0]);
            model.beams.push(beam.unwrap());
        }
        model
    }

    #[test]
    fn an_analysis_is_shared_by_structures_that_hang_together_alike_and_by_no_other() {
        let shared = SharedAnalysis::default();
        let first = shared.of(&chain([[0, 1], [1, 2]])).unwrap();
        let alike = shared.of(&chain([[0, 1], [1, 2]])).unwrap();
        assert!(Arc::ptr_eq(&first.pattern, &alike.pattern));
        let other = shared.of(&chain([[0, 1], [0, 2]])).unwrap();
        assert!(!Arc::ptr_eq(&first.pattern, &other.pattern));
        assert!(other.is_of(&chain([[0, 1], [0, 2]])) && !first.is_of(&chain([[0, 1], [0, 2]])));
    }
}
