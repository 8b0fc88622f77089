//! Shadows: the rasterizer's own depth buffers, seen from the sun.

use glam::DVec3;
use halfplane::{ClipPositions, Depth, DepthTest, Region, Standard, State, Viewport, draw, texels};

use crate::camera::{Hand, View};
use crate::mesh::Mesh;
use crate::render::RenderError;

/// Side of a map in pixels.
const SIDE: u32 = 2048;
/// How far before and behind its middle a map sees.
const DEEP: f64 = 5000.0;

/// The middle and the radius of what each map shows, finest first.
const CASCADES: [(DVec3, f64); 3] = [
    (DVec3::new(0.0, 6.0, 5.0), 27.0),
    (DVec3::new(45.0, 5.0, 115.0), 95.0),
    (DVec3::new(120.0, 50.0, 560.0), 620.0),
];

/// What the sun sees of a scene.
pub(super) struct Shadows {
    maps: Vec<Map>,
}

struct Map {
    middle: DVec3,
    radius: f64,
    axes: [DVec3; 3],
    depth: Vec<u32>,
}

impl Shadows {
    /// Draws the maps.
    pub(super) fn new(mesh: &Mesh, sun: DVec3) -> Result<Self, RenderError> {
        let view = View { eye: DVec3::ZERO, forward: -sun, up: DVec3::Y };
        let Ok(axes) = view.axes(Hand::Left) else {
            // A sun straight overhead: no scene has one.
            return Ok(Self { maps: Vec::new() });
        };
        let maps = CASCADES.iter().map(|&(middle, radius)| Map::draw(mesh, middle, radius, axes));
        Ok(Self { maps: maps.collect::<Result<_, _>>()? })
    }

    /// The part of the sun that reaches `point`, of a surface with that normal: 0 to 1.
    pub(super) fn open(&self, point: DVec3, normal: DVec3) -> f64 {
        self.maps.iter().find_map(|map| map.open(point, normal)).unwrap_or(1.0)
    }
}

impl Map {
    fn draw(mesh: &Mesh, middle: DVec3, radius: f64, axes: [DVec3; 3]) -> Result<Self, RenderError> {
        let mut map = Self { middle, radius, axes, depth: Vec::new() };
        let clip: Vec<[f32; 4]> = mesh
            .positions
            .iter()
            .map(|&position| {
                let [x, y, z] = map.project(DVec3::from(position.map(f64::from)));
                [x as f32, y as f32, z as f32, 1.0]
            })
            .collect();
        let region = Region::<Standard>::of_size(SIDE, SIDE)?;
        let mut storage = vec![u32::MAX; texels(SIDE, SIDE)];
        let mut depth = Depth::<Standard>::new(region, &mut storage, DepthTest::LESS)?;
        let positions = ClipPositions::new(&clip, Viewport::new(region));
        draw(&positions, &mesh.indices, 0, &State::new(region), &mut depth)?;
        map.depth = vec![0; SIDE as usize * SIDE as usize];
        depth.to_linear(&mut map.depth)?;
        Ok(map)
    }

    /// Clip space of the map; w is 1.
    fn project(&self, point: DVec3) -> [f64; 3] {
        let offset = point - self.middle;
        let [right, up, forward] = self.axes;
        let along = (offset.dot(forward) + DEEP) / (2.0 * DEEP);
        [offset.dot(right) / self.radius, offset.dot(up) / self.radius, along]
    }

    /// As [`Shadows::open`]; `None` outside the map.
    fn open(&self, point: DVec3, normal: DVec3) -> Option<f64> {
        let texel = 2.0 * self.radius / f64::from(SIDE);
        // Off the surface, so that it does not shade itself.
        let [x, y, z] = self.project(point + normal * (1.6 * texel));
        let side = f64::from(SIDE);
        let (column, row) = ((x * 0.5 + 0.5) * side - 0.5, (0.5 - y * 0.5) * side - 0.5);
        if !(2.0..side - 3.0).contains(&column) || !(2.0..side - 3.0).contains(&row) {
            return None;
        }
        let depth = (z - 0.6 * texel / (2.0 * DEEP)) * f64::from(u32::MAX);
        let (left, top) = (column.floor(), row.floor());
        let (part_x, part_y) = (column - left, row - top);
        let lit = |dx: i64, dy: i64| {
            let at = (top as i64 + dy) * i64::from(SIDE) + left as i64 + dx;
            let seen = self.depth.get(at as usize).copied().unwrap_or(u32::MAX);
            f64::from(u8::from(depth <= f64::from(seen)))
        };
        // Four by four texels, weighted so that the sum moves smoothly with the point.
        let weights = |part: f64| [1.0 - part, 1.0, 1.0, part];
        let mut sum = 0.0;
        for (dy, weight_y) in (-1..).zip(weights(part_y)) {
            for (dx, weight_x) in (-1..).zip(weights(part_x)) {
                sum += weight_x * weight_y * lit(dx, dy);
            }
        }
        Some(sum / 9.0)
    }
}
