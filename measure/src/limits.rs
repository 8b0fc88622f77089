//! What the machine can do at best: whoever reads the tables elsewhere compares with these.

use std::hint::black_box;

use super::buffer::Buffer;

/// Pixels of the buffer whose clear is the unit of all times.
pub const CLEAR_PIXELS: usize = 1280 * 720;

/// A buffer of 32-bit pixels.
#[derive(Debug)]
pub struct Limit {
    pixels: Buffer<u32>,
}

impl Limit {
    /// Of that many pixels.
    #[must_use]
    pub fn new(pixels: usize) -> Self {
        Self { pixels: Buffer::new(pixels, 0) }
    }

    /// Writes every pixel, as the rasterizer clears depth: all bits set, which compilers make a `memset`,
    /// the fastest there is.
    pub fn clear(&mut self) {
        self.pixels.as_mut_slice().fill(u32::MAX);
        black_box(self.pixels.as_slice());
    }

    /// Reads, changes and writes every pixel, as a depth test that passes everywhere does.
    pub fn read_modify_write(&mut self) {
        let more = black_box(1);
        for pixel in self.pixels.as_mut_slice() {
            *pixel = pixel.wrapping_add(more);
        }
        black_box(self.pixels.as_slice());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_is_written() {
        let mut limit = Limit::new(100);
        limit.clear();
        limit.read_modify_write();
        assert_eq!(limit.pixels.as_slice(), [0; 100]);
    }
}
