//! Whether every level draws the same picture, with and without meshlets: before anybody is timed.

use super::{MAIN, WITH_MESHLETS};
use crate::ours::{Level, Prepared, Target, drawn};
use crate::scenes::View;

/// The pixels that every level covers; depths and statistics must be those of the fallback, with and without
/// meshlets.
pub(super) fn same_picture<'a>(
    view: &View,
    prepared: Option<&'a Prepared>,
    target: &mut Target<'a>,
    levels: &[Level],
) -> Result<usize, String> {
    let mut draw = |level, attachments, meshlets| {
        target.set_meshlets(meshlets);
        let statistics = drawn(target.frame(level, attachments, &view.matrix));
        (target.fingerprint(attachments), target.covered(attachments), statistics)
    };
    let (_, covered, _) = draw(Level::FALLBACK, MAIN, None);
    let meshlets = prepared.map(|prepared| Some(prepared.meshlets()));
    for attachments in WITH_MESHLETS {
        let expected = draw(Level::FALLBACK, attachments, None);
        for &level in levels {
            for meshlets in [None].into_iter().chain(meshlets) {
                if draw(level, attachments, meshlets) != expected {
                    let with = if meshlets.is_some() { " with meshlets" } else { "" };
                    return Err(format!(
                        "{}, {}: {}{with} draws another picture than fallback",
                        view.name,
                        attachments.name(),
                        level.name()
                    ));
                }
            }
        }
    }
    Ok(covered)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ours;
    use crate::scenes::growth;

    /// Meshlets of another mesh draw another picture.
    #[test]
    fn another_picture_is_an_error() {
        let view = growth::view(1000, (64, 36));
        let mut last = ours::Last::default();
        let wrong = last.of(&growth::view(300, (64, 36)), |_| ());
        let message = same_picture(&view, Some(wrong), &mut ours::target(&view), &ours::available());
        assert!(message.is_err_and(|message| message.contains(" with meshlets draws another picture")));
        let right = same_picture(&view, None, &mut ours::target(&view), &ours::available());
        assert_eq!(right, Ok(64 * 36));
    }
}
