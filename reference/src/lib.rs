//! The exact oracle of the rasterizer `halfplane`.
//!
//! Everything here is written from the definitions: a sample is inside a triangle or on an edge that
//! counts, decided in unbounded rationals; a depth is a fraction; a picture is every triangle tried on
//! every sample of its bounding box. The rasterizer that is checked is not a dependency, and no
//! arithmetic is shared with it: coverage here comes from half-open scanline intervals, never from a
//! biased edge function; depth comes from barycentric fractions, never from a plane in fixed point
//! (except [`SpecifiedPlane`], which *is* the written definition of the stored depth).
//!
//! | level | what | arithmetic |
//! |---|---|---|
//! | [`covers`], [`weights_at`], [`depth_at`], [`covered_area`], [`HalfOpen`] | the definitions | rationals |
//! | [`to_clip`], [`clip`], [`to_window`], [`snap`], [`unorm`] | the exact transform | rationals |
//! | [`specified_depth`] | the definition of a stored depth | unbounded integers |
//! | [`cover_rows`], [`touch_rows`], [`inside_rows`], [`ExactPlane`], [`Fraction`], [`SpecifiedPlane`] | the same answers, fast | `i128`, ranges stated and checked |
//! | [`render`], [`verify`], [`cover_count_picture`] | whole scenes by brute force | the fast level |
//! | [`unsnapped()`] | a model without any rounding, whole pictures | `f64` with bounds, unbounded integers where they do not decide |
//!
//! The fast level is tested against the definitions by the property tests of this crate.
//!
//! Conventions: window coordinates in sub-pixel steps (2^-S px), x right, y **down**, pixel (i, j)
//! covers `[i, i+1) x [j, j+1)` px, its centre lies at +0.5. Both windings cover the same samples; a
//! triangle of zero area covers none.
//!
//! ```
//! use halfplane_reference::{Compare, DepthSpec, Scene, SceneTriangle, render, verify};
//!
//! let scene = Scene {
//!     width: 8,
//!     height: 8,
//!     subpixel_bits: 8,
//!     sample: (128, 128),
//!     triangles: vec![SceneTriangle { xy: [[0, 0], [2048, 0], [0, 2048]], z: [1 << 30; 3], id: 7 }],
//! };
//! let picture = render(&scene, Compare::Less, DepthSpec::D32, &|_| ()).unwrap();
//! // The hypotenuse is neither a top nor a left edge: the 8 centres on it are not covered.
//! assert_eq!(picture.ids.iter().filter(|&&id| id == 7).count(), 28);
//! let report = verify(&scene, Compare::Less, DepthSpec::D32, &picture.depth, Some(&picture.ids), &|_| ());
//! assert!(report.unwrap().identical());
//! ```
#![forbid(unsafe_code)]

mod area;
mod conservative;
mod definition;
mod exact;
mod fraction;
mod grid;
mod rational;
mod render;
mod report;
mod scene;
mod spans;
mod specified;
mod strips;
mod transform;
mod unsnapped;
mod verify;

pub use area::covered_area;
pub use conservative::HalfOpen;
pub use definition::{Point, covers, depth_at, weights_at};
pub use exact::ExactPlane;
pub use fraction::Fraction;
pub use grid::{Grid, GridError, MAX_SUBPIXEL_BITS, Rect};
pub use rational::{Rational, decimal, from_f32, from_steps, nearest_ties_even, nearest_ties_up};
pub use render::{Picture, render};
pub use report::{Difference, Mismatches, Outcome, Report};
pub use scene::{Compare, MAX_SIDE, NO_ID, Scene, SceneError, SceneTriangle};
pub use spans::{cover_count_picture, cover_counts, cover_rows};
pub use specified::{DepthSpec, DepthSpecError, SpecifiedPlane, specified_depth, z16_from_z32};
pub use strips::{inside_rows, touch_rows};
pub use transform::{ClipError, Planes, Viewport, WindowPoint, clip, snap, to_clip, to_window, unorm};
pub use unsnapped::{Model, ModelError, Unsnapped, unsnapped};
pub use verify::{VerifyError, verify};
