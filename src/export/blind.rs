//! The scoreboard of a blind run as text (Markdown): figures, reliability, simpler methods, every case.

use crate::blind::followed::Followed;
use crate::blind::scoreboard::{Row, Scoreboard};
use crate::blind::{Kind, Outcome};

/// The page.
pub fn page(study: &str, board: &Scoreboard, outcomes: &[Outcome]) -> String {
    [
        lead(study, board, outcomes),
        figures(board),
        every_case(outcomes),
        twins_measured_again(outcomes),
        not_hidden(board),
        without_an_answer(board),
    ]
    .concat()
}

fn lead(study: &str, board: &Scoreboard, outcomes: &[Outcome]) -> String {
    let mut lead = format!(
        "# Blind cases on {study}\n\n{} cases, made by washout itself: a development benchmark; {} more came to no answer. Median \
         time of a diagnosis {:.0} s.\n\n",
        board.cases,
        board.failed.len(),
        board.median_seconds
    );
    let redrawn: Vec<String> = outcomes
        .iter()
        .filter(|outcome| outcome.redrawn > 0)
        .map(|outcome| outcome.seed.to_string())
        .collect();
    if !redrawn.is_empty() {
        lead += &format!(
            "Drawn anew, because a wing had no equilibrium with what was hidden, or it was too faint: {}.\n\n",
            redrawn.join(", ")
        );
    }
    lead
}

/// The figures, the reliability of stated probabilities, and the simpler methods.
fn figures(board: &Scoreboard) -> String {
    let mut tables =
        "| figure | hits | share or value | 95 % interval | asked |\n|---|---|---|---|---|\n".to_string();
    for row in &board.rows {
        tables += &line(row);
    }
    tables += "\nStated probabilities of alarms against how often they were right ";
    tables += &format!(
        "(mean distance {:.3}, asked <= 0.08):\n\n",
        board.calibration_error
    );
    tables += "| stated | right |\n|---|---|\n";
    for bin in &board.reliability {
        tables += &format!("| {:.2} | {}/{} |\n", bin.stated, bin.hits, bin.count);
    }
    tables += "\nSimpler methods on the same cases:\n\n| method | hits | share | 95 % interval | |\n|---|---|---|---|---|\n";
    for row in &board.simpler {
        tables += &line(row);
    }
    tables
}

fn every_case(outcomes: &[Outcome]) -> String {
    let mut table =
        "\nEvery case:\n\n| kind | seed | hidden (distance, sigma) | said | right | time s |\n|---|---|---|---|---|---|\n"
            .to_string();
    for outcome in outcomes {
        let hidden: Vec<String> = outcome
            .truth
            .iter()
            .enumerate()
            .map(|(k, acted)| match outcome.detectability.get(k) {
                Some(distance) => format!("{} {:.3} ({distance:.0})", acted.asked, acted.strength),
                None => acted.formula.replace('|', "\\|"),
            })
            .collect();
        let right = match (outcome.is_right(), outcome.in_set, outcome.kind) {
            (true, _, _) => "yes",
            (false, true, Kind::Twin) => "in the set",
            (false, true, _) => "no; in the set",
            (false, false, _) if !outcome.is_alarm() => "not seen",
            _ => "no",
        };
        table += &format!(
            "| {} | {} | {} | {} | {right} | {:.0} |\n",
            outcome.kind.word(),
            outcome.seed,
            hidden.join(" + "),
            outcome.sentence,
            outcome.seconds
        );
    }
    table
}

fn twins_measured_again(outcomes: &[Outcome]) -> String {
    let followed = outcomes.iter().filter_map(|o| Some((o, o.followed.as_ref()?)));
    let followed: Vec<String> = followed
        .map(|(outcome, followed)| measured(outcome, followed))
        .collect();
    if followed.is_empty() {
        return String::new();
    }
    let head = "\nTwins after the measurement that the diagnosis asked for, and after another of the list (names in the 95 % set; \
                probability of the truth):\n\n| seed | asked for | expected, sigma | other | names: before, asked for, other | \
                truth |\n|---|---|---|---|---|---|\n";
    head.to_string() + &followed.concat()
}

fn not_hidden(board: &Scoreboard) -> String {
    if board.turned.is_empty() {
        return String::new();
    }
    let turned = board.turned.iter().map(|turned| match turned.cosine {
        Some(cosine) => format!("{} (cosine {cosine:.2})", turned.effect),
        None => format!("{} (no equilibrium)", turned.effect),
    });
    format!(
        "\nNot hidden, because an error of one percent in the wing turns their signature (the wing's motion is near a \
         resonance): {}.\n",
        turned.collect::<Vec<_>>().join(", ")
    )
}

fn without_an_answer(board: &Scoreboard) -> String {
    if board.failed.is_empty() {
        return String::new();
    }
    let mut table = "\nWithout an answer:\n\n| kind | seed | why |\n|---|---|---|\n".to_string();
    for failed in &board.failed {
        let why = failed.failed.replace('|', "\\|").replace('\n', " ");
        table += &format!("| {} | {} | {why} |\n", failed.kind.word(), failed.seed);
    }
    table
}

fn measured(outcome: &Outcome, followed: &Followed) -> String {
    format!(
        "| {} | {} | {:.1} | {} | {} | {} |\n",
        outcome.seed,
        followed.best,
        followed.expected_sigma,
        followed.other,
        followed.names.map(|names| names.to_string()).join(", "),
        followed.truth.map(|truth| format!("{truth:.2}")).join(", ")
    )
}

fn line(row: &Row) -> String {
    let percent = |share: f64| format!("{:.1}", 100.0 * share);
    let (hits, value, interval) = match (row.hits, row.interval) {
        _ if row.count == 0 => ("0/0".to_string(), "–".to_string(), "–".to_string()),
        (Some(hits), Some([low, high])) => (
            format!("{hits}/{}", row.count),
            format!("{} %", percent(row.value)),
            format!("{} to {} %", percent(low), percent(high)),
        ),
        _ => (
            format!("of {}", row.count),
            format!("{:.3}", row.value),
            "–".to_string(),
        ),
    };
    format!(
        "| {} | {hits} | {value} | {interval} | {} |\n",
        row.what, row.asked
    )
}
