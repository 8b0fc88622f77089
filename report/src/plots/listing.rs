//! What plots of horizontal bars share: groups below each other under headings, a name before each bar and a number
//! behind it.

use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use super::{Error, INK, short, text};

/// What is drawn on.
pub(super) type Paper<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Where things are, in pixels.
#[derive(Debug, Clone, Copy)]
pub(super) struct Listing {
    /// Where the bars begin.
    pub left: i32,
    /// Room at the right end for the numbers.
    pub right: i32,
    /// Above the first heading.
    pub top: i32,
    /// Below the last bar.
    pub foot: i32,
    /// From a bar to the next.
    pub bar: i32,
    /// From a heading to its first bar.
    pub heading: i32,
    /// The size of names and numbers.
    pub letters: u32,
}

/// The width of the picture.
pub(super) const WIDTH: i32 = 960;

impl Listing {
    /// The length of the longest bar.
    pub(super) fn longest(&self) -> f64 {
        f64::from(WIDTH - self.left - self.right)
    }

    /// Draws `frame`, to whom the y of the foot is told, and on it the groups; `paint` draws the bar with its top there
    /// and returns where it ends and its number.
    pub(super) fn draw<B>(
        &self,
        path: &Path,
        title: &str,
        groups: &[(&str, Vec<(&str, B)>)],
        frame: impl FnOnce(&Paper<'_>, i32) -> Result<(), Error>,
        mut paint: impl FnMut(&Paper<'_>, usize, &B, i32) -> Result<(i32, f64), Error>,
    ) -> Result<(), Error> {
        let bars = groups.iter().map(|(_, bars)| bars.len()).sum::<usize>() as i32;
        let height = self.top + groups.len() as i32 * self.heading + bars * self.bar + self.foot;
        let root = SVGBackend::new(path, (WIDTH as u32, height as u32)).into_drawing_area();
        root.fill(&WHITE)?;
        root.draw(&Text::new(title.to_owned(), (16, 16), text(20, INK, HPos::Left, VPos::Top)))?;
        frame(&root, height - self.foot)?;
        let mut y = self.top;
        for (place, (name, bars)) in groups.iter().enumerate() {
            let style = text(17, INK, HPos::Left, VPos::Bottom);
            root.draw(&Text::new((*name).to_owned(), (16, y + self.heading - 5), style))?;
            y += self.heading;
            for (name, bar) in bars {
                let middle = y + self.bar / 2;
                let style = text(self.letters, INK, HPos::Right, VPos::Center);
                root.draw(&Text::new((*name).to_owned(), (self.left - 6, middle), style))?;
                let (end, number) = paint(&root, place, bar, y)?;
                let style = text(self.letters, INK, HPos::Left, VPos::Center);
                root.draw(&Text::new(short(number), (end + 6, middle), style))?;
                y += self.bar;
            }
        }
        root.present()?;
        Ok(())
    }
}
