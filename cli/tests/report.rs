//! `report`: a page, its tables as CSV, and errors of 0 where the contract says so.

mod common;

use std::collections::HashMap;

use common::{Folder, IDENTITY};

/// A slope over the whole picture, a triangle before it, a sliver, one through the near plane, one outside.
const OBJ: &str = "v -1 -1 .9\nv 3 -1 .5\nv -1 3 .7\nv -.5 -.5 .2\nv .4 -.4 .3\nv .1 .6 .1\n\
                   v -.9 .05 .15\nv .9 .051 .15\nv .9 .06 .4\nv .7 .7 -.5\nv .9 .7 .5\nv .8 .9 .6\n\
                   v 5 5 .5\nv 6 5 .5\nv 5 6 .5\n\
                   f 1 2 3\nf 4 5 6\nf 7 8 9\nf 10 11 12\nf 13 14 15\n";

/// A CSV without quoted line breaks: rows by heading.
fn table(folder: &Folder, name: &str) -> Vec<HashMap<String, String>> {
    let text = String::from_utf8(folder.read(name)).unwrap();
    let fields = |line: &str| {
        let (mut fields, mut quoted) = (vec![String::new()], false);
        for letter in line.chars() {
            match letter {
                '"' => quoted = !quoted,
                ',' if !quoted => fields.push(String::new()),
                _ => fields.last_mut().unwrap().push(letter),
            }
        }
        fields
    };
    let mut lines = text.lines().map(fields);
    let headings = lines.next().unwrap();
    lines.map(|fields| headings.iter().cloned().zip(fields).collect()).collect()
}

#[track_caller]
fn number(row: &HashMap<String, String>, name: &str) -> f64 {
    row[name].parse().unwrap_or_else(|_| panic!("{name} of {row:?}"))
}

#[test]
fn a_tiny_scene_has_a_page_and_tables_and_our_errors_are_those_promised() {
    let folder = Folder::new("report_tiny");
    folder.write("tiny.obj", OBJ);
    let arguments = [
        "report",
        "tiny.obj",
        "--matrix",
        IDENTITY,
        "--size",
        "96x64",
        "--cull",
        "none",
        "--seconds",
        "0.001",
        "--max-error",
        "1000000",
        "--no-programs",
        "--out",
        "page",
    ];
    let text = folder.succeed(&arguments);
    assert!(text.contains("front: ") && text.contains("recommended for tiny.obj: "), "{text}");
    assert!(text.contains("Cargo.toml: halfplane = "), "{text}");
    let page = String::from_utf8(folder.read("page/index.html")).unwrap();
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
    assert!(page.matches("<svg").count() > 9 && !page.contains("http://cdn") && !page.contains("<script"));
    for name in
        ["depth", "subpixel-bits", "transform", "antialiasing", "levels", "format", "peers", "savings"]
    {
        assert!(folder.listing().contains(&format!("page/{name}.csv")), "{name}");
        assert!(!table(&folder, &format!("page/{name}.csv")).is_empty(), "{name}");
    }

    for row in table(&folder, "page/levels.csv") {
        assert_eq!(number(&row, "pixels_not_as_specified_px"), 0.0, "{row:?}");
        assert!(number(&row, "min_ms") > 0.0 && number(&row, "frames") >= 3.0, "{row:?}");
    }
    let ablation = table(&folder, "page/ablation.csv");
    let (inside, left_out): (Vec<_>, Vec<_>) =
        ablation.iter().partition(|row| row["note"].starts_with("not measured: "));
    assert!(inside.len() == 3 && left_out.len() > 3, "{ablation:?}");
    for row in left_out {
        assert_eq!(number(row, "pixels_not_as_specified_px"), 0.0, "{row:?}");
        assert!(number(row, "min_ms") > 0.0, "{row:?}");
    }
    let depth = table(&folder, "page/depth.csv");
    let ours: Vec<_> = depth.iter().filter(|row| row["choice"].starts_with("D32")).collect();
    assert!(!ours.is_empty());
    for row in ours {
        assert!(number(row, "largest_error_2_to_minus_32") <= 1.01, "{row:?}");
        assert!(number(row, "mean_error_2_to_minus_32") <= 1.01, "{row:?}");
    }
    let bits = table(&folder, "page/subpixel-bits.csv");
    assert_eq!(bits.len(), 10);
    for (bits, row) in bits.iter().enumerate().take(9).skip(1) {
        // Half a step, and what floats lose.
        let bound = 0.5 / f64::from(1 << bits) + 1e-4;
        assert!(number(row, "largest_vertex_displacement_px") <= bound, "{row:?}");
    }
    let broken = "guard band of ±32768 px it breaks 5 bounds: 1 to 8 sub-pixel bits: 12; ";
    assert!(bits[9]["note"].contains(broken), "{bits:?}");
    for row in table(&folder, "page/checks.csv") {
        assert_eq!(number(&row, "differences"), 0.0, "{row:?}");
    }
    for row in table(&folder, "page/stiffness.csv") {
        assert!(number(&row, "depth_d32") <= 1.01, "{row:?}");
        if !["distant", "near-plane", "denormal"].contains(&row["family"].as_str()) {
            assert_eq!(number(&row, "wrong_samples"), 0.0, "{row:?}");
        }
    }
}

#[test]
fn what_is_no_scene_is_refused_and_nothing_is_written() {
    let folder = Folder::new("report_wrong");
    folder.write("points.obj", "v 0 0 0\nv 1 0 0\n");
    for arguments in [
        &["report", "absent.obj"][..],
        &["report", "points.obj"],
        &["report", "--max-error", "-1"],
        &["report", "--seconds", "-1"],
    ] {
        let output = folder.run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(errors.lines().count(), 1, "{errors}");
    }
    assert_eq!(folder.listing(), ["points.obj"]);
}
