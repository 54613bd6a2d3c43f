//! The physics that can be added, as a page of documentation: a table of all effects, then the card of each.

use std::fmt::Write;

use crate::effects::Card;

/// The page in Markdown; the same cards give the same page.
pub fn effects_page(cards: &[Card]) -> String {
    let mut page = String::from(
        "# Physics that can be added\n\n\
         Written by `washout effects --page docs/effects.md` from the cards in `src/effects`; a test compares the two.\n\n\
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
