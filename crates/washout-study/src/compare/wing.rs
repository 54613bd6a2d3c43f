//! A measurement against a solved wing.

use std::collections::BTreeMap;

use crate::input::design::Instrument;
use crate::input::measurement::{Channel, Measurement, Row};
use crate::observation::{ObservationError, Observer, TwistProfile};

use super::comparison::Comparison;
use super::row::{ComparedRow, compare_row};
use super::span::SpanComparison;
use super::stages::ModelledStages;
use super::verdict;

/// Compares a measurement (the rows of one case) with a solved wing.
///
/// The model is read by the instrument of the measurement, if all its twists were read by one and the design says what
/// that needs; by the instrument of the design otherwise, and a note says so.
///
/// `whole_wing` holds what the model gives for channels of the whole wing (lift in mN, ratios to the rigid wing, …);
/// rows of channels that are not in it are listed as not compared.
///
/// # Example
/// ```
/// # use washout_study as washout;
/// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
/// # use std::{collections::BTreeMap, path::Path};
/// # use washout::{input::measurement::Measurement, progress::Progress, wing::WingModel};
/// let wing = WingModel::open("designs/twist-v1.toml", &["mesh.refine=0.5"])?.solve(&Progress::quiet())?;
/// let measured = Measurement::load_for(Path::new("measurements/colmenares-as-stated.csv"), wing.model.design())?;
/// let comparison = washout::compare::compare(&wing.observer()?, &measured, &BTreeMap::new());
/// assert!(!comparison.rows.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn compare(
    observer: &Observer,
    measurement: &Measurement,
    whole_wing: &BTreeMap<Channel, f64>,
) -> Comparison {
    let foreign = measured_instrument(measurement).filter(|measured| *measured != observer.instrument());
    let seen = foreign.map(|measured| observer.seen_by(measured));
    let observer = match &seen {
        Some(Ok(seen)) => seen,
        _ => observer,
    };
    let profile = observer.profile();
    let (mut rows, mut not_compared) = (Vec::new(), Vec::new());
    for row in &measurement.rows {
        match compare_row(row, observer, &profile, whole_wing) {
            Ok(row) => rows.push(row),
            Err(reason) => not_compared.push(reason),
        }
    }
    let mut comparison = Comparison {
        wing: observer.design().name.clone(),
        case: measurement
            .rows
            .first()
            .map_or_else(String::new, |row| row.case.clone()),
        file: measurement.file.clone(),
        instrument: profile.instrument,
        camera_axis: profile.camera_axis,
        span: spans(measurement, &rows, &profile),
        modelled_stages: ModelledStages::of(&profile),
        notes: notes(
            &rows,
            &profile,
            seen.as_ref().and_then(|seen| seen.as_ref().err()),
        ),
        rows,
        not_compared,
        verdict: String::new(),
    };
    comparison.verdict = verdict::in_words(&comparison, observer.design(), &profile);
    comparison
}

/// Each run's twists, and its rates integrated.
fn spans(measurement: &Measurement, compared: &[ComparedRow], profile: &TwistProfile) -> Vec<SpanComparison> {
    let mut runs: Vec<&str> = Vec::new();
    for row in &measurement.rows {
        if !runs.contains(&row.run.as_str()) {
            runs.push(&row.run);
        }
    }
    let mut spans = Vec::new();
    for run in runs {
        let twists: Vec<&ComparedRow> = compared.iter().filter(|row| row.run == run).collect();
        spans.extend(SpanComparison::of_twists(run, &twists));
        let rows: Vec<&Row> = measurement.rows.iter().filter(|row| row.run == run).collect();
        spans.extend(SpanComparison::of_rates(run, &rows, profile));
    }
    spans
}

/// The instrument by which every twist was measured; none if there are several, or no twist.
fn measured_instrument(measurement: &Measurement) -> Option<Instrument> {
    let mut instruments = measurement.rows.iter().filter_map(|row| row.instrument);
    let first = instruments.next()?;
    instruments.all(|other| other == first).then_some(first)
}

fn notes(rows: &[ComparedRow], profile: &TwistProfile, refused: Option<&ObservationError>) -> Vec<String> {
    let mut notes = Vec::new();
    let others = rows
        .iter()
        .filter_map(|row| row.instrument)
        .find(|other| *other != profile.instrument);
    if let Some(measured) = others {
        let (measured, modelled) = (measured.words(), profile.instrument.words());
        let why = refused.map_or_else(String::new, |error| format!(": {error}"));
        notes.push(format!(
            "twist was measured by {measured}, but the model is read by {modelled}{why}"
        ));
    }
    for row in rows.iter().filter(|row| row.read_to_mm.is_some()) {
        let [from, to, read] = [row.r_mm, row.r_to_mm, row.read_to_mm].map(|place| place.unwrap_or_default());
        notes.push(format!(
            "the interval {from}-{to} mm is read in the model up to {read:.1} mm only"
        ));
    }
    for skipped in &profile.skipped {
        let r_mm = skipped.station.r_m * 1e3;
        notes.push(format!(
            "the model was not read at {r_mm:.1} mm: {}",
            skipped.reason
        ));
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::design::Design;
    use crate::input::measurement::{Bound, SigmaKind};
    use crate::observation::Place;
    use crate::observation::imposed::{design, wing};

    const HEAD: &str = "case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n";
    const V1: &str = "v1,twist_rate,camera,deg/mm,washout,,0,48,0.29,0.041,assumed,none\n\
                      v1,twist_rate,camera,deg/mm,washout,,48,70,1.39,0.107,assumed,none\n";

    fn measurement(rows: &str) -> Measurement {
        Measurement::from_csv(&format!("{HEAD}{rows}"), "m.csv").unwrap()
    }

    fn against(design: &Design, twist_deg: impl Fn(f64) -> f64, rows: &str) -> Comparison {
        let (planform, solution) = wing(
            design,
            |r_m| twist_deg(r_m * 1e3).to_radians(),
            |r_m| [0.0, r_m * r_m],
        );
        let observer = Observer::new(design, &planform, &solution).unwrap();
        compare(&observer, &measurement(rows), &BTreeMap::new())
    }

    fn stated_v1_deg(r_mm: f64) -> f64 {
        0.29 * r_mm.min(48.0) + 1.39 * (r_mm - 48.0).max(0.0)
    }

    /// A uniform rod's shape: the rate falls to nothing at the tip, 9.6 deg there.
    fn uniform_rod_deg(r_mm: f64) -> f64 {
        9.6 * (1.0 - (1.0 - r_mm / 70.0).powi(2))
    }

    #[test]
    fn a_model_that_twists_as_measured_has_no_misfit_anywhere() {
        let mut design = design("");
        // The break and the clipped end as stations, so that straight interpolation is exact.
        design.observation.stations_mm = vec![48.0];
        let comparison = against(&design, stated_v1_deg, V1);
        assert_eq!(comparison.rows.len(), 2);
        for row in &comparison.rows {
            // The break lies between two columns of nodes, so a bay's film reads a little across it.
            assert!(row.error.abs() < 0.03, "{row:?}");
        }
        let span = &comparison.span[0];
        assert_eq!(span.stations.len(), 7);
        let spar_ends = span
            .stations
            .iter()
            .filter(|station| matches!(station.place, Some(Place::SparEnd(_))));
        assert!(
            spar_ends
                .map(|station| station.error_deg.abs())
                .fold(0.0, f64::max)
                < 1e-9,
            "{span:?}"
        );
        assert!(span.rmse_deg < 0.3, "{span:?}");
        assert!(
            comparison
                .verdict
                .contains("agrees within 2 sigma from 2.8 to 67.9 mm"),
            "{}",
            comparison.verdict
        );
        assert!(
            !comparison.verdict.contains("uniform rod cannot"),
            "{}",
            comparison.verdict
        );
    }

    #[test]
    fn a_uniform_rod_against_twist_v1_fails_outboard_and_the_words_say_why() {
        let comparison = against(&design(""), uniform_rod_deg, V1);
        let span = &comparison.span[0];
        let tip = span.outermost().unwrap();
        let measured_deg = 13.92 + 1.39 * 19.9;
        assert!((tip.measured_deg - measured_deg).abs() < 1e-9);
        assert!((tip.error_deg - (measured_deg - 9.6)).abs() < 0.02, "{tip:?}");
        let sigma_deg = (0.041f64 * 48.0).hypot(0.107 * 19.9);
        assert!((tip.sigma_deg - sigma_deg).abs() < 1e-9);
        assert!((tip.misfit_sigma - tip.error_deg / sigma_deg).abs() < 1e-9);
        assert_eq!((tip.sigma_kind, span.worst_r_mm), (SigmaKind::Assumed, tip.r_mm));
        let words = &comparison.verdict;
        for part in [
            "At 67.9 mm the measured twist is 41.6 deg and the modelled one 9.6 deg",
            "too little",
            "measured twist rate rises, from 0.29 to 1.39 deg/mm, and the modelled one falls",
            "a uniform rod cannot do this quasi-statically by its own rotation",
            "assumed sigma",
        ] {
            assert!(words.contains(part), "{part}: {words}");
        }
    }

    #[test]
    fn a_stepped_rod_or_a_bench_load_is_not_told_what_a_uniform_rod_cannot_do() {
        let mut stepped = design("");
        stepped.rod.push(stepped.rod[0].clone());
        stepped.rod[0].to_mm = 40.0.into();
        stepped.rod[1].from_mm = 40.0.into();
        let comparison = against(&stepped, uniform_rod_deg, V1);
        assert!(
            comparison.verdict.contains("uniform rod cannot"),
            "two equal pieces are one rod"
        );
        stepped.rod[1].material = Some("other".to_string());
        let comparison = against(&stepped, uniform_rod_deg, V1);
        assert!(!comparison.verdict.contains("uniform rod cannot"));
    }

    #[test]
    fn the_error_over_the_span_does_not_count_close_stations_twice() {
        // An error that grows straight from the base has the root mean square last/√3 over the span.
        let rows = "a,twist_rate,camera,deg/mm,washout,,0,70,0.5,0.05,stated,none\n";
        let comparison = against(&design(""), |r_mm| 0.2 * r_mm, rows);
        let span = &comparison.span[0];
        let expected = 0.3 * 67.9 / 3f64.sqrt();
        assert!((span.rmse_along_span_deg - expected).abs() < 0.01, "{span:?}");
        assert!(span.rmse_deg > expected);
    }

    #[test]
    fn twist_within_an_upper_bound_is_no_misfit_and_beyond_it_is() {
        let row = "rigid,twist,chord_rotation,deg,washout,,67.9,,3.0,1.0,assumed,upper\n";
        let within = against(&design(""), |r_mm| r_mm / 67.9, row);
        assert_eq!((within.rows[0].misfit, within.rows[0].bound), (0.0, Bound::Upper));
        assert!((within.rows[0].error - 2.0).abs() < 1e-3);
        assert!(within.verdict.contains("at most 3.0 deg") && within.verdict.contains("no contradiction"));
        let beyond = against(&design(""), |r_mm| 5.0 * r_mm / 67.9, row);
        assert!((beyond.rows[0].misfit + 2.0).abs() < 5e-3);
        assert!(
            beyond.verdict.contains("(2.0 assumed sigma) too much"),
            "{}",
            beyond.verdict
        );
    }

    #[test]
    fn clipping_another_instrument_and_rows_that_the_model_lacks_are_reported() {
        let rows = format!(
            "{V1}v1,lift_ratio,,1,,,,,1.353,0.05,assumed,none\n\
             v1,twist,camera,deg,washout,,69.9,,44.0,1,assumed,none\n\
             v1,deflection,,mm,,,50,,2.5,0.1,stated,none\n"
        );
        let comparison = against(&design(""), uniform_rod_deg, &rows);
        assert_eq!(
            comparison.rows[1].read_to_mm.map(|r_mm| (r_mm * 10.0).round()),
            Some(679.0)
        );
        assert!(
            comparison
                .notes
                .iter()
                .any(|note| note.contains("48-70 mm is read in the model up to 67.9 mm"))
        );
        assert!(comparison.notes[0].contains("measured by a camera, but the model is read by the rotation"));
        assert!(
            comparison.notes[0].contains("camera_axis"),
            "{}",
            comparison.notes[0]
        );
        let reasons: Vec<&str> = comparison
            .not_compared
            .iter()
            .map(|row| row.reason.as_str())
            .collect();
        assert_eq!(reasons.len(), 2);
        assert!(reasons[0].contains("that wing's solution beside this one"));
        assert!(reasons[1].contains("nothing is extrapolated"));
        let deflection = &comparison.rows[2];
        assert!((deflection.modelled - 2.5).abs() < 0.01, "{deflection:?}");
    }

    #[test]
    fn the_model_is_read_by_the_instrument_of_the_measurement_where_the_design_says_how() {
        let mut design = design("");
        design.observation.camera_axis = Some(crate::input::design::CameraAxis::FlappingAxis);
        // Feathered at 45 deg: the camera along the flapping axis saturates there, the rotation does not.
        let feathered = |r_mm: f64| 45.0 * r_mm / 67.9;
        let row = "a,twist,camera,deg,washout,,67.9,,45.0,1,assumed,none\n";
        let comparison = against(&design, feathered, row);
        assert_eq!(comparison.instrument, Instrument::Camera);
        assert_eq!(comparison.rows[0].modelled_bound, Bound::Lower);
        assert!(comparison.notes.is_empty(), "{:?}", comparison.notes);
        let row = row.replace("camera", "chord_rotation");
        let comparison = against(&design, feathered, &row);
        assert_eq!(
            (comparison.instrument, comparison.rows[0].modelled_bound),
            (Instrument::ChordRotation, Bound::None)
        );
    }

    #[test]
    fn twist_that_arises_beyond_the_last_spar_is_said_to_be_the_films() {
        let mut two_spars = design("");
        two_spars.spar.truncate(3);
        let row = "a,twist,chord_rotation,deg,washout,,67.9,,3.0,1.0,assumed,upper\n";
        let outboard = |r_mm: f64| 0.1 * r_mm + 0.5 * (r_mm - 35.0).max(0.0);
        let words = against(&two_spars, outboard, row).verdict;
        assert!(
            words.contains("3.5 deg are reached at the last spar (35.0 mm)"),
            "{words}"
        );
        assert!(words.contains("the film alone holds the chord"), "{words}");
        let inboard = |r_mm: f64| 0.5 * r_mm.min(35.0);
        let words = against(&two_spars, inboard, row).verdict;
        assert!(!words.contains("film alone"), "{words}");
        let words = against(&design(""), outboard, row).verdict;
        assert!(!words.contains("film alone"), "{words}");
    }

    #[test]
    fn ratios_that_the_model_gives_are_compared_and_named_where_they_miss() {
        let design = design("");
        let (planform, solution) = wing(&design, |_| 0.0, |_| [0.0, 0.0]);
        let observer = Observer::new(&design, &planform, &solution).unwrap();
        let rows = measurement("v1,lift_ratio,,1,,,,,1.353,0.05,assumed,none\n");
        let comparison = compare(&observer, &rows, &BTreeMap::from([(Channel::LiftRatio, 0.786)]));
        assert!((comparison.rows[0].misfit_sigma - 0.567 / 0.05).abs() < 1e-9);
        assert!(
            comparison
                .verdict
                .contains("lift ratio 1.353 measured, 0.786 modelled (11.3 assumed sigma)")
        );
        let comparison = compare(
            &observer,
            &rows,
            &BTreeMap::from([(Channel::LiftRatio, f64::NAN)]),
        );
        assert!(comparison.rows.is_empty() && comparison.verdict.starts_with("No measured row"));
    }

    #[test]
    fn repeats_stand_side_by_side_and_the_words_are_about_the_worst() {
        let rows = "a,twist,chord_rotation,deg,washout,one,35,,4.0,0.5,repeats,none\n\
                    a,twist,chord_rotation,deg,washout,two,35,,9.0,0.5,repeats,none\n";
        let comparison = against(&design(""), |r_mm| 0.1 * r_mm, rows);
        assert_eq!(comparison.span.len(), 2);
        assert!(
            comparison.verdict.contains("fits worst (run two)"),
            "{}",
            comparison.verdict
        );
        assert!(!comparison.verdict.contains("assumed"), "{}", comparison.verdict);
    }

    #[test]
    fn a_comparison_reads_back_from_json() {
        let comparison = against(&design(""), uniform_rod_deg, V1);
        let text = serde_json::to_string(&comparison).unwrap();
        assert_eq!(serde_json::from_str::<Comparison>(&text).unwrap(), comparison);
    }
}
