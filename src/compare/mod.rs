//! Measured minus modelled.
