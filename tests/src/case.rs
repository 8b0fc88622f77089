//! A mesh and how it is drawn, made from any numbers: what properties of the vector code, of bounds and of batches are
//! given.

use crate::{
    Failure, Frame,
    frame::into_guard_band,
    shapes::{Corners, Kind, Model, Projection, Random, at_the_limit, depths, model, triangle},
};
use halfplane::{
    Compare, Cull, DepthTest, Format, ModelPositions, Region, Standard, State, Viewport, Winding,
};

/// One triangle's numbers: kind, corners, depths.
pub type Numbers = (u32, [u32; 8], [u32; 4]);

/// A mesh and how it is drawn.
#[derive(Clone, Debug)]
pub struct Case {
    /// Region of the attachments, scissor, sample.
    pub frame: Frame,
    /// `[x0, y0, x1, y1]` of the viewport: often larger than the frame, as for a band.
    pub viewport: [u32; 4],
    /// How the corners get to clip space.
    pub projection: Projection,
    /// The triangles wanted in the window.
    pub wanted: Vec<Corners>,
    /// Vertices and matrix.
    pub model: Model,
    /// Three for each triangle.
    pub indices: Vec<u32>,
    /// The first triangle's id.
    pub first_id: u32,
    /// Which faces are not drawn.
    pub cull: Cull,
    /// Which faces are in front.
    pub front: Winding,
    /// The depth test.
    pub test: DepthTest,
    /// Chooses the attachments.
    pub attachments: u32,
    /// What the attachments hold before: cleared where 0.
    pub contents: u32,
}

impl Case {
    /// A case from any numbers.
    pub fn from_numbers(place: [u32; 12], how: [u32; 10], triangles: &[Numbers], kinds: &[Kind]) -> Self {
        let [view, project, culling, test, attachments, contents, id, share, a, b] = how;
        let frame = frame(place, a);
        let projection = Projection::ALL[(project % 16) as usize % 6 * usize::from(project % 16 < 10)];
        let shape = |&(kind, numbers, _): &Numbers| match kinds.get(kind as usize % (kinds.len() + 2)) {
            Some(&kind) => triangle::<Standard>(kind, &frame, numbers),
            None => at_the_limit(&frame, numbers),
        };
        let wanted: Vec<Corners> = triangles.iter().map(shape).collect();
        // Often only few depths, so that some are equal, or on the near or the far plane.
        let depth = |&(_, _, z): &Numbers| match share % 3 {
            0 => [[1 << 30, 1 << 31, 3 << 30, 0, u32::MAX][z[0] as usize % 5]; 3],
            _ => depths(z),
        };
        let given: Vec<_> = wanted.iter().copied().zip(triangles.iter().map(depth)).collect();
        let viewport = viewport(&frame, view, b);
        let model = model(projection, viewport, &given, [a, b, test / 16, culling / 16]);
        let mut random = Random(share.into());
        let count = model.vertices.len();
        let indices = (0..count).map(|at| {
            // Some corners are those of other triangles.
            if share % 4 == 0 && random.below(4) == 0 { random.below(count) as u32 } else { at as u32 }
        });
        let compares = [
            Compare::Less,
            Compare::LessEqual,
            Compare::Greater,
            Compare::GreaterEqual,
            Compare::Always,
            Compare::Less,
        ];
        let test = match test % 4 {
            0 => DepthTest { compare: compares[test as usize / 4 % 6], write: test % 7 != 0 },
            _ => DepthTest::LESS,
        };
        Self {
            frame,
            viewport,
            projection,
            indices: indices.collect(),
            wanted,
            model,
            first_id: if id % 2 == 0 { id / 2 % 1000 } else { u32::MAX - triangles.len() as u32 },
            cull: [Cull::None, Cull::None, Cull::Back, Cull::Front][culling as usize % 4],
            front: [Winding::Clockwise, Winding::CounterClockwise][culling as usize / 4 % 2],
            test,
            attachments,
            contents: if contents % 2 == 0 { 0 } else { contents },
        }
    }

    /// A window triangle of any corners and depths, alone in a whole frame.
    pub fn single(frame: Frame, corners: Corners, z: [u32; 3]) -> Self {
        let corners = corners.map(|corner| corner.map(|v| into_guard_band::<Standard>(v.into())));
        let viewport = viewport(&frame, 0, 0);
        Self {
            frame,
            viewport,
            projection: Projection::Flat,
            wanted: vec![corners],
            model: model(Projection::Flat, viewport, &[(corners, z)], [0; 4]),
            indices: vec![0, 1, 2],
            first_id: 0,
            cull: Cull::None,
            front: Winding::Clockwise,
            test: DepthTest::LESS,
            attachments: 4,
            contents: 0,
        }
    }

    /// A level grid of so many squares to a side, of which a quarter is in view: the middle, nothing before anything.
    pub fn grid(side: u16) -> Self {
        let frame = Frame::whole::<Standard>(100, 100);
        let at = |v: u16| 4.1 * f32::from(v) / f32::from(side) - 2.05;
        let vertices = (0..=side).flat_map(|y| (0..=side).map(move |x| [at(x), at(y), 0.5])).collect();
        let pitch = u32::from(side) + 1;
        let squares = (0..side).flat_map(|y| (0..side).map(move |x| u32::from(y) * pitch + u32::from(x)));
        let indices = squares.flat_map(|a| [a, a + 1, a + pitch, a + pitch, a + 1, a + pitch + 1]).collect();
        let matrix = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];
        Self {
            viewport: frame.region,
            wanted: Vec::new(),
            model: Model { vertices, matrix },
            indices,
            ..Self::single(frame, [[0; 2]; 3], [0; 3])
        }
    }

    /// A grid like that one behind two triangles that hide all of it, the last ones of the list.
    pub fn behind_a_wall(side: u16) -> Self {
        let mut case = Self::grid(side);
        // Twice as far, and as large.
        for [x, y, z] in &mut case.model.vertices {
            (*x, *y, *z) = (2.0 * *x, 2.0 * *y, 2.0);
        }
        case.model.matrix = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 1.], [0., 0., -0.5, 0.]];
        let first = case.model.vertices.len() as u32;
        case.model.vertices.extend([[-1.5, -1.5, 1.0], [1.5, -1.5, 1.0], [-1.5, 1.5, 1.0], [1.5, 1.5, 1.0]]);
        case.indices.extend([0, 1, 2, 2, 1, 3].map(|corner| first + corner));
        case
    }

    /// The same with its vertices anywhere around the eye instead, near ones and far ones: triangles pass by it, and
    /// some that have every corner out of view are in view.
    #[must_use]
    pub fn around_the_eye(mut self, seed: u64) -> Self {
        let mut random = Random(seed);
        for vertex in &mut self.model.vertices {
            let size = (random.between(-4, 8) as f32).exp2();
            *vertex = [0; 3].map(|_: u32| random.between(-1000, 1000) as f32 / 1000.0 * size);
        }
        self.model.matrix = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 1.], [0., 0., -0.0625, 0.]];
        self.projection = Projection::Perspective;
        self.wanted.clear();
        self
    }

    /// Its vertices before its matrix and viewport.
    pub fn positions(&self) -> Result<ModelPositions<'_, Standard>, Failure> {
        Ok(ModelPositions::new(&self.model.vertices, self.model.matrix, self.core_viewport()?))
    }

    /// Its viewport.
    pub fn core_viewport(&self) -> Result<Viewport<Standard>, Failure> {
        let [x0, y0, x1, y1] = self.viewport;
        Ok(Viewport::new(Region::new(x0, y0, x1, y1)?))
    }

    /// The state that it is drawn with.
    pub fn state(&self) -> Result<State<Standard>, Failure> {
        Ok(State { cull: self.cull, front: self.front, ..self.frame.state()? })
    }
}

/// A frame of up to 100 pixels, or of some hundred, anywhere.
fn frame(place: [u32; 12], large: u32) -> Frame {
    let mut frame = Frame::from_numbers::<Standard>(place);
    if large.is_multiple_of(4) {
        let [x0, y0, ..] = frame.region;
        let (x1, y1) = (x0 + 100 + place[1] % 300, y0 + 40 + place[2] % 300);
        if x1 <= Standard::MAX_TARGET && y1 <= Standard::MAX_TARGET {
            frame.region = [x0, y0, x1, y1];
            frame.scissor = match large / 4 % 3 {
                0 => [x0, y0, x1, y1],
                _ => [x0 + place[6] % 90, y0 + place[7] % 40, x1 - place[8] % 10, y1],
            };
        }
    }
    frame
}

/// The viewport: sides that are powers of two, so that positions are exact, or the frame's, or others.
fn viewport(frame: &Frame, kind: u32, free: u32) -> [u32; 4] {
    let limit = Standard::MAX_TARGET;
    let [x0, y0, x1, y1] = frame.region;
    let side = |from: u32, to: u32| match (to - from).next_power_of_two() {
        side if from + side <= limit => (from, from + side),
        _ => (0, limit),
    };
    let ((left, right), (top, bottom)) = (side(x0, x1), side(y0, y1));
    match kind % 8 {
        0..=3 => [left, top, right, bottom],
        4 => [0, 0, limit, limit],
        5 => frame.region,
        6 => {
            let [sx0, sy0, sx1, sy1] = frame.scissor;
            [sx0 / 2, sy0 + free % (sy1 - sy0), sx1 - free / 100 % (sx1 - sx0), limit.min(sy1 + free % 50)]
        }
        // Anywhere; it need not meet the scissor.
        _ => {
            let [x, y] = [free % limit, free / limit % limit];
            [x, y, x + 1 + kind / 8 % (limit - x), y + 1 + kind / 64 % (limit - y)]
        }
    }
}
