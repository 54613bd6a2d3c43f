//! The page of a run: what its builder wants to know besides the twist.

use super::warnings::SLOW_RATIO;
use crate::coupling::{Engineering, Extreme};
use crate::page::Line;
use crate::page::text::{number, significant};

/// A margin beyond this says that the part carries nothing but rounding.
const NO_STRESS: f64 = 1e6;

/// Mass, inertia, frequencies, stresses and margins, each with its name; empty if there are none. `film_carries`: the film does not
/// wrinkle.
pub fn engineering(engineering: &Engineering, film_carries: bool) -> Vec<Line> {
    let mut lines = Vec::new();
    let mut line =
        |name, words: Option<String>| lines.extend(words.map(|words| Line::new(name).words(words)));
    let of = |value: Option<f64>, digits, unit: &str| {
        value.map(|value| format!("{} {unit}", significant(value, digits)))
    };
    line("mass", of(engineering.mass_mg, 4, "mg"));
    let flapping = engineering.inertia_flapping_g_mm2;
    let about = |axis: &str| format!("g mm² about the {axis}");
    line("inertia", of(flapping, 4, &about("flapping axis")));
    let name = if flapping.is_some() { "" } else { "inertia" };
    line(
        name,
        of(engineering.inertia_pitch_g_mm2, 4, &about("leading edge")),
    );
    line("frequency", lowest(engineering));
    line("", engineering.frequency_ratio.map(stillness));
    let away = engineering.unstable_directions;
    let runs_away = || format!("none: the loaded shape would run away in {away} directions");
    line("frequency", (away > 0).then(runs_away));
    line("rod shear", engineering.rod_shear_stress.as_ref().map(stress));
    line("rod bending", engineering.rod_bending_stress.as_ref().map(stress));
    line("spars", engineering.spar_stress.as_ref().map(stress));
    line("film", engineering.film_stress.as_ref().map(stress));
    for (which, tension) in [
        ("largest", engineering.film_tension_max_n_per_m),
        ("smallest", engineering.film_tension_min_n_per_m),
    ] {
        line(
            "",
            of(tension, 3, "N/m").map(|tension| format!("{which} tension {tension}")),
        );
    }
    let state = match film_carries {
        true => "pressed in some direction, which it carries",
        false => "wrinkled or slack",
    };
    let share = engineering.film_wrinkled_share;
    line(
        "",
        share.map(|share| format!("{} % of its area is {state}", number(100.0 * share, 0))),
    );
    lines
}

fn lowest(engineering: &Engineering) -> Option<String> {
    let lowest = engineering.natural_frequencies_hz.first()?;
    let in_air = engineering.natural_frequencies_in_air_hz.first();
    let in_air = in_air.map(|lowest| format!(", {} Hz with the air it moves", number(*lowest, 1)));
    Some(format!(
        "lowest natural {} Hz{}",
        number(*lowest, 1),
        in_air.unwrap_or_default()
    ))
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
        let lines = engineering(&unstable, false);
        assert!(lines[0].text().contains("run away in 2 directions"), "{lines:?}");
        assert!(engineering(&Engineering::default(), false).is_empty());
    }

    #[test]
    fn what_carries_is_not_called_wrinkled_and_inertia_keeps_its_label_without_flapping() {
        let found = Engineering {
            inertia_pitch_g_mm2: Some(2.0),
            film_wrinkled_share: Some(0.5),
            ..Engineering::default()
        };
        let [wrinkles, carries] = [false, true].map(|carries| engineering(&found, carries));
        let is_wrinkled = |lines: &[Line]| lines[1].text().contains("wrinkled");
        assert!(is_wrinkled(&wrinkles) && !is_wrinkled(&carries), "{carries:?}");
        assert_eq!(carries[0].name, "inertia");
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
