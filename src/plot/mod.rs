//! Pictures as SVG: charts, heat maps and numbers that fall step by step, drawn from numbers; knows no wings.
//!
//! A [`Figure`] is data: panels with marks, a legend, a caption. [`Figure::to_svg`] draws it, the same bytes for the same
//! figure. Colours are those of Okabe and Ito (readable by colour-blind people); what colour says, shape or weight says
//! too, so that a picture survives a printer without colour: what was fitted is filled, what was held out is hollow, the
//! model as stated is thin, the calibrated one thick.
//!
//! Drawn by `plotters` 0.3.7 without its default features: three crates besides `num-traits`, 2 s to build, escaped text,
//! nothing random. `kuva` 0.6, the other candidate, has the finer builders, but took 48 s to build (95,000 lines, most of
//! them plots that nobody needs here) and changes its interface often. What `plotters` lacks is made up for here: it places
//! on whole units only (so a pixel is ten of them), and its legend lies on the data (so [`Key`]s stand above it).

pub mod chart;

pub mod error;

pub mod figure;

pub mod heat_map;

pub mod palette;

pub mod pen;

pub mod print;

pub mod scale;

pub mod terminal;

pub mod stair;

pub use chart::{Chart, Limit, Mark, Point, Weight};
pub use error::PlotError;
pub use figure::{Figure, Key, Panel, Sample};
pub use heat_map::{HeatMap, HeatTable};
pub use palette::{Ink, Shape};
pub use print::Print;
pub use stair::{Stair, Step};
