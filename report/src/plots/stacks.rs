//! Horizontal bars of parts.

use std::path::Path;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use super::listing::{Listing, Paper, WIDTH};
use super::{Error, INK, colour, letters_on, short, text};

/// A bar of parts, in the order of the legend.
#[derive(Debug, Clone, PartialEq)]
pub struct Stack {
    /// What it is of.
    pub name: String,
    /// How much of each.
    pub parts: Vec<f64>,
}

/// Stacks under a heading, on a scale of their own.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// The heading, with the unit.
    pub name: String,
    /// From the top.
    pub stacks: Vec<Stack>,
}

const LISTING: Listing =
    Listing { left: 100, right: 80, top: 84, foot: 16, bar: 24, heading: 36, letters: 15 };

/// Draws the groups below each other, under one legend.
///
/// # Errors
///
/// What the file system or plotters says.
pub fn draw(path: &Path, title: &str, legend: &[&str], groups: &[Group]) -> Result<(), Error> {
    let Listing { left, bar: thick, .. } = LISTING;
    let step = (WIDTH - 32) / legend.len().max(1) as i32;
    let entries = |root: &Paper<'_>, _| {
        for (place, name) in legend.iter().enumerate() {
            let x = 16 + place as i32 * step;
            root.draw(&Rectangle::new([(x, 54), (x + 14, 68)], colour(place).filled()))?;
            let style = text(15, INK, HPos::Left, VPos::Center);
            root.draw(&Text::new((*name).to_owned(), (x + 20, 61), style))?;
        }
        Ok(())
    };
    let most =
        |group: &Group| group.stacks.iter().map(|stack| stack.parts.iter().sum::<f64>()).fold(0.0, f64::max);
    let scales: Vec<f64> = groups.iter().map(|group| LISTING.longest() / most(group)).collect();
    let mut listed = Vec::new();
    for group in groups {
        let named = group.stacks.iter().map(|stack| (stack.name.as_str(), stack));
        listed.push((group.name.as_str(), named.collect()));
    }
    LISTING.draw(path, title, &listed, entries, |root, group, stack, y| {
        let x = |value: f64| left + (value * scales[group]).round() as i32;
        let mut sum = 0.0;
        for (place, part) in stack.parts.iter().enumerate() {
            let corners = [(x(sum), y + 3), (x(sum + part), y + thick - 3)];
            sum += part;
            if corners[0].0 == corners[1].0 {
                continue;
            }
            root.draw(&Rectangle::new(corners, colour(place).filled()))?;
            let label = short(*part);
            if corners[1].0 - corners[0].0 > 9 * label.len() as i32 {
                let style = text(13, letters_on(colour(place)), HPos::Center, VPos::Center);
                root.draw(&Text::new(label, ((corners[0].0 + corners[1].0) / 2, y + thick / 2), style))?;
            }
        }
        Ok((x(sum), sum))
    })
}
