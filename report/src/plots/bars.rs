//! Groups of horizontal bars on a logarithmic axis.

use std::path::Path;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use super::{Error, FAINT, INK, colour, power, short, text};

/// A bar.
#[derive(Debug, Clone, PartialEq)]
pub struct Bar {
    /// Who.
    pub name: String,
    /// How much.
    pub value: f64,
    /// Bars of one kind have one colour: a place in the palette.
    pub colour: usize,
    /// Quoted, not measured: drawn hollow.
    pub quoted: bool,
}

/// Bars under a heading.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// The heading.
    pub name: String,
    /// From the top.
    pub bars: Vec<Bar>,
}

const WIDTH: i32 = 960;
const LEFT: i32 = 240;
const RIGHT: i32 = 60;
const TOP: i32 = 64;
const BAR: i32 = 18;
const HEADING: i32 = 30;
const FOOT: i32 = 44;

/// Draws the groups below each other.
///
/// # Errors
///
/// What the file system or plotters says.
pub fn draw(path: &Path, title: &str, axis: &str, groups: &[Group]) -> Result<(), Error> {
    let bars = groups.iter().map(|group| group.bars.len()).sum::<usize>() as i32;
    let height = TOP + groups.len() as i32 * HEADING + bars * BAR + FOOT;
    let root = SVGBackend::new(path, (WIDTH as u32, height as u32)).into_drawing_area();
    root.fill(&WHITE)?;
    let values = || groups.iter().flat_map(|group| &group.bars).map(|bar| bar.value);
    // From 1, the unit, on: the length of a bar on a logarithmic axis is how many times more than that.
    let low = 10f64.powf(values().fold(1.0, f64::min).log10().floor());
    let high = values().fold(low * 10.0, f64::max) * 1.05;
    let x = |value: f64| {
        let part = (value / low).log10().max(0.0) / (high / low).log10();
        LEFT + (part * f64::from(WIDTH - LEFT - RIGHT)) as i32
    };
    root.draw(&Text::new(title.to_owned(), (16, 16), text(20, INK, HPos::Left, VPos::Top)))?;
    let bottom = height - FOOT;
    let mut tick = low;
    while tick < high {
        for times in [1.0, 2.0, 5.0] {
            let value = tick * times;
            if value > high {
                break;
            }
            root.draw(&PathElement::new([(x(value), TOP - 8), (x(value), bottom)], FAINT))?;
            let style = text(14, INK, HPos::Center, VPos::Top);
            root.draw(&Text::new(power(value), (x(value), bottom + 4), style))?;
        }
        tick *= 10.0;
    }
    let style = text(15, INK, HPos::Center, VPos::Top);
    root.draw(&Text::new(axis.to_owned(), ((LEFT + WIDTH - RIGHT) / 2, bottom + 22), style))?;
    let mut y = TOP;
    for group in groups {
        root.draw(&Text::new(group.name.clone(), (16, y + 8), text(17, INK, HPos::Left, VPos::Top)))?;
        y += HEADING;
        for bar in &group.bars {
            let corners = [(LEFT, y + 2), (x(bar.value), y + BAR - 2)];
            let colour = colour(bar.colour);
            if bar.quoted {
                root.draw(&Rectangle::new(corners, WHITE.filled()))?;
                root.draw(&Rectangle::new(corners, colour.stroke_width(2)))?;
            } else {
                root.draw(&Rectangle::new(corners, colour.filled()))?;
            }
            let middle = y + BAR / 2;
            let style = text(14, INK, HPos::Right, VPos::Center);
            root.draw(&Text::new(bar.name.clone(), (LEFT - 6, middle), style))?;
            let style = text(14, INK, HPos::Left, VPos::Center);
            root.draw(&Text::new(short(bar.value), (x(bar.value) + 5, middle), style))?;
            y += BAR;
        }
    }
    root.present()?;
    Ok(())
}
