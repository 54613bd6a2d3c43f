//! Progress and cancelling.
