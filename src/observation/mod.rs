//! Twist and other channels as an instrument sees them.

pub mod broken_line;

pub mod stages;
