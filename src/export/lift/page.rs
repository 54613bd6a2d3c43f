//! What twist buys, for people to read.

use super::{LiftSummary, WingLift, WingRatios};
use crate::page::Digits::After;
use crate::page::text::number;
use crate::page::{Page, Part, Rows, Table};

impl LiftSummary {
    /// What `washout lift` says.
    pub fn page(&self) -> Page {
        let mut page = Page {
            title: "Lift of one wing, mean over the stroke".to_string(),
            kind: "summary",
            lead: vec![
                Part::Text(format!("The wings fly with {}.", self.twist)),
                Part::Notes(self.warnings.clone()),
            ],
            ..Page::default()
        };
        page.brief = page.lead.clone();
        let wings = self.wings().without(&["departure_from_ellipse"]);
        page.brief.push(Part::Table(wings));
        if !self.ratios.is_empty() {
            page.brief.push(Part::Table(self.main_ratios()));
        }
        let mut wings = vec![Part::Table(self.wings())];
        wings.extend(listed(self.wings.iter().filter_map(inertial)));
        wings.extend(listed(self.wings.iter().filter_map(effects)));
        page.section("wings", "Wings", wings);
        let ratios = self.ratios.iter().enumerate();
        let ratios = ratios.flat_map(|(index, ratios)| self.ratios_of(index, ratios));
        page.section("ratios", "Ratios to the reference", ratios.collect());
        if !self.sensitivity.is_empty() {
            let sensitivity = Part::Table(self.sensitivity());
            page.brief.push(sensitivity.clone());
            page.section("sensitivity", "What is not known", vec![sensitivity]);
        }
        page
    }

    fn wings(&self) -> Table {
        Rows::of("/wings", &self.wings)
            .words("wing", |wing| wing.name.as_str())
            .number(["frequency_hz", "f", "Hz"], After(1), |wing| wing.frequency_hz)
            .number(["half_amplitude_deg", "±", "deg"], After(1), |wing| {
                wing.half_amplitude_deg
            })
            .number(["tip_twist_deg", "tip", "deg"], After(1), |wing| wing.tip_twist_deg)
            .number(["mean/lift_mn", "lift", "mN"], After(2), |wing| wing.mean.lift_mn)
            .number(["mean/drag_mn", "drag", "mN"], After(2), |wing| wing.mean.drag_mn)
            .number(["mean/power_mw", "power", "mW"], After(1), |wing| {
                wing.mean.power_mw
            })
            .number(["mean/lift_to_drag", "L/D", ""], After(3), |wing| {
                wing.mean.lift_to_drag
            })
            .number(["mean/lift_per_power_n_per_w", "L/P", "N/W"], After(4), |wing| {
                wing.mean.lift_per_power_n_per_w
            })
            .number(["local_lift_to_drag", "local L/D", ""], After(3), |wing| {
                wing.local_lift_to_drag
            })
            .number(["departure_from_ellipse", "off ell.", ""], After(3), |wing| {
                wing.departure_from_ellipse
            })
            .caption("Local L/D: mean along the span of local lift over drag. Off ell.: departure of the lift along the span from an ellipse.")
            .table()
    }

    /// What a screen shows of the ratios.
    fn main_ratios(&self) -> Table {
        Rows::of("/ratios", &self.ratios)
            .words("wing", |row| row.name.as_str())
            .number(["as_flown/lift", "lift", ""], After(3), |row| row.as_flown.lift)
            .number(["as_flown/lift_to_drag", "L/D", ""], After(3), |row| {
                row.as_flown.lift_to_drag
            })
            .number(
                ["as_flown/local_lift_to_drag", "local L/D", ""],
                After(3),
                |row| row.as_flown.local_lift_to_drag,
            )
            .number(["equal_rate/lift", "lift, equal f×Φ", ""], After(3), |row| {
                row.equal_rate.lift
            })
            .number(
                ["equal_rate/lift_per_power", "L/P, equal f×Φ", ""],
                After(3),
                |row| row.equal_rate.lift_per_power,
            )
            .caption(&format!(
                "Over {}: as flown, and at the same product of frequency and amplitude",
                self.reference
            ))
            .table()
    }

    fn ratios_of(&self, index: usize, ratios: &WingRatios) -> Vec<Part> {
        let sets = [&ratios.as_flown, &ratios.equal_amplitude, &ratios.equal_rate];
        let rows: Vec<([&str; 2], [f64; 3])> = (0..sets[0].named().len())
            .map(|row| {
                let (key, name, _) = sets[0].named()[row];
                ([key, name], sets.map(|set| set.named()[row].2))
            })
            .collect();
        let table = Rows::keyed(
            &format!("/ratios/{index}"),
            rows.iter().map(|row| (row.0[0], row)),
        )
        .words("ratio", |row| row.0[1])
        .number(["as_flown/{}", "as flown", ""], After(3), |row| row.1[0])
        .number(["equal_amplitude/{}", "equal amplitude", ""], After(3), |row| {
            row.1[1]
        })
        .number(["equal_rate/{}", "equal f×Φ", ""], After(3), |row| row.1[2])
        .table();
        let title = format!(
            "{} over {} (frequency {} times, frequency × amplitude {} times)",
            ratios.name,
            self.reference,
            number(ratios.frequency_ratio, 4),
            number(ratios.rate_ratio, 4)
        );
        let mut parts = vec![Part::Subtitle(title), Part::Table(table)];
        parts.extend(listed(self.beside(ratios).into_iter()));
        parts
    }

    /// What was measured of a wing, and what that says of its coefficients.
    fn beside(&self, ratios: &WingRatios) -> Vec<String> {
        let mut lines = Vec::new();
        if let Some(measured) = &ratios.measured {
            let with = |value: Option<[f64; 2]>| {
                value.map_or("–".to_string(), |[value, sigma]| {
                    format!("{} ± {}", number(value, 3), number(sigma, 3))
                })
            };
            lines.push(format!(
                "measured: lift {}, efficiency {}, effective lift coefficient {}",
                with(measured.lift),
                with(measured.efficiency),
                with(measured.effective_lift)
            ));
        }
        let Some(effective) = &ratios.effective else {
            return lines;
        };
        lines.push(format!(
            "effective lift coefficient, measured over modelled lift: {} at equal amplitude, {} as flown",
            number(effective.lift_at_equal_amplitude, 3),
            number(effective.lift_as_flown, 3)
        ));
        lines.extend(effective.drag_at_equal_amplitude.map(|drag| {
            format!(
                "effective drag coefficient: {} at equal amplitude, if the measured efficiency is lift per power there",
                number(drag, 3)
            )
        }));
        lines.extend(effective.implied_amplitude_ratio.map(|ratio| {
            format!(
                "amplitude over that of {} which the source's own effective coefficient implies: {}",
                self.reference,
                number(ratio, 3)
            )
        }));
        lines
    }

    fn sensitivity(&self) -> Table {
        Rows::of("/sensitivity", &self.sensitivity)
            .words("wing", |row| row.wing.as_str())
            .words("what", |row| row.what.as_str())
            .words("value", |row| row.value.as_str())
            .number(["lift_to_drag", "L/D", ""], After(3), |row| row.lift_to_drag)
            .number(["lift_at_equal_rate", "lift, equal f×Φ", ""], After(3), |row| {
                row.lift_at_equal_rate
            })
            .number(
                ["lift_per_power_at_equal_rate", "L/P, equal f×Φ", ""],
                After(3),
                |row| row.lift_per_power_at_equal_rate,
            )
            .number(
                ["lift_per_power_at_equal_amplitude", "L/P, equal Φ", ""],
                After(3),
                |row| row.lift_per_power_at_equal_amplitude,
            )
            .caption(&format!(
                "One at a time, alike on both wings, the twist kept; ratios to {}",
                self.reference
            ))
            .table()
    }
}

fn listed(lines: impl Iterator<Item = String>) -> Option<Part> {
    let lines: Vec<String> = lines.collect();
    (!lines.is_empty()).then_some(Part::List(lines))
}

fn inertial(wing: &WingLift) -> Option<String> {
    let inertial = wing.inertial.as_ref()?;
    Some(format!(
        "{}: inertia {} g mm² about the stroke axis, inertial power up to {} mW; a drive that gets none of it back gives {} mW",
        wing.name,
        number(inertial.inertia_g_mm2, 0),
        number(inertial.largest_mw, 1),
        number(inertial.mean_without_recovery_mw, 1),
    ))
}

fn effects(wing: &WingLift) -> Option<String> {
    (!wing.effects.is_empty()).then(|| format!("{}: with {}", wing.name, wing.effects.join(", ")))
}
