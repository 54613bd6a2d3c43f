//! Air and structure together: load and shape transfer, residual, fixed point, sensitivity.

pub mod solution;
