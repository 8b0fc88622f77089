//! The vector levels of this machine, by name.

pub use halfplane::simd::Level;

/// What `--level` takes for the best level there is.
const AUTO: &str = "auto";

/// The levels of this machine, the best first; the last is [`Level::FALLBACK`].
#[must_use]
pub fn available() -> Vec<Level> {
    Level::detect().and_below().collect()
}

/// Whether a level is plain arrays.
#[must_use]
pub fn is_fallback(level: Level) -> bool {
    level.name() == Level::FALLBACK.name()
}

/// The level of that name, if this machine has it; `auto` is the best.
///
/// # Errors
///
/// A sentence that names those there are.
pub fn parse(name: &str) -> Result<Level, String> {
    if name == AUTO {
        return Ok(Level::detect());
    }
    let levels = available();
    levels.iter().copied().find(|level| level.name() == name).ok_or_else(|| {
        let names: Vec<&str> = levels.iter().map(|level| level.name()).chain([AUTO]).collect();
        format!("no such level on this machine, which has {}", names.join(", "))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_found_by_their_names() {
        let names: Vec<_> = available().into_iter().map(Level::name).collect();
        assert_eq!(names.last(), Some(&"fallback"));
        for name in &names {
            assert_eq!(parse(name).map(Level::name), Ok(*name));
        }
        assert_eq!(parse("auto").map(Level::name), Ok(names[0]));
        for wrong in ["", "AVX2", "avx1024", "scalar"] {
            assert!(parse(wrong).is_err_and(|message| message.ends_with("fallback, auto")), "{wrong}");
        }
    }
}
