//! Results as pictures: what is drawn against what, with which mark; the drawing itself is done by `plot`.

pub mod compared;

pub mod diagnosis;

pub mod explained;

pub mod folder;

pub mod in_sigma;

pub mod ladder;

pub mod lift;

pub mod layouts;

pub mod panels;

pub mod pareto;

pub mod profile;

pub mod residuals;

pub mod sweep;

pub mod tables;

pub mod wing;

pub mod write;

use crate::input::measurement::Channel;

/// A channel in words.
fn words(channel: Channel) -> String {
    channel.name().replace('_', " ")
}

/// A quantity with its unit, as axes have it.
fn with_unit(name: &str, unit: &str) -> String {
    match unit {
        "" | "1" => name.to_string(),
        unit => format!("{name} ({unit})"),
    }
}

/// A number as short as it can be read: at most four digits, no zeros behind.
fn plain(value: f64) -> String {
    let text = crate::plot::scale::short(value, 4);
    match text.split_once('.') {
        Some((_, rest)) if rest.chars().all(|c| c.is_ascii_digit()) => {
            text.trim_end_matches('0').trim_end_matches('.').to_string()
        }
        _ => text,
    }
}
