//! Design, study, measurement and material files: the only room that reads files.

pub mod design;

pub mod quantity;
