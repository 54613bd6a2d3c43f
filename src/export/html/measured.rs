//! Measured twist along the span, as the viewer draws it: a ghost of the wing.

use std::collections::BTreeSet;

use crate::compare::integrated::IntegratedRates;
use crate::compare::{ProfileOrigin, SpanComparison};
use crate::input::measurement::{Bound, Channel, Row};
use crate::page::text::number;

/// Twist of one run of a measurement.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// What the viewer calls it.
    pub name: String,
    /// Places (mm from the base, rising) and twists there (deg).
    pub stations: Vec<[f64; 2]>,
}

impl Measured {
    /// From every run of a comparison that gives degrees.
    pub fn of_spans(spans: &[SpanComparison]) -> Vec<Measured> {
        let measured = spans.iter().map(|span| {
            let read = span.stations.iter();
            let read = read.map(|own| (own.r_mm, own.measured_deg, own.bound));
            Measured::new(&span.run, span.origin, read.collect())
        });
        measured.collect()
    }

    /// From the measured rows of a case: twists, or rates integrated from the base.
    pub fn of_rows(rows: &[Row]) -> Vec<Measured> {
        let rows = || rows.iter().filter(|row| !row.is_planned);
        let runs: BTreeSet<&str> = rows().map(|row| row.run.as_str()).collect();
        let of_run = |run: &str| {
            let rows: Vec<&Row> = rows().filter(|row| row.run == run).collect();
            let twists = rows.iter().filter(|row| row.channel == Channel::Twist);
            let twists: Vec<_> = twists
                .filter_map(|row| Some((row.r_mm?, row.value, row.bound)))
                .collect();
            if !twists.is_empty() {
                return Some(Measured::new(run, ProfileOrigin::Twists, twists));
            }
            let profile = IntegratedRates::new(&rows)?;
            let ends = rows.iter().filter(|row| row.channel == Channel::TwistRate);
            let ends = ends.filter_map(|row| {
                let r_mm = row.r_to_mm?;
                let twist = profile.twist_at(r_mm)?;
                Some((r_mm, twist.twist_deg, twist.bound))
            });
            Some(Measured::new(run, ProfileOrigin::IntegratedRates, ends.collect()))
        };
        runs.into_iter().filter_map(of_run).collect()
    }

    fn new(run: &str, origin: ProfileOrigin, mut read: Vec<(f64, f64, Bound)>) -> Measured {
        read.sort_by(|a, b| a.0.total_cmp(&b.0));
        let is_bound = read.iter().any(|(_, _, bound)| *bound != Bound::None);
        let what = if is_bound { "measured bound" } else { "measured" };
        // rates are integrated from the base, where there is no twist
        let base = (origin == ProfileOrigin::IntegratedRates).then_some([0.0; 2]);
        Measured {
            name: match run {
                "" => what.to_string(),
                run => format!("{what}, run {run}"),
            },
            stations: base
                .into_iter()
                .chain(read.iter().map(|(r_mm, twist_deg, _)| [*r_mm, *twist_deg]))
                .collect(),
        }
    }

    /// As the viewer reads it.
    pub(super) fn json(&self) -> String {
        let stations = self.stations.iter();
        let stations: Vec<String> = stations
            .map(|[r_mm, twist_deg]| format!("[{},{}]", number(*r_mm, 3), number(*twist_deg, 3)))
            .collect();
        format!(
            "{{\"name\":{},\"stations\":[{}]}}",
            serde_json::Value::from(self.name.as_str()),
            stations.join(",")
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::measurement::Measurement;

    #[test]
    fn twists_stand_at_their_stations_by_run_and_rates_are_integrated() {
        let head = "case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n";
        let rows = "a,twist,camera,deg,washout,2,60,,9,1,stated,none\n\
                    a,twist,camera,deg,washout,2,30,,4,1,stated,none\n\
                    a,twist_rate,camera,deg/mm,washout,,20,40,0.2,0.1,stated,upper\n\
                    a,twist_rate,camera,deg/mm,washout,,0,20,0.1,0.1,stated,none\n";
        let measurement = Measurement::from_csv(&format!("{head}{rows}"), "m.csv").expect("rows");
        let found = Measured::of_rows(&measurement.rows);
        let [rates, twists] = &found[..] else {
            panic!("{found:?}")
        };
        assert_eq!(rates.name, "measured bound");
        assert_eq!(rates.stations, [[0.0, 0.0], [20.0, 2.0], [40.0, 6.0]]);
        assert_eq!(twists.name, "measured, run 2");
        assert_eq!(twists.stations, [[30.0, 4.0], [60.0, 9.0]]);
    }
}
