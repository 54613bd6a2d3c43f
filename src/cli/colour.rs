//! Colours of an answer on a terminal: the verdict bold, what to note yellow, the commands to go on with cyan.

use std::env;
use std::io::{IsTerminal, stdout};

use clap::builder::styling::{AnsiColor, Style};

/// Whether standard output shows colours: a terminal that is not dumb, unless `NO_COLOR` (<https://no-color.org>) is set.
pub fn is_shown() -> bool {
    let is_set = |name: &str| env::var_os(name).is_some_and(|value| !value.is_empty());
    let is_dumb = env::var_os("TERM").is_some_and(|terminal| terminal == "dumb");
    stdout().is_terminal() && !is_set("NO_COLOR") && !is_dumb
}

/// A text in colours, in which `answer` stands as it is laid out.
pub fn coloured(text: &str, answer: &str) -> String {
    let verdict: Vec<&str> = answer.lines().filter(|line| !line.trim().is_empty()).collect();
    let lines = text.lines().map(|line| match line.strip_prefix(NOTE) {
        _ if verdict.contains(&line) => styled(Style::new().bold(), line),
        Some(rest) => styled(AnsiColor::Yellow.on_default(), NOTE) + rest,
        None if line.starts_with(COMMAND) => styled(AnsiColor::Cyan.on_default(), line),
        None => line.to_string(),
    });
    lines.map(|line| line + "\n").collect()
}

/// How a note begins, and a command to go on with.
const NOTE: &str = "Note:";
const COMMAND: &str = "  washout ";

fn styled(style: Style, words: &str) -> String {
    format!("{style}{words}{style:#}")
}

#[cfg(test)]
mod tests {
    use super::coloured;

    #[test]
    fn the_verdict_is_bold_wherever_it_stands_and_all_else_is_as_it_was() {
        let text = "wing\n\nMissing: it is\nplay.\nNote: few\n  washout add it\n\nMissing: it is\nplay.\n";
        let shown = coloured(text, "Missing: it is\nplay.\n");
        assert_eq!(shown.matches("\u{1b}[1mplay.\u{1b}[0m\n").count(), 2, "{shown:?}");
        assert!(shown.contains("\u{1b}[33mNote:\u{1b}[0m few\n"), "{shown:?}");
        assert!(
            shown.contains("\u{1b}[36m  washout add it\u{1b}[0m\n"),
            "{shown:?}"
        );
        let plain: String = shown
            .split('\u{1b}')
            .map(|part| {
                part.split_once('m')
                    .filter(|(code, _)| code.starts_with('['))
                    .map_or(part, |(_, rest)| rest)
            })
            .collect();
        assert_eq!(plain, text);
    }
}
