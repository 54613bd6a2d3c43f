//! `washout effects`: the physics that can be added, and the card of each.

use std::path::PathBuf;

use clap::Args;
use serde::Serialize;
use serde_json::Value;

use crate::effects::{Card, Parameter, all, named};
use crate::explore::{ExploreError, Signature, signature};
use crate::export::effects::{effects_page, picture};
use crate::export::file::write_page;
use crate::page::{Line, Page, Part, Rows};

use super::{Console, Failure};

/// Arguments of `washout effects`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  # all effects, one line each
  washout effects
  # when it is right, what it gets wrong, its numbers, a picture
  washout effects tip-loss-prandtl
  # formula and source besides
  washout effects tip-loss-prandtl --verbose
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
            let mut after = String::new();
            if let Some(path) = &self.page {
                write_page(path, &effects_page(&cards))?;
                after = format!("Written: {}\n", path.display());
            }
            return console.answer(&list(&cards), &after, &cards);
        };
        let Some(effect) = named(name) else {
            let names: Vec<&str> = all().map(|effect| effect.card().name).collect();
            return Err(Failure::Option {
                option: "washout effects NAME",
                reason: format!("there is no effect {name}; there are {}", names.join(", ")),
            });
        };
        let card = effect.card();
        let (picture, signature, without) = match signature(effect, console.progress()) {
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
        console.answer(&page(&card), &picture, &shown)
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
    page.brief = page.lead.clone();
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

/// The card of an effect: what it is good for and its numbers first.
fn page(card: &Card<'static>) -> Page {
    let line = |name, words: &str| Line::new(name).words(words);
    let needs: Vec<String> = card.needs.iter().map(word).collect();
    let needs = if needs.is_empty() {
        "nothing".to_string()
    } else {
        needs.join(", ")
    };
    let channels: Vec<&str> = card.channels.iter().map(|channel| channel.name()).collect();
    let good_for = vec![
        line("when right", card.when_right),
        line("gets wrong", card.gets_wrong),
        line("needs", &needs),
    ];
    let numbers = vec![
        Part::Named(card.parameters.iter().map(number).collect()),
        Part::Subtitle("In a design".to_string()),
        Part::Code(format!(
            "[effects.{}]\n{} = {}",
            card.name,
            card.parameters[0].name,
            card.parameters[0].scale()
        )),
    ];
    let mut page = Page {
        title: card.name.to_string(),
        kind: "effect",
        lead: vec![Part::Text(card.summary.to_string())],
        ..Page::default()
    };
    page.brief = page.lead.clone();
    page.brief.push(Part::Named(good_for.clone()));
    page.brief.extend(numbers.iter().cloned());
    let mut lines = vec![line("formula", card.formula), line("source", card.source)];
    lines.extend(good_for);
    lines.extend([
        line("acts on", &word(&card.seam)),
        line("changes", &channels.join(", ")),
        line("family", card.family),
        line("checked by", card.case),
    ]);
    page.section("card", "What it is", vec![Part::Named(lines)]);
    page.section("numbers", "Numbers", numbers);
    page
}

/// A number of an effect: its ranges and what it means.
fn number(parameter: &Parameter<'static>) -> Line {
    let ([low, high], [from, to]) = (parameter.range, parameter.plausible);
    let unit = if parameter.unit == "1" { "" } else { parameter.unit };
    let words = format!(
        "{low} … {high} {unit} (plausible {from} … {to}): {}",
        parameter.meaning
    );
    Line::new(parameter.name).words(words)
}

/// The word that stands for a choice in JSON.
fn word(choice: &impl serde::Serialize) -> String {
    match serde_json::to_value(choice) {
        Ok(Value::String(word)) => word.replace('_', " "),
        _ => String::new(),
    }
}
