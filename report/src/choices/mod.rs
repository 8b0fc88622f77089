//! The choices that trade error for time, each with its errors found and its frames ready to be timed.

mod ablation;
mod antialiasing;
mod configurations;
mod depth;
mod format;
mod levels;
mod peers;
mod subpixel;
mod transform;

pub use ablation::{QUESTION as ABLATION, ablation};
pub use antialiasing::{QUESTION as ANTIALIASING, antialiasing};
pub use configurations::{
    ALL as ALL_CONFIGURATIONS, Configuration, QUESTION as CONFIGURATIONS, configurations,
};
pub use depth::{QUESTION as DEPTH, depth};
pub use format::{QUESTION as FORMAT, SIZE as FORMAT_SIZE, format};
pub use levels::{QUESTION as LEVELS, levels};
pub use peers::{QUESTION as PEERS, peers};
pub use subpixel::{QUESTION as SUBPIXEL, subpixel};
pub use transform::{QUESTION as TRANSFORM, transform};

use crate::row::Question;

/// All questions, in the page's order.
pub const QUESTIONS: [Question; 9] =
    [CONFIGURATIONS, DEPTH, SUBPIXEL, TRANSFORM, ANTIALIASING, LEVELS, FORMAT, PEERS, ABLATION];

/// The configuration of that name.
#[must_use]
pub fn configuration(name: &str) -> Option<Configuration> {
    ALL_CONFIGURATIONS.into_iter().find(|configuration| configuration.name == name)
}

/// What a frame of contenders returns where a first frame returned without an error: always the same.
fn repeated<T, E>(result: Result<T, E>) {
    // The first frame was checked; whatever refuses would have refused then.
    let _ = std::hint::black_box(result.is_ok());
}
