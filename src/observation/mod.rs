//! Twist and other channels as an instrument sees them.
