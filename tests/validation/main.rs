//! Bench wings: the designs against independent solutions of the same beams, and against what was measured on them.
//!
//! Figures against measurements stand as they come out: they are findings, and a test of them fails when they move.

mod minguet;

mod pazy;

mod pre_pazy;

mod ribs;

mod support;

mod tang_dowell;
