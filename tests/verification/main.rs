//! The structure against published cases and closed forms.

mod roll_up;
