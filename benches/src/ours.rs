//! The rasterizer, as the command draws with it (`halfplane_measure::target`), on views.

use std::sync::Arc;

use halfplane::{Cull, Region, State};
use halfplane_cli::mesh::Mesh;

pub use halfplane_measure::level::{Level, available, is_fallback};
pub use halfplane_measure::target::{Attachments, Preparation, Prepared, Stage, Target, TargetError};

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

/// The meshlets of the mesh that was drawn last: the views of a scene share them.
#[derive(Debug, Default)]
pub struct Last(Option<(Arc<Mesh>, Prepared)>);

impl Last {
    /// Those of a view's mesh; `told` is called with what they cost where they had to be made.
    ///
    /// # Panics
    ///
    /// As [`target`].
    pub fn of(&mut self, view: &View, told: impl FnOnce(Preparation)) -> &Prepared {
        if self.0.as_ref().is_some_and(|(mesh, _)| !Arc::ptr_eq(mesh, &view.mesh)) {
            self.0 = None;
        }
        let make = || {
            let prepared = drawn(Prepared::new(&view.mesh.positions, &view.mesh.indices));
            told(prepared.preparation());
            (Arc::clone(&view.mesh), prepared)
        };
        &self.0.get_or_insert_with(make).1
    }
}

/// What a target returned; it refuses nothing of a view.
///
/// # Panics
///
/// If it did.
#[inline]
pub fn drawn<T>(result: Result<T, TargetError>) -> T {
    result.expect("views have indices that exist and targets have memory")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::peers::{self, visible::Visible};
    use crate::scenes::{growth, micro};

    #[test]
    fn every_level_draws_the_same_picture() {
        let view = micro::random("test", 2000, 24.0, (200, 120));
        let mut last = Last::default();
        let prepared = last.of(&view, |_| ());
        let mut target = target(&view);
        for attachments in MEASURED {
            drawn(target.frame(Level::FALLBACK, attachments, &view.matrix));
            let (expected, covered) = (target.fingerprint(attachments), target.covered(attachments));
            assert!(covered > 200 * 120 / 2, "{attachments:?} {covered}");
            for level in available() {
                for way in [None, Some(prepared.meshlets())] {
                    target.set_meshlets(way);
                    drawn(target.frame(level, attachments, &view.matrix));
                    assert_eq!(target.fingerprint(attachments), expected, "{level:?} {attachments:?}");
                }
            }
            target.set_meshlets(None);
        }
    }

    #[test]
    fn a_mesh_is_prepared_once() {
        let one = micro::random("one", 200, 24.0, (200, 120));
        let other = micro::random("other", 300, 24.0, (200, 120));
        let (mut last, mut told) = (Last::default(), Vec::new());
        for view in [&one, &View { size: (100, 60), ..one.clone() }, &other, &one] {
            let prepared = last.of(view, |preparation| told.push(preparation.meshlets)).preparation();
            assert_eq!(told.last(), Some(&prepared.meshlets));
        }
        // 32 triangles that share no vertex fill a meshlet.
        assert_eq!(told, [7, 10, 7]);
    }

    #[test]
    fn levels_have_names() {
        assert_eq!(from_name(fastest().name()).map(Level::name), Some(fastest().name()));
        assert!(from_name("fallback").is_some_and(is_fallback));
        assert!(from_name("scalar").is_none());
    }

    /// Who draws nothing is fast.
    #[test]
    fn every_peer_covers_about_what_we_cover() {
        let views = [
            growth::view(1000, (320, 180)),
            micro::random("test", 100, 40.0, (320, 180)),
            micro::fullscreen("test", 2, false, (320, 180)),
        ];
        for view in &views {
            let visible = Visible::new(&view.plain());
            let ours = |indices: &[u32]| {
                let mut target = with_indices(view, indices);
                drawn(target.frame(Level::FALLBACK, Attachments::Depth32, &view.matrix));
                target.covered(Attachments::Depth32) as f64
            };
            for mut peer in peers::all(&view.plain(), &visible) {
                peer.frame(&view.matrix);
                peer.frame(&view.matrix);
                let expected = ours(if peer.moves() { &view.mesh.indices } else { &visible.indices });
                let covered = peer.covered() as f64;
                // embedded-graphics covers what an outline touches.
                let allowed = if peer.name() == "embedded-graphics" { 0.25 } else { 0.02 };
                assert!(
                    (covered - expected).abs() <= allowed * expected,
                    "{} on {}: {covered}, not {expected}",
                    peer.name(),
                    view.name
                );
            }
        }
    }
}
