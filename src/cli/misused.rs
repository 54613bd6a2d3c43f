//! What is wrong with a command, in the words of the other refusals: place, what is wrong, cure.

use clap::error::{ContextKind, ContextValue, ErrorKind};

use super::console::complain;

/// Tells what clap has found; help and version go to standard output as they are.
pub fn tell(error: &clap::Error) {
    match words(error) {
        Some(words) => complain(&words),
        // Nobody is left to tell if even this cannot be printed.
        None => drop(error.print()),
    }
}

/// What is wrong, the usage and where all options are listed; none for what is no fault.
pub fn words(error: &clap::Error) -> Option<String> {
    let sentence = sentence(error)?;
    let usage = usage(error);
    let verb = usage
        .split(' ')
        .nth(1)
        .filter(|verb| verb.starts_with(|c: char| c.is_ascii_lowercase()));
    let help = verb.map_or("washout --help".to_string(), |verb| {
        format!("washout {verb} --help")
    });
    let usage = if usage.is_empty() {
        String::new()
    } else {
        format!("\n  Usage: {usage}")
    };
    let stop = if sentence.ends_with('?') { "" } else { "." };
    Some(format!("{sentence}{stop}{usage}\n  All options: {help}"))
}

/// The usage in one line.
fn usage(error: &clap::Error) -> String {
    let usage = match error.get(ContextKind::Usage) {
        Some(ContextValue::StyledStr(usage)) => usage.to_string(),
        _ => String::new(),
    };
    usage
        .trim_start_matches("Usage:")
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
}

fn context(error: &clap::Error, kind: ContextKind) -> Option<String> {
    match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.clone()),
        Some(ContextValue::Strings(texts)) => Some(texts.join(", ")).filter(|text| !text.is_empty()),
        _ => None,
    }
}

fn did_you_mean(error: &clap::Error, suggested: ContextKind) -> String {
    context(error, suggested).map_or(String::new(), |near| format!("; did you mean {near}?"))
}

/// Whether a word names a table of readings.
fn is_table(word: &str) -> bool {
    let end = word.rsplit_once('.').map_or("", |(_, end)| end);
    ["csv", "tsv", "xlsx", "ods"]
        .iter()
        .any(|own| end.eq_ignore_ascii_case(own))
}

fn sentence(error: &clap::Error) -> Option<String> {
    let argument = context(error, ContextKind::InvalidArg).unwrap_or_default();
    Some(match error.kind() {
        ErrorKind::DisplayHelp
        | ErrorKind::DisplayVersion
        | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => return None,
        ErrorKind::UnknownArgument if argument.starts_with('=') => {
            "=: a setting is one word. Write it without spaces about the sign: --set KEY=VALUE".to_string()
        }
        ErrorKind::UnknownArgument if argument == "--with" => {
            "--with: only diagnose and compare take a design with a table. For all else make a study of them: washout init NAME --study \
             --design DESIGN --readings TABLE"
                .to_string()
        }
        ErrorKind::UnknownArgument if argument.starts_with('-') => {
            format!(
                "{argument}: there is no such option here{}",
                did_you_mean(error, ContextKind::SuggestedArg)
            )
        }
        ErrorKind::UnknownArgument if is_table(&argument) => {
            format!(
                "{argument}: one word too many. A table of readings is given with --with {argument}, to diagnose and compare"
            )
        }
        ErrorKind::UnknownArgument => {
            format!("{argument}: one word too many. Quote a path or a value that has spaces")
        }
        ErrorKind::InvalidSubcommand => {
            let verb = context(error, ContextKind::InvalidSubcommand).unwrap_or_default();
            format!(
                "there is no verb {verb}{}",
                did_you_mean(error, ContextKind::SuggestedSubcommand)
            )
        }
        ErrorKind::MissingRequiredArgument => format!("{argument} is missing"),
        ErrorKind::ArgumentConflict => match context(error, ContextKind::PriorArg) {
            Some(prior) if prior == argument => format!("{argument} stands twice; give it once"),
            Some(prior) => format!("{argument} does not go together with {prior}; leave one out"),
            None => format!("{argument} does not go together with the others; leave it out"),
        },
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => wrong_value(error, &argument),
        _ => {
            let rendered = error.render().to_string();
            let first = rendered.lines().next().unwrap_or_default();
            first.trim_start_matches("error: ").to_string()
        }
    })
}

fn wrong_value(error: &clap::Error, argument: &str) -> String {
    let value = context(error, ContextKind::InvalidValue).unwrap_or_default();
    let why = std::error::Error::source(error).map_or(String::new(), |why| format!(": {why}"));
    let near = did_you_mean(error, ContextKind::SuggestedValue);
    match (value.is_empty(), context(error, ContextKind::ValidValue)) {
        (true, None) => format!("{argument}: its value is missing"),
        (true, Some(all)) => format!("{argument}: its value is missing; it is one of {all}"),
        (false, Some(all)) => format!("{argument} = {value}: is none of {all}{near}"),
        (false, None) => format!("{argument} = {value}: is not what it takes{why}"),
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::words;
    use crate::cli::Arguments;

    #[test]
    fn a_slip_in_a_command_is_told_as_other_faults_are() {
        let told = |command: &str| {
            let error = Arguments::try_parse_from(command.split(' ')).expect_err(command);
            words(&error).unwrap_or_else(|| panic!("{command}: no fault"))
        };
        let slips = [
            (
                "washout diagnose d.toml --wiht s.csv",
                "--wiht: there is no such option here; did you mean --with?",
            ),
            (
                "washout solve d.toml --set a.b = 25",
                "=: a setting is one word. Write it without spaces",
            ),
            (
                "washout sovle d.toml",
                "there is no verb sovle; did you mean solve?",
            ),
            (
                "washout explain s.toml --with t.csv",
                "--with: only diagnose and compare take a design with a table",
            ),
            ("washout solve", "<DESIGN> is missing."),
            (
                "washout solve d.toml --refine two",
                "--refine <FACTOR> = two: is not what it takes: invalid float",
            ),
            ("washout solve d.toml e.toml", "e.toml: one word too many"),
            ("washout diagnose d.toml t.csv", "is given with --with t.csv"),
            (
                "washout diagnose s.toml --plan --report",
                "does not go together with",
            ),
            ("washout solve d.toml --set", "its value is missing"),
            ("washout diagnose d.toml --sigma 0.5", "is missing"),
        ];
        for (command, begins) in slips {
            let told = told(command);
            assert!(told.contains(begins), "{command}: {told}");
            assert!(
                !told.contains("error:") && !told.contains("tip:"),
                "{command}: {told}"
            );
            assert!(told.contains("All options: washout"), "{command}: {told}");
        }
        let help = Arguments::try_parse_from(["washout", "--help"]).expect_err("help");
        assert_eq!(words(&help), None);
    }
}
