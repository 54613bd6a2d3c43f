//! What a page tells its reader to do: commands with their outputs, files to write, pieces of files of the repository.
//!
//! - ```` ```console ````: lines that begin with `$ ` are commands, what follows them is what they print (`…`: lines left out;
//!   nothing: any output);
//! - ```` ``` ```` without a language: every line that begins with `washout ` is a command, with `\` at its end continued on the
//!   next line; its output is not shown;
//! - a numbered line that begins with a command between back-ticks: that command; what stands in italics behind it, up to the
//!   next number, is part of its output;
//! - `<!-- washout ARGUMENTS -->` before a ```` ```text ```` block: a command and its output;
//! - `<!-- file NAME -->` before a block: the reader writes it into that file;
//! - `<!-- from PATH -->` before a block: it is a piece of that file of the repository;
//! - `<!-- fails with CODE -->` before a block: its last command ends with that exit code.

/// One thing to do.
#[derive(Debug, Clone, PartialEq)]
pub enum Step {
    Run {
        line: String,
        /// What stands below the command; none where no output is shown.
        shown: Option<String>,
        /// Sentences of the output that the page quotes.
        said: Vec<String>,
        code: i32,
    },
    Write {
        file: String,
        text: String,
    },
    Quote {
        file: String,
        text: String,
    },
}

/// The steps of a page, in its order.
pub fn steps(page: &str) -> Vec<Step> {
    let mut steps = Vec::new();
    let mut marks: Vec<String> = Vec::new();
    let mut item: Option<String> = None;
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        if let Some(mark) = line
            .strip_prefix("<!-- ")
            .and_then(|rest| rest.strip_suffix(" -->"))
        {
            marks.push(mark.to_string());
            continue;
        }
        let Some(language) = line.strip_prefix("```") else {
            if !line.trim().is_empty() {
                marks.clear();
            }
            if let Some(line) = numbered(line) {
                steps.push(Step::Run {
                    line,
                    shown: None,
                    said: Vec::new(),
                    code: 0,
                });
                item = Some(String::new());
            }
            match &mut item {
                Some(text) if !line.is_empty() => *text = format!("{text} {}", line.trim()),
                _ => item = None,
            }
            if let (Some(text), Some(Step::Run { said, .. })) = (&item, steps.last_mut()) {
                *said = italics(text);
            }
            continue;
        };
        item = None;
        let block: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
        steps.extend(of_block(language, &block, &marks));
        marks.clear();
    }
    steps
}

/// The command at the beginning of a numbered line.
fn numbered(line: &str) -> Option<String> {
    let (number, rest) = line.split_once(". `")?;
    let is_number = !number.is_empty() && number.chars().all(|digit| digit.is_ascii_digit());
    let command = rest.split('`').next()?;
    (is_number && (command.starts_with("washout ") || command.starts_with("cat ")))
        .then(|| command.to_string())
}

/// Sentences in italics, longer than three words.
fn italics(text: &str) -> Vec<String> {
    let outside_code: String = text.split('`').step_by(2).collect();
    let quoted = outside_code.split('*').skip(1).step_by(2).map(str::to_string);
    quoted
        .filter(|quote| quote.split_whitespace().count() > 3)
        .collect()
}

fn of_block(language: &str, block: &[&str], marks: &[String]) -> Vec<Step> {
    let marked = |word: &str| {
        marks
            .iter()
            .find_map(|mark| mark.strip_prefix(word).map(str::to_string))
    };
    let whole = || block.join("\n");
    if let Some(file) = marked("file ") {
        let text = whole() + "\n";
        return vec![Step::Write { file, text }];
    }
    if let Some(file) = marked("from ") {
        return vec![Step::Quote { file, text: whole() }];
    }
    if let Some(arguments) = marked("washout ") {
        return vec![Step::Run {
            line: format!("washout {arguments}"),
            shown: Some(whole()),
            said: Vec::new(),
            code: 0,
        }];
    }
    let mut steps = match language {
        "console" => console(block),
        "" => plain(block),
        _ => Vec::new(),
    };
    if let (Some(wanted), Some(Step::Run { code, .. })) = (marked("fails with "), steps.last_mut()) {
        *code = wanted.parse().expect("an exit code");
    }
    steps
}

fn console(block: &[&str]) -> Vec<Step> {
    let mut steps: Vec<Step> = Vec::new();
    for line in block {
        match (line.strip_prefix("$ "), steps.last_mut()) {
            (Some(command), _) => steps.push(Step::Run {
                line: command.to_string(),
                shown: None,
                said: Vec::new(),
                code: 0,
            }),
            (None, Some(Step::Run { shown, .. })) => {
                let before = shown.take().map(|text| text + "\n").unwrap_or_default();
                *shown = Some(before + line);
            }
            (None, _) => panic!("a console block begins with a command: {line}"),
        }
    }
    steps
}

fn plain(block: &[&str]) -> Vec<Step> {
    let mut commands: Vec<String> = Vec::new();
    let mut continues = false;
    for line in block {
        let part = line.trim_end_matches('\\').trim();
        match (continues, commands.last_mut()) {
            (true, Some(command)) => *command = format!("{command} {part}"),
            _ if line.starts_with("washout ") => commands.push(part.to_string()),
            _ => continue,
        }
        continues = line.ends_with('\\');
    }
    let run = |line| Step::Run {
        line,
        shown: None,
        said: Vec::new(),
        code: 0,
    };
    commands.into_iter().map(run).collect()
}

#[test]
fn commands_outputs_files_and_quotes_of_a_page_are_found() {
    let page = "a\n<!-- file b.toml -->\n\n```toml\nx = 1\n```\n<!-- fails with 2 -->\n```console\n$ one\n…\n$ two x\nand\nmore\n```\n\
                <!-- from c.rs -->\nnot for the block\n```\nwashout a # b\nother\nwashout c \\\n    d\n```\n";
    let run = |line: &str, shown: Option<&str>, code| Step::Run {
        line: line.to_string(),
        shown: shown.map(str::to_string),
        said: Vec::new(),
        code,
    };
    let file = Step::Write {
        file: "b.toml".into(),
        text: "x = 1\n".into(),
    };
    let found = steps(page);
    assert_eq!(found[0], file);
    assert_eq!(
        found[1..],
        [
            run("one", Some("…"), 0),
            run("two x", Some("and\nmore"), 2),
            run("washout a # b", None, 0),
            run("washout c d", None, 0),
        ]
    );
}

#[test]
fn numbered_commands_are_found_with_what_is_quoted_of_their_output() {
    let page = "1. `washout a b`: why? *It is so and\n   so.* And *no*.\n2. no command\n3. `cat c`\n\n*Not part of the list.*\n";
    let [
        Step::Run { line, said, .. },
        Step::Run {
            line: last,
            said: none,
            ..
        },
    ] = &steps(page)[..]
    else {
        panic!("{:?}", steps(page));
    };
    assert_eq!((line.as_str(), last.as_str()), ("washout a b", "cat c"));
    assert_eq!(
        (&said[..], none.len()),
        (&["It is so and so.".to_string()][..], 0)
    );
}
