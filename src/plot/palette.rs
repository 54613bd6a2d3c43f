//! Colours and shapes that everybody can tell apart.
//!
//! Colours: M. Okabe, K. Ito, "Color Universal Design" (2008), without the yellow, which is lost on white.

use plotters::style::RGBColor;

/// Colour of a mark.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ink {
    /// Text, frames, measurements without a curve of their own.
    Black,
    /// What stands back: grids, the uncalibrated model.
    Grey,
    /// The k-th of the curves of a figure; they repeat after seven.
    Curve(usize),
}

const CURVES: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
];

impl Ink {
    /// The colour.
    pub(super) fn colour(self) -> RGBColor {
        match self {
            Ink::Black => RGBColor(34, 34, 34),
            Ink::Grey => RGBColor(119, 119, 119),
            Ink::Curve(index) => CURVES[index % CURVES.len()],
        }
    }
}

/// Shape of a marker.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A circle.
    Circle,
    /// A square.
    Square,
    /// A triangle on its base.
    Triangle,
    /// A square on its corner.
    Diamond,
}

impl Shape {
    /// Shape of the k-th curve; they repeat after four, so that colour and shape together repeat after 28.
    pub fn of_curve(index: usize) -> Shape {
        [Shape::Circle, Shape::Square, Shape::Triangle, Shape::Diamond][index % 4]
    }
}

/// Limits of the classes of a heat map, in standard deviations; beyond the last is a class of its own.
pub(super) const CLASSES: [f64; 4] = [1.0, 2.0, 3.0, 5.0];

/// Blue below zero, vermillion above, white within one; stronger the further off.
pub(super) fn diverging(value: f64) -> RGBColor {
    const BELOW: [RGBColor; 5] = [
        RGBColor(247, 247, 247),
        RGBColor(209, 229, 240),
        RGBColor(146, 197, 222),
        RGBColor(67, 147, 195),
        RGBColor(0, 90, 150),
    ];
    const ABOVE: [RGBColor; 5] = [
        RGBColor(247, 247, 247),
        RGBColor(253, 226, 200),
        RGBColor(246, 178, 122),
        RGBColor(226, 119, 40),
        RGBColor(172, 70, 0),
    ];
    let side = if value < 0.0 { BELOW } else { ABOVE };
    side[class_of(value)]
}

/// The class of a value, from 0 (within one) to 4.
pub(super) fn class_of(value: f64) -> usize {
    CLASSES.iter().filter(|limit| value.abs() > **limit).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lightness as a grey printer sees it.
    fn grey(colour: RGBColor) -> f64 {
        0.299 * f64::from(colour.0) + 0.587 * f64::from(colour.1) + 0.114 * f64::from(colour.2)
    }

    #[test]
    fn further_off_is_darker_on_both_sides() {
        for sign in [-1.0, 1.0] {
            let shades: Vec<f64> = [0.5, 1.5, 2.5, 4.0, 9.0]
                .map(|v| grey(diverging(sign * v)))
                .into();
            assert!(
                shades.windows(2).all(|pair| pair[1] < pair[0] - 15.0),
                "{shades:?}"
            );
        }
    }

    #[test]
    fn curves_differ_in_colour_or_shape_up_to_the_twenty_eighth() {
        let looks: Vec<_> = (0..28)
            .map(|k| (Ink::Curve(k).colour(), Shape::of_curve(k)))
            .collect();
        for (k, look) in looks.iter().enumerate() {
            assert!(!looks[..k].contains(look), "{k}");
        }
    }
}
