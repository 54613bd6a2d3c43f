//! The native half of the Python package `washout`: wings, comparisons and diagnoses of the library, and any verb, without Python's lock.
//!
//! What Python sees of it is typed in `washout/_washout.pyi`; people use the modules beside that file.

mod arrays;
mod failure;
mod run;
mod solved;
mod study;
mod verb;
mod wing;
mod worker;

/// The module that the Python package imports.
#[pyo3::pymodule]
mod _washout {
    #[pymodule_export]
    use crate::run::Run;
    #[pymodule_export]
    use crate::solved::Solved;
    #[pymodule_export]
    use crate::study::{compare, diagnose};
    #[pymodule_export]
    use crate::verb::run;
    #[pymodule_export]
    use crate::wing::Wing;
}
