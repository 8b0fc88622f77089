//! Figures that are not measured here: of C++ programs, by their own harness, on another machine (Zen 3,
//! AVX2, one thread, shared; minima of 3 to 4 interleaved runs; from object space to the finished depth
//! buffer, clear included; on the same scenes and cameras). A clear of 1280x720 pixels of 32 bits took
//! [`CLEAR_MS`] there, so that times can be compared in clears.

/// A clear of 1280x720 on that machine, in milliseconds.
pub const CLEAR_MS: f64 = 0.054;

/// What the columns of [`QUOTED`] are.
pub const WHAT: [(&str, &str); 3] = [
    (
        "raw",
        "rawrunprotected/rasterizer (AVX2): occluders baked offline (sorted into batches, positions quantised), \
         16-bit depth, edges quantised to a table, clips at w > 0 only; triangles, without its queries",
    ),
    (
        "MOC",
        "Intel Masked Occlusion Culling: tiles with a mask and two depths, no depth per pixel, conservative in intent",
    ),
    (
        "ryg",
        "the public occlusion-culling code of the \"optimising\" series, last version: SSE4, float depth, drops \
         triangles that cross the near plane",
    ),
];

/// The figures for one view.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quoted {
    /// The view's name.
    pub view: &'static str,
    /// raw, MOC and ryg, in milliseconds on that machine.
    pub peers_ms: [f64; 3],
    /// What this project is to reach, in clears: with AVX2, with AVX-512.
    pub target_clears: [f64; 2],
}

const fn quoted(view: &'static str, peers_ms: [f64; 3], target_clears: [f64; 2]) -> Quoted {
    Quoted { view, peers_ms, target_clears }
}

/// All of them.
pub const QUOTED: [Quoted; 12] = [
    quoted("castle main 1280x720", [0.74, 0.74, 1.42], [13.0, 10.9]),
    quoted("castle main 1920x1080", [1.09, 0.89, 2.74], [15.7, 13.2]),
    quoted("castle aerial 1280x720", [1.07, 1.28, 1.49], [18.8, 15.9]),
    quoted("castle aerial 1920x1080", [1.60, 1.47, 2.64], [25.9, 21.8]),
    quoted("castle nearcross_n01 1280x720", [0.74, 0.96, 3.32], [13.1, 11.0]),
    quoted("castle nearcross_n01 1920x1080", [1.16, 1.10, 6.82], [19.4, 16.3]),
    quoted("sponza main_n01 1280x720", [1.58, 1.60, 2.24], [27.8, 23.4]),
    quoted("sponza main_n01 1920x1080", [2.14, 1.74, 3.70], [30.6, 25.8]),
    quoted("sponza gallery 1280x720", [3.87, 5.63, 7.17], [68.1, 57.3]),
    quoted("sponza gallery 1920x1080", [5.35, 6.04, 11.9], [94.0, 79.0]),
    quoted("sponza nearcross_n01 1280x720", [3.12, 3.82, 7.75], [54.9, 46.2]),
    quoted("sponza nearcross_n01 1920x1080", [4.28, 4.32, 14.0], [75.3, 63.4]),
];

/// The figures for a view, if there are any.
#[must_use]
pub fn of(view: &str) -> Option<&'static Quoted> {
    QUOTED.iter().find(|quoted| quoted.view == view)
}
