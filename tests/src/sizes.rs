//! How many cases each property gets: the only place where that is said.
//!
//! `HALFPLANE_TEST_SCALE` multiplies all of them (a decimal, for instance `0.2` or `50`);
//! `HALFPLANE_TEST_SEED`, an integer, chooses another sequence of cases.

use std::env;

/// Cases of one property.
#[derive(Clone, Copy, Debug)]
pub struct Cases(u32);

macro_rules! table {
    ($($(#[$doc:meta])* $name:ident = $cases:literal;)+) => {
        $($(#[$doc])* pub const $name: Cases = Cases($cases);)+
        /// Every row of the table, by name.
        pub const TABLE: &[(&str, Cases)] = &[$((stringify!($name), $name)),+];
    };
}

table! {
    /// Coverage of one triangle, for each format.
    COVERAGE = 12_000;
    /// Triangles in long and narrow scissors.
    LONG = 500;
    /// Set-up triangles, for each format.
    SETUP = 3_000;
    /// Coverage against the definition in rationals.
    DEFINITION = 300;
    /// Conservative coverage of one triangle, for each format.
    CONSERVATIVE = 3_000;
    /// Triangles and regions, relations of conservative coverage, for each format.
    OVERLAP = 1_000;
    /// Triangulations, fans and grids drawn whole.
    MESH = 250;
    /// Fans of a thousand triangles.
    FAN = 12;
    /// Depth of one triangle, for each pair of formats.
    DEPTH = 3_000;
    /// Depth against the definition in unbounded integers.
    DEPTH_DEFINITION = 400;
    /// All orders of a triangle's vertices.
    ORDERS = 1_500;
    /// Depth tests against a model, for each comparison.
    DEPTH_TEST = 120;
    /// Questions to hierarchical depth, for each comparison.
    HIERARCHY = 1_000;
    /// Draws through bins.
    BINS = 400;
    /// Whole scenes against the reference's picture.
    SCENE = 120;
    /// The same scene through every entry point.
    ENTRY = 100;
    /// Statistics of window triangles and of arbitrary clip-space bits.
    STATISTICS = 800;
    /// Refused draws.
    ERRORS = 300;
    /// Storage layouts.
    STORAGE = 400;
    /// Projected vertices.
    TRANSFORM = 8_000;
    /// Clipped meshes.
    CLIP_MESH = 500;
    /// Clipped triangles and their pieces.
    CLIP_PIECES = 20_000;
    /// Clipped triangles against the exact polygon.
    CLIP_EXACT = 3_000;
    /// Conversions of single numbers.
    NUMBERS = 100_000;
    /// Lane operations.
    LANES = 3_000;
    /// Whole frames drawn by the definition path at every vector level.
    LEVEL_FRAME = 500;
    /// The same for window vertices of the small format.
    LEVEL_SMALL = 200;
    /// Whole frames at every vector level.
    SIMD_FRAME = 2_500;
    /// Whole frames of more triangles than are collected at a time.
    SIMD_MANY = 60;
    /// Frames of triangles with hardly any area.
    SIMD_STEEP = 400;
    /// Frames of vertices whose last bit shows.
    SIMD_VERTEX = 400;
    /// Rows of constant depths.
    SIMD_DEPTH = 300;
    /// Refused draws at every vector level.
    SIMD_ERRORS = 150;
    /// Whole frames of meshlets at every vector level.
    MESHLET_FRAME = 700;
    /// Whole frames of more meshlets than are drawn at a time.
    MESHLET_MANY = 24;
    /// Boxes at the planes of the frustum.
    MESHLET_GRAZING = 2_000;
    /// Meshlets one by one.
    MESHLET_ALONE = 40;
    /// Meshes that are refused.
    MESHLET_ERRORS = 100;
    /// Whole frames of batches at every vector level.
    BATCH_FRAME = 500;
    /// Whole frames of many batches.
    BATCH_MANY = 40;
    /// Boxes and spheres against what is in them.
    BOUND = 3_000;
    /// Meshlets whose triangles face one way.
    CONES = 1_000;
    /// Edges of large triangles.
    CROSSINGS = 4_000;
    /// Parts of each of the long enumerations.
    ENUMERATION = 3;
    /// Random bytes for each of the fuzzer's targets.
    BYTES = 400;
    /// Squares of lattice points on a side of the enumerations, centre sample; not cases: grows with
    /// the sixth root of the scale.
    LATTICE = 9;
}

/// The factor of `HALFPLANE_TEST_SCALE`, 1 without it.
///
/// # Panics
///
/// Where it is set and not a positive number: a run of another size than asked for would mislead.
pub fn scale() -> f64 {
    match env::var("HALFPLANE_TEST_SCALE") {
        Ok(text) => match text.parse() {
            Ok(scale) if scale > 0.0 && scale < 1e6 => scale,
            _ => panic!("HALFPLANE_TEST_SCALE is {text:?}; a number above 0 and below 1000000 is wanted"),
        },
        Err(_) => 1.0,
    }
}

/// The integer of `HALFPLANE_TEST_SEED`, 0 without it.
///
/// # Panics
///
/// Where it is set and not an integer.
pub fn seed() -> u64 {
    match env::var("HALFPLANE_TEST_SEED") {
        Ok(text) => {
            text.parse().unwrap_or_else(|_| panic!("HALFPLANE_TEST_SEED is {text:?}, not an integer"))
        }
        Err(_) => 0,
    }
}

impl Cases {
    /// How many to run: scaled, at least 1.
    pub fn scaled(self) -> u32 {
        (f64::from(self.0) * scale()).round().clamp(1.0, 4e9) as u32
    }

    /// A side of a lattice whose triangles are all tried: their number grows with its sixth power.
    pub fn scaled_side(self) -> i32 {
        (f64::from(self.0) * scale().powf(1.0 / 6.0)).round().clamp(2.0, 40.0) as i32
    }
}
