//! Twist profiles that rise in stages: the family over which a front is sought.

use crate::lift::{LiftError, TwistAlongSpan};

use super::error::ExploreError;

/// Profiles of so many straight stages from an untwisted base to the tip.
///
/// Variables: the ends of all stages but the last (mm from the base), then the twist rate of each (deg/mm).
#[derive(Debug, Clone, PartialEq)]
pub struct StagedTwist {
    /// Stages.
    pub stages: usize,
    /// Length of the wing, mm.
    pub length_mm: f64,
    /// Least and largest twist rate, deg/mm; the least is above 0, so that every profile rises.
    pub rates_deg_per_mm: [f64; 2],
    /// Shortest stage, mm.
    pub shortest_mm: f64,
    /// Largest twist at the tip, deg: that of a wing that is feathered there.
    pub largest_deg: f64,
}

impl StagedTwist {
    /// A family after a check of its numbers.
    ///
    /// # Errors
    /// For rates that are not rising from above 0, no stage, or stages that have no room.
    ///
    /// # Example
    /// ```
    /// # use washout_study as washout;
    /// use washout::explore::StagedTwist;
    ///
    /// let family = StagedTwist::new(2, 70.0, [0.01, 2.0], 45.0)?;
    /// assert_eq!(family.bounds().len(), 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        stages: usize,
        length_mm: f64,
        rates_deg_per_mm: [f64; 2],
        largest_deg: f64,
    ) -> Result<StagedTwist, ExploreError> {
        let refuse = |name: &'static str, value: f64, cure: &'static str| {
            Err(ExploreError::Setting { name, value, cure })
        };
        let shortest_mm = length_mm / 14.0;
        let [low, high] = rates_deg_per_mm;
        if !(low > 0.0 && low.is_finite()) {
            return refuse(
                "the least twist rate (deg/mm)",
                low,
                "give one above 0; 0.001 is next to flat",
            );
        }
        if !(high > low && high <= 20.0) {
            return refuse(
                "the largest twist rate (deg/mm)",
                high,
                "give one above the least, at most 20",
            );
        }
        if !(1..=6).contains(&stages) {
            return refuse("the number of stages", stages as f64, "give 1 to 6");
        }
        if largest_deg.is_nan() || largest_deg <= low * length_mm {
            return refuse(
                "the largest twist at the tip (deg)",
                largest_deg,
                "give more than the least rate makes over the span; it is the stop angle, so check flapping.stop_angle_deg",
            );
        }
        Ok(StagedTwist {
            stages,
            length_mm,
            rates_deg_per_mm,
            shortest_mm,
            largest_deg,
        })
    }

    /// Bounds of the variables.
    pub fn bounds(&self) -> Vec<[f64; 2]> {
        let ends = [self.shortest_mm, self.length_mm - self.shortest_mm];
        let mut bounds = vec![ends; self.stages - 1];
        bounds.extend(vec![self.rates_deg_per_mm; self.stages]);
        bounds
    }

    /// The stages `[length_mm, rate_deg_per_mm]` of some variables, from the base outward.
    pub fn stages(&self, variables: &[f64]) -> Vec<[f64; 2]> {
        let (ends, rates) = variables.split_at(self.stages - 1);
        let mut ends: Vec<f64> = ends.to_vec();
        ends.push(self.length_mm);
        ends.sort_by(f64::total_cmp);
        let mut from = 0.0;
        let stage = |(end, rate): (f64, &f64)| {
            let length = end - from;
            from = end;
            [length, *rate]
        };
        ends.into_iter().zip(rates).map(stage).collect()
    }

    /// By how much the variables break what a profile must keep: stages that are too short, a tip beyond feathered; 0 if they
    /// do not.
    pub fn violation(&self, variables: &[f64]) -> f64 {
        let stages = self.stages(variables);
        let short: f64 = stages
            .iter()
            .map(|[length, _]| (self.shortest_mm - length).max(0.0) / self.shortest_mm)
            .sum();
        let beyond = (tip_deg(&stages) - self.largest_deg).max(0.0) / self.largest_deg;
        // rounding is no violation
        let sum = short + beyond;
        if sum < 1e-9 { 0.0 } else { sum }
    }

    /// Variables of a profile of fewer stages, to start from; none if it is outside of the family.
    pub fn variables(&self, stages: &[[f64; 2]]) -> Option<Vec<f64>> {
        let mut stages = stages.to_vec();
        while stages.len() < self.stages {
            let longest = (0..stages.len()).max_by(|&a, &b| stages[a][0].total_cmp(&stages[b][0]))?;
            stages[longest][0] *= 0.5;
            stages.insert(longest, stages[longest]);
        }
        let mut end = 0.0;
        let mut variables: Vec<f64> = Vec::new();
        for [length, _] in &stages[..stages.len() - 1] {
            end += length;
            variables.push(end);
        }
        let [low, high] = self.rates_deg_per_mm;
        variables.extend(stages.iter().map(|[_, rate]| rate.clamp(low, high)));
        let is_inside = stages.len() == self.stages
            && variables
                .iter()
                .zip(self.bounds())
                .all(|(x, [low, high])| (low..=high).contains(x));
        is_inside.then_some(variables)
    }
}

/// Twist at the end of the last stage, deg.
pub fn tip_deg(stages: &[[f64; 2]]) -> f64 {
    stages.iter().map(|[length, rate]| length * rate).sum()
}

/// The profile of some stages.
///
/// # Errors
/// For a stage without length.
pub fn along_span(stages: &[[f64; 2]]) -> Result<TwistAlongSpan, LiftError> {
    TwistAlongSpan::from_stages(stages)
}
