//! The process that is watched: it draws what it is told to and nothing else meanwhile.

use std::fs;
use std::io::{self, BufRead as _, Write as _};
use std::time::{Duration, Instant};

use crate::contest::MAIN;
use crate::ours::{self, Level, Stage, Target, drawn, is_fallback};
use crate::scenes::View;

/// The function whose calls callgrind dumps, as it names it.
pub const COUNTED: &str = "halfplane_benches::breakdown::child::counted";

/// One stage, counted by whoever watches this function.
#[inline(never)]
fn counted(target: &mut Target<'_>, level: Level, stage: Stage, view: &View) {
    drawn(target.stage(level, stage, &view.matrix));
}

/// What is counted apart at a level: the clear, the transform if the draw does not hold it, the draw.
#[must_use]
pub fn stages(level: Level) -> Vec<Stage> {
    let transform = is_fallback(level).then_some(Stage::Transform);
    [Some(Stage::Clear(MAIN)), transform, Some(Stage::Draw(MAIN))].into_iter().flatten().collect()
}

/// Draws every stage of every level once to warm up and once to be counted. Prints the levels.
///
/// # Errors
///
/// What the output says.
pub fn count(view: &View) -> io::Result<()> {
    let mut target = ours::target(view);
    for level in ours::available() {
        println!("{}", level.name());
        for stage in stages(level) {
            drawn(target.stage(level, stage, &view.matrix));
        }
        for stage in stages(level) {
            counted(&mut target, level, stage, view);
        }
    }
    io::stdout().flush()
}

/// Prints where this program lies in memory, waits for a line, then draws for some seconds. Clears between
/// draws: a draw into finished buffers is another draw. They are of no stage that is looked for.
///
/// # Errors
///
/// What the input or output says.
pub fn draw_for(view: &View, level: Level, seconds: f64) -> io::Result<()> {
    let mut target = ours::target(view);
    drawn(target.frame(level, MAIN, &view.matrix));
    println!("{:x}", place()?);
    io::stdout().flush()?;
    io::stdin().lock().read_line(&mut String::new())?;
    let started = Instant::now();
    while started.elapsed() < Duration::from_secs_f64(seconds) {
        drawn(target.frame(level, MAIN, &view.matrix));
    }
    Ok(())
}

/// The first address of this program in memory; its file's addresses count from there (0 where the system
/// does not tell).
fn place() -> io::Result<u64> {
    let program = std::env::current_exe()?;
    let Ok(maps) = fs::read_to_string("/proc/self/maps") else { return Ok(0) };
    let line = maps.lines().find(|line| line.ends_with(&*program.to_string_lossy()));
    let start = line.and_then(|line| line.split('-').next());
    Ok(start.and_then(|start| u64::from_str_radix(start, 16).ok()).unwrap_or(0))
}
