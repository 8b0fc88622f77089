//! Figures that are not measured here: of C++ programs, by their own harness, on other machines (shared, one
//! thread; from object space to the finished depth buffer, clear included; on the same scenes and cameras).
//! Each machine's time of a clear of 1280x720 pixels of 32 bits is known, so that times can be compared in
//! clears.

/// A machine that figures are quoted from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Machine {
    /// What it is.
    pub name: &'static str,
    /// Its widest vectors: the peers that choose use them.
    pub level: &'static str,
    /// What is quoted of the times.
    pub what: &'static str,
    /// A clear of 1280x720, in milliseconds.
    pub clear_ms: f64,
}

/// The machine of [`Quoted::peers_ms`] and [`Quoted::queries_ms`].
pub const ZEN3: Machine =
    Machine { name: "Zen 3", level: "AVX2", what: "minima of 3 to 4 interleaved runs", clear_ms: CLEAR_MS };

/// The machine of [`OnZen4`].
pub const ZEN4: Machine =
    Machine { name: "Zen 4", level: "AVX-512", what: "medians of an earlier run", clear_ms: 0.06 };

/// A clear of 1280x720 on [`ZEN3`], in milliseconds.
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

/// What else is quoted, and is no peer that a target was made of.
pub const MORE: [(&str, &str); 4] = [
    ("raw + queries", "each batch's box is tested against the depth so far before it is drawn"),
    ("raw, quads + queries", "the same, and pairs of triangles were merged into quads offline"),
    ("ryg, first", "the first version of the same code"),
    ("llvmpipe", "Mesa's rasterizer, compiled at run time: a complete GPU pipeline, depth only"),
];

/// The figures for one view.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quoted {
    /// The view's name.
    pub view: &'static str,
    /// raw, MOC and ryg, in milliseconds on [`ZEN3`].
    pub peers_ms: [f64; 3],
    /// raw with queries, raw with quads and queries, on the same machine.
    pub queries_ms: [f64; 2],
    /// What this project is to reach, in clears: with AVX2, with AVX-512.
    pub target_clears: [f64; 2],
}

const fn quoted(
    view: &'static str,
    peers_ms: [f64; 3],
    queries_ms: [f64; 2],
    target_clears: [f64; 2],
) -> Quoted {
    Quoted { view, peers_ms, queries_ms, target_clears }
}

/// All of [`ZEN3`], with the targets.
pub const QUOTED: [Quoted; 12] = [
    quoted("castle main 1280x720", [0.74, 0.74, 1.42], [0.51, 0.33], [13.0, 10.9]),
    quoted("castle main 1920x1080", [1.09, 0.89, 2.74], [0.85, 0.57], [15.7, 13.2]),
    quoted("castle aerial 1280x720", [1.07, 1.28, 1.49], [1.05, 0.68], [18.8, 15.9]),
    quoted("castle aerial 1920x1080", [1.60, 1.47, 2.64], [1.60, 1.02], [25.9, 21.8]),
    quoted("castle nearcross_n01 1280x720", [0.74, 0.96, 3.32], [0.36, 0.36], [13.1, 11.0]),
    quoted("castle nearcross_n01 1920x1080", [1.16, 1.10, 6.82], [0.74, 0.75], [19.4, 16.3]),
    quoted("sponza main_n01 1280x720", [1.58, 1.60, 2.24], [0.64, 0.34], [27.8, 23.4]),
    quoted("sponza main_n01 1920x1080", [2.14, 1.74, 3.70], [1.09, 0.60], [30.6, 25.8]),
    quoted("sponza gallery 1280x720", [3.87, 5.63, 7.17], [2.79, 1.66], [68.1, 57.3]),
    quoted("sponza gallery 1920x1080", [5.35, 6.04, 11.9], [4.15, 2.38], [94.0, 79.0]),
    quoted("sponza nearcross_n01 1280x720", [3.12, 3.82, 7.75], [1.38, 0.89], [54.9, 46.2]),
    quoted("sponza nearcross_n01 1920x1080", [4.28, 4.32, 14.0], [2.43, 1.58], [75.3, 63.4]),
];

/// The figures of [`ZEN4`] for one view, in milliseconds; those of cameras with a near plane of 1 too, on which
/// raw draws other surfaces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OnZen4 {
    /// The view's name.
    pub view: &'static str,
    /// raw, MOC (AVX-512) and ryg.
    pub peers_ms: [Option<f64>; 3],
    /// raw with queries.
    pub queries_ms: f64,
    /// ryg's first version, llvmpipe.
    pub others_ms: [Option<f64>; 2],
}

const fn zen4(
    view: &'static str,
    [raw, moc]: [f64; 2],
    ryg: Option<f64>,
    queries_ms: f64,
    others_ms: [Option<f64>; 2],
) -> OnZen4 {
    OnZen4 { view, peers_ms: [Some(raw), Some(moc), ryg], queries_ms, others_ms }
}

/// All of [`ZEN4`].
pub const ON_ZEN4: [OnZen4; 9] = [
    zen4("castle main 1280x720", [0.72, 0.70], Some(1.88), 0.41, [Some(3.67), Some(7.6)]),
    zen4("castle main 1920x1080", [1.16, 0.81], Some(3.7), 0.73, [Some(5.5), Some(10.2)]),
    zen4("castle aerial 1280x720", [0.97, 1.13], Some(1.83), 0.94, [Some(4.19), Some(8.7)]),
    zen4("castle aerial 1920x1080", [1.46, 1.21], None, 1.42, [None, Some(13.0)]),
    zen4("sponza main 1280x720", [1.39, 2.0], Some(3.5), 0.46, [Some(6.2), Some(9.2)]),
    zen4("sponza main 1920x1080", [1.77, 2.2], Some(5.4), 0.82, [Some(8.5), Some(12.2)]),
    zen4("sponza gallery 1280x720", [3.45, 5.5], Some(9.0), 2.4, [Some(14.4), Some(29.0)]),
    zen4("sponza gallery 1920x1080", [4.7, 5.8], Some(15.8), 3.6, [Some(21.6), Some(39.0)]),
    zen4("sponza nearcross 1280x720", [3.2, 4.2], None, 0.86, [Some(13.6), None]),
];

/// The figures for a view, if there are any.
#[must_use]
pub fn of(view: &str) -> Option<&'static Quoted> {
    QUOTED.iter().find(|quoted| quoted.view == view)
}

/// The figures of [`ZEN4`] for a view, if there are any.
#[must_use]
pub fn on_zen4(view: &str) -> Option<&'static OnZen4> {
    ON_ZEN4.iter().find(|quoted| quoted.view == view)
}

/// The best of raw, MOC and ryg: its name and time.
#[must_use]
pub fn best(peers_ms: [Option<f64>; 3]) -> Option<(&'static str, f64)> {
    let known = WHAT.iter().zip(peers_ms).filter_map(|((name, _), ms)| Some((*name, ms?)));
    known.min_by(|a, b| a.1.total_cmp(&b.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_are_just_below_the_best_peer() {
        for quoted in &QUOTED {
            let (name, ms) = best(quoted.peers_ms.map(Some)).unwrap();
            assert_ne!(name, "ryg");
            let part = quoted.target_clears[0] / (ms / ZEN3.clear_ms);
            assert!((0.93..0.97).contains(&part), "{} {part}", quoted.view);
            assert!(quoted.target_clears[1] < quoted.target_clears[0]);
        }
    }

    #[test]
    fn views_are_found() {
        assert_eq!(best(on_zen4("castle main 1280x720").unwrap().peers_ms), Some(("MOC", 0.70)));
        assert_eq!(best(on_zen4("sponza nearcross 1280x720").unwrap().peers_ms), Some(("raw", 3.2)));
        assert!(on_zen4("sponza nearcross_n01 1280x720").is_none() && of("castle main 1x1").is_none());
        assert_eq!(best([None; 3]), None);
    }
}
