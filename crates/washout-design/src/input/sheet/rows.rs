//! From the cells of a table to measured rows, each with its condition.

use std::collections::HashMap;

use super::cells::{Cells, Checked};
use super::condition::Condition;
use super::grid::{Grid, Line};
use super::header::{Column, Role, reading_factor};
use super::sigmas::Sigmas;
use crate::input::design::{Design, Instrument};
use crate::input::error::InputError;
use crate::input::measurement::{Bound, CHANNELS, Channel, Row, SigmaKind};

/// Standard deviation of a twist that states none, deg, and of a displacement, mm: a careful reading of a video frame.
const SIGMA: f64 = 0.5;

/// Run of readings of the still wing that name none: they have a zero of their own.
pub const ON_BENCH: &str = "bench";

const BOUNDS: [(&str, Bound); 3] = [
    ("none", Bound::None),
    ("upper", Bound::Upper),
    ("lower", Bound::Lower),
];

const SIGMA_KINDS: [(&str, SigmaKind); 3] = [
    ("stated", SigmaKind::Stated),
    ("repeats", SigmaKind::Repeats),
    ("assumed", SigmaKind::Assumed),
];

/// What was read.
pub struct Read {
    pub rows: Vec<Row>,
    /// Each once, in the order of the table.
    pub conditions: Vec<Condition>,
    pub assumed: Vec<[String; 2]>,
}

/// Reads a table.
pub struct Reader<'a> {
    pub(super) cells: Cells<'a>,
    pub(super) design: &'a Design,
    sigma: &'a Sigmas,
    pub(super) rows: Vec<Row>,
    pub(super) conditions: Vec<Condition>,
}

impl<'a> Reader<'a> {
    pub fn new(grid: &'a Grid, columns: &'a [Column], design: &'a Design, sigma: &'a Sigmas) -> Reader<'a> {
        Reader {
            cells: Cells::new(grid, columns),
            design,
            sigma,
            rows: Vec::new(),
            conditions: Vec::new(),
        }
    }

    pub fn read(mut self) -> Checked<Read> {
        let columns = self.cells.columns;
        let is_reading = |column: &&Column| matches!(column.role, Role::Readings { is_sigma: false, .. });
        if !columns.iter().any(|column| is_reading(&column)) {
            let head = self.cells.grid.head.cells.join(", ");
            let cure = "Name one column for each condition, e.g. 22 Hz, or one for all, e.g. twist (deg)"
                .to_string();
            return Err(self.cells.grid.fault(
                self.cells.grid.head.number,
                &head,
                "",
                "holds no readings",
                cure,
            ));
        }
        for line in &self.cells.grid.lines {
            for column in columns.iter().filter(is_reading) {
                self.reading(line, column)?;
            }
        }
        self.cells.marks_differ()?;
        if self.rows.is_empty() {
            return Err(InputError::about_file(
                &self.cells.grid.input.file,
                "has no reading",
                "Fill in the values",
            ));
        }
        self.rows_repeat()?;
        self.names_differ()?;
        Ok(Read {
            rows: self.rows,
            conditions: self.conditions,
            assumed: self.cells.assumed,
        })
    }

    fn reading(&mut self, line: &Line, column: &Column) -> Checked<()> {
        let Role::Readings {
            points,
            bench,
            station,
            channel,
            nose_up,
            ..
        } = &column.role
        else {
            return Ok(());
        };
        let Some(value) = self.cells.number(line, column)? else {
            return Ok(());
        };
        let (channel, factor) = self.quantity(line, column, *channel)?;
        let (nose_up, instrument) = self.seen(line, channel, *nose_up)?;
        let bound = self.cells.choice(line, "bound", &BOUNDS, (Bound::None, ""))?;
        let (sigma, is_stated) = self.sigma(line, column, channel, factor)?;
        let usual = if is_stated {
            SigmaKind::Stated
        } else {
            SigmaKind::Assumed
        };
        let sigma_kind = self.cells.choice(line, "sigma_kind", &SIGMA_KINDS, (usual, ""))?;
        let run = self.run(line);
        let [r_mm, r_to_mm] = self.place(line, column, channel, *station)?;
        let fraction = self
            .cells
            .number_of(line, |role| *role == Role::Word("chord_fraction"))?;
        let value = value * factor * if nose_up { -1.0 } else { 1.0 };
        if !channel.range().contains(value) {
            let cure = format!("{} must lie in {}", channel.name(), channel.range());
            return Err(self.cells.refuse(line, column, "is out of range", cure));
        }
        let condition = self.condition(line, column, points.clone(), *bench)?;
        let is_on_bench = |known: &Condition| known.bench.is_some() && known.case() == condition;
        // a zero of its own: it was not read in flight
        let run = match run.is_empty() && self.conditions.iter().any(is_on_bench) {
            true => ON_BENCH.to_string(),
            false => run,
        };
        self.rows.push(Row {
            line: line.number,
            case: condition,
            channel,
            instrument,
            run,
            r_mm,
            r_to_mm,
            chord_fraction: channel.is_displacement().then_some(fraction.unwrap_or(0.0)),
            value,
            is_planned: false,
            sigma,
            sigma_kind,
            bound: match (bound, nose_up) {
                (Bound::Upper, true) => Bound::Lower,
                (Bound::Lower, true) => Bound::Upper,
                (bound, _) => bound,
            },
        });
        Ok(())
    }

    /// The channel of a reading, and what it is multiplied by for the unit that its row names.
    fn quantity(&mut self, line: &Line, column: &Column, named: Option<Channel>) -> Checked<(Channel, f64)> {
        let channel = match named {
            Some(channel) => channel,
            None => self
                .cells
                .choice(line, "channel", &CHANNELS, (Channel::Twist, "twist"))?,
        };
        let unit = self.cells.word(line, "unit").map(|(cell, _)| cell.to_lowercase());
        if unit.is_none() && !column.has_unit {
            self.cells.assume("unit", channel.unit());
        }
        let factor = reading_factor(unit.as_deref(), Some(channel)).map_err(|(message, cure)| {
            let unit = unit.as_deref().unwrap_or_default();
            self.cells.grid.fault(line.number, "unit", unit, &message, cure)
        })?;
        Ok((channel, factor))
    }

    fn run(&mut self, line: &Line) -> String {
        let run = self
            .cells
            .word(line, "run")
            .map_or(String::new(), |(cell, _)| cell.to_string());
        if run.is_empty() {
            self.cells
                .assume("run", "one for all readings in air, one for all on the bench");
        }
        run
    }

    /// Whether a twist is counted nose up, and the instrument that it was read with.
    fn seen(
        &mut self,
        line: &Line,
        channel: Channel,
        nose_up: Option<bool>,
    ) -> Checked<(bool, Option<Instrument>)> {
        let is_twist = channel.is_twist();
        let signs = [("washout", false), ("nose_up", true), ("nose_down", false)];
        let nose_up = match nose_up {
            Some(up) => up,
            None if is_twist => self.cells.choice(
                line,
                "sign",
                &signs,
                (false, "washout (positive lowers the angle of attack)"),
            )?,
            None => false,
        };
        let instruments = Instrument::ALL.map(|instrument| (instrument.name(), instrument));
        let instrument = match is_twist {
            true => Some(self.cells.choice(
                line,
                "instrument",
                &instruments,
                (Instrument::default(), Instrument::default().name()),
            )?),
            false => None,
        };
        Ok((nose_up, instrument))
    }

    /// The station of a reading and the end of its interval, mm, as far as its channel has them.
    fn place(
        &mut self,
        line: &Line,
        column: &Column,
        channel: Channel,
        station: Option<f64>,
    ) -> Checked<[Option<f64>; 2]> {
        let r_mm = match station {
            Some(station) => Some(station),
            None => {
                let columns = self.cells.columns;
                let column = columns.iter().find(|column| column.role == Role::Station);
                if column.is_some_and(|column| !column.has_unit) {
                    self.cells.assume("unit of stations", "mm");
                }
                self.cells.number_of(line, |role| *role == Role::Station)?
            }
        };
        let r_to_mm = self.cells.number_of(line, |role| *role == Role::StationTo)?;
        if (channel.has_station() && r_mm.is_none()) || (channel == Channel::TwistRate && r_to_mm.is_none()) {
            let cure = "Give the distance from the wing base in a column r (mm); for twist_rate the outer end in r_to (mm) too";
            let message = format!("{} has no station", channel.name());
            return Err(self.cells.grid.fault(
                line.number,
                self.cells.head(column),
                "",
                &message,
                cure.to_string(),
            ));
        }
        Ok([
            r_mm.filter(|_| channel.has_station()),
            r_to_mm.filter(|_| channel == Channel::TwistRate),
        ])
    }

    /// The standard deviation of a reading, and whether the table states it.
    fn sigma(&mut self, line: &Line, of: &Column, channel: Channel, factor: f64) -> Checked<(f64, bool)> {
        let Role::Readings {
            points,
            bench,
            station,
            channel: named,
            ..
        } = &of.role
        else {
            return Ok((SIGMA, false));
        };
        let columns = self.cells.columns;
        let fits = |column: &&Column, own: bool| match &column.role {
            Role::Readings {
                points: p,
                bench: b,
                station: s,
                channel: c,
                is_sigma: true,
                ..
            } => {
                let place = if own {
                    p == points && b == bench && s == station
                } else {
                    p.is_empty() && b.is_none() && s.is_none()
                };
                place && (c.is_none() || c == named || (named.is_none() && *c == Some(channel)))
            }
            _ => false,
        };
        let column = columns.iter().find(|column| fits(column, true));
        let column = column.or_else(|| columns.iter().find(|column| fits(column, false)));
        let stated = match column {
            Some(column) => self
                .cells
                .number(line, column)?
                .map(|sigma| (sigma * factor, column)),
            None => None,
        };
        if let Some((sigma, column)) = stated {
            if !(1e-9..=1e9).contains(&sigma) {
                let cure = "Give one standard deviation, above 0, or leave the cell empty".to_string();
                return Err(self.cells.refuse(line, column, "must be positive", cure));
            }
            return Ok((sigma, true));
        }
        let has_usual = channel == Channel::Twist || channel.is_displacement();
        let Some(sigma) = self.sigma.of(channel).or(has_usual.then_some(SIGMA)) else {
            let message = format!("{} has no sigma", channel.name());
            let cure = format!("Add a column sigma ({}), or give --sigma", channel.unit());
            return Err(self
                .cells
                .grid
                .fault(line.number, self.cells.head(of), "", &message, cure));
        };
        self.cells.assume(
            &format!("sigma of {}", channel.name()),
            &format!("{sigma} {}", channel.unit()),
        );
        Ok((sigma, false))
    }

    fn rows_repeat(&self) -> Checked<()> {
        let mut seen = HashMap::new();
        for row in &self.rows {
            let bits = |number: Option<f64>| number.map(f64::to_bits);
            let same = (
                &row.case,
                row.channel,
                &row.run,
                [bits(row.r_mm), bits(row.r_to_mm), bits(row.chord_fraction)],
            );
            if let Some(first) = seen.insert(same, row.line) {
                let message = format!("repeats the reading on line {first}");
                let cure = "Delete one of them, or tell repeats apart in a column run".to_string();
                return Err(self.cells.grid.fault(row.line, "r", "", &message, cure));
            }
        }
        Ok(())
    }
}
