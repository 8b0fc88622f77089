//! Tiled storage: where every pixel is, and how it is read back.

use crate::{Frame, ensure, ensure_eq, failure::Verdict, shapes::Random};
use halfplane::{Coverage, Format, StorageError, Tiled, blocks, texels};

/// The place of a pixel by the documented layout: blocks of 4x4 row by row, in each its pixels row by row.
fn documented(frame: &Frame, (x, y): (u32, u32)) -> usize {
    let (column, row) = ((x - frame.region[0]) as usize, (y - frame.region[1]) as usize);
    let pitch = (frame.width() as usize).div_ceil(4);
    (row / 4 * pitch + column / 4) * 16 + row % 4 * 4 + column % 4
}

/// The places are those of the layout, each pixel has its own, and what is beyond the region's blocks
/// is never touched; `get`, `block` and `to_linear` agree.
pub fn of_texels<F: Format>(frame: &Frame, spare: usize) -> Verdict {
    let needed = texels(frame.width(), frame.height());
    ensure_eq!(
        needed,
        frame.width().div_ceil(4) as usize * frame.height().div_ceil(4) as usize * 16,
        "texels"
    );
    // Each element holds its own place, so what is read says where it was read from.
    let mut storage: Vec<u32> = (0..(needed + spare) as u32).collect();
    let tiled = Tiled::<F, [u32; 16]>::of_texels(frame.core_region()?, &mut storage)?;
    let mut seen = vec![false; needed];
    for pixel in frame.pixels() {
        let place = documented(frame, pixel);
        ensure_eq!(tiled.get(pixel.0, pixel.1), Some(place as u32), "texel of pixel {pixel:?}");
        ensure_eq!(
            tiled.block(pixel.0, pixel.1).map(|block| block[0]),
            Some((place / 16 * 16) as u32),
            "block of {pixel:?}"
        );
        ensure!(!std::mem::replace(&mut seen[place], true), "pixel {pixel:?} shares its place");
    }
    let [x0, y0, x1, y1] = frame.region;
    for pixel in
        [(x1, y0), (x0, y1), (x0.wrapping_sub(1), y0), (x0, y0.wrapping_sub(1)), (u32::MAX, u32::MAX)]
    {
        ensure_eq!(tiled.get(pixel.0, pixel.1), None, "texel of pixel {pixel:?} outside");
        ensure_eq!(tiled.block(pixel.0, pixel.1), None, "block of pixel {pixel:?} outside");
    }
    let count = (frame.width() * frame.height()) as usize;
    let mut rows = vec![u32::MAX; count + spare];
    tiled.to_linear(&mut rows)?;
    for (pixel, &given) in frame.pixels().zip(&rows) {
        ensure_eq!(given as usize, documented(frame, pixel), "row value of pixel {pixel:?}");
    }
    ensure!(rows[count..].iter().all(|&v| v == u32::MAX), "written beyond the last row");
    let mut short = vec![u32::MAX; count - 1];
    let error = StorageError::BufferTooSmall { needed: count, given: count - 1 };
    ensure_eq!(tiled.to_linear(&mut short), Err(error), "rows one too short");
    ensure!(short.iter().all(|&v| v == u32::MAX), "written although refused");

    let mut tiled = Tiled::<F, [u32; 16]>::of_texels(frame.core_region()?, &mut storage)?;
    ensure_eq!(tiled.blocks_mut().len(), needed / 16, "blocks");
    tiled.fill(u32::MAX - 9);
    for (place, &value) in storage.iter().enumerate() {
        let expected = if place < needed { u32::MAX - 9 } else { place as u32 };
        ensure_eq!(value, expected, "element {place} after a fill");
    }
    Ok(())
}

/// `get` and `to_bits` of a coverage bitmap agree with the masks in the slice.
pub fn of_bits<F: Format>(frame: &Frame, seed: u64) -> Verdict {
    let mut random = Random(seed);
    let masks: Vec<u16> = (0..blocks(frame.width(), frame.height())).map(|_| random.bits() as u16).collect();
    let mut storage = masks.clone();
    let coverage = Coverage::<F>::new(frame.core_region()?, &mut storage)?;
    let pitch = frame.width().div_ceil(8) as usize;
    let needed = pitch * frame.height() as usize;
    let mut rows = vec![0xEE; needed + 3];
    coverage.to_bits(&mut rows)?;
    let mut set = 0;
    for pixel in frame.pixels() {
        let place = documented(frame, pixel);
        let expected = masks[place / 16] >> (place % 16) & 1 != 0;
        ensure_eq!(coverage.get(pixel.0, pixel.1), Some(expected), "pixel {pixel:?}");
        let (column, row) = ((pixel.0 - frame.region[0]) as usize, (pixel.1 - frame.region[1]) as usize);
        let bit = rows[row * pitch + column / 8] >> (column % 8) & 1 != 0;
        ensure_eq!(bit, expected, "bit of pixel {pixel:?}");
        set += u32::from(expected);
    }
    let bits: u32 = rows[..needed].iter().map(|byte| byte.count_ones()).sum();
    ensure_eq!(bits, set, "set bits: unused ones are 0");
    ensure!(rows[needed..].iter().all(|&byte| byte == 0xEE), "written beyond the last row");
    let error = StorageError::BufferTooSmall { needed, given: needed - 1 };
    ensure_eq!(coverage.to_bits(&mut vec![0; needed - 1]), Err(error), "rows one byte too short");
    Ok(())
}
