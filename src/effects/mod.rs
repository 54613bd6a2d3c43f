//! Physical effects that can be added to the base model, one file each.
