//! The structure against published cases and closed forms.

mod bend_45_degrees;

mod cook_membrane;

mod elastica;

mod natural_frequencies;

mod patch_tests;

mod princeton_beam;

mod rigid_motion;

mod roll_up;

mod support;
