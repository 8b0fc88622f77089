//! What programs are given to draw: values written over those that stand in the linked file.

use object::{Endianness, Object as _, ObjectSection as _, ObjectSymbol as _};

/// Width and height in pixels of the programs' targets.
const SIZE: [f32; 2] = [320.0, 16.0];

/// What a program's vertices are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Corners {
    /// Window vertices: steps to the pixel, and unorm32 depths.
    Window {
        /// Steps to the pixel.
        steps: u16,
    },
    /// Floats, in clip space or in object space with a matrix that changes nothing.
    Float,
}

/// The same triangle some times.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Workload {
    /// Its corners in pixels, and depths of 0 to 1.
    pub corners: [[f32; 3]; 3],
    /// How often: at most 64.
    pub times: u32,
}

impl Workload {
    /// A triangle that covers one sample, some times.
    pub(super) const fn small(times: u32) -> Self {
        Self { corners: [[8.25, 8.25, 0.5], [8.75, 8.25, 0.5], [8.25, 9.0, 0.5]], times }
    }

    /// A triangle over the target's first `columns`; only an edge that is parallel to them crosses the target.
    pub(super) const fn large(columns: u16) -> Self {
        let right = columns as f32;
        Self { corners: [[-900.0, 8.0, 0.5], [right, -500.0, 0.5], [right, 516.0, 0.5]], times: 1 }
    }

    /// The same with a corner before the near plane.
    pub(super) const fn clipped() -> Self {
        let mut workload = Self::large(320);
        workload.corners[0][2] = -0.5;
        workload
    }

    /// The words of `INPUT`, as `tests/bare-metal` reads them.
    fn input(&self, of: Corners) -> [u32; 64] {
        let mut input = [0; 64];
        for (words, [x, y, z]) in input.chunks_exact_mut(3).zip(self.corners) {
            let vertex = match of {
                Corners::Window { steps } => {
                    let snapped = |pixels: f32| (pixels * f32::from(steps)).round() as i32 as u32;
                    [snapped(x), snapped(y), (f64::from(z) * f64::from(u32::MAX)).round() as u32]
                }
                Corners::Float => [2.0 * x / SIZE[0] - 1.0, 1.0 - 2.0 * y / SIZE[1], z].map(f32::to_bits),
            };
            words.copy_from_slice(&vertex);
        }
        let one = 1f32.to_bits();
        // w in clip space; the matrix; indices; records of scratch memory.
        input[15] = one;
        if of == Corners::Float {
            (0..4).for_each(|row| input[16 + 5 * row] = one);
        }
        input[32] = 3 * self.times;
        input[33] = 3;
        input
    }

    /// The program of `bytes` with this to draw.
    ///
    /// # Errors
    ///
    /// Where the file is not as `tests/bare-metal` is linked.
    pub(super) fn written(&self, bytes: &[u8], of: Corners) -> Result<Vec<u8>, String> {
        let mut written = bytes.to_vec();
        overwrite(bytes, &mut written, "INPUT", &self.input(of))?;
        let indices: Vec<u32> = (0..3 * self.times).map(|place| place % 3).collect();
        overwrite(bytes, &mut written, "INDICES", &indices)?;
        Ok(written)
    }
}

/// Writes words over the start of a static of the file's `.data`.
fn overwrite(bytes: &[u8], written: &mut [u8], name: &str, words: &[u32]) -> Result<(), String> {
    let file = object::File::parse(bytes).map_err(|error| error.to_string())?;
    let wrong = || format!("the program has no room called {name}");
    let symbol = file.symbols().find(|symbol| symbol.name() == Ok(name)).ok_or_else(wrong)?;
    let section =
        symbol.section_index().and_then(|index| file.section_by_index(index).ok()).ok_or_else(wrong)?;
    let (start, _) = section.file_range().ok_or_else(wrong)?;
    let at = (start + symbol.address().wrapping_sub(section.address())) as usize;
    let size = 4 * words.len();
    if symbol.size() < size as u64 {
        return Err(wrong());
    }
    let room = written.get_mut(at..at + size).ok_or_else(wrong)?;
    for (bytes, word) in room.as_chunks_mut().0.iter_mut().zip(words) {
        *bytes = match file.endianness() {
            Endianness::Little => word.to_le_bytes(),
            Endianness::Big => word.to_be_bytes(),
        };
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_those_that_programs_read() {
        let window = Workload::small(16).input(Corners::Window { steps: 16 });
        assert_eq!(window[..6], [132, 132, 1 << 31, 140, 132, 1 << 31]);
        assert_eq!((window[32], window[33], window[16]), (48, 3, 0));
        let float = Workload::large(160).input(Corners::Float);
        assert_eq!(
            [3, 4, 5, 15, 16, 17, 21].map(|at| f32::from_bits(float[at])),
            [0.0, 63.5, 0.5, 1.0, 1.0, 0.0, 1.0]
        );
    }

    #[test]
    fn what_has_no_room_is_named() {
        let own = std::fs::read(std::env::current_exe().unwrap()).unwrap();
        let given = Workload::small(1).written(&own, Corners::Float);
        assert_eq!(given, Err("the program has no room called INPUT".to_owned()));
    }
}
