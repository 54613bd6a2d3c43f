//! Tables of readings: every usual form is understood alike, and what is wrong is told with its place and its cure.

use std::path::Path;

use washout::input::measurement::{Channel, SigmaKind};
use washout::input::sheet::study::Names;
use washout::input::sheet::{DesignReadings, Sheet, Sigmas};
use washout::input::study::LoadedStudy;
use washout::input::{Design, InputError};

const WING: &str = include_str!("wing.toml");

fn wing() -> Design {
    Design::from_toml(WING, "wing.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn read(text: &str) -> Result<Sheet, InputError> {
    Sheet::from_text(text, "sheet.csv", wing(), &Sigmas::default())
}

fn understood(text: &str) -> Sheet {
    read(text).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

/// Case, station and value of every reading.
fn readings(sheet: &Sheet) -> Vec<(String, f64, f64)> {
    let rows = sheet.measurement.rows.iter();
    let mut found: Vec<_> = rows
        .map(|row| (row.case.clone(), row.r_mm.unwrap_or(f64::NAN), row.value))
        .collect();
    found.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    found
}

#[test]
fn all_usual_forms_of_a_table_say_the_same() {
    let wanted = readings(&understood("r (mm),16 Hz,22 Hz\n20,4.5,6.25\n40,5.5,8\n"));
    assert_eq!(wanted.len(), 4);
    assert_eq!(wanted[3], ("22hz".to_string(), 40.0, 8.0));
    let same = [
        // semicolons and decimal commas, tabs, quotes
        "r (mm);16 Hz;22 Hz\n20;4,5;6,25\n40;5,5;8\n",
        "r_mm\t16 Hz\t22 Hz\n20\t4.5\t6.25\n40\t5.5\t8\n",
        "r,\"16 Hz\",\"22 Hz\"\n20,\"4,5\",\"6,25\"\n40,\"5,5\",8\n",
        // other words, units that must be converted, blank lines and columns, a title
        "Twist of my wing,,\n\nstation [cm],twist at 16 Hz (deg),f = 22 Hz\n2,4.5,6.25\n\n4,5.5,8\n,,\n",
        "Span / m;16Hz [°];1320 rpm;\n0,02;4,5;6,25;\n0,04;5,5;8;\n",
        "r (mm),16 Hz nose up,22 Hz\n20,-4.5,6.25\n40,−5.5,8\n",
        // long
        "condition,r,value\n16 Hz,20,4.5\n16 Hz,40,5.5\n22 Hz,20,6.25\n22 Hz,40,8\n",
        "frequency (Hz),r (mm),twist (deg)\n16,20,4.5\n16,40,5.5\n22,20,6.25\n22,40,8\n",
        "frequency_hz,r_mm,twist_deg\n16,20,4.5\n16,40,5.5\n22,20,6.25\n22,40,8\n",
        "flapping.frequency_hz,r_mm,twist\n16,20,4.5\n16,40,5.5\n22,20,6.25\n22,40,8\n",
        // a column for each station
        "frequency (Hz),20 mm,40 mm\n16,4.5,5.5\n22,6.25,8\n",
    ];
    for text in same {
        assert_eq!(readings(&understood(text)), wanted, "{text}");
    }
}

#[test]
fn a_workbook_is_read_as_a_text_is() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/input");
    let read = |file: &str| Sheet::load(&folder.join(file), &folder.join("wing.toml"), &Sigmas::default());
    let sheet = read("sheet.xlsx").unwrap_or_else(|error| panic!("{error}"));
    let wanted = readings(&understood("r (mm),16 Hz,22 Hz\n20,4.5,6.25\n40,5.5,8\n"));
    assert_eq!(readings(&sheet), wanted);
    assert_eq!(sheet.understood[0][1], "workbook, sheet \"twist\"");
    let error = read("wing.toml").expect_err("a design").to_string();
    assert!(error.contains("is no table of readings"), "{error}");
}

#[test]
fn conditions_of_the_head_become_settings_of_the_study() {
    let sheet = understood("r (mm);22 Hz, 35 deg;22 Hz, 30 deg;18 Hz\n20;4;5;6\n");
    let families: Vec<_> = sheet
        .families
        .iter()
        .map(|own| (own.form.as_str(), own.cases.len()))
        .collect();
    assert_eq!(
        families,
        [("{frequency}hz-{half_amplitude}deg", 2), ("{frequency}hz", 1)]
    );
    assert_eq!(
        sheet.families[0].set,
        [
            "flapping.frequency_hz={frequency}",
            "flapping.half_amplitude_deg={half_amplitude}"
        ]
    );
    assert_eq!(sheet.families[0].cases[0], "22hz-35deg");
    let alone = understood("r,twist\n20,4\n");
    assert_eq!(
        (alone.families[0].form.clone(), alone.families[0].set.len()),
        (wing().name, 0)
    );
}

#[test]
fn a_load_on_the_still_wing_is_a_condition_in_a_head_or_in_a_column() {
    let wide = understood(
        "r (mm);22 Hz;torque 20 uN m at 62 mm;torque 20 uN m at 62 mm sigma\n15;10,5;3,1;0,2\n28;12;;\n",
    );
    let long = understood(
        "condition,r,value,sigma\n22 Hz,15,10.5,\n22 Hz,28,12,\nTorque of 20 µN·m at 62 mm,15,3.1,0.2\n",
    );
    assert_eq!(readings(&wide), readings(&long));
    for sheet in [&wide, &long] {
        let family = &sheet.families[usize::from(sheet.families[0].form.starts_with('{'))];
        assert_eq!(family.form, "torque-20-un-m-at-62-mm");
        assert_eq!(
            family.set,
            [
                "flapping.frequency_hz=0.1",
                "load=[{at_mm=62.0, moment_n_m=[2e-5, 0.0, 0.0]}]"
            ]
        );
        let row = sheet.measurement.rows.iter().find(|row| row.case == family.form);
        let row = row.map(|row| (row.value, row.sigma, row.run.as_str()));
        assert_eq!(row, Some((3.1, 0.2, "bench")), "with a zero of its own");
        assert!(sheet.measurement.rows.iter().any(|row| row.run.is_empty()));
        assert!(sheet.doubts.is_empty(), "{:?}", sheet.doubts);
    }
    let pushed = understood("r,deflection at push 2 g at 24 mm 12 mm behind (mm)\n20,0.4\n");
    assert_eq!(pushed.measurement.rows[0].channel, Channel::Deflection);
    assert_eq!(
        pushed.families[0].set[1],
        "load=[{at_mm=24.0, chord_offset_mm=12.0, force_n=[0.0, 0.0, 0.0196133]}]"
    );
    // the torque turns the wing where it acts, as no flight does
    let steep = understood(
        "r (mm),16 Hz,18 Hz,22 Hz,torque 20 uN m at 62 mm\n15,7.2,8.3,10.5,0.7\n28,9.5,11,14.4,1.1\n40,9.7,11.5,14.6,1.1\n\
         51,16.3,17.9,21.7,3.9\n62,16.3,18.3,21.4,8.5\n",
    );
    assert!(steep.doubts.is_empty(), "{:?}", steep.doubts);
    let weighed = understood("r,weight of 2 g at 24 mm and 12 mm behind\n20,4\n");
    assert_eq!(weighed.families[0].set, pushed.families[0].set);
    let with_comma = understood("r;torque 0,02 mN m at 62 mm;22,5 Hz\n20;4,5;5,5\n");
    assert_eq!(with_comma.families[0].cases, ["torque-20-un-m-at-62-mm"]);
    assert_eq!(with_comma.families[1].cases, ["22.5hz"]);
    // a letter of several bytes where a comma might stand
    assert!(read("r,torque 44\u{fffd}5 mN m at 20 mm\n20,4\n").is_err());
    for (text, message, cure) in [
        (
            "r,torque 20 uN m at 620 mm\n20,4\n",
            "column \"torque 20 uN m at 620 mm\": load[0].at_mm",
            "between 0 and",
        ),
        (
            "r,0 Hz\n20,4\n",
            "must lie in",
            "Of the still wing write what loads it",
        ),
        (
            "r,still wing 20\n20,4\n",
            "is not understood",
            "torque 20 uN m at 62 mm",
        ),
        (
            "r,load 5 g at 20 mm\n20,4\n",
            "is not understood",
            "Is it a load on the still wing?",
        ),
        (
            "r,torque 20 mN at 62 mm\n20,4\n",
            "without its number and unit",
            "torque 20 uN m at 62 mm",
        ),
        (
            "frequency (Hz),condition,r,value\n22,push 2 mN at 20 mm 9 mm behind,20,4\n",
            "is of the still wing, but sets flapping.frequency_hz to 22",
            "leave that cell empty",
        ),
        (
            "condition,r,push 2 mN at 20 mm 9 mm behind\ntorque 2 uN m at 20 mm,20,4\n",
            "names another load than the head",
            "once",
        ),
    ] {
        let error = read(text).expect_err(text).to_string();
        assert!(error.contains(message) && error.contains(cure), "{error}");
    }
}

#[test]
fn what_the_table_leaves_out_is_assumed_and_told() {
    let told = |text: &str| {
        understood(text)
            .assumed
            .iter()
            .map(|pair| pair.join(": "))
            .collect::<Vec<_>>()
    };
    let bare = told("r,22 Hz\n20,4\n");
    for words in [
        "unit: deg",
        "sign: washout",
        "instrument: chord_rotation",
        "sigma of twist: 0.5 deg",
        "run: one",
        "unit of stations: mm",
    ] {
        assert!(bare.iter().any(|own| own.starts_with(words)), "{words}: {bare:?}");
    }
    let full =
        "r (mm),case,twist (deg),sigma,sign,instrument,run\n20,\"22 Hz, 30 deg\",4,0.25,nose up,camera,a\n";
    let of_design = [
        "zero of twist: known to 0.25 deg, as a reading is",
        "root.chord: \"free\", of the design",
        "rod[0].section.flat: \"in-plane\", of the design",
    ];
    assert_eq!(told(full), of_design);
    let row = understood(full).measurement.rows.remove(0);
    assert_eq!(
        (row.value, row.sigma, row.sigma_kind),
        (-4.0, 0.25, SigmaKind::Stated)
    );
    let own = understood("r (mm),18 Hz,18 Hz sigma,22 Hz,sigma (deg)\n20,4,0.1,5,0.3\n");
    let sigmas: Vec<f64> = own.measurement.rows.iter().map(|row| row.sigma).collect();
    assert_eq!(sigmas, [0.1, 0.3]);
    let bent = understood("r (mm),deflection at 22 Hz (cm)\n20,0.4\n")
        .measurement
        .rows
        .remove(0);
    assert_eq!(
        (bent.channel, bent.value, bent.sigma),
        (Channel::Deflection, 4.0, 0.5)
    );
}

#[test]
fn natural_mistakes_are_refused_with_place_and_cure() {
    let cases = [
        (
            "r,22 Hx\n20,4\n",
            "sheet.csv:1: column \"22 Hx\"",
            "Did you mean 22 Hz?",
        ),
        (
            "r,22\n20,4\n",
            "column \"22\"",
            "Give the number its unit, e.g. 22 Hz",
        ),
        (
            "r,5 m/s\n20,4\n",
            "names 5 m/s, which the design has not",
            "flaps",
        ),
        (
            "Station (mmm),22 Hz\n20,4\n",
            "column \"Station (mmm)\"",
            "mmm is no unit that is known",
        ),
        (
            "statoin,22 Hz\n20,4\n",
            "column \"statoin\"",
            "Did you mean station?",
        ),
        ("r,twst_deg\n20,4\n", "column \"twst_deg\"", "Did you mean twist?"),
        ("r (deg),22 Hz\n20,4\n", "unit that is no length", "r (mm)"),
        ("22 Hz,18 Hz\n4,5\n", "twist has no station", "r (mm)"),
        ("r,sigma\n20,4\n", "holds no readings", "22 Hz"),
        (
            "r,22 Hz\n20,4.x\n",
            "sheet.csv:2: column \"22 Hz\" = 4.x: is no number",
            "12.4",
        ),
        (
            "r;22 Hz\n20;4,5\n30;4.5\n",
            "sheet.csv:2",
            "With a decimal point: 1, first on line 3",
        ),
        (
            "r;18 Hz;22 Hz\n20;4,5;5,5\n30;4,5;5.5\n",
            "sheet.csv:3: column \"22 Hz\" = 5.5: has a decimal point",
            "With a decimal comma: 3, first on line 2",
        ),
        (
            "r,-18 Hz,22 Hz\n20,4,5\n",
            "sheet.csv:1: column \"-18 Hz\": flapping.frequency_hz = -18: must lie in 0.1",
            "hertz",
        ),
        (
            "r (cm),22 Hz\n20,4\n30,5\n",
            "the innermost is 200 mm",
            "Is another unit meant?",
        ),
        ("r;22 Hz\n20;1.234,5\n", "is no number", "12.4"),
        (
            "r,22 Hz\n20,4,5\n",
            "the row has 3 values, the header 2",
            "semicolons",
        ),
        ("r,22 Hz\n20,4\n20,5\n", "sheet.csv:3", "column run"),
        ("r,22 Hz,22Hz\n20,4,5\n", "stands twice", "column run"),
        ("r,22 Hz\n500,4\n", "sheet.csv:2: r = 500", "mm long"),
        ("r,22 Hz\n20,400\n", "out of range", "180"),
        (
            "r,22 Hz,sigma\n20,4,0\n",
            "must be positive",
            "one standard deviation",
        ),
        ("r,lift at 22 Hz (N)\n20,4\n", "lift is in mN", "unit"),
        (
            "r,twist,sign\n20,4,nose-upp\n",
            "= nose-upp",
            "Did you mean nose_up?",
        ),
        (
            "r,case,twist\n20,flap18,4\n",
            "sheet.csv:2: column \"case\" = flap18",
            "Did you mean 18 Hz?",
        ),
        (
            "r,case,twist\n20,slow,4\n20,fast,5\n",
            "differs from slow in its name alone",
            "frequency",
        ),
        ("r,frequency,22 Hz\n20,18,4\n", "to 22 and to 18", "once"),
        ("r,22 Hz\n", "has a header but no rows", "each station"),
        ("r,22 Hz\n20,\n", "has no reading", "Fill in"),
        (
            "r,22 Hz\n0.02,4\n0.06,5\n",
            "no station beyond 0.06 mm",
            "Are they in metres?",
        ),
    ];
    for (text, place, cure) in cases {
        let error = read(text).expect_err(text).to_string();
        assert!(error.contains(place) && error.contains(cure), "{text}\n{error}");
    }
}

#[test]
fn a_standard_deviation_in_a_unit_that_no_reading_has_is_refused() {
    let sigma = "0.25 mm".parse().expect("a standard deviation");
    let read = Sheet::from_text("r,22 Hz\n20,4\n", "sheet.csv", wing(), &sigma);
    let error = read.expect_err("no reading in mm").to_string();
    assert!(
        error.contains("--sigma: 0.25 mm is of no reading of sheet.csv, whose unit is deg"),
        "{error}"
    );
}

#[test]
fn what_looks_wrong_is_proposed_and_not_changed() {
    let doubted = |text: &str| understood(text).doubts.join("\n");
    let cases = [
        ("r,22 Hz\n20,-4\n40,-6\n50,-7\n", "nose up"),
        ("r,22 Hz\n20,0.08\n40,0.1\n", "in radians"),
        ("r,22 Hz\n0.02,4\n40,6\n", "in metres"),
        ("r,\"22 Hz, 70 deg\"\n20,4\n40,6\n", "Then write 35 deg"),
    ];
    for (text, words) in cases {
        assert!(doubted(text).contains(words), "{text}\n{}", doubted(text));
    }
    assert_eq!(doubted("r,22 Hz\n20,4\n40,6\n50,-0.1\n"), "");
    assert_eq!(doubted("r,twist at 22 Hz (rad)\n20,0.08\n40,0.1\n"), "");
}

#[test]
fn a_condition_that_lacks_what_others_name_is_told() {
    let doubted = |text: &str| understood(text).doubts.join("\n");
    for text in [
        "r,\"16 Hz, 30 deg\",45 deg\n20,4.5,6.25\n40,5.5,8\n",
        "frequency_hz,half_amplitude_deg,r_mm,twist_deg\n16,30,20,4.5\n16,30,40,5.5\n,45,20,6.25\n",
    ] {
        let told = doubted(text);
        assert!(
            told.contains("The condition 45deg says nothing of flapping.frequency_hz"),
            "{told}"
        );
    }
    // where none names it, the design does, and that is told too
    let sheet = understood("r,16 Hz,22 Hz\n20,4.5,6.25\n40,5.5,8\n");
    let assumed: Vec<String> = sheet.assumed.iter().map(|pair| pair.join(": ")).collect();
    let own = "flapping.half_amplitude_deg: ";
    assert!(
        assumed
            .iter()
            .any(|words| words.starts_with(own) && words.ends_with("of the design")),
        "{assumed:?}"
    );
    assert_eq!(sheet.doubts, [""; 0]);
}

#[test]
fn a_twist_that_the_other_conditions_do_not_lead_to_is_told_though_its_neighbours_are_rough() {
    let profile = [9.2, 12.4, 15.3, 15.0, 18.3, 22.4, 19.5, 21.4];
    // not quite in proportion, and read to 0.1 deg
    let twist = |condition: usize, station: usize| {
        let share = 1.0 + 0.13 * condition as f64 - 0.004 * (condition * station) as f64;
        (10.0 * share * profile[station]).round() / 10.0
    };
    for conditions in [3, 4] {
        let told = |slip: Option<(usize, usize, f64)>| {
            let heads: Vec<String> = (0..conditions).map(|k| format!("{} Hz", 14 + 2 * k)).collect();
            let rows = (0..profile.len()).map(|station| {
                let cells = (0..conditions).map(|condition| match slip {
                    Some((c, s, value)) if (c, s) == (condition, station) => value.to_string(),
                    _ => twist(condition, station).to_string(),
                });
                format!("{},{}\n", 20 + 5 * station, cells.collect::<Vec<_>>().join(","))
            });
            let text = format!("r,{}\n{}", heads.join(","), rows.collect::<String>());
            understood(&text).doubts
        };
        assert_eq!(told(None), [""; 0]);
        for (condition, station) in (0..conditions).flat_map(|c| (0..profile.len()).map(move |s| (c, s))) {
            let said = told(Some((condition, station, twist(condition, station) + 8.0)));
            let place = format!("Line {}, {}hz: ", station + 2, 14 + 2 * condition);
            assert!(said.len() == 1 && said[0].starts_with(&place), "{place}{said:?}");
        }
    }
}

#[test]
fn a_twist_that_stands_alone_among_its_neighbours_is_told() {
    let twists = [10.5, 8.7, 8.9, 10.2, 10.9, 16.5, 17.0, 19.2];
    let table = |twists: &[f64]| {
        let rows = twists.iter().enumerate();
        let rows: String = rows
            .map(|(k, twist)| format!("{},{twist}\n", 5 + 8 * k))
            .collect();
        understood(&format!("r,22 Hz\n{rows}")).doubts.join("\n")
    };
    assert_eq!(table(&twists), "", "a rod that gives way at its break is no slip");
    let mut point = twists;
    point[2] = 89.0;
    let told = table(&point);
    assert!(
        told.contains("Line 4, 22hz: 89 deg at 21 mm beside 8.7 and 10.2 deg"),
        "{told}"
    );
    let mut swapped = twists;
    swapped[7] = 91.2;
    assert!(
        table(&swapped).contains("91.2 deg at 61 mm"),
        "{}",
        table(&swapped)
    );
}

#[test]
fn the_study_of_a_table_loads_with_its_readings_and_leaves_no_row_out() {
    let folder = tempfile::tempdir().expect("a folder");
    let design = folder.path().join("wing.toml");
    std::fs::write(&design, WING).expect("written");
    let table = folder.path().join("sheet.csv");
    std::fs::write(&table, "r (mm);18 Hz;22 Hz\n20;4;5\n40;6;7\n").expect("written");
    let sheet = Sheet::load(&table, &design, &0.25.into()).unwrap_or_else(|error| panic!("{error}"));
    let names = Names {
        study: "mine",
        design: "wing.toml",
        readings: &sheet.measurement.file,
    };
    let path = folder.path().join("mine.toml");
    let study = LoadedStudy::with_readings(
        Path::new(&path),
        &sheet.study(names, &[], &sheet.loaded.design.assumptions()),
        &[],
        &sheet.measurement,
    );
    let study = study.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(study.study.candidates, None, "no effect is left out in silence");
    assert!(study.unused.is_empty());
    let zeros: Vec<_> = study
        .study
        .ruler
        .iter()
        .map(|zero| (zero.channel, zero.sigma))
        .collect();
    assert_eq!(
        zeros,
        [(Channel::Twist, 0.25)],
        "the zero is as uncertain as a reading"
    );
    let found: Vec<_> = study
        .cases
        .iter()
        .map(|case| (case.name.as_str(), case.rows.len(), case.sets[0].as_str()))
        .collect();
    assert_eq!(
        found,
        [
            ("18hz", 2, "flapping.frequency_hz=18.0"),
            ("22hz", 2, "flapping.frequency_hz=22.0")
        ]
    );
    assert!(
        study
            .cases
            .iter()
            .flat_map(|case| &case.rows)
            .all(|row| row.sigma == 0.25)
    );
    for asks in [
        LoadedStudy::load(&table, &[]).err(),
        Design::load(&table, &[]).err(),
    ] {
        let error = asks.expect("a table is neither").to_string();
        assert!(
            error.contains("is a table") && error.contains("--with"),
            "{error}"
        );
    }
}

#[test]
fn one_sigma_for_readings_of_several_units_is_doubted() {
    let doubts = |sigma: &str| {
        let sigma: Sigmas = sigma.parse().expect("a sigma");
        let text = "r (mm),twist at 22 Hz (deg),deflection at 22 Hz (mm)\n20,4,0.4\n40,5,0.6\n";
        let sheet = Sheet::from_text(text, "sheet.csv", wing(), &sigma).expect("a table");
        sheet.doubts.join(" ")
    };
    assert!(doubts("0.3").contains("0.3 deg and 0.3 mm"), "{}", doubts("0.3"));
    assert!(!doubts("0.3 deg, 0.05 mm").contains("the same sigma"));
}

#[test]
fn a_condition_that_is_held_out_is_named_as_the_table_has_it_or_as_its_case() {
    let folder = tempfile::tempdir().expect("a folder");
    let design = folder.path().join("wing.toml");
    std::fs::write(&design, WING).expect("written");
    let table = folder.path().join("sheet.csv");
    std::fs::write(&table, "r (mm);18 Hz, 30 deg;22 Hz, 30 deg\n20;4;5\n40;6;7\n").expect("written");
    let read =
        || DesignReadings::load(&table, &design, &0.25.into()).unwrap_or_else(|error| panic!("{error}"));
    for named in ["22hz-30deg", "22 Hz, 30 deg", "22Hz 30deg", " 22 hz,30 DEG"] {
        let held = read().holding_out(&[named.to_string()]);
        let held = held.unwrap_or_else(|error| panic!("{error}"));
        let study = held.study(&[]).unwrap_or_else(|error| panic!("{error}"));
        let cases: Vec<_> = study
            .cases
            .iter()
            .map(|case| (case.name.as_str(), case.is_held_out))
            .collect();
        assert_eq!(cases, [("18hz-30deg", false), ("22hz-30deg", true)], "{named}");
    }
    std::fs::write(&table, "r (mm);-5 deg, 8 m/s;5 deg, 8 m/s\n20;4;5\n40;6;7\n").expect("written");
    let gliding = folder.path().join("glider.toml");
    let begin = WING.find("[flapping]").expect("it flaps");
    let end = begin
        + WING[begin..]
            .find("\n[")
            .map_or(WING.len() - begin, |end| end + 1);
    let stream = "[steady]\nspeed_m_s = 8.0\nroot_angle_deg = 5.0\n";
    std::fs::write(&gliding, format!("{}{stream}{}", &WING[..begin], &WING[end..])).expect("written");
    for (named, case) in [
        ("-5 deg, 8 m/s", "-5deg-8m_s"),
        ("5deg 8 m/s", "5deg-8m_s"),
        ("-5deg-8m_s", "-5deg-8m_s"),
    ] {
        let read =
            DesignReadings::load(&table, &gliding, &0.25.into()).unwrap_or_else(|error| panic!("{error}"));
        let held = read.holding_out(&[named.to_string()]);
        assert_eq!(
            held.unwrap_or_else(|error| panic!("{error}")).held_out,
            [case],
            "{named}"
        );
    }
    std::fs::write(&table, "r (mm);18 Hz, 30 deg;22 Hz, 30 deg\n20;4;5\n40;6;7\n").expect("written");
    let refused = |conditions: &[&str]| {
        let conditions: Vec<String> = conditions.iter().map(ToString::to_string).collect();
        read().holding_out(&conditions).expect_err("refused").to_string()
    };
    let error = refused(&["2 Hz, 30 deg"]);
    assert!(
        error.contains("is no condition") && error.contains("One of 18hz-30deg, 22hz-30deg"),
        "{error}"
    );
    let error = refused(&["18hz-30deg", "22hz-30deg"]);
    assert!(
        error.contains("holds out all there are") && error.contains("Leave at least one"),
        "{error}"
    );
}

#[test]
fn what_is_set_of_what_the_design_assumes_is_known() {
    let folder = tempfile::tempdir().expect("a folder");
    let [design, table] = ["wing.toml", "sheet.csv"].map(|name| folder.path().join(name));
    std::fs::write(&design, WING).expect("written");
    std::fs::write(&table, "r (mm);18 Hz;22 Hz\n20;4;5\n40;6;7\n").expect("written");
    let read = DesignReadings::load(&table, &design, &0.25.into()).unwrap_or_else(|error| panic!("{error}"));
    let uncertain = |sets: &[&str]| {
        let sets: Vec<String> = sets.iter().map(|set| (*set).to_string()).collect();
        let study = read.study(&sets).unwrap_or_else(|error| panic!("{error}"));
        let keys = study.study.uncertain.iter().map(|own| own.key.clone());
        keys.filter(|key| key == "flapping.half_amplitude_deg").count()
    };
    assert_eq!(uncertain(&[]), 1);
    assert_eq!(uncertain(&["flapping.half_amplitude_deg=31"]), 0);
}

#[test]
fn a_range_of_the_frequency_that_the_bench_leaves_out_is_told() {
    let begin = WING.find("frequency_hz = ").expect("it flaps");
    let end = begin + WING[begin..].find('\n').expect("a line");
    let range = "frequency_hz = { assumed = 23.0, range = [20.0, 26.0], why = \"by ear\" }";
    let text = format!("{}{range}{}", &WING[..begin], &WING[end..]);
    let told = |table: &str| {
        let design = Design::from_toml(&text, "wing.toml").unwrap_or_else(|error| panic!("{error}"));
        let sheet = Sheet::from_text(table, "sheet.csv", design, &Sigmas::default());
        let sheet = sheet.unwrap_or_else(|error| panic!("{error}"));
        let own = sheet
            .assumed
            .into_iter()
            .find(|[key, _]| key == "flapping.frequency_hz");
        own.map(|[_, words]| words)
    };
    let with_bench = told("r,twist,torque 20 uN m at 62 mm\n20,4,1\n").expect("told");
    assert!(with_bench.contains("without its range"), "{with_bench}");
    let in_air = told("r,\"30 deg\"\n20,4\n").expect("told");
    assert!(in_air.contains("(20 to 26)"), "{in_air}");
}
