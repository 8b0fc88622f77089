//! The same picture from every entry point.

use crate::{Failure, Frame, ensure, ensure_eq, failure::Verdict, shapes::Corners};
use halfplane::{
    Attachment, Block, Bounds, ClipPositions, Coverage, Depth, DepthFormat, DepthTest, Format, Ids, Region,
    State, Triangle, Vertex, Viewport, blocks, draw, texels, traverse, unorm32,
};

/// Triangles with depths as floats from 0 to 1, so that clip space can carry them.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Corners in steps and depths.
    pub triangles: Vec<(Corners, [f32; 3])>,
    /// The sides of the target: powers of two, so that clip space is exact.
    pub size: [u32; 2],
    /// The scissor, inside the target.
    pub scissor: [u32; 4],
    /// Where the draws are cut in two, and how high bands are (in blocks).
    pub cut: usize,
    /// Steps in a pixel.
    steps_per_pixel: u16,
}

/// A picture of a region, by pixel.
type Pixels = Vec<(Option<bool>, Option<u32>, Option<u32>)>;

/// The first id of every draw of the whole scene.
const FIRST_ID: u32 = 1000;

type All<'s, 'm, F, D> = (Coverage<'m, F>, Depth<'s, F, D>, Ids<'s, F>);

/// Makes the attachments of a region, lets `paint` draw, and reads them back.
fn painted<F: Format, D: DepthFormat<F>>(
    region: Region<F>,
    paint: impl FnOnce(&mut All<'_, '_, F, D>) -> Verdict,
) -> Result<Pixels, Failure> {
    let (width, height) = (region.width(), region.height());
    let mut masks = vec![0; blocks(width, height)];
    let mut depths = vec![D::FAR; texels(width, height)];
    let mut ids = vec![0; texels(width, height)];
    let mut all = (
        Coverage::new(region, &mut masks)?,
        Depth::new(region, &mut depths, DepthTest::LESS)?,
        Ids::new(region, &mut ids)?,
    );
    all.2.clear();
    paint(&mut all)?;
    let (coverage, depth, ids) = &all;
    let pixel = |(x, y)| (coverage.get(x, y), depth.get(x, y).map(Into::into), ids.get(x, y));
    let rows = (region.y0()..region.y1()).flat_map(|y| (region.x0()..region.x1()).map(move |x| (x, y)));
    Ok(rows.map(pixel).collect())
}

/// Draws one scene through u16 and u32 indices, in one draw and in two, by hand, from clip space, in
/// bands, in tiles and through coverage alone.
pub fn all_draw_the_same<F: Format, D: DepthFormat<F>>(scene: &Scene) -> Verdict {
    let [width, height] = scene.size;
    let [x0, y0, x1, y1] = scene.scissor;
    let target = Region::<F>::of_size(width, height)?;
    let state = State::new(Region::new(x0, y0, x1, y1)?);
    let mut vertices = Vec::new();
    for (corners, z) in &scene.triangles {
        vertices.extend(crate::frame::window_vertices::<F>(corners, z.map(unorm32))?);
    }
    let vertices = &vertices[..];
    let wide: Vec<u32> = (0..vertices.len() as u32).collect();
    let short: Vec<u16> = (0..vertices.len() as u16).collect();

    let expected = painted::<F, D>(target, |all| {
        draw(vertices, &wide, FIRST_ID, &state, all)?;
        Ok(())
    })?;
    let same = |name: &str, region: Region<F>, given: Pixels| -> Verdict {
        let mut given = given.into_iter();
        for y in region.y0()..region.y1() {
            for x in region.x0()..region.x1() {
                let expected = expected[(y * width + x) as usize];
                ensure_eq!(given.next(), Some(expected), "{name}: pixel ({x}, {y})");
            }
        }
        Ok(())
    };

    same(
        "u16 indices",
        target,
        painted::<F, D>(target, |all| {
            draw(vertices, &short, FIRST_ID, &state, all)?;
            Ok(())
        })?,
    )?;
    same(
        "two draws",
        target,
        painted::<F, D>(target, |all| {
            let cut = scene.cut % (scene.triangles.len() + 1);
            draw(vertices, &wide[..3 * cut], FIRST_ID, &state, all)?;
            draw(vertices, &wide[3 * cut..], FIRST_ID + cut as u32, &state, all)?;
            Ok(())
        })?,
    )?;
    same(
        "by hand",
        target,
        painted::<F, D>(target, |all| {
            by_hand(vertices, &state, all);
            Ok(())
        })?,
    )?;
    let clip = clip_space(scene);
    same(
        "clip space",
        target,
        painted::<F, D>(target, |all| {
            let positions = ClipPositions::new(&clip, Viewport::new(target));
            draw(&positions, &wide, FIRST_ID, &state, all)?;
            Ok(())
        })?,
    )?;
    for region in parts::<F>(scene)? {
        let Some(scissor) = state.scissor.intersect(region) else { continue };
        same(
            "a part",
            region,
            painted::<F, D>(region, |all| {
                draw(vertices, &short, FIRST_ID, &State { scissor, ..state }, all)?;
                Ok(())
            })?,
        )?;
    }

    // Attachments do not see each other but by what they let through.
    let mut masks = vec![0; blocks(width, height)];
    let mut coverage = Coverage::new(target, &mut masks)?;
    draw(vertices, &wide, FIRST_ID, &state, &mut coverage)?;
    for (pixel, expected) in Frame::whole::<F>(width, height).pixels().zip(&expected) {
        ensure_eq!(coverage.get(pixel.0, pixel.1), expected.0, "coverage alone: pixel {pixel:?}");
        let seen = expected.2 != Some(halfplane::NO_ID);
        ensure!(expected.0 == Some(seen), "pixel {pixel:?} is covered and has no id, or the reverse");
    }
    Ok(())
}

/// What `draw` does, from the level below it.
fn by_hand<F: Format, A: Attachment<F>>(vertices: &[Vertex<F>], state: &State<F>, attachments: &mut A) {
    for (id, corners) in (FIRST_ID..).zip(vertices.as_chunks::<3>().0) {
        if let Some(triangle) = Triangle::new(*corners, state.sample) {
            attachments.begin(&triangle);
            traverse(&triangle, state.scissor, |x, y, mask| {
                attachments.block(&Block { x, y, mask, triangle: &triangle, id });
            });
        }
    }
}

/// The same triangles in clip space, w = 1: nothing is rounded, as the sides are powers of two and a
/// coordinate has at most 24 bits.
fn clip_space(scene: &Scene) -> Vec<[f32; 4]> {
    let [half_width, half_height] = scene.size.map(|side| side as f32 / 2.0);
    let vertex = |([x, y], z): ([f32; 2], f32)| {
        [(x - half_width) / half_width, (half_height - y) / half_height, z, 1.0]
    };
    let pixels = |[x, y]: [i32; 2]| [x as f32 / scene.steps(), y as f32 / scene.steps()];
    scene
        .triangles
        .iter()
        .flat_map(|(corners, z)| [0, 1, 2].map(|k| vertex((pixels(corners[k]), z[k]))))
        .collect()
}

/// Bands of whole blocks, and tiles.
fn parts<F: Format>(scene: &Scene) -> Result<Vec<Region<F>>, Failure> {
    let [width, height] = scene.size;
    let band = 4 * (1 + scene.cut as u32 % 5);
    let mut parts = Vec::new();
    for y in (0..height).step_by(band as usize) {
        parts.push(Region::new(0, y, width, (y + band).min(height))?);
    }
    for y in (0..height).step_by(20) {
        for x in (0..width).step_by(12) {
            parts.push(Region::new(x, y, (x + 12).min(width), (y + 20).min(height))?);
        }
    }
    Ok(parts)
}

impl Scene {
    fn steps(&self) -> f32 {
        f32::from(self.steps_per_pixel)
    }

    /// A scene whose coordinates stay where nothing is clipped.
    pub fn new<F: Format>(
        triangles: Vec<(Corners, [f32; 3])>,
        size: [u32; 2],
        scissor: [u32; 4],
        cut: usize,
    ) -> Self {
        let limit = Bounds::<F>::CLIP_PIXELS * Bounds::<F>::STEPS_PER_PIXEL;
        let inside = |(corners, z): (Corners, [f32; 3])| {
            (corners.map(|corner| corner.map(|v| v.clamp(-limit, limit))), z)
        };
        Self {
            triangles: triangles.into_iter().map(inside).collect(),
            size,
            scissor,
            cut,
            steps_per_pixel: Bounds::<F>::STEPS_PER_PIXEL as u16,
        }
    }
}

/// An attachment that lets everything through, also what is not covered.
struct Careless;

impl<F: Format> Attachment<F> for Careless {
    fn block(&mut self, _: &Block<'_, F>) -> halfplane::Mask {
        halfplane::Mask::FULL
    }
}

/// What an attachment lets through that is not covered is not drawn by later ones.
pub fn careless_attachments_cover_nothing_more<F: Format>(frame: &Frame, corners: &Corners) -> Verdict {
    let mut masks = vec![0; blocks(frame.width(), frame.height())];
    let mut coverage = Coverage::<F>::new(frame.core_region()?, &mut masks)?;
    let vertices = crate::frame::window_vertices::<F>(corners, [9; 3])?;
    draw(&vertices[..], &[0u16, 1, 2], 0, &frame.state()?, &mut (Careless, &mut coverage, ()))?;
    let expected = crate::oracle::coverage::<F>(frame, corners)?;
    for (pixel, expected) in frame.pixels().zip(expected) {
        ensure_eq!(coverage.get(pixel.0, pixel.1), Some(expected), "pixel {pixel:?}");
    }
    Ok(())
}
