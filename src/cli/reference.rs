//! The reference pages of the documentation: files, outputs, and every verb from the command line's own definition.

use std::fmt::Write;

use clap::{Arg, Command, ValueEnum};

use super::documents::Output;
use crate::export::reference::design::{design_page, video_page};
use crate::export::reference::measurement::measurement_page;
use crate::export::reference::outputs::{Document, outputs_page};

const HEAD: &str = "\
# Commands

Every verb with its options, from the command line's own definition; written by `washout schema --pages docs/reference`, and a test
compares. `washout help VERB` prints the same, `washout man DIR` writes it as manual pages.
";

/// The pages by the names of their files, in docs/reference.
pub fn reference_pages(whole: Command) -> [(&'static str, String); 5] {
    let documents: Vec<Document> = Output::value_variants()
        .iter()
        .map(|output| Document {
            printed_by: meaning(*output),
            schema: output.schema().to_value(),
        })
        .collect();
    [
        ("design.md", design_page()),
        ("measurement.md", measurement_page()),
        ("video.md", video_page()),
        ("outputs.md", outputs_page(&documents)),
        ("commands.md", commands_page(whole)),
    ]
}

/// What prints a document.
fn meaning(output: Output) -> String {
    let value = output.to_possible_value();
    let help = value.as_ref().and_then(|value| value.get_help());
    help.map(ToString::to_string).unwrap_or_default()
}

fn commands_page(mut whole: Command) -> String {
    whole.build();
    let mut text = HEAD.to_string();
    text.push_str("\n## Every verb\n");
    let global: Vec<&Arg> = whole.get_arguments().filter(|arg| arg.is_global_set()).collect();
    text.push_str(&options(global.into_iter()));
    for verb in whole.get_subcommands().filter(|verb| verb.get_name() != "help") {
        text.push_str(&section(verb));
    }
    text
}

fn section(verb: &Command) -> String {
    let about = verb.get_about().map(ToString::to_string).unwrap_or_default();
    let mut usage = verb.clone();
    let usage = usage.render_usage().to_string();
    let usage = usage.trim_start_matches("Usage: ").replace("[OPTIONS] ", "");
    let mut text = format!("\n## washout {}\n\n{about}.\n\n`{usage}`\n", verb.get_name());
    let own = |arg: &&Arg| !arg.is_global_set() && arg.get_id() != "help" && !arg.is_hide_set();
    text.push_str(&options(verb.get_arguments().filter(own)));
    if let Some(after) = verb.get_after_help() {
        let after = after.to_string();
        let (examples, words) = after.split_once("\n\n").unwrap_or((&after, ""));
        let _ = write!(text, "\n```text\n{}\n```\n", examples.trim_end());
        if !words.trim().is_empty() {
            let _ = write!(text, "\n{}\n", words.trim());
        }
    }
    text
}

fn options<'a>(arguments: impl Iterator<Item = &'a Arg>) -> String {
    let rows: String = arguments.map(row).collect();
    match rows.is_empty() {
        true => String::new(),
        false => format!("\n| | |\n|---|---|\n{rows}"),
    }
}

fn row(argument: &Arg) -> String {
    let mut help = argument.get_help().map(ToString::to_string).unwrap_or_default();
    let hidden = argument.is_hide_possible_values_set();
    let words = if hidden {
        Vec::new()
    } else {
        argument.get_possible_values()
    };
    let takes_words = argument.get_action().takes_values() && !words.is_empty();
    if takes_words {
        let words: Vec<String> = words
            .iter()
            .filter(|word| !word.is_hide_set())
            .map(|word| match word.get_help() {
                Some(help) => format!("`{}` ({help})", word.get_name()),
                None => format!("`{}`", word.get_name()),
            })
            .collect();
        let _ = write!(help, ". One of {}", words.join(", "));
    }
    let defaults: Vec<&str> = argument
        .get_default_values()
        .iter()
        .filter_map(|value| value.to_str())
        .collect();
    if argument.get_action().takes_values() && !defaults.is_empty() {
        let _ = write!(help, ". Default: {}", defaults.join(" "));
    }
    let name = argument.to_string();
    let short = argument.get_short().filter(|_| argument.get_long().is_some());
    let short = short.map(|letter| format!("`-{letter}`, ")).unwrap_or_default();
    format!(
        "| {short}`{}` | {} |\n",
        name.replace('|', "\\|"),
        help.replace('|', "\\|")
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::Arguments;
    use clap::CommandFactory;

    #[test]
    fn every_verb_and_option_stands_with_its_words() {
        let page = commands_page(Arguments::command());
        let mut whole = Arguments::command();
        whole.build();
        for verb in whole.get_subcommands().filter(|verb| verb.get_name() != "help") {
            let (_, section) = page
                .split_once(&format!("## washout {}\n", verb.get_name()))
                .expect("its section");
            let shown = |arg: &&Arg| !arg.is_global_set() && !arg.is_hide_set();
            for argument in verb.get_arguments().filter(shown) {
                if let Some(long) = argument.get_long().filter(|long| *long != "help") {
                    assert!(
                        section.contains(&format!("`--{long}")),
                        "{} --{long}",
                        verb.get_name()
                    );
                }
            }
        }
    }

    #[test]
    fn every_document_has_its_section() {
        let [.., (_, outputs), _] = reference_pages(Arguments::command());
        for output in Output::value_variants() {
            assert!(outputs.contains(&format!("## {}\n", meaning(*output))));
        }
    }
}
