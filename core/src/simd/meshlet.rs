//! Meshlets: runs of a mesh's triangles with vertices of their own and a box round them, made once per
//! mesh, so that a draw passes over those outside the view frustum unseen.

use super::cone::{self, Cone};
use crate::{
    draw::{self, DrawError, Index},
    geometry::{Assembly, Positions, Region, Vertex},
    numbers::Standard,
    transform::{ModelPositions, assemble},
};
use core::{error::Error, fmt};

/// Most vertices of a meshlet.
pub(super) const VERTICES: usize = 96;
/// Most triangles of a meshlet.
pub(super) const TRIANGLES: usize = 128;

/// Consecutive triangles of a mesh, and the vertices they use.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Meshlet {
    /// The box round the vertices; not finite where a vertex is not.
    pub(super) low: [f32; 3],
    pub(super) high: [f32; 3],
    /// What the triangles' normals have in common, if anything.
    cone: Option<Cone>,
    /// How many vertices and triangles there are.
    vertices: u8,
    pub(super) triangles: u8,
    /// The number of the first triangle in the mesh.
    pub(super) first: u32,
    /// x, y and z of the vertices, and of the last one again in the places left.
    pub(super) positions: [[f32; VERTICES]; 3],
    corners: [[u8; 3]; TRIANGLES],
}

// What there is about it beside vertices and indices fits into its last line.
const _: () = assert!(size_of::<Meshlet>() == (3 * (4 * VERTICES + TRIANGLES)).next_multiple_of(64) + 64);

/// Meshlets that cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshletError {
    /// The indices are none that could be drawn.
    Indices(DrawError),
    /// There is room for too few meshlets.
    TooFew {
        /// Meshlets needed.
        needed: usize,
        /// Meshlets given.
        given: usize,
    },
}

impl fmt::Display for MeshletError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Indices(error) => error.fmt(f),
            Self::TooFew { needed, given } => {
                write!(f, "room for {given} meshlets: the mesh needs {needed}")
            }
        }
    }
}

impl Error for MeshletError {}

/// How many meshlets a mesh of that many triangles can need at most: each but the last has 21 triangles
/// or more.
#[must_use]
pub const fn max_meshlets(triangles: usize) -> usize {
    triangles.div_ceil(VERTICES / 3)
}

/// Makes the meshlets of a triangle list, three indices into `positions` each, in the order of the
/// triangles; those that were made.
///
/// # Errors
///
/// [`MeshletError::Indices`] with [`DrawError::IndexCount`], [`DrawError::IndexOutOfRange`] or
/// [`DrawError::TooManyIds`], nothing is written then; [`MeshletError::TooFew`] where `meshlets` is too
/// short, its contents mean nothing then.
pub fn make_meshlets<'m, I: Index>(
    positions: &[[f32; 3]],
    indices: &[I],
    meshlets: &'m mut [Meshlet],
) -> Result<&'m mut [Meshlet], MeshletError> {
    let triangles = draw::check_indices(indices, positions.len()).map_err(MeshletError::Indices)?;
    if u32::try_from(triangles.len()).is_err() {
        let error = DrawError::TooManyIds { first_id: 0, triangles: triangles.len() };
        return Err(MeshletError::Indices(error));
    }
    let given = meshlets.len();
    let mut made = Made { meshlets, count: 0 };
    let mut builder = Builder::new(0);
    for (number, corners) in (0..).zip(triangles) {
        let corners = corners.map(Index::to_u32);
        if !builder.add(corners, positions) {
            made.push(&builder);
            builder = Builder::new(number);
            builder.add(corners, positions);
        }
    }
    if builder.meshlet.triangles > 0 {
        made.push(&builder);
    }
    let Made { meshlets, count: needed } = made;
    meshlets.get_mut(..needed).ok_or(MeshletError::TooFew { needed, given })
}

/// Meshlets that were made, of which there may be more than there is room for.
pub(super) struct Made<'m> {
    pub(super) meshlets: &'m mut [Meshlet],
    pub(super) count: usize,
}

impl Made<'_> {
    /// Finishes one and counts it.
    pub(super) fn push(&mut self, builder: &Builder) {
        if let Some(to) = self.meshlets.get_mut(self.count) {
            *to = builder.finish();
        }
        self.count += 1;
    }
}

/// A meshlet in the making.
pub(super) struct Builder {
    pub(super) meshlet: Meshlet,
    /// The mesh's numbers of the vertices.
    names: [u32; VERTICES],
}

impl Builder {
    pub(super) fn new(first: u32) -> Self {
        Self { meshlet: Meshlet { first, ..Meshlet::EMPTY }, names: [0; VERTICES] }
    }

    /// Adds a triangle; `false`, and nothing changes, where it does not fit.
    pub(super) fn add(&mut self, corners: [u32; 3], positions: &[[f32; 3]]) -> bool {
        let mut names = self.names;
        let mut vertices = self.meshlet.vertices;
        let mut places = [0; 3];
        for (place, name) in places.iter_mut().zip(corners) {
            let known = names.iter().take(usize::from(vertices)).position(|&known| known == name);
            *place = match (known, names.get_mut(usize::from(vertices))) {
                (Some(known), _) => known as u8,
                (None, Some(next)) => {
                    *next = name;
                    vertices += 1;
                    vertices - 1
                }
                (None, None) => return false,
            };
        }
        let Some(to) = self.meshlet.corners.get_mut(usize::from(self.meshlet.triangles)) else {
            return false;
        };
        *to = places;
        self.meshlet.triangles += 1;
        for at in self.meshlet.vertices..vertices {
            if let Some(position) = names.get(usize::from(at)).and_then(|&name| positions.get(name as usize))
            {
                self.meshlet.place(usize::from(at), *position);
            }
        }
        self.meshlet.vertices = vertices;
        self.names = names;
        true
    }

    /// The meshlet, its places without a vertex filled, and the cone of its normals.
    fn finish(&self) -> Meshlet {
        let mut finished = self.meshlet;
        let vertices = usize::from(finished.vertices);
        for axis in &mut finished.positions {
            let last = axis.get(vertices.wrapping_sub(1)).copied().unwrap_or(0.0);
            for value in axis.iter_mut().skip(vertices) {
                *value = last;
            }
        }
        let meshlet = &finished;
        let place = |at: u8| meshlet.position(usize::from(at)).unwrap_or([f32::NAN; 3]);
        let triangles = meshlet.corners().iter().map(|corners| corners.map(place));
        let cone = Cone::new(cone::middle(meshlet.corners_of_box()), triangles);
        Meshlet { cone, ..finished }
    }
}

impl Meshlet {
    /// A meshlet without triangles, to fill arrays with.
    pub const EMPTY: Self = Self {
        low: [f32::INFINITY; 3],
        high: [f32::NEG_INFINITY; 3],
        cone: None,
        vertices: 0,
        triangles: 0,
        first: 0,
        positions: [[0.0; VERTICES]; 3],
        corners: [[0; 3]; TRIANGLES],
    };

    /// Sets a vertex and widens the box.
    pub(super) fn place(&mut self, at: usize, position: [f32; 3]) {
        let finite = position.iter().all(|v| v.is_finite());
        let axes = self.positions.iter_mut().zip(self.low.iter_mut().zip(&mut self.high));
        for ((axis, (low, high)), value) in axes.zip(position) {
            if let Some(to) = axis.get_mut(at) {
                *to = value;
            }
            // Infinite once, infinite for ever.
            *low = low.min(if finite { value } else { f32::NEG_INFINITY });
            *high = high.max(if finite { value } else { f32::INFINITY });
        }
    }

    /// Two opposite corners of the box round it, in object space: the smallest x, y and z, and the largest.
    #[must_use]
    pub const fn corners_of_box(&self) -> [[f32; 3]; 2] {
        [self.low, self.high]
    }

    /// Whether its triangles face much the same way, so that [`draw_batches`](super::draw_batches) can leave them out
    /// together where they are culled.
    #[must_use]
    pub const fn has_cone(&self) -> bool {
        self.cone.is_some()
    }

    /// What its triangles' normals have in common.
    #[inline(always)]
    pub(super) const fn cone(&self) -> Option<&Cone> {
        self.cone.as_ref()
    }

    /// The numbers of its triangles in the mesh.
    #[must_use]
    pub fn triangles(&self) -> core::ops::Range<u32> {
        self.first..self.first.saturating_add(u32::from(self.triangles))
    }

    /// How many triangles there are.
    pub(super) const fn count(&self) -> u32 {
        self.triangles as u32
    }

    /// The number after that of its last triangle.
    pub(super) fn end(&self) -> usize {
        self.triangles().end as usize
    }

    /// How many vertices there are.
    pub(super) fn vertices(&self) -> usize {
        usize::from(self.vertices)
    }

    /// The triangles' corners, as places among the vertices.
    pub(super) fn corners(&self) -> &[[u8; 3]] {
        self.corners.get(..usize::from(self.triangles)).unwrap_or(&[])
    }

    /// The number of the first triangle in the mesh.
    pub(super) const fn first(&self) -> u32 {
        self.first
    }

    /// A vertex.
    pub(super) fn position(&self, at: usize) -> Option<[f32; 3]> {
        let [x, y, z] = &self.positions;
        if at >= self.vertices() {
            return None;
        }
        Some([*x.get(at)?, *y.get(at)?, *z.get(at)?])
    }
}

/// A meshlet's vertices as a draw's positions.
pub(super) struct MeshletPositions<'a> {
    pub(super) meshlet: &'a Meshlet,
    /// The matrix and the viewport; vertices of its own do not matter.
    pub(super) camera: &'a ModelPositions<'a, Standard>,
}

impl Positions<Standard> for MeshletPositions<'_> {
    fn count(&self) -> usize {
        self.meshlet.vertices()
    }

    fn window(&self) -> Option<Region<Standard>> {
        self.camera.window()
    }

    fn assemble<E: FnMut([Vertex<Standard>; 3])>(&self, corners: [usize; 3], emit: E) -> Assembly {
        let [a, b, c] = corners.map(|at| self.meshlet.position(at).map(|p| self.camera.clip_point(p)));
        match (a, b, c) {
            (Some(a), Some(b), Some(c)) => {
                assemble([a, b, c], self.camera.viewport(), self.camera.planes(), emit)
            }
            _ => Assembly::NoVertex,
        }
    }
}
