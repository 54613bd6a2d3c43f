//! A video file and its marks, as `washout live` writes what was clicked; `washout measure` reads them.

use std::fmt::Write;

use crate::input::video::{Click, Video};

/// The description: how the camera stood, and where the marks are.
pub fn video_toml(video: &Video) -> String {
    let keys = toml::to_string(video).unwrap_or_default();
    format!(
        "# Frames of a video that were marked with washout live: how the camera stood. All keys: washout schema --video\n#\n\
         #   washout measure {}.toml\n\n{keys}",
        video.name
    )
}

/// The clicks, sorted by frame (in the order of `frames`), station and edge; clicks on the same point are numbered.
pub fn marks_csv(clicks: &[Click], frames: &[String]) -> String {
    let place = |click: &Click| frames.iter().position(|name| *name == click.frame);
    let mut sorted: Vec<&Click> = clicks.iter().collect();
    // stable: clicks on one point stay in the order in which they were made
    sorted.sort_by(|a, b| {
        let station = |click: &Click| click.r_mm.unwrap_or(f64::NEG_INFINITY);
        (place(a).cmp(&place(b)))
            .then(station(a).total_cmp(&station(b)))
            .then(a.mark.cmp(&b.mark))
    });
    let has_chord = clicks.iter().any(|click| click.chord_mm.is_some());
    let mut text = "# Marks clicked with washout live. Pixels: x to the right, y down.\nframe,r_mm,mark,x_px,y_px,repeat".to_string();
    text += if has_chord { ",chord_mm\n" } else { "\n" };
    let optional = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
    let (mut repeat, mut before): (usize, Option<&Click>) = (0, None);
    for click in sorted {
        repeat = match before {
            Some(before) if click.is_repeat_of(before) => repeat + 1,
            _ => 1,
        };
        before = Some(click);
        let _ = write!(
            text,
            "{},{},{},{},{},{repeat}",
            click.frame,
            optional(click.r_mm),
            click.mark.name(),
            click.x_px,
            click.y_px
        );
        if has_chord {
            let _ = write!(text, ",{}", optional(click.chord_mm));
        }
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::video::{Along, LoadedVideo, View, Which};

    fn click(frame: &str, r_mm: f64, mark: Which, at: [f64; 2]) -> Click {
        Click {
            frame: frame.to_string(),
            r_mm: Some(r_mm),
            mark,
            x_px: at[0],
            y_px: at[1],
            chord_mm: None,
        }
    }

    #[test]
    fn what_is_written_is_read_back_whatever_the_order_of_the_clicks() {
        let video = Video {
            format: 1,
            name: "try".to_string(),
            source: "a \"bench\"\nin May".to_string(),
            marks: "try-marks.csv".to_string(),
            rest: Some("rest".to_string()),
            sigma_px: Some(0.5),
            view: View {
                along: Along::Stroke,
                washout: None,
                zero_sigma_deg: None,
                root_angle_deg: Some(45.0),
                root_angle_sigma_deg: None,
            },
            references: None,
        };
        let clicks = [
            click("mid", 10.0, Which::Trailing, [10.25, 40.0]),
            click("rest", 10.0, Which::Leading, [10.0, 0.0]),
            click("mid", 10.0, Which::Leading, [10.0, 0.5]),
            click("rest", 10.0, Which::Trailing, [10.0, 50.0]),
            click("rest", 10.0, Which::Trailing, [10.0, 51.0]),
        ];
        let frames = ["rest".to_string(), "mid".to_string()];
        let (toml, csv) = (video_toml(&video), marks_csv(&clicks, &frames));
        let lines: Vec<&str> = csv.lines().skip(2).collect();
        assert_eq!(
            lines,
            [
                "rest,10,leading,10,0,1",
                "rest,10,trailing,10,50,1",
                "rest,10,trailing,10,51,2",
                "mid,10,leading,10,0.5,1",
                "mid,10,trailing,10.25,40,1"
            ]
        );
        let read = LoadedVideo::read(("try.toml", &toml), ("try-marks.csv", &csv)).expect("sound");
        assert_eq!(read.video, video);
        let rest = read.rest.expect("a frame at rest");
        assert_eq!(rest.stations[0].trailing.clicks, 2);
        assert_eq!(rest.stations[0].trailing.y_px, 50.5);
        assert_eq!(read.frames[0].stations[0].trailing.x_px, 10.25);
    }
}
