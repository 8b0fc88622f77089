//! Pictures of small models: the right pixels, by whichever file and camera they are asked for.

mod common;

use common::{Folder, IDENTITY, glb, gltf_mesh, scn1};
use halfplane_cli::picture::colour_of;

/// The left half of clip space at z = 0.5 as two triangles, counter-clockwise as seen.
const HALF: [[f32; 3]; 4] = [[-1.0, -1.0, 0.5], [0.0, -1.0, 0.5], [0.0, 1.0, 0.5], [-1.0, 1.0, 0.5]];
const OBJ: &str = "v -1 -1 .5\nv 0 -1 .5\nv 0 1 .5\nv -1 1 .5\nf 1 2 3\nf 1/1 3/2 4/3\n";
const NONE: u32 = u32::MAX;
/// 0.5 as a unorm32, ties up.
const MIDDLE: u32 = 0x8000_0000;

/// Renders with `--raw` and returns depths and ids.
fn raw(folder: &Folder, arguments: &[&str]) -> (Vec<u32>, Vec<u32>) {
    folder.succeed(&[&["render"], arguments, &["--raw"]].concat());
    (folder.words("out/depth.u32"), folder.words("out/ids.u32"))
}

/// What an 8x4 picture of the half must be: the diagonal from bottom left to top right of the square
/// of 4x4 pixels runs through pixel centres, which belong to the triangle right of it (its left edge).
fn expected(first: u32, second: u32) -> (Vec<u32>, Vec<u32>) {
    let mut ids = vec![NONE; 32];
    for y in 0..4 {
        for x in 0..4 {
            ids[y * 8 + x] = if x + y >= 3 { first } else { second };
        }
    }
    (ids.iter().map(|&id| if id == NONE { NONE } else { MIDDLE }).collect(), ids)
}

#[test]
fn an_obj_in_clip_space() {
    let folder = Folder::new("obj");
    folder.write("half.obj", OBJ);
    let view = ["half.obj", "--matrix", IDENTITY, "--size", "8x4"];
    assert_eq!(raw(&folder, &view), expected(0, 1));
    // Counter-clockwise on the screen is front for OBJ files.
    let back = raw(&folder, &[&view[..], &["--cull", "back"]].concat());
    assert_eq!(back, expected(0, 1));
    let front = raw(&folder, &[&view[..], &["--cull", "front"]].concat());
    assert!(front.1.iter().all(|&id| id == NONE));
    let turned = raw(&folder, &[&view[..], &["--cull", "back", "--front", "cw"]].concat());
    assert!(turned.1.iter().all(|&id| id == NONE));
    let (depth, ids) = raw(&folder, &[&view[..], &["--depth", "d16"]].concat());
    assert_eq!(ids, expected(0, 1).1);
    assert!(depth.iter().all(|&d| d == 0x8000 || d == 0xFFFF), "{depth:x?}");
}

#[test]
fn pictures_show_what_the_raw_files_hold() {
    let folder = Folder::new("pictures");
    folder.write("slope.obj", "v -1 -1 .1\nv 3 -1 .5\nv -1 3 .9\nv 1 1 .3\nf 1 2 3\nf 1 2 4\n");
    let (depth, ids) = raw(&folder, &["slope.obj", "--matrix", IDENTITY, "--size", "9x7"]);
    let listing = folder.listing();
    let files = ["out/depth.png", "out/depth.u32", "out/ids.png", "out/ids.u32", "out/shaded.png"];
    assert_eq!(listing, [&["out"], &files[..], &["slope.obj"]].concat());

    let picture = image::load_from_memory(&folder.read("out/ids.png")).unwrap();
    assert_eq!(picture.color(), image::ColorType::Rgb8);
    let shown: Vec<[u8; 3]> = picture.to_rgb8().pixels().map(|p| p.0).collect();
    assert_eq!(shown, ids.iter().map(|&id| colour_of(id)).collect::<Vec<_>>());
    assert_eq!((picture.width(), picture.height()), (9, 7));

    let picture = image::load_from_memory(&folder.read("out/depth.png")).unwrap();
    assert_eq!(picture.color(), image::ColorType::L16);
    let greys: Vec<u16> = picture.to_luma16().pixels().map(|p| p.0[0]).collect();
    let mut pairs: Vec<_> = depth.into_iter().zip(greys).collect();
    pairs.sort_unstable();
    assert!(pairs.windows(2).all(|w| w[0].1 >= w[1].1), "farther must not be lighter: {pairs:?}");
    assert_eq!(pairs[0].1, 65535);
    assert!(pairs.iter().all(|&(depth, grey)| (depth == NONE) == (grey == 0)), "{pairs:?}");
    assert!(pairs.iter().any(|&(depth, _)| depth != NONE));

    let shaded = image::load_from_memory(&folder.read("out/shaded.png")).unwrap();
    assert_eq!((shaded.width(), shaded.height()), (9, 7));
}

#[test]
fn a_glb_with_nodes_inside_nodes() {
    let folder = Folder::new("glb");
    // The half, moved and shrunk; the nodes put it back. The second node hangs below the first.
    let away = HALF.map(|[x, y, z]| [(x - 1.0) * 0.5, y * 0.25, z * 4.0]);
    let nodes = r#"[{"children":[1],"translation":[1,0,0]},
                    {"mesh":0,"matrix":[2,0,0,0, 0,4,0,0, 0,0,0.25,0, 0,0,0,1]}]"#;
    let (json, buffer) = gltf_mesh(&away, &[0, 1, 2, 0, 2, 3], nodes, "");
    folder.write("half.glb", glb(&json, &buffer));
    let view = ["--matrix", IDENTITY, "--size", "8x4"];
    assert_eq!(raw(&folder, &[&["half.glb"], &view[..]].concat()), expected(0, 1));
    // The same with the buffer in a file of its own.
    let (json, buffer) = gltf_mesh(&away, &[0, 2, 3, 0, 1, 2], nodes, r#""uri":"half.bin","#);
    folder.write("half.gltf", json);
    folder.write("half.bin", buffer);
    assert_eq!(raw(&folder, &[&["half.gltf"], &view[..]].concat()), expected(1, 0));
}

#[test]
fn an_scn1_scene_and_its_cameras() {
    let folder = Folder::new("scn1");
    // Clockwise as seen from z = 0: front for SCN1.
    let wall = [[-4.0, -2.0, 5.0], [-4.0, 2.0, 5.0], [4.0, 2.0, 5.0], [4.0, -2.0, 5.0]];
    folder.write("wall.bin", scn1(&wall, &[0, 1, 2, 0, 2, 3, 0, 2, 1]));
    let ready = IDENTITY.replace(',', " ");
    folder.write(
        "wall.txt",
        format!(
            "# cameras\ncamera straight\neye 0 0 0\ndir 0 0 1\nup 0 1 0\nlens fovy 0.9 near 1 far 9\n\
             mvp 8x4 {ready}\ncamera other\neye 0 0 9\ndir 0 0 -1\nup 0 1 0\nlens fovy 0.9 near 1 far 9\n"
        ),
    );
    // 8x4 has a ready matrix, in which the wall lies behind the far plane.
    let (_, ids) = raw(&folder, &["wall.bin", "--camera", "straight", "--size", "8x4"]);
    assert!(ids.iter().all(|&id| id == NONE), "{ids:?}");
    // Any other size is made from the lens; it must be what the same options give.
    for size in ["16x8", "30x40"] {
        let named = raw(&folder, &["wall.bin", "--camera", "straight", "--size", size]);
        let degrees = 0.9f64.to_degrees().to_string();
        let lens = ["--fov", &degrees, "--near", "1", "--far", "9", "--size", size];
        let free = [&["wall.bin", "--eye", "0,0,0", "--target", "0,0,1"], &lens[..]].concat();
        assert_eq!(named, raw(&folder, &free), "{size}");
        assert!(named.1.contains(&0) && named.1.contains(&1), "{:?}", named.1);
        assert!(!named.1.contains(&2), "triangle 2 faces away");
    }
    // From behind, back faces are culled: only triangle 2 is seen; without culling, 0 and 1 win.
    let (_, ids) = raw(&folder, &["wall.bin", "--camera", "other", "--size", "16x8"]);
    assert!(ids.contains(&2) && !ids.contains(&0) && !ids.contains(&1), "{ids:?}");
    let (_, ids) = raw(&folder, &["wall.bin", "--camera", "other", "--size", "16x8", "--cull", "none"]);
    assert!(ids.contains(&0) && !ids.contains(&2), "{ids:?}");
}

#[test]
fn right_handed_models_are_not_mirrored() {
    let folder = Folder::new("hands");
    // The second triangle lies towards +x. From +z, a right-handed viewer has +x at his right.
    folder.write("x.obj", "v -3 -1 0\nv -1 -1 0\nv -2 1 0\nv 1 -1 0\nv 3 -1 0\nv 2 1 0\nf 1 2 3\nf 4 5 6\n");
    let (_, ids) =
        raw(&folder, &["x.obj", "--eye", "0,0,9", "--target", "0,0,0", "--cull", "back", "--size", "32x16"]);
    let at = |id| ids.iter().position(|&found| found == id).unwrap() % 32;
    assert!(at(0) < 16 && at(1) >= 16);
    let vertices = [
        [-3.0, -1.0, 0.0],
        [-2.0, 1.0, 0.0],
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
        [2.0, 1.0, 0.0],
        [3.0, -1.0, 0.0],
    ];
    folder.write("x.bin", scn1(&vertices, &[0, 1, 2, 3, 4, 5]));
    // A left-handed one has it at his right from -z.
    let (_, ids) = raw(&folder, &["x.bin", "--eye", "0,0,-9", "--target", "0,0,0", "--size", "32x16"]);
    let at = |id| ids.iter().position(|&found| found == id).unwrap() % 32;
    assert!(at(0) < 16 && at(1) >= 16);
}

#[test]
fn without_a_camera_the_model_is_framed() {
    let folder = Folder::new("frame");
    folder.write("far.obj", "v 1000 2000 -500\nv 1010 2000 -500\nv 1005 2030 -490\nv 1004 2001 -510\nf 1 2 3\nf 1 3 4\nf 2 4 3\nf 1 4 2\n");
    for size in ["40x30", "12x60"] {
        let (_, ids) = raw(&folder, &["far.obj", "--size", size]);
        let width: usize = size.split('x').next().unwrap().parse().unwrap();
        let height = ids.len() / width;
        let drawn: Vec<_> =
            (0..ids.len()).filter(|&at| ids[at] != NONE).map(|at| (at % width, at / width)).collect();
        let touches = |near: &dyn Fn(&(usize, usize)) -> usize, side: usize| {
            let (min, max) = (drawn.iter().map(near).min().unwrap(), drawn.iter().map(near).max().unwrap());
            (max - min + 1) as f64 / side as f64
        };
        let fill = touches(&|p| p.0, width).max(touches(&|p| p.1, height));
        assert!((0.7..1.0).contains(&fill), "{size}: {fill}");
    }
}

#[test]
fn verify_finds_small_models_right_and_writes_nothing() {
    let folder = Folder::new("verify");
    folder.write("half.obj", OBJ);
    for depth in ["d32", "d16"] {
        for cull in ["none", "back", "front"] {
            let report =
                folder.succeed(&["verify", "half.obj", "--size", "61x43", "--depth", depth, "--cull", cull]);
            assert!(report.contains("mismatching pixels: 0\n"), "{report}");
            assert!(report.contains("depth error in units of 2^-"), "{report}");
        }
    }
    assert_eq!(folder.listing(), ["half.obj"]);
}

#[test]
fn the_built_in_scene_needs_nothing() {
    let folder = Folder::new("default");
    let report = folder.succeed(&["--size", "320x180"]);
    for part in ["320x180", "submitted", "drawn", "culled", "rejected", "level ", "draw", "ms"] {
        assert!(report.contains(part), "{part}: {report}");
    }
    let names = ["out", "out/depth.png", "out/ids.png", "out/shaded.png"];
    assert_eq!(folder.listing(), names);
    let first = names[1..].iter().map(|name| folder.read(name)).collect::<Vec<_>>();
    folder.succeed(&["render", "--size", "320x180", "--camera", "terrace"]);
    let second = names[1..].iter().map(|name| folder.read(name)).collect::<Vec<_>>();
    assert!(first == second, "the same command gives the same files");
    // The terrace's camera stands among triangles that cross its near plane.
    let clipped: u32 =
        report.split("clipped ").nth(1).and_then(|t| t.split(')').next()).unwrap().parse().unwrap();
    assert!(clipped > 10, "{report}");
    let report = folder.succeed(&["verify", "--size", "160x90"]);
    assert!(report.contains("mismatching pixels: 0\n"), "{report}");
}
