//! The native half of the Python package `washout`: solves designs and runs verbs, without Python's lock.
//!
//! What Python sees of it is typed in `washout/_washout.pyi`; people use the modules beside that file.

mod arrays;
mod failure;
mod solved;
mod verb;
mod worker;

/// The module that the Python package imports.
#[pyo3::pymodule]
mod _washout {
    #[pymodule_export]
    use crate::solved::Solved;
    #[pymodule_export]
    use crate::solved::solve;
    #[pymodule_export]
    use crate::verb::run;
}
