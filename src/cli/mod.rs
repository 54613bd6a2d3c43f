//! The command line: one file per verb.
//!
//! Exit codes: 0 done; 1 files or output could not be written, or anything else; 2 the input is at fault;
//! 3 not converged; 130 interrupted.

pub mod failure;

mod colour;

pub mod console;

pub mod design_arguments;

mod memory;

pub mod solve;

mod written;

pub mod study_file;

pub mod compare;

pub mod lift;

mod twist_source;

pub mod pareto;

pub mod fronts;

mod marked_wings;

mod fitted_factor;

mod finished;

pub mod job;

pub mod tasks;

pub mod slurm;

pub mod sweep;

pub mod design;

pub mod layouts;

mod layout_summary;

mod rod_aim;

pub mod divergence;

pub mod modes;

pub mod mesh;

pub mod measure;

pub mod init;

pub mod schema;

pub mod documents;

pub mod reference;

pub mod effects;

pub mod diagnose;

pub mod explain;

pub mod add;

pub mod report;

pub mod plot;

pub mod synthesize;

pub mod blind;

pub mod check;

pub mod diff;

pub mod export;

pub mod verify;

pub mod doctor;

pub mod live;

mod live_verbs;

pub mod completions;

pub mod man;

pub mod misused;

use std::process::ExitCode;

use clap::{CommandFactory, Parser, Subcommand};

pub use console::{Common, Console};
pub use failure::Failure;

/// The twist of a flexible wing under air load, from a design file.
#[derive(Debug, Parser)]
#[command(name = "washout", version, about, color = clap::ColorChoice::Never, max_term_width = 80)]
#[command(after_help = "Examples:
  # write a design to start from
  washout init my-wing
  # twist, forces, stresses, ParaView files
  washout solve designs/twist-v2.toml
  # where the model misses the measurement
  washout compare designs/twist-v1.toml
  # all options of a verb
  washout help solve

Exit codes: 0 done, 1 cannot write or other, 2 input at fault, 3 not converged, 130 interrupted")]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub verb: Verb,
    /// What every verb understands.
    #[command(flatten)]
    pub common: Common,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Verb {
    /// Solve a design: twist profile, forces, stresses, files for ParaView
    Solve(solve::Solve),
    /// Compare a design with its measurement, in degrees, in sigma and in words
    Compare(compare::Compare),
    /// What twist buys: lift, power and efficiency over the stroke, wings side by side
    Lift(lift::Lift),
    /// The front between lift and efficiency over twist profiles
    Pareto(pareto::Pareto),
    /// Many cases: keys of a design or study over values, in one table; on one machine or on a cluster
    Sweep(sweep::Sweep),
    /// The rods that make a wanted twist, and their cutting template
    Design(design::DesignRod),
    /// Raise the speed or the amplitude until the wing has no equilibrium any more
    Divergence(divergence::Divergence),
    /// Natural frequencies and mode shapes, unloaded or in flight
    Modes(modes::Modes),
    /// Write the mesh of a design, for VTK and Gmsh
    Mesh(mesh::WriteMesh),
    /// Turn marks clicked in video frames into twist with its error, as a measurement file
    Measure(measure::Measure),
    /// Write a commented design, or a study, to start from
    Init(init::Init),
    /// Print the JSON schema of a file or of an output
    Schema(schema::Schema),
    /// Find which physics the model of a study lacks, and how sure that is
    Diagnose(diagnose::Diagnose),
    /// Find what it would take to explain a few readings: the least implausible sets of changes
    Explain(explain::Explain),
    /// Add an effect to the model of a study, and see the error fall
    Add(add::Add),
    /// Move the inputs of a design or a study on a page in the browser, and see the wing follow; or mark the frames of a video
    Live(live::Live),
    /// Make measurements with a hidden effect, to try a campaign before trusting it
    Synthesize(synthesize::Synthesize),
    /// Diagnose many cases whose answer is known, and print the scoreboard
    Blind(blind::TryBlind),
    /// List the physics that can be added to a design, or print the card of one
    Effects(effects::ListEffects),
    /// Check a run: files and inputs unchanged, its shape in equilibrium
    Check(check::Check),
    /// Compare two runs: inputs, results, twist
    Diff(diff::Diff),
    /// One HTML file of a run or a study: the wing in 3D, pictures, tables, for a browser or a printer
    Report(report::Report),
    /// The pictures of a run for print: SVG and PNG
    Plot(plot::Plot),
    /// Write a run as input for another program, for a second opinion
    Export(export::Export),
    /// Run the published cases that say how far to trust the solver
    Verify(verify::Verify),
    /// Print version, features and threads, and check some solves with a known answer
    Doctor(doctor::Doctor),
    /// Print the completions of a shell
    Completions(completions::Completions),
    /// Write manual pages
    Man(man::Man),
}

/// The program: parses the arguments of the process, runs one verb, and says by the exit code how it ended. A program that adds
/// effects of its own calls it after [`crate::effects::register`].
pub fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            misused::tell(&error);
            return ExitCode::from(error.exit_code() as u8);
        }
    };
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            console::complain(&failure);
            ExitCode::from(failure.exit_code())
        }
    }
}

/// Runs one verb on the console of the process.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    run_on(&Console::new(&arguments.common), arguments)
}

/// Runs the words of a command line behind `washout` on a console.
fn run_words(words: &[String], console: &Console) -> Result<(), Failure> {
    let words = std::iter::once("washout").chain(words.iter().map(String::as_str));
    let arguments = Arguments::try_parse_from(words).map_err(|error| Failure::Option {
        option: "washout",
        reason: error.to_string(),
    })?;
    run_on(console, &arguments)
}

/// Runs one verb on a console.
pub fn run_on(console: &Console, arguments: &Arguments) -> Result<(), Failure> {
    if let Some(threads) = arguments.common.threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
        pool.build_global()
            .map_err(|error| Failure::Threads(error.to_string()))?;
    }
    let result = match &arguments.verb {
        Verb::Solve(verb) => verb.run(console),
        Verb::Compare(verb) => verb.run(console),
        Verb::Lift(verb) => verb.run(console),
        Verb::Pareto(verb) => verb.run(console),
        Verb::Sweep(verb) => verb.run(console),
        Verb::Design(verb) => verb.run(console),
        Verb::Divergence(verb) => verb.run(console),
        Verb::Modes(verb) => verb.run(console),
        Verb::Mesh(verb) => verb.run(console),
        Verb::Measure(verb) => verb.run(console),
        Verb::Init(verb) => verb.run(console),
        Verb::Schema(verb) => verb.run(Arguments::command(), console),
        Verb::Diagnose(verb) => verb.run(console),
        Verb::Explain(verb) => verb.run(console),
        Verb::Add(verb) => verb.run(console),
        Verb::Live(verb) => verb.run(run_words, console),
        Verb::Synthesize(verb) => verb.run(console),
        Verb::Blind(verb) => verb.run(console),
        Verb::Effects(verb) => verb.run(console),
        Verb::Check(verb) => verb.run(console),
        Verb::Diff(verb) => verb.run(console),
        Verb::Report(verb) => verb.run(console),
        Verb::Plot(verb) => verb.run(console),
        Verb::Export(verb) => verb.run(console),
        Verb::Verify(verb) => verb.run(console),
        Verb::Doctor(verb) => verb.run(console),
        Verb::Completions(verb) => verb.run(Arguments::command(), console),
        Verb::Man(verb) => verb.run(Arguments::command(), console),
    };
    console.progress().finish();
    result
}
