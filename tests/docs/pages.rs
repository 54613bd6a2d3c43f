//! Every command that a page of docs shows is run, in the order of the page, and its output compared.

use std::time::Instant;

use clap::{Arg, Command, CommandFactory};

use crate::page::{Step, steps};
use crate::text::disagreement;
use crate::workshop::{run, workshop};
use crate::{all_pages, root, text_of};

/// Commands that take more than some seconds, by page and beginning: the ignored test runs them.
const SLOW: [(&str, &str); 14] = [
    ("find-a-hidden-effect.md", ""),
    ("front.md", "washout pareto"),
    (
        "many-cases.md",
        "washout sweep designs/twist-v2.toml --vary flapping.frequency_hz=15..26",
    ),
    ("many-cases.md", "washout sweep studies/paper-wings.toml"),
    ("paper-wings.md", "washout compare studies/paper-wings.toml"),
    ("paper-wings.md", "washout explain"),
    ("what-would-explain-it.md", "washout explain"),
    ("pazy.md", "washout diagnose"),
    ("real-data.md", "washout diagnose"),
    ("robobee.md", "washout diagnose"),
    ("real-data.md", "washout add"),
    ("report.md", "washout report studies/paper-wings.toml"),
    ("rods.md", "washout"),
    ("second-opinion.md", "washout"),
];

/// Commands that need what a test cannot ask for: a cluster, other programs, hours.
const ELSEWHERE: [&str; 0] = [];

fn is_elsewhere(line: &str) -> bool {
    line.contains("--slurm") || ELSEWHERE.iter().any(|word| line.starts_with(word))
}

fn is_slow(page: &str, line: &str) -> bool {
    SLOW.iter()
        .any(|(slow, beginning)| page.ends_with(slow) && line.starts_with(beginning))
}

/// Does what a page says; the slow commands too, if asked for.
fn follow(page: &str, slow: bool) {
    let here = workshop();
    for step in steps(&text_of(page)) {
        match step {
            Step::Write { file, text } => {
                let path = here.path().join(file);
                std::fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
                std::fs::write(path, text).expect("a file");
            }
            Step::Quote { file, text } => {
                let whole = std::fs::read_to_string(root().join(&file)).expect("the file that is quoted");
                assert!(whole.contains(&text), "{page}: {file} does not hold\n{text}");
            }
            Step::Run { line, .. } if is_elsewhere(&line) || is_slow(page, &line) && !slow => {}
            Step::Run {
                line,
                shown,
                said: quotes,
                code,
            } => {
                let start = Instant::now();
                let said = run(here.path(), &line);
                println!("{:6.1} s  {page}: {line}", start.elapsed().as_secs_f64());
                assert_eq!(said.code, Some(code), "{page}: {line}\n{}{}", said.out, said.err);
                let printed = if code == 0 { said.out } else { said.err };
                if let Some(difference) = shown.and_then(|shown| disagreement(&shown, &printed)) {
                    panic!("{page}: {line}\n{difference}\nwhole output\n{printed}");
                }
                let words = printed.split_whitespace().collect::<Vec<_>>().join(" ");
                for quote in quotes {
                    assert!(
                        words.contains(quote.trim_end_matches('.')),
                        "{page}: {line}: *{quote}* is not in\n{printed}"
                    );
                }
            }
        }
    }
}

/// Whether a page has something to follow.
fn has_steps(page: &str) -> bool {
    page != "README.md" && !steps(&text_of(page)).is_empty()
}

/// One test a page, so that they run side by side.
macro_rules! pages {
    ($($name:ident $page:literal)*) => {
        $(#[test]
        fn $name() {
            follow($page, false);
        })*

        #[test]
        fn every_page_that_shows_commands_is_followed() {
            let followed = [$($page),*];
            for page in all_pages().iter().filter(|page| has_steps(page)) {
                assert!(followed.contains(&page.as_str()), "add {page} to `pages!` in tests/docs/pages.rs");
            }
            for page in followed {
                assert!(has_steps(page), "{page} shows no commands any more");
            }
        }

        #[test]
        #[ignore = "several minutes: the slow commands of the pages, see SLOW"]
        fn the_slow_commands_of_the_pages_do_what_they_say() {
            for page in [$($page),*] {
                if SLOW.iter().any(|(slow, _)| page.ends_with(slow)) {
                    follow(page, true);
                }
            }
        }
    };
}

pages! {
    errors "docs/errors.md"
    first_wing "docs/first-wing.md"
    find_a_hidden_effect "docs/find-a-hidden-effect.md"
    from_your_own_table "docs/from-your-own-table.md"
    from_video_to_twist "docs/from-video-to-twist.md"
    front "docs/front.md"
    lift "docs/lift.md"
    many_cases "docs/many-cases.md"
    minguet "docs/minguet.md"
    own_effect "docs/own-effect.md"
    paper_wings "docs/paper-wings.md"
    plan_a_measurement "docs/plan-a-measurement.md"
    pazy "docs/pazy.md"
    pre_pazy "docs/pre-pazy.md"
    real_data "docs/real-data.md"
    report "docs/report.md"
    robobee "docs/robobee.md"
    rods "docs/rods.md"
    second_opinion "docs/second-opinion.md"
    tang_dowell "docs/tang-dowell.md"
    what_would_explain_it "docs/what-would-explain-it.md"
    your_own_wing "docs/your-own-wing.md"
}

#[test]
fn every_command_that_is_named_anywhere_has_its_verb_and_options() {
    let mut whole = washout::cli::Arguments::command();
    whole.build();
    let mut named = 0;
    for page in all_pages() {
        let text = text_of(&page);
        let mut commands: Vec<String> = inline(&text);
        commands.extend(steps(&text).into_iter().filter_map(|step| match step {
            Step::Run { line, .. } => Some(line),
            _ => None,
        }));
        for command in commands {
            let command = command.split(" # ").next().unwrap_or_default();
            let Some(rest) = command.strip_prefix("washout ") else {
                continue;
            };
            named += 1;
            if let Some(fault) = fault(&whole, rest) {
                panic!("{page}: `{command}`: {fault}");
            }
        }
    }
    assert!(named > 100, "{named} commands are named");
}

/// Commands in the running text, between back-ticks.
fn inline(text: &str) -> Vec<String> {
    let mut outside = String::new();
    let mut is_inside = false;
    for line in text.lines() {
        let is_fence = line.starts_with("```");
        is_inside ^= is_fence;
        if !is_inside && !is_fence {
            outside.push_str(line);
            outside.push(if line.is_empty() { '\n' } else { ' ' });
        }
    }
    let paragraphs = outside
        .lines()
        .flat_map(|paragraph| paragraph.split('`').skip(1).step_by(2));
    paragraphs.map(str::to_string).collect()
}

/// What is wrong with the words after `washout`.
fn fault(whole: &Command, words: &str) -> Option<String> {
    let mut words = words.split_whitespace();
    let first = words.next()?;
    if first.starts_with('-') || first == "help" || first.chars().all(char::is_uppercase) {
        return None;
    }
    let Some(verb) = whole.find_subcommand(first) else {
        return Some(format!("there is no verb {first}"));
    };
    let known: Vec<&str> = verb.get_arguments().filter_map(Arg::get_long).collect();
    let mut options = words
        .filter_map(|word| word.strip_prefix("--"))
        .filter(|word| !word.is_empty());
    let unknown = options.find(|option| !known.contains(&option.trim_end_matches([',', ']'])));
    unknown.map(|option| format!("{first} has no option --{option}"))
}

#[test]
fn a_verb_or_an_option_that_does_not_exist_is_found() {
    let mut whole = washout::cli::Arguments::command();
    whole.build();
    assert_eq!(fault(&whole, "solve DESIGN --json --stroke 36"), None);
    assert!(fault(&whole, "solv DESIGN").is_some());
    assert!(fault(&whole, "solve DESIGN --strokes 36").is_some());
    assert_eq!(inline("a `b c` d\n```\n`x`\n```\nand `e\nf`"), ["b c", "e f"]);
}
