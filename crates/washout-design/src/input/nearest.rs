//! The nearest of the allowed words, for "did you mean".

/// The allowed word that is nearest to `word`, if one is near enough to be a slip of the keys.
pub fn nearest<'a>(word: &str, allowed: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = word.to_lowercase();
    if word.chars().count() > 64 {
        return None;
    }
    let (distance, best) = allowed
        .into_iter()
        .map(|candidate| (edits(&word, &candidate.to_lowercase()), candidate))
        .min_by_key(|(distance, _)| *distance)?;
    let longest = word.chars().count().max(best.chars().count());
    // of a word as short as that nothing would be left
    (distance <= 1 + longest / 5 && distance < longest).then_some(best)
}

/// Insertions, deletions, replacements and swaps of neighbours that lead from `a` to `b`.
fn edits(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.chars().collect();
    let b: Vec<char> = b.chars().collect();
    let mut rows = vec![(0..=b.len()).collect::<Vec<usize>>()];
    for i in 1..=a.len() {
        let mut row = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            row[j] = replaced.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                row[j] = row[j].min(rows[i - 2][j - 2] + 1);
            }
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_finds_its_word() {
        let allowed = ["length_mm", "mean_chord_mm", "r2_hat"];
        assert_eq!(nearest("lenght_mm", allowed), Some("length_mm"));
        assert_eq!(nearest("Mean_Chord_mm", allowed), Some("mean_chord_mm"));
    }

    #[test]
    fn a_stranger_finds_nothing() {
        assert_eq!(nearest("colour", ["length_mm", "r2_hat"]), None);
        assert_eq!(nearest("x", []), None);
    }

    #[test]
    fn swapped_neighbours_count_once() {
        assert_eq!(edits("lenght", "length"), 1);
        assert_eq!(edits("abc", ""), 3);
    }
}
