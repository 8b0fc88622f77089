//! Whole configurations, each with the pixels that it gets wrong: what a recommendation chooses from.

use halfplane::{D16, D32, Depth, DepthFormat, DepthTest, Format, Ids, NO_ID, Small, Standard, texels};
use halfplane_measure::level::{self, Level};
use halfplane_measure::target::{Attachments, Prepared, Target};

use super::repeated;
use crate::error::ReportError;
use crate::plain::{Plain, rows};
use crate::row::{Column, Entry, Question, Row, Whose};
use crate::scene::Scene;
use crate::statistics::differences;
use crate::truth::Truth;

/// Configurations.
pub const QUESTION: Question = Question {
    id: "configurations",
    title: "Whole configurations",
    about: "What one would write in a program, by everything it gets wrong: a pixel is wrong where another triangle, \
            or none, is seen than in the picture that has no rounding at all, be it snapping, the transform's floats \
            or the depth's bits. Depth only is timed.",
    error: Column::new("wrong pixels", "px"),
    details: &[Column::new("of 1000 pixels", "")],
};

/// A configuration: what to write, and what must be in `Cargo.toml`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Configuration {
    /// Its row's name, but for the level.
    pub name: &'static str,
    /// Features of the dependency.
    pub features: &'static str,
    /// Lines of a program.
    pub code: &'static str,
}

const VECTOR32: Configuration = Configuration {
    name: "Standard, D32, vector registers",
    features: "features = [\"simd\", \"std\"]",
    code: "let mut depth: Depth<'_, Standard, D32> = Depth::new(region, &mut texels, DepthTest::LESS)?;\n\
           simd::draw(Level::detect(), &positions, &mut records, triangles, 0, &state, &mut depth)?;",
};

const VECTOR16: Configuration = Configuration {
    name: "Standard, D16, vector registers",
    features: "features = [\"simd\", \"std\"]",
    code: "let mut depth: Depth<'_, Standard, D16> = Depth::new(region, &mut texels, DepthTest::LESS)?;\n\
           simd::draw(Level::detect(), &positions, &mut records, triangles, 0, &state, &mut depth)?;",
};

const MESHLETS32: Configuration = Configuration {
    name: "Standard, D32, vector registers, meshlets",
    features: "features = [\"simd\", \"std\"]",
    code: "let meshlets = simd::make_meshlets(&positions, &indices, &mut meshlet_memory)?; // once\n\
           let mut depth: Depth<'_, Standard, D32> = Depth::new(region, &mut texels, DepthTest::LESS)?;\n\
           simd::draw_meshlets(Level::detect(), meshlets, matrix, viewport, &mut scratch, 0, &state, &mut depth)?;",
};

const MESHLETS16: Configuration = Configuration {
    name: "Standard, D16, vector registers, meshlets",
    features: "features = [\"simd\", \"std\"]",
    code: "let meshlets = simd::make_meshlets(&positions, &indices, &mut meshlet_memory)?; // once\n\
           let mut depth: Depth<'_, Standard, D16> = Depth::new(region, &mut texels, DepthTest::LESS)?;\n\
           simd::draw_meshlets(Level::detect(), meshlets, matrix, viewport, &mut scratch, 0, &state, &mut depth)?;",
};

const PLAIN32: Configuration = Configuration {
    name: "Standard, D32, plain arrays",
    features: "",
    code: "let mut depth: Depth<'_, Standard, D32> = Depth::new(region, &mut texels, DepthTest::LESS)?;\n\
           draw(&ClipPositions::new(&clip, viewport), &indices, 0, &state, &mut depth)?;",
};

const PLAIN16: Configuration = Configuration {
    name: "Standard, D16, plain arrays",
    features: "",
    code: "let mut depth: Depth<'_, Standard, D16> = Depth::new(region, &mut texels, DepthTest::LESS)?;\n\
           draw(&ClipPositions::new(&clip, viewport), &indices, 0, &state, &mut depth)?;",
};

const SMALL16: Configuration = Configuration {
    name: "Small, D16, plain arrays",
    features: "",
    code: "let mut depth: Depth<'_, Small, D16> = Depth::new(region, &mut texels, DepthTest::LESS)?;\n\
           draw(&ClipPositions::<Small>::new(&clip, viewport), &indices, 0, &state, &mut depth)?;",
};

/// All of them, in the order of the rows.
pub const ALL: [Configuration; 7] = [VECTOR32, VECTOR16, MESHLETS32, MESHLETS16, PLAIN32, PLAIN16, SMALL16];

/// A row for each configuration.
///
/// # Errors
///
/// Where the scene cannot be drawn.
pub fn configurations<'a>(
    scene: &'a Scene,
    truth: &Truth,
    prepared: &'a Prepared,
) -> Result<Vec<Entry<'a>>, ReportError> {
    let (width, height) = scene.size;
    let mut entries = Vec::new();
    for configuration in ALL {
        let entry = match configuration {
            VECTOR32 => {
                vector(scene, truth, configuration, (Attachments::DepthIds32, Attachments::Depth32), None)?
            }
            VECTOR16 => {
                vector(scene, truth, configuration, (Attachments::DepthIds16, Attachments::Depth16), None)?
            }
            MESHLETS32 => {
                let attachments = (Attachments::DepthIds32, Attachments::Depth32);
                vector(scene, truth, configuration, attachments, Some(prepared))?
            }
            MESHLETS16 => {
                let attachments = (Attachments::DepthIds16, Attachments::Depth16);
                vector(scene, truth, configuration, attachments, Some(prepared))?
            }
            PLAIN32 => plain::<Standard, D32>(scene, truth, configuration)?,
            PLAIN16 => plain::<Standard, D16>(scene, truth, configuration)?,
            _ if width <= Small::MAX_TARGET && height <= Small::MAX_TARGET => {
                plain::<Small, D16>(scene, truth, configuration)?
            }
            _ => {
                let most = Small::MAX_TARGET;
                let reason =
                    format!("the small format has targets of at most {most} px; see the table of formats");
                Row::pending(configuration.name, Whose::Ours, &reason).into()
            }
        };
        entries.push(entry);
    }
    Ok(entries)
}

fn row(scene: &Scene, truth: &Truth, name: String, ids: &[u32], bytes: usize) -> Row {
    let wrong = differences(ids, &truth.unsnapped.ids, NO_ID).0 as f64;
    Row {
        error: Some(wrong),
        details: vec![Some(1000.0 * wrong / scene.pixels() as f64)],
        bytes: Some(bytes),
        ..Row::new(name, Whose::Ours)
    }
}

fn vector<'a>(
    scene: &'a Scene,
    truth: &Truth,
    configuration: Configuration,
    (judged, timed): (Attachments, Attachments),
    prepared: Option<&'a Prepared>,
) -> Result<Entry<'a>, ReportError> {
    let level = Level::detect();
    if level::is_fallback(level) {
        return Ok(Row::pending(configuration.name, Whose::Ours, "this machine has no vector level").into());
    }
    let mut target = Target::new(&scene.positions, &scene.indices, &scene.state()?)?;
    target.set_meshlets(prepared.map(Prepared::meshlets));
    target.frame(level, judged, &scene.matrix)?;
    let ids = target.id_rows(judged)?;
    target.frame(level, timed, &scene.matrix)?;
    let texel = if timed.has_depth16() { 2 } else { 4 };
    let bytes = texel * texels(scene.size.0, scene.size.1);
    let row = row(scene, truth, configuration.name.to_owned(), &ids, bytes);
    let row = Row { note: level.name().to_owned(), ..row };
    Ok(Entry::new(row, move |_| repeated(target.frame(level, timed, &scene.matrix))))
}

fn plain<'a, F: Format, D: DepthFormat<F>>(
    scene: &'a Scene,
    truth: &Truth,
    configuration: Configuration,
) -> Result<Entry<'a>, ReportError> {
    let mut plain = Plain::<F>::new(scene)?;
    let state = *plain.state();
    let region = state.scissor;
    let texels = texels(region.width(), region.height());
    let mut storage = vec![D::FAR; texels];
    let mut id_storage = vec![NO_ID; texels];
    {
        let mut depth = Depth::<F, D>::new(region, &mut storage, DepthTest::LESS)?;
        plain.draw(&mut (&mut depth, &mut Ids::<F>::new(region, &mut id_storage)?))?;
    }
    let ids = rows(&state, &mut id_storage)?;
    let bytes = size_of_val(storage.as_slice());
    let row = row(scene, truth, configuration.name.to_owned(), &ids, bytes);
    let mut frame = move || -> Result<(), ReportError> {
        let mut depth = Depth::<F, D>::new(region, &mut storage, DepthTest::LESS)?;
        depth.clear(D::FAR);
        plain.draw(&mut depth)?;
        Ok(())
    };
    frame()?;
    Ok(Entry::new(row, move |_| repeated(frame())))
}
