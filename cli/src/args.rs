//! The command line.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use glam::DVec3;
use halfplane::{Cull, Format, Standard, Winding};

use crate::camera::{self, Matrix};
use crate::level::{self, Level};
use crate::target;

/// An exact triangle rasterizer: renders depth and visibility buffers, and checks every pixel.
///
/// Without a command it renders the built-in scene.
#[derive(Debug, Parser)]
#[command(name = "halfplane", version, args_conflicts_with_subcommands = true)]
pub struct Cli {
    /// What to do; without it, `render` of the built-in scene.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// The options of `render`.
    #[command(flatten)]
    pub options: Options,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Draw a mesh: depth, triangle ids and a shaded preview as PNG files
    ///
    /// FILE is a Wavefront OBJ, glTF (.gltf, .glb) or SCN1 mesh; without it, the built-in scene.
    /// OBJ and glTF are taken as right-handed, SCN1 and the built-in scene as left-handed; all
    /// coordinates on the command line are the model's own.
    Render(Picture),
    /// Draw a mesh and compare every pixel with the exact reference; exit status 1 if any differs
    ///
    /// Prints the mismatching pixels (0 is right), the largest and mean depth error in units of the
    /// depth format's last bit, and how far snapping moved vertices. Writes diff.png if any differs.
    Verify(Picture),
    /// Time frames of a mesh, one thread, beside what this machine can do at best in the same run
    ///
    /// A frame is everything from object-space positions and a matrix to finished buffers: clear,
    /// transform, draw. Limits are the clear and the read-modify-write of 1280x720 numbers of 32 bits, and
    /// the vertex stage alone. "clears" are minima over that of the clear: a measure that can be compared
    /// between machines. Nothing is written to files.
    Bench(Bench),
    /// What occlusion culling leaves out of a mesh: boxes over the depth picture, green where something in them can be
    /// seen, red where all is hidden, and a table
    ///
    /// The mesh is clustered; occludees are the boxes of its meshlets, asked after the whole frame. "wrongly culled"
    /// counts hidden boxes of which a triangle is in the exact picture: it must be 0, and the exit status is 1 where it is
    /// not. Writes occlusion.png.
    Occlusion(Picture),
    /// Measure error against run time of every choice: one page, its plots, and the same numbers as CSV
    ///
    /// For the built-in scene, and for Castle and Sponza where they are, or for FILE alone: sub-pixel bits, depth
    /// planes, the transform's floats, samples for each pixel, vector levels, formats, other crates. Errors are
    /// against the exact reference; times are taken in turns in one run, on one thread. Writes index.html and *.csv.
    /// Levels, meshlets and depth formats are all measured, whatever the options for them say.
    Report(Report),
    /// Conformance kits: the TRIQUERY protocol from stdin to stdout, which samples are covered
    Coverage,
    /// Conformance kits: the TRIDEPTH protocol from stdin to stdout, the depth of every pixel
    Depth,
}

/// A mesh and how to draw it.
#[derive(Debug, Args)]
pub struct Picture {
    /// An OBJ, glTF, GLB or SCN1 file; without it, the built-in scene
    pub file: Option<PathBuf>,
    /// How to draw it.
    #[command(flatten)]
    pub options: Options,
}

/// A mesh, how to draw it, and how often.
#[derive(Debug, Args)]
pub struct Bench {
    /// What is drawn.
    #[command(flatten)]
    pub picture: Picture,
    /// What a frame writes
    #[arg(long, value_enum, default_value = "depth")]
    pub attachments: Attachments,
    /// Frames that are measured
    #[arg(long, value_name = "N", default_value_t = 600, allow_hyphen_values = true, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub frames: u32,
    /// Frames that are drawn before, and not measured
    #[arg(long, value_name = "N", default_value_t = 60, allow_hyphen_values = true, value_parser = clap::value_parser!(u32).range(0..=1_000_000))]
    pub warm_up: u32,
    /// Move the camera a little every frame, always the same way: a processor learns repeated frames by heart
    #[arg(long)]
    pub moving: bool,
    /// With --binned, draw tiles along Hilbert's curve and not row by row
    #[arg(long, requires = "binned")]
    pub hilbert: bool,
    /// Print one JSON object instead of a table
    #[arg(long)]
    pub json: bool,
}

/// What is reported on.
#[derive(Debug, Args)]
pub struct Report {
    /// What is drawn.
    #[command(flatten)]
    pub picture: Picture,
    /// Time for each row, at most; never fewer than 3 frames
    #[arg(long, value_name = "S", default_value_t = Self::SECONDS, value_parser = seconds, allow_hyphen_values = true)]
    pub seconds: f64,
    /// Wrong pixels that the recommended configuration may have, against the picture without any rounding
    /// [default: as few as any configuration has]
    #[arg(long, value_name = "PIXELS", value_parser = wrong_pixels, allow_hyphen_values = true)]
    pub max_error: Option<f64>,
    /// Leave out the linked programs, which need cargo and the sources
    #[arg(long)]
    pub no_programs: bool,
    /// Where castle.bin, sponza.bin and their cameras are looked for
    #[arg(long, value_name = "DIR", default_value = "../shared/scenes")]
    pub scenes: PathBuf,
}

impl Report {
    /// `--seconds`, if it is not given.
    pub const SECONDS: f64 = 0.25;
}

/// How to draw a mesh.
#[derive(Debug, Clone, Args)]
pub struct Options {
    /// Width and height of the picture in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720", value_parser = size)]
    pub size: (u32, u32),
    /// A camera by its name in the .txt beside an SCN1 file, or one of the built-in scene
    #[arg(long, value_name = "NAME", conflicts_with_all = ["eye", "target", "matrix"])]
    pub camera: Option<String>,
    /// The camera's place; without any camera option, one that frames the model is made
    #[arg(long, value_name = "X,Y,Z", value_parser = point, requires = "target", allow_hyphen_values = true)]
    pub eye: Option<DVec3>,
    /// The point the camera looks at
    #[arg(long, value_name = "X,Y,Z", value_parser = point, requires = "eye", allow_hyphen_values = true)]
    pub target: Option<DVec3>,
    /// The direction that is up in the picture [default: 0,1,0]
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    pub up: Option<DVec3>,
    /// Vertical field of view, 0.1 to 179 degrees [default: the named camera's, or 45]
    #[arg(long, value_name = "DEGREES", value_parser = field_of_view, allow_hyphen_values = true)]
    pub fov: Option<f64>,
    /// Distance of the near plane [default: chosen from the model's size]
    #[arg(long, value_name = "DISTANCE", value_parser = distance, allow_hyphen_values = true)]
    pub near: Option<f64>,
    /// Distance of the far plane [default: behind the model]
    #[arg(long, value_name = "DISTANCE", value_parser = distance, allow_hyphen_values = true)]
    pub far: Option<f64>,
    /// The camera as 16 numbers with commas or spaces between, row by row: clip = [x y z 1] * M,
    /// y up, z from 0 (near) to w (far)
    #[arg(long, value_name = "M00,..,M33", value_parser = matrix, allow_hyphen_values = true,
          conflicts_with_all = ["eye", "target", "up", "fov", "near", "far"])]
    pub matrix: Option<Matrix>,
    /// Depth format: 32 or 16 bits, both normalized integers
    #[arg(long, value_enum, default_value = "d32")]
    pub depth: DepthFormat,
    /// Which faces are left out [default: back for SCN1 and the built-in scene, none for OBJ and glTF,
    /// whose faces often show both sides]
    #[arg(long, value_enum)]
    pub cull: Option<CullArg>,
    /// How front faces wind on the screen [default: cw for SCN1 and the built-in scene, ccw for OBJ
    /// and glTF]
    #[arg(long, value_enum)]
    pub front: Option<FrontArg>,
    /// How the inner loops run: avx512, avx2, sse4.2, sse2, neon, wasm128, fallback (no vectors), or
    /// auto, the best that this machine has. The picture is the same
    #[arg(long, value_name = "LEVEL", default_value = "auto", value_parser = level::parse)]
    pub level: Level,
    /// Make meshlets of the mesh once, before anything is drawn: runs of triangles with a box round each, so
    /// that a frame passes over those outside the view. The picture is the same
    #[arg(long)]
    pub meshlets: bool,
    /// Cluster the mesh once, before anything is drawn, and draw it from front to back, asking of each batch of
    /// triangles whether it is hidden. The depths are the same; where several triangles are at the same depth, the
    /// id may be another of theirs
    #[arg(long, conflicts_with_all = ["binned", "threads", "meshlets"])]
    pub queries: bool,
    /// Sort the triangles into bins, one for each 64x64 tile, and draw tile by tile. The picture is the same
    #[arg(long, conflicts_with = "meshlets")]
    pub binned: bool,
    /// Threads that draw, each a band of the picture at a time; without --binned, meshlets are made. The picture is
    /// the same
    #[arg(long, value_name = "N", default_value = "1", allow_hyphen_values = true, value_parser = threads)]
    pub threads: NonZeroUsize,
    /// The folder for the pictures; made if it is not there
    #[arg(long, value_name = "DIR", default_value = "out")]
    pub out: PathBuf,
    /// Draw every pixel as a square of this many in the PNG files: for looking at single pixels
    #[arg(long, value_name = "TIMES", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=64))]
    pub zoom: u32,
    /// Also write depth.u32 and ids.u32: rows from the top, 32-bit little-endian numbers
    #[arg(long)]
    pub raw: bool,
}

/// `--depth`
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum DepthFormat {
    /// unorm32
    D32,
    /// unorm16
    D16,
}

/// `--attachments`
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Attachments {
    /// Depth, in the format of --depth
    Depth,
    /// Triangle ids; the last drawn wins
    Ids,
    /// Depth, and the id of the nearest triangle
    #[value(name = "depth+ids")]
    DepthIds,
    /// One bit per pixel
    Coverage,
}

/// `--cull`
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum CullArg {
    /// Both sides are drawn
    None,
    /// Faces turned away are left out
    Back,
    /// Faces turned here are left out
    Front,
}

/// `--front`
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum FrontArg {
    /// Clockwise
    Cw,
    /// Counter-clockwise
    Ccw,
}

impl Options {
    /// `--size`, if it is not given.
    pub const DEFAULT_SIZE: (u32, u32) = (1280, 720);

    /// All as if it were not given, but the size.
    #[must_use]
    pub fn of_size(size: (u32, u32)) -> Self {
        Self {
            size,
            camera: None,
            eye: None,
            target: None,
            up: None,
            fov: None,
            near: None,
            far: None,
            matrix: None,
            depth: DepthFormat::D32,
            cull: None,
            front: None,
            level: Level::detect(),
            meshlets: false,
            queries: false,
            binned: false,
            threads: NonZeroUsize::MIN,
            out: PathBuf::from("out"),
            zoom: 1,
            raw: false,
        }
    }

    /// The part that asks for a camera.
    #[must_use]
    pub fn camera_request(&self) -> camera::Request {
        camera::Request {
            name: self.camera.clone(),
            eye: self.eye,
            target: self.target,
            up: self.up,
            fov: self.fov,
            near: self.near,
            far: self.far,
            matrix: self.matrix,
        }
    }
}

impl DepthFormat {
    /// Bits of a depth.
    #[must_use]
    pub const fn bits(self) -> u32 {
        match self {
            Self::D32 => 32,
            Self::D16 => 16,
        }
    }
}

impl Attachments {
    /// What a frame then writes.
    #[must_use]
    pub const fn in_format(self, depth: DepthFormat) -> target::Attachments {
        use DepthFormat::{D16, D32};
        match (self, depth) {
            (Self::Depth, D32) => target::Attachments::Depth32,
            (Self::Depth, D16) => target::Attachments::Depth16,
            (Self::DepthIds, D32) => target::Attachments::DepthIds32,
            (Self::DepthIds, D16) => target::Attachments::DepthIds16,
            (Self::Ids, _) => target::Attachments::Ids,
            (Self::Coverage, _) => target::Attachments::Coverage,
        }
    }

    /// Its name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Depth => "depth",
            Self::Ids => "ids",
            Self::DepthIds => "depth+ids",
            Self::Coverage => "coverage",
        }
    }
}

impl From<CullArg> for Cull {
    fn from(arg: CullArg) -> Self {
        match arg {
            CullArg::None => Self::None,
            CullArg::Back => Self::Back,
            CullArg::Front => Self::Front,
        }
    }
}

impl From<FrontArg> for Winding {
    fn from(arg: FrontArg) -> Self {
        match arg {
            FrontArg::Cw => Self::Clockwise,
            FrontArg::Ccw => Self::CounterClockwise,
        }
    }
}

fn size(text: &str) -> Result<(u32, u32), String> {
    let limit = Standard::MAX_TARGET;
    let side = |text: &str| text.parse().ok().filter(|side| (1..=limit).contains(side));
    text.split_once(['x', 'X'])
        .and_then(|(width, height)| Some((side(width)?, side(height)?)))
        .ok_or_else(|| format!("it must be WIDTHxHEIGHT, both from 1 to {limit}, such as 1280x720"))
}

/// Finite numbers with commas or white space between them.
fn numbers(text: &str) -> Option<Vec<f64>> {
    text.split([',', ' ', '\t', '\n'])
        .filter(|word| !word.is_empty())
        .map(|word| word.parse().ok().filter(|number: &f64| number.is_finite()))
        .collect()
}

fn point(text: &str) -> Result<DVec3, String> {
    numbers(text)
        .and_then(|numbers| Some(DVec3::from(<[f64; 3]>::try_from(numbers).ok()?)))
        .ok_or_else(|| "it must be three finite numbers, such as 1,2.5,-3".to_owned())
}

fn matrix(text: &str) -> Result<Matrix, String> {
    let numbers = numbers(text).ok_or("it must be 16 finite numbers with commas between")?;
    let count = numbers.len();
    // A number beyond f32 becomes infinite here; the camera's own check names it.
    Matrix::try_from(numbers.iter().map(|&number| number as f32).collect::<Vec<_>>())
        .map_err(|_| format!("it has {count} numbers, a matrix has 16"))
}

fn field_of_view(text: &str) -> Result<f64, String> {
    let fov = text.parse().ok().filter(|fov| (0.1..=179.0).contains(fov));
    fov.ok_or_else(|| "it must be an angle from 0.1 to 179 degrees".to_owned())
}

fn threads(text: &str) -> Result<NonZeroUsize, String> {
    let threads = text.parse().ok().filter(|threads: &NonZeroUsize| threads.get() <= 1024);
    threads.ok_or_else(|| "it must be a number of threads from 1 to 1024".to_owned())
}

fn wrong_pixels(text: &str) -> Result<f64, String> {
    let pixels = text.parse().ok().filter(|pixels: &f64| *pixels >= 0.0);
    pixels.ok_or_else(|| "it must be a number of pixels, 0 or more".to_owned())
}

fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|s: &f64| (0.0..=3600.0).contains(s));
    seconds.ok_or_else(|| "it must be a number of seconds from 0 to 3600".to_owned())
}

fn distance(text: &str) -> Result<f64, String> {
    let distance = text.parse().ok().filter(|d: &f64| d.is_finite() && *d > 0.0);
    distance.ok_or_else(|| "it must be a finite number greater than 0".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_definition_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn attachments_have_one_name() {
        for attachments in Attachments::value_variants() {
            let value = attachments.to_possible_value().unwrap();
            assert_eq!(value.get_name(), attachments.name());
        }
    }

    #[test]
    fn sizes_stay_within_the_target_limit() {
        assert_eq!(size("1280x720"), Ok((1280, 720)));
        for wrong in ["", "x", "0x4", "4x0", "16385x1", "-1x4", "4", "4x4x4", "4.0x4"] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn numbers_must_be_finite_and_as_many_as_needed() {
        assert_eq!(point("1, 2.5 ,-3"), Ok(DVec3::new(1.0, 2.5, -3.0)));
        for wrong in ["1,2", "1,2,3,4", "1,2,nan", "1,2,inf", "a,b,c", ""] {
            assert!(point(wrong).is_err(), "{wrong}");
        }
        assert!(matrix("1 0 0 0, 0 1 0 0, 0 0 1 0, 0 0 0 1").is_ok());
        assert!(matrix("1 0 0 0").is_err());
        assert!(field_of_view("180").is_err() && field_of_view("60").is_ok());
        assert!(distance("0").is_err() && distance("-1").is_err() && distance("0.5").is_ok());
    }
}
