//! Measured twist rates integrated from the base to a profile in degrees.

use crate::input::measurement::{Bound, Channel, Row, SigmaKind};

/// A measured profile: rates over neighbouring intervals, from 0 deg at the base.
#[derive(Debug, Clone, PartialEq)]
pub struct IntegratedRates<'a> {
    rows: Vec<&'a Row>,
    /// Where the last interval that joins on ends, mm.
    pub reach_mm: f64,
    /// What stopped the integration short of the last row, if anything did.
    pub stopped: Option<String>,
}

/// Twist of a measured profile at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntegratedTwist {
    /// Twist, deg.
    pub twist_deg: f64,
    /// Root of Σ (σ_rate Δr)²: the errors of different intervals are taken as independent.
    pub sigma_deg: f64,
    /// The weakest kind of standard deviation that went in.
    pub sigma_kind: SigmaKind,
    /// Whether a bounded rate makes the twist a bound.
    pub bound: Bound,
}

impl<'a> IntegratedRates<'a> {
    /// From the twist rates among `rows`, all of one run. None without rates that start at the base.
    pub fn new(rows: &[&'a Row]) -> Option<IntegratedRates<'a>> {
        let mut rates: Vec<&'a Row> = rows
            .iter()
            .copied()
            .filter(|row| row.channel == Channel::TwistRate)
            .collect();
        rates.sort_by(|a, b| ends_mm(a)[0].total_cmp(&ends_mm(b)[0]));
        let mut joined = IntegratedRates {
            rows: Vec::new(),
            reach_mm: 0.0,
            stopped: None,
        };
        for row in rates {
            let [from_mm, to_mm] = ends_mm(row);
            if (from_mm - joined.reach_mm).abs() > 1e-6 {
                let what = if from_mm > joined.reach_mm {
                    "a gap before"
                } else {
                    "an overlap with"
                };
                let reach_mm = joined.reach_mm;
                joined.stopped = Some(format!(
                    "{what} the interval from {from_mm} mm ends it at {reach_mm} mm"
                ));
                break;
            }
            joined.rows.push(row);
            joined.reach_mm = to_mm;
        }
        (!joined.rows.is_empty()).then_some(joined)
    }

    /// Twist at `r_mm`; none beyond the reach, or where upper and lower bounds are mixed.
    pub fn twist_at(&self, r_mm: f64) -> Option<IntegratedTwist> {
        if !(0.0..=self.reach_mm + 1e-6).contains(&r_mm) {
            return None;
        }
        let mut sum = IntegratedTwist {
            twist_deg: 0.0,
            sigma_deg: 0.0,
            sigma_kind: SigmaKind::Stated,
            bound: Bound::None,
        };
        for row in &self.rows {
            let [from_mm, to_mm] = ends_mm(row);
            let length_mm = r_mm.min(to_mm) - from_mm;
            if length_mm <= 0.0 {
                continue;
            }
            sum.twist_deg += row.value * length_mm;
            sum.sigma_deg = sum.sigma_deg.hypot(row.sigma * length_mm);
            sum.sigma_kind = weaker(sum.sigma_kind, row.sigma_kind);
            sum.bound = match (sum.bound, row.bound) {
                (bound, Bound::None) | (Bound::None, bound) => bound,
                (before, bound) if before == bound => bound,
                _ => return None,
            };
        }
        Some(sum)
    }
}

/// The kind of standard deviation that deserves less trust.
pub fn weaker(a: SigmaKind, b: SigmaKind) -> SigmaKind {
    let rank = |kind: SigmaKind| match kind {
        SigmaKind::Repeats => 0,
        SigmaKind::Stated => 1,
        SigmaKind::Assumed => 2,
    };
    if rank(b) > rank(a) { b } else { a }
}

fn ends_mm(row: &Row) -> [f64; 2] {
    [row.r_mm.unwrap_or(0.0), row.r_to_mm.unwrap_or(0.0)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::measurement::Measurement;

    fn measurement(rows: &str) -> Measurement {
        let head = "case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n";
        Measurement::from_csv(&format!("{head}{rows}"), "m.csv").unwrap()
    }

    #[test]
    fn the_rates_of_twist_v1_integrate_to_its_stated_twists_and_errors() {
        let rows = "v1,twist_rate,camera,deg/mm,washout,,48,70,1.39,0.107,assumed,none\n\
                    v1,twist_rate,camera,deg/mm,washout,,0,48,0.29,0.041,stated,none\n";
        let measurement = measurement(rows);
        let rows: Vec<&Row> = measurement.rows.iter().collect();
        let profile = IntegratedRates::new(&rows).unwrap();
        let inner = profile.twist_at(48.0).unwrap();
        assert!((inner.twist_deg - 13.92).abs() < 1e-12);
        assert!((inner.sigma_deg - 1.968).abs() < 1e-12);
        assert_eq!(inner.sigma_kind, SigmaKind::Stated);
        let tip = profile.twist_at(70.0).unwrap();
        assert!((tip.twist_deg - 44.5).abs() < 1e-12);
        assert!((tip.sigma_deg - (1.968f64.powi(2) + 2.354f64.powi(2)).sqrt()).abs() < 1e-12);
        assert_eq!(tip.sigma_kind, SigmaKind::Assumed);
        assert_eq!(profile.twist_at(70.1), None);
    }

    #[test]
    fn a_gap_or_an_overlap_ends_the_profile_and_says_so() {
        for (from, word) in [(25, "gap"), (15, "overlap")] {
            let rows = format!(
                "a,twist_rate,camera,deg/mm,washout,,0,20,0.1,0.1,stated,none\n\
                 a,twist_rate,camera,deg/mm,washout,,{from},40,0.2,0.1,stated,none\n"
            );
            let measurement = measurement(&rows);
            let rows: Vec<&Row> = measurement.rows.iter().collect();
            let profile = IntegratedRates::new(&rows).unwrap();
            assert_eq!(profile.reach_mm, 20.0);
            assert!(profile.stopped.unwrap().contains(word));
        }
    }

    #[test]
    fn rates_that_do_not_start_at_the_base_give_no_profile() {
        let measurement = measurement("a,twist_rate,camera,deg/mm,washout,,5,20,0.1,0.1,stated,none\n");
        let rows: Vec<&Row> = measurement.rows.iter().collect();
        assert_eq!(IntegratedRates::new(&rows), None);
    }

    #[test]
    fn an_upper_bound_on_the_basal_rate_bounds_every_twist_outboard() {
        let rows = "a,twist_rate,camera,deg/mm,washout,,0,20,0.1,0.1,stated,upper\n\
                    a,twist_rate,camera,deg/mm,washout,,20,40,0.2,0.1,stated,none\n";
        let measurement = measurement(rows);
        let rows: Vec<&Row> = measurement.rows.iter().collect();
        let profile = IntegratedRates::new(&rows).unwrap();
        assert_eq!(profile.twist_at(30.0).unwrap().bound, Bound::Upper);
        assert!((profile.twist_at(30.0).unwrap().twist_deg - 4.0).abs() < 1e-12);
    }
}
