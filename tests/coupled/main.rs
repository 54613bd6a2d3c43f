//! Air and structure together: load transfer, divergence, tangent, sensitivity, independence of numerics.

mod difference;
mod film;
mod independence;
mod invariances;
mod load_transfer;
mod mesh_error;
mod mesh_study;
mod random_wing;
mod reliability;
mod sensitivity;
mod support;
mod tangent;
mod uniform_wing;
mod warm_start;
