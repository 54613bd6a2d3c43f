//! Where the model fails, in plain words made from the numbers of a comparison.

use crate::input::design::Design;
use crate::input::measurement::{Bound, Channel, SigmaKind};

use crate::observation::{Place, TwistProfile};

use super::comparison::Comparison;
use super::integrated::weaker;
use super::row::ComparedRow;
use super::span::{ComparedStation, SpanComparison};

/// Misfits up to this many standard deviations count as agreement.
pub const AGREEMENT_SIGMA: f64 = 2.0;

/// One paragraph: where the model fails and by how much, how the rates run, and what that rules out.
pub fn in_words(comparison: &Comparison, design: &Design, profile: &TwistProfile) -> String {
    if comparison.rows.is_empty() && comparison.span.is_empty() {
        return "No measured row could be compared with the model; the reason stands beside each row."
            .to_string();
    }
    let worst = comparison
        .span
        .iter()
        .max_by(|a, b| a.rms_sigma.total_cmp(&b.rms_sigma));
    let mut sentences: Vec<String> = Vec::new();
    if let Some(span) = worst {
        if comparison.span.len() > 1 {
            let (count, run) = (comparison.span.len(), named(&span.run));
            sentences.push(format!(
                "Of {count} measured profiles, this is about the one it fits worst{run}."
            ));
        }
        sentences.extend(along_the_span(span));
        sentences.extend(free_film(span, profile));
    }
    if let Some(rates) = Rates::of(comparison) {
        sentences.push(rates.in_words());
        if rates.measured_rises() && rates.modelled[1] < rates.modelled[0] && is_uniform_and_free(design) {
            sentences.push(UNIFORM_ROD.to_string());
        }
    }
    sentences.extend(other_channels(&comparison.rows));
    let kind = comparison
        .rows
        .iter()
        .map(|row| row.sigma_kind)
        .fold(SigmaKind::Repeats, weaker);
    if kind == SigmaKind::Assumed {
        sentences.push(
            "The errors are assumed, not measured: a count of sigma is worth no more than they are.".into(),
        );
    }
    sentences.join(" ")
}

const UNIFORM_ROD: &str = "The rod is uniform and its tip is free: its torque falls to zero at the tip, and its twist \
    rate with it, so a uniform rod cannot do this quasi-statically by its own rotation, at any stiffness or load; what \
    is missing lies elsewhere (the line from leading to trailing edge, bending, dynamics, the instrument).";

/// "assumed sigma" and the like.
pub fn sigma_words(kind: SigmaKind) -> &'static str {
    match kind {
        SigmaKind::Stated => "stated sigma",
        SigmaKind::Repeats => "sigma from repeats",
        SigmaKind::Assumed => "assumed sigma",
    }
}

fn named(run: &str) -> String {
    if run.is_empty() {
        String::new()
    } else {
        format!(" (run {run})")
    }
}

fn along_the_span(span: &SpanComparison) -> Vec<String> {
    let Some(last) = span.outermost() else {
        return Vec::new();
    };
    let sigma = sigma_words(span.sigma_kind());
    let mut sentences = vec![format!(
        "At {:.1} mm the measured twist is {}{:.1} deg and the modelled one {}{:.1} deg: {}.",
        last.r_mm,
        bound_words(last.bound),
        last.measured_deg,
        bound_words(last.modelled_bound),
        last.modelled_deg,
        outermost_words(last, sigma),
    )];
    if span.stations.len() > 1 {
        sentences.push(format!("Along the span the model {}.", stretches(&span.stations)));
        let size = |station: &&ComparedStation| station.r_mm == span.worst_r_mm;
        let worst_deg = span
            .stations
            .iter()
            .find(size)
            .map_or(0.0, |station| station.misfit_deg.abs());
        sentences.push(format!(
            "The root mean square error over the span is {:.1} deg ({:.1} {sigma} over the stations), the largest \
             {worst_deg:.1} deg at {:.1} mm.",
            span.rmse_along_span_deg, span.rms_sigma, span.worst_r_mm,
        ));
    }
    sentences
}

/// Whether most of a misfit at the last station arises outboard of the last spar, where no spar keeps the chord.
fn free_film(span: &SpanComparison, profile: &TwistProfile) -> Option<String> {
    let last = span.outermost()?;
    let is_spar_end = |place: Place| matches!(place, Place::SparEnd(_));
    let spar = profile
        .readings
        .iter()
        .rfind(|reading| is_spar_end(reading.place))?;
    let (spar_mm, spar_deg) = (spar.r_m * 1e3, spar.twist_rad.to_degrees());
    let beyond_deg = last.modelled_deg - spar_deg;
    let is_far = last.r_mm - spar_mm > FREE_SHARE * last.r_mm;
    // The misfit is measured minus modelled, so what the film adds to the model takes away from it.
    let is_most = -beyond_deg * last.misfit_deg.signum() > 0.5 * last.misfit_deg.abs();
    (is_far && last.misfit_deg != 0.0 && is_most).then(|| {
        format!(
            "Of the modelled twist there {spar_deg:.1} deg are reached at the last spar ({spar_mm:.1} mm); the other \
             {beyond_deg:.1} deg arise outboard of it, where the film alone holds the chord."
        )
    })
}

/// A last station farther outboard of the last spar than this share of its place hangs on the film.
const FREE_SHARE: f64 = 0.1;

fn bound_words(bound: Bound) -> &'static str {
    match bound {
        Bound::None => "",
        Bound::Upper => "at most ",
        Bound::Lower => "at least ",
    }
}

fn outermost_words(last: &ComparedStation, sigma: &str) -> String {
    if last.misfit_deg == 0.0 {
        return "no contradiction".to_string();
    }
    let way = if last.misfit_deg > 0.0 {
        "too little"
    } else {
        "too much"
    };
    let count = last.misfit_sigma.abs();
    format!(
        "the model twists {:.1} deg ({count:.1} {sigma}) {way}",
        last.misfit_deg.abs()
    )
}

/// "agrees within 2 sigma from 2.8 to 18.9 mm, twists too little from 35.0 to 67.9 mm (by up to 32.0 deg)".
fn stretches(stations: &[ComparedStation]) -> String {
    let class = |station: &ComparedStation| {
        let beyond = station.misfit_sigma.abs() > AGREEMENT_SIGMA;
        if beyond {
            station.misfit_sigma.signum() as i32
        } else {
            0
        }
    };
    let words = stations.chunk_by(|a, b| class(a) == class(b)).map(|stretch| {
        let place = match stretch {
            [only] => format!("at {:.1} mm", only.r_mm),
            _ => format!(
                "from {:.1} to {:.1} mm",
                stretch[0].r_mm,
                stretch[stretch.len() - 1].r_mm
            ),
        };
        let most = stretch
            .iter()
            .map(|station| station.misfit_deg.abs())
            .fold(0.0, f64::max);
        match class(&stretch[0]) {
            0 => format!("agrees within {AGREEMENT_SIGMA} sigma {place}"),
            1 => format!("twists too little {place} (by up to {most:.1} deg)"),
            _ => format!("twists too much {place} (by up to {most:.1} deg)"),
        }
    });
    words.collect::<Vec<_>>().join(", ")
}

/// Innermost and outermost twist rate of one run.
struct Rates {
    measured: [f64; 2],
    sigma: [f64; 2],
    modelled: [f64; 2],
}

impl Rates {
    fn of(comparison: &Comparison) -> Option<Rates> {
        let rates = |run: &str| {
            let rows = comparison
                .rows
                .iter()
                .filter(move |row| row.channel == Channel::TwistRate && row.run == run);
            let mut rows: Vec<&ComparedRow> = rows.filter(|row| row.bound == Bound::None).collect();
            rows.sort_by(|a, b| a.r_mm.unwrap_or(0.0).total_cmp(&b.r_mm.unwrap_or(0.0)));
            rows
        };
        let rows = comparison
            .rows
            .iter()
            .map(|row| rates(&row.run))
            .find(|rows| rows.len() > 1)?;
        let (first, last) = (rows[0], rows[rows.len() - 1]);
        Some(Rates {
            measured: [first.measured, last.measured],
            sigma: [first.sigma, last.sigma],
            modelled: [first.modelled, last.modelled],
        })
    }

    fn measured_rises(&self) -> bool {
        self.measured[1] - self.measured[0] > AGREEMENT_SIGMA * self.sigma[0].hypot(self.sigma[1])
    }

    fn in_words(&self) -> String {
        let change = self.measured[1] - self.measured[0];
        let measured = if change.abs() <= AGREEMENT_SIGMA * self.sigma[0].hypot(self.sigma[1]) {
            "stays within its error"
        } else if change > 0.0 {
            "rises"
        } else {
            "falls"
        };
        let modelled = if self.modelled[1] > self.modelled[0] {
            "rises"
        } else {
            "falls"
        };
        format!(
            "Toward the tip the measured twist rate {measured}, from {:.2} to {:.2} deg/mm, and the modelled one \
             {modelled}, from {:.2} to {:.2} deg/mm.",
            self.measured[0], self.measured[1], self.modelled[0], self.modelled[1],
        )
    }
}

/// Whether the rod has one section from base to end and nothing but air, film and spars loads it.
fn is_uniform_and_free(design: &Design) -> bool {
    let same = |pair: &[crate::input::design::RodSegment]| {
        pair[0].section == pair[1].section && pair[0].material == pair[1].material
    };
    design.load.is_empty() && design.rod.windows(2).all(same)
}

fn other_channels(rows: &[ComparedRow]) -> Option<String> {
    let off = rows
        .iter()
        .filter(|row| !row.channel.is_twist() && row.misfit_sigma.abs() > AGREEMENT_SIGMA);
    let words: Vec<String> = off
        .map(|row| {
            let unit = if row.unit == "1" {
                String::new()
            } else {
                format!(" {}", row.unit)
            };
            let place = row
                .r_mm
                .map_or_else(String::new, |r_mm| format!(" at {r_mm:.1} mm"));
            format!(
                "{}{place} {:.3}{unit} measured, {:.3}{unit} modelled ({:.1} {})",
                row.channel.name().replace('_', " "),
                row.measured,
                row.modelled,
                row.misfit_sigma.abs(),
                sigma_words(row.sigma_kind),
            )
        })
        .collect();
    (!words.is_empty()).then(|| format!("Besides the twist it misses: {}.", words.join("; ")))
}
