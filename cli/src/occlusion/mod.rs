//! The command `occlusion`: what of a mesh is hidden behind the rest, judged by the exact picture.

mod lines;

use std::collections::HashSet;
use std::fmt;
use std::path::Path;
use std::time::Duration;

use halfplane::D32;
use halfplane::simd::{Occlusion, Visibility};
use halfplane_reference::{Compare, DepthSpec, render as reference_render};

use crate::args::{DepthFormat, Options};
use crate::command;
use crate::error::Error;
use crate::measure::protocol::{Contender, Frame, Plan, Summary, measure};
use crate::output::Outputs;
use crate::picture;
use crate::render::{Picture, RenderError, to_clip};
use crate::target::{Attachments, Clustered, Occluded, Target};
use crate::verify;

/// How often all questions are asked, for their time.
const PASSES: u32 = 20;

/// What was found.
#[derive(Debug, Clone, Copy)]
struct Findings {
    /// Boxes of meshlets.
    occludees: usize,
    /// Of these, the ones whose triangles face much the same way.
    cones: usize,
    /// Outside the view.
    outside: usize,
    /// Said to be hidden.
    culled: usize,
    /// Said to be hidden, and a triangle of them is in the exact picture.
    wrongly: usize,
    /// Not said to be hidden, and no triangle of them is in the exact picture.
    falsely: usize,
    /// What the frame itself asked while it was drawn.
    asked: Occlusion,
    /// Triangles that it left out as hidden.
    hidden: u32,
    /// Whole frames with the questions and without, and the questions alone.
    with: Summary,
    without: Summary,
    questions: Duration,
}

/// Draws, asks, judges, prints a table, and writes the boxes over the depths. Returns whether no box was wrongly said
/// to be hidden.
///
/// # Errors
///
/// [`Error`] for a mesh, camera or output that is no good.
pub fn run_occlusion(file: Option<&Path>, options: &Options) -> Result<bool, Error> {
    if options.depth == DepthFormat::D16 {
        return Err(Error::Usage("--depth d16 cannot be used with occlusion: it judges by d32".to_owned()));
    }
    let (subject, matrix, settings) = command::prepare(file, options, &mut |_| ())?;
    let (mesh, state, level) = (&subject.mesh, settings.state(), settings.level);
    let clustered = Clustered::new(&mesh.positions, &mesh.indices)?;
    let boxes: Vec<_> = clustered.meshlets().iter().map(halfplane::simd::Meshlet::corners_of_box).collect();

    let mut target = Occluded::<D32>::new(&clustered, &state, true);
    let (statistics, asked) = target.frame(level, &matrix)?;
    let mut answers = vec![Visibility::default(); boxes.len()];
    let times = target.ask(level, &matrix, &boxes, &mut answers, PASSES)?;
    let questions = times.into_iter().skip(1).min().unwrap_or_default();

    // The exact picture, of the triangles in the clusters' order: its ids are places in it.
    let clip = to_clip(mesh, &matrix);
    let (scene, _) = verify::assemble(&clip, clustered.indices(), &settings);
    let exact = |compare| {
        reference_render(&scene, compare, DepthSpec::D32, &|_| ())
            .map_err(|error| RenderError::Verify(error.into()))
    };
    // Of triangles at the same depth, the first and the last are seen.
    let seen: HashSet<u32> =
        exact(Compare::Less)?.ids.into_iter().chain(exact(Compare::LessEqual)?.ids).collect();
    let is_seen: Vec<bool> =
        clustered.meshlets().iter().map(|meshlet| meshlet.triangles().any(|id| seen.contains(&id))).collect();
    let count = |answer: Visibility, is: Option<bool>| {
        let judged = answers.iter().zip(&is_seen);
        judged.filter(|&(&given, &seen)| given == answer && is.is_none_or(|is| is == seen)).count()
    };

    let mut plain = Target::new(&mesh.positions, clustered.indices(), &state)?;
    plain.set_meshlets(Some(clustered.meshlets()));
    let mut queried = Occluded::<D32>::new(&clustered, &state, false);
    let frames: [Frame<'_>; 2] = [
        Box::new(|_| drop(queried.frame(level, &matrix))),
        Box::new(|_| drop(plain.frame(level, Attachments::Depth32, &matrix))),
    ];
    let plan = Plan { frames: 60, warm_up: 10, ..Plan::CLASSIC };
    let times = measure(&mut frames.map(|frame| Contender { plan, frame }));
    let time = |place: usize| times.get(place).copied().unwrap_or_default();
    let findings = Findings {
        occludees: boxes.len(),
        cones: clustered.meshlets().iter().filter(|meshlet| meshlet.has_cone()).count(),
        outside: count(Visibility::Outside, None),
        culled: count(Visibility::Hidden, None),
        wrongly: count(Visibility::Hidden, Some(true)) + count(Visibility::Outside, Some(true)),
        falsely: count(Visibility::Visible, Some(false)),
        asked,
        hidden: statistics.culled.hidden,
        with: time(0),
        without: time(1),
        questions,
    };

    let (width, height) = (settings.region.width(), settings.region.height());
    let depth = target.depth_rows()?;
    let drawn =
        Picture { width, height, bits: 32, ids: target.id_rows()?, ordered: false, depth, statistics };
    let mut pixels: Vec<[u8; 3]> =
        picture::grey(&drawn).into_iter().map(|grey| [(grey >> 9) as u8; 3]).collect();
    // Those that are seen last, over the others.
    for (answer, colour) in [(Visibility::Hidden, [255, 64, 48]), (Visibility::Visible, [48, 224, 64])] {
        for (corners, _) in boxes.iter().zip(&answers).filter(|(_, given)| **given == answer) {
            lines::draw_box(&mut pixels, (width, height), &matrix, corners, colour);
        }
    }
    let mut outputs = Outputs::new(&options.out);
    outputs.add("occlusion.png", picture::rgb8(width, height, &pixels));
    let path = options.out.join("occlusion.png");
    outputs.commit()?;
    let triangles = mesh.triangles();
    command::print(&format!(
        "{}: {triangles} triangles in {} batches, {width}x{height} pixels, level {}\n{}\n{findings}wrote {}\n",
        subject.name,
        clustered.batches().len(),
        level.name(),
        clustered.preparation(),
        path.display()
    ))?;
    Ok(findings.wrongly == 0)
}

impl fmt::Display for Findings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Occlusion { batches, hidden_batches, facing_meshlets, meshlets, hidden_meshlets } = self.asked;
        let each = self.questions.as_nanos() as f64 / self.occludees.max(1) as f64;
        let rows: [(&str, String); 12] = [
            ("meshlets with a cone of normals", self.cones.to_string()),
            ("occludees: boxes of meshlets", self.occludees.to_string()),
            ("outside the view", self.outside.to_string()),
            ("culled: hidden", self.culled.to_string()),
            ("wrongly culled (must be 0)", self.wrongly.to_string()),
            ("falsely visible", self.falsely.to_string()),
            ("a question, on average, minimum", format!("{each:.0} ns")),
            ("while drawing: batches asked / hidden", format!("{batches} / {hidden_batches}")),
            ("while drawing: meshlets that face away", facing_meshlets.to_string()),
            ("while drawing: meshlets asked / hidden", format!("{meshlets} / {hidden_meshlets}")),
            ("while drawing: triangles left out", self.hidden.to_string()),
            (
                "whole frame, depth: with / without, minima",
                format!("{:.3} / {:.3} ms", self.with.min, self.without.min),
            ),
        ];
        for (name, value) in rows {
            writeln!(f, "{name:44} {value:>16}")?;
        }
        Ok(())
    }
}
