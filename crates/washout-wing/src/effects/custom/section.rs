//! A place of the span, as a formula sees it.

use crate::effects::StripPlace;
use crate::input::design::Design;

/// A place of the span, as a formula sees it, without angle and speed.
#[derive(Debug, Clone, Copy)]
pub struct Section<'a> {
    pub design: &'a Design,
    pub r_m: f64,
    pub chord_m: f64,
    pub root_angle_rad: f64,
    pub density_kg_m3: f64,
    pub twist_rate_rad_s: f64,
}

impl<'a> Section<'a> {
    /// Of a strip.
    pub fn of(place: &StripPlace<'a>) -> Self {
        Section {
            design: place.design,
            r_m: place.r_m,
            chord_m: place.chord_m,
            root_angle_rad: place.root_angle_rad,
            density_kg_m3: place.density_kg_m3,
            twist_rate_rad_s: place.twist_rate_rad_s(),
        }
    }
}
