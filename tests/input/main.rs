//! The input room from outside: every fault of a file with its exact message, and files that must be accepted.

mod bad_designs;

mod bad_files;

mod bad_measurements;
mod bad_studies;
mod bad_videos;

mod properties;

mod ribs;

mod settings;

mod sheets;

mod shipped;
