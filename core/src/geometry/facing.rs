//! Winding, culling, and why a triangle was not drawn.

/// The order of a triangle's vertices on the screen, whose y points down.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Winding {
    /// Clockwise as seen; front faces by default, as in Direct3D.
    #[default]
    Clockwise,
    /// Counter-clockwise as seen.
    CounterClockwise,
}

/// Which faces are not drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Cull {
    /// Both faces are drawn.
    #[default]
    None,
    /// Only front faces are drawn.
    Back,
    /// Only back faces are drawn.
    Front,
}

impl Cull {
    /// Whether a triangle of that winding is culled where `front` is the front faces' winding.
    #[must_use]
    pub const fn culls(self, winding: Winding, front: Winding) -> bool {
        let is_front = matches!(
            (winding, front),
            (Winding::Clockwise, Winding::Clockwise) | (Winding::CounterClockwise, Winding::CounterClockwise)
        );
        match self {
            Self::None => false,
            Self::Back => !is_front,
            Self::Front => is_front,
        }
    }
}

/// Why a triangle covers nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Culled {
    /// It faces the way that [`Cull`] excludes.
    Facing,
    /// Its snapped vertices lie on one line.
    ZeroArea,
    /// It lies between the samples.
    NoSample,
    /// It lies outside the scissor, the viewport or the view frustum.
    Outside,
}
