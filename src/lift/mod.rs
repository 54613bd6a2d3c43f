//! Stroke means of lift, drag and power.
