//! Time and memory of a diagnosis: 9 conditions of the three wings, every effect that can act.
//!
//! `cargo bench --bench diagnosis`, or `cargo bench --bench diagnosis -- 0.5` for another refinement of the mesh. The data
//! are the model's own with one effect on and noise: good for timing, no proof of anything.

use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::time::Instant;

use washout::diagnose::{Settings, diagnose};
use washout::effects::ALL;
use washout::input::study::LoadedStudy;
use washout::progress::Progress;
use washout::study::{Campaign, Forward, UnknownKind};

const WINGS: [&str; 3] = ["rigid", "twist-v1", "twist-v2"];
const CONDITIONS: [(f64, f64); 3] = [(18.0, 30.0), (23.0, 34.5), (23.0, 42.0)];
const STATIONS_MM: [f64; 10] = [7.0, 14.0, 21.0, 28.0, 35.0, 42.0, 49.0, 56.0, 63.0, 67.0];
const SIGMA_DEG: f64 = 0.3;
const HIDDEN: &str = "effects.centre-of-pressure-shift.strength";

fn main() -> Result<(), Box<dyn Error>> {
    let refine = std::env::args().find_map(|word| word.parse::<f64>().ok());
    let folder = tempfile::tempdir()?;
    let names: Vec<&str> = ALL.iter().map(|effect| effect.card().name).collect();
    let study = study(folder.path(), refine.unwrap_or(1.0))?;
    measure(folder.path(), |_| 0.0)?;
    let quiet = Progress::quiet();

    let made = {
        let campaign = Campaign::new(&LoadedStudy::load(&study, &[])?, &names, &quiet)?;
        let mut truth = campaign.start();
        for (value, unknown) in truth.iter_mut().zip(campaign.unknowns()) {
            if let (UnknownKind::Effect { scale, .. }, HIDDEN) = (&unknown.kind, unknown.name.as_str()) {
                *value = 0.7 * scale;
            }
        }
        campaign.predict(&truth)?
    };
    measure(folder.path(), |row| made[row] + SIGMA_DEG * noise(row))?;

    let mut clock = Clock::new();
    let campaign = Campaign::new(&LoadedStudy::load(&study, &[])?, &names, &quiet)?;
    let start = campaign.start();
    clock.say("first solve of all conditions");
    let before = campaign.work();
    campaign.linearize(&start, &|_| true)?;
    clock.say("screening: derivatives with every effect");
    println!("  {}", campaign.work() - before);
    let settings = Settings {
        start: Some(start),
        ..Settings::default()
    };
    let diagnosis = diagnose(&campaign, &settings, &quiet)?;
    clock.say("the whole diagnosis");
    println!(
        "{}\nits screening: {}\nall of this: {}",
        diagnosis.sentence,
        diagnosis.screening,
        campaign.work()
    );
    println!("peak memory {}", status("VmHWM:"));
    Ok(())
}

/// The study, with its measurement `measured.csv` beside it.
fn study(folder: &Path, refine: f64) -> Result<std::path::PathBuf, Box<dyn Error>> {
    let mut text = "format = 1\nname = 'bench'\ntitle = 'bench'\n".to_string();
    for wing in WINGS {
        let design = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("designs/{wing}.toml"));
        write!(
            text,
            "[[case]]\ndesign = '{}'\nset = ['flapping.frequency_hz={{f}}', 'flapping.half_amplitude_deg={{phi}}', \
             'mesh.refine={refine}']\nmeasurement = 'measured.csv'\nmeasured = '{wing}-{{f}}-{{phi}}'\n\
             [[ruler]]\nkind = 'offset'\nchannel = 'twist'\nsigma = 0.3\nruns = ['{wing}']\n",
            design.display()
        )?;
    }
    text += "[[uncertain]]\nkey = 'material.carbon-rod.g_gpa'\nsigma = 0.4\n\
             [[uncertain]]\nkey = 'air.density_kg_m3'\nsigma = 0.02\n";
    let path = folder.join("study.toml");
    fs::write(&path, text)?;
    Ok(path)
}

/// The measurement, row by row as the study has them.
fn measure(folder: &Path, value: impl Fn(usize) -> f64) -> Result<(), Box<dyn Error>> {
    let mut text =
        "case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n".to_string();
    let mut row = 0;
    for wing in WINGS {
        for (f, phi) in CONDITIONS {
            for r_mm in STATIONS_MM {
                let value = value(row);
                writeln!(
                    text,
                    "{wing}-{f}-{phi},twist,chord_rotation,deg,washout,{wing},{r_mm},,{value:.4},{SIGMA_DEG},assumed,none"
                )?;
                row += 1;
            }
        }
    }
    fs::write(folder.join("measured.csv"), text)?;
    Ok(())
}

/// About normal, of unit variance, the same in every run.
fn noise(row: usize) -> f64 {
    let part = |k: usize| (((row * 12 + k) as f64 * 12.9898).sin() * 43758.5453).rem_euclid(1.0);
    (0..12).map(part).sum::<f64>() - 6.0
}

/// Wall and processor time since the last line.
struct Clock {
    wall: Instant,
    ticks: f64,
}

impl Clock {
    fn new() -> Clock {
        Clock {
            wall: Instant::now(),
            ticks: ticks(),
        }
    }

    fn say(&mut self, what: &str) {
        let (wall, cpu) = (self.wall.elapsed().as_secs_f64(), 0.01 * (ticks() - self.ticks));
        println!("{what}: {wall:.2} s, processors {cpu:.2} s");
        *self = Clock::new();
    }
}

/// Processor time of this process in hundredths of a second; 0 where the system does not tell.
fn ticks() -> f64 {
    let text = fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let after_name = text.rsplit(") ").next().unwrap_or_default();
    let fields = after_name.split(' ').skip(11).take(2);
    fields.filter_map(|field| field.parse::<f64>().ok()).sum()
}

fn status(key: &str) -> String {
    let text = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text.lines().find_map(|line| line.strip_prefix(key));
    line.map_or_else(String::new, |rest| rest.trim().to_string())
}
