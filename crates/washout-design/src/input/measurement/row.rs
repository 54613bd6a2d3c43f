//! One row of a measurement file: every column checked against the channel.

use super::{Bound, CHANNELS, Channel, Row, SigmaKind};
use crate::input::design::Instrument;
use crate::input::error::{InputError, Problem, Range};
use crate::input::table::Record;

/// Standard deviations that are accepted, in the unit of the channel.
const SIGMAS: std::ops::RangeInclusive<f64> = 1e-9..=1e9;

pub(super) fn read_row(record: &Record) -> Result<Row, InputError> {
    let case = record.text("case").to_string();
    if case.is_empty() {
        return Err(record.fault(
            "case",
            Problem::Missing,
            "Name the wing and condition, e.g. twist-v2",
        ));
    }
    let channel = record.word("channel", &CHANNELS, "Give what was measured, e.g. twist")?;
    read_unit(record, channel)?;
    let instrument = read_instrument(record, channel)?;
    let washout = read_sign(record, channel)?;
    let (r_mm, r_to_mm) = read_station(record, channel)?;
    let chord_fraction = read_chord_fraction(record, channel)?;
    let cure = format!("Give the value in {}, e.g. 12.5", unit_words(channel));
    let is_planned = record.text("value").is_empty();
    let value = match is_planned {
        true => 0.0,
        false => record.number_in("value", channel.range(), &cure)?,
    };
    let sigma = read_sigma(record)?;
    let kinds = [
        ("stated", SigmaKind::Stated),
        ("repeats", SigmaKind::Repeats),
        ("assumed", SigmaKind::Assumed),
    ];
    let sigma_kind = record.word("sigma_kind", &kinds, "Say where sigma comes from")?;
    let bound = read_bound(record, washout)?;
    Ok(Row {
        line: record.line,
        case,
        channel,
        instrument,
        run: record.text("run").to_string(),
        r_mm,
        r_to_mm,
        chord_fraction,
        value: if washout { value } else { -value },
        is_planned,
        sigma,
        sigma_kind,
        bound,
    })
}

fn read_sigma(record: &Record) -> Result<f64, InputError> {
    let cure = "Give the standard deviation of the value in its unit; if the source states none, assume one \
                and write sigma_kind = assumed";
    let sigma = record.number("sigma", cure)?;
    if sigma <= 0.0 {
        return Err(record.conflict("sigma", "must be larger than 0", &[], cure));
    }
    if !SIGMAS.contains(&sigma) {
        let words = format!("outside {:e} to {:e}", SIGMAS.start(), SIGMAS.end());
        return Err(record.conflict("sigma", words, &[], cure));
    }
    Ok(sigma)
}

/// Whether the value is only a bound, as washout has it.
fn read_bound(record: &Record, washout: bool) -> Result<Bound, InputError> {
    let bounds = [
        ("none", Bound::None),
        ("upper", Bound::Upper),
        ("lower", Bound::Lower),
    ];
    let bound = record.word("bound", &bounds, "Write none unless the value is only a bound")?;
    Ok(match (washout, bound) {
        (false, Bound::Upper) => Bound::Lower,
        (false, Bound::Lower) => Bound::Upper,
        _ => bound,
    })
}

fn unit_words(channel: Channel) -> &'static str {
    match channel.unit() {
        "1" => "parts of the rigid wing (1.35 for +35 %)",
        unit => unit,
    }
}

fn read_unit(record: &Record, channel: Channel) -> Result<(), InputError> {
    let unit = channel.unit();
    if record.text("unit") == unit {
        return Ok(());
    }
    let cure = format!(
        "Convert value and sigma to {} and write unit {unit}",
        unit_words(channel)
    );
    let problem = match record.text("unit") {
        "" => Problem::Missing,
        _ => Problem::Conflict {
            message: match unit {
                "1" => format!("the channel {} is a ratio, with the unit 1", channel.name()),
                _ => format!("the channel {} is given in {unit}", channel.name()),
            },
            with: vec!["channel".to_string()],
        },
    };
    Err(record.fault("unit", problem, &cure))
}

fn read_instrument(record: &Record, channel: Channel) -> Result<Option<Instrument>, InputError> {
    let words = Instrument::ALL.map(|instrument| (instrument.name(), instrument));
    match (channel.is_twist(), record.text("instrument")) {
        (true, _) => record
            .word("instrument", &words, "Say how twist was read")
            .map(Some),
        (false, "") => Ok(None),
        (false, _) => {
            let message = format!("only twist has an instrument, not {}", channel.name());
            Err(record.conflict("instrument", message, &["channel"], "Leave it empty"))
        }
    }
}

/// Whether twist counts as washout; true for channels without a sign.
fn read_sign(record: &Record, channel: Channel) -> Result<bool, InputError> {
    let words = [("washout", true), ("nose_up", false)];
    match (channel.is_twist(), record.text("sign")) {
        (true, _) => record.word(
            "sign",
            &words,
            "Write washout where a positive value lowers the angle of attack",
        ),
        (false, "") => Ok(true),
        (false, _) => {
            let message = format!("only twist has a sign, not {}", channel.name());
            Err(record.conflict("sign", message, &["channel"], "Leave it empty"))
        }
    }
}

fn read_station(record: &Record, channel: Channel) -> Result<(Option<f64>, Option<f64>), InputError> {
    let cure = "Give the distance from the wing base in millimetres, e.g. 35.0";
    let range = Range {
        low: 0.0,
        high: 100000.0,
        open: false,
        unit: "mm",
    };
    let empty = |column: &str, needs: &str| -> Result<Option<f64>, InputError> {
        match record.text(column) {
            "" => Ok(None),
            _ => {
                let message = format!("the channel {} {needs}", channel.name());
                Err(record.conflict(column, message, &["channel"], "Leave it empty"))
            }
        }
    };
    if !channel.has_station() {
        return Ok((
            empty("r_mm", "belongs to the whole wing")?,
            empty("r_to_mm", "belongs to the whole wing")?,
        ));
    }
    let r_mm = record.number_in("r_mm", range, cure)?;
    if channel != Channel::TwistRate {
        return Ok((
            Some(r_mm),
            empty("r_to_mm", "belongs to one station, not to an interval")?,
        ));
    }
    let r_to_mm = record.number_in(
        "r_to_mm",
        range,
        "Give the outer end of the interval in millimetres, e.g. 48.0",
    )?;
    if r_to_mm <= r_mm {
        let message = format!("must be larger than r_mm = {r_mm}");
        let cure = "Give the inner end as r_mm and the outer end as r_to_mm";
        return Err(record.conflict("r_to_mm", message, &["r_mm"], cure));
    }
    Ok((Some(r_mm), Some(r_to_mm)))
}

/// Where on the chord a displacement was read; the leading edge where nothing is said.
fn read_chord_fraction(record: &Record, channel: Channel) -> Result<Option<f64>, InputError> {
    let column = "chord_fraction";
    match (channel.is_displacement(), record.text(column)) {
        (true, "") => Ok(Some(0.0)),
        (true, _) => {
            let range = Range {
                low: 0.0,
                high: 1.0,
                open: false,
                unit: "",
            };
            let cure =
                "Give the place as a fraction of the chord, 0 at the leading edge, 1 at the trailing edge";
            record.number_in(column, range, cure).map(Some)
        }
        (false, "") => Ok(None),
        (false, _) => {
            let message = format!(
                "only displacements have a place on the chord, not {}",
                channel.name()
            );
            Err(record.conflict(column, message, &["channel"], "Leave it empty"))
        }
    }
}

/// What two rows must not share: they would be one number stated twice.
pub(super) fn identity(row: &Row) -> (String, Channel, Option<Instrument>, String, [Option<u64>; 3]) {
    let place =
        [row.r_mm, row.r_to_mm, row.chord_fraction].map(|station| station.map(|mm| (mm + 0.0).to_bits()));
    (
        row.case.clone(),
        row.channel,
        row.instrument,
        row.run.clone(),
        place,
    )
}
