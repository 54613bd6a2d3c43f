//! `verify.md` and the page "How far to trust washout": the cases, their errors and orders, and what they do not say.

use std::fmt::Write;

use crate::compare::StudyComparison;

use super::verification::{CaseReport, QuantityReport, VerifyReport, percent, rows};
use crate::page::text::{number, significant};

/// What stands above the tables of the page "How far to trust washout".
pub const TRUST_HEAD: &str = "\
# How far to trust washout

Written by `washout verify --page docs/how-far-to-trust-washout.md`; `tests/verification` runs the cases again and
compares. Do not edit by hand.

A solver may be trusted for the cases that it has passed. Each case below runs through the library that the wings use,
on a coarse, a middle and a fine mesh, each with half the element size of the one before. It passes if the error on the
fine mesh is within its limit, which is what good elements are reported to reach on such meshes. Where theory gives an
order of convergence, the observed one must lie within 0.2 of it. The order is observed on the three meshes alone
(against the own extrapolated value), not against the reference.

References are *seen* (read in a public transcription of the publication), *derived* (a closed form, or a solution by
independent means) or from *memory*. What rests on memory alone is shown and not judged.

Validation asks for nature instead: its limit is two standard deviations of the measurement, as assumed before any
comparison was run. Wings whose measurement needs offsets of the instrument or uncertain inputs are studies, not cases.
";

/// What stands above the table of the studies.
const MEASURED: &str = "\
## Measured wings

Root mean square of measured minus modelled in the unit of the channel, over all rows of a channel. It is given with the
inputs as stated (with its mean, the bias), and after calibration of what is uncertain within its prior. Rows held out
were never fitted. The standard deviations of the measurement and of the uncertain inputs (an unknown zero of the
instrument among them) were written down before the first comparison. *Explained* is the share of the mean square error
of the uncalibrated model that both together would give on average (ASME V&V 20). Where it is less than all, the model
lacks something.
`washout compare STUDY` shows every row.
";

/// The page of documentation, with the misfit of studies; no timings, so that it does not change from run to run.
pub fn trust_page(report: &VerifyReport, studies: &[StudyComparison]) -> String {
    format!(
        "{TRUST_HEAD}\n{}{}{}",
        tables(report, false),
        measured(studies),
        notes(report)
    )
}

/// `verify.md`: the same tables with timings.
pub fn markdown(report: &VerifyReport) -> String {
    format!(
        "# washout {} verify\n\n{}\n\n{}{}",
        report.made_of.washout_version,
        report.summary(),
        tables(report, true),
        notes(report)
    )
}

fn tables(report: &VerifyReport, timed: bool) -> String {
    let mut text = String::new();
    for (_, title, cases) in report.parts() {
        if cases.is_empty() {
            continue;
        }
        // writing to a text cannot fail
        let _ = write!(text, "## {title}\n\n{}", table(cases, timed));
        for case in cases {
            if let Some(failure) = &case.failure {
                let _ = writeln!(text, "\n`{}` gave no answer: {failure}.", case.name);
            }
        }
        text.push('\n');
    }
    text += "Errors and limits in percent of the reference; a curve is shown where it is worst.\n\n";
    text + &missed(report)
}

/// The studies: misfit uncalibrated and calibrated, and what known uncertainty explains of it.
fn measured(studies: &[StudyComparison]) -> String {
    let head = [
        "study",
        "wing",
        "channel",
        "rows",
        "uncalibrated",
        "bias",
        "calibrated",
        "σ measured",
        "σ inputs",
        "explained",
    ];
    let mut text = format!(
        "{MEASURED}\n| {} |\n|{}\n",
        head.join(" | "),
        "---|".repeat(head.len())
    );
    for study in studies {
        for group in &study.groups {
            let held_out = if group.is_held_out { " held out" } else { "" };
            let explained = match group.explained {
                Some(share) if share < 1.0 => format!("{} %", number(100.0 * share, 0)),
                _ => "all".to_string(),
            };
            let cells = [
                study.study.clone(),
                group.wing.clone(),
                format!("{}, {}", group.channel.name(), group.unit),
                format!("{}{held_out}", group.count),
                significant(group.rmse[0], 2),
                significant(group.bias[0], 2),
                significant(group.rmse[1], 2),
                significant(group.sigma_of_measurement, 2),
                if group.sigma_of_inputs < 1e-3 * group.sigma_of_measurement {
                    "0".to_string()
                } else {
                    significant(group.sigma_of_inputs, 2)
                },
                explained,
            ];
            let _ = writeln!(text, "| {} |", cells.join(" | "));
        }
    }
    if studies.is_empty() {
        String::new()
    } else {
        text + "\n"
    }
}

/// What fails, in a list; nothing if nothing does.
fn missed(report: &VerifyReport) -> String {
    let fails = |q: &&QuantityReport| q.verdict == "error" || q.verdict == "order";
    let mut text = String::new();
    for case in report.cases() {
        for quantity in case.quantities.iter().filter(fails) {
            let what = if quantity.verdict == "error" {
                format!(
                    "{} % off, limit {} %",
                    percent(quantity.error()),
                    quantity.limit()
                )
            } else {
                format!("order {}", quantity.order_words())
            };
            let _ = writeln!(text, "- `{}`, {}: {what}.", case.name, quantity.name);
        }
    }
    if text.is_empty() {
        return text;
    }
    format!("## Missed\n\n{text}\n")
}

fn table(cases: &[CaseReport], timed: bool) -> String {
    let head = [
        "case",
        "quantity",
        "reference",
        "ours",
        "coarse",
        "middle",
        "fine",
        "limit",
        "order",
        "mesh",
    ];
    let mut head = head.map(str::to_string).to_vec();
    if timed {
        head.push("time, s".to_string());
    }
    head.extend(["verdict".to_string(), "source".to_string()]);
    let mut text = format!("| {} |\n|{}\n", head.join(" | "), "---|".repeat(head.len()));
    for (case, quantity) in rows(cases) {
        let error = |level: &str| percent(case.error_at(quantity, level));
        let unit = if quantity.unit == "1" { "" } else { &quantity.unit };
        let mut cells = vec![
            case.name.clone(),
            quantity.words(),
            format!("{} {unit}", significant(quantity.reference, 6))
                .trim_end()
                .to_string(),
            quantity.ours.map_or("–".to_string(), |ours| significant(ours, 6)),
            error("coarse"),
            error("middle"),
            error("fine"),
            quantity.limit(),
            quantity.order_words(),
            case.meshes.last().map_or(String::new(), |mesh| mesh.mesh.clone()),
        ];
        if timed {
            cells.push(number(case.time_s(), 1));
        }
        cells.push(if quantity.verdict == "pass" {
            "pass".to_string()
        } else {
            format!("**{}**", quantity.verdict)
        });
        cells.push(format!("{} ({})", quantity.source, quantity.confidence));
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
    text
}

/// What the cases are, which are exempt from an order and why, and other references.
fn notes(report: &VerifyReport) -> String {
    let mut text = String::from("## The cases\n\n");
    for case in report.cases() {
        let _ = writeln!(text, "- `{}`: {}.", case.name, case.title);
        let mut seen: Vec<&String> = Vec::new();
        for quantity in &case.quantities {
            for other in quantity
                .others
                .iter()
                .filter(|other| !seen.contains(other))
                .collect::<Vec<_>>()
            {
                let _ = writeln!(text, "  Other reference for the {}: {other}.", quantity.name);
                seen.push(other);
            }
        }
    }
    text += "\n## Without an expected order\n\n";
    for case in report.cases() {
        let mut reasons: Vec<&String> = case
            .quantities
            .iter()
            .filter_map(|q| q.order_exempt.as_ref())
            .collect();
        reasons.dedup();
        for reason in reasons {
            let exempt = |q: &&QuantityReport| q.order_exempt.as_ref() == Some(reason);
            let names: Vec<&str> = case
                .quantities
                .iter()
                .filter(exempt)
                .map(|q| q.name.as_str())
                .collect();
            let which = if names.len() == case.quantities.len() {
                String::new()
            } else {
                format!(" ({})", names.join("; "))
            };
            let _ = writeln!(text, "- `{}`{which}: {reason}.", case.name);
        }
    }
    text
}
