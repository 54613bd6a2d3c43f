//! Air and structure together: load transfer, divergence, tangent, sensitivity, independence of numerics.

mod load_transfer;
mod support;
mod uniform_wing;
