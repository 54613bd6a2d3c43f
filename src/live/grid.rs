//! A grid of solved wings over one to three inputs or effects, for a page that moves through it without this program.

use std::collections::BTreeMap;

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use serde::Serialize;

use crate::export::html::Wing;
use crate::page::text::significant;
use crate::progress::Progress;
use crate::wing::SolvedWing;

use super::opened::CaseWing;
use super::refusal::Refusal;
use super::session::Session;
use super::shape::{About, document, drawn, read};

/// Points along each axis, by the number of axes.
const POINTS: [usize; 3] = [21, 9, 5];
/// Bytes that the numbers of all points may take, of the 5 MB of a page.
const MOST: usize = 4_200_000;
/// What an effect is called among the axes.
const EFFECT: &str = "effect:";

/// One axis.
#[derive(Debug, Clone, Serialize)]
struct Axis {
    /// Key of the input, or `effect:NAME`.
    key: String,
    /// Places along it, rising.
    values: Vec<f64>,
}

/// One point.
#[derive(Debug, Clone, Serialize)]
struct Point {
    solved: bool,
    twist_deg: Vec<f64>,
    angle_of_attack_deg: Option<Vec<f64>>,
    numbers: Vec<f64>,
    /// Points under load, µm, as the viewer has them.
    loaded: Vec<i64>,
    fields: Vec<Vec<f64>>,
    refusal: Option<String>,
}

/// The grid of a session over inputs (`flapping.frequency_hz`) and effects (`root-flexure`), as JSON.
///
/// # Errors
/// If there are no such inputs, the wing as opened has no shape, an axis changes its mesh, or somebody asked to stop.
pub fn grid(session: &Session, over: &[String], progress: &Progress) -> Result<String, Refusal> {
    let axes = axes(session, over)?;
    let first = session.wing()?;
    let solved = first.model.solve(progress)?;
    let total: usize = axes.iter().map(|axis| axis.values.len()).product();
    let done = std::sync::atomic::AtomicUsize::new(0);
    let points: Vec<Result<Point, Refusal>> = (0..total)
        .into_par_iter()
        .map(|index| {
            progress.check().map_err(Refusal::new)?;
            let point = point(session, &axes, index, &solved, &progress.unseen());
            let count = 1 + done.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            progress.count(count, total, "wings");
            point
        })
        .collect();
    let mut points: Vec<Point> = points.into_iter().collect::<Result<_, _>>()?;
    progress.check().map_err(Refusal::new)?;
    slim(&mut points)?;
    let about = About {
        revision: 1,
        shape_revision: 1,
        solved: true,
        settled: true,
        case: session.case(),
        ..About::default()
    };
    let read = read(&solved, first.measured.as_ref())?;
    let wing = drawn(&first.name, &solved, first.measured.as_ref(), None)?;
    written(
        session,
        &axes,
        &document(&about, Some(&read), Some(&wing)),
        &points,
    )
}

fn written(session: &Session, axes: &[Axis], shape: &str, points: &[Point]) -> Result<String, Refusal> {
    let mut state = session.state();
    let is_axis = |key: &str| axes.iter().any(|axis| axis.key == key);
    state.inputs.retain(|input| is_axis(&input.key));
    state
        .effects
        .retain(|effect| is_axis(&format!("{EFFECT}{}", effect.name)));
    for axis in axes {
        let ends = [axis.values[0], axis.values[axis.values.len() - 1]];
        for input in state.inputs.iter_mut().filter(|input| input.key == axis.key) {
            ([input.low, input.high], input.allowed) = (ends, ends);
        }
        let of_axis = |name: &str| format!("{EFFECT}{name}") == axis.key;
        for effect in state.effects.iter_mut().filter(|effect| of_axis(effect.name)) {
            ([effect.low, effect.high], effect.allowed) = (ends, ends);
        }
    }
    let text = |value: serde_json::Result<String>| value.map_err(Refusal::new);
    // the shape is text already
    Ok(format!(
        "{{\"kind\":\"live-grid\",\"format\":1,\"state\":{},\"axes\":{},\"shape\":{shape},\"points\":{}}}",
        text(serde_json::to_string(&state))?,
        text(serde_json::to_string(axes))?,
        text(serde_json::to_string(points))?
    ))
}

/// The axes: evenly over each slider, the value as opened among them.
fn axes(session: &Session, over: &[String]) -> Result<Vec<Axis>, Refusal> {
    let (state, count) = (session.state(), over.len());
    if count == 0 || count > POINTS.len() {
        return Err(Refusal::new(format!(
            "{count} inputs to move: name one to three, separated by commas"
        )));
    }
    let mut axes: Vec<Axis> = Vec::new();
    for name in over {
        let input = state.inputs.iter().find(|input| input.key == *name);
        let bare = name.strip_prefix(EFFECT).unwrap_or(name);
        let effect = state.effects.iter().find(|effect| effect.name == bare);
        let (key, low, high, value) = match (input, effect) {
            (Some(input), _) => (name.clone(), input.low, input.high, input.value),
            (None, Some(effect)) => {
                let value = effect.value.unwrap_or(effect.none);
                (format!("{EFFECT}{bare}"), effect.low, effect.high, value)
            }
            (None, None) => {
                let message = "is no input or effect that can be moved here";
                return Err(Refusal::at(name, message, "The page of washout live shows all"));
            }
        };
        if axes.iter().any(|axis| axis.key == key) {
            return Err(Refusal::at(name, "is named twice", "Name it once"));
        }
        axes.push(Axis {
            key,
            values: places(low, high, value, POINTS[count - 1]),
        });
    }
    Ok(axes)
}

/// Places evenly from `low` to `high`; the one nearest to `value` is moved there.
fn places(low: f64, high: f64, value: f64, count: usize) -> Vec<f64> {
    let step = (high - low) / (count - 1) as f64;
    let mut places: Vec<f64> = (0..count).map(|k| low + step * k as f64).collect();
    places[count - 1] = high;
    let nearest = ((value - low) / step).round().clamp(0.0, (count - 1) as f64) as usize;
    if (low..=high).contains(&value) {
        places[nearest] = value;
        // the ends stay
        places[0] = places[0].min(low);
        places[count - 1] = places[count - 1].max(high);
    }
    places.dedup();
    places
}

fn point(
    session: &Session,
    axes: &[Axis],
    index: usize,
    first: &SolvedWing,
    progress: &Progress,
) -> Result<Point, Refusal> {
    let found = moved(session, axes, index).and_then(|wing| {
        let solved = wing.model.solve(progress)?;
        Ok((wing, solved))
    });
    let (wing, solved) = match found {
        Ok(found) => found,
        Err(refusal) => {
            return Ok(Point {
                solved: false,
                twist_deg: Vec::new(),
                angle_of_attack_deg: None,
                numbers: Vec::new(),
                loaded: Vec::new(),
                fields: Vec::new(),
                refusal: Some(refusal.message),
            });
        }
    };
    let (own, other) = (&solved.solution.mesh, &first.solution.mesh);
    if own.nodes.len() != other.nodes.len() || own.triangles != other.triangles {
        let keys: Vec<&str> = axes.iter().map(|axis| axis.key.as_str()).collect();
        return Err(Refusal::new(format!(
            "{}: the mesh of the wing changes with it, so no page can move through it; name inputs that keep the mesh",
            keys.join(", ")
        )));
    }
    let read = read(&solved, wing.measured.as_ref())?;
    let model = &solved.model;
    let drawn = Wing::of_solution(&wing.name, model.design(), &model.planform, &solved.solution);
    let loaded = drawn.loaded_mm.as_flattened().iter();
    Ok(Point {
        solved: true,
        twist_deg: rounded(&read.twist.twist_deg),
        angle_of_attack_deg: read.angle_of_attack.map(|attack| rounded(&attack.deg)),
        numbers: read.numbers.iter().map(|number| number.value).collect(),
        loaded: loaded.map(|length| (length * 1e3).round() as i64).collect(),
        fields: drawn.fields.iter().map(|field| rounded(&field.values)).collect(),
        refusal: None,
    })
}

/// The wing at a point; the last axis runs fastest.
fn moved(session: &Session, axes: &[Axis], mut index: usize) -> Result<CaseWing, Refusal> {
    let mut session = session.clone();
    let mut moves = BTreeMap::new();
    for axis in axes.iter().rev() {
        let value = axis.values[index % axis.values.len()];
        index /= axis.values.len();
        match axis.key.strip_prefix(EFFECT) {
            Some(effect) => session.effect(effect, Some(value), false)?,
            None => {
                moves.insert(axis.key.clone(), value);
            }
        }
    }
    session.set(&moves, false)?;
    session.wing()
}

/// To four digits, as the viewer has them.
fn rounded(values: &[f64]) -> Vec<f64> {
    let short = |value: &f64| significant(*value, 4).parse().unwrap_or(*value);
    values.iter().map(short).collect()
}

/// Takes fields out, the last first, until a page holds them all.
fn slim(points: &mut [Point]) -> Result<(), Refusal> {
    loop {
        let size = serde_json::to_string(&points).map_err(Refusal::new)?.len();
        if size <= MOST {
            return Ok(());
        }
        let most = points.iter().map(|point| point.fields.len()).max().unwrap_or(0);
        if most <= 1 {
            return Err(Refusal::new(format!(
                "the shapes of {} wings take {:.1} MB, and a page takes 5: take a coarser mesh (--set mesh.refine=0.5) or fewer inputs",
                points.len(),
                size as f64 / 1e6
            )));
        }
        points
            .iter_mut()
            .for_each(|point| point.fields.truncate(most - 1));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_value_as_opened_is_a_place_and_the_ends_stay() {
        assert_eq!(places(0.0, 4.0, 1.2, 5), [0.0, 1.2, 2.0, 3.0, 4.0]);
        assert_eq!(places(0.0, 4.0, 0.1, 5), [0.0, 1.0, 2.0, 3.0, 4.0]);
        assert_eq!(places(0.0, 4.0, 4.0, 5), [0.0, 1.0, 2.0, 3.0, 4.0]);
    }
}
