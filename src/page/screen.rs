//! A page on a screen: what a terminal shows of it unless all is asked for.

use super::text::WIDTH;
use super::{Page, Part};

/// Lines of an answer, with what is to be done after it.
const LINES: usize = 15;
/// Rows below which a table is left out instead of cut.
const FEWEST: usize = 2;
/// How to see the rest.
pub const ALL: &str = "Full output: --verbose";

impl Page {
    /// What of it fits on a screen, and `after` it what is to be done next. Sentences and numbers with their names always stand there;
    /// tables, lists and notes share the lines that are left, in their order. None where nothing is chosen for a screen.
    pub fn on_screen(&self, after: &str) -> Option<String> {
        if self.brief.is_empty() {
            return None;
        }
        let always = self.brief.iter().filter(|part| !part.gives_way());
        let always: usize = always.map(|part| lines(&part.text(0))).sum();
        let mut room = LINES.saturating_sub(always + lines(&ended(after, 0)));
        let mut notes = 0;
        let mut parts: Vec<String> = Vec::new();
        for part in &self.brief {
            let (text, left_out) = match part.gives_way() {
                true => part.within(room),
                false => (part.text(0), 0),
            };
            if part.gives_way() {
                room -= lines(&text);
            }
            notes += left_out;
            parts.push(text);
        }
        parts.retain(|text| !text.is_empty());
        // what is left makes it easier to read
        if room > 0 {
            parts.push("\n".to_string());
        }
        if room > 1 && parts.len() > 2 {
            parts.insert(1, "\n".to_string());
        }
        Some(parts.concat() + &ended(after, notes))
    }
}

impl Part {
    /// Whether a screen may show less of it, or nothing.
    fn gives_way(&self) -> bool {
        matches!(self, Part::Table(_) | Part::List(_) | Part::Notes(_))
    }

    /// What of it fits into so many lines, and how many notes do not.
    fn within(&self, room: usize) -> (String, usize) {
        let fits = |text: &String| lines(text) <= room;
        match self {
            Part::Table(table) => {
                let of_rows = |most: usize, caption: &str| {
                    let mut table = table.clone();
                    table.most_in_text = table.most_in_text.min(most);
                    table.caption = caption.to_string();
                    table.text(0)
                };
                let fewest = FEWEST.min(table.rows.len());
                let cut = (fewest..=table.rows.len()).rev().map(|most| of_rows(most, ""));
                let mut tried = [of_rows(usize::MAX, &table.caption)].into_iter().chain(cut);
                (tried.find(fits).unwrap_or_default(), 0)
            }
            Part::List(items) => first(items, fits, Part::List),
            Part::Notes(items) => first(items, fits, Part::Notes),
            part => (part.text(0), 0),
        }
    }
}

/// As many of the first items as fit, and how many do not.
fn first(
    items: &[String],
    fits: impl Fn(&String) -> bool,
    part: impl Fn(Vec<String>) -> Part,
) -> (String, usize) {
    let shown = |count: usize| part(items[..count].to_vec()).text(0);
    let most = (0..=items.len()).rev().find(|&count| fits(&shown(count)));
    let most = most.unwrap_or(0);
    let is_of_notes = matches!(part(Vec::new()), Part::Notes(_));
    (shown(most), if is_of_notes { items.len() - most } else { 0 })
}

fn lines(text: &str) -> usize {
    text.lines().count()
}

/// What is to be done after an answer, and how to see what is left out: on the last line if it has room.
fn ended(after: &str, notes: usize) -> String {
    let all = match notes {
        0 => ALL.to_string(),
        1 => format!("1 more note. {ALL}"),
        count => format!("{count} more notes. {ALL}"),
    };
    let last = after.lines().last().unwrap_or("");
    let is_a_line_of_its_own = last.starts_with(|first: char| !first.is_whitespace());
    match is_a_line_of_its_own && last.chars().count() + 2 + all.chars().count() <= WIDTH {
        true => format!("{}. {all}\n", after.trim_end()),
        false => format!("{after}{all}\n"),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Digits, Rows};
    use super::*;

    fn table(rows: usize) -> Part {
        let values: Vec<f64> = (0..rows).map(|row| row as f64).collect();
        let table = Rows::of("/rows", &values).number(["", "value", ""], Digits::After(0), |value| *value);
        Part::Table(table.caption("What it is.").table())
    }

    fn page(brief: Vec<Part>) -> Page {
        Page {
            brief,
            ..Page::default()
        }
    }

    #[test]
    fn a_page_has_fifteen_lines_and_its_tables_give_way() {
        let shown = |rows: usize| {
            let page = page(vec![Part::Sentence("It is so.".into()), table(rows)]);
            page.on_screen("3 files in here\n").expect("a screen")
        };
        let whole = shown(8);
        assert_eq!(
            lines(&whole),
            14,
            "an empty line above the table and below it: {whole}"
        );
        assert!(whole.contains("What it is."), "{whole}");
        let cut = shown(40);
        assert_eq!(lines(&cut), LINES, "{cut}");
        assert!(
            cut.contains("… and 29 more") && !cut.contains("What it is."),
            "{cut}"
        );
        assert!(
            cut.ends_with("3 files in here. Full output: --verbose\n"),
            "{cut}"
        );
    }

    #[test]
    fn sentences_stay_and_notes_that_have_no_room_are_counted() {
        let sentences = vec![Part::Text("A line.".into()); 13];
        let notes = Part::Notes(vec!["One.".into(), "Two.".into(), "Three.".into()]);
        let shown = page([sentences, vec![table(3), notes]].concat())
            .on_screen("")
            .expect("a screen");
        assert_eq!(lines(&shown), LINES, "{shown}");
        assert!(
            shown.contains("Note: One.") && !shown.contains("value"),
            "{shown}"
        );
        assert!(
            shown.ends_with("2 more notes. Full output: --verbose\n"),
            "{shown}"
        );
    }

    #[test]
    fn of_rows_along_the_span_the_first_and_the_last_stay() {
        let values: Vec<f64> = (0..41).map(f64::from).collect();
        let rows = Rows::of("/rows", &values).number(["", "value", ""], Digits::After(0), |value| *value);
        let shown = page(vec![Part::Table(rows.along().table())])
            .on_screen("")
            .expect("a screen");
        assert_eq!(lines(&shown), LINES, "{shown}");
        assert!(shown.contains("    0\n") && shown.contains("   40\n"), "{shown}");
    }
}
