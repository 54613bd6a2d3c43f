//! Work that is cut into parts which can be done anywhere, in any order, twice without harm: what such a part is known by.

use std::ops::Range;

use crate::origin::sha256;
use crate::program::program_sha256;

/// What a result hangs on, as one word: SHA-256 of the program and of all `parts`, 32 hexadecimal digits of it.
pub fn key<T: AsRef<str>>(parts: impl IntoIterator<Item = T>) -> String {
    let mut all = Vec::new();
    let mut add = |part: &str| {
        // with its length, so that no two lists of parts read the same
        all.extend((part.len() as u64).to_le_bytes());
        all.extend(part.as_bytes());
    };
    add(program_sha256());
    parts.into_iter().for_each(|part| add(part.as_ref()));
    let mut word = sha256(&all);
    word.truncate(32);
    word
}

/// `count` cases in stretches of `size`, the last one with what is left.
pub fn stretches(count: usize, size: usize) -> impl Iterator<Item = Range<usize>> {
    let size = size.max(1);
    (0..count)
        .step_by(size)
        .map(move |start| start..(start + size).min(count))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_is_the_same_for_the_same_parts_and_another_for_any_others() {
        assert_eq!(key(["ab", "c"]), key(["ab", "c"]));
        let others = [
            vec!["ab", "c"],
            vec!["a", "bc"],
            vec!["abc"],
            vec!["c", "ab"],
            vec![],
        ];
        let mut keys: Vec<String> = others.into_iter().map(key).collect();
        assert!(keys.iter().all(|key| key.len() == 32));
        keys.sort();
        keys.dedup();
        assert_eq!(keys.len(), 5);
    }

    #[test]
    fn stretches_hold_every_case_once() {
        let found: Vec<Range<usize>> = stretches(25, 10).collect();
        assert_eq!(found, [0..10, 10..20, 20..25]);
        assert_eq!(stretches(0, 10).count(), 0);
        assert_eq!(stretches(3, 0).count(), 3);
    }
}
