//! The `washout` program: parse, call one verb, print.
fn main() {}
