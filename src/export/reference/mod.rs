//! The reference pages of the documentation, from the schemas of files and outputs.

pub mod key;

pub mod tables;

pub mod design;

pub mod measurement;

pub mod outputs;
