//! The choices that trade error for time, each with its errors found and its frames ready to be timed.

mod antialiasing;
mod depth;
mod format;
mod levels;
mod peers;
mod subpixel;
mod transform;

pub use antialiasing::{QUESTION as ANTIALIASING, antialiasing};
pub use depth::{QUESTION as DEPTH, depth};
pub use format::{QUESTION as FORMAT, SIZE as FORMAT_SIZE, format};
pub use levels::{QUESTION as LEVELS, levels};
pub use peers::{QUESTION as PEERS, peers};
pub use subpixel::{QUESTION as SUBPIXEL, subpixel};
pub use transform::{QUESTION as TRANSFORM, transform};

use crate::row::Question;

/// All questions, in the page's order.
pub const QUESTIONS: [Question; 7] = [SUBPIXEL, DEPTH, TRANSFORM, ANTIALIASING, LEVELS, FORMAT, PEERS];

/// What a frame of contenders returns where a first frame returned without an error: always the same.
fn repeated<T, E>(result: Result<T, E>) {
    // The first frame was checked; whatever refuses would have refused then.
    let _ = std::hint::black_box(result.is_ok());
}
