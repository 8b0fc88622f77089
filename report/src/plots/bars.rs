//! Groups of horizontal bars on a logarithmic axis.

use std::path::Path;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use super::listing::{Listing, Paper, WIDTH};
use super::{Error, FAINT, INK, colour, power, text};

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

const LISTING: Listing =
    Listing { left: 240, right: 60, top: 64, foot: 44, bar: 18, heading: 30, letters: 14 };

/// Draws the groups below each other.
///
/// # Errors
///
/// What the file system or plotters says.
pub fn draw(path: &Path, title: &str, axis: &str, groups: &[Group]) -> Result<(), Error> {
    let Listing { left, right, top, bar: thick, .. } = LISTING;
    let values = || groups.iter().flat_map(|group| &group.bars).map(|bar| bar.value);
    // From 1, the unit, on: the length of a bar on a logarithmic axis is how many times more than that.
    let low = 10f64.powf(values().fold(1.0, f64::min).log10().floor());
    let high = values().fold(low * 10.0, f64::max) * 1.05;
    let x = |value: f64| {
        let part = (value / low).log10().max(0.0) / (high / low).log10();
        left + (part * LISTING.longest()) as i32
    };
    let axes = |root: &Paper<'_>, bottom: i32| {
        let mut tick = low;
        while tick < high {
            for value in [1.0, 2.0, 5.0].map(|times| tick * times).into_iter().filter(|&value| value <= high)
            {
                root.draw(&PathElement::new([(x(value), top - 8), (x(value), bottom)], FAINT))?;
                let style = text(14, INK, HPos::Center, VPos::Top);
                root.draw(&Text::new(power(value), (x(value), bottom + 4), style))?;
            }
            tick *= 10.0;
        }
        let style = text(15, INK, HPos::Center, VPos::Top);
        root.draw(&Text::new(axis.to_owned(), ((left + WIDTH - right) / 2, bottom + 22), style))?;
        Ok(())
    };
    let mut listed = Vec::new();
    for group in groups {
        let named = group.bars.iter().map(|bar| (bar.name.as_str(), bar));
        listed.push((group.name.as_str(), named.collect()));
    }
    LISTING.draw(path, title, &listed, axes, |root, _, bar, y| {
        let end = x(bar.value);
        let corners = [(left, y + 2), (end, y + thick - 2)];
        let colour = colour(bar.colour);
        if bar.quoted {
            root.draw(&Rectangle::new(corners, WHITE.filled()))?;
            root.draw(&Rectangle::new(corners, colour.stroke_width(2)))?;
        } else {
            root.draw(&Rectangle::new(corners, colour.filled()))?;
        }
        Ok((end, bar.value))
    })
}
