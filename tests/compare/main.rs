//! Comparison with the measurements that are shipped.

mod torsion_rod;
mod twisting_wings;
