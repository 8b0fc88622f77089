//! A test double: an attachment that counts how often each sample is covered, and tells of overdraw.

use crate::{Failure, Frame, ensure, failure::Verdict};
use halfplane::{Attachment, Block, Format, Mask, Winding};
use std::fmt::Write as _;

/// Counts for each pixel the triangles that cover it, apart by winding, and remembers the first two
/// that met.
///
/// In a watertight mesh each sample inside belongs to exactly one triangle: overdraw is what a wrong
/// fill rule looks like.
#[derive(Clone, Debug)]
pub struct Overdraw {
    frame: Frame,
    clockwise: Vec<u16>,
    counter_clockwise: Vec<u16>,
    last: Vec<u32>,
    first_meeting: Option<[u32; 4]>,
    outside: Option<(u32, u32)>,
}

impl Overdraw {
    /// Nothing drawn yet.
    pub fn new(frame: Frame) -> Self {
        let pixels = (frame.width() * frame.height()) as usize;
        Self {
            frame,
            clockwise: vec![0; pixels],
            counter_clockwise: vec![0; pixels],
            last: vec![halfplane::NO_ID; pixels],
            first_meeting: None,
            outside: None,
        }
    }

    /// How many triangles cover a pixel of the frame.
    pub fn count(&self, pixel: (u32, u32)) -> u16 {
        let place = self.frame.place(pixel);
        self.clockwise[place] + self.counter_clockwise[place]
    }

    /// Clockwise triangles less counter-clockwise ones.
    pub fn signed(&self, pixel: (u32, u32)) -> i32 {
        let place = self.frame.place(pixel);
        i32::from(self.clockwise[place]) - i32::from(self.counter_clockwise[place])
    }

    /// Fails where a sample was covered twice, or a block lay outside the scissor.
    pub fn verdict(&self) -> Verdict {
        if let Some((x, y)) = self.outside {
            return Err(Failure::new(format_args!("pixel ({x}, {y}) outside the scissor was covered")));
        }
        if let Some([x, y, first, second]) = self.first_meeting {
            return Err(Failure::new(format_args!(
                "overdraw at pixel ({x}, {y}): triangles {first} and {second}\n{}",
                self.picture()
            )));
        }
        Ok(())
    }

    /// Fails unless each pixel was covered as often as `expected` says.
    pub fn matches(&self, expected: impl Fn((u32, u32)) -> u16) -> Verdict {
        for pixel in self.frame.pixels() {
            let (count, wanted) = (self.count(pixel), expected(pixel));
            ensure!(
                count == wanted,
                "pixel {pixel:?} was covered {count} times, not {wanted}\n{}",
                self.picture()
            );
        }
        Ok(())
    }

    /// The counts as text, one character for each pixel: `.` for none, `#` for one, then digits.
    pub fn picture(&self) -> String {
        let mut text = String::new();
        let [x0, y0, _, y1] = self.frame.region;
        let _ = writeln!(text, "from pixel ({x0}, {y0}):");
        for y in y0..y1 {
            text.extend((0..self.frame.width()).map(|x| match self.count((x0 + x, y)) {
                0 => '.',
                1 => '#',
                count => char::from_digit(u32::from(count.min(9)), 10).unwrap_or('9'),
            }));
            text.push('\n');
        }
        text
    }
}

impl<F: Format> Attachment<F> for Overdraw {
    fn block(&mut self, block: &Block<'_, F>) -> Mask {
        for (column, row) in block.mask.cells() {
            let (x, y) = (block.x + column, block.y + row);
            if !self.frame.scissor_has((x, y)) {
                self.outside = self.outside.or(Some((x, y)));
                continue;
            }
            let place = self.frame.place((x, y));
            if self.count((x, y)) != 0 && self.first_meeting.is_none() {
                self.first_meeting = Some([x, y, self.last[place], block.id]);
            }
            self.last[place] = block.id;
            match block.triangle.winding() {
                Winding::Clockwise => self.clockwise[place] += 1,
                Winding::CounterClockwise => self.counter_clockwise[place] += 1,
            }
        }
        block.mask
    }
}
