//! The document's plots.

use std::path::{Path, PathBuf};

use super::data::Data;
use crate::breakdown::Part;
use crate::limits::CLEAR_PIXELS;
use crate::peers;
use crate::plots::{
    Error,
    bars::{self, Bar},
    curves::{self, Curve},
    stacks::{self, Stack},
};
use crate::quoted;

/// Draws every plot that there is data for; the files.
///
/// # Errors
///
/// What the file system or plotters says.
pub fn draw(data: &Data, folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let mut files = Vec::new();
    for scene in ["built-in", "castle", "sponza"] {
        let groups = comparison(data, scene);
        if !groups.is_empty() {
            let path = folder.join(format!("comparison-{scene}.svg"));
            let title = format!(
                "{scene}, depth, one thread: a frame, in clears (hollow: quoted from another machine)"
            );
            bars::draw(&path, &title, "clears of 1280x720 u32, logarithmic", &groups)?;
            files.push(path);
        }
    }
    let curves = growth(data);
    if !curves.is_empty() {
        let path = folder.join("growth.svg");
        let axes = ["triangles", "ms, minimum"];
        curves::draw(&path, "The same surface in more triangles (1280x720, depth)", axes, &curves)?;
        files.push(path);
    }
    let curves = pixels(data);
    if !curves.is_empty() {
        let path = folder.join("pixels.svg");
        let axes = ["samples covered by all triangles", "ms, minimum"];
        curves::draw(
            &path,
            "1000 triangles that cover more (1280x720, depth, all samples pass)",
            axes,
            &curves,
        )?;
        files.push(path);
    }
    for (name, title, unit, of) in [
        (
            "stages-time",
            "Stages of a frame by time (levels within three times the fastest)",
            "ms",
            ms as fn(&crate::breakdown::table::Row) -> Option<f64>,
        ),
        (
            "stages-instructions",
            "Stages of a frame by instructions (levels within three times the fewest)",
            "millions of instructions",
            millions,
        ),
    ] {
        let groups = stages(data, unit, of);
        if !groups.is_empty() {
            let path = folder.join(format!("{name}.svg"));
            stacks::draw(&path, title, &Part::ALL.map(Part::name), &groups)?;
            files.push(path);
        }
    }
    Ok(files)
}

fn comparison(data: &Data, scene: &str) -> Vec<bars::Group> {
    let views = data.views(scene).into_iter().filter(|view| view.ends_with(" 1280x720"));
    let group = |view: &str| {
        let levels = data.levels();
        let ours = levels.into_iter().filter_map(|level| {
            let value = data.depth(view, level)?.clears;
            Some(Bar { name: format!("halfplane {level}"), value, colour: 0, quoted: false })
        });
        // At the fastest level: what half the depth and meshlets change.
        let ways = [
            ("depth D16", false, "D16", 0),
            ("depth", true, "meshlets", 4),
            ("depth D16", true, "D16, meshlets", 4),
        ];
        let fastest = data.levels().first().copied();
        let ways = ways.into_iter().filter_map(move |(attachments, meshlets, name, colour)| {
            let level = fastest?;
            let value = data.way(view, level, attachments, meshlets)?.clears;
            Some(Bar { name: format!("halfplane {level}, {name}"), value, colour, quoted: false })
        });
        let crates = peers::WHAT.into_iter().filter_map(|(name, _)| {
            let record = data.of(view, name, false)?;
            let flat = record.kind == crate::contest::Kind::Peer2d;
            let name = if flat { format!("{name} (2D)") } else { name.to_owned() };
            Some(Bar { name, value: record.clears, colour: 1, quoted: false })
        });
        let quoted = quoted::of(view).into_iter().flat_map(|quoted| {
            quoted::WHAT.into_iter().zip(quoted.peers_ms).map(|((name, _), ms)| Bar {
                name: format!("{name} (quoted)"),
                value: ms / quoted::CLEAR_MS,
                colour: 2,
                quoted: true,
            })
        });
        bars::Group { name: view.to_owned(), bars: ours.chain(ways).chain(crates).chain(quoted).collect() }
    };
    views.map(group).filter(|group| !group.bars.is_empty()).collect()
}

/// A curve for each level, of the points of all views.
fn by_level(data: &Data, views: &[&str], x: impl Fn(&crate::record::Record) -> f64) -> Vec<Curve> {
    let levels = data.levels();
    let curve = |level: &str| {
        let records = views.iter().filter_map(|view| data.depth(view, level));
        let mut points: Vec<_> = records.map(|record| (x(record), record.min_ms)).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        Curve { name: format!("halfplane {level}"), points, reference: false }
    };
    levels.into_iter().map(curve).filter(|curve| curve.points.len() > 1).collect()
}

fn growth(data: &Data) -> Vec<Curve> {
    let mut curves = by_level(data, &data.views("growth "), |record| record.triangles as f64);
    // A line of slope 1 through the last point of the first curve.
    if let Some((first, last)) =
        curves.first().and_then(|curve| Some((*curve.points.first()?, *curve.points.last()?)))
    {
        let points = [first.0, last.0].map(|x| (x, last.1 * x / last.0)).to_vec();
        curves.push(Curve { name: "slope 1".to_owned(), points, reference: true });
    }
    curves
}

fn pixels(data: &Data) -> Vec<Curve> {
    let mut views = data.views("pixels ");
    views.extend(data.views("micro fullscreen back-to-front, 1000"));
    let mut curves = by_level(data, &views, |record| record.samples as f64);
    if let (Some(first), Some(each)) =
        (curves.first(), views.last().and_then(|view| data.read_modify_write(view)))
    {
        let xs = [first.points.first(), first.points.last()].into_iter().flatten().map(|point| point.0);
        let points = xs.map(|x| (x, x * each)).collect();
        let name = format!("read-modify-write of {CLEAR_PIXELS} pixels, per pixel (slope 1)");
        curves.push(Curve { name, points, reference: true });
    }
    curves
}

fn ms(row: &crate::breakdown::table::Row) -> Option<f64> {
    row.ms
}

fn millions(row: &crate::breakdown::table::Row) -> Option<f64> {
    row.instructions.map(|count| count as f64 / 1e6)
}

fn stages(
    data: &Data,
    unit: &str,
    of: fn(&crate::breakdown::table::Row) -> Option<f64>,
) -> Vec<stacks::Group> {
    let mut groups: Vec<stacks::Group> = Vec::new();
    for row in &data.stages {
        let Some(value) = of(row) else { continue };
        let name = format!("{}, {unit}", row.view);
        if groups.last().is_none_or(|group| group.name != name) {
            groups.push(stacks::Group { name, stacks: Vec::new() });
        }
        let Some(group) = groups.last_mut() else { continue };
        if group.stacks.last().is_none_or(|stack| stack.name != row.level) {
            group.stacks.push(Stack { name: row.level.clone(), parts: vec![0.0; Part::ALL.len()] });
        }
        if let Some(stack) = group.stacks.last_mut()
            && let Some(place) = Part::ALL.iter().position(|&part| part == row.part)
        {
            stack.parts[place] += value;
        }
    }
    // Levels that are much slower would leave nothing to be seen of the others; they are in the table.
    for group in &mut groups {
        let all = |stack: &Stack| stack.parts.iter().sum::<f64>();
        let least = group.stacks.iter().map(all).fold(f64::INFINITY, f64::min);
        group.stacks.retain(|stack| all(stack) <= 3.0 * least);
    }
    groups
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::breakdown::table::Row;
    use crate::record::{records, tests::outcome};
    use std::fs;

    #[test]
    fn every_plot_is_drawn() {
        let mut outcomes =
            ["castle main 1280x720", "growth 10^3", "growth 10^4", "pixels 10^4", "pixels 10^5"]
                .map(|view| outcome(view, "halfplane avx2 depth"));
        for (place, outcome) in outcomes.iter_mut().enumerate() {
            outcome.samples = 10u64.pow(place as u32 + 1);
            outcome.rows.iter_mut().for_each(|row| row.triangles = 10usize.pow(place as u32 + 1));
        }
        let stage = |part, ms| Row {
            view: "castle main 1280x720".to_owned(),
            level: "avx2".to_owned(),
            part,
            instructions: Some(2_000_000),
            ms: Some(ms),
        };
        let stages = vec![stage(Part::Cull, 0.25), stage(Part::Depth, 0.5)];
        let data = Data { records: records(&outcomes, ""), stages, ..Data::default() };
        let folder = std::env::temp_dir().join(format!("halfplane-figures-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let files = draw(&data, &folder).unwrap();
        let texts: Vec<_> = files.iter().map(|file| fs::read_to_string(file).unwrap()).collect();
        fs::remove_dir_all(&folder).unwrap();
        assert_eq!(texts.len(), 5);
        assert!(texts[0].contains("halfplane avx2, meshlets") && !texts[0].contains("D16"), "{}", texts[0]);
        for (text, part) in texts.iter().zip(["raw (quoted)", "slope 1", "samples", "0.750", "4.00"]) {
            assert!(text.contains(part), "{part}: {text}");
        }
        assert!(draw(&Data::default(), &folder).unwrap().is_empty());
    }
}
