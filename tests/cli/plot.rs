//! `washout plot`: pictures of a run for print.

use std::fs;

use crate::{below, conforms, design, entries, folder, schema, washout};

#[test]
fn a_run_is_drawn_for_print_as_wide_and_as_fine_as_asked() {
    let here = folder();
    let run = |arguments: &[&str]| washout(here.path(), arguments);
    let solved = run(&["solve", &design("twist-v2.toml"), "--refine", "0.5", "--quiet"]);
    assert_eq!(solved.code, Some(0), "{}", solved.err);
    let listed = run(&["plot", "output/twist-v2", "--list"]);
    assert_eq!(
        (listed.code, listed.out.as_str()),
        (Some(0), "wing\ntwist\nair\n")
    );
    assert_eq!(entries(&here.path().join("output")), ["twist-v2"]);

    let made = run(&[
        "plot",
        "output/twist-v2",
        "--width-mm",
        "85",
        "--dpi",
        "300",
        "--json",
    ]);
    assert_eq!(made.code, Some(0), "{}", made.err);
    conforms(&made.document(), &schema(&["--output", "plot"]));
    let target = here.path().join("output/twist-v2-plots");
    let expected = [
        "air.png",
        "air.svg",
        "plot.json",
        "twist.png",
        "twist.svg",
        "wing.png",
        "wing.svg",
    ];
    assert_eq!(entries(&target), expected);
    for name in ["air", "twist", "wing"] {
        let svg = fs::read_to_string(target.join(format!("{name}.svg"))).expect("a picture");
        assert!(svg.starts_with("<svg xmlns="), "{name}");
        assert!(
            svg[..300].contains("width=\"85.00mm\""),
            "{name}: {}",
            &svg[..300]
        );
        let png = fs::read(target.join(format!("{name}.png"))).expect("a picture");
        assert!(png.starts_with(b"\x89PNG\r\n\x1a\n"), "{name}");
        // the head of a PNG: width and height as big-endian numbers from byte 16 on; 85 mm at 300 dpi
        let width = u32::from_be_bytes(png[16..20].try_into().expect("four bytes"));
        assert_eq!(width, 1004, "{name}");
    }

    let one = run(&[
        "plot",
        "output/twist-v2",
        "--only",
        "twist",
        "--to",
        "png",
        "--output",
        "print",
    ]);
    assert_eq!(one.code, Some(0), "{}", one.err);
    assert_eq!(entries(&here.path().join("print")), ["plot.json", "twist.png"]);
}

#[test]
fn the_pictures_of_a_run_that_is_no_solved_wing_are_those_that_stand_in_it() {
    let here = folder();
    let wing = design("rigid.toml");
    let run = |arguments: &[&str]| washout(here.path(), arguments);
    let lift = run(&["lift", &wing, "--set", "mesh.refine=0.2", "--output", "lift"]);
    assert_eq!(lift.code, Some(0), "{}", lift.err);
    let listed = run(&["plot", "lift", "--list"]);
    assert_eq!((listed.code, listed.out.as_str()), (Some(0), "span\nstroke\n"));
    let refused = run(&["diff", "lift", "lift"]);
    assert_eq!(refused.code, Some(2));
    let words =
        "lift/summary.json is of a run of `washout lift`; here belongs a run that washout solve wrote";
    assert!(refused.err.contains(words), "{}", refused.err);
}

#[test]
fn what_cannot_be_drawn_ends_with_2_and_says_what_to_give() {
    let here = folder();
    let refused = |arguments: &[&str], words: &str| {
        let said = washout(here.path(), arguments);
        assert_eq!(
            (said.code, said.out.as_str()),
            (Some(2), ""),
            "{arguments:?}: {}",
            said.err
        );
        assert!(said.err.contains(words), "{words:?} is not in\n{}", said.err);
    };
    refused(&["plot", "nowhere"], "give the folder that washout solve");
    refused(
        &["plot", &design("rigid.toml")],
        "give the folder that washout solve",
    );
    refused(&["plot", &below(here.path(), "")], "a folder without pictures");
    fs::write(
        here.path().join("one.svg"),
        "<svg viewBox=\"0 0 10 10\"><path d=\"M0 0L9 9\" stroke=\"#000\"/></svg>",
    )
    .expect("a file");
    let here_itself = below(here.path(), "");
    refused(&["plot", &here_itself, "--only", "two"], "there are one");
    refused(&["plot", &here_itself, "--dpi", "NaN"], "--dpi");
    refused(&["plot", &here_itself, "--width-mm", "5"], "give 10 to 2000");
    refused(
        &["plot", &here_itself, "--width-mm", "2000", "--dpi", "2400"],
        "ask for less width or a lower resolution",
    );
    assert_eq!(entries(here.path()), ["one.svg"]);
}
