//! `--threads`, `--binned`, `--queries` and `occlusion`: the same pictures, verified, and tables that make sense.

mod common;

use std::num::NonZeroUsize;

use common::{Folder, state, view};
use gltf::json::{Value, deserialize};
use halfplane::bins::TileOrder;
use halfplane::{D16, D32};
use halfplane_cli::camera::Matrix;
use halfplane_cli::level;
use halfplane_cli::mesh::Mesh;
use halfplane_cli::target::{Attachments, Banded, Binned, Clustered, Occluded, Prepared, Target};

const SIZE: (u32, u32) = (203, 117);

fn threads(count: usize) -> NonZeroUsize {
    NonZeroUsize::new(count).unwrap()
}

/// Depths and ids of a plain draw.
fn plain(mesh: &Mesh, matrix: &Matrix, attachments: Attachments) -> [Vec<u32>; 2] {
    let level = level::available()[0];
    let mut target = Target::new(&mesh.positions, &mesh.indices, &state(SIZE)).unwrap();
    target.frame(level, attachments, matrix).unwrap();
    [target.depth_rows(attachments).unwrap(), target.id_rows(attachments).unwrap()]
}

#[test]
fn any_number_of_threads_draws_the_same() {
    let (mesh, matrix) = view(SIZE);
    let expected = plain(&mesh, &matrix, Attachments::DepthIds32);
    let prepared = Prepared::new(&mesh.positions, &mesh.indices).unwrap();
    for count in 1..=16 {
        for level in [level::available()[0], level::Level::FALLBACK] {
            let mut target = Banded::<D32>::new(&prepared, &state(SIZE), threads(count), true).unwrap();
            // A frame must not see the one before, whose times divide it otherwise.
            for _ in 0..3 {
                target.frame(level, &matrix).unwrap();
            }
            let drawn = [target.depth_rows().unwrap(), target.id_rows().unwrap()];
            assert!(drawn == expected, "{count} threads, {}", level.name());
            if count > 3 {
                break;
            }
        }
    }
}

#[test]
fn bins_of_any_size_draw_the_same() {
    let (mesh, matrix) = view(SIZE);
    let expected = plain(&mesh, &matrix, Attachments::DepthIds32);
    let (positions, indices) = (&mesh.positions, &mesh.indices);
    let mut rounds = Vec::new();
    for (order, count, most) in [
        (TileOrder::Rows, 1, 1 << 16),
        (TileOrder::Hilbert, 2, 1 << 16),
        (TileOrder::Rows, 3, 500),
        (TileOrder::Hilbert, 1, 0),
    ] {
        let mut target =
            Binned::<D32>::new(positions, indices, &state(SIZE), order, threads(count), most).unwrap();
        let mut round = 0;
        for level in level::available() {
            target.frame(level, &matrix).unwrap();
            let statistics;
            (statistics, round) = target.frame(level, &matrix).unwrap();
            let what = format!("{order:?}, {count} threads, {most} triangles, {}", level.name());
            assert!(target.rows().unwrap() == expected, "{what}");
            assert_eq!(statistics.submitted as usize, mesh.triangles());
        }
        rounds.push(round);
    }
    assert!(rounds[2] > 3 && rounds[3] == 0, "{rounds:?}");
}

#[test]
fn questions_change_no_depth() {
    let (mesh, matrix) = view(SIZE);
    let [depths, _] = plain(&mesh, &matrix, Attachments::DepthIds32);
    let clustered = Clustered::new(&mesh.positions, &mesh.indices).unwrap();
    for level in level::available() {
        for with_ids in [false, true] {
            let mut target = Occluded::<D32>::new(&clustered, &state(SIZE), with_ids);
            target.frame(level, &matrix).unwrap();
            let (statistics, asked) = target.frame(level, &matrix).unwrap();
            assert!(target.depth_rows().unwrap() == depths, "{}", level.name());
            assert_eq!(statistics.submitted as usize, mesh.triangles());
            assert!(asked.hidden_batches + asked.hidden_meshlets > 0, "{asked:?}");
        }
    }
}

#[test]
fn depths_of_16_bits_are_those_of_a_plain_draw() {
    let (mesh, matrix) = view(SIZE);
    let expected = plain(&mesh, &matrix, Attachments::DepthIds16);
    let (positions, indices, best) = (&mesh.positions, &mesh.indices, level::available()[0]);
    let prepared = Prepared::new(positions, indices).unwrap();
    let mut bands = Banded::<D16>::new(&prepared, &state(SIZE), threads(2), true).unwrap();
    bands.frame(best, &matrix).unwrap();
    assert!([bands.depth_rows().unwrap(), bands.id_rows().unwrap()] == expected, "bands");
    let order = TileOrder::Rows;
    let mut bins = Binned::<D16>::new(positions, indices, &state(SIZE), order, threads(2), 500).unwrap();
    bins.frame(level::available()[0], &matrix).unwrap();
    assert!(bins.rows().unwrap() == expected, "bins");
    let clustered = Clustered::new(positions, indices).unwrap();
    let mut queries = Occluded::<D16>::new(&clustered, &state(SIZE), true);
    let (_, asked) = queries.frame(best, &matrix).unwrap();
    assert!(queries.depth_rows().unwrap() == expected[0], "queries");
    assert!(asked.hidden_batches + asked.hidden_meshlets > 0, "{asked:?}");
}

#[test]
fn every_way_is_verified() {
    let folder = Folder::new("ways");
    let view = ["--size", "203x117"];
    for way in [
        &["--threads", "2"][..],
        &["--threads", "5", "--level", "fallback"],
        &["--binned"],
        &["--binned", "--threads", "3"],
        &["--queries"],
        &["--queries", "--level", "fallback"],
        &["--queries", "--cull", "back"],
        &["--queries", "--cull", "front"],
    ] {
        for depth in ["d32", "d16"] {
            let text = folder.succeed(&[&["verify", "--depth", depth], &view[..], way].concat());
            assert!(text.contains("mismatching pixels: 0\n"), "{way:?}, {depth}: {text}");
        }
    }
    assert_eq!(folder.listing(), Vec::<String>::new());
}

fn bench(folder: &Folder, arguments: &[&str]) -> Value {
    let few = ["--json", "--frames", "3", "--warm-up", "1", "--size", "203x117"];
    let text = folder.succeed(&[&["bench"], arguments, &few].concat());
    deserialize::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

#[test]
fn frames_of_every_way_are_timed() {
    let folder = Folder::new("ways_bench");
    let number =
        |object: &Value, name: &str| object[name].as_f64().unwrap_or_else(|| panic!("{name}: {object}"));
    let queries = bench(&folder, &["--queries"]);
    assert!(number(&queries, "batches") > 0.0 && number(&queries, "hidden_batches") >= 0.0, "{queries}");
    assert!(number(&queries, "hidden_meshlets") <= number(&queries, "tested_meshlets"), "{queries}");
    let bands = bench(&folder, &["--threads", "2"]);
    assert_eq!(number(&bands, "threads"), 2.0);
    assert!(bands["batches"].is_null(), "{bands}");
    for more in [&["--binned"][..], &["--binned", "--hilbert", "--threads", "2"]] {
        let binned = bench(&folder, &[more, &["--attachments", "depth+ids"]].concat());
        assert!(number(&binned, "min_ms") > 0.0, "{binned}");
        assert_eq!(number(&binned, "drawn"), number(&bench(&folder, &[]), "drawn"), "{binned}");
    }
    let text = folder.succeed(&["bench", "--queries", "--frames", "2", "--warm-up", "0", "--size", "90x50"]);
    assert!(text.contains("asked: batches "), "{text}");
}

#[test]
fn occlusion_is_judged_and_shown() {
    let folder = Folder::new("occlusion");
    let text = folder.succeed(&["occlusion", "--size", "203x117"]);
    let value = |name: &str| {
        let line =
            text.lines().find(|line| line.starts_with(name)).unwrap_or_else(|| panic!("{name}: {text}"));
        line.split_whitespace().last().and_then(|word| word.parse::<u32>().ok()).unwrap()
    };
    let (all, outside, culled) = (value("occludees"), value("outside"), value("culled"));
    assert!(all > outside + culled && culled > 0, "{text}");
    assert_eq!(value("wrongly culled"), 0, "{text}");
    assert!(value("falsely visible") < all - outside - culled, "{text}");
    let picture = image::load_from_memory(&folder.read("out/occlusion.png")).unwrap().into_rgb8();
    assert_eq!(picture.dimensions(), SIZE);
    let count = |colour: [u8; 3]| picture.pixels().filter(|pixel| pixel.0 == colour).count();
    assert!(count([255, 64, 48]) > 0 && count([48, 224, 64]) > 0);
}

#[test]
fn ways_that_do_not_go_together_are_refused() {
    let folder = Folder::new("ways_refused");
    for (arguments, expected) in [
        (&["occlusion", "--depth", "d16"][..], "--depth d16"),
        (&["render", "--threads", "0"], "number of threads"),
        (&["render", "--threads", "2000"], "number of threads"),
        (&["render", "--queries", "--binned"], "cannot be used with"),
        (&["render", "--queries", "--threads", "2"], "cannot be used with"),
        (&["bench", "--hilbert"], "--binned"),
        (&["bench", "--binned"], "depth+ids"),
        (&["bench", "--queries", "--attachments", "coverage"], "--attachments depth"),
    ] {
        let output = folder.run(arguments);
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {error}");
        assert!(error.contains(expected), "{arguments:?}: {error}");
        assert_eq!(folder.listing(), Vec::<String>::new());
    }
}
