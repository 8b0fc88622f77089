//! Error against time: both axes logarithmic, 0 at a marked place, and the Pareto front as a line.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use super::scales::Scale;
use super::svg::{self, Place, Role};
use super::{Error, text};

/// A dot.
#[derive(Debug, Clone, PartialEq)]
pub struct Dot {
    /// What stands in it: its row in the table.
    pub number: usize,
    /// Its name; shown where it is on the front.
    pub name: String,
    /// Its time.
    pub x: f64,
    /// Half of the frames lie between.
    pub spread: [f64; 2],
    /// Its error.
    pub y: f64,
    /// Its colour's place in the palette.
    pub colour: usize,
    /// Whether nothing beats it.
    pub front: bool,
}

/// Width and height.
pub const SIZE: (i32, i32) = (760, 430);
const LEFT: i32 = 78;
const RIGHT: i32 = 22;
const TOP: i32 = 26;
const BOTTOM: i32 = 58;
const RADIUS: i32 = 9;

/// Draws the dots; the axes are named with their units.
///
/// # Errors
///
/// What plotters says.
pub fn draw(title: &str, axes: [&str; 2], dots: &[Dot], place: Place) -> Result<String, Error> {
    let (width, height) = SIZE;
    let [bottom, right] = [height - BOTTOM, width - RIGHT];
    let times: Vec<f64> = dots.iter().flat_map(|dot| [dot.x, dot.spread[0], dot.spread[1]]).collect();
    let errors: Vec<f64> = dots.iter().map(|dot| dot.y).collect();
    let x = Scale::new(&times, false, [LEFT, right]);
    let y = Scale::new(&errors, true, [bottom, TOP]);
    svg::draw((width as u32, height as u32), title, place, |root| {
        let ink = Role::Ink.stand_in();
        let grid = Role::Grid.stand_in();
        for tick in x.ticks() {
            root.draw(&PathElement::new([(tick.at, TOP), (tick.at, bottom)], grid))?;
            let style = text(14, ink, HPos::Center, VPos::Top);
            root.draw(&Text::new(tick.label, (tick.at, bottom + 8), style))?;
        }
        for tick in y.ticks() {
            root.draw(&PathElement::new([(LEFT, tick.at), (right, tick.at)], grid))?;
            let style = text(14, ink, HPos::Right, VPos::Center);
            root.draw(&Text::new(tick.label, (LEFT - 8, tick.at), style))?;
        }
        // The axis is broken between 0 and the first decade.
        let broken = bottom - 17;
        for up in [0, 5] {
            let path = [(LEFT - 5, broken - up + 3), (LEFT + 5, broken - up - 3)];
            root.draw(&PathElement::new(path, ink))?;
        }
        root.draw(&PathElement::new([(LEFT, TOP), (LEFT, broken - 5)], ink))?;
        root.draw(&PathElement::new([(LEFT, broken), (LEFT, bottom), (right, bottom)], ink))?;
        let style = text(14, ink, HPos::Center, VPos::Bottom);
        root.draw(&Text::new(axes[0].to_owned(), ((LEFT + right) / 2, height - 8), style))?;
        let style = text(14, ink, HPos::Left, VPos::Top);
        root.draw(&Text::new(axes[1].to_owned(), (8, 4), style))?;

        let placed: Vec<(&Dot, i32, i32)> =
            dots.iter().filter_map(|dot| Some((dot, x.at(dot.x)?, y.at(dot.y)?))).collect();
        front_line(root, &placed, right)?;
        for &(dot, px, py) in &placed {
            let colour = Role::Series(dot.colour).stand_in();
            if let [Some(from), Some(to)] = dot.spread.map(|time| x.at(time)) {
                root.draw(&PathElement::new([(from, py), (to, py)], colour.stroke_width(1)))?;
                for end in [from, to] {
                    root.draw(&PathElement::new([(end, py - 3), (end, py + 3)], colour))?;
                }
            }
            root.draw(&Circle::new((px, py), RADIUS, Role::Paper.stand_in().filled()))?;
            let width = if dot.front { 4 } else { 2 };
            root.draw(&Circle::new((px, py), RADIUS, colour.stroke_width(width)))?;
            let style = text(12, ink, HPos::Center, VPos::Center);
            root.draw(&Text::new(dot.number.to_string(), (px, py), style))?;
        }
        names(root, &placed, right)
    })
}

type Paper<'a, 'b> = &'a DrawingArea<SVGBackend<'b>, plotters::coord::Shift>;

/// Steps through the front's dots: what lies above and to the right of it is beaten.
fn front_line(root: Paper<'_, '_>, placed: &[(&Dot, i32, i32)], right: i32) -> Result<(), Error> {
    let mut front: Vec<(i32, i32)> =
        placed.iter().filter(|(dot, ..)| dot.front).map(|&(_, x, y)| (x, y)).collect();
    front.sort_unstable();
    let Some(&(first, _)) = front.first() else { return Ok(()) };
    let mut path = vec![(first, TOP)];
    for &(x, y) in &front {
        path.push((x, path.last().map_or(y, |&(_, y)| y)));
        path.push((x, y));
    }
    path.push((right, path.last().map_or(TOP, |&(_, y)| y)));
    root.draw(&PathElement::new(path, Role::Ink.stand_in().stroke_width(2)))?;
    Ok(())
}

/// The names of the front's dots, where they do not lie on each other.
fn names(root: Paper<'_, '_>, placed: &[(&Dot, i32, i32)], right: i32) -> Result<(), Error> {
    let mut taken: Vec<[i32; 4]> =
        placed.iter().map(|&(_, x, y)| [x - RADIUS, y - RADIUS, x + RADIUS, y + RADIUS]).collect();
    for &(dot, px, py) in placed.iter().filter(|(dot, ..)| dot.front) {
        let long = 8 * dot.name.chars().count() as i32;
        let boxed = |x: i32, y: i32| [x, y - 8, x + long, y + 8];
        let places = [-20, 20, 0, -36, 36, -52, 52, -68, 68].into_iter().flat_map(|down| {
            [px + RADIUS + 5, px - RADIUS - 5 - long, px - long / 2].map(|left| (left, py + down))
        });
        let free = places.map(|(x, y)| boxed(x, y)).find(|place| {
            let inside =
                place[0] > LEFT + 2 && place[2] <= right && place[1] > TOP && place[3] < SIZE.1 - BOTTOM + 4;
            inside && !taken.iter().any(|other| overlap(place, other))
        });
        if let Some(place) = free {
            taken.push(place);
            let style = text(14, Role::Ink.stand_in(), HPos::Left, VPos::Center);
            root.draw(&Text::new(dot.name.clone(), (place[0], (place[1] + place[3]) / 2), style))?;
        }
    }
    Ok(())
}

fn overlap(a: &[i32; 4], b: &[i32; 4]) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_dot_is_drawn_and_the_front_is_named() {
        let dot = |number, x, y, front| Dot {
            number,
            name: format!("choice {number}"),
            x,
            spread: [x, 1.1 * x],
            y,
            colour: 0,
            front,
        };
        let dots = [dot(1, 1.0, 0.0, true), dot(2, 0.5, 30.0, true), dot(3, 2.0, 900.0, false)];
        let svg = draw("Title", ["time (ms)", "error (px)"], &dots, Place::Page).unwrap();
        assert_eq!(svg.matches("<circle").count(), 6);
        for text in ["choice 1", "choice 2", "time (ms)", "error (px)"] {
            assert!(svg.contains(text), "{text}");
        }
        assert!(!svg.contains("choice 3"));
        assert!(draw("Empty", ["x", "y"], &[], Place::Alone).is_ok());
    }
}
