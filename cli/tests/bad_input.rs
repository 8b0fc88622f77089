//! Bad input ends with exit status 2, one line that says what, where and what would be right, and no
//! file.

mod common;

use common::{Folder, bytes_of, glb, gltf_mesh, scn1};

const TRIANGLE: [[f32; 3]; 3] = [[-0.5, -0.5, 0.5], [0.0, 0.5, 0.5], [0.5, -0.5, 0.5]];

/// Runs, and checks everything that all failures have in common; `expected` must all be in the line.
#[track_caller]
fn refused(folder: &Folder, arguments: &[&str], input: &[u8], expected: &[&str]) {
    let before = folder.listing();
    let output = folder.feed(arguments, input);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {errors}");
    assert_eq!(errors.lines().count(), 1, "{arguments:?}: {errors}");
    assert!(errors.ends_with('\n') && errors.starts_with("halfplane: "), "{arguments:?}: {errors}");
    assert_eq!(output.stdout, b"", "{arguments:?}");
    assert_eq!(folder.listing(), before, "{arguments:?}");
    for part in expected {
        assert!(errors.contains(part), "{arguments:?}: no \"{part}\" in {errors}");
    }
}

/// A folder with one file, which `render` and `verify` must refuse.
#[track_caller]
fn file_refused(test: &str, name: &str, contents: &[u8], expected: &[&str]) {
    let folder = Folder::new(test);
    folder.write(name, contents);
    for command in ["render", "verify"] {
        refused(&folder, &[command, name], &[], &[&[name], expected].concat());
    }
}

#[test]
fn files_that_are_not_there_or_not_meshes() {
    let folder = Folder::new("not_meshes");
    refused(&folder, &["render", "nothing.obj"], &[], &["nothing.obj", "No such file"]);
    refused(&folder, &["verify", "nothing.glb"], &[], &["nothing.glb"]);
    refused(&folder, &["render", "."], &[], &["cannot read"]);
    file_refused("a_text", "notes.txt", b"v 0 0 0", &["not a mesh", ".obj"]);
    file_refused("empty_obj", "empty.obj", b"# nothing\nv 0 0 0\n", &["no triangle"]);
    file_refused("text_glb", "text.glb", b"hello", &["glTF"]);
    file_refused("text_gltf", "text.gltf", b"{\"asset\":", &["glTF"]);
    file_refused("binary_obj", "binary.obj", &[0xFF, 0xFE, b'\n', 0x80], &["not a mesh", "no triangle"]);
    file_refused("no_triangles", "none.bin", &scn1(&TRIANGLE, &[]), &["no triangle"]);
}

#[test]
fn positions_that_are_no_numbers() {
    let mut vertices = TRIANGLE;
    vertices[1][2] = f32::NAN;
    file_refused("nan_scn1", "nan.bin", &scn1(&vertices, &[0, 1, 2]), &["vertex 1", "NaN", "finite"]);
    vertices[1][2] = f32::NEG_INFINITY;
    file_refused("inf_scn1", "inf.bin", &scn1(&vertices, &[0, 1, 2]), &["vertex 1", "-inf", "finite"]);
    let (json, buffer) = gltf_mesh(&vertices, &[0, 1, 2], r#"[{"mesh":0}]"#, "");
    file_refused("inf_glb", "inf.glb", &glb(&json, &buffer), &["mesh 0 primitive 0", "finite"]);
    let nan = b"v 0 0 0\nv 1 nan 0\nv 1 1 0\nf 1 2 3\n";
    file_refused("nan_obj", "nan.obj", nan, &["line 2", "NaN", "finite"]);
    let word = b"v 0 0 0\nv 1 0 0\nv 1 one 0\nf 1 2 3\n";
    file_refused("word_obj", "word.obj", word, &["line 3", "three numbers"]);
}

#[test]
fn indices_that_name_nothing() {
    file_refused("index_scn1", "index.bin", &scn1(&TRIANGLE, &[0, 1, 3]), &["index 2", "vertex 3", "0 to 2"]);
    let (json, buffer) = gltf_mesh(&TRIANGLE, &[0, 9, 2], r#"[{"mesh":0}]"#, "");
    file_refused("index_glb", "index.glb", &glb(&json, &buffer), &["mesh 0", "vertex 9", "0 to 2"]);
    let text = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 4\n";
    file_refused("index_obj", "index.obj", text, &["line 4", "vertex 4", "1 to 3"]);
    let text = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nf 0 1 2\n";
    file_refused("zero_obj", "zero.obj", text, &["line 4", "vertex 0", "1 to 3"]);
    file_refused("no_list", "list.bin", &scn1(&TRIANGLE, &[0, 1, 2, 0]), &["4 indices", "multiple of 3"]);
}

#[test]
fn files_that_end_early_or_late() {
    let whole = scn1(&TRIANGLE, &[0, 1, 2]);
    file_refused("short", "short.bin", &whole[..whole.len() - 1], &["59 bytes", "60"]);
    file_refused("header", "header.bin", &whole[..7], &["7 bytes", "12"]);
    file_refused("long", "long.bin", &[whole.as_slice(), &[0]].concat(), &["61 bytes", "60"]);
    // The counts promise sixteen gigabytes.
    let huge = [b"SCN1".to_vec(), bytes_of([u32::MAX, 3])].concat();
    file_refused("huge", "huge.bin", &huge, &["12 bytes"]);
    let (json, buffer) = gltf_mesh(&TRIANGLE, &[0, 1, 2], r#"[{"mesh":0}]"#, "");
    let whole = glb(&json, &buffer);
    file_refused("short_glb", "short.glb", &whole[..whole.len() - 9], &["glTF"]);
    let promised = json.replace("\"count\":3,\"type\":\"VEC3\"", "\"count\":300,\"type\":\"VEC3\"");
    assert_ne!(json, promised);
    file_refused("count_glb", "count.glb", &glb(&promised, &buffer), &["POSITION", "bytes"]);
    let elsewhere = json.replace("\"buffers\":[{", "\"buffers\":[{\"uri\":\"gone.bin\",");
    file_refused("gone_gltf", "gone.gltf", elsewhere.as_bytes(), &["glTF"]);
}

#[test]
fn nodes_that_are_no_tree() {
    for (test, nodes) in [
        ("own_child", r#"[{"mesh":0,"children":[0]}]"#),
        ("two_parents", r#"[{"children":[1,2]},{"children":[2]},{"mesh":0}]"#),
    ] {
        let (json, buffer) = gltf_mesh(&TRIANGLE, &[0, 1, 2], nodes, "");
        file_refused(test, "nodes.glb", &glb(&json, &buffer), &["node ", "parent"]);
    }
}

#[test]
fn options_out_of_range() {
    let folder = Folder::new("options");
    for (arguments, expected) in [
        (&["--size", "0x10"][..], &["0x10", "1 to 16384"][..]),
        (&["--size", "16385x4"], &["16385x4", "1 to 16384"]),
        (&["--size", "wide"], &["wide", "1280x720"]),
        (&["--eye", "1,2", "--target", "0,0,0"], &["--eye", "three finite numbers"]),
        (&["--eye", "1,2,nan", "--target", "0,0,0"], &["--eye", "three finite numbers"]),
        (&["--eye", "1,2,3"], &["--target"]),
        (&["--eye", "1,2,3", "--target", "1,2,3"], &["--target", "--eye"]),
        (&["--eye", "0,5,0", "--target", "0,0,0"], &["--up"]),
        (&["--fov", "0"], &["0.1 to 179"]),
        (&["--fov", "180"], &["180", "0.1 to 179"]),
        (&["--fov", "nan"], &["0.1 to 179"]),
        (&["--near", "0"], &["--near", "greater than 0"]),
        (&["--near", "-1"], &["--near", "greater than 0"]),
        (&["--far", "inf"], &["--far", "finite"]),
        (&["--near", "5", "--far", "5"], &["near 5", "far 5", "near < far"]),
        (&["--near", "9", "--far", "5"], &["near 9", "far 5", "near < far"]),
        (&["--matrix", "1,2,3"], &["3 numbers", "16"]),
        (&["--matrix", "1,0,0,0,0,1,0,0,0,0,nan,0,0,0,0,1"], &["--matrix", "finite"]),
        (&["--matrix", "1,0,0,0,0,1,0,0,0,0,1e99,0,0,0,0,1"], &["number 10", "finite"]),
        (&["--matrix", "1,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1"], &["singular"]),
        (&["--camera", "nobody"], &["nobody", "terrace", "temple", "aerial"]),
        (&["--depth", "d24"], &["d24", "d32", "d16"]),
        (&["--cull", "some"], &["some", "none", "back", "front"]),
        (&["--colour"], &["--colour"]),
    ] {
        for command in [&["render"][..], &["verify"], &[]] {
            refused(&folder, &[command, arguments].concat(), &[], expected);
        }
    }
    refused(&folder, &["paint"], &[], &["paint"]);
    refused(&folder, &["render", "a.obj", "b.obj"], &[], &["b.obj"]);
}

#[test]
fn cameras_by_name() {
    let folder = Folder::new("cameras");
    folder.write("scene.bin", scn1(&TRIANGLE, &[0, 1, 2]));
    folder.write("model.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    let ask = |file: &'static str| ["render", file, "--camera", "door"];
    refused(&folder, &ask("scene.bin"), &[], &["scene.txt", "--eye"]);
    refused(&folder, &ask("model.obj"), &[], &["SCN1", "--eye"]);
    folder.write("scene.txt", "# two\ncamera front\ncamera back\n");
    refused(&folder, &ask("scene.bin"), &[], &["door", "scene.txt", "front, back"]);
    folder.write("scene.txt", "camera door\n");
    refused(&folder, &ask("scene.bin"), &[], &["door", "1280x720", "lens"]);
    folder.write("scene.txt", "camera door\neye 1 2\n");
    refused(&folder, &ask("scene.bin"), &[], &["scene.txt line 2", "three numbers"]);
    let zeros = "0 ".repeat(16);
    folder.write("scene.txt", format!("camera door\nmvp 1280x720 {zeros}\n"));
    refused(&folder, &ask("scene.bin"), &[], &["singular"]);
}

#[test]
fn outputs_that_cannot_be_written() {
    let folder = Folder::new("outputs");
    folder.write("model.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    folder.write("file", "in the way");
    let to = |out: &'static str| ["render", "model.obj", "--size", "8x8", "--raw", "--out", out];
    refused(&folder, &to("file"), &[], &["file", "--out"]);
    refused(&folder, &to("file/below"), &[], &["file", "--out"]);
    // The last of five files is in the way: none of the others may appear.
    std::fs::create_dir_all(folder.path().join("taken/ids.u32")).unwrap();
    refused(&folder, &to("taken"), &[], &["ids.u32", "folder"]);
}

#[test]
fn requests_that_end_early() {
    let folder = Folder::new("requests");
    let coverage =
        [b"TRIQUERY".to_vec(), bytes_of([1, 8, 8, 1, 8, 128, 128, 0, 0, 2048, 0, 0, 2048])].concat();
    let depth = [b"TRIDEPTH".to_vec(), bytes_of([1, 8, 8, 8, 0, 0, 5, 2048, 0, 5, 0, 2048, 5])].concat();
    for (command, name, whole) in [("coverage", "TRIQUERY", coverage), ("depth", "TRIDEPTH", depth)] {
        assert!(folder.feed(&[command], &whole).status.success());
        for end in [0, 3, 8, 12, 30, whole.len() - 1] {
            refused(&folder, &[command], &whole[..end], &[name, "standard input"]);
        }
        let mut empty = whole.clone();
        empty[12..16].fill(0);
        refused(&folder, &[command], &empty, &[name, "0x8", "1 to 16384"]);
        let mut wide = whole.clone();
        wide[12..16].copy_from_slice(&16385u32.to_le_bytes());
        refused(&folder, &[command], &wide, &[name, "16385x8", "1 to 16384"]);
        // Two thousand million triangles are promised, one is there.
        let mut many = whole;
        many[8..12].copy_from_slice(&0x8000_0000u32.to_le_bytes());
        refused(&folder, &[command], &many, &[name, "triangles"]);
    }
}

#[test]
fn levels_that_are_not_there() {
    let folder = Folder::new("levels_refused");
    for command in ["render", "verify", "bench"] {
        for wrong in ["avx1024", "", "scalar"] {
            refused(&folder, &[command, "--level", wrong], &[], &["--level", "fallback", "auto"]);
        }
    }
    for (option, wrong) in
        [("--frames", "0"), ("--frames", "x"), ("--warm-up", "-1"), ("--attachments", "all")]
    {
        refused(&folder, &["bench", option, wrong], &[], &[option]);
    }
}
