//! Effects that the toy knows, and its nuisances.

/// An effect of the toy: its strength is an unknown of that name.
pub struct ToyEffect {
    pub name: &'static str,
    pub family: &'static str,
    pub unit: &'static str,
    pub scale: f64,
    pub one_sided: bool,
    pub place: Option<f64>,
}

/// Name, unit and prior standard deviation.
pub const NUISANCES: &[(&str, &str, f64)] = &[
    ("ln_g", "1", 0.05),
    ("ln_cn", "1", 0.06),
    ("root_angle", "deg", 1.0),
    ("camera_offset", "deg", 0.3),
];

const fn effect(name: &'static str, family: &'static str, scale: f64, one_sided: bool) -> ToyEffect {
    ToyEffect {
        name,
        family,
        unit: "1",
        scale,
        one_sided,
        place: None,
    }
}

const fn damage(name: &'static str, place: f64) -> ToyEffect {
    ToyEffect {
        name,
        family: "damage",
        unit: "rad/(N m)",
        scale: 150.0,
        one_sided: true,
        place: Some(place),
    }
}

/// All effects, in the order of their unknowns (after the nuisances).
pub const EFFECTS: &[ToyEffect] = &[
    effect("stiffness", "stiffness", 0.2, false),
    effect("coefficient_scale", "coefficient_scale", 0.2, false),
    effect("root_compliance", "root_compliance", 120.0, true),
    effect("clamp_slip", "clamp_slip", 180.0, true),
    effect("tip_loss_exponential", "tip_loss", 0.7, true),
    effect("tip_loss_cutoff", "tip_loss", 0.5, true),
    effect("inflow_uniform", "inflow", 1.0, true),
    effect("inflow_linear", "inflow", 1.0, true),
    effect("lift_gain", "lift_gain", 0.6, false),
    effect("centrifugal", "centrifugal", 0.4, true),
    effect("geometric_stiffening", "geometric_stiffening", 0.6, true),
    effect("film_tension", "film_tension", 0.8, true),
    effect("gravity", "gravity", 0.6, false),
    effect("inertia", "inertia", 0.6, false),
    effect("rotational_damping", "rotational_damping", 0.8, false),
    effect("tip_mass", "tip_mass", 1.0, false),
    damage("damage_10", 7.5 / 48.0),
    damage("damage_20", 11.5 / 48.0),
    damage("damage_30", 15.5 / 48.0),
    damage("damage_40", 19.5 / 48.0),
    damage("damage_50", 24.5 / 48.0),
    damage("damage_60", 29.5 / 48.0),
    damage("damage_70", 33.5 / 48.0),
    damage("damage_80", 38.5 / 48.0),
    effect("rod_short", "rod_short", 0.4, true),
    effect("taper", "taper", 0.3, false),
    effect("camera_scale", "camera_scale", 0.05, false),
    effect("camera_tilt", "camera_tilt", 1.5, false),
    effect("stall", "stall", 0.6, true),
    effect("pressure_centre", "pressure_centre", 0.5, false),
    effect("reynolds", "reynolds", 0.15, false),
    effect("frequency_error", "frequency_error", 0.03, false),
];
