//! Readers of files that people write: designs, studies, tables, meshes, formulas, marks.

use std::fs;
use std::path::Path;

use num_dual::Dual64;
use washout::geometry::Planform;
use washout::input::measurement::Measurement;
use washout::input::sheet::Sheet;
use washout::input::stock::stock_from_csv;
use washout::input::study::LoadedStudy;
use washout::input::video::LoadedVideo;
use washout::input::{Design, Expression, InputError, TwistTable};
use washout::mesh::gmsh;
use washout::sweep::Axis;

use crate::{Verdict, folder, fuzz};

/// Files of the repository, as seeds.
fn files(names: &[&str]) -> Vec<Vec<u8>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |name: &&str| fs::read(root.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    names.iter().map(read).collect()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// An error names its file and says something.
fn judged<T>(read: Result<T, InputError>) -> Verdict {
    let Err(error) = read else { return Ok(()) };
    let said = error.to_string();
    let file = &error.place.file;
    if said.starts_with(file.as_str()) && said.len() > file.len() + 10 {
        Ok(())
    } else {
        Err(format!("it does not say what is wrong: {said:?}"))
    }
}

const DESIGNS: [&str; 4] = [
    "designs/twist-v2.toml",
    "designs/pre-pazy-skin.toml",
    "designs/tang-dowell.toml",
    "examples/effect_of_ones_own.toml",
];

#[test]
fn designs() {
    fuzz("design", &files(&DESIGNS), 6000, |bytes| {
        let read = Design::from_toml(&text(bytes), "wing.toml");
        if let Ok(design) = &read {
            let _ = Planform::from_design(design);
        }
        judged(read)
    });
}

#[test]
fn settings_of_a_design() {
    let seeds = [
        "flapping.half_amplitude_deg=30",
        "rod[1].section={shape='round',diameter_mm=0.3}",
        "film.material=kapton",
        "effects.root-flexure.strength=0.2",
        "spar=[]",
        "measured.case='a, b'",
    ];
    let seeds = seeds.map(|seed| seed.as_bytes().to_vec());
    let design = text(&files(&DESIGNS[..1])[0]);
    fuzz("setting", &seeds, 4000, |bytes| {
        match Design::load_text(&design, Path::new("designs/twist-v2.toml"), &[text(bytes)]) {
            Err(error) if error.to_string().len() < 20 => Err(error.to_string()),
            _ => Ok(()),
        }
    });
}

#[test]
fn studies() {
    let names = [
        "studies/three-rods.toml",
        "studies/pre-pazy-skin.toml",
        "studies/minguet.toml",
    ];
    fuzz("study", &files(&names), 600, |bytes| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("studies/damaged.toml");
        match LoadedStudy::from_text(&path, &text(bytes), &[]) {
            Err(error) if error.to_string().len() < 20 => Err(error.to_string()),
            _ => Ok(()),
        }
    });
}

#[test]
fn measurements() {
    let names = [
        "measurements/three-rods.csv",
        "measurements/pre-pazy.csv",
        "measurements/colmenares-as-stated.csv",
    ];
    fuzz("measurement", &files(&names), 6000, |bytes| {
        let read = Measurement::from_csv(&text(bytes), "m.csv");
        if let Ok(measurement) = &read
            && measurement
                .rows
                .iter()
                .any(|row| !row.value.is_finite() || row.sigma <= 0.0)
        {
            return Err("a reading without a value, or a standard deviation of none".to_string());
        }
        judged(read)
    });
}

#[test]
fn tables_of_readings() {
    let mut seeds = files(&["measurements/three-rods.csv"]);
    seeds.push(b"r (mm);22 Hz, 30 deg;23 Hz, 34 deg\n40;5,1;6,0\n60;11,2;13,4\n".to_vec());
    seeds.push(b"station_mm\ttwist (deg)\tsigma\n40\t5.1\t0.3\n60\t11.2\t0.4\n".to_vec());
    seeds.push(
        b"r (mm),22 Hz,torque 20 uN m at 62 mm,push 2 g at 24 mm 12 mm behind\n15,5.1,3.1,2\n".to_vec(),
    );
    let design = Path::new(env!("CARGO_MANIFEST_DIR")).join(DESIGNS[0]);
    let design = Design::load(&design, &[]).expect("a design").design;
    fuzz("table", &seeds, 6000, |bytes| {
        judged(Sheet::from_text(
            &text(bytes),
            "sheet.csv",
            design.clone(),
            &0.5.into(),
        ))
    });
}

#[test]
fn workbooks() {
    let path = folder("workbook").join("sheet.xlsx");
    let design = Path::new(env!("CARGO_MANIFEST_DIR")).join(DESIGNS[0]);
    fuzz("workbook", &files(&["tests/input/sheet.xlsx"]), 1000, |bytes| {
        fs::write(&path, bytes).expect("written");
        judged(Sheet::load(&path, &design, &0.5.into()))
    });
}

#[test]
fn coefficients_of_the_air() {
    let folder = folder("air");
    let design = text(&files(&DESIGNS[..1])[0]);
    let seeds = [
        b"# wind tunnel\nalpha_deg,cl,cd\n-90,-0.1,2.0\n-5,-0.4,0.03\n0,0,0.02\n5,0.4,0.03\n90,0.1,2.0\n"
            .to_vec(),
    ];
    let sets = ["air={law='table',table='table.csv'}".to_string()];
    fuzz("air", &seeds, 1500, |bytes| {
        fs::write(folder.join("table.csv"), bytes).expect("written");
        match Design::load_text(&design, &folder.join("wing.toml"), &sets) {
            Err(error) if error.to_string().len() < 20 => Err(error.to_string()),
            _ => Ok(()),
        }
    });
}

#[test]
fn twists_along_the_span_and_stocks_of_rods() {
    let names = [
        "designs/paper-most-efficient.csv",
        "designs/paper-highest-lift.csv",
    ];
    fuzz("profile", &files(&names), 6000, |bytes| {
        judged(TwistTable::from_csv("profile.csv", &text(bytes)))
    });
    fuzz("stock", &files(&["designs/stock.csv"]), 6000, |bytes| {
        judged(stock_from_csv("stock.csv", &text(bytes)))
    });
}

#[test]
fn formulas() {
    let seeds = [
        "2*x^2 + sin(pi*y)",
        "(1 - x)*max(y, 0.5) / sqrt(1 + y*y)",
        "tanh((x-0.5)*2000) + exp(-y^2)",
        "-x^-2^y",
    ];
    let seeds = seeds.map(|seed| seed.as_bytes().to_vec());
    // rounding can part the two at one place, a fault does at each
    let places = [[0.3, -1.5], [0.31, -1.49], [0.7, 0.2]];
    fuzz("formula", &seeds, 40_000, |bytes| {
        match Expression::parse(&text(bytes), &["x", "y"]) {
            Ok(formula) => {
                let parted = |place: &[f64; 2]| {
                    let value: f64 = formula.value(place);
                    let dual = formula.value(&place.map(|number| Dual64::from_re(number).derivative()));
                    value.is_nan() != dual.re.is_nan()
                };
                match places.iter().all(parted) {
                    true => Err("either a number or a dual number is not one, the other is".to_string()),
                    false => Ok(()),
                }
            }
            Err(error) if error.to_string().len() > 10 => Ok(()),
            Err(error) => Err(error.to_string()),
        }
    });
}

#[test]
fn ranges_of_a_sweep() {
    let seeds = [
        "flapping.frequency_hz=18:26:2",
        "rod[1].section.diameter_mm=0.3,0.5",
        "film.material=kapton,mylar",
        "a.b=1:2:0.1",
    ];
    let seeds = seeds.map(|seed| seed.as_bytes().to_vec());
    fuzz("axis", &seeds, 20_000, |bytes| match Axis::parse(&text(bytes)) {
        Err(error) if error.to_string().len() < 10 => Err(error.to_string()),
        _ => Ok(()),
    });
}

#[test]
fn meshes() {
    let names = ["tests/mesh/bay.msh", "tests/mesh/bay-22.msh"];
    fuzz("mesh", &files(&names), 2000, |bytes| {
        match gmsh::read(bytes, "wing.msh") {
            Ok(mesh) => {
                let _ = washout::mesh::check::check(&mesh);
                Ok(())
            }
            Err(error) if error.to_string().contains("wing.msh") => Ok(()),
            Err(error) => Err(error.to_string()),
        }
    });
}

#[test]
fn videos_and_marks() {
    let [video, marks] =
        ["examples/video.toml", "examples/video-marks.csv"].map(|name| files(&[name]).remove(0));
    let folder = folder("video");
    fs::write(folder.join("video-marks.csv"), &marks).expect("written");
    fuzz("video", std::slice::from_ref(&video), 1500, |bytes| {
        let path = folder.join("damaged.toml");
        fs::write(&path, bytes).expect("written");
        judged(LoadedVideo::load(&path))
    });
    fs::write(folder.join("video.toml"), &video).expect("written");
    fuzz("marks", &[marks], 1500, |bytes| {
        fs::write(folder.join("video-marks.csv"), bytes).expect("written");
        judged(LoadedVideo::load(&folder.join("video.toml")))
    });
}
