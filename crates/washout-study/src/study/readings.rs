//! One campaign with other readings, and what its answers depend on besides.

use std::sync::atomic::AtomicUsize;

use nalgebra::DVector;

use super::campaign::Campaign;
use super::case::PreparedCase;
use super::forward::{Observable, Unknown, UnknownKind};
use super::unknowns::Targets;
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
        self.made_of_these(PreparedCase::made_of, |_| true)
    }

    /// As [`Campaign::made_of`], without the effects that are tried: what the answer to each of them depends on besides
    /// [`Campaign::unknown_made_of`].
    pub fn made_of_without_tried(&self) -> String {
        self.made_of_these(PreparedCase::made_of_without_tried, |unknown| {
            let own = match &unknown.kind {
                UnknownKind::Place { of, .. } => self.targets.unknowns.iter().find(|own| own.name == *of),
                _ => Some(unknown),
            };
            let Some(UnknownKind::Effect { effect, .. }) = own.map(|own| &own.kind) else {
                return true;
            };
            !self.cases.iter().any(|case| case.joined(effect))
        })
    }

    /// What the answer to an unknown depends on besides [`Campaign::made_of_without_tried`], as text: what it is, where it acts, and the
    /// numbers of its effect in each design.
    pub fn unknown_made_of(&self, unknown: usize) -> String {
        let unknowns = &self.targets.unknowns;
        let own = &unknowns[unknown];
        let is_place =
            |other: &&Unknown| matches!(&other.kind, UnknownKind::Place { of, .. } if *of == own.name);
        let numbers = |case: &PreparedCase| match &own.kind {
            UnknownKind::Effect { effect, .. } => case.design.effects.get(effect).cloned(),
            _ => None,
        };
        let numbers: Vec<_> = self.cases.iter().map(numbers).collect();
        format!("{:?}", (own, unknowns.iter().find(is_place), numbers))
    }

    fn made_of_these(
        &self,
        of_case: impl Fn(&PreparedCase) -> String,
        is_told: impl Fn(&Unknown) -> bool,
    ) -> String {
        let cases = self.cases.iter().map(of_case);
        let Targets {
            unknowns,
            targets,
            start,
        } = &self.targets;
        let told = (0..unknowns.len()).filter(|&i| is_told(&unknowns[i]));
        let told: Vec<_> = told.map(|i| (&unknowns[i], &targets[i], start[i])).collect();
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
                told,
                observables.collect::<Vec<_>>(),
                &self.conditions
            )
        )
    }
}
