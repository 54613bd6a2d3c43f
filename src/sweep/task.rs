//! Parts of a sweep that can be done anywhere, in any order, twice without harm.

use std::ops::Range;

use super::plan::SweepPlan;
use crate::task::{key, stretches};

/// Some cases of a sweep.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Task {
    /// Its number, from 0.
    pub number: usize,
    /// Its cases.
    pub cases: Range<usize>,
    /// What its result hangs on: content of the base, values of its cases, version of the program; 32 hexadecimal digits.
    pub key: String,
}

/// The tasks of a sweep whose base has this `content`.
pub fn tasks(plan: &SweepPlan, points: &[Vec<String>], content: &str) -> Vec<Task> {
    let all = stretches(points.len(), plan.task_size).enumerate();
    all.map(|(number, cases)| {
        let mut parts = vec![content.to_string()];
        for point in &points[cases.clone()] {
            let sets = plan.sets(point);
            parts.push(sets.len().to_string());
            parts.extend(sets);
        }
        Task {
            number,
            cases,
            key: key(parts),
        }
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;
    use crate::sweep::{Axis, Method};

    #[test]
    fn tasks_hold_every_case_once_and_their_keys_change_with_what_they_hang_on() {
        let plan = SweepPlan {
            base: PathBuf::from("a.toml"),
            set: vec!["film.law=full".to_string()],
            axes: vec![Axis::parse("a=1..2:25").unwrap()],
            method: Method::Grid,
            samples: 0,
            seed: 1,
            task_size: 10,
        };
        let points = plan.points().unwrap();
        let found = tasks(&plan, &points, "wing");
        let cases: Vec<usize> = found.iter().flat_map(|task| task.cases.clone()).collect();
        assert_eq!(cases, (0..25).collect::<Vec<_>>());
        assert_eq!(found, tasks(&plan, &points, "wing"));
        let mut keys: Vec<String> = found.iter().map(|task| task.key.clone()).collect();
        keys.extend(
            tasks(&plan, &points, "another wing")
                .into_iter()
                .map(|task| task.key),
        );
        let other = SweepPlan {
            set: Vec::new(),
            ..plan.clone()
        };
        keys.extend(tasks(&other, &points, "wing").into_iter().map(|task| task.key));
        keys.sort();
        keys.dedup();
        assert_eq!(keys.len(), 9);
    }
}
