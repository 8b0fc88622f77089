//! How the inner loops run, and what is written: equal pixels, other times.

use halfplane::NO_ID;
use halfplane::simd::Snapped;
use halfplane_measure::level::{self, Level};
use halfplane_measure::target::{Attachments, Prepared, Target};
use halfplane_reference::Picture;

use super::repeated;
use crate::error::ReportError;
use crate::row::{Column, Entry, Question, Row, Whose};
use crate::scene::Scene;
use crate::truth::Truth;

/// Levels.
pub const QUESTION: Question = Question {
    id: "levels",
    title: "Vector levels and attachments",
    about: "Every way of this crate to draw the same pixels: vector levels, meshlets, and what is written. The \
            error is the number of pixels whose depth, id or coverage is not the specified one; it is 0 or the run \
            ends with an error, so only time and memory differ.",
    error: Column::new("pixels not as specified", "px"),
    details: &[Column::new("triangles drawn", ""), Column::new("meshlets", "")],
};

/// A row for each level, and for what else can be drawn at the best.
///
/// # Errors
///
/// [`ReportError::Differs`] where a picture is not as specified.
pub fn levels<'a>(
    scene: &'a Scene,
    truth: &Truth,
    prepared: &'a Prepared,
) -> Result<Vec<Entry<'a>>, ReportError> {
    let specified16 = truth.specified16(scene)?;
    let mut entries = Vec::new();
    let best = Level::detect();
    for level in level::available() {
        for attachments in Attachments::ALL {
            let only_best = attachments != Attachments::Depth32 || level::is_fallback(level);
            for meshlets in [None, Some(prepared)] {
                if (only_best || meshlets.is_some())
                    && level.name() != best.name()
                    && !(level::is_fallback(level)
                        && meshlets.is_none()
                        && attachments == Attachments::Depth32)
                {
                    continue;
                }
                let specified = if attachments.has_depth16() { &specified16 } else { &truth.specified };
                entries.push(entry(scene, specified, (level, attachments, meshlets))?);
            }
        }
    }
    Ok(entries)
}

fn entry<'a>(
    scene: &'a Scene,
    specified: &Picture,
    (level, attachments, prepared): (Level, Attachments, Option<&'a Prepared>),
) -> Result<Entry<'a>, ReportError> {
    let mut target = Target::new(&scene.positions, &scene.indices, &scene.state()?)?;
    target.set_meshlets(prepared.map(Prepared::meshlets));
    let statistics = target.frame(level, attachments, &scene.matrix)?;
    let with = if prepared.is_some() { ", meshlets" } else { "" };
    let name = format!("{}, {}{with}", attachments.name(), level.name());
    let pixels = wrong(&mut target, attachments, specified)?;
    if pixels > 0 {
        return Err(ReportError::Differs { scene: scene.name.clone(), way: name, pixels });
    }
    let kept = match prepared {
        Some(prepared) => prepared.preparation().bytes,
        None if level::is_fallback(level) => scene.positions.len() * size_of::<[f32; 4]>(),
        None => scene.positions.len() * size_of::<Snapped>(),
    };
    let meshlets = prepared.map(|prepared| prepared.preparation().meshlets as f64);
    let row = Row {
        error: Some(pixels as f64),
        details: vec![Some(f64::from(statistics.drawn)), meshlets],
        bytes: Some(kept + attachment_bytes(scene, attachments)),
        ..Row::new(name, Whose::Ours)
    };
    Ok(Entry::new(row, move |_| repeated(target.frame(level, attachments, &scene.matrix))))
}

fn wrong(target: &mut Target<'_>, attachments: Attachments, specified: &Picture) -> Result<u64, ReportError> {
    let differ = |given: &[u32], expected: &[u32]| {
        given.iter().zip(expected).filter(|(given, expected)| given != expected).count()
    };
    let mut wrong = 0;
    if attachments.has_depth16() || attachments.has_depth32() {
        wrong += differ(&target.depth_rows(attachments)?, &specified.depth);
    }
    let covered = specified.ids.iter().filter(|&&id| id != NO_ID).count();
    if attachments.has_ids() && (attachments.has_depth16() || attachments.has_depth32()) {
        wrong += differ(&target.id_rows(attachments)?, &specified.ids);
    } else {
        // The last id wins, or there are no ids: what is covered is what can be compared.
        wrong += target.covered(attachments).abs_diff(covered);
    }
    Ok(wrong as u64)
}

fn attachment_bytes(scene: &Scene, attachments: Attachments) -> usize {
    let (width, height) = scene.size;
    let texels = halfplane::texels(width, height);
    let mut bytes = 0;
    if attachments.has_depth32() {
        bytes += 4 * texels;
    }
    if attachments.has_depth16() {
        bytes += 2 * texels;
    }
    if attachments.has_ids() {
        bytes += 4 * texels;
    }
    if attachments.has_coverage() {
        bytes += 2 * halfplane::blocks(width, height);
    }
    bytes
}
