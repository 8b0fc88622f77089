//! `bench`, `--level` and `--meshlets`: figures that make sense, and the same pictures in every way.

mod common;

use common::{Folder, IDENTITY};
use gltf::json::{Value, deserialize};
use halfplane_cli::level;

const OBJ: &str = "v -1 -1 .1\nv 3 -1 .5\nv -1 3 .9\nv 1 1 .3\nf 1 2 3\nf 1 2 4\nf 2 1 4\n";

/// Runs `bench` with few frames and returns its JSON.
fn bench(folder: &Folder, arguments: &[&str]) -> Value {
    let few = ["--json", "--frames", "5", "--warm-up", "2"];
    let text = folder.succeed(&[&["bench"], arguments, &few].concat());
    assert_eq!(text.lines().count(), 1, "{text}");
    deserialize::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

#[track_caller]
fn number(object: &Value, name: &str) -> f64 {
    object[name].as_f64().unwrap_or_else(|| panic!("{name}: {object}"))
}

#[test]
fn the_json_has_all_figures_in_order() {
    let folder = Folder::new("bench_json");
    folder.write("a \"b\".obj", OBJ);
    let view = ["a \"b\".obj", "--matrix", IDENTITY, "--size", "64x36", "--cull", "back"];
    for more in [
        &["--attachments", "depth"][..],
        &["--attachments", "depth", "--depth", "d16"],
        &["--attachments", "ids", "--moving"],
        &["--attachments", "depth+ids", "--moving"],
        &["--attachments", "coverage", "--level", "fallback"],
        &[],
    ] {
        let object = bench(&folder, &[&view[..], more].concat());
        let order = ["min_ms", "p25_ms", "median_ms", "p75_ms", "max_ms"].map(|name| number(&object, name));
        assert!(order[0] > 0.0 && order.is_sorted(), "{object}");
        let (mean, sdev) = (number(&object, "mean_ms"), number(&object, "sdev_ms"));
        assert!((order[0]..=order[4]).contains(&mean) && (0.0..=order[4]).contains(&sdev), "{object}");
        let limits = &object["limits"];
        let clear = number(limits, "clear_ms");
        assert!(clear > 0.0 && number(limits, "rmw_ms") > 0.0 && number(limits, "transform_ms") >= 0.0);
        let clears = order[0] / clear;
        assert!((number(&object, "clears") - clears).abs() <= 0.01 * clears + 1e-3, "{object}");

        assert_eq!(object["scene"].as_str(), Some("a \"b\".obj"));
        assert_eq!(object["size"].as_str(), Some("64x36"));
        assert_eq!(number(&object, "triangles"), 3.0);
        assert_eq!(number(&object, "drawn"), 2.0);
        assert_eq!(number(&object, "covered"), 64.0 * 36.0, "{object}");
        assert_eq!((number(&object, "frames"), number(&object, "warm_up")), (5.0, 2.0));
        let expected = if more.contains(&"--attachments") { more[1] } else { "depth" };
        assert_eq!(object["attachments"].as_str(), Some(expected));
        assert_eq!(object["moving"].as_bool(), Some(more.contains(&"--moving")));
        let best = level::available()[0].name();
        let expected = if more.contains(&"fallback") { "fallback" } else { best };
        assert_eq!(object["level"].as_str(), Some(expected));
        let bits = if more.contains(&"d16") { 16.0 } else { 32.0 };
        assert_eq!(number(&object, "depth_bits"), bits);
    }
    assert_eq!(folder.listing(), ["a \"b\".obj"], "bench writes no files");
}

#[test]
fn meshlets_change_no_other_figure() {
    let folder = Folder::new("bench_meshlets");
    folder.write("slope.obj", OBJ);
    let slope = ["slope.obj", "--matrix", IDENTITY, "--size", "64x36", "--cull", "back"];
    let built_in = ["--size", "160x90", "--moving", "--attachments", "depth+ids"];
    let keys = ["meshlets", "prepare_ms", "meshlet_bytes"];
    for (scene, least) in [(&slope[..], 1.0), (&built_in, 20.0)] {
        for level in level::available() {
            let arguments = [scene, &["--level", level.name()]].concat();
            let plain = bench(&folder, &arguments);
            let object = bench(&folder, &[&arguments[..], &["--meshlets"]].concat());
            for key in keys {
                assert!(plain.get(key).is_none(), "{plain}");
                assert!(number(&object, key) > 0.0, "{object}");
            }
            let meshlets = number(&object, "meshlets");
            assert!(meshlets >= least && number(&object, "meshlet_bytes") >= 1000.0 * meshlets, "{object}");
            for key in ["scene", "size", "level", "triangles", "vertices", "drawn", "covered", "frames"] {
                assert_eq!(plain[key], object[key], "{key} {}", level.name());
            }
            let names = |object: &Value| {
                let names = object.as_object().unwrap().keys().cloned();
                names.filter(|name| !keys.contains(&&**name)).collect::<Vec<_>>()
            };
            assert_eq!(names(&plain), names(&object));
            assert!(number(&object, "min_ms") > 0.0 && number(&object["limits"], "transform_ms") >= 0.0);
        }
    }
    let report = folder.succeed(&["bench", "--size", "160x90", "--frames", "3", "--meshlets"]);
    assert!(report.contains(" meshlets of ") && report.contains(" bytes, made once in "), "{report}");
}

#[test]
fn the_table_has_the_limits_of_the_same_run() {
    let folder = Folder::new("bench_table");
    let report = folder.succeed(&["bench", "--size", "160x90", "--frames", "3", "--warm-up", "1"]);
    for part in ["the built-in scene", "160x90", "level ", "median", "clears", "read-modify-write", "vertex"]
    {
        assert!(report.contains(part), "{part}: {report}");
    }
    assert_eq!(folder.listing(), [""; 0]);
}

#[test]
fn every_level_gives_the_same_bits() {
    let folder = Folder::new("levels");
    folder.write("slope.obj", OBJ);
    let slope = ["slope.obj", "--matrix", IDENTITY, "--size", "61x43"];
    let built_in = ["--size", "160x90"];
    for (scene, depths) in [(&slope[..], &["d32", "d16"][..]), (&built_in, &["d32"])] {
        for &depth in depths {
            let pictures = level::available().into_iter().map(|level| {
                let options = ["--level", level.name(), "--depth", depth, "--raw"];
                ["", "--meshlets"].map(|way| {
                    let more: &[&str] = if way.is_empty() { &[] } else { &[way] };
                    let report = folder.succeed(&[&["render"], scene, &options, more].concat());
                    assert!(report.contains(&format!("level {}\n", level.name())), "{report}");
                    assert_eq!(report.contains(" meshlets of "), !way.is_empty(), "{report}");
                    let is_count = |line: &&str| {
                        ["submitted", "culled", "rejected"].iter().any(|name| line.starts_with(name))
                    };
                    let counts: Vec<_> = report.lines().filter(is_count).map(str::to_owned).collect();
                    assert_eq!(counts.len(), 3, "{report}");
                    let picture = (folder.read("out/depth.u32"), folder.read("out/ids.u32"), counts);
                    ((level.name(), way), picture)
                })
            });
            let pictures: Vec<_> = pictures.flatten().collect();
            for (how, picture) in &pictures {
                assert!(picture == &pictures[0].1, "{how:?} {depth} {scene:?}");
            }
        }
    }
}

#[test]
fn every_level_is_verified() {
    let folder = Folder::new("levels_verified");
    for level in level::available() {
        let plain = ["verify", "--size", "96x54", "--level", level.name()];
        for more in [&[][..], &["--meshlets"]] {
            let report = folder.succeed(&[&plain[..], more].concat());
            assert!(report.contains("mismatching pixels: 0\n"), "{report}");
            assert!(report.contains(&format!("level {}\n", level.name())), "{report}");
            assert_eq!(report.contains(" meshlets of "), !more.is_empty(), "{report}");
        }
    }
}
