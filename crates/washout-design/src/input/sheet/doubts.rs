//! What looks wrong in a table: metres or centimetres for millimetres, radians for degrees, the other sign, the whole stroke for its half,
//! a condition that lacks what others name, a slip of the keys. It is told with what to write; nothing is changed by a guess.

use std::collections::BTreeSet;

use super::condition::Condition;
use super::header::{Column, Role};
use crate::input::design::Design;
use crate::input::error::InputError;
use crate::input::measurement::{Channel, Measurement, Row};

/// Stations that all lie within this share of the length from the base are in metres.
const METRES: f64 = 0.01;
/// Stations of which none lies beyond this share of the length may be in centimetres.
const CENTIMETRES: f64 = 0.15;
/// Largest twist, in the unit of the table, that may be in radians.
const RADIANS: f64 = 0.8;
/// A twist so many times as far from the line between its neighbours as the others at the median is a slip of the keys, if it is so many
/// standard deviations off besides. A choice: a `Check:` that is not needed costs a look at the table, and changes nothing.
const SLIP: (f64, f64) = (10.0, 10.0);
/// Twists along a span that show how smooth they are.
const ENOUGH: usize = 5;
/// A half amplitude so many times that of the design may be the whole stroke.
const WHOLE_STROKE: f64 = 1.6;

/// What to doubt.
///
/// # Errors
/// If no station can be meant as it stands.
pub fn doubts(
    table: &Measurement,
    columns: &[Column],
    conditions: &[Condition],
    design: &Design,
) -> Result<Vec<String>, InputError> {
    let mut doubts = Vec::new();
    doubts.extend(of_stations(table, design)?);
    doubts.extend(of_twists(table, columns));
    // what a load on the bench does has its steps where the load and the spars are
    let is_in_air = |row: &&Row| {
        let of_row = conditions.iter().find(|condition| condition.case() == row.case);
        row.channel == Channel::Twist && of_row.is_none_or(|condition| condition.bench.is_none())
    };
    let in_air = runs(table.rows.iter().filter(is_in_air));
    let among = of_slips_among(&in_air);
    let slips = of_slips(in_air);
    // at the end of a wing its neighbour may seem the one that slipped
    let is_other = |slip: &&Slip| among.iter().all(|known| known.case != slip.case);
    doubts.extend(
        slips
            .iter()
            .filter(is_other)
            .chain(&among)
            .map(|slip| slip.words.clone()),
    );
    doubts.extend(of_amplitude(conditions, design));
    doubts.extend(of_conditions(conditions));
    Ok(doubts)
}

/// A twist that may be a slip of the keys.
struct Slip {
    case: String,
    words: String,
}

/// The twist that stands alone against what the other conditions lead one to expect.
fn of_slips_among(runs: &[Vec<&Row>]) -> Option<Slip> {
    let off = |(row, expected): &(&Row, f64)| (row.value - expected).abs();
    let cells = (0..runs.len()).flat_map(|run| runs[run].iter().map(move |row| (run, *row)));
    let cells: Vec<(&Row, f64)> = cells
        .filter_map(|(run, row)| Some((row, expected(runs, run, row)?)))
        .collect();
    let usual = median(cells.iter().map(off).collect())?;
    let worst = cells.iter().max_by(|a, b| off(a).total_cmp(&off(b)))?;
    let (row, expected) = worst;
    (off(worst) > SLIP.0 * usual && off(worst) > SLIP.1 * row.sigma).then(|| Slip {
        case: row.case.clone(),
        words: format!(
            "Line {}, {}: {} deg at {} mm, where the other conditions lead to about {expected:.1} deg: is it a slip of the keys?",
            row.line,
            row.case,
            row.value,
            row.r_mm.unwrap_or_default()
        ),
    })
}

/// What the other runs lead one to expect of a row of `runs[run]`: each twist is about a share of its station times a share of its condition.
/// None with fewer than two others: of two, which slipped cannot be told.
fn expected(runs: &[Vec<&Row>], run: usize, row: &Row) -> Option<f64> {
    let at = |run: &[&Row], r_mm: Option<f64>| run.iter().find(|row| row.r_mm == r_mm).map(|row| row.value);
    let others = (0..runs.len())
        .filter(|other| *other != run)
        .map(|other| &runs[other]);
    let by_other = others.filter_map(|other| {
        let near = runs[run].iter().filter(|near| near.r_mm != row.r_mm);
        let ratios = near.filter_map(|near| Some(near.value / at(other, near.r_mm)?));
        let ratios: Vec<f64> = ratios.filter(|ratio| ratio.is_finite()).collect();
        (ratios.len() + 1 >= ENOUGH).then_some(at(other, row.r_mm)? * median(ratios)?)
    });
    let by_other: Vec<f64> = by_other.collect();
    (by_other.len() >= 2).then(|| median(by_other))?
}

/// The middle one, or the mean of the middle two; none of none.
fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    let upper = *values.get(middle)?;
    match values.len() % 2 {
        1 => Some(upper),
        _ => Some(0.5 * (upper + values[middle - 1])),
    }
}

/// Rows of one condition and run each.
fn runs<'a>(rows: impl Iterator<Item = &'a Row>) -> Vec<Vec<&'a Row>> {
    let mut runs: Vec<Vec<&Row>> = Vec::new();
    for row in rows {
        let is_same = |run: &&mut Vec<&Row>| run[0].case == row.case && run[0].run == row.run;
        match runs.iter_mut().find(is_same) {
            Some(run) => run.push(row),
            None => runs.push(vec![row]),
        }
    }
    runs
}

/// Twists that stand alone among their neighbours, the worst of each condition.
fn of_slips(mut runs: Vec<Vec<&Row>>) -> Vec<Slip> {
    runs.retain(|run| run.len() >= ENOUGH);
    for run in &mut runs {
        run.sort_by(|a, b| a.r_mm.partial_cmp(&b.r_mm).unwrap_or(std::cmp::Ordering::Equal));
    }
    // the one without which the others are smoothest
    let without = |run: &[&Row], at: usize| -> Vec<f64> {
        let rest: Vec<&Row> = [&run[..at], &run[at + 1..]].concat();
        (0..rest.len()).map(|at| off_line(&rest, at)).collect()
    };
    let lone = runs.iter().filter_map(|run| {
        let rough = |at: usize| without(run, at).iter().sum::<f64>();
        let at = (0..run.len()).min_by(|a, b| rough(*a).total_cmp(&rough(*b)))?;
        Some((run, at))
    });
    let lone: Vec<(&Vec<&Row>, usize)> = lone.collect();
    let mut smooth: Vec<f64> = lone.iter().flat_map(|(run, at)| without(run, *at)).collect();
    smooth.sort_by(f64::total_cmp);
    let median = smooth.get(smooth.len() / 2).copied().unwrap_or_default();
    let told = |(run, at): &(&Vec<&Row>, usize)| {
        let (row, off) = (run[*at], off_line(run, *at));
        (off > SLIP.0 * median && off > SLIP.1 * row.sigma).then(|| {
            let beside = [at.checked_sub(1), Some(at + 1)].into_iter().flatten();
            let beside: Vec<String> = beside
                .filter_map(|at| Some(run.get(at)?.value.to_string()))
                .collect();
            let words = format!(
                "Line {}, {}: {} deg at {} mm beside {} deg: is it a slip of the keys?",
                row.line,
                row.case,
                row.value,
                row.r_mm.unwrap_or_default(),
                beside.join(" and ")
            );
            let case = row.case.clone();
            Slip { case, words }
        })
    };
    lone.iter().filter_map(told).collect()
}

/// How far a twist is from the line through those on both sides of it, or through the two next to it where it is at an end, deg.
fn off_line(run: &[&Row], at: usize) -> f64 {
    let place = |row: &Row| row.r_mm.unwrap_or_default();
    let [a, b] = match at {
        0 => [1, 2],
        last if last + 1 == run.len() => [last - 2, last - 1],
        inner => [inner - 1, inner + 1],
    };
    let slope = (run[b].value - run[a].value) / (place(run[b]) - place(run[a]));
    (run[at].value - run[a].value - slope * (place(run[at]) - place(run[a]))).abs()
}

/// Conditions that lack a number which others name.
fn of_conditions(conditions: &[Condition]) -> Vec<String> {
    let keys = |condition: &Condition| -> BTreeSet<String> {
        condition.points.iter().map(|point| point.key.clone()).collect()
    };
    let all: BTreeSet<String> = conditions.iter().flat_map(keys).collect();
    let lacking = |condition: &Condition| {
        let own = keys(condition);
        let lacks: Vec<&str> = all.difference(&own).map(String::as_str).collect();
        (!lacks.is_empty()).then(|| {
            format!(
                "The condition {} says nothing of {}, as others do: the number of the design is taken. Name it in the head or in its \
                 column if it was another.",
                condition.case(),
                lacks.join(", ")
            )
        })
    };
    let in_air = conditions.iter().filter(|condition| condition.bench.is_none());
    in_air.filter_map(lacking).collect()
}

fn of_stations(table: &Measurement, design: &Design) -> Result<Option<String>, InputError> {
    let length = design.planform.length_mm.value();
    let stations: Vec<f64> = table.rows.iter().filter_map(|row| row.r_mm).collect();
    let farthest = stations.iter().fold(0.0_f64, |far, r| far.max(r.abs()));
    let short = stations
        .iter()
        .filter(|r| **r > 0.0 && **r < METRES * length)
        .count();
    let nearest = stations
        .iter()
        .filter(|r| **r > 0.0)
        .fold(f64::INFINITY, |near, r| near.min(*r));
    if stations.len() > 1 && nearest.is_finite() && nearest > length {
        let message = format!(
            "has no station on the wing: the innermost is {nearest} mm, the wing is {length} mm long"
        );
        let cure = "Is another unit meant? Write it above them, e.g. r (mm); stations are counted from the wing base".to_string();
        return Err(InputError::about_file(&table.file, message, cure));
    }
    if farthest > 0.0 && farthest < METRES * length {
        let message = format!("has no station beyond {farthest} mm of a wing that is {length} mm long");
        let cure = format!(
            "Are they in metres? Then write r (m) above them; {} mm would be the outermost",
            farthest * 1000.0
        );
        return Err(InputError::about_file(&table.file, message, cure));
    }
    if farthest > 0.0 && farthest < CENTIMETRES * length {
        return Ok(Some(format!(
            "No station lies beyond {farthest} mm of a wing that is {length} mm long: are they in centimetres? Then write r (cm) above \
             them; {:.1} mm would be the outermost.",
            farthest * 10.0
        )));
    }
    Ok((short > 0).then(|| {
        format!(
            "{short} of {} stations lie within {} mm of the wing base: is one in metres? All stations are in one unit.",
            stations.len(),
            METRES * length
        )
    }))
}

fn of_twists(table: &Measurement, columns: &[Column]) -> Vec<String> {
    let mut doubts = Vec::new();
    let twists = table.rows.iter().filter(|row| row.channel == Channel::Twist);
    let twists: Vec<f64> = twists.map(|row| row.value).collect();
    let largest = twists
        .iter()
        .fold(0.0_f64, |largest, twist| largest.max(twist.abs()));
    let is_converted = columns
        .iter()
        .any(|column| matches!(column.role, Role::Readings { .. }) && column.factor != 1.0);
    if twists.len() > 1 && largest > 0.0 && largest < RADIANS && !is_converted {
        doubts.push(format!(
            "The largest twist is {largest:.3} deg: is it in radians ({:.1} deg)? Then write rad in its head, e.g. twist (rad).",
            largest.to_degrees()
        ));
    }
    let negative = twists.iter().filter(|twist| **twist < 0.0).count();
    if twists.len() > 2 && negative * 3 > twists.len() * 2 {
        doubts.push(format!(
            "{negative} of {} twists raise the angle of attack, where air loads lower it on most wings: is the sign the other \
             one? Positive is washout (nose down); write twist, nose up (deg) above readings of the other sign.",
            twists.len()
        ));
    }
    doubts
}

fn of_amplitude(conditions: &[Condition], design: &Design) -> Option<String> {
    let own = design.flapping.as_ref()?.half_amplitude_deg.value();
    let mut points = conditions.iter().flat_map(|condition| &condition.points);
    let point = points
        .find(|point| point.key == "flapping.half_amplitude_deg" && point.value > WHOLE_STROKE * own)?;
    Some(format!(
        "{} deg is taken for the half amplitude, {own} deg in the design: is it the whole stroke? Then write {} deg.",
        point.value,
        point.value / 2.0
    ))
}
