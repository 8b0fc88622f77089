//! The rasterizer, as the command draws with it (`halfplane_cli::target`), on views.

use halfplane::{Cull, Region, State};
use halfplane_cli::render::RenderError;

pub use halfplane_cli::level::{Level, available, is_fallback};
pub use halfplane_cli::target::{Attachments, Stage, Target};

use crate::scenes::View;

/// The attachments that are measured.
pub const MEASURED: [Attachments; 5] = [
    Attachments::Depth32,
    Attachments::Depth16,
    Attachments::Ids,
    Attachments::DepthIds32,
    Attachments::Coverage,
];

/// The fastest level of this machine.
#[must_use]
pub fn fastest() -> Level {
    Level::detect()
}

/// The level of that name, if this machine has it.
#[must_use]
pub fn from_name(name: &str) -> Option<Level> {
    available().into_iter().find(|level| level.name() == name)
}

/// For drawing a view's whole mesh; faces that wind counter-clockwise are culled.
///
/// # Panics
///
/// If the view's size is none that a target can have, or its indices do not exist.
#[must_use]
pub fn target(view: &View) -> Target<'_> {
    with_indices(view, &view.mesh.indices)
}

/// The same for some of the mesh's triangles.
///
/// # Panics
///
/// As [`target`].
#[must_use]
pub fn with_indices<'v>(view: &'v View, indices: &'v [u32]) -> Target<'v> {
    let region = Region::of_size(view.size.0, view.size.1).expect("views have sizes that targets can have");
    let state = State { cull: Cull::Back, ..State::new(region) };
    drawn(Target::new(&view.mesh.positions, indices, &state))
}

/// What a target returned; it refuses nothing of a view.
///
/// # Panics
///
/// If it did.
#[inline]
pub fn drawn<T>(result: Result<T, RenderError>) -> T {
    result.expect("views have indices that exist and targets have memory")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::micro;

    #[test]
    fn every_level_draws_the_same_picture() {
        let view = micro::random("test", 2000, 24.0, (200, 120));
        let mut target = target(&view);
        for attachments in MEASURED {
            drawn(target.frame(Level::FALLBACK, attachments, &view.matrix));
            let (expected, covered) = (target.fingerprint(attachments), target.covered(attachments));
            assert!(covered > 200 * 120 / 2, "{attachments:?} {covered}");
            for level in available() {
                drawn(target.frame(level, attachments, &view.matrix));
                assert_eq!(target.fingerprint(attachments), expected, "{level:?} {attachments:?}");
            }
        }
    }

    #[test]
    fn levels_have_names() {
        assert_eq!(from_name(fastest().name()).map(Level::name), Some(fastest().name()));
        assert!(from_name("fallback").is_some_and(is_fallback));
        assert!(from_name("scalar").is_none());
    }
}
