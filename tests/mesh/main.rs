//! Mesh files: written and read back, made by others, broken.

mod bad_files;
mod round_trip;
mod third_party;
