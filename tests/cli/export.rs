//! `washout export`.

use std::fs;
use std::path::Path;

use crate::{Said, conforms, design, entries, folder, schema, washout};

/// Solves twist-v2 into `run` on a coarse mesh, with changes.
fn solve(here: &Path, sets: &[&str]) -> Said {
    let design = design("twist-v2.toml");
    let mut arguments = vec![
        "solve", &design, "--refine", "0.5", "--output", "run", "--json", "--quiet",
    ];
    for set in sets {
        arguments.extend(["--set", set]);
    }
    washout(here, &arguments)
}

fn export(here: &Path) -> Said {
    washout(here, &["export", "--to", "calculix", "run", "--json", "--quiet"])
}

/// Numbered lines after each line that begins with `keyword`.
fn block<'d>(deck: &'d str, keyword: &str) -> Vec<Vec<&'d str>> {
    let (mut inside, mut lines) = (false, Vec::new());
    for line in deck.lines() {
        if line.starts_with('*') {
            inside = line.starts_with(keyword);
        } else if inside {
            lines.push(line.split(',').collect());
        }
    }
    lines
}

#[test]
fn the_deck_holds_the_loads_that_the_support_carries_and_goes_away_with_its_run() {
    let here = folder();
    let solved = solve(here.path(), &["film.compression=carries"]).document();
    let said = export(here.path());
    assert_eq!(said.code, Some(0), "{}", said.err);
    conforms(&said.document(), &schema(&["--output", "export"]));
    let target = here.path().join("run/calculix");
    assert_eq!(entries(&target), ["edges.csv", "summary.json", "wing.inp"]);
    let deck = fs::read_to_string(target.join("wing.inp")).expect("a deck");
    for (k, reaction) in solved["solve"]["reaction_force_mn"]
        .as_array()
        .expect("a force")
        .iter()
        .enumerate()
    {
        let of_axis = block(&deck, "*CLOAD")
            .into_iter()
            .filter(|line| line[1] == (k + 1).to_string());
        let sum: f64 = of_axis
            .map(|line| line[2].parse::<f64>().expect("a number"))
            .sum();
        let reaction = reaction.as_f64().expect("a number");
        assert!((1e3 * sum + reaction).abs() < 1e-4, "{k} {sum} {reaction}");
    }
    let triangles = solved["mesh"]["triangles"].as_u64().expect("a count") as usize;
    assert_eq!(block(&deck, "*ELEMENT,TYPE=S6").len(), triangles);
    // only the half-round rod's coupling has no counterpart
    assert_eq!(said.document()["left_out"].as_array().expect("a list").len(), 1);
    assert_eq!(solve(here.path(), &[]).code, Some(0));
    assert!(!target.exists());
}

#[test]
fn a_skin_that_gives_way_is_said_to_be_left_out() {
    let here = folder();
    let sets = ["film.compression=carries", "effects.skin-yielding.strength=0.2"];
    assert_eq!(solve(here.path(), &sets).code, Some(0));
    let said = export(here.path()).document();
    assert!(
        said["left_out"].to_string().contains("skin"),
        "{}",
        said["left_out"]
    );
}

#[test]
fn a_film_with_pretension_is_cooled_to_it_in_a_step_of_its_own() {
    let here = folder();
    solve(here.path(), &["film.pretension_n_per_m=10"]);
    let said = export(here.path());
    assert_eq!(said.document()["cured"], true);
    let deck = fs::read_to_string(here.path().join("run/calculix/wing.inp")).expect("a deck");
    assert_eq!(deck.matches("*STEP").count(), 2);
    let cooling: f64 = block(&deck, "*TEMPERATURE")[0][1].parse().expect("a number");
    // N (1 − ν)/(E t) of 10 N/m in 6 µm of Kapton, at 1e-5 per degree
    assert!(
        (cooling + 10.0 * 0.66 / (2.5e9 * 6e-6) * 1e5).abs() < 1e-6,
        "{cooling}"
    );
}

#[test]
fn what_has_no_counterpart_and_runs_of_other_inputs_are_refused() {
    let here = folder();
    let solved = solve(here.path(), &["root.pitch_stiffness_n_m_per_rad=0.01"]);
    assert_eq!(solved.code, Some(0), "{}", solved.err);
    let said = export(here.path());
    assert_eq!(said.code, Some(2));
    assert!(said.err.contains("root.pitch_stiffness"), "{}", said.err);
    assert!(!here.path().join("run/calculix").exists());
    let here = folder();
    solve(here.path(), &[]);
    let file = here.path().join("run/summary.json");
    let text = fs::read_to_string(&file).expect("a summary");
    fs::write(
        &file,
        text.replace("\"frequency_hz\": 23.0", "\"frequency_hz\": 22.0"),
    )
    .expect("written");
    let said = export(here.path());
    assert_eq!(said.code, Some(2));
    assert!(said.err.contains("another tip displacement"), "{}", said.err);
}

#[test]
fn the_model_part_for_kratos_holds_the_same_loads_and_the_shape_node_by_node() {
    let here = folder();
    let solved = solve(here.path(), &["film.compression=carries"]).document();
    let said = washout(
        here.path(),
        &["export", "--to", "kratos", "run", "--json", "--quiet"],
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
    conforms(&said.document(), &schema(&["--output", "export"]));
    let target = here.path().join("run/kratos");
    assert_eq!(
        entries(&target),
        ["edges.csv", "shape.csv", "summary.json", "wing.mdpa"]
    );
    let part = fs::read_to_string(target.join("wing.mdpa")).expect("a model part");
    let rows = |head: &str| -> Vec<Vec<&str>> {
        let inside = part.lines().skip_while(|line| *line != format!("Begin {head}"));
        let rows = inside.skip(1).take_while(|line| !line.starts_with("End"));
        rows.map(|line| line.split_whitespace().collect()).collect()
    };
    let reaction = solved["solve"]["reaction_force_mn"].as_array().expect("a force");
    for (axis, reaction) in ["X", "Y", "Z"].into_iter().zip(reaction) {
        let loads = rows(&format!("NodalData POINT_LOAD_{axis}"));
        let sum: f64 = loads
            .iter()
            .map(|row| row[2].parse::<f64>().expect("a number"))
            .sum();
        let reaction = reaction.as_f64().expect("a number");
        assert!((1e3 * sum + reaction).abs() < 1e-4, "{axis} {sum} {reaction}");
    }
    let nodes = rows("Nodes").len();
    let triangles = solved["mesh"]["triangles"].as_u64().expect("a count") as usize;
    assert_eq!(rows("Elements ShellThinElementCorotational3D3N").len(), triangles);
    // the rod's base, clamped
    assert_eq!(rows("NodalData ROTATION_X").len(), 1);
    let shape = fs::read_to_string(target.join("shape.csv")).expect("a shape");
    assert_eq!(shape.lines().count(), nodes + 1);
}
