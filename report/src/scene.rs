//! The scene that is reported on, as plain data.

use halfplane::{Cull, Region, RegionError, State, Winding};
use halfplane_measure::Matrix;
use halfplane_measure::view::View;
use halfplane_reference::Model;

/// A mesh seen by a camera. Front faces are clockwise on the screen.
#[derive(Debug, Clone)]
pub struct Scene {
    /// What the page calls it.
    pub name: String,
    /// Vertices in the mesh's own units.
    pub positions: Vec<[f32; 3]>,
    /// Three for each triangle; all less than the number of positions.
    pub indices: Vec<u32>,
    /// Model space to clip space.
    pub matrix: Matrix,
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// Whether faces turned away are drawn, too.
    pub two_sided: bool,
}

impl Scene {
    /// The same scene whatever way its front faces wind and whatever is culled: corners are put in the order
    /// in which what is drawn is clockwise.
    #[must_use]
    pub fn wound(mut self, cull: Cull, front: Winding) -> Self {
        let clockwise = match cull {
            Cull::None | Cull::Back => front == Winding::Clockwise,
            Cull::Front => front != Winding::Clockwise,
        };
        if !clockwise {
            self.indices.chunks_exact_mut(3).for_each(|triangle| triangle.swap(1, 2));
        }
        self.two_sided = cull == Cull::None;
        self
    }

    /// The same scene in another size. The camera is kept, so another shape stretches the picture.
    #[must_use]
    pub fn resized(&self, size: (u32, u32)) -> Self {
        Self { size, ..self.clone() }
    }

    /// The drawing state, at any sub-pixel format.
    ///
    /// # Errors
    ///
    /// Where no target of the format has the size.
    pub fn state<F: halfplane::Format>(&self) -> Result<State<F>, RegionError> {
        let cull = if self.two_sided { Cull::None } else { Cull::Back };
        Ok(State { cull, ..State::new(Region::of_size(self.size.0, self.size.1)?) })
    }

    /// What is drawn, for other crates.
    #[must_use]
    pub fn view(&self) -> View<'_> {
        View { positions: &self.positions, indices: &self.indices, matrix: self.matrix, size: self.size }
    }

    /// Some of its triangles, for the exact picture.
    #[must_use]
    pub fn model<'s>(&'s self, indices: &'s [u32]) -> Model<'s> {
        Model {
            positions: &self.positions,
            indices,
            matrix: self.matrix,
            width: self.size.0,
            height: self.size.1,
            clockwise_only: !self.two_sided,
        }
    }

    /// Triangles.
    #[must_use]
    pub fn triangles(&self) -> usize {
        self.indices.len() / 3
    }

    /// Pixels.
    #[must_use]
    pub fn pixels(&self) -> usize {
        self.size.0 as usize * self.size.1 as usize
    }

    /// Such as `1280x720`.
    #[must_use]
    pub fn dimensions(&self) -> String {
        format!("{}x{}", self.size.0, self.size.1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_drawn_is_clockwise() {
        let scene = Scene {
            name: String::new(),
            positions: vec![[0.0; 3]; 3],
            indices: vec![0, 1, 2],
            matrix: [0.0; 16],
            size: (4, 4),
            two_sided: false,
        };
        let of = |cull, front| {
            let wound = scene.clone().wound(cull, front);
            (wound.indices, wound.two_sided)
        };
        use Winding::{Clockwise, CounterClockwise};
        assert_eq!(of(Cull::Back, Clockwise), (vec![0, 1, 2], false));
        assert_eq!(of(Cull::Back, CounterClockwise), (vec![0, 2, 1], false));
        assert_eq!(of(Cull::Front, Clockwise), (vec![0, 2, 1], false));
        assert_eq!(of(Cull::Front, CounterClockwise), (vec![0, 1, 2], false));
        assert_eq!(of(Cull::None, CounterClockwise), (vec![0, 2, 1], true));
    }
}
