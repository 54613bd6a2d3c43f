//! The physics that can be added, as a page of documentation: a table of all effects, then the card of each.

use std::fmt::Write;

use crate::effects::Card;
use crate::explore::Signature;

use crate::page::text::{number, significant};

/// The page in Markdown; the same cards give the same page.
pub fn effects_page(cards: &[Card]) -> String {
    let mut page = String::from(
        "# Physics that can be added\n\n\
         Written by `washout effects --page docs/effects.md` from the cards in `crates/washout-wing/src/effects`; a test compares the two.\n\n\
         Each effect is off until a design has its table, e.g. `[effects.gravity]` with `strength = 1.0`, or\n\
         `--set effects.gravity.strength=1`. A strength of 0 is the base model, bit for bit. Effects of one family are\n\
         rivals: other formulas of the same physics, or other causes of the same sight.\n\n\
         | effect | what happens | family | acts on |\n|---|---|---|---|\n",
    );
    for card in cards {
        let _ = writeln!(
            page,
            "| [{0}](#{0}) | {1} | {2} | {3} |",
            card.name,
            card.summary,
            card.family,
            format!("{:?}", card.seam).to_lowercase()
        );
    }
    for card in cards {
        let _ = write!(page, "\n## {}\n\n{}\n\n", card.name, card.summary);
        let channels: Vec<&str> = card.channels.iter().map(|channel| channel.name()).collect();
        let lines = [
            ("Formula", card.formula),
            ("Source", card.source),
            ("When right", card.when_right),
            ("What it gets wrong", card.gets_wrong),
            ("Changes", &channels.join(", ")),
            ("Checked by", &format!("`{}`", card.case)),
        ];
        for (name, line) in lines {
            let _ = writeln!(page, "- {name}: {line}");
        }
        page.push_str(
            "\n| number | unit | meaning | default | accepted | plausible |\n|---|---|---|---|---|---|\n",
        );
        for parameter in card.parameters {
            let ([low, high], [from, to]) = (parameter.range, parameter.plausible);
            let _ = writeln!(
                page,
                "| `{}` | {} | {} | {} | {low} to {high} | {from} to {to} |",
                parameter.name, parameter.unit, parameter.meaning, parameter.default
            );
        }
    }
    page
}

/// Columns of a bar on each side of zero.
const BAR: usize = 20;

/// What an effect does to the example wing, as a small picture: a bar for every station.
pub fn picture(signature: &Signature, unit: &str) -> String {
    let changes = signature.stations.iter().map(|station| station.change_deg.abs());
    let largest = changes.fold(0.0, f64::max);
    let decimals = if largest < 0.1 { 4 } else { 2 };
    let mut text = format!(
        "Signature: what strength {}{}{} does to the wing of `washout init`{}\n",
        significant(signature.strength, 3),
        if unit == "1" { "" } else { " " },
        if unit == "1" { "" } else { unit },
        match signature.set.is_empty() {
            true => String::new(),
            false => format!(" with {}", signature.set.join(", ")),
        }
    );
    if signature.strength != signature.plausible {
        let more = significant(signature.plausible, 3);
        let _ = writeln!(
            text,
            "  (no more, because up to the plausible {more} the wing was not solved)"
        );
    }
    text.push_str("  r, mm  twist, deg   change\n");
    for station in &signature.stations {
        let share = if largest > 0.0 {
            station.change_deg.abs() / largest
        } else {
            0.0
        };
        let bar = "█".repeat((share * BAR as f64).round() as usize);
        let (down, up) = if station.change_deg < 0.0 {
            (bar.as_str(), "")
        } else {
            ("", bar.as_str())
        };
        let _ = writeln!(
            text,
            "  {:>5}  {:>10}  {:>7}  {down:>BAR$}|{up}",
            number(station.r_mm, 1),
            number(station.without_deg, 2),
            number(station.change_deg, decimals),
        );
    }
    let _ = writeln!(
        text,
        "  leading edge at the tip {} mm, lift {} mN",
        number(signature.tip_deflection_mm, 3),
        number(signature.lift_mn, 2)
    );
    text
}
