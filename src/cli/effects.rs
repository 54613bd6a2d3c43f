//! `washout effects`: the physics that can be added, and the card of each.

use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;
use serde::Serialize;
use serde_json::Value;

use crate::effects::{Card, all, named};
use crate::explore::{ExploreError, Signature, signature};
use crate::export::effects::{effects_page, picture};
use crate::export::file::write_page;
use crate::page::text::{hanging, wrapped};
use crate::page::{Page, Part, Rows};

use super::{Console, Failure};

/// Arguments of `washout effects`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  # all effects, one line each
  washout effects
  # formula, source, when it is right, what it gets wrong, a picture
  washout effects tip-loss-prandtl
  washout solve designs/twist-v2.toml --set effects.tip-loss-prandtl.strength=1")]
pub struct ListEffects {
    /// Print the card of this effect
    pub name: Option<String>,
    /// Write the cards of all as a page of documentation
    #[arg(long, value_name = "FILE", conflicts_with = "name")]
    pub page: Option<PathBuf>,
}

impl ListEffects {
    /// Prints the list or a card.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let Some(name) = &self.name else {
            let cards: Vec<Card> = all().map(|effect| effect.card()).collect();
            if let Some(path) = &self.page {
                write_page(path, &effects_page(&cards))?;
            }
            return console.answer(&list(&cards), "", &cards);
        };
        let Some(effect) = named(name) else {
            let names: Vec<&str> = all().map(|effect| effect.card().name).collect();
            return Err(Failure::Option {
                option: "washout effects NAME",
                reason: format!("there is no effect {name}; there are {}", names.join(", ")),
            });
        };
        let card = effect.card();
        let (picture, signature, without) = match signature(&card, console.progress()) {
            Ok(found) => (picture(&found, card.parameters[0].unit), Some(found), None),
            // an example that has no equilibrium is told; a fault or an interruption is one
            Err(ExploreError::Coupling(error)) if error.is_not_converged() => {
                let reason = error.to_string();
                (
                    format!("No picture of its signature: the wing of `washout init` is {reason}\n"),
                    None,
                    Some(reason),
                )
            }
            Err(source) => {
                return Err(Failure::Explore {
                    design: PathBuf::from("the wing of washout init"),
                    source,
                });
            }
        };
        let shown = ShownCard {
            card: &card,
            signature,
            without_signature: without,
        };
        console.result(&(page(&card) + &picture), &shown)
    }
}

/// A card with what its effect does to an example wing.
#[derive(Debug, Serialize)]
pub struct ShownCard<'a> {
    #[serde(flatten)]
    card: &'a Card<'a>,
    signature: Option<Signature>,
    /// Why there is none.
    without_signature: Option<String>,
}

/// All effects: by what they act on, and each with what happens.
fn list(cards: &[Card]) -> Page {
    let mut page = Page {
        title: "Physics that can be added to a design ([effects.NAME] strength = ...)".to_string(),
        kind: "effects",
        lead: vec![Part::Text(
            "The card of one: washout effects NAME. One of your own: [effects.NAME] kind = \"custom\", acts_on, expression; see \
             examples/effect_of_ones_own.toml"
                .to_string(),
        )],
        ..Page::default()
    };
    let mut seams: Vec<String> = Vec::new();
    for seam in cards.iter().map(|card| word(&card.seam)) {
        if !seams.contains(&seam) {
            seams.push(seam);
        }
    }
    for seam in &seams {
        let own = || cards.iter().filter(|card| word(&card.seam) == *seam);
        let names: Vec<&str> = own().map(|card| card.name).collect();
        page.brief
            .push(Part::Text(format!("{seam}: {}", names.join(", "))));
    }
    let table = Rows::of("", cards)
        .words("effect", |card| card.name)
        .words("what happens", |card| card.summary)
        .table();
    page.section("effects", "All effects", vec![Part::Table(table)]);
    page
}

fn page(card: &Card) -> String {
    let mut text = format!("{}\n{}", card.name, wrapped(card.summary, 2));
    let needs: Vec<String> = card.needs.iter().map(word).collect();
    let lines = [
        ("formula", card.formula.to_string()),
        ("source", card.source.to_string()),
        ("when right", card.when_right.to_string()),
        ("gets wrong", card.gets_wrong.to_string()),
        ("acts on", word(&card.seam)),
        (
            "needs",
            if needs.is_empty() {
                "nothing".into()
            } else {
                needs.join(", ")
            },
        ),
        (
            "changes",
            card.channels
                .iter()
                .map(|channel| channel.name())
                .collect::<Vec<_>>()
                .join(", "),
        ),
        ("family", card.family.to_string()),
        ("checked by", card.case.to_string()),
    ];
    for (name, line) in lines {
        text += &hanging(&format!("  {name:<11} "), &line, 14);
    }
    text.push_str("Numbers\n");
    for parameter in card.parameters {
        let [low, high] = parameter.range;
        let [from, to] = parameter.plausible;
        let unit = if parameter.unit == "1" { "" } else { parameter.unit };
        let range = format!(
            "{low} … {high} {unit} (plausible {from} … {to}): {}",
            parameter.meaning
        );
        text += &hanging(&format!("  {:<11} ", parameter.name), &range, 14);
    }
    let _ = writeln!(
        text,
        "In a design\n  [effects.{}]\n  {} = {}",
        card.name,
        card.parameters[0].name,
        card.parameters[0].scale()
    );
    text
}

/// The word that stands for a choice in JSON.
fn word(choice: &impl serde::Serialize) -> String {
    match serde_json::to_value(choice) {
        Ok(Value::String(word)) => word.replace('_', " "),
        _ => String::new(),
    }
}
