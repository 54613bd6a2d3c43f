//! Mesh files: written and read back, made by others, broken.

mod bad_files;
mod generator;
mod import;
mod round_trip;
mod shipped;
mod third_party;
