//! Plausible wings at random, the same for every seed: what a user may draw, of sizes from an insect's to a small bird's.

use std::fmt::Write;

/// Numbers that look random (SplitMix64).
struct Draw(u64);

impl Draw {
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    /// Even in the logarithm.
    fn scale(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    fn is(&mut self, share: f64) -> bool {
        self.share() < share
    }

    fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.share() * choices.len() as f64) as usize]
    }

    /// A section as thick as `size_mm`.
    fn section(&mut self, size_mm: f64) -> String {
        match self.of(&[0, 1, 2, 3]) {
            0 => format!("{{ shape = \"round\", diameter_mm = {size_mm} }}"),
            1 => {
                let flat = self.of(&["in-plane", "across"]);
                format!("{{ shape = \"half-round\", diameter_mm = {size_mm}, flat = \"{flat}\" }}")
            }
            2 => format!(
                "{{ shape = \"tube\", outer_diameter_mm = {size_mm}, inner_diameter_mm = {} }}",
                size_mm * self.between(0.3, 0.7)
            ),
            _ => format!(
                "{{ shape = \"rectangle\", width_mm = {}, thickness_mm = {size_mm} }}",
                size_mm * self.between(1.0, 2.5)
            ),
        }
    }
}

/// The wing of a seed, as a design file.
pub fn random_wing(seed: u64, refine: f64) -> String {
    let mut draw = Draw(seed.wrapping_mul(0x0123_4567_89ab_cdef));
    let long_mm = draw.scale(20.0, 400.0);
    let chord_mm = long_mm / draw.between(1.5, 7.0);
    let offset_mm = if draw.is(0.5) {
        draw.between(0.05, 0.4) * long_mm
    } else {
        0.0
    };
    let r2_hat = draw.between(0.5, 0.6);
    let mut text = format!(
        "format = 1\nname = \"random-{seed}\"\n\n[mesh]\nrefine = {refine}\n\n[planform]\nlength_mm = {long_mm}\n\
         mean_chord_mm = {chord_mm}\nr2_hat = {r2_hat}\nroot_offset_mm = {offset_mm}\n\n"
    );
    air(&mut text, &mut draw, long_mm + offset_mm);
    // a wing of ribs is a beam: it has neither film nor spars
    let has_ribs = draw.is(0.06);
    if has_ribs {
        writeln!(text, "[ribs]\nbays = 8\nrod_chord_fraction = 0.25\n").unwrap();
    } else {
        film(&mut text, &mut draw);
    }
    let rod_mm = long_mm * draw.scale(0.006, 0.03);
    let part = draw.between(0.3, 0.7) * long_mm;
    let ends = if draw.is(0.3) {
        vec![0.0, part, long_mm]
    } else {
        vec![0.0, long_mm]
    };
    for (piece, ends) in ends.windows(2).enumerate() {
        let section = draw.section(rod_mm * 0.7_f64.powi(piece as i32));
        let (from, to) = (ends[0], ends[1]);
        writeln!(
            text,
            "[[rod]]\nfrom_mm = {from}\nto_mm = {to}\nmaterial = \"rod\"\nsection = {section}\n"
        )
        .unwrap();
    }
    let spars = if has_ribs {
        0
    } else {
        draw.of(&[0, 1, 1, 2, 2, 3, 3, 4, 5, 6, 7, 8])
    };
    for spar in 0..spars {
        let at_mm = long_mm * (spar as f64 + draw.between(0.8, 1.2)) / (spars as f64 + 1.0);
        let size_mm = rod_mm * draw.between(0.15, 0.6);
        let section = draw.section(size_mm);
        writeln!(
            text,
            "[[spar]]\nat_mm = {at_mm}\nmaterial = \"rod\"\nsection = {section}\n"
        )
        .unwrap();
    }
    if draw.is(0.15) {
        let force_n = [0.0, 0.0, draw.between(-1.0, 1.0) * 1e-6 * long_mm * long_mm];
        writeln!(
            text,
            "[[load]]\nat_mm = {}\nforce_n = {force_n:?}\n",
            0.9 * long_mm
        )
        .unwrap();
    }
    let (film_gpa, rod_gpa) = (draw.of(&[0.5, 2.5, 4.5]), draw.of(&[12.0, 70.0, 134.0]));
    text + &format!(
        "[material.film]\ne_gpa = {film_gpa}\npoisson = 0.34\ndensity_kg_m3 = 1400.0\n\n\
         [material.rod]\ne_gpa = {rod_gpa}\ng_gpa = {}\ndensity_kg_m3 = 1500.0\n",
        rod_gpa / draw.between(3.0, 30.0)
    )
}

fn air(text: &mut String, draw: &mut Draw, tip_mm: f64) {
    if draw.is(0.55) {
        let amplitude_deg = draw.between(15.0, 80.0);
        let tip_m_s = draw.between(2.0, 14.0);
        let frequency_hz = tip_m_s / (std::f64::consts::TAU * amplitude_deg.to_radians() * 1e-3 * tip_mm);
        let stop_deg = draw.between(20.0, 80.0);
        writeln!(
            text,
            "[flapping]\nfrequency_hz = {frequency_hz}\nhalf_amplitude_deg = {amplitude_deg}\nstop_angle_deg = {stop_deg}\n"
        )
        .unwrap();
    } else {
        let angle_deg = draw.between(-90.0, 90.0);
        let angle_deg = draw.of(&[
            0.0, 90.0, angle_deg, angle_deg, angle_deg, angle_deg, angle_deg, angle_deg,
        ]);
        let speed_m_s = draw.between(1.0, 20.0);
        writeln!(
            text,
            "[steady]\nspeed_m_s = {speed_m_s}\nroot_angle_deg = {angle_deg}\n"
        )
        .unwrap();
    }
    let law = draw.of(&["dickinson", "whitney-wood", "thin-airfoil"]);
    let centre = draw.of(&["dickson", "purdue"]);
    let slope = if law == "thin-airfoil" {
        "lift_slope_per_rad = 5.0\n"
    } else {
        ""
    };
    writeln!(
        text,
        "[air]\ndensity_kg_m3 = 1.2\ncoefficients = \"{law}\"\n{slope}centre_of_pressure = \"{centre}\"\n"
    )
    .unwrap();
    let chord = draw.of(&["free", "clamped"]);
    writeln!(text, "[root]\nchord = \"{chord}\"\n").unwrap();
    if draw.is(0.3) {
        writeln!(text, "[gravity]\nacceleration_m_s2 = [0.0, 0.0, -9.81]\n").unwrap();
    }
}

fn film(text: &mut String, draw: &mut Draw) {
    let thickness_mm = draw.scale(0.003, 0.1);
    let compression = if draw.is(0.2) { "carries" } else { "tension-field" };
    let tension_n_per_m = if draw.is(0.25) { draw.scale(0.5, 30.0) } else { 0.0 };
    writeln!(
        text,
        "[film]\nmaterial = \"film\"\nthickness_mm = {thickness_mm}\ncompression = \"{compression}\"\n\
         pretension_n_per_m = {tension_n_per_m}\n"
    )
    .unwrap();
}
