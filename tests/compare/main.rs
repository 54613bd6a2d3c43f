//! Comparison with the measurements that are shipped.

mod studies;
mod torsion_rod;
mod twisting_wings;
mod video;
