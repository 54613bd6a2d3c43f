//! Damage done to bytes: a few edits of a seed, the same for the same number.

use fastrand::Rng;

/// What breaks readers of numbers, tables, trees and markup.
const PIECES: [&str; 40] = [
    "nan",
    "inf",
    "-inf",
    "1e308",
    "-1e308",
    "1e-320",
    "0",
    "-0",
    "1",
    "-1",
    "99999999999999999999",
    "4294967296",
    "18446744073709551615",
    "0x7f",
    "1e999",
    "0.0000001",
    "[",
    "]",
    "{",
    "}",
    "(",
    ")",
    "\"",
    "'",
    "\n",
    "\r\n",
    "\t",
    ",",
    ";",
    "=",
    "#",
    "..",
    "../",
    "/dev/zero",
    "é",
    "\u{0}",
    "\u{feff}",
    "null",
    "&#0;",
    "<!--",
];

/// A seed with one to eight edits; sometimes a piece of another seed in it.
pub fn mutated(seeds: &[Vec<u8>], rng: &mut Rng) -> Vec<u8> {
    let mut bytes = seeds[rng.usize(..seeds.len())].clone();
    for _ in 0..rng.usize(1..=8) {
        let start = rng.usize(..=bytes.len());
        let end = (start + length(rng)).min(bytes.len());
        match rng.u8(..10) {
            0 if start < bytes.len() => bytes[start] ^= 1 << rng.u8(..8),
            1 if start < bytes.len() => bytes[start] = rng.u8(..),
            2 => drop(bytes.drain(start..end)),
            3 => {
                let copy = bytes[start..end].to_vec();
                let to = rng.usize(..=bytes.len());
                drop(bytes.splice(to..to, copy));
            }
            4 => number_changed(&mut bytes, start, rng),
            5 => {
                let other = &seeds[rng.usize(..seeds.len())];
                let from = rng.usize(..=other.len());
                let to = (from + length(rng)).min(other.len());
                drop(bytes.splice(start..end, other[from..to].iter().copied()));
            }
            6 if rng.u8(..8) == 0 => bytes.truncate(start),
            7 => lines_changed(&mut bytes, start, rng),
            _ => {
                let piece = PIECES[rng.usize(..PIECES.len())];
                let end = if rng.bool() { start } else { end };
                drop(bytes.splice(start..end, piece.bytes()));
            }
        }
    }
    bytes
}

/// Mostly short, now and then long.
fn length(rng: &mut Rng) -> usize {
    match rng.u8(..8) {
        0 => rng.usize(..400),
        _ => rng.usize(..12),
    }
}

/// Puts another number where one stands, at this place or after it.
fn number_changed(bytes: &mut Vec<u8>, start: usize, rng: &mut Rng) {
    let Some(first) = (start..bytes.len()).find(|&at| bytes[at].is_ascii_digit()) else {
        return;
    };
    let after = bytes[first..]
        .iter()
        .position(|byte| !byte.is_ascii_digit() && *byte != b'.');
    let end = after.map_or(bytes.len(), |length| first + length);
    let number = PIECES[rng.usize(..16)];
    drop(bytes.splice(first..end, number.bytes()));
}

/// Takes a line away, or writes it twice.
fn lines_changed(bytes: &mut Vec<u8>, start: usize, rng: &mut Rng) {
    let first = bytes[..start]
        .iter()
        .rposition(|byte| *byte == b'\n')
        .map_or(0, |at| at + 1);
    let after = bytes[first..].iter().position(|byte| *byte == b'\n');
    let end = after.map_or(bytes.len(), |length| first + length + 1);
    let line: Vec<u8> = bytes.drain(first..end).collect();
    if rng.bool() {
        for _ in 0..2 {
            drop(bytes.splice(first..first, line.iter().copied()));
        }
    }
}

#[test]
fn a_number_gives_the_same_damage_and_another_gives_another() {
    let seeds = [b"mean_chord_mm = 20.5\nr2_hat = 0.54\n".to_vec()];
    let damage = |number| mutated(&seeds, &mut Rng::with_seed(number));
    assert_eq!(damage(7), damage(7));
    let different = (0..50).filter(|&number| damage(number) != seeds[0]).count();
    assert!(different > 45, "{different}");
}
