//! Planform and layout; the frame and the signs.
