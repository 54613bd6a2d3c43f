//! Effects, their numbers and made measurements that are refused: the message names the option or the file, what is allowed, the
//! cure.

use std::fs;
use std::path::Path;

use crate::hidden::{MANY, campaign};
use crate::washout;

/// The words on standard error of a run that must be refused as an input at fault.
fn refused(folder: &Path, arguments: &[&str], words: &[&str]) -> String {
    let said = washout(folder, arguments);
    assert_eq!(said.code, Some(2), "{arguments:?}: {}{}", said.out, said.err);
    for word in words {
        assert!(
            said.err.contains(word),
            "{arguments:?}: no '{word}' in\n{}",
            said.err
        );
    }
    said.err
}

/// A study of a rod on the bench whose values are yet to be measured.
fn planned() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), &MANY);
    folder
}

/// The same with values, as `made/study.toml`.
fn made(options: &[&str]) -> tempfile::TempDir {
    let folder = planned();
    let arguments = [&["synthesize", "study.toml", "--output", "made"], options].concat();
    let said = washout(folder.path(), &arguments);
    assert_eq!(said.code, Some(0), "{}", said.err);
    folder
}

fn replace(path: &Path, from: &str, to: &str) {
    let text = fs::read_to_string(path).unwrap();
    assert!(text.contains(from), "{text}");
    fs::write(path, text.replace(from, to)).unwrap();
}

#[test]
fn a_wrong_table_of_an_effect_is_refused_with_its_line() {
    let folder = planned();
    let rod = folder.path().join("rod.toml");
    let sound = fs::read_to_string(&rod).unwrap();
    let line = sound.lines().count() + 2;
    let tables = [
        (
            "root-flexure",
            "strength = -7",
            format!("rod.toml:{line}:12: effects.root-flexure.strength = -7: must lie in"),
        ),
        (
            "root-flexure",
            "strength = 'x'",
            format!("rod.toml:{line}:12: effects.root-flexure.strength = \"x\": must be a number"),
        ),
        (
            "mine",
            "kind = 'custom'\nacts_on = 'moment'\nstrength = 1\nexpression = '2 * x +'",
            format!("rod.toml:{}:14: effects.mine.expression", line + 3),
        ),
    ];
    for (name, table, words) in tables {
        fs::write(&rod, format!("{sound}[effects.{name}]\n{table}\n")).unwrap();
        refused(folder.path(), &["solve", "rod.toml"], &[&words]);
    }
    // what an option says stands nowhere in the file
    fs::write(&rod, format!("{sound}[effects.root-flexure]\nstrength = 0.3\n")).unwrap();
    let set = ["solve", "rod.toml", "--set", "effects.root-flexure.strength=-7"];
    refused(
        folder.path(),
        &set,
        &["rod.toml: effects.root-flexure.strength = -7: must lie in"],
    );
}

#[test]
fn an_effect_that_there_is_not_is_a_fault_of_the_option() {
    let folder = planned();
    for verb in [
        &["diagnose", "study.toml", "--plan"][..],
        &["blind", "2", "--study", "study.toml"],
    ] {
        let with = |name: &'static str| [verb, &["--effect", "tip-mass", "--effect", name]].concat();
        let near =
            ["--effect: there is no effect root-flexture; did you mean root-flexure? (washout effects)"];
        let said = refused(folder.path(), &with("root-flexture"), &near);
        assert!(!said.contains("study.toml"), "{said}");
        let far = [
            "--effect: there is no effect nonsense; there are rod-shear-modulus",
            "washout effects",
        ];
        refused(folder.path(), &with("nonsense"), &far);
    }
    assert!(!folder.path().join("output").exists());
}

#[test]
fn effects_that_cannot_be_are_left_out_and_the_answer_says_which() {
    let folder = planned();
    let plan = ["diagnose", "study.toml", "--plan", "--json"];
    let tried = |arguments: &[&str]| {
        let said = washout(folder.path(), arguments);
        assert_eq!(said.code, Some(0), "{}", said.err);
        let plan: serde_json::Value = serde_json::from_str(&said.out).unwrap();
        let rows = plan["effects"].as_array().unwrap().iter();
        let names: Vec<String> = rows.map(|row| row["effect"].to_string()).collect();
        (names, said.err)
    };
    let (all, _) = tried(&plan);
    let (by_option, said) = tried(&[&plan[..], &["--without", "root-flexure"]].concat());
    assert!(all.contains(&"\"root-flexure\"".to_string()) && by_option.len() == all.len() - 1);
    assert!(
        said.contains("root-flexure is not tried: it is excluded"),
        "{said}"
    );
    let study = folder.path().join("study.toml");
    replace(
        &study,
        "candidates =",
        "excluded = ['root-flexure']\ncandidates =",
    );
    assert_eq!(tried(&plan).0, by_option);
    let near = ["--without: there is no effect root-flexture; did you mean root-flexure?"];
    refused(
        folder.path(),
        &["diagnose", "study.toml", "--plan", "--without", "root-flexture"],
        &near,
    );
    let both = [
        &plan[..],
        &["--effect", "root-flexure", "--without", "root-flexure"],
    ];
    let both_ways = ["--without: root-flexure is asked for by --effect, too. Leave out one of the two"];
    refused(folder.path(), &both.concat(), &both_ways);
    replace(
        &study,
        "excluded = ['root-flexure']",
        "excluded = ['root-flexture']",
    );
    let place = [
        "excluded[0] = 'root-flexture': there is no such effect",
        "Did you mean root-flexure?",
    ];
    refused(folder.path(), &["diagnose", "study.toml", "--plan"], &place);
}

#[test]
fn candidates_that_there_are_not_are_refused_with_their_place_whatever_the_option_says() {
    let folder = planned();
    replace(
        &folder.path().join("study.toml"),
        "'root-flexure'",
        "'root-flexture'",
    );
    for verb in [
        &["diagnose", "study.toml", "--plan"][..],
        &["diagnose", "study.toml", "--plan", "--effect", "tip-mass"],
        &["blind", "2", "--study", "study.toml", "--effect", "tip-mass"],
    ] {
        let words = [
            "study.toml:4:36: candidates[1] = 'root-flexture': there is no such effect",
            "Did you mean root-flexure? (washout effects)",
        ];
        refused(folder.path(), verb, &words);
    }
}

#[test]
fn candidates_of_which_none_can_join_are_refused_by_that_key_or_option() {
    let lacking = "the model has large rotation already (structure.kinematics is not linear)";
    for (list, words) in [
        (
            "['large-rotation']",
            &["large-rotation cannot join the model: ", lacking][..],
        ),
        (
            "['large-rotation', 'film-slack']",
            &[
                "none of them can join the model: large-rotation: ",
                lacking,
                "film-slack: the wing has no film",
            ],
        ),
        ("[]", &["there is no effect in it"]),
    ] {
        let folder = planned();
        let both = "['rod-shear-modulus', 'root-flexure']";
        replace(&folder.path().join("study.toml"), both, list);
        let key = format!("study.toml:4:14: candidates = {list}: ");
        let all = [words, &[&key, "Name others in candidates", "delete candidates"]].concat();
        let said = refused(folder.path(), &["diagnose", "study.toml", "--plan"], &all);
        assert!(!said.contains("[effects]"), "{said}");
        refused(folder.path(), &["blind", "2", "--study", "study.toml"], &all);
    }
    let folder = planned();
    let arguments = ["diagnose", "study.toml", "--plan", "--effect", "large-rotation"];
    let words = [
        "--effect: study.toml: large-rotation cannot join the model: ",
        lacking,
        "or name none",
    ];
    refused(folder.path(), &arguments, &words);
    let with = fs::read_to_string(folder.path().join("study.toml")).unwrap()
        + "[[effect]]\nname = 'root-flexure'\nstrength = 0.1\n";
    fs::write(folder.path().join("with.toml"), with).unwrap();
    let arguments = ["diagnose", "with.toml", "--plan", "--effect", "root-flexure"];
    let words = ["root-flexure cannot join the model: it stands in the study already ([[effect]])"];
    refused(folder.path(), &arguments, &words);
}

#[test]
fn bad_numbers_of_an_added_effect_name_the_option_and_what_is_allowed() {
    let folder = made(&[]);
    let whole = fs::read_to_string(folder.path().join("made/study.toml")).unwrap();
    for (effect, numbers, words) in [
        (
            "rod-split",
            &["form=0.5"][..],
            &[
                "rod-split has no number form, did you mean from?",
                "from in 0 … 1 (plausible 0 … 0.95)",
            ][..],
        ),
        (
            "rod-split",
            &["from=1.5"],
            &[
                "1.5 is out of range",
                "from in 0 … 1 (plausible 0 … 0.95): station from which it is split",
            ],
        ),
        (
            "rod-split",
            &["from=nan"],
            &["nan is out of range; give from in 0 … 1"],
        ),
        (
            "rod-split",
            &["from=half"],
            &["'half' is no number; give from in 0 … 1"],
        ),
        ("rod-split", &["0.5"], &["is not NAME=VALUE, such as from="]),
        (
            "rod-split",
            &["strength=0.5"],
            &["the strength is fitted; leave it out"],
        ),
        ("rod-split", &["from=0.5", "from=0.6"], &["from is given twice"]),
        (
            "rod-shear-modulus",
            &["from=0.5"],
            &["rod-shear-modulus has no number but its strength, which is fitted"],
        ),
    ] {
        let mut arguments = vec!["add", effect, "--to", "made/study.toml"];
        arguments.extend(numbers.iter().flat_map(|number| ["--number", number]));
        let option = format!("--number: {}: ", numbers[numbers.len() - 1]);
        let said = refused(folder.path(), &arguments, &[words, &[&option]].concat());
        assert!(!said.contains("case"), "{said}");
    }
    let arguments = ["add", "rod-splt", "--to", "made/study.toml"];
    refused(
        folder.path(),
        &arguments,
        &[
            "there is no effect rod-splt; did you mean rod-split?",
            "--own FILE",
        ],
    );
    let arguments = ["add", "rod-split", "--to", "made/study.toml", "--on", "rodd"];
    refused(
        folder.path(),
        &arguments,
        &["--on: there is no wing rodd in made/study.toml, did you mean rod?"],
    );
    assert_eq!(
        fs::read_to_string(folder.path().join("made/study.toml")).unwrap(),
        whole
    );
}

#[test]
fn a_broken_table_of_ones_own_names_its_file_line_and_key() {
    let folder = made(&[]);
    let good =
        "# mine\n[effects.seam]\nkind = 'custom'\nacts_on = 'torsion'\nexpression = '1 + k * x'\nk = 0.5\n";
    for (from, to, words) in [
        (
            "'torsion'",
            "'torsoin'",
            &[
                "own.toml:4:11: effects.seam.acts_on = 'torsoin': ",
                "Write one of moment, force",
            ][..],
        ),
        (
            "acts_on = 'torsion'\n",
            "",
            &["own.toml:2:1: effects.seam.acts_on: '' is nothing it can act on"],
        ),
        (
            "k * x",
            "k * z",
            &["own.toml:5:14: effects.seam.expression = '1 + k * z': column 9 of the formula: "],
        ),
        (
            "1 + k * x",
            "1 + x",
            &["own.toml:6:5: effects.seam.k = 0.5: the formula does not use it"],
        ),
        (
            "k * x",
            "k / 0",
            &["effects.seam.expression = '1 + k / 0': it is inf at x = 0.00"],
        ),
        (
            "k = 0.5",
            "k = 0.5\nstrength = 'full'",
            &["own.toml:7:12: effects.seam.strength = 'full': must be a number"],
        ),
        (
            "'custom'",
            "'costum'",
            &["own.toml:3:8: effects.seam.kind = 'costum': "],
        ),
    ] {
        assert!(good.contains(from));
        fs::write(folder.path().join("own.toml"), good.replace(from, to)).unwrap();
        for verb in [
            &["add", "seam", "--to", "made/study.toml"][..],
            &["synthesize", "study.toml", "--output", "again"],
        ] {
            let said = refused(
                folder.path(),
                &[verb, &["--own", "own.toml"]].concat(),
                &[words, &["--own: own.toml:"]].concat(),
            );
            assert!(!said.contains("case"), "{said}");
        }
    }
    fs::write(folder.path().join("own.toml"), good).unwrap();
    let arguments = ["add", "seem", "--to", "made/study.toml", "--own", "own.toml"];
    refused(
        folder.path(),
        &arguments,
        &["--own: own.toml has no table [effects.seem], only seam; did you mean seam?"],
    );
    fs::write(
        folder.path().join("own.toml"),
        good.replace("seam", "root-flexure"),
    )
    .unwrap();
    let arguments = [
        "add",
        "root-flexure",
        "--to",
        "made/study.toml",
        "--own",
        "own.toml",
    ];
    refused(
        folder.path(),
        &arguments,
        &["own.toml:2:1: effects.root-flexure: there is an effect of this name already"],
    );
    assert!(!folder.path().join("again").exists());
}

/// A whole number is a strength as good as any other.
#[test]
fn the_strength_of_ones_own_effect_is_taken_as_it_stands() {
    let folder = planned();
    let own = "[effects.seam]\nkind = 'custom'\nacts_on = 'torsion'\nexpression = '1 + x'\nstrength = 2\n";
    fs::write(folder.path().join("own.toml"), own).unwrap();
    let arguments = [
        "synthesize",
        "study.toml",
        "--own",
        "own.toml",
        "--output",
        "made",
    ];
    assert_eq!(washout(folder.path(), &arguments).code, Some(0));
    let answer = fs::read_to_string(folder.path().join("made/answer.json")).unwrap();
    let answer: serde_json::Value = serde_json::from_str(&answer).unwrap();
    assert_eq!(answer["acted"][0]["strength"], 2.0, "{answer}");
}

#[test]
fn what_cannot_be_hidden_names_the_option_the_value_and_the_range() {
    let folder = planned();
    for (effect, words) in [
        (
            "root-flexure=-1",
            &[
                "--effect: root-flexure: strength -1 is outside 0 to 1000; plausible is 0 to 0.3 (compliance of the root",
                "washout effects root-flexure",
            ][..],
        ),
        (
            "rod-split@rod=20",
            &["--effect: rod-split: strength 20 is outside 0 to 12; plausible is 0 to 2.7"],
        ),
        (
            "stop-backlash=90",
            &["strength 90 is outside 0 to 45 deg; plausible is 0 to 5 deg"],
        ),
        (
            "root-flexture=0.1",
            &[
                "--effect: root-flexture: there is no such effect; ",
                "did you mean root-flexure?",
            ],
        ),
        ("film-slack=0.1", &["--effect: film-slack: acts on none"]),
        (
            "rod-split@rot=0.1",
            &["--effect: rod-split: there is no wing rot"],
        ),
    ] {
        let arguments = ["synthesize", "study.toml", "--effect", effect, "--output", "made"];
        refused(folder.path(), &arguments, words);
    }
    assert!(!folder.path().join("made").exists());
}

#[test]
fn what_is_not_in_a_study_cannot_be_taken_out_and_what_is_there_is_listed() {
    let folder = made(&[]);
    let take = |name: &'static str| ["add", name, "--to", "made/study.toml", "--remove"];
    let words = ["--remove: root-flexure is not in made/study.toml; there is no effect in it"];
    refused(folder.path(), &take("root-flexure"), &words);
    let study = folder.path().join("made/study.toml");
    let text = fs::read_to_string(&study).unwrap();
    let effect = |name: &str| format!("[[effect]]\nname = '{name}'\nstrength = 0.1\n");
    fs::write(&study, text + &effect("root-flexure") + &effect("tip-mass")).unwrap();
    let words = [
        "--remove: root-flexur is not in made/study.toml, did you mean root-flexure?",
        "in it: root-flexure, tip-mass",
    ];
    refused(folder.path(), &take("root-flexur"), &words);
    let design = folder.path().join("rod.toml");
    let text = fs::read_to_string(&design).unwrap();
    fs::write(&design, text + "[effects.rod-split]\nstrength = 0.1\n").unwrap();
    let words = [
        "rod-split stands in the design",
        "rod.toml",
        "delete its table [effects.rod-split]",
    ];
    refused(folder.path(), &take("rod-split"), &words);
    assert!(!folder.path().join("output").exists());
}

#[test]
fn made_measurements_whose_word_cannot_be_read_do_not_pass_for_nature() {
    let folder = made(&["--seed", "7"]);
    let file = folder.path().join("made/m.csv");
    let good = fs::read_to_string(&file).unwrap();
    let line = "made by washout synthesize: mesh 1.25, formulas other, background 0.01, seed 7";
    let diagnose = ["diagnose", "made/study.toml", "--seed", "7"];
    for (to, wrong) in [
        (
            line.replace("seed 7", "seed seven"),
            "has seed 'seven', which is no whole number from 0 on",
        ),
        (line.replace("mesh 1.25, ", ""), "has no mesh"),
        (
            line.replace("other", "mine"),
            "has formulas 'mine', which is neither other nor same",
        ),
        (
            line.replace(':', " and mended by hand:"),
            "does not go on as 'made by washout synthesize: mesh …'",
        ),
    ] {
        fs::write(&file, good.replace(line, &to)).unwrap();
        let words = [
            "made/m.csv:1: the comment 'made by washout synthesize' ",
            wrong,
            "Restore the line as washout wrote it, e.g. # made by washout synthesize: mesh 1.25",
        ];
        refused(folder.path(), &diagnose, &words);
        refused(folder.path(), &["compare", "made/study.toml"], &words);
    }
    // below the columns it is believed as at the head; without it, or with another comment, the data are nature's
    let without = good.replace(&format!("# {line}\n"), "");
    fs::write(&file, format!("{without}# {line}\n")).unwrap();
    refused(folder.path(), &diagnose, &["the same seed (seed 7)"]);
    for head in ["", "# made by hand\n", "# not made by washout synthesize\n"] {
        fs::write(&file, format!("{head}{without}")).unwrap();
        let said = washout(folder.path(), &diagnose);
        assert_eq!(said.code, Some(0), "{head}: {}", said.err);
    }
}

#[test]
fn all_that_made_data_have_in_common_with_the_diagnosis_is_told() {
    let folder = made(&[
        "--seed",
        "1",
        "--mesh",
        "1",
        "--background",
        "0",
        "--same-formulas",
    ]);
    let words = [
        "made/study.toml: made/m.csv was made by washout synthesize with the same meshes (mesh 1), the same formulas (formulas \
         same), the same outline, stiffness and air law (background 0) and the same seed (seed 1) as this diagnosis has: finding \
         the answer there would prove nothing",
        "Make the measurements anew with --mesh 1.25, no --same-formulas, --background 0.01 and --seed 2 (washout synthesize)",
        "or diagnose them all the same: washout diagnose made/study.toml --own-data",
    ];
    refused(folder.path(), &["diagnose", "made/study.toml"], &words);
    let some = ["with the same meshes (mesh 1), the same formulas (formulas same) and the same outline"];
    let said = refused(
        folder.path(),
        &["diagnose", "made/study.toml", "--seed", "5"],
        &some,
    );
    assert!(!said.contains("the same seed"), "{said}");
}
