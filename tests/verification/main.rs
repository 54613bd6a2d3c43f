//! The structure against published cases (all of `verify::ALL`, each on one mesh) and proofs that need no publication.

mod cases;

mod bulged_plate;
mod drilling;

mod optimal_triangle;

mod page;

mod patch_tests;

mod prestressed_film;

mod rigid_motion;

mod sheared_panel;

mod support;

mod whole_load;
