//! Enlarged pictures, for looking at single pixels.

/// How a picture is enlarged: every pixel becomes a square of `times` by `times`.
#[derive(Debug, Clone, Copy)]
pub struct Zoom {
    /// Width of the picture as drawn.
    pub width: u32,
    /// Height of the picture as drawn.
    pub height: u32,
    /// Pixels for a pixel, each way.
    pub times: u32,
}

impl Zoom {
    /// Width and height of the enlarged picture.
    #[must_use]
    pub fn size(self) -> (u32, u32) {
        (self.width * self.times, self.height * self.times)
    }

    /// The enlarged picture, in rows.
    #[must_use]
    pub fn enlarge<T: Copy>(self, pixels: &[T]) -> Vec<T> {
        let (width, times) = (self.width as usize, self.times as usize);
        let mut enlarged = Vec::with_capacity(pixels.len() * times * times);
        for row in pixels.chunks(width.max(1)) {
            for _ in 0..times {
                enlarged.extend(row.iter().flat_map(|&pixel| std::iter::repeat_n(pixel, times)));
            }
        }
        enlarged
    }
}

#[cfg(test)]
mod tests {
    use super::Zoom;

    #[test]
    fn every_pixel_becomes_a_square() {
        let zoom = Zoom { width: 2, height: 2, times: 3 };
        let enlarged = zoom.enlarge(&[1, 2, 3, 4]);
        assert_eq!(zoom.size(), (6, 6));
        let row = |y: usize| enlarged[6 * y..6 * y + 6].to_vec();
        assert_eq!((row(0), row(2)), (vec![1, 1, 1, 2, 2, 2], vec![1, 1, 1, 2, 2, 2]));
        assert_eq!((row(3), row(5)), (vec![3, 3, 3, 4, 4, 4], vec![3, 3, 3, 4, 4, 4]));
        assert_eq!(Zoom { times: 1, ..zoom }.enlarge(&[1, 2, 3, 4]), [1, 2, 3, 4]);
    }
}
