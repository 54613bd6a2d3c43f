//! What the cases of a sweep hang on besides their values: what the files hold that they read, not where those stand.

use std::collections::HashMap;

use super::evaluate::Base;
use crate::input::{Design, Loaded};
use crate::origin::InputFile;

/// The content of a base, and of the files that its cases name.
#[derive(Debug)]
pub struct Content<'a> {
    base: &'a Base,
    of_base: String,
    /// Files by the settings that may name one.
    named: HashMap<Vec<String>, Vec<InputFile>>,
}

impl<'a> Content<'a> {
    /// Of a base as it was read.
    pub fn new(base: &'a Base) -> Content<'a> {
        Content {
            base,
            of_base: base.content(),
            named: HashMap::new(),
        }
    }

    /// Of the base.
    pub fn of_base(&self) -> &str {
        &self.of_base
    }

    /// Hashes of the files that a case with the changes `sets` names.
    pub fn of_files(&mut self, sets: &[String]) -> Vec<String> {
        let files = self.files(sets).iter();
        files.map(|file| file.sha256.clone()).collect()
    }

    /// Every file that the base or a case asked for so far reads.
    pub fn all_files(&self) -> Vec<InputFile> {
        let mut named: Vec<&InputFile> = self.named.values().flatten().collect();
        named.sort_by(|a, b| a.file.cmp(&b.file));
        self.base.files().iter().chain(named).cloned().collect()
    }

    /// Files that a case with these changes names.
    fn files(&mut self, sets: &[String]) -> &[InputFile] {
        let may_name: Vec<String> = sets.iter().filter(|set| may_name_a_file(set)).cloned().collect();
        let base = self.base;
        self.named
            .entry(may_name)
            .or_insert_with_key(|sets| base.named_files(sets))
    }
}

impl Base {
    /// All that a result hangs on besides the values of its case: what the files hold, not where they stand.
    pub fn content(&self) -> String {
        match self {
            Base::Design(loaded, _) => loaded.content(),
            Base::Study(study) => {
                let mut all = format!("{:?}", study.study);
                for case in study.cases.iter().chain(&study.experiments) {
                    all += &case.loaded.content();
                    all += &format!("{:?}{}", case.rows, case.is_held_out);
                }
                all
            }
        }
    }

    /// The files that it was read from.
    fn files(&self) -> &[InputFile] {
        match self {
            Base::Design(loaded, _) => &loaded.files,
            Base::Study(study) => &study.files,
        }
    }

    /// The files that its designs name with these changes.
    fn named_files(&self, sets: &[String]) -> Vec<InputFile> {
        let study = match self {
            Base::Design(loaded, _) => return Design::named_files(&loaded.path, sets),
            Base::Study(study) => study,
        };
        let mut known: Vec<(&Loaded, Vec<String>)> = Vec::new();
        for case in &study.cases {
            let all = case.sets.iter().chain(sets).filter(|set| may_name_a_file(set));
            let all: Vec<String> = all.cloned().collect();
            let is_known =
                |(loaded, sets): &(&Loaded, Vec<String>)| loaded.path == case.loaded.path && *sets == all;
            if !known.iter().any(is_known) {
                known.push((&case.loaded, all));
            }
        }
        let files = known
            .iter()
            .flat_map(|(loaded, sets)| Design::named_files(&loaded.path, sets));
        files.collect()
    }
}

/// Whether the value of a setting may be the name of a file, or hold one.
fn may_name_a_file(set: &str) -> bool {
    let value = set.split_once('=').map_or("", |(_, value)| value.trim());
    value.parse::<f64>().is_err()
}
