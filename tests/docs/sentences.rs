//! Sentences that a reader who is no native speaker reads without stopping: none longer than thirty words, eighteen in the mean.

use crate::{all_pages, text_of};

/// Words of the longest sentence.
const LONGEST: usize = 30;
/// Words of the mean sentence.
const MEAN: f64 = 18.0;

/// Pages that are looked up, not read: cards of effects, keys, what changed.
const LISTS: [&str; 3] = ["docs/effects.md", "docs/reference/", "CHANGELOG.md"];

/// Paragraphs and items of lists, without code, tables, headings and marks.
fn paragraphs(page: &str) -> Vec<String> {
    let (mut found, mut is_code, mut is_mark) = (vec![String::new()], false, false);
    for line in page.lines() {
        let text = line.trim_start();
        if text.starts_with("```") {
            is_code = !is_code;
            continue;
        }
        is_mark |= text.starts_with("<!--");
        let is_left_out = is_code || is_mark || ["|", "#", "!["].iter().any(|start| text.starts_with(start));
        is_mark &= !text.contains("-->");
        let item = ["- ", "* "].iter().find_map(|start| text.strip_prefix(start));
        if is_left_out || text.is_empty() || item.is_some() {
            found.push(String::new());
        }
        if !is_left_out && let Some(last) = found.last_mut() {
            last.push_str(item.unwrap_or(text));
            last.push(' ');
        }
    }
    found
}

/// Sentences of a paragraph; what stands between back-ticks is one word, of a link its text counts.
fn sentences(paragraph: &str) -> Vec<Vec<String>> {
    let code = paragraph.split('`').enumerate();
    let plain: String = code
        .map(|(part, text)| if part % 2 == 0 { text } else { "code" })
        .collect();
    let links = plain.split("](").enumerate();
    let plain: String = links
        .map(|(part, text)| match part {
            0 => text,
            _ => text.split_once(')').map_or("", |(_, rest)| rest),
        })
        .collect();
    let mut found = vec![Vec::new()];
    for word in plain.split_whitespace() {
        let is_word = word.chars().any(char::is_alphanumeric);
        let last = found.last_mut().expect("begun with one");
        if is_word {
            last.push(word.to_string());
        }
        if word.trim_end_matches(['*', '"', ')']).ends_with(['.', '!', '?']) {
            found.push(Vec::new());
        }
    }
    found.retain(|sentence| sentence.len() > 1);
    found
}

#[test]
fn no_sentence_has_more_than_thirty_words_and_the_mean_has_at_most_eighteen() {
    let (mut words, mut count, mut long) = (0, 0, Vec::new());
    for page in all_pages()
        .iter()
        .filter(|page| !LISTS.iter().any(|list| page.starts_with(list)))
    {
        for sentence in paragraphs(&text_of(page))
            .iter()
            .flat_map(|paragraph| sentences(paragraph))
        {
            (words, count) = (words + sentence.len(), count + 1);
            if sentence.len() > LONGEST {
                long.push(format!(
                    "{page}, {} words: {}",
                    sentence.len(),
                    sentence.join(" ")
                ));
            }
        }
    }
    assert!(long.is_empty(), "{}", long.join("\n"));
    let mean = words as f64 / f64::from(count);
    assert!(count > 1000 && mean <= MEAN, "{count} sentences of {mean} words");
}

#[test]
fn a_sentence_is_counted_as_it_is_read() {
    let page = "# Not this\n\nOne two `three four` [five](six seven.md).\nNext *one.* Then\n\n- an item\n\n```\nnot this\n```\n";
    let counts: Vec<Vec<usize>> = paragraphs(page)
        .iter()
        .map(|paragraph| sentences(paragraph).iter().map(Vec::len).collect())
        .collect();
    assert_eq!(counts.concat(), [4, 2, 2]);
}
