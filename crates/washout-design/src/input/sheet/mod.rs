//! A table of readings as people keep it: long or wide, from a spreadsheet or a text file, made into a measurement and a study.

use std::collections::BTreeSet;
use std::path::Path;

use super::design::{Design, Section};
use super::error::InputError;
use super::load::Loaded;
use super::measurement::{Made, Measurement, SigmaKind};

mod bench;

mod cells;

mod condition;

mod doubts;

mod grid;

mod header;

mod of_design;

mod row_condition;

mod rows;

mod sigmas;

pub mod study;

mod words;

mod zeros;

pub use bench::{Bench, Load, STILL_HZ, short};
pub use condition::Family;
pub use of_design::DesignReadings;
pub use rows::ON_BENCH;
pub use sigmas::Sigmas;

/// A table that was read for a design, with all that was understood of it and all that was assumed.
#[derive(Debug, Clone)]
pub struct Sheet {
    /// The design that it was measured on, as its file has it.
    pub loaded: Loaded,
    /// Its readings; the cases are named after their conditions.
    pub measurement: Measurement,
    /// The families of its conditions.
    pub families: Vec<Family>,
    /// What each column, and the file itself, was taken for.
    pub understood: Vec<[String; 2]>,
    /// What the table does not say, with the value that is used instead.
    pub assumed: Vec<[String; 2]>,
    /// What looks wrong in it, each with what to write if it is.
    pub doubts: Vec<String>,
}

impl Sheet {
    /// Reads the table at `path`, measured on the design at `design`; `sigma`: the standard deviations of readings that have none.
    ///
    /// # Errors
    /// If either cannot be read, or a header or a cell is not understood: with its place and what to write.
    pub fn load(path: &Path, design: &Path, sigma: &Sigmas) -> Result<Sheet, InputError> {
        let loaded = Design::load(design, &[])?;
        Sheet::of_grid(grid::Grid::load(path)?, loaded, sigma)
    }

    /// Reads a table from its text, for a design that is read already.
    ///
    /// # Errors
    /// As [`Sheet::load`].
    ///
    /// # Example
    /// ```
    /// # use washout_design as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use std::path::Path;
    /// use washout::input::{Design, sheet::Sheet};
    ///
    /// let design = Design::load(Path::new("designs/twist-v2.toml"), &[])?.design;
    /// let table = "r (mm);22 Hz, 30 deg;23 Hz, 34 deg\n40;5,1;6,0\n60;11,2;13,4\n";
    /// let sheet = Sheet::from_text(table, "sheet.csv", design, &0.5.into())?;
    /// assert_eq!(sheet.measurement.rows.len(), 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_text(text: &str, file: &str, design: Design, sigma: &Sigmas) -> Result<Sheet, InputError> {
        let input = crate::origin::InputFile::new(file, text.as_bytes());
        Sheet::of_grid(grid::Grid::of_text(text, input)?, Loaded::alone(design), sigma)
    }

    fn of_grid(grid: grid::Grid, loaded: Loaded, sigma: &Sigmas) -> Result<Sheet, InputError> {
        let columns = header::columns(&grid, &loaded.design)?;
        let read = rows::Reader::new(&grid, &columns, &loaded.design, sigma).read()?;
        let measurement = Measurement {
            file: grid.input.file.clone(),
            comments: grid.comments.clone(),
            input: Some(grid.input.clone()),
            made: Made::of_file(&format!("# {}\n", grid.comments.join("\n# ")), &grid.input.file)?,
            rows: read.rows,
        };
        sigma_is_used(&measurement, sigma)?;
        let doubts = doubts::doubts(&measurement, &columns, &read.conditions, &loaded.design)?;
        let doubts: Vec<String> = doubts.into_iter().chain(of_sigma(&measurement, sigma)).collect();
        let head = |role: header::Role, usual: &str| {
            let own = columns.iter().find(|column| column.role == role);
            own.map_or(usual.to_string(), |own| grid.head.cells[own.place].clone())
        };
        let heads = [
            head(header::Role::Station, "station"),
            head(header::Role::StationTo, "r_to"),
        ];
        measurement.check_stations(&loaded.design, [&heads[0], &heads[1]])?;
        let mut understood = vec![["file".to_string(), grid.dialect.clone()]];
        let heads = columns.iter().map(|column| {
            let name = grid.head.cells.get(column.place).cloned().unwrap_or_default();
            [name, column.words()]
        });
        understood.extend(heads);
        let mut assumed = read.assumed;
        assumed.extend(zeros::zeros(&measurement).into_iter().map(|(channel, sigma)| {
            let is = format!("known to {sigma} {}, as a reading is", channel.unit());
            [format!("zero of {}", channel.name().replace('_', " ")), is]
        }));
        assumed.extend(condition::of_design(&read.conditions, &loaded.design));
        assumed.extend(choice(&loaded.design));
        assumed.extend(flats(&loaded.design));
        Ok(Sheet {
            families: condition::families(&read.conditions, &loaded.design),
            loaded,
            measurement,
            understood,
            assumed,
            doubts,
        })
    }
}

/// How the root edge of a film is held, which is a choice of two that no fit moves.
fn choice(design: &Design) -> Option<[String; 2]> {
    design.film.as_ref()?;
    let word = toml::Value::try_from(design.root.chord).ok()?;
    Some(["root.chord".to_string(), format!("{word}, of the design")])
}

/// How the flat of each half-round lies, which its shape alone does not say.
fn flats(design: &Design) -> impl Iterator<Item = [String; 2]> {
    let pieces = design.rod.iter().enumerate();
    pieces.filter_map(|(index, piece)| {
        let Section::HalfRound { flat, .. } = &piece.section else {
            return None;
        };
        let word = toml::Value::try_from(flat).ok()?;
        Some([
            format!("rod[{index}].section.flat"),
            format!("{word}, of the design"),
        ])
    })
}

/// Refuses a standard deviation in a unit that no reading has.
fn sigma_is_used(table: &Measurement, sigma: &Sigmas) -> Result<(), InputError> {
    let units: BTreeSet<&str> = table.rows.iter().map(|row| row.channel.unit()).collect();
    let Some((unit, value)) = sigma.of_units().find(|(unit, _)| !units.contains(unit)) else {
        return Ok(());
    };
    let have: Vec<&str> = units.into_iter().collect();
    Err(InputError::about_file(
        "--sigma",
        format!(
            "{value} {unit} is of no reading of {}, whose unit is {}",
            table.file,
            have.join(" or ")
        ),
        format!("Write e.g. --sigma \"{value} {}\"", have[0]),
    ))
}

/// That one standard deviation without a unit was taken for readings of several.
fn of_sigma(table: &Measurement, sigma: &Sigmas) -> Option<String> {
    let any = sigma.any()?;
    let rows = table
        .rows
        .iter()
        .filter(|row| row.sigma_kind == SigmaKind::Assumed);
    let units: BTreeSet<&str> = rows
        .filter(|row| sigma.of(row.channel) == Some(any))
        .map(|row| row.channel.unit())
        .collect();
    (units.len() > 1).then(|| {
        let taken: Vec<String> = units.iter().map(|unit| format!("{any} {unit}")).collect();
        format!(
            "the same sigma was taken for all channels: {}. Give one for each: --sigma \"0.3 deg, 0.05 mm\"",
            taken.join(" and ")
        )
    })
}
