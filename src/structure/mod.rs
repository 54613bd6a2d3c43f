//! Beams, plate and membrane, supports, assembly, nonlinear solve, modes. Knows no air.

pub mod state;
