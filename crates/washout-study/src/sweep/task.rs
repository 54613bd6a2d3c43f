//! Parts of a sweep that can be done anywhere, in any order, twice without harm.

use std::ops::Range;

use super::content::Content;
use super::plan::SweepPlan;
use crate::task::{key, stretches};

/// Some cases of a sweep.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Task {
    /// Its number, from 0.
    pub number: usize,
    /// Its cases.
    pub cases: Range<usize>,
    /// What its result hangs on: content of the base and of every file that its cases name, their values, the program; 32
    /// hexadecimal digits.
    pub key: String,
}

/// The tasks of a sweep.
pub fn tasks(plan: &SweepPlan, points: &[Vec<String>], content: &mut Content) -> Vec<Task> {
    let all = stretches(points.len(), plan.task_size).enumerate();
    all.map(|(number, cases)| Task {
        number,
        key: task_key(plan, &points[cases.clone()], content),
        cases,
    })
    .collect()
}

/// What the result of these cases hangs on, as one word.
pub fn task_key(plan: &SweepPlan, points: &[Vec<String>], content: &mut Content) -> String {
    let mut parts = vec![content.of_base().to_string()];
    for point in points {
        let sets = plan.sets(point);
        let files = content.of_files(&sets);
        for list in [sets, files] {
            parts.push(list.len().to_string());
            parts.extend(list);
        }
    }
    key(parts)
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use super::*;
    use crate::sweep::{Axis, Base, Method};

    fn plan(set: &[&str], vary: &str) -> SweepPlan {
        SweepPlan {
            base: PathBuf::from("a.toml"),
            set: set.iter().map(|set| set.to_string()).collect(),
            axes: vec![Axis::parse(vary).unwrap()],
            method: Method::Grid,
            samples: 0,
            seed: 1,
            task_size: 10,
        }
    }

    fn shipped(name: &str) -> Base {
        let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
            .join("designs")
            .join(name);
        Base::load(&path, &[]).unwrap()
    }

    fn of(plan: &SweepPlan, base: &Base) -> Vec<Task> {
        tasks(plan, &plan.points().unwrap(), &mut Content::new(base))
    }

    #[test]
    fn tasks_hold_every_case_once_and_their_keys_change_with_what_they_hang_on() {
        let (base, vary) = (shipped("rigid.toml"), "a=1..2:25");
        let set = plan(&["film.law=full"], vary);
        let found = of(&set, &base);
        let cases: Vec<usize> = found.iter().flat_map(|task| task.cases.clone()).collect();
        assert_eq!(cases, (0..25).collect::<Vec<_>>());
        assert_eq!(found, of(&set, &base));
        let others = [of(&set, &shipped("twist-v2.toml")), of(&plan(&[], vary), &base)];
        let all = found.into_iter().chain(others.into_iter().flatten());
        let mut keys: Vec<String> = all.map(|task| task.key).collect();
        keys.sort();
        keys.dedup();
        assert_eq!(keys.len(), 9);
    }

    #[test]
    fn the_key_of_a_task_changes_with_a_file_that_only_its_cases_name() {
        let folder = tempfile::tempdir().unwrap();
        let [design, table] = ["wing.toml", "air.csv"].map(|name| folder.path().join(name));
        let init = crate::input::design::INIT.replace("NAME", "wing");
        std::fs::write(&design, init).unwrap();
        let base = Base::load(&design, &[]).unwrap();
        let vary = plan(&[], "air.table=air.csv");
        let mut known = vec![of(&vary, &base)];
        for text in ["cl 1.2", "cl 1.1"] {
            std::fs::write(&table, text).unwrap();
            known.push(of(&vary, &base));
        }
        known.push(of(&vary, &base));
        let keys: Vec<&str> = known.iter().map(|tasks| tasks[0].key.as_str()).collect();
        assert!(keys[0] != keys[1] && keys[1] != keys[2], "{keys:?}");
        assert_eq!(keys[2], keys[3]);
    }
}
