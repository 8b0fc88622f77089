//! The commands `render` and `verify`, from the command line's options to files and a report.

use std::fmt::Write as _;
use std::io::{self, Write};
use std::path::Path;
use std::time::{Duration, Instant};

use halfplane::{Cull, Format as _, NO_ID, Region, Standard, Winding};
use indicatif::{ProgressBar, ProgressStyle};

use crate::args::Options;
use crate::camera::{self, CameraError, Hand, Matrix, Named};
use crate::error::Error;
use crate::load::{self, Format};
use crate::mesh::Mesh;
use crate::output::{OutputError, Outputs};
use crate::picture::{self, Look, Zoom};
use crate::render::{Picture, RenderError, Settings, render, to_clip};
use crate::scene;
use crate::target::Preparation;
use crate::verify;
use crate::way::Way;

/// Draws, writes the pictures, prints a report.
///
/// # Errors
///
/// [`Error`] for a mesh, camera or output that is no good.
pub fn run_render(file: Option<&Path>, options: &Options) -> Result<(), Error> {
    let mut drawn = draw(file, options)?;
    let Drawn { subject, matrix, picture, .. } = &drawn;
    let zoom = Zoom { width: picture.width, height: picture.height, times: options.zoom };
    let (width, height) = zoom.size();

    let started = Instant::now();
    let shaded = picture::shaded(&subject.mesh, matrix, picture, subject.look)?;
    let mut outputs = Outputs::new(&options.out);
    outputs.add("depth.png", picture::grey16(width, height, &zoom.enlarge(&picture::grey(picture))));
    outputs.add("ids.png", picture::rgb8(width, height, &zoom.enlarge(&picture::colours(&picture.ids))));
    outputs.add("shaded.png", picture::rgb8(width, height, &zoom.enlarge(&shaded)));
    if options.raw {
        outputs.add("depth.u32", little_endian(&picture.depth));
        outputs.add("ids.u32", little_endian(&picture.ids));
    }
    let pictures = started.elapsed();

    let started = Instant::now();
    let paths: Vec<String> = outputs.paths().map(|path| path.display().to_string()).collect();
    outputs.commit()?;
    drawn.times.extend([("pictures", pictures), ("write", started.elapsed())]);
    print(&format!("{}wrote {}\n", drawn.report(), paths.join(", ")))
}

/// Draws, compares with the reference, prints a report; writes a difference picture if there is one.
/// Returns whether every pixel is right.
///
/// # Errors
///
/// [`Error`] for a mesh, camera or output that is no good.
pub fn run_verify(file: Option<&Path>, options: &Options) -> Result<bool, Error> {
    let drawn = draw(file, options)?;
    print(&drawn.report())?;
    let Drawn { subject, matrix, settings, picture, .. } = &drawn;

    let started = Instant::now();
    let clip = &to_clip(&subject.mesh, matrix);
    let (scene, whole) = verify::assemble(clip, &subject.mesh.indices, settings);
    let bar = progress_bar(u64::from(picture.width) * u64::from(picture.height));
    let report = verify::compare(&scene, picture, &|pixels| bar.inc(pixels))?;
    bar.finish_and_clear();
    let pixels = started.elapsed();
    let started = Instant::now();
    let size = (picture.width, picture.height);
    let moved = verify::displacement(&subject.mesh, matrix, clip, &whole, size, Standard::SUBPIXEL_BITS);
    let vertices = started.elapsed();

    let mut text = String::new();
    let _ = writeln!(text, "mismatching pixels: {}", report.mismatches.pixels);
    let _ = writeln!(
        text,
        "depth error in units of 2^-{}: largest {:.6}, mean {:.6}",
        picture.bits, report.max_error, report.mean_error
    );
    let _ = writeln!(
        text,
        "snapped vertices off their exact places, in steps of 1/{} px: largest {:.6} from clip space, {:.6} from model space ({} vertices)",
        1 << Standard::SUBPIXEL_BITS,
        moved.from_clip,
        moved.from_model,
        moved.vertices
    );
    let _ = writeln!(text, "reference: {report}");
    let _ = writeln!(text, "verified in {} (pixels), {} (vertices)", seconds(pixels), seconds(vertices));
    if !report.identical() {
        let mut outputs = Outputs::new(&options.out);
        let difference = verify::difference(&scene, picture)?;
        outputs.add("diff.png", picture::rgb8(picture.width, picture.height, &difference));
        let path = options.out.join("diff.png");
        outputs.commit()?;
        let _ = writeln!(text, "wrote {}", path.display());
    }
    print(&text)?;
    Ok(report.identical())
}

/// A mesh, its conventions and its named cameras.
pub(crate) struct Subject {
    pub(crate) mesh: Mesh,
    pub(crate) name: String,
    cameras: Vec<Named>,
    /// Where the cameras are, for messages.
    place: String,
    hand: Hand,
    front: Winding,
    cull: Cull,
    look: Look,
}

impl Subject {
    fn built_in() -> Self {
        Self {
            mesh: scene::evening(),
            name: scene::NAME.to_owned(),
            cameras: scene::cameras(),
            place: scene::NAME.to_owned(),
            hand: Hand::Left,
            front: Winding::Clockwise,
            cull: Cull::Back,
            look: Look::Evening,
        }
    }

    /// `named`: whether a camera is asked for by name.
    fn load(path: &Path, named: bool) -> Result<Self, Error> {
        let (mesh, format) = load::load(path)?;
        let cameras = match (named, format) {
            (false, _) => Vec::new(),
            (true, Format::Scn1) => camera::beside(path)?,
            (true, _) => return Err(CameraError::NoNames.into()),
        };
        let (hand, front, cull) = match format {
            Format::Scn1 => (Hand::Left, Winding::Clockwise, Cull::Back),
            Format::Obj | Format::Gltf => (Hand::Right, Winding::CounterClockwise, Cull::None),
        };
        let place = camera::file_of(path).display().to_string();
        let name = path.display().to_string();
        Ok(Self { mesh, name, cameras, place, hand, front, cull, look: Look::Studio })
    }
}

/// A drawn picture and all it was drawn from.
struct Drawn {
    subject: Subject,
    matrix: Matrix,
    settings: Settings,
    picture: Picture,
    preparation: Option<Preparation>,
    times: Vec<(&'static str, Duration)>,
}

fn draw(file: Option<&Path>, options: &Options) -> Result<Drawn, Error> {
    let mut times = Vec::new();
    let mut started = Instant::now();
    let mut lap = |name| {
        times.push((name, started.elapsed()));
        started = Instant::now();
    };
    let (subject, matrix, settings) = prepare(file, options, &mut lap)?;
    let way = Way::of(&subject.mesh, options)?;
    let preparation = way.preparation();
    if preparation.is_some() {
        lap("meshlets");
    }
    let picture = render(&subject.mesh, &matrix, &settings, &way)?;
    lap("draw");
    Ok(Drawn { subject, matrix, settings, picture, preparation, times })
}

/// All that a draw needs; `lap` is told what has just been done.
pub(crate) fn prepare(
    file: Option<&Path>,
    options: &Options,
    lap: &mut dyn FnMut(&'static str),
) -> Result<(Subject, Matrix, Settings), Error> {
    let mut request = options.camera_request();
    let subject = match file {
        Some(path) => Subject::load(path, request.name.is_some())?,
        None => {
            if request.eye.is_none() && request.matrix.is_none() && request.name.is_none() {
                request.name = Some(scene::CAMERA.to_owned());
            }
            Subject::built_in()
        }
    };
    lap(if file.is_some() { "load" } else { "build" });
    let Subject { mesh, cameras, place, hand, .. } = &subject;
    let matrix = camera::choose(&request, cameras, place, mesh, *hand, options.size)?;
    let region = Region::of_size(options.size.0, options.size.1).map_err(RenderError::from)?;
    let settings = Settings {
        region,
        cull: options.cull.map_or(subject.cull, Cull::from),
        front: options.front.map_or(subject.front, Winding::from),
        depth: options.depth,
        level: options.level,
    };
    lap("camera");
    Ok((subject, matrix, settings))
}

impl Drawn {
    fn report(&self) -> String {
        let Self { subject, settings, picture, preparation, times, .. } = self;
        let preparation = preparation.map_or(String::new(), |preparation| format!("{preparation}\n"));
        let covered = picture.ids.iter().filter(|&&id| id != NO_ID).count();
        let times: Vec<String> =
            times.iter().map(|(name, time)| format!("{name} {}", seconds(*time))).collect();
        format!(
            "{}: {} triangles, {} vertices\n{}x{} pixels, {covered} covered, depth in {} bits, level {}\n{preparation}{}\n{}\n",
            subject.name,
            subject.mesh.triangles(),
            subject.mesh.positions.len(),
            picture.width,
            picture.height,
            picture.bits,
            settings.level.name(),
            picture.statistics,
            times.join(", ")
        )
    }
}

fn seconds(time: Duration) -> String {
    format!("{:.1} ms", time.as_secs_f64() * 1000.0)
}

fn little_endian(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

/// On standard error, and only where that is a terminal.
fn progress_bar(pixels: u64) -> ProgressBar {
    let bar = ProgressBar::new(pixels);
    let style = ProgressStyle::with_template("verifying {bar:40} {percent} % ({eta} left)");
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// Prints to standard output. A reader that has seen enough is no failure.
pub(crate) fn print(text: &str) -> Result<(), Error> {
    let mut output = io::stdout().lock();
    match output.write_all(text.as_bytes()).and_then(|()| output.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(OutputError::print(error).into()),
        _ => Ok(()),
    }
}
