//! Video files and marks that must be refused, each with its whole message.

use std::fs;

use washout::input::video::LoadedVideo;

const SPAN: &str = "[view]\nalong = 'span'\nwashout = 'clockwise'\n";
const HEAD: &str = "frame,r_mm,mark,x_px,y_px,repeat,chord_mm\n";
const REST: &str = "rest,20,leading,10,10,,\nrest,20,trailing,110,10,,\n";
const HIT: &str = "hit,20,leading,10,10,,\nhit,20,trailing,110,20,,\n";

fn loaded(video: &str, marks: &str) -> Result<LoadedVideo, String> {
    let folder = tempfile::tempdir().unwrap();
    let text = format!("format = 1\nname = 'v'\nmarks = 'm.csv'\n{video}");
    fs::write(folder.path().join("v.toml"), text).unwrap();
    fs::write(folder.path().join("m.csv"), format!("{HEAD}{marks}")).unwrap();
    let shown = format!("{}/", folder.path().display());
    LoadedVideo::load(&folder.path().join("v.toml")).map_err(|error| error.to_string().replace(&shown, ""))
}

#[test]
fn a_sound_video_is_read_and_repeats_are_averaged() {
    let marks = format!("{REST}hit,20,leading,10,10,1,\nhit,20,leading,12,11,2,\nhit,20,trailing,110,20,,\n");
    let video = loaded(&format!("rest = 'rest'\n{SPAN}"), &marks).unwrap_or_else(|error| panic!("{error}"));
    let leading = &video.frames[0].stations[0].leading;
    assert_eq!((leading.x_px, leading.y_px, leading.clicks), (11.0, 10.5, 2));
    assert_eq!(leading.scatter_px2, 2.5);
    assert_eq!(video.rest.map(|rest| rest.stations.len()), Some(1));
}

#[test]
fn bad_videos_are_refused_with_place_value_and_cure() {
    let with_rest = format!("rest = 'rest'\nsigma_px = 0.5\n{SPAN}");
    let stroke = "sigma_px = 0.5\n[view]\nalong = 'stroke'\nroot_angle_deg = 45\n";
    let both = format!("{REST}{HIT}");
    let cases: &[(&str, &str, &str)] = &[
        (
            "sigma_px = 0.5\n[view]\nalong = 'span'\n",
            &both,
            "v.toml:5:1: view.washout is missing.\n  Write washout = \"counterclockwise\" where a trailing edge that washes out \
             turns against the clock about the leading edge in the frame, or \"clockwise\"",
        ),
        (
            "sigma_px = 0.5\n[view]\nalong = 'stroke'\n",
            &both,
            "v.toml:5:1: view.root_angle_deg is missing.\n  Give the angle of attack of the untwisted chord, e.g. \
             root_angle_deg = 45.0",
        ),
        (
            "sigma_px = 0.5\n[view]\nalong = 'stroke'\nroot_angle_deg = 1.0\n",
            &both,
            "v.toml:7:18: view.root_angle_deg = 1.0: shows only 1.7 % of the untwisted chord.\n  Look along the other line: \
             see docs/from-video-to-twist.md",
        ),
        (
            "sigma_px = 0.5\n[view]\nalong = 'stroke'\nroot_angle_deg = 45.0\nwashout = 'clockwise'\n",
            &both,
            "v.toml:8:11: view.washout = 'clockwise': does not belong to this view.\n  Delete it: it belongs to along = \
             \"span\"; here the length of the chord in the frame is read",
        ),
        (
            &format!("rest = 'still'\nsigma_px = 0.5\n{SPAN}"),
            &both,
            "v.toml:4:8: rest = 'still': there is no such frame.\n  The frames of m.csv are rest, hit",
        ),
        (
            &format!("rest = 'rest'\n{SPAN}"),
            &both,
            "v.toml: sigma_px is missing, and no mark was clicked twice at different places.\n  Give the standard deviation of \
             a click, e.g. sigma_px = 0.5, or click each mark several times and number the clicks in the column repeat",
        ),
        (
            &format!("sigma_px = 0.5\n{SPAN}"),
            HIT,
            "v.toml: rest is missing, and the frames show no reference points: nothing says what untwisted is.\n  Name the \
             frame that shows the wing untwisted, or click reference_a and reference_b on a line along the untwisted chord, from \
             leading to trailing edge",
        ),
        (
            stroke,
            &format!("{HIT}hit,,reference_a,0,0,,\nhit,,reference_b,100,0,,\n"),
            "v.toml: references.distance_mm is missing.\n  Give the distance between the reference points, or name the frame \
             that shows the wing untwisted",
        ),
        (
            &stroke.replace("[view]", "references = { distance_mm = 50 }\n[view]"),
            &format!("{HIT}hit,,reference_a,0,0,,\nhit,,reference_b,100,0,,\n"),
            "m.csv:2: chord_mm is missing.\n  Give the chord at the station in a column chord_mm; without a frame of the \
             untwisted wing it says how much of the chord the frame shows",
        ),
        (
            &with_rest,
            REST,
            "v.toml:3:9: marks = 'm.csv': there is no frame besides rest.\n  Add marks of a frame that shows the wing under load",
        ),
        (
            &with_rest,
            &format!("{both}hit,,reference_a,0,0,,\nhit,,reference_b,100,0,,\n"),
            "v.toml:3:9: marks = 'm.csv': frame rest has no reference points, frame hit has.\n  Click reference_a and \
             reference_b in every frame, or in none",
        ),
        (
            &with_rest,
            &format!("{both}hit,40,leading,10,10,,\n"),
            "m.csv:6: mark = leading: has no trailing beside it in frame hit.\n  Click trailing there too, or delete this row",
        ),
        (
            &with_rest,
            &format!("{both}hit,40,leading,10,10,,\nhit,40,trailing,10.2,10.3,,\n"),
            "m.csv:6: mark = leading: lies on the mark of line 7.\n  Two points less than a pixel apart have no direction; check \
             the coordinates, or leave the station out",
        ),
        (
            &with_rest,
            &format!("{both}hit,40,leading,10,10,,\nhit,40,trailing,110,30,,\n"),
            "m.csv:6: r_mm = 40: frame rest has no marks at this station.\n  Click both edges there too, or leave the station out",
        ),
        (
            &with_rest,
            &format!("{both}hit,20,leading,11,10,,\n"),
            "m.csv:6: mark = leading: was clicked already on line 4.\n  Delete one of them, or number the repeats in the column \
             repeat",
        ),
        (
            &with_rest,
            &format!("{both}hit,20,ledge,11,10,,\n"),
            "m.csv:6: mark = ledge: must be one of leading, trailing, reference_a, reference_b.\n  Say which point was clicked: \
             that on the leading edge, ...",
        ),
        (
            &with_rest,
            &format!("{both}\"a,b\",20,leading,11,10,,\n"),
            "m.csv:6: frame = a,b: is no name.\n  Use letters, digits, -, _ and . only: the name becomes that of the measured case",
        ),
        (
            &with_rest,
            &format!("{both}hit,20,leading,NaN,10,7,\n"),
            "m.csv:6: x_px = NaN: must be a finite number.\n  Give the pixel coordinate, x to the right and y down, e.g. 512.5",
        ),
    ];
    let mut wrong = Vec::new();
    for (video, marks, expected) in cases {
        let found = loaded(video, marks).err().unwrap_or_default();
        if found != *expected {
            wrong.push(format!("expected {expected}\n   found {found}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}
