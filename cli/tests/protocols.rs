//! The doors for conformance kits, from the outside; and third-party goldens where they are at hand.

mod common;

use std::path::Path;

use common::{Folder, bytes_of, words};

fn request(name: &str, header: &[u32], body: &[i32]) -> Vec<u8> {
    let mut bytes = name.as_bytes().to_vec();
    bytes.extend(bytes_of(header.iter().copied()));
    bytes.extend(bytes_of(body.iter().map(|&word| word as u32)));
    bytes
}

#[test]
fn coverage_of_a_square_in_two_triangles() {
    let folder = Folder::new("coverage");
    // Pixels 1..9 x 1..3 of 10x4, split from bottom left to top right, in opposite windings.
    let triangles = [[16, 16, 144, 16, 16, 48], [144, 16, 16, 48, 144, 48]];
    let output = folder
        .feed(&["coverage"], &request("TRIQUERY", &[2, 10, 4, 1, 4, 128, 128], triangles.as_flattened()));
    assert!(output.status.success());
    // The edge has slope -1/4 and passes no centre: row 1 has 6 pixels left of it, row 2 has 2.
    let left = [0, 0, 0b0111_1110, 0, 0b0000_0110, 0, 0, 0];
    let right = [0, 0, 0b1000_0000, 1, 0b1111_1000, 1, 0, 0];
    assert_eq!(output.stdout, [left, right].concat());
}

#[test]
fn depth_of_a_plane_that_is_exact() {
    let folder = Folder::new("depth");
    // z = 64 + 16 x, in quarter pixels, both windings.
    let triangles = [[0, 0, 64, 8, 0, 96, 0, 8, 64], [0, 0, 64, 0, 8, 64, 8, 0, 96]];
    let input = request("TRIDEPTH", &[2, 3, 2, 2], triangles.as_flattened());
    let output = folder.feed(&["depth"], &input);
    assert!(output.status.success());
    let none = u32::MAX;
    let one = [72, none, none, none, none, none];
    assert_eq!(words(&output.stdout), [one, one].concat());
}

#[test]
fn what_is_allowed_but_beyond_this_program_exits_77() {
    let folder = Folder::new("beyond");
    for (command, input) in [
        ("coverage", request("TRIQUERY", &[1, 4, 4, 1, 17, 128, 128], &[0; 6])),
        ("coverage", request("TRIQUERY", &[1, 4, 4, 1, 8, 128, 256], &[0; 6])),
        ("coverage", request("TRIQUERY", &[1, 4, 4, 1, 8, 128, 128], &[0, 0, 8_388_609, 0, 0, 9])),
        ("depth", request("TRIDEPTH", &[1, 4, 4, 8], &[0, 0, 0, i32::MIN, 0, 0, 0, 9, 0])),
    ] {
        let output = folder.feed(&[command], &input);
        assert_eq!(output.status.code(), Some(77), "{command}");
        assert_eq!(output.stdout, b"");
        assert_eq!(String::from_utf8(output.stderr).unwrap().lines().count(), 1);
    }
}

/// A TRIGOLD1 file: the request it stands for and the expected answer.
fn golden(bytes: &[u8]) -> (Vec<u8>, Vec<u8>) {
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let short = |at: usize| usize::from(u16::from_le_bytes([bytes[at], bytes[at + 1]]));
    assert_eq!(&bytes[..8], b"TRIGOLD1");
    let [n, width, height, samples, bits] = [8, 12, 16, 20, 24].map(word);
    let mut request = [b"TRIQUERY".to_vec(), bytes_of([n, width, height, samples, bits])].concat();
    let mut at = 40;
    for _ in 0..2 * samples {
        request.extend(bytes_of([short(at) as u32]));
        at += 2;
    }
    let stride = width.div_ceil(8) as usize;
    let mut answer = Vec::new();
    for _ in 0..n {
        request.extend(&bytes[at..at + 24]);
        at += 24;
        for _ in 0..samples {
            let mut bitmap = vec![0u8; stride * height as usize];
            let (first, rows) = (short(at), short(at + 2));
            at += 4;
            for row in first..first + rows {
                for x in short(at)..short(at + 2) {
                    bitmap[row * stride + x / 8] |= 1 << (x % 8);
                }
                at += 4;
            }
            answer.extend(bitmap);
        }
    }
    assert_eq!(at, bytes.len());
    (request, answer)
}

#[test]
fn third_party_goldens() {
    let goldens = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/goldens");
    if !goldens.is_dir() {
        println!("skipped: no third-party goldens beside the repository (../shared/goldens)");
        return;
    }
    let folder = Folder::new("goldens");
    for name in [
        "cases_bezout_q16_s1.bin",
        "cases_beyond_q16_s1.bin",
        "cases_centers_q16_s4.bin",
        "cases_big_axis_q16_s1.bin",
        "cases_longsliver_q16_s4.bin",
    ] {
        let (request, expected) = golden(&std::fs::read(goldens.join(name)).unwrap());
        let output = folder.feed(&["coverage"], &request);
        assert!(output.status.success(), "{name}");
        assert!(output.stdout == expected, "{name}: the coverage differs");
    }
}
