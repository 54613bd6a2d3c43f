//! What twist buys, for people to read.

use super::{LiftSummary, WingRatios};
use crate::page::text::{Table, number, wrapped};

impl LiftSummary {
    /// The page.
    pub fn page(&self, folder: &str) -> String {
        let mut page = format!("Lift of one wing, mean over the stroke; {}\n", self.twist);
        page += &self.wings_table();
        for ratios in &self.ratios {
            page += &format!("\n{}", self.ratios_table(ratios));
        }
        if !self.sensitivity.is_empty() {
            page += &format!("\n{}", self.sensitivity_table());
        }
        if !self.warnings.is_empty() {
            page.push('\n');
        }
        for warning in &self.warnings {
            page += &wrapped(warning, 2);
        }
        page += &format!("\nFiles in {folder}: {}\n", self.files.join(" "));
        page
    }

    fn wings_table(&self) -> String {
        let mut table = Table::new([
            "wing",
            "f_hz",
            "half_deg",
            "tip_deg",
            "lift_mn",
            "drag_mn",
            "power_mw",
            "l/d",
            "lift/power",
            "local_l/d",
            "off_ellipse",
        ]);
        let optional = |value: Option<f64>, digits| value.map_or("–".into(), |value| number(value, digits));
        for wing in &self.wings {
            table.row([
                wing.name.clone(),
                number(wing.frequency_hz, 1),
                number(wing.half_amplitude_deg, 1),
                number(wing.tip_twist_deg, 1),
                number(wing.mean.lift_mn, 2),
                number(wing.mean.drag_mn, 2),
                number(wing.mean.power_mw, 1),
                optional(wing.mean.lift_to_drag, 3),
                optional(wing.mean.lift_per_power_n_per_w, 4),
                number(wing.local_lift_to_drag, 3),
                optional(wing.departure_from_ellipse, 3),
            ]);
        }
        let mut text = table.render();
        text += "  lift/power in N/W; local_l/d: mean along the span of local lift over drag\n";
        for wing in &self.wings {
            if let Some(inertial) = &wing.inertial {
                text += &format!(
                    "  {}: inertia {} g mm² about the stroke axis, inertial power up to {} mW; a drive that gets none of it \
                     back gives {} mW\n",
                    wing.name,
                    number(inertial.inertia_g_mm2, 0),
                    number(inertial.largest_mw, 1),
                    number(inertial.mean_without_recovery_mw, 1),
                );
            }
            if !wing.effects.is_empty() {
                text += &format!("  {}: with {}\n", wing.name, wing.effects.join(", "));
            }
        }
        text
    }

    fn ratios_table(&self, ratios: &WingRatios) -> String {
        let mut table = Table::new(["ratio", "as_flown", "equal_amplitude", "equal_f_x_amplitude"]);
        let rows = (ratios.as_flown.named().into_iter())
            .zip(ratios.equal_amplitude.named())
            .zip(ratios.equal_rate.named());
        for (((name, flown), (_, amplitude)), (_, rate)) in rows {
            table.row([
                name.to_string(),
                number(flown, 3),
                number(amplitude, 3),
                number(rate, 3),
            ]);
        }
        let mut text = format!(
            "{} over {} (frequency {} times, frequency × amplitude {} times)\n{}",
            ratios.name,
            self.reference,
            number(ratios.frequency_ratio, 4),
            number(ratios.rate_ratio, 4),
            table.render()
        );
        if let Some(measured) = &ratios.measured {
            let with = |value: Option<[f64; 2]>| {
                value.map_or("–".to_string(), |[value, sigma]| {
                    format!("{} ± {}", number(value, 3), number(sigma, 3))
                })
            };
            text += &format!(
                "  measured: lift {}, efficiency {}, effective lift coefficient {}\n",
                with(measured.lift),
                with(measured.efficiency),
                with(measured.effective_lift)
            );
        }
        if let Some(effective) = &ratios.effective {
            text += &format!(
                "  effective lift coefficient, measured over modelled lift: {} at equal amplitude, {} as flown\n",
                number(effective.lift_at_equal_amplitude, 3),
                number(effective.lift_as_flown, 3)
            );
            if let Some(drag) = effective.drag_at_equal_amplitude {
                text += &format!(
                    "  effective drag coefficient: {} at equal amplitude, if the measured efficiency is lift per power there\n",
                    number(drag, 3)
                );
            }
            if let Some(ratio) = effective.implied_amplitude_ratio {
                text += &format!(
                    "  amplitude over that of {} which the source's own effective coefficient implies: {}\n",
                    self.reference,
                    number(ratio, 3)
                );
            }
        }
        text
    }

    fn sensitivity_table(&self) -> String {
        let mut table = Table::new([
            "wing",
            "what",
            "value",
            "l/d",
            "lift_equal_rate",
            "lift/power_equal_rate",
            "lift/power_equal_amplitude",
        ]);
        for row in &self.sensitivity {
            table.row([
                row.wing.clone(),
                row.what.clone(),
                row.value.clone(),
                number(row.lift_to_drag, 3),
                number(row.lift_at_equal_rate, 3),
                number(row.lift_per_power_at_equal_rate, 3),
                number(row.lift_per_power_at_equal_amplitude, 3),
            ]);
        }
        format!(
            "What is not known, one at a time, alike on both wings, the twist kept (ratios to {})\n{}",
            self.reference,
            table.render()
        )
    }
}
