//! Text against text: words must be the same, numbers may differ by one unit of their last digit.

/// A line that stands for any number of lines.
const ELLIPSIS: &str = "…";

/// Counts of steps and residuals may change without any result changing.
const UNCOMPARED: &str = "solved ";

/// A block of the README and the command that prints it.
#[derive(Debug)]
pub struct Shown<'a> {
    /// Arguments of the program.
    pub command: &'a str,
    /// What it prints.
    pub text: String,
}

impl Shown<'_> {
    /// All fenced blocks that follow a mark `<!-- washout ARGUMENTS -->`.
    pub fn after<'a>(readme: &'a str, mark: &str) -> Vec<Shown<'a>> {
        readme
            .split(mark)
            .skip(1)
            .map(|part| {
                let (command, rest) = part.split_once(" -->").expect("the end of the mark");
                let block = rest
                    .trim_start()
                    .strip_prefix("```text\n")
                    .expect("a block ```text");
                let text = block.split_once("\n```").expect("the end of the block").0;
                Shown {
                    command,
                    text: text.to_string(),
                }
            })
            .collect()
    }
}

/// The first place where `shown` is not `printed`; lines "…" of `shown` stand for any lines.
pub fn disagreement(shown: &str, printed: &str) -> Option<String> {
    let mut printed = printed.lines();
    let mut skips = false;
    for line in shown.lines() {
        if line.trim() == ELLIPSIS {
            skips = true;
            continue;
        }
        let found = if skips {
            printed.find(|candidate| agree(line, candidate))
        } else {
            printed.next().filter(|candidate| agree(line, candidate))
        };
        if found.is_none() {
            let next = printed.next().unwrap_or("nothing more");
            return Some(format!("no line is like\n{line}\nbefore\n{next}"));
        }
        skips = false;
    }
    match printed.next() {
        Some(more) if !skips => Some(format!("shown is too short; there follows\n{more}")),
        _ => None,
    }
}

/// Whether two lines have the same words and nearly the same numbers.
fn agree(shown: &str, printed: &str) -> bool {
    let mut pairs = shown.split_whitespace().zip(printed.split_whitespace());
    let same_count = shown.split_whitespace().count() == printed.split_whitespace().count();
    let is_uncompared = [shown, printed]
        .iter()
        .all(|line| line.trim_start().starts_with(UNCOMPARED));
    is_uncompared || same_count && pairs.all(|(a, b)| word_agrees(a, b))
}

fn word_agrees(shown: &str, printed: &str) -> bool {
    if shown == printed {
        return true;
    }
    let (Some([before_a, digits_a, after_a]), Some([before_b, digits_b, after_b])) =
        (parts(shown), parts(printed))
    else {
        return false;
    };
    let decimals = |digits: &str| digits.split_once('.').map_or(0, |(_, after)| after.len());
    let (Ok(a), Ok(b)) = (digits_a.parse::<f64>(), digits_b.parse::<f64>()) else {
        return false;
    };
    let unit = 10f64.powi(-(decimals(digits_a).min(decimals(digits_b)) as i32));
    before_a == before_b && after_a == after_b && (a - b).abs() <= 1.01 * unit
}

/// What stands before, in and after the number in a word such as "(11.3°,".
fn parts(word: &str) -> Option<[&str; 3]> {
    let is_part = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let start = word.find(is_part)?;
    let end = word[start..]
        .find(|c| !is_part(c))
        .map_or(word.len(), |length| start + length);
    // A full stop ends the sentence, not the number.
    let digits = word[start..end].trim_end_matches('.');
    let end = start + digits.len();
    (!digits.is_empty()).then(|| [&word[..start], &word[start..end], &word[end..]])
}

#[test]
fn numbers_may_move_by_one_unit_of_the_last_digit_and_words_not_at_all() {
    assert!(agree("tip 20.58° (at 67.9 mm).", "  tip  20.59° (at 67.9 mm)."));
    assert!(!agree("tip 20.58°", "tip 20.60°"));
    assert!(!agree("tip 20.6° up", "tip 20.6° down"));
    assert!(agree("-0.010 deg.", "-0.011 deg."));
    assert!(!agree("0.5 deg", "-0.5 deg"));
    assert!(!agree("one two", "one"));
}

#[test]
fn lines_that_are_left_out_are_skipped_and_lines_that_are_missing_are_found() {
    let printed = "a 1.00\nb 2.00\nc 3.00\n";
    assert_eq!(disagreement("a 1.00\n…\nc 3.01\n…", printed), None);
    assert_eq!(disagreement("a 1.00\nb 2.00\nc 3.00", printed), None);
    assert!(disagreement("a 1.00\nb 2.00", printed).is_some());
    assert!(disagreement("a 1.00\nc 3.00\n…", printed).is_some());
    assert!(disagreement("…\nd 4.00\n…", printed).is_some());
}
