//! The structure against published cases and closed forms.

mod bend_45_degrees;

mod cook_membrane;

mod drilling;

mod elastica;

mod hencky_membrane;

mod lateral_buckling;

mod linear_shells;

mod macneal_straight_beam;

mod natural_frequencies;

mod nonlinear_shells;

mod patch_tests;

mod plates;

mod princeton_beam;

mod rigid_motion;

mod roll_up;

mod support;

mod taut_rectangle;

mod tension_field;

mod thick_cantilever;
