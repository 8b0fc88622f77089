//! embedded-graphics: 2D shapes for small displays.

use std::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::primitives::{PrimitiveStyle, Rectangle, StyledDrawable, Triangle};

use super::{Peer, Shown, visible::Visible};
use crate::Matrix;
use crate::view::View;

/// A view for embedded-graphics.
#[derive(Debug)]
pub struct EmbeddedGraphics {
    triangles: Vec<Triangle>,
    indices: Vec<u32>,
    target: Rows,
}

impl EmbeddedGraphics {
    /// The visible triangles with every corner moved into the pixel it lies in.
    #[must_use]
    pub fn new(view: &View<'_>, visible: &Visible) -> Self {
        let (width, height) = view.size;
        let inside = |at: f32, side: u32| (at.floor() as i32).clamp(0, side as i32 - 1);
        let corner = |[x, y]: [f32; 2]| Point::new(inside(x, width), inside(y, height));
        let triangle = |corners: &[[f32; 2]; 3]| {
            let [a, b, c] = corners.map(corner);
            Triangle::new(a, b, c)
        };
        Self {
            triangles: visible.corners.iter().map(triangle).collect(),
            indices: visible.indices.clone(),
            target: Rows { size: Size::new(width, height), pixels: vec![0; view.pixels()] },
        }
    }
}

impl Peer for EmbeddedGraphics {
    fn name(&self) -> &'static str {
        "embedded-graphics"
    }

    fn frame(&mut self, _: &Matrix) {
        self.target.pixels.fill(0);
        let style = PrimitiveStyle::with_fill(Colour(1));
        for triangle in &self.triangles {
            let Ok(()) = triangle.draw_styled(&style, &mut self.target);
        }
    }

    fn moves(&self) -> bool {
        false
    }

    fn triangles(&self) -> usize {
        self.triangles.len()
    }

    fn indices(&self) -> &[u32] {
        &self.indices
    }

    fn covered(&self) -> usize {
        self.target.pixels.iter().filter(|pixel| **pixel != 0).count()
    }

    fn shown(&self) -> Vec<Shown> {
        let pixels = self.target.pixels.iter();
        pixels.map(|pixel| if *pixel == 0 { Shown::Nothing } else { Shown::Something }).collect()
    }
}

/// 32 bits.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Colour(u32);

impl PixelColor for Colour {
    type Raw = ();
}

/// Rows of 32-bit pixels, filled a run at a time.
#[derive(Debug)]
struct Rows {
    size: Size,
    pixels: Vec<u32>,
}

impl OriginDimensions for Rows {
    fn size(&self) -> Size {
        self.size
    }
}

impl DrawTarget for Rows {
    type Color = Colour;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Colour>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, colour) in pixels {
            self.fill_solid(&Rectangle::new(point, Size::new(1, 1)), colour)?;
        }
        Ok(())
    }

    #[inline]
    fn fill_solid(&mut self, area: &Rectangle, Colour(colour): Colour) -> Result<(), Infallible> {
        let width = self.size.width as usize;
        let (x, y) = (area.top_left.x as usize, area.top_left.y as usize);
        for row in self.pixels.chunks_exact_mut(width).skip(y).take(area.size.height as usize) {
            if let Some(run) = row.get_mut(x..x + area.size.width as usize) {
                run.fill(colour);
            }
        }
        Ok(())
    }
}
