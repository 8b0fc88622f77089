//! What every loader and the built-in scene produce: positions, triangles, and what they look like.

use glam::{DVec3, Vec3};

/// A triangle list with one surface per triangle.
#[derive(Debug, Clone, Default)]
pub struct Mesh {
    /// Vertex positions in the model's own units; all finite.
    pub positions: Vec<[f32; 3]>,
    /// Three per triangle; all less than the number of positions.
    pub indices: Vec<u32>,
    /// Which of [`surfaces`](Self::surfaces) each triangle shows in the preview; empty: the first.
    pub surface_of: Vec<u8>,
    /// The surfaces; never empty once loaded.
    pub surfaces: Vec<Surface>,
}

/// How a triangle looks in the shaded preview.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface {
    /// Linear red, green and blue, 0 to 1.
    pub colour: [f32; 3],
    /// What the light does there.
    pub finish: Finish,
}

/// What light does at a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Finish {
    /// Scattered equally in all directions.
    Matte,
    /// Mirrored, the more the flatter the view: still water.
    Water,
    /// Given off, whatever falls in: lit windows, fire.
    Glow,
}

/// The surface of everything that brings no colours of its own.
pub const CLAY: Surface = Surface { colour: [0.55, 0.52, 0.48], finish: Finish::Matte };

/// The smallest axis-aligned box round a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// The corner with the smallest coordinates.
    pub min: DVec3,
    /// The corner with the largest coordinates.
    pub max: DVec3,
}

impl Mesh {
    /// A mesh in one colour.
    #[must_use]
    pub fn plain(positions: Vec<[f32; 3]>, indices: Vec<u32>) -> Self {
        Self { positions, indices, surface_of: Vec::new(), surfaces: vec![CLAY] }
    }

    /// How many triangles it has.
    #[must_use]
    pub fn triangles(&self) -> usize {
        self.indices.len() / 3
    }

    /// The corners of triangle `id`, or `None` past the last triangle.
    #[must_use]
    pub fn corners(&self, id: u32) -> Option<[DVec3; 3]> {
        let first = 3 * id as usize;
        let corner = |k: usize| {
            let index = *self.indices.get(first + k)?;
            let position = self.positions.get(index as usize)?;
            Some(Vec3::from(*position).as_dvec3())
        };
        Some([corner(0)?, corner(1)?, corner(2)?])
    }

    /// The surface of triangle `id`.
    #[must_use]
    pub fn surface(&self, id: u32) -> Surface {
        let which = self.surface_of.get(id as usize).copied().unwrap_or(0);
        self.surfaces.get(usize::from(which)).copied().unwrap_or(CLAY)
    }

    /// The box round all vertices that some triangle uses; `None` without triangles.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        let mut corners = self.used();
        let first = corners.next()?;
        Some(corners.fold(Bounds { min: first, max: first }, |bounds, p| Bounds {
            min: bounds.min.min(p),
            max: bounds.max.max(p),
        }))
    }

    /// The position of every corner of every triangle.
    pub fn used(&self) -> impl Iterator<Item = DVec3> + '_ {
        self.indices
            .iter()
            .filter_map(|&index| self.positions.get(index as usize))
            .map(|&position| Vec3::from(position).as_dvec3())
    }
}

impl Bounds {
    /// The middle.
    #[must_use]
    pub fn centre(&self) -> DVec3 {
        (self.min + self.max) * 0.5
    }

    /// The radius of the sphere round the box.
    #[must_use]
    pub fn radius(&self) -> f64 {
        (self.max - self.min).length() * 0.5
    }

    /// The eight corners.
    #[must_use]
    pub fn corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|k| {
            let pick = |bit: usize, low: f64, high: f64| if k >> bit & 1 == 0 { low } else { high };
            DVec3::new(
                pick(0, self.min.x, self.max.x),
                pick(1, self.min.y, self.max.y),
                pick(2, self.min.z, self.max.z),
            )
        })
    }
}
