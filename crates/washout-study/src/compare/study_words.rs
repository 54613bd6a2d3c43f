//! A study as compared, in words: how far the model is from what was measured, and what calibration had to move.

use std::collections::BTreeSet;

use super::study_comparison::{CalibratedUnknown, GroupMisfit, StudyComparison};

/// A sentence for each wing and channel, for each input that was moved far, and for what the data say little of.
pub(super) fn words(comparison: &StudyComparison) -> Vec<String> {
    let mut words: Vec<String> = comparison.groups.iter().map(of_group).collect();
    let moved: Vec<&CalibratedUnknown> = comparison
        .unknowns
        .iter()
        .filter(|unknown| unknown.has_moved_far())
        .collect();
    for unknown in moved {
        words.push(format!(
            "{} had to move by {:.1} of its prior's standard deviations: the prior is too narrow, or it stands in for something \
             that the model lacks.",
            unknown.unknown.name, unknown.pull
        ));
    }
    let unseen = (comparison.unknowns.iter())
        .filter(|unknown| unknown.is_at_its_prior())
        .map(|unknown| unknown.unknown.name.as_str());
    // wings with a part of one name each
    let unseen: BTreeSet<&str> = unseen.collect();
    if !unseen.is_empty() {
        words.push(format!(
            "These data say little of {}: they stay at their priors.",
            unseen.into_iter().collect::<Vec<_>>().join(", ")
        ));
    }
    words
}

/// How far the model is from a channel of a wing.
pub fn of_group(group: &GroupMisfit) -> String {
    let held = if group.is_held_out { " (held out)" } else { "" };
    let total = group.sigma_of_measurement.hypot(group.sigma_of_inputs);
    let verdict = match group.explained {
        None => "for every bound is kept".to_string(),
        Some(share) if share >= 1.0 => "which the known uncertainty of ruler and inputs explains".to_string(),
        Some(share) => format!(
            "of which the known uncertainty ({total:.3} {}) explains {:.0} % (of the mean square)",
            group.unit,
            100.0 * share
        ),
    };
    format!(
        "{}, {}{held}: the uncalibrated model misses by {:.3} {} (root mean square of {}), {verdict}; calibrated, by {:.3}.",
        group.wing,
        group.channel.name(),
        group.rmse[0],
        group.unit,
        group.count,
        group.rmse[1],
    )
}
