//! Horizontal bars of parts.

use std::path::Path;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

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

const WIDTH: i32 = 960;
const LEFT: i32 = 100;
const RIGHT: i32 = 80;
const TOP: i32 = 84;
const BAR: i32 = 24;
const HEADING: i32 = 36;

/// Draws the groups below each other, under one legend.
///
/// # Errors
///
/// What the file system or plotters says.
pub fn draw(path: &Path, title: &str, legend: &[&str], groups: &[Group]) -> Result<(), Error> {
    let bars = groups.iter().map(|group| group.stacks.len()).sum::<usize>() as i32;
    let height = TOP + groups.len() as i32 * HEADING + bars * BAR + 16;
    let root = SVGBackend::new(path, (WIDTH as u32, height as u32)).into_drawing_area();
    root.fill(&WHITE)?;
    root.draw(&Text::new(title.to_owned(), (16, 16), text(20, INK, HPos::Left, VPos::Top)))?;
    let step = (WIDTH - 32) / legend.len().max(1) as i32;
    for (place, name) in legend.iter().enumerate() {
        let x = 16 + place as i32 * step;
        root.draw(&Rectangle::new([(x, 54), (x + 14, 68)], colour(place).filled()))?;
        let style = text(15, INK, HPos::Left, VPos::Center);
        root.draw(&Text::new((*name).to_owned(), (x + 20, 61), style))?;
    }
    let mut y = TOP;
    for group in groups {
        root.draw(&Text::new(group.name.clone(), (16, y + 12), text(17, INK, HPos::Left, VPos::Top)))?;
        y += HEADING;
        let most = group.stacks.iter().map(|stack| stack.parts.iter().sum::<f64>()).fold(0.0, f64::max);
        for stack in &group.stacks {
            let middle = y + BAR / 2;
            let style = text(15, INK, HPos::Right, VPos::Center);
            root.draw(&Text::new(stack.name.clone(), (LEFT - 6, middle), style))?;
            let x = |value: f64| LEFT + (value / most * f64::from(WIDTH - LEFT - RIGHT)).round() as i32;
            let mut sum = 0.0;
            for (place, part) in stack.parts.iter().enumerate() {
                let corners = [(x(sum), y + 3), (x(sum + part), y + BAR - 3)];
                sum += part;
                if corners[0].0 == corners[1].0 {
                    continue;
                }
                root.draw(&Rectangle::new(corners, colour(place).filled()))?;
                let label = short(*part);
                if corners[1].0 - corners[0].0 > 9 * label.len() as i32 {
                    let style = text(13, letters_on(colour(place)), HPos::Center, VPos::Center);
                    root.draw(&Text::new(label, ((corners[0].0 + corners[1].0) / 2, middle), style))?;
                }
            }
            let style = text(15, INK, HPos::Left, VPos::Center);
            root.draw(&Text::new(short(sum), (x(sum) + 6, middle), style))?;
            y += BAR;
        }
    }
    root.present()?;
    Ok(())
}
