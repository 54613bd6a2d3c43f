//! Design, study, measurement and material files: the only room that reads files.

pub mod design;

pub mod quantity;

pub mod error;

pub mod schema;

pub mod assumption;

pub mod expression;

pub mod measurement;

pub mod study;

pub mod sheet;

pub mod video;

pub mod stock;

pub mod twist_table;

mod air_table;

mod load;

mod named;

mod seen_from;

mod set;

mod syntax;

mod table;

mod check;

mod checked;

mod document;

#[cfg(feature = "cli")]
pub mod drawing;

mod file;

mod form;

mod keys;

mod nearest;

mod numbers;

mod path;

mod polar;

mod unit;

pub use assumption::{Assumption, Choice};
pub use check::{place_in, refused_in};
pub use design::Design;
pub use error::{InputError, Place, Problem, Range};
pub use expression::{Expression, ExpressionError};
pub use load::Loaded;
pub use nearest::nearest;
pub use numbers::DesignNumber;
pub use seen_from::seen_from;
pub use set::effect_key;
pub use twist_table::TwistTable;
pub use unit::unit_symbol;
