//! The page of a run: what its builder wants to know besides the twist.

use std::fmt::Write;

use super::warnings::SLOW_RATIO;
use crate::coupling::{Engineering, Extreme};
use crate::page::text::{number, significant};

/// A margin beyond this says that the part carries nothing but rounding.
const NO_STRESS: f64 = 1e6;

/// Mass, inertia, frequencies, stresses and margins; empty if there are none. `film_carries`: the film does not wrinkle.
pub fn engineering(engineering: &Engineering, film_carries: bool) -> String {
    let mut text = String::from("For the builder\n");
    let empty = text.len();
    if let Some(mass) = engineering.mass_mg {
        line(&mut text, "mass", &format!("{} mg", significant(mass, 4)));
    }
    if let Some(inertia) = engineering.inertia_flapping_g_mm2 {
        line(
            &mut text,
            "inertia",
            &format!("{} g mm² about the flapping axis", significant(inertia, 4)),
        );
    }
    if let Some(inertia) = engineering.inertia_pitch_g_mm2 {
        line(
            &mut text,
            if engineering.inertia_flapping_g_mm2.is_some() {
                ""
            } else {
                "inertia"
            },
            &format!("{} g mm² about the leading edge", significant(inertia, 4)),
        );
    }
    let [in_vacuum, in_air] = [
        &engineering.natural_frequencies_hz,
        &engineering.natural_frequencies_in_air_hz,
    ]
    .map(|all| all.first());
    if let Some(lowest) = in_vacuum {
        let in_air = in_air.map_or(String::new(), |lowest| {
            format!(", {} Hz with the air it moves", number(*lowest, 1))
        });
        line(
            &mut text,
            "frequency",
            &format!("lowest natural {} Hz{in_air}", number(*lowest, 1)),
        );
    }
    if let Some(ratio) = engineering.frequency_ratio {
        line(&mut text, "", &stillness(ratio));
    }
    if engineering.unstable_directions > 0 {
        let count = engineering.unstable_directions;
        line(
            &mut text,
            "frequency",
            &format!("none: the loaded shape would run away in {count} directions"),
        );
    }
    for (name, extreme) in [
        ("rod shear", &engineering.rod_shear_stress),
        ("rod bending", &engineering.rod_bending_stress),
        ("spars", &engineering.spar_stress),
        ("film", &engineering.film_stress),
    ] {
        if let Some(extreme) = extreme {
            line(&mut text, name, &stress(extreme));
        }
    }
    if let Some(tension) = engineering.film_tension_max_n_per_m {
        line(
            &mut text,
            "",
            &format!("largest tension {} N/m", significant(tension, 3)),
        );
    }
    if let Some(tension) = engineering.film_tension_min_n_per_m {
        line(
            &mut text,
            "",
            &format!("smallest tension {} N/m", significant(tension, 3)),
        );
    }
    if let Some(share) = engineering.film_wrinkled_share {
        let state = if film_carries {
            "pressed in some direction, which it carries"
        } else {
            "wrinkled or slack"
        };
        line(
            &mut text,
            "",
            &format!("{} % of its area is {state}", number(100.0 * share, 0)),
        );
    }
    if text.len() == empty { String::new() } else { text }
}

/// Whether a shape that follows its load at once is right: a mode at `ratio` times the flapping answers a harmonic load
/// 1/(1 − 1/ratio²) times as much as a slow one.
fn stillness(ratio: f64) -> String {
    let times = format!("{} times the flapping", number(ratio, 2));
    if ratio < SLOW_RATIO {
        return format!("{times}: too near it, the shape does not follow the load (not quasi-static)");
    }
    let excess = number(100.0 / (ratio * ratio - 1.0), 0);
    let third = if (ratio - 3.0).abs() < 0.75 {
        "; its third harmonic is near"
    } else {
        ""
    };
    format!("{times}: quasi-static within about {excess} %{third}")
}

fn stress(extreme: &Extreme) -> String {
    let margin = match (extreme.strength_mpa, extreme.margin) {
        (Some(strength), Some(margin)) => {
            format!(
                "; strength {} MPa, margin {}",
                significant(strength, 3),
                if margin > NO_STRESS {
                    "–".to_string()
                } else {
                    significant(margin, 3)
                }
            )
        }
        _ => "; strength not stated".to_string(),
    };
    format!(
        "{} MPa at {} mm{margin}",
        significant(extreme.stress_mpa, 3),
        number(extreme.r_mm, 1)
    )
}

/// Adds a line to a page: a name and what it is.
pub(super) fn line(text: &mut String, name: &str, value: &str) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "  {name:<12}{value}");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stillness_is_judged_by_the_answer_of_one_mode() {
        assert_eq!(
            stillness(5.0),
            "5.00 times the flapping: quasi-static within about 4 %"
        );
        assert!(stillness(3.0).ends_with("within about 12 %; its third harmonic is near"));
        assert!(stillness(1.0).contains("not quasi-static"));
    }

    #[test]
    fn an_unstable_shape_is_said_to_have_no_frequency() {
        let unstable = Engineering {
            unstable_directions: 2,
            ..Engineering::default()
        };
        let text = engineering(&unstable, false);
        assert!(text.contains("run away in 2 directions"), "{text}");
        assert_eq!(engineering(&Engineering::default(), false), "");
    }

    #[test]
    fn what_carries_is_not_called_wrinkled_and_inertia_keeps_its_label_without_flapping() {
        let found = Engineering {
            inertia_pitch_g_mm2: Some(2.0),
            film_wrinkled_share: Some(0.5),
            ..Engineering::default()
        };
        let [wrinkles, carries] = [false, true].map(|carries| engineering(&found, carries));
        assert!(
            wrinkles.contains("wrinkled") && !carries.contains("wrinkled"),
            "{carries}"
        );
        assert!(carries.contains("inertia"), "{carries}");
    }

    #[test]
    fn a_margin_of_rounding_is_not_printed() {
        let of = |margin| {
            stress(&Extreme {
                stress_mpa: 1.0,
                r_mm: 2.0,
                strength_mpa: Some(3.0),
                margin: Some(margin),
            })
        };
        assert!(
            of(9e15).ends_with("margin –") && of(3.0).ends_with("margin 3.00"),
            "{}",
            of(3.0)
        );
    }
}
