//! The stiffness ladder: families of triangles whose conditioning worsens by powers of two, up to what can be
//! represented at all. Each rung is a case for tests, which hold this crate to its contract there, and a row
//! of the page, which shows the margin beside what textbooks' forms do.
//!
//! | module | what |
//! |---|---|
//! | [`window`] | families of window triangles: needles, slivers, steep depths, fans, far places |
//! | [`clip`] | families of clip-space triangles: ratios of w, the near plane, tiny and huge numbers |
//! | [`edges`], [`homogeneous`] | coverage as textbooks have it, in `f32` and `f64` |
//! | [`judged`] | a rung's errors |
//! | [`checks`] | orders, mirrors, splits, shared edges, a million triangles over one another |
//! | [`timing`] | a rung's time beside that of well-conditioned triangles of the same number and size |

pub mod checks;
pub mod clip;
pub mod edges;
pub mod homogeneous;
pub mod judged;
pub mod timing;
pub mod window;

use halfplane::{OutsideGuardBand, Standard, Vertex};

use crate::error::ReportError;
use crate::run::Progress;
pub use judged::Judged;

/// A window triangle: corners in steps of 1/256 px and their depths in units of 2^-32.
pub type Corners = ([[i32; 2]; 3], [u32; 3]);

/// One rung.
#[derive(Debug, Clone)]
pub struct Rung {
    /// The exponent: what gets worse is 2^k.
    pub k: i32,
    /// Width and height of the target in pixels.
    pub size: (u32, u32),
    /// The triangles.
    pub shapes: Shapes,
}

/// What a rung draws.
#[derive(Debug, Clone)]
pub enum Shapes {
    /// Window triangles.
    Window(Vec<Corners>),
    /// Triangles of a model through a matrix: three positions each.
    Model {
        /// Three for each triangle.
        positions: Vec<[f32; 3]>,
        /// Model space to clip space.
        matrix: [f32; 16],
    },
}

/// Rungs that get worse in one way.
#[derive(Debug, Clone)]
pub struct Family {
    /// In tables and files.
    pub id: &'static str,
    /// The heading.
    pub title: &'static str,
    /// What 2^k is.
    pub about: &'static str,
    /// What the contract says of it.
    pub promise: Promise,
    /// From harmless to extreme.
    pub rungs: Vec<Rung>,
}

/// What this crate promises at every rung of a family.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Promise {
    /// Every sample right and depth within 1.01 units of 2^-32 of the exact one of the snapped triangle.
    Exact,
    /// Every sample right: the vertices are such that neither the transform nor snapping moves one.
    Samples,
    /// Nothing but what floats keep of the vertices: the transform is measured, not promised.
    Measured,
}

/// All families.
#[must_use]
pub fn families() -> Vec<Family> {
    let mut families = window::families();
    families.extend(clip::families());
    families
}

/// A measured rung.
#[derive(Debug, Clone)]
pub struct Step {
    /// The exponent.
    pub k: i32,
    /// Its errors.
    pub judged: Judged,
    /// Milliseconds of a draw.
    pub ms: f64,
    /// That over the time of as many well-conditioned triangles that cover as many samples.
    pub ratio: f64,
}

/// A measured family.
#[derive(Debug, Clone)]
pub struct Ladder {
    /// The family, without its shapes.
    pub id: &'static str,
    /// Its heading.
    pub title: &'static str,
    /// What 2^k is.
    pub about: &'static str,
    /// What the contract says of it.
    pub promise: Promise,
    /// Its rungs.
    pub steps: Vec<Step>,
}

/// Measures every rung of every family.
///
/// # Errors
///
/// Where a rung cannot be drawn.
pub fn climb(progress: &dyn Progress) -> Result<Vec<Ladder>, ReportError> {
    let families = families();
    let count = families.len() as f64;
    let mut ladders = Vec::new();
    for (place, Family { id, title, about, promise, rungs }) in families.into_iter().enumerate() {
        progress.at(&format!("stiffness: {title}"), place as f64 / count);
        let mut steps = Vec::new();
        for rung in &rungs {
            let judged = judged::judge(rung)?;
            let (ms, ratio) = timing::time(rung, judged.samples)?;
            steps.push(Step { k: rung.k, judged, ms, ratio });
        }
        ladders.push(Ladder { id, title, about, promise, steps });
    }
    Ok(ladders)
}

/// Window vertices of these corners.
///
/// # Errors
///
/// [`OutsideGuardBand`].
pub fn vertices((xy, z): &Corners) -> Result<[Vertex<Standard>; 3], OutsideGuardBand> {
    let [[ax, ay], [bx, by], [cx, cy]] = *xy;
    Ok([Vertex::new(ax, ay, z[0])?, Vertex::new(bx, by, z[1])?, Vertex::new(cx, cy, z[2])?])
}
