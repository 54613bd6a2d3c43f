//! Pictures: what is drawn against what, with which numbers, and the SVG that comes of it.

mod docs;

mod drawing;

mod panels;

use washout::compare::{StudyCase, StudyRow};
use washout::export::pictures::panels::Compared;
use washout::input::measurement::{Bound, Channel};
use washout::input::study::CaseNumber;

/// A case of a family with its numbers.
pub fn case(family: &str, name: &str, numbers: &[(&str, &str, f64)], is_held_out: bool) -> StudyCase {
    let number = |(name, unit, value): &(&str, &str, f64)| CaseNumber {
        name: name.to_string(),
        unit: unit.to_string(),
        value: *value,
    };
    StudyCase {
        name: name.to_string(),
        wing: "wing".to_string(),
        family: family.to_string(),
        numbers: numbers.iter().map(number).collect(),
        is_held_out,
    }
}

/// A number of a case at a station; measured, as stated, calibrated.
pub fn row(case: &StudyCase, channel: Channel, r_mm: Option<f64>, values: [f64; 3]) -> StudyRow {
    StudyRow {
        case: case.name.clone(),
        wing: case.wing.clone(),
        line: 2,
        channel,
        run: String::new(),
        r_mm,
        r_to_mm: None,
        chord_fraction: None,
        measured: values[0],
        sigma: 0.5,
        bound: Bound::None,
        before: values[1],
        sigma_of_inputs: 0.25,
        after: values[2],
        left_out: None,
        is_held_out: case.is_held_out,
    }
}

/// A comparison of these cases and rows, after a calibration.
pub fn compared(cases: Vec<StudyCase>, rows: Vec<StudyRow>) -> Compared {
    Compared {
        name: "bench".to_string(),
        title: String::new(),
        cases,
        rows,
        is_calibrated: true,
    }
}

/// Two angles at four speeds each, the second angle held out; twist at one station.
pub fn tunnel() -> Compared {
    let (mut cases, mut rows) = (Vec::new(), Vec::new());
    for (angle, is_held_out) in [(1.0, false), (2.5, true)] {
        // Not in order, as files are.
        for speed in [20.0, 10.0, 40.0, 30.0] {
            let numbers = [("root angle", "deg", angle), ("speed", "m/s", speed)];
            let case = case(
                "aero-{angle}-{speed}",
                &format!("aero-{angle}-{speed}"),
                &numbers,
                is_held_out,
            );
            let twist = -angle * speed * speed / 1000.0;
            rows.push(row(
                &case,
                Channel::Twist,
                Some(450.0),
                [twist, 0.8 * twist, 0.9 * twist],
            ));
            cases.push(case);
        }
    }
    compared(cases, rows)
}
