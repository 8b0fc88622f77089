//! Errors up a ladder: the exponent on a linear axis, the error on a logarithmic one with a place for 0.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use super::scales::Scale;
use super::svg::{self, Place, Role};
use super::{Error, text};

/// A line up the ladder.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// What it is of; shown by its colour in the page's legend.
    pub name: &'static str,
    /// Its colour's place in the palette.
    pub colour: usize,
    /// By rung.
    pub points: Vec<(i32, f64)>,
}

const SIZE: (i32, i32) = (470, 290);
const LEFT: i32 = 58;
const RIGHT: i32 = 14;
const TOP: i32 = 30;
const BOTTOM: i32 = 48;

/// Draws the lines; `bound` is a line of what is promised.
///
/// # Errors
///
/// What plotters says.
pub fn draw(title: &str, axes: [&str; 2], series: &[Series], bound: Option<f64>) -> Result<String, Error> {
    let (width, height) = SIZE;
    let (bottom, right) = (height - BOTTOM, width - RIGHT);
    let points = || series.iter().flat_map(|series| &series.points);
    let errors: Vec<f64> = points().map(|&(_, error)| error).chain(bound).collect();
    let y = Scale::new(&errors, true, [bottom, TOP]);
    let (low, high) = points().fold((i32::MAX, i32::MIN), |(low, high), &(k, _)| (low.min(k), high.max(k)));
    let x = |k: i32| {
        let part = f64::from(k - low) / f64::from((high - low).max(1));
        LEFT + 12 + (part * f64::from(right - LEFT - 24)) as i32
    };
    svg::draw((width as u32, height as u32), title, Place::Page, |root| {
        let (ink, grid) = (Role::Ink.stand_in(), Role::Grid.stand_in());
        if low <= high {
            let every = ((high - low) / 8 + 1) as usize;
            for k in (low..=high).step_by(every) {
                root.draw(&PathElement::new([(x(k), TOP), (x(k), bottom)], grid))?;
                let style = text(13, ink, HPos::Center, VPos::Top);
                root.draw(&Text::new(k.to_string(), (x(k), bottom + 7), style))?;
            }
        }
        for tick in y.ticks() {
            root.draw(&PathElement::new([(LEFT, tick.at), (right, tick.at)], grid))?;
            let style = text(13, ink, HPos::Right, VPos::Center);
            root.draw(&Text::new(tick.label, (LEFT - 7, tick.at), style))?;
        }
        root.draw(&PathElement::new([(LEFT, TOP), (LEFT, bottom - 22)], ink))?;
        root.draw(&PathElement::new([(LEFT, bottom - 17), (LEFT, bottom), (right, bottom)], ink))?;
        let style = text(13, ink, HPos::Center, VPos::Bottom);
        root.draw(&Text::new(axes[0].to_owned(), ((LEFT + right) / 2, height - 5), style))?;
        let style = text(13, ink, HPos::Left, VPos::Top);
        root.draw(&Text::new(axes[1].to_owned(), (6, 5), style))?;
        if let Some(at) = bound.and_then(|bound| y.at(bound)) {
            for from in (LEFT..right).step_by(10) {
                root.draw(&PathElement::new([(from, at), (from + 5, at)], ink))?;
            }
        }
        // The first is drawn last, so that it lies above.
        for series in series.iter().rev() {
            let colour = Role::Series(series.colour).stand_in();
            let path: Vec<(i32, i32)> =
                series.points.iter().filter_map(|&(k, error)| Some((x(k), y.at(error)?))).collect();
            root.draw(&PathElement::new(path.clone(), colour.stroke_width(2)))?;
            for at in path {
                root.draw(&Circle::new(at, 3, colour.filled()))?;
            }
        }
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_is_drawn() {
        let series = [
            Series { name: "flat", colour: 0, points: vec![(3, 0.5), (4, 0.5), (5, 0.0)] },
            Series { name: "steep", colour: 1, points: vec![(3, 1.0), (4, 1e6), (5, 1e12)] },
        ];
        let svg = draw("Ladder", ["k", "error (2^-32)"], &series, Some(1.01)).unwrap();
        assert_eq!(svg.matches("<circle").count(), 6);
        assert!(svg.contains("error (2^-32)") && svg.contains("10¹²"), "{svg}");
        assert!(draw("Nothing", ["k", "error"], &[], None).is_ok());
    }
}
