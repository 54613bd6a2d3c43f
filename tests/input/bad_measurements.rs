//! Measurement files that must be refused, each with its whole message.

use washout::input::measurement::Measurement;

const HEAD: &str = "# source: a test bench\n\
                    case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n\
                    wing,twist,camera,deg,washout,1,20,,4.5,0.5,stated,none\n";

/// Name of the case, the row (the fourth line of the file), and the message.
type Case = (&'static str, &'static str, &'static str);

const CASES: &[Case] = &[
    (
        "sigma zero",
        "wing,twist,camera,deg,washout,1,30,,6,0,stated,none",
        "m.csv:4: sigma = 0: must be larger than 0.\n  \
         Give the standard deviation of the value in its unit; if the source states none, assume one and write sigma_kind = assumed",
    ),
    (
        "sigma beyond all numbers",
        "wing,twist,camera,deg,washout,1,30,,6,1e-200,stated,none",
        "m.csv:4: sigma = 1e-200: outside 1e-9 to 1e9.\n  \
         Give the standard deviation of the value in its unit; if the source states none, assume one and write sigma_kind = assumed",
    ),
    (
        "sigma negative",
        "wing,twist,camera,deg,washout,1,30,,6,-0.5,stated,none",
        "m.csv:4: sigma = -0.5: must be larger than 0.\n  \
         Give the standard deviation of the value in its unit; if the source states none, assume one and write sigma_kind = assumed",
    ),
    (
        "sigma absent",
        "wing,twist,camera,deg,washout,1,30,,6,,stated,none",
        "m.csv:4: sigma is missing.\n  \
         Give the standard deviation of the value in its unit; if the source states none, assume one and write sigma_kind = assumed",
    ),
    (
        "sigma not a number",
        "wing,twist,camera,deg,washout,1,30,,6,nan,stated,none",
        "m.csv:4: sigma = nan: must be a finite number.\n  \
         Give the standard deviation of the value in its unit; if the source states none, assume one and write sigma_kind = assumed",
    ),
    (
        "value not a number",
        "wing,twist,camera,deg,washout,1,30,,NaN,0.5,stated,none",
        "m.csv:4: value = NaN: must be a finite number.\n  \
         Give the value in deg, e.g. 12.5",
    ),
    (
        "value infinite",
        "wing,twist,camera,deg,washout,1,30,,inf,0.5,stated,none",
        "m.csv:4: value = inf: must be a finite number.\n  \
         Give the value in deg, e.g. 12.5",
    ),
    (
        "value a word",
        "wing,twist,camera,deg,washout,1,30,,minimal,0.5,stated,none",
        "m.csv:4: value = minimal: must be a number, not text.\n  \
         Give the value in deg, e.g. 12.5",
    ),
    (
        "value out of range",
        "wing,twist,camera,deg,washout,1,30,,450,0.5,stated,none",
        "m.csv:4: value = 450: must lie in -180 … 180 deg.\n  \
         Give the value in deg, e.g. 12.5",
    ),
    (
        "wrong unit",
        "wing,twist,camera,rad,washout,1,30,,0.1,0.01,stated,none",
        "m.csv:4: unit = rad: the channel twist is given in deg.\n  \
         Convert value and sigma to deg and write unit deg",
    ),
    (
        "rate in degrees",
        "wing,twist_rate,camera,deg,washout,1,0,30,6,0.5,stated,none",
        "m.csv:4: unit = deg: the channel twist_rate is given in deg/mm.\n  \
         Convert value and sigma to deg/mm and write unit deg/mm",
    ),
    (
        "ratio in per cent",
        "wing,lift_ratio,,%,,1,,,35.3,5,assumed,none",
        "m.csv:4: unit = %: the channel lift_ratio is a ratio, with the unit 1.\n  \
         Convert value and sigma to parts of the rigid wing (1.35 for +35 %) and write unit 1",
    ),
    (
        "unit absent",
        "wing,twist,camera,,washout,1,30,,6,0.5,stated,none",
        "m.csv:4: unit is missing.\n  \
         Convert value and sigma to deg and write unit deg",
    ),
    (
        "duplicate row",
        "wing,twist,camera,deg,washout,1,20,,5.0,0.5,stated,none",
        "m.csv:4: case = wing: repeats the row on line 3.\n  \
         Delete one of them, or tell repeats apart in the column run",
    ),
    (
        "station negative",
        "wing,twist,camera,deg,washout,1,-5,,6,0.5,stated,none",
        "m.csv:4: r_mm = -5: must lie in 0 … 100000 mm.\n  \
         Give the distance from the wing base in millimetres, e.g. 35.0",
    ),
    (
        "station absent",
        "wing,twist,camera,deg,washout,1,,,6,0.5,stated,none",
        "m.csv:4: r_mm is missing.\n  \
         Give the distance from the wing base in millimetres, e.g. 35.0",
    ),
    (
        "station of a ratio",
        "wing,lift_ratio,,1,,1,30,,1.3,0.5,stated,none",
        "m.csv:4: r_mm = 30: the channel lift_ratio belongs to the whole wing.\n  \
         Leave it empty",
    ),
    (
        "interval of a twist",
        "wing,twist,camera,deg,washout,1,30,40,6,0.5,stated,none",
        "m.csv:4: r_to_mm = 40: the channel twist belongs to one station, not to an interval.\n  \
         Leave it empty",
    ),
    (
        "interval reversed",
        "wing,twist_rate,camera,deg/mm,washout,1,40,30,0.5,0.05,stated,none",
        "m.csv:4: r_to_mm = 30: must be larger than r_mm = 40.\n  \
         Give the inner end as r_mm and the outer end as r_to_mm",
    ),
    (
        "interval without end",
        "wing,twist_rate,camera,deg/mm,washout,1,40,,0.5,0.05,stated,none",
        "m.csv:4: r_to_mm is missing.\n  \
         Give the outer end of the interval in millimetres, e.g. 48.0",
    ),
    (
        "case absent",
        ",twist,camera,deg,washout,1,30,,6,0.5,stated,none",
        "m.csv:4: case is missing.\n  \
         Name the wing and condition, e.g. twist-v2",
    ),
    (
        "channel unknown",
        "wing,twst,camera,deg,washout,1,30,,6,0.5,stated,none",
        "m.csv:4: channel = twst: must be one of twist, twist_rate, deflection, chordwise_displacement, spanwise_displacement, lift, drag, power, lift_ratio, drag_ratio, efficiency_ratio, effective_lift_ratio, frequency.\n  \
         Did you mean twist? Give what was measured, e.g. twist",
    ),
    (
        "instrument unknown",
        "wing,twist,ruler,deg,washout,1,30,,6,0.5,stated,none",
        "m.csv:4: instrument = ruler: must be one of chord_rotation, camera.\n  \
         Say how twist was read",
    ),
    (
        "instrument of a ratio",
        "wing,lift_ratio,camera,1,,1,,,1.3,0.5,stated,none",
        "m.csv:4: instrument = camera: only twist has an instrument, not lift_ratio.\n  \
         Leave it empty",
    ),
    (
        "sign unknown",
        "wing,twist,camera,deg,positive,1,30,,6,0.5,stated,none",
        "m.csv:4: sign = positive: must be one of washout, nose_up.\n  \
         Write washout where a positive value lowers the angle of attack",
    ),
    (
        "sign absent",
        "wing,twist,camera,deg,,1,30,,6,0.5,stated,none",
        "m.csv:4: sign is missing.\n  \
         Write washout where a positive value lowers the angle of attack",
    ),
    (
        "sign of a ratio",
        "wing,lift_ratio,,1,washout,1,,,1.3,0.5,stated,none",
        "m.csv:4: sign = washout: only twist has a sign, not lift_ratio.\n  \
         Leave it empty",
    ),
    (
        "kind of sigma unknown",
        "wing,twist,camera,deg,washout,1,30,,6,0.5,guessed,none",
        "m.csv:4: sigma_kind = guessed: must be one of stated, repeats, assumed.\n  \
         Say where sigma comes from",
    ),
    (
        "bound unknown",
        "wing,twist,camera,deg,washout,1,30,,6,0.5,stated,max",
        "m.csv:4: bound = max: must be one of none, upper, lower.\n  \
         Write none unless the value is only a bound",
    ),
    (
        "too few values",
        "wing,twist,camera,deg,washout,1,30,6,0.5,stated,none",
        "m.csv:4: the row has 11 values, the header 12.\n  \
         Separate values by commas, leave a value empty where there is none, quote text that has a comma",
    ),
    (
        "too many values",
        "wing,twist,camera,deg,washout,1,30,,6,0.5,stated,none,extra",
        "m.csv:4: the row has 13 values, the header 12.\n  \
         Separate values by commas, leave a value empty where there is none, quote text that has a comma",
    ),
];

fn message(text: &str) -> String {
    match Measurement::from_csv(text, "m.csv") {
        Ok(_) => "(accepted)".to_string(),
        Err(error) => error.to_string(),
    }
}

#[test]
fn the_first_row_alone_is_accepted() {
    assert_eq!(message(HEAD), "(accepted)");
}

#[test]
fn every_bad_row_is_refused_with_its_message() {
    let mut wrong = Vec::new();
    for (name, row, expected) in CASES {
        let found = message(&format!("{HEAD}{row}\n"));
        if found != *expected {
            wrong.push(format!("{name}\n  expected: {expected}\n  found:    {found}"));
        }
    }
    assert!(
        wrong.is_empty(),
        "{} of {} messages differ:\n{}",
        wrong.len(),
        CASES.len(),
        wrong.join("\n")
    );
}

#[test]
fn comments_and_blank_lines_between_rows_do_not_shift_the_line() {
    let row = "wing,twist,camera,deg,washout,1,30,,6,0,stated,none";
    let found = message(&format!("{HEAD}# a note\n\n# another\n{row}\n"));
    assert!(found.starts_with("m.csv:7: sigma = 0"), "{found}");
}

#[test]
fn a_missing_column_is_named() {
    let text = HEAD.replace("sigma_kind,", "").replace("stated,", "");
    assert_eq!(
        message(&text),
        "m.csv:2: column sigma_kind is missing.\n  \
         The columns are case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound, and if wanted chord_fraction"
    );
}

#[test]
fn a_misspelt_column_is_named() {
    assert_eq!(
        message(&HEAD.replace(",r_mm", ",r_m")),
        "m.csv:2: column \"r_m\" is not known.\n  \
         Did you mean r_mm? The columns are case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound, and if wanted chord_fraction"
    );
}

#[test]
fn a_column_twice_is_named() {
    assert_eq!(
        message(&HEAD.replace(",run,", ",case,")),
        "m.csv:2: column case stands twice.\n  \
         The columns are case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound, and if wanted chord_fraction"
    );
}

#[test]
fn a_table_without_rows_is_refused() {
    let text: String = HEAD.lines().take(2).map(|line| format!("{line}\n")).collect();
    assert_eq!(
        message(&text),
        "m.csv: has a header but no rows.\n  \
         Give rows with case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound"
    );
}

#[test]
fn text_that_is_no_table_is_refused() {
    assert_eq!(
        message("twist at 20 mm: 4.5 deg\n"),
        "m.csv:1: column \"twist at 20 mm: 4.5 deg\" is not known.\n  \
         The columns are case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound, and if wanted chord_fraction. \
         Tables of other forms: `washout diagnose DESIGN --with TABLE`, `washout init NAME --study --design DESIGN --readings TABLE`"
    );
}
