//! One campaign with other readings, and what its answers depend on besides.

use std::sync::atomic::AtomicUsize;

use nalgebra::DVector;

use super::campaign::Campaign;
use super::case::PreparedCase;
use super::forward::Observable;
use super::work::Tally;
use crate::input::measurement::Bound;
use crate::input::study::LoadedStudy;

impl Campaign {
    /// The same campaign with the readings of `study`; none if that does not hold just its rows.
    pub fn with_readings_of(&self, study: &LoadedStudy) -> Option<Campaign> {
        let rows = || study.cases.iter().enumerate();
        let read: Vec<Observable> = rows()
            .flat_map(|(index, case)| case.rows.iter().map(move |row| Observable::of(row, index)))
            .collect();
        let is_same = |a: &Observable, b: &Observable| {
            let value = a.value;
            Observable { value, ..b.clone() } == *a
        };
        let alike = read.len() == self.observables.len()
            && self.observables.iter().zip(&read).all(|(a, b)| is_same(a, b));
        if !alike {
            return None;
        }
        let mut cases = self.cases.clone();
        for (case, (_, read)) in cases.iter_mut().zip(rows()) {
            case.rows = read.rows.clone();
        }
        Some(self.read_anew(cases, read))
    }

    /// The same campaign with these values of all observables.
    pub fn with_values(&self, values: &DVector<f64>) -> Campaign {
        let mut told = self.observables.clone();
        for (observable, value) in told.iter_mut().zip(values.iter()) {
            observable.value = *value;
        }
        self.read_anew(self.cases.clone(), told)
    }

    fn read_anew(&self, cases: Vec<PreparedCase>, observables: Vec<Observable>) -> Campaign {
        Campaign {
            name: self.name.clone(),
            discrepancy: self.discrepancy,
            skipped: self.skipped.clone(),
            unused: self.unused.clone(),
            cases,
            targets: self.targets.clone(),
            observables,
            conditions: self.conditions.clone(),
            progress: self.progress.unseen(),
            asked: AtomicUsize::new(0),
            tally: Tally::default(),
            mesh_error: self.mesh_error.clone(),
        }
    }

    /// What its answers depend on, as text: designs, meshes and tables of air, unknowns, and what is read where; of the values that were
    /// read, only bounds.
    pub fn made_of(&self) -> String {
        let cases = self.cases.iter().map(PreparedCase::made_of);
        let unread = |own: &Observable| Observable {
            value: if own.bound == Bound::None { 0.0 } else { own.value },
            sigma: 0.0,
            line: 0,
            ..own.clone()
        };
        let observables = self.observables.iter().map(unread);
        format!(
            "{:?}",
            (
                cases.collect::<Vec<_>>(),
                &self.targets,
                observables.collect::<Vec<_>>(),
                &self.conditions
            )
        )
    }
}
