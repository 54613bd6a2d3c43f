//! From a solved wing to its summary and its files.

use crate::aero::Flow;
use crate::compare::Reading;
use crate::coupling::Engineering;
use crate::coupling::solution::Solution;
use crate::geometry::Planform;
use crate::input::Loaded;
use crate::mesh::Mesh;
use crate::observation::TwistProfile;
use crate::observation::field::twist_at_nodes;
use crate::program::MadeOf;
use crate::solve::SolvedDesign;
use crate::study::Uncertainty;

use crate::wing::{DiscretizationError, OtherEquilibrium, SolvedWing, WingModel};

use super::html::{self, REPORT};
use super::run::RunFolder;
use super::summary::{
    AssumedChoice, AssumedInput, CellLegend, FlowSummary, MeshSummary, Outcome, ProfileRow, RunSummary,
    SolveSummary, TipSummary, WingSummary, place_name,
};
use super::warnings::warnings;
use super::wing::{Legend, PARTS, Shape, displacement_mm, solution_grid};
use super::{ExportError, csv, pvd};

/// A solved wing and what was read from it.
#[derive(Debug, Clone, Copy)]
pub struct Solved<'a> {
    /// The wing and its loaded shape.
    pub wing: &'a SolvedWing,
    /// Profile, lift, and how far it is from the measurement.
    pub reading: &'a Reading,
    /// What the mesh leaves.
    pub mesh_error: &'a DiscretizationError,
    /// Another shape in which it rests under the same load, where one was found.
    pub other_equilibrium: Option<&'a OtherEquilibrium>,
    /// Band from the assumed ranges.
    pub uncertainty: Option<&'a Uncertainty>,
    /// What a builder wants to know besides.
    pub engineering: &'a Engineering,
}

impl<'a> Solved<'a> {
    /// Of a design.
    pub fn of(design: &'a SolvedDesign) -> Solved<'a> {
        Solved {
            wing: &design.wing,
            reading: &design.reading,
            mesh_error: &design.mesh_error,
            other_equilibrium: design.other_equilibrium.as_ref(),
            uncertainty: design.uncertainty.as_ref(),
            engineering: &design.engineering,
        }
    }
}

/// The summary of a solved wing, without files.
pub fn summarize(solved: &Solved) -> RunSummary {
    let SolvedWing { model, solution } = solved.wing;
    let WingModel { loaded, planform, .. } = model;
    let (design, reading) = (&loaded.design, solved.reading);
    let profile = &reading.profile;
    let legend = Legend::of(design);
    let mut summary = RunSummary {
        name: design.name.clone(),
        design_file: loaded.path.display().to_string(),
        design: design.clone(),
        assumed: assumed(loaded),
        assumed_choices: assumed_choices(loaded),
        wing: wing(planform),
        flow: Flow::from_design(design).map(|flow| air(&flow, design.air.density_kg_m3.value(), planform)),
        mesh: mesh(&solution.mesh, loaded),
        solve: solve(solution),
        profile: profile.readings.iter().map(ProfileRow::of).collect(),
        along_span: reading.along_span.iter().map(ProfileRow::of).collect(),
        skipped: skipped(profile),
        stages: reading.stages.clone(),
        measured: reading.measured.clone(),
        tip: tip(solved),
        lift: reading.lift.clone(),
        mesh_error: solved.mesh_error.clone(),
        other_equilibrium: solved.other_equilibrium.cloned(),
        stroke: None,
        engineering: solved.engineering.clone(),
        uncertainty: solved.uncertainty.cloned(),
        legend: CellLegend {
            part: PARTS.map(str::to_string).to_vec(),
            material: legend.materials.iter().map(|name| name.to_string()).collect(),
            section: legend.sections.into_iter().cloned().collect(),
        },
        warnings: Vec::new(),
        made_of: MadeOf::files(&loaded.files),
        files: Vec::new(),
    };
    summary.warnings = warnings(&summary);
    summary
}

/// Adds all files of a run to its folder; `summary.files` is filled with their names. `with_report`: the report too.
pub fn write_files(
    folder: &mut RunFolder,
    solved: &Solved,
    summary: &mut RunSummary,
    with_report: bool,
) -> Result<(), ExportError> {
    let SolvedWing { model, solution } = solved.wing;
    let design = model.design();
    let twist_deg = twist_at_nodes(&model.planform, solution);
    let twist_deg: Vec<f64> = twist_deg.into_iter().map(f64::to_degrees).collect();
    let series = [("wing-rest.vtu", Shape::Unloaded), ("wing.vtu", Shape::Deformed)];
    for (name, shape) in series {
        folder.add(
            name,
            &solution_grid(design, solution, twist_deg.clone(), shape).to_vtu()?,
        )?;
    }
    let steps = [0.0, 1.0]
        .into_iter()
        .zip(series.map(|(name, _)| name.to_string()));
    folder.add("wing.pvd", pvd::collection(&steps.collect::<Vec<_>>()).as_bytes())?;
    folder.add("profile.csv", &csv::profile(&summary.along_span)?)?;
    if !solution.strips.is_empty() {
        folder.add("strips.csv", &csv::strips(&solution.strips)?)?;
    }
    summary.files = folder.listed();
    if with_report {
        // Before the summary, which the report holds as it will be written.
        summary.files.insert(summary.files.len() - 1, REPORT.to_string());
        let page = html::run::of_files(summary, folder.target(), &|name| folder.read(name))?;
        folder.add(REPORT, page.html().as_bytes())?;
    }
    folder.add_summary(summary)
}

fn assumed(loaded: &Loaded) -> Vec<AssumedInput> {
    let assumptions = loaded.design.assumptions().into_iter();
    let input = assumptions.map(|assumption| AssumedInput {
        key: assumption.key,
        value: assumption.value,
        range: assumption.range,
        why: assumption.why,
    });
    input.collect()
}

fn assumed_choices(loaded: &Loaded) -> Vec<AssumedChoice> {
    let choices = loaded.design.assumed_choices().into_iter();
    let choice = choices.map(|choice| AssumedChoice {
        key: choice.key,
        value: choice.value,
        why: choice.why,
    });
    choice.collect()
}

fn wing(planform: &Planform) -> WingSummary {
    WingSummary {
        length_mm: planform.length_m() * 1e3,
        tip_mm: planform.tip_m() * 1e3,
        root_offset_mm: planform.root_offset_m() * 1e3,
        mean_chord_mm: planform.mean_chord_m() * 1e3,
        area_mm2: planform.area_m2() * 1e6,
        r1_hat: planform.r1_hat(),
        r2_hat: planform.r2_hat(),
    }
}

fn air(flow: &Flow, density_kg_m3: f64, planform: &Planform) -> FlowSummary {
    let root_angle_deg = flow.root_angle_rad().to_degrees();
    match *flow {
        Flow::Flapping {
            frequency_hz,
            half_amplitude_rad,
            phase_rad,
            ..
        } => FlowSummary::Flapping {
            frequency_hz,
            half_amplitude_deg: half_amplitude_rad.to_degrees(),
            phase_deg: phase_rad.to_degrees(),
            root_angle_deg,
            tip_speed_m_s: flow.velocity(planform.tip_m()).norm(),
            density_kg_m3,
        },
        Flow::Steady { speed_m_s, .. } => FlowSummary::Steady {
            speed_m_s,
            root_angle_deg,
            density_kg_m3,
        },
    }
}

fn mesh(mesh: &Mesh, loaded: &Loaded) -> MeshSummary {
    MeshSummary {
        nodes: mesh.nodes.len(),
        triangles: mesh.triangles.len(),
        beams: mesh.beams.len(),
        file: loaded.design.mesh.file.clone(),
    }
}

fn solve(solution: &Solution) -> SolveSummary {
    let report = &solution.report;
    let largest = |twist: &Vec<f64>| twist.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let history = report.twist_history_deg.iter().filter(|twist| !twist.is_empty());
    SolveSummary {
        outcome: Outcome::Converged,
        dof: report.dof,
        iterations: report.iterations,
        newton_steps: report.newton_steps,
        residual: report.residual,
        twist_change_deg: report.twist_change_deg,
        negative_pivots: report.negative_pivots,
        critical_pressure_ratio: report.critical_pressure_ratio,
        reaction_force_mn: report.reaction_force_n.map(|force| force * 1e3),
        reaction_moment_mn_mm: report.reaction_moment_n_m.map(|moment| moment * 1e6),
        largest_twist_deg: history.map(largest).collect(),
    }
}

fn skipped(profile: &TwistProfile) -> Vec<String> {
    let skipped = profile.skipped.iter();
    let sentence = skipped.map(|skipped| {
        let (station, reason) = (skipped.station, skipped.reason);
        format!(
            "{} at {:.2} mm: {reason}",
            place_name(station.place),
            station.r_m * 1e3
        )
    });
    sentence.collect()
}

fn tip(solved: &Solved) -> TipSummary {
    let SolvedWing { model, solution } = solved.wing;
    let observation = &model.design().observation;
    let reading = solved.reading.profile.tip();
    // The last node of the leading edge; a mesh without one has no tip to speak of.
    let node = solution.mesh.leading_edge.last().copied().unwrap_or_default();
    let moved = displacement_mm(&solution.rest, &solution.state);
    TipSummary {
        r_mm: observation.tip_station * model.planform.length_m() * 1e3,
        twist_deg: reading.map(|reading| reading.twist_rad.to_degrees()),
        alpha_deg: reading.and_then(|reading| reading.alpha_rad).map(f64::to_degrees),
        node,
        displacement_mm: moved.get(node).copied().unwrap_or_default(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::ModelledStages;
    use crate::export::run::read_summary;
    use crate::observation::imposed;
    use crate::observation::read_profile;

    /// A run of a wing with an imposed linear twist of 0.3 deg/mm, written below `target`.
    fn write(target: &std::path::Path) -> RunSummary {
        let design = imposed::design("");
        let (planform, mut solution) =
            imposed::wing(&design, |r_m| 300.0 * r_m.to_radians(), |r_m| [0.0, 0.1 * r_m]);
        let (triangles, beams) = (solution.mesh.triangles.len(), solution.mesh.beams.len());
        solution.pressure_pa = vec![1.0; triangles];
        solution.membrane_force_n_per_m = vec![[2.0, 1.0, 0.0]; triangles];
        solution.beam_force = vec![[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]; beams];
        let profile = read_profile(&design, &planform, &solution).expect("a profile");
        let reading = Reading {
            stages: ModelledStages::of(&profile),
            along_span: profile.readings.clone(),
            profile,
            lift: None,
            measured: None,
        };
        let model = WingModel {
            loaded: Loaded::alone(design),
            planform,
            mesh: solution.mesh.clone(),
        };
        let solved = Solved {
            wing: &SolvedWing::new(model, solution),
            reading: &reading,
            mesh_error: &DiscretizationError::default(),
            other_equilibrium: None,
            uncertainty: None,
            engineering: &Engineering::default(),
        };
        let mut summary = summarize(&solved);
        let mut folder = RunFolder::create(target, "solve").expect("a folder");
        write_files(&mut folder, &solved, &mut summary, true).expect("files");
        folder.commit().expect("a run");
        summary
    }

    #[test]
    fn the_summary_in_the_folder_is_the_one_that_was_made() {
        let parent = tempfile::tempdir().expect("a folder");
        let summary = write(&parent.path().join("run"));
        assert_eq!(
            read_summary(&parent.path().join("run")).expect("a summary"),
            summary
        );
        for name in &summary.files {
            assert!(parent.path().join("run").join(name).is_file(), "{name}");
        }
        assert_eq!(summary.files.last().map(String::as_str), Some("summary.json"));
    }

    #[test]
    fn an_imposed_twist_stands_in_profile_stages_and_tip() {
        let parent = tempfile::tempdir().expect("a folder");
        let summary = write(&parent.path().join("run"));
        let last = summary.profile.last().expect("a row");
        assert_eq!(last.place, "tip");
        assert!(
            (last.r_mm - 67.9).abs() < 1e-9 && (last.twist_deg - 0.3 * 67.9).abs() < 0.05,
            "{last:?}"
        );
        let fit = summary.stages.expect("stages");
        assert_eq!(fit.stages.len(), 1, "{fit:?}");
        assert!((fit.stages[0].rate_deg_per_mm - 0.3).abs() < 1e-3, "{fit:?}");
        assert!(
            (summary.tip.displacement_mm[2] - 6.93).abs() < 1e-9,
            "{:?}",
            summary.tip
        );
    }

    /// The text of an element of data in a page.
    fn embedded(page: &str, id: &str) -> serde_json::Value {
        let rest = page.split(&format!("id=\"{id}\">")).nth(1).expect("an element");
        serde_json::from_str(rest.split("</script>").next().expect("its end")).expect("JSON")
    }

    #[test]
    fn the_report_holds_the_summary_and_shows_its_numbers_as_they_stand_there() {
        let parent = tempfile::tempdir().expect("a folder");
        let summary = write(&parent.path().join("run"));
        let page = std::fs::read_to_string(parent.path().join("run/report.html")).expect("a report");
        let document = embedded(&page, "summary");
        assert_eq!(document, crate::export::json::document(&summary).expect("JSON"));
        let mut shown = 0;
        for piece in page.split("<data value=\"").skip(1) {
            let value = piece.split('"').next().expect("a value");
            let place = piece.split("data-of=\"").nth(1).expect("a place");
            let place = place.split('"').next().expect("a place");
            let text = piece.split('>').nth(1).and_then(|text| text.split('<').next());
            let found = document.pointer(place).unwrap_or_else(|| panic!("{place}"));
            assert_eq!(found.to_string(), value, "{place}");
            let (found, text) = (found.as_f64().expect("a number"), text.expect("text"));
            let read: f64 = text.parse().unwrap_or_else(|_| panic!("{place}: {text}"));
            assert!(
                (read - found).abs() <= 0.06 * found.abs() + 0.06,
                "{place}: {text} for {found}"
            );
            shown += 1;
        }
        assert!(shown > 100, "{shown} numbers");
        for row in 0..summary.profile.len() {
            assert!(
                page.contains(&format!("data-of=\"/profile/{row}/twist_deg\"")),
                "{row}"
            );
        }
        let wing = &embedded(&page, "wing-data")["wings"][0];
        assert_eq!(
            wing["triangles"].as_array().map(Vec::len),
            Some(3 * summary.mesh.triangles)
        );
    }

    #[test]
    fn equal_inputs_give_equal_bytes() {
        let parent = tempfile::tempdir().expect("a folder");
        let bytes = |name: &str| {
            let summary = write(&parent.path().join(name));
            let read = |file: &String| std::fs::read(parent.path().join(name).join(file)).expect("a file");
            summary.files.iter().map(read).collect::<Vec<_>>()
        };
        assert!(bytes("a") == bytes("b"));
    }
}
