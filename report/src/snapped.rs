//! What the reference is given: the window triangles of a draw, as the rasterizer's own transform snaps them.

use halfplane::{Assembly, ClipPositions, Cull, Positions, Standard, State, Viewport, Winding};
use halfplane_reference::{DepthSpec, Scene, SceneTriangle, z16_from_z32};

/// A triangle that reached the window as it was: its vertices in the mesh and in the window.
#[derive(Debug, Clone, Copy)]
pub struct Whole {
    /// Vertex numbers.
    pub corners: [usize; 3],
    /// Snapped positions in sub-pixel steps.
    pub xy: [[i32; 2]; 3],
}

/// The window triangles of a draw, in its order; and which triangles of the mesh were drawn without clipping.
#[must_use]
pub fn assemble(
    clip: &[[f32; 4]],
    indices: &[u32],
    state: &State<Standard>,
    spec: DepthSpec,
) -> (Scene, Vec<Whole>) {
    let region = state.scissor;
    let positions = ClipPositions::new(clip, Viewport::<Standard>::new(region));
    let mut scene = Scene {
        width: region.width(),
        height: region.height(),
        subpixel_bits: <Standard as halfplane::Format>::SUBPIXEL_BITS,
        sample: (128, 128),
        triangles: Vec::new(),
    };
    let mut whole = Vec::new();
    for (id, corners) in (0..).zip(indices.chunks_exact(3)) {
        let corners = [0, 1, 2].map(|k| corners[k] as usize);
        let mut last = None;
        let assembly = positions.assemble(corners, |vertices| {
            let xy = vertices.map(|vertex| [vertex.x(), vertex.y()]);
            last = Some(xy);
            if is_culled(xy, state) {
                return;
            }
            let z = vertices.map(|vertex| match spec.bits() {
                16 => u32::from(z16_from_z32(vertex.z())),
                _ => vertex.z(),
            });
            scene.triangles.push(SceneTriangle { xy, z, id });
        });
        if let (Assembly::Whole, Some(xy)) = (assembly, last) {
            whole.push(Whole { corners, xy });
        }
    }
    (scene, whole)
}

/// Whether a window triangle faces the culled way, from its definition: clockwise on the y-down screen
/// is a positive area.
fn is_culled([a, b, c]: [[i32; 2]; 3], state: &State<Standard>) -> bool {
    let delta = |p: [i32; 2]| [0, 1].map(|k| i64::from(p[k]) - i64::from(a[k]));
    let ([bx, by], [cx, cy]) = (delta(b), delta(c));
    let area = i128::from(bx) * i128::from(cy) - i128::from(by) * i128::from(cx);
    let front = match state.front {
        Winding::Clockwise => area > 0,
        Winding::CounterClockwise => area < 0,
    };
    match state.cull {
        Cull::None => false,
        Cull::Back => !front,
        Cull::Front => front,
    }
}
