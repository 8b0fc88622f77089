//! Why a property does not hold.

use std::error::Error;
use std::fmt;

/// A property that does not hold, in words.
///
/// It is made from any error by `?`, and so is not an [`Error`] itself.
#[derive(Clone, PartialEq, Eq)]
pub struct Failure(pub String);

impl Failure {
    /// A failure with this message.
    pub fn new(message: impl fmt::Display) -> Self {
        Self(message.to_string())
    }
}

impl fmt::Debug for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl<E: Error> From<E> for Failure {
    fn from(error: E) -> Self {
        Self::new(error)
    }
}

/// What a property returns.
pub type Verdict = Result<(), Failure>;

/// Returns a [`Failure`] from the property unless the condition holds.
#[macro_export]
macro_rules! ensure {
    ($condition:expr, $($message:tt)+) => {
        if !$condition {
            return Err($crate::Failure(format!($($message)+)));
        }
    };
}

/// Returns a [`Failure`] with both values unless they are equal.
#[macro_export]
macro_rules! ensure_eq {
    ($left:expr, $right:expr, $($message:tt)+) => {
        match (&$left, &$right) {
            (left, right) => {
                if left != right {
                    return Err($crate::Failure(format!(
                        "{}: {left:?} is not {right:?}",
                        format_args!($($message)+)
                    )));
                }
            }
        }
    };
}
