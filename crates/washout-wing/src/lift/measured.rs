//! A measured twist profile as the lift model flies with it: rates integrated from the base, or twists between stations.

use crate::input::measurement::{Bound, Channel, Measurement, Row};

use super::error::LiftError;
use super::twist::TwistAlongSpan;

impl TwistAlongSpan {
    /// The profile of one measured wing: its twist rates from the base outward where there are any, else its twists, from
    /// no twist at the base. Rows that are bounds only do not count, but a wing that has nothing else, "minimal twist", is flat.
    ///
    /// # Errors
    /// [`LiftError::NoMeasuredTwist`] without twist; stretches that overlap.
    pub fn from_measurement(measurement: &Measurement) -> Result<Self, LiftError> {
        let of = |channel: Channel| -> Vec<&Row> {
            let rows = measurement.rows.iter();
            rows.filter(|row| row.channel == channel && !row.is_planned)
                .collect()
        };
        let run = |rows: &[&Row]| rows.first().map(|row| row.run.clone());
        let (mut rates, mut twists) = (of(Channel::TwistRate), of(Channel::Twist));
        if rates.is_empty() && twists.is_empty() {
            return Err(LiftError::NoMeasuredTwist);
        }
        for rows in [&mut rates, &mut twists] {
            let first = run(rows);
            rows.retain(|row| row.bound == Bound::None && Some(&row.run) == first.as_ref());
        }
        rates.sort_by(|a, b| a.r_mm.unwrap_or(0.0).total_cmp(&b.r_mm.unwrap_or(0.0)));
        twists.sort_by(|a, b| a.r_mm.unwrap_or(0.0).total_cmp(&b.r_mm.unwrap_or(0.0)));
        let mut points = vec![[0.0, 0.0]];
        for row in &rates {
            let (Some(from), Some(to)) = (row.r_mm, row.r_to_mm) else {
                continue;
            };
            let [reached_m, twist] = points[points.len() - 1];
            if from * 1e-3 > reached_m {
                points.push([from * 1e-3, twist]);
            }
            points.push([to * 1e-3, twist + ((to - from) * row.value).to_radians()]);
        }
        if rates.is_empty() {
            for row in &twists {
                let Some(r_mm) = row.r_mm else { continue };
                if r_mm == 0.0 {
                    points.clear();
                }
                points.push([r_mm * 1e-3, row.value.to_radians()]);
            }
        }
        Self::from_points(points)
    }
}

#[cfg(test)]
mod tests {
    use crate::input::measurement::Measurement;
    use crate::lift::error::LiftError;
    use crate::lift::paper;
    use crate::lift::twist::TwistAlongSpan;

    fn case(name: &str) -> Measurement {
        let text = include_str!("../../../../measurements/colmenares-as-stated.csv");
        Measurement::from_csv(text, "stated.csv")
            .expect("a measurement")
            .case(name)
    }

    #[test]
    fn the_papers_rates_become_its_profiles_and_minimal_twist_is_none() {
        for (name, profile) in [("twist-v1", paper::twist_v1()), ("twist-v2", paper::twist_v2())] {
            let found = TwistAlongSpan::from_measurement(&case(name)).expect("a profile");
            for r_mm in [0.0, 10.0, 30.0, 50.0, 69.0] {
                let (found, stated) = (found.twist_rad(r_mm * 1e-3), profile.twist_rad(r_mm * 1e-3));
                assert!((found - stated).abs() < 1e-12, "{name} {r_mm}");
            }
        }
        let rigid = TwistAlongSpan::from_measurement(&case("rigid")).expect("a profile");
        assert_eq!(rigid.twist_rad(0.06), 0.0);
    }

    #[test]
    fn a_measurement_without_twist_is_refused() {
        let empty = TwistAlongSpan::from_measurement(&case("none"));
        assert_eq!(empty, Err(LiftError::NoMeasuredTwist));
    }
}
