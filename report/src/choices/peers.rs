//! Other crates on the same triangles.

use std::panic::{AssertUnwindSafe, catch_unwind};

use halfplane::NO_ID;
use halfplane_measure::level::Level;
use halfplane_measure::peers::visible::Visible;
use halfplane_measure::peers::{self, Shown};
use halfplane_measure::target::{Attachments, Target};
use halfplane_reference::{Unsnapped, unsnapped};

use super::repeated;
use crate::error::ReportError;
use crate::row::{Column, Entry, Question, Row, Whose};
use crate::scene::Scene;
use crate::truth::Truth;
use crate::vector::CoverageFrames;

/// Peers.
pub const QUESTION: Question = Question {
    id: "peers",
    title: "Other crates",
    about: "Crates from crates.io beside this one, each with the triangles it can take. A pixel is wrong where \
            something is drawn and nothing should be or the reverse, or where the depth is off by more than 1/256 \
            of what is left to the far plane: another surface is seen. The truth is the picture of the same \
            triangles that has no rounding at all; ours is held to it by the same rule. Crates for 2D have neither \
            depth nor transform: they are given window triangles that were made beforehand, and only their coverage \
            is judged.",
    error: Column::new("wrong pixels", "px"),
    details: &[Column::new("of those: silhouette", "px"), Column::new("triangles given", "")],
};

/// A row for us and each peer; one more of ours with what crates for 2D are given.
///
/// # Errors
///
/// Where the scene cannot be drawn.
pub fn peers<'a>(scene: &'a Scene, truth: &Truth) -> Result<Vec<Entry<'a>>, ReportError> {
    let best = Level::detect();
    let mut entries = vec![ours(scene, &scene.indices, &truth.unsnapped, ("", Attachments::Depth32), best)?];
    let mut view = scene.view();
    let twice: Vec<u32>;
    if scene.two_sided {
        // They cull what faces away: each triangle once each way.
        let turned = scene.indices.chunks_exact(3).flat_map(|t| [t[0], t[2], t[1]]);
        twice = scene.indices.iter().copied().chain(turned).collect();
        view.indices = &twice;
    }
    let visible = Visible::new(&view);
    let flat = unsnapped(&scene.model(&visible.indices), &|_| ())?;
    let one_sided = Scene { two_sided: false, ..scene.resized(scene.size) };
    for mut peer in peers::all(&view, &visible) {
        let name = peer.name();
        let (moves, given) = (peer.moves(), peer.triangles());
        if given == 0 {
            entries
                .push(Row::pending(name, Whose::Peer, "no triangle of the scene is one it can take").into());
            continue;
        }
        let drawn = catch_unwind(AssertUnwindSafe(|| peer.frame(&scene.matrix))).is_ok();
        if !drawn {
            entries.push(Row::pending(name, Whose::Peer, "it panics on this scene").into());
            continue;
        }
        let own;
        let exact = match (moves, given == scene.triangles()) {
            (true, true) => &truth.unsnapped,
            (true, false) => {
                own = unsnapped(&one_sided.model(peer.indices()), &|_| ())?;
                &own
            }
            (false, _) => &flat,
        };
        let (wrong, silhouette) = judged(peer.shown().into_iter(), exact);
        let row = Row {
            error: Some(wrong as f64),
            details: vec![Some(silhouette as f64), Some(given as f64)],
            note: (if moves { "depth" } else { "2D: coverage of window triangles" }).to_owned(),
            ..Row::new(name, Whose::Peer)
        };
        entries.push(Entry::new(row, move |_| peer.frame(&scene.matrix)));
    }
    if !visible.indices.is_empty() {
        let name = ", what 2D crates are given";
        entries.insert(1, visible_only(scene, &visible, &flat, name, best)?);
    }
    Ok(entries)
}

fn ours<'a>(
    scene: &'a Scene,
    indices: &'a [u32],
    exact: &Unsnapped,
    (name, attachments): (&str, Attachments),
    level: Level,
) -> Result<Entry<'a>, ReportError> {
    let mut target = Target::new(&scene.positions, indices, &scene.state()?)?;
    target.frame(level, attachments, &scene.matrix)?;
    let far = u32::MAX;
    let depths = target.depth_rows(attachments)?;
    let shown = depths.into_iter().map(|depth| {
        if depth == far { Shown::Nothing } else { Shown::Depth((f64::from(depth) / f64::from(far)) as f32) }
    });
    let (wrong, silhouette) = judged(shown, exact);
    let row = Row {
        error: Some(wrong as f64),
        details: vec![Some(silhouette as f64), Some((indices.len() / 3) as f64)],
        note: "depth".to_owned(),
        ..Row::new(format!("halfplane {}{name}", level.name()), Whose::Ours)
    };
    Ok(Entry::new(row, move |_| repeated(target.frame(level, attachments, &scene.matrix))))
}

/// Ours, with the triangles that crates for 2D are given: still with its transform, and only coverage.
fn visible_only<'a>(
    scene: &'a Scene,
    visible: &Visible,
    exact: &Unsnapped,
    name: &str,
    level: Level,
) -> Result<Entry<'a>, ReportError> {
    let indices = visible.indices.clone();
    let state = scene.state()?;
    let ids = Attachments::Ids;
    let wrong = {
        let mut target = Target::new(&scene.positions, &indices, &state)?;
        target.frame(level, ids, &scene.matrix)?;
        let shown = target.id_rows(ids)?.into_iter();
        judged(shown.map(|id| if id == NO_ID { Shown::Nothing } else { Shown::Something }), exact)
    };
    let row = Row {
        error: Some(wrong.0 as f64),
        details: vec![Some(wrong.1 as f64), Some((indices.len() / 3) as f64)],
        note: "coverage, its transform included".to_owned(),
        ..Row::new(format!("halfplane {}{name}", level.name()), Whose::Ours)
    };
    let mut coverage = CoverageFrames::new(scene, indices)?;
    coverage.frame(level, &state)?;
    Ok(Entry::new(row, move |_| repeated(coverage.frame(level, &state))))
}

/// Wrong pixels, and how many of those are drawn where nothing should be or the reverse.
fn judged(shown: impl Iterator<Item = Shown>, exact: &Unsnapped) -> (u64, u64) {
    let mut wrong = (0, 0);
    for (place, shown) in shown.enumerate() {
        let covered = exact.ids[place] != NO_ID;
        if (shown != Shown::Nothing) != covered {
            wrong = (wrong.0 + 1, wrong.1 + 1);
            continue;
        }
        // Four last bits of an f32 near 1 are no other surface.
        let off = |given: f32, exact: f64, size: f64| {
            let distance = (f64::from(given) - exact).abs();
            distance.is_nan()
                || distance > size / 256.0 + 4.0 * f64::from(f32::EPSILON) * f64::max(1.0, exact)
        };
        let is_wrong = match shown {
            Shown::Nothing | Shown::Something => false,
            Shown::Depth(depth) => off(depth, exact.depth[place], 1.0 - exact.depth[place]),
            Shown::InverseW(inverse) => off(inverse, exact.inverse_w[place], exact.inverse_w[place]),
        };
        wrong.0 += u64::from(is_wrong);
    }
    wrong
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_judged_by_what_is_seen() {
        let exact = Unsnapped {
            ids: vec![0, 0, NO_ID, 1, 1, 1, 1],
            depth: vec![0.5, 0.5, 1.0, 0.9, 0.9, 0.9, 0.9],
            inverse_w: vec![0.0, 0.0, 0.0, 0.1, 0.1, 0.1, 0.1],
            decided_in_integers: 0,
        };
        let shown = [
            Shown::Something,
            Shown::Nothing,
            Shown::Depth(0.3),
            Shown::Depth(0.9003),
            Shown::Depth(0.901),
            Shown::InverseW(0.1003),
            Shown::InverseW(f32::NAN),
        ];
        assert_eq!(judged(shown.into_iter(), &exact), (4, 2));
    }
}
