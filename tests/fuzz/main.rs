//! Damaged files: every reader either takes them or says what is wrong; none panics, asks for more than two GB, or hangs.
//!
//! `cargo test --release` gives each reader a few thousand files. `WASHOUT_FUZZ_SECONDS=120` gives each two minutes;
//! `WASHOUT_FUZZ_FROM=100000` goes on from there. A finding names the reader and the number of the file; the file stands under
//! `target/tmp/fuzz`.

mod mutate;

mod readers;

mod runs;

use std::alloc::System;
use std::any::Any;
use std::fs;
use std::io::{Seek, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use cap::Cap;
use fastrand::Rng;

/// No damaged file makes a reader ask for more: what is asked for above that ends the test.
#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, 2 << 30);

/// Longer than any file of this size may take; a file that takes longer is a finding.
const SLOWEST: Duration = Duration::from_secs(20);

/// What a reader says of bytes: nothing, or how what it says breaks the rules.
type Verdict = Result<(), String>;

/// A folder of the test's own for a reader.
pub fn folder(reader: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fuzz").join(reader);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn number(variable: &str) -> Option<u64> {
    let text = std::env::var(variable).ok()?;
    Some(
        text.parse()
            .unwrap_or_else(|_| panic!("{variable} is no number: {text}")),
    )
}

/// Damages seeds and reads them, `count` times or as long as `WASHOUT_FUZZ_SECONDS` says.
///
/// # Panics
/// At the first finding, with its number.
pub fn fuzz(reader: &str, seeds: &[Vec<u8>], count: u64, read: impl Fn(&[u8]) -> Verdict) {
    for seed in seeds {
        if let Err(reason) = read(seed) {
            panic!("{reader}: a seed: {reason}");
        }
    }
    let path = folder(reader).join("last-input");
    let mut last = fs::File::create(&path).expect("a file");
    let seconds = number("WASHOUT_FUZZ_SECONDS").map(Duration::from_secs);
    let first = number("WASHOUT_FUZZ_FROM").unwrap_or(0);
    let salt: u64 = reader.bytes().map(u64::from).sum::<u64>() << 40;
    let begun = Instant::now();
    let mut done = 0;
    while seconds.map_or(done < count, |seconds| begun.elapsed() < seconds) {
        let at = first + done;
        let bytes = mutate::mutated(seeds, &mut Rng::with_seed(salt + at));
        last.set_len(0)
            .and_then(|()| last.rewind())
            .and_then(|()| last.write_all(&bytes))
            .expect("written");
        let started = Instant::now();
        let said = catch_unwind(AssertUnwindSafe(|| read(&bytes)));
        let fault = match said {
            Ok(Ok(())) if started.elapsed() < SLOWEST => None,
            Ok(Ok(())) => Some(format!("it took {:.0} s", started.elapsed().as_secs_f64())),
            Ok(Err(reason)) => Some(reason),
            Err(panic) => Some(format!("panic: {}", words(panic.as_ref()))),
        };
        if let Some(fault) = fault {
            let kept = folder(reader).join(format!("finding-{at}"));
            fs::copy(&path, &kept).expect("copied");
            panic!("{reader}, file {at}: {fault}\n{} holds it", kept.display());
        }
        done += 1;
    }
    println!("{reader}: {done} files in {:.0} s", begun.elapsed().as_secs_f64());
}

fn words(panic: &dyn Any) -> String {
    let text = panic.downcast_ref::<String>().cloned();
    text.or_else(|| panic.downcast_ref::<&str>().map(ToString::to_string))
        .unwrap_or_default()
}

#[test]
fn a_reader_that_panics_is_found() {
    let weak = |bytes: &[u8]| {
        assert!(
            bytes.iter().filter(|byte| **byte == b',').count() < 4,
            "four commas"
        );
        Ok(())
    };
    let found = catch_unwind(|| fuzz("weak", &[b"a,b,c\n".to_vec()], 10_000, weak));
    let said = words(found.expect_err("a finding").as_ref());
    assert!(said.contains("panic: four commas"), "{said}");
}
