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

use super::{Console, Failure};

/// Arguments of `washout effects`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout effects                               all effects, one line each
  washout effects tip-loss-prandtl              formula, source, when it is right, what it gets wrong, a picture
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
            return console.result(&list(&cards), &cards);
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
struct ShownCard<'a> {
    #[serde(flatten)]
    card: &'a Card<'a>,
    signature: Option<Signature>,
    /// Why there is none.
    without_signature: Option<String>,
}

fn list(cards: &[Card]) -> String {
    let width = cards.iter().map(|card| card.name.len()).max().unwrap_or(0);
    let mut text = String::from("Physics that can be added to a design ([effects.NAME] strength = ...)\n");
    for card in cards {
        let _ = writeln!(text, "  {:width$}  {}", card.name, card.summary);
    }
    text.push_str("The card of one: washout effects NAME\n");
    text.push_str(
        "One of your own: [effects.NAME] kind = \"custom\", acts_on, expression; see examples/effect_of_ones_own.toml\n",
    );
    text
}

fn page(card: &Card) -> String {
    let mut text = format!("{}\n  {}\n", card.name, card.summary);
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
        let _ = writeln!(text, "  {name:<11} {line}");
    }
    text.push_str("Numbers\n");
    for parameter in card.parameters {
        let [low, high] = parameter.range;
        let [from, to] = parameter.plausible;
        let unit = if parameter.unit == "1" { "" } else { parameter.unit };
        let _ = writeln!(
            text,
            "  {:<11} {low} … {high} {unit} (plausible {from} … {to}): {}",
            parameter.name, parameter.meaning
        );
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
