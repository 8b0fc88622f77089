//! Every named error is produced, with the right numbers in it, and nothing is written then.

use crate::{Failure, ensure, ensure_eq, failure::Verdict};
use halfplane::{
    Bounds, Coverage, D16, Depth, DepthTest, DrawError, Format, Ids, OutsideAttachment, OutsideGuardBand,
    Region, RegionError, State, Statistics, StorageError, Vertex, blocks, draw, texels,
};

/// What a refused draw is given.
#[derive(Clone, Copy, Debug)]
pub struct Refused {
    /// Width and height of the attachments.
    pub size: [u32; 2],
    /// Triangles in the index list.
    pub triangles: u32,
    /// Where the fault is put, modulo what there is.
    pub at: u32,
    /// How far beyond the limit it is.
    pub beyond: u32,
}

type Attachments<'a, F> = (Coverage<'a, F>, Depth<'a, F, D16>, Ids<'a, F>);

/// Draws with good vertices into buffers filled with a pattern, and fails if any of it changed.
fn refused<F: Format>(
    case: Refused,
    indices: &[u32],
    draw: impl Fn(&[Vertex<F>], &[u32], &mut Attachments<'_, F>) -> Result<Statistics, DrawError>,
) -> Result<DrawError, Failure> {
    let [width, height] = case.size;
    let region = Region::<F>::of_size(width, height)?;
    let mut masks = vec![0xA5A5; blocks(width, height)];
    let mut depths = vec![0x5A5A; texels(width, height)];
    let mut ids = vec![0xDEAD_BEEF; texels(width, height)];
    let mut attachments = (
        Coverage::new(region, &mut masks)?,
        Depth::new(region, &mut depths, DepthTest::LESS)?,
        Ids::new(region, &mut ids)?,
    );
    let end = Bounds::<F>::GUARD_BAND;
    let vertices = [Vertex::new(0, 0, 9)?, Vertex::new(end, 0, 9)?, Vertex::new(0, end, 9)?];
    let outcome = draw(&vertices, indices, &mut attachments);
    let untouched = masks.iter().all(|&mask| mask == 0xA5A5)
        && depths.iter().all(|&depth| depth == 0x5A5A)
        && ids.iter().all(|&id| id == 0xDEAD_BEEF);
    match outcome {
        Ok(statistics) => Err(Failure::new(format_args!("not refused: {statistics}"))),
        Err(_) if !untouched => Err(Failure::new("a refused draw has written")),
        Err(error) => Ok(error),
    }
}

/// All errors of a draw.
pub fn of_draws<F: Format>(case: Refused) -> Verdict {
    let [width, height] = case.size;
    let state = State::new(Region::<F>::of_size(width, height)?);
    let good: Vec<u32> = (0..3 * case.triangles).map(|k| k % 3).collect();

    // One or two indices too many.
    let mut indices = good.clone();
    indices.extend((0..1 + case.beyond % 2).map(|_| 0));
    let error = refused::<F>(case, &indices, |vertices, indices, a| draw(vertices, indices, 0, &state, a))?;
    ensure_eq!(error, DrawError::IndexCount { count: indices.len() }, "one index too many");

    // An index that names no vertex, and a second one after it that is not reported.
    let at = (case.at % (3 * case.triangles)) as usize;
    let index = 3 + case.beyond % (u32::MAX - 2);
    let mut indices = good.clone();
    indices[at] = index;
    if let Some(later) = indices.get_mut(at + 1) {
        *later = u32::MAX;
    }
    let error = refused::<F>(case, &indices, |vertices, indices, a| draw(vertices, indices, 0, &state, a))?;
    ensure_eq!(error, DrawError::IndexOutOfRange { at, index, vertices: 3 }, "an index that names no vertex");
    let short: Vec<u16> = indices.iter().map(|&index| index.min(0xFFFF) as u16).collect();
    let error = refused::<F>(case, &indices, |vertices, _, a| draw(vertices, &short, 0, &state, a))?;
    let index = index.min(0xFFFF);
    ensure_eq!(
        error,
        DrawError::IndexOutOfRange { at, index, vertices: 3 },
        "a u16 index that names no vertex"
    );

    // Ids that do not fit.
    let first_id = u32::MAX - case.beyond % case.triangles;
    let triangles = case.triangles as usize;
    let error =
        refused::<F>(case, &good, |vertices, indices, a| draw(vertices, indices, first_id, &state, a))?;
    ensure_eq!(error, DrawError::TooManyIds { first_id, triangles }, "ids that do not fit");

    // A scissor that reaches beyond the attachments.
    let large = Region::<F>::new(0, 0, width, height + 1 + case.beyond % (F::MAX_TARGET - height))?;
    let beyond = State { scissor: large, ..state };
    let error = refused::<F>(case, &good, |vertices, indices, a| draw(vertices, indices, 0, &beyond, a))?;
    let outside = OutsideAttachment { area: [0, 0, width, large.y1()], attachment: [0, 0, width, height] };
    ensure_eq!(error, DrawError::OutsideAttachment(outside), "a scissor beyond the attachments");
    ensure!(!error.to_string().is_empty(), "an error without a message");
    Ok(())
}

/// The last ids that fit are drawn; there is no room for more.
pub fn of_last_ids<F: Format>(triangles: u32) -> Verdict {
    let region = Region::<F>::of_size(8, 8)?;
    let mut storage = vec![7; texels(8, 8)];
    let mut ids = Ids::new(region, &mut storage)?;
    let end = Bounds::<F>::GUARD_BAND;
    let vertices = [Vertex::<F>::new(0, 0, 9)?, Vertex::new(end, 0, 9)?, Vertex::new(0, end, 9)?];
    let indices: Vec<u32> = (0..3 * triangles).map(|k| k % 3).collect();
    let statistics = draw(&vertices[..], &indices, u32::MAX - triangles, &State::new(region), &mut ids)?;
    ensure_eq!(statistics.drawn, triangles, "drawn");
    let expected = if triangles == 0 { 7 } else { u32::MAX - 1 };
    ensure_eq!(ids.get(0, 0), Some(expected), "the last id");
    Ok(())
}

/// The errors of regions.
pub fn of_regions<F: Format>([x0, y0, x1, y1]: [u32; 4]) -> Verdict {
    let limit = F::MAX_TARGET;
    let expected = if x1 > limit || y1 > limit {
        Err(RegionError::TargetTooLarge { x1, y1, limit })
    } else if x0 >= x1 || y0 >= y1 {
        Err(RegionError::Empty { width: x1.saturating_sub(x0), height: y1.saturating_sub(y0) })
    } else {
        Ok([x0, y0, x1, y1])
    };
    let given = Region::<F>::new(x0, y0, x1, y1);
    ensure_eq!(given.map(|r| [r.x0(), r.y0(), r.x1(), r.y1()]), expected, "region {x0} {y0} {x1} {y1}");
    Ok(())
}

/// The errors of storage: too small by so many elements, and not at multiples of 4.
pub fn of_storage<F: Format>(x0: u32, y0: u32, size: [u32; 2], missing: usize) -> Verdict {
    let [width, height] = size;
    let region = Region::<F>::new(x0, y0, x0 + width, y0 + height)?;
    let mut ids = vec![0u32; texels(width, height)];
    let mut masks = vec![0u16; blocks(width, height)];
    let (ids_needed, masks_needed) = (ids.len(), masks.len());
    if !x0.is_multiple_of(4) || !y0.is_multiple_of(4) {
        let expected = Some(StorageError::RegionNotAligned { x0, y0 });
        ensure_eq!(Ids::new(region, &mut ids).err(), expected, "ids at ({x0}, {y0})");
        ensure_eq!(Coverage::new(region, &mut masks).err(), expected, "coverage at ({x0}, {y0})");
        return Ok(());
    }
    ensure!(Ids::new(region, &mut ids).is_ok(), "ids that fit are refused");
    ensure!(Coverage::new(region, &mut masks).is_ok(), "coverage that fits is refused");
    let (ids_given, masks_given) =
        (ids_needed - 1 - missing % ids_needed, masks_needed - 1 - missing % masks_needed);
    let short = Ids::new(region, &mut ids[..ids_given]).err();
    let expected = StorageError::BufferTooSmall { needed: ids_needed, given: ids_given };
    ensure_eq!(short, Some(expected), "ids {missing} too short");
    let short = Coverage::new(region, &mut masks[..masks_given]).err();
    let expected = StorageError::BufferTooSmall { needed: masks_needed, given: masks_given };
    ensure_eq!(short, Some(expected), "coverage {missing} too short");
    Ok(())
}

/// The error of vertices: exactly those outside the guard band, whose ends are inside.
pub fn of_vertices<F: Format>(x: i32, y: i32) -> Verdict {
    let limit = Bounds::<F>::GUARD_BAND;
    let inside = |v: i32| (-i64::from(limit)..=i64::from(limit)).contains(&i64::from(v));
    let given = Vertex::<F>::new(x, y, 0).map(|v| (v.x(), v.y()));
    let expected = if inside(x) && inside(y) { Ok((x, y)) } else { Err(OutsideGuardBand { x, y, limit }) };
    ensure_eq!(given, expected, "vertex ({x}, {y})");
    Ok(())
}
