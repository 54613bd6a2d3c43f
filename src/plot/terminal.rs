//! Charts in a terminal: lines of Braille dots, measured points as letters.

use super::chart::{Chart, Limit, Mark};
use super::figure::{Figure, Panel, Sample};
use super::scale::Scale;

/// Dots in a character: columns and rows.
const DOTS: [usize; 2] = [2, 4];
/// First of the Braille characters, the one without dots.
const BLANK: u32 = 0x2800;
/// Bit of a dot, by column and row of its character.
const BITS: [[u8; 4]; 2] = [[0x01, 0x02, 0x04, 0x40], [0x08, 0x10, 0x20, 0x80]];
/// Columns that the labels of the upright axis take.
const LABELS: usize = 8;

/// Characters of a sketch: columns and rows.
const SKETCH: [usize; 2] = [64, 10];

/// The first chart of a figure, small, with what its marks mean; nothing if it has no chart.
pub fn sketch(figure: &Figure) -> String {
    let mut charts = figure.panels.iter().filter_map(|panel| match panel {
        Panel::Chart(chart) => Some(chart),
        _ => None,
    });
    let Some(chart) = charts.next() else {
        return String::new();
    };
    let labels = |is_asked: &dyn Fn(&Sample) -> bool| {
        let keys = figure.legend.iter().filter(|key| is_asked(&key.sample));
        keys.map(|key| key.label.as_str()).collect::<Vec<_>>().join(", ")
    };
    let lines = labels(&|sample| matches!(sample, Sample::Line(..) | Sample::Band(..)));
    let points = labels(&|sample| matches!(sample, Sample::Marker(..) | Sample::Dot(..)));
    let mut page = drawn(chart, SKETCH[0], SKETCH[1]);
    for (mark, meaning) in [("dots", lines), ("o", points)] {
        if !meaning.is_empty() {
            page += &format!("{:>LABELS$}  {mark}: {meaning}\n", "");
        }
    }
    page
}

/// A chart of so many characters, with its axes: lines dotted, points as `o`, bounds as `v` and `^`, bands by their edges.
pub fn drawn(chart: &Chart, columns: usize, rows: usize) -> String {
    let mut paper = Paper::of(chart, columns, rows);
    for mark in &chart.marks {
        match mark {
            Mark::Line { points, .. } => points.windows(2).for_each(|ends| paper.line(ends[0], ends[1])),
            Mark::Level { points, .. } => points.iter().for_each(|point| paper.dot(*point)),
            Mark::Points { points, .. } => {
                for point in points {
                    let letter = match point.limit {
                        Limit::None => 'o',
                        Limit::Upper => 'v',
                        Limit::Lower => '^',
                    };
                    let middle = point.x_to.map_or(point.x, |to| 0.5 * (point.x + to));
                    paper.letter([middle, point.y], letter);
                }
            }
            Mark::Band { points, .. } => {
                for edge in [1, 2] {
                    let ends = points.windows(2);
                    ends.for_each(|ends| {
                        paper.line([ends[0][0], ends[0][edge]], [ends[1][0], ends[1][edge]])
                    });
                }
            }
        }
    }
    paper.page(chart)
}

struct Paper {
    x: Scale,
    y: Scale,
    columns: usize,
    rows: usize,
    dots: Vec<u8>,
    letters: Vec<Option<char>>,
}

impl Paper {
    fn of(chart: &Chart, columns: usize, rows: usize) -> Paper {
        let reach: Vec<[f64; 2]> = chart.marks.iter().flat_map(Mark::reach).collect();
        let zero = chart.has_zero_line.then_some(0.0);
        Paper {
            x: Scale::around(
                reach.iter().map(|p| p[0]).chain(chart.x_includes),
                0.0,
                columns / 12,
            ),
            y: Scale::around(reach.iter().map(|p| p[1]).chain(zero), 0.0, rows / 3),
            columns,
            rows,
            dots: vec![0; columns * rows],
            letters: vec![None; columns * rows],
        }
    }

    /// Place in dots from the upper left corner.
    fn place(&self, point: [f64; 2]) -> [f64; 2] {
        let share = |value: f64, [low, high]: [f64; 2]| ((value - low) / (high - low)).clamp(0.0, 1.0);
        [
            share(point[0], self.x.range) * (self.columns * DOTS[0] - 1) as f64,
            (1.0 - share(point[1], self.y.range)) * (self.rows * DOTS[1] - 1) as f64,
        ]
    }

    fn dot(&mut self, point: [f64; 2]) {
        let [x, y] = self.place(point).map(|dots| dots.round() as usize);
        let cell = y / DOTS[1] * self.columns + x / DOTS[0];
        self.dots[cell] |= BITS[x % DOTS[0]][y % DOTS[1]];
    }

    fn line(&mut self, from: [f64; 2], to: [f64; 2]) {
        let [a, b] = [self.place(from), self.place(to)];
        let steps = (b[0] - a[0]).abs().max((b[1] - a[1]).abs()).ceil().max(1.0);
        for step in 0..=steps as usize {
            let share = step as f64 / steps;
            self.dot([0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis])));
        }
    }

    fn letter(&mut self, point: [f64; 2], letter: char) {
        let [x, y] = self.place(point).map(|dots| dots.round() as usize);
        self.letters[y / DOTS[1] * self.columns + x / DOTS[0]] = Some(letter);
    }

    fn page(&self, chart: &Chart) -> String {
        let mut page = format!("  {}\n", chart.y_label);
        let row_of = |tick: f64| self.place([self.x.range[0], tick])[1].round() as usize / DOTS[1];
        for row in 0..self.rows {
            let label = self.y.ticks.iter().find(|tick| row_of(**tick) == row);
            let label = label.map_or(String::new(), |tick| self.y.label(*tick));
            let edge = if label.is_empty() { '│' } else { '┤' };
            let cells = (0..self.columns).map(|column| {
                let cell = row * self.columns + column;
                let dots = char::from_u32(BLANK + u32::from(self.dots[cell])).unwrap_or(' ');
                self.letters[cell].unwrap_or(if self.dots[cell] == 0 { ' ' } else { dots })
            });
            let line = format!("{label:>LABELS$} {edge}{}", cells.collect::<String>());
            page += line.trim_end();
            page.push('\n');
        }
        let mut axis: Vec<char> = vec!['─'; self.columns];
        let mut labels: Vec<char> = vec![' '; LABELS + 2 + self.columns + LABELS];
        for &tick in &self.x.ticks {
            let column = self.place([tick, self.y.range[0]])[0].round() as usize / DOTS[0];
            axis[column] = '┬';
            let label: Vec<char> = self.x.label(tick).chars().collect();
            let first = LABELS + 2 + column - label.len() / 2;
            labels[first..first + label.len()].copy_from_slice(&label);
        }
        page += &format!("{:>LABELS$} └{}\n", "", axis.into_iter().collect::<String>());
        page += labels.into_iter().collect::<String>().trim_end();
        page += &format!("\n{:>LABELS$}  {}\n", "", chart.x_label);
        page
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::{Ink, Point, Shape, Weight};

    #[test]
    fn a_rising_line_rises_and_a_measured_point_stands_where_it_was_measured() {
        let chart = Chart {
            title: String::new(),
            x_label: "r (mm)".into(),
            y_label: "twist (deg)".into(),
            marks: vec![
                Mark::Line {
                    points: vec![[0.0, 0.0], [50.0, 10.0]],
                    ink: Ink::Black,
                    weight: Weight::Thin,
                },
                Mark::Points {
                    points: vec![Point {
                        x: 50.0,
                        x_to: None,
                        y: 0.0,
                        sigma: 0.0,
                        limit: Limit::None,
                    }],
                    ink: Ink::Black,
                    shape: Shape::Circle,
                    is_filled: true,
                },
            ],
            x_includes: None,
            has_zero_line: true,
        };
        let page = drawn(&chart, 24, 6);
        let expected = [
            "  twist (deg)",
            "      10 ┤                    ⣀⠤⠒⠉",
            "         │                ⣀⠤⠒⠉",
            "         │            ⣀⠤⠒⠉",
            "       5 ┤        ⣀⠤⠒⠉",
            "         │    ⣀⠤⠒⠉",
            "       0 ┤⣀⠤⠒⠉                   o",
            "         └┬────────┬─────────┬────",
            "          0       20        40",
            "          r (mm)",
            "",
        ];
        assert_eq!(page.split('\n').collect::<Vec<_>>(), expected);
    }
}
