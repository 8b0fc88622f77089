//! Plots as SVG, drawn from plain numbers: [`bars`], [`curves`] and [`stacks`] as files on a background of their
//! own, so that they can be read on light and on dark pages; the others in the colours of the page they are in.

pub mod bars;
pub mod curves;
mod listing;
pub mod rungs;
pub mod scales;
pub mod scatter;
pub mod stacks;
pub mod svg;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Colours that people with any kind of colour vision can tell apart (Okabe and Ito), darkened where white
/// is behind them.
const PALETTE: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 140, 105),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(200, 140, 0),
    RGBColor(120, 94, 160),
    RGBColor(110, 110, 110),
];

const INK: RGBColor = RGBColor(30, 30, 30);
const FAINT: RGBColor = RGBColor(215, 215, 215);

/// Why a plot could not be drawn.
pub type Error = Box<dyn std::error::Error>;

fn colour(place: usize) -> RGBColor {
    PALETTE[place % PALETTE.len()]
}

fn text(size: u32, colour: RGBColor, h: HPos, v: VPos) -> TextStyle<'static> {
    ("sans-serif", size).into_font().color(&colour).pos(Pos::new(h, v))
}

/// The colour of letters on a colour: what can be read.
fn letters_on(colour: RGBColor) -> RGBColor {
    let RGBColor(red, green, blue) = colour;
    let light = 0.3 * f64::from(red) + 0.59 * f64::from(green) + 0.11 * f64::from(blue);
    if light > 125.0 { INK } else { WHITE }
}

/// Text between tags.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A number of at most four signs: 0.05, 1.3, 27, 1200.
pub(crate) fn short(value: f64) -> String {
    match value {
        v if v >= 99.5 => format!("{v:.0}"),
        v if v >= 9.95 => format!("{v:.1}"),
        v if v >= 0.995 => format!("{v:.2}"),
        v => format!("{v:.3}"),
    }
}

/// A place on a logarithmic axis as people write it: 0.001, 1, 2000, 10^6.
fn power(value: f64) -> String {
    let exponent = value.log10().round();
    if (value / 10f64.powf(exponent) - 1.0).abs() > 1e-6 {
        return format!("{value}");
    }
    if (-4.0..=3.0).contains(&exponent) {
        let digits = (-exponent).max(0.0) as usize;
        format!("{value:.digits$}")
    } else {
        let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
        let sign = if exponent < 0.0 { "⁻" } else { "" };
        let raised = (exponent.abs() as u32).to_string();
        let raised = raised.bytes().filter_map(|digit| digits.get(usize::from(digit - b'0')));
        format!("10{sign}{}", raised.collect::<String>())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!([0.0514, 1.34, 27.31, 1234.5].map(short), ["0.051", "1.34", "27.3", "1234"]);
        assert_eq!([0.001, 1.0, 100.0, 1e6, 1e-7].map(power), ["0.001", "1", "100", "10⁶", "10⁻⁷"]);
        assert_eq!([2000.0, 50_000.0].map(power), ["2000", "50000"]);
    }
}
