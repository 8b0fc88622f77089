//! What is made of a mesh once, before any frame: its meshlets.

use std::fmt;
use std::time::{Duration, Instant};

use halfplane::simd::{Meshlet, make_meshlets, max_meshlets};

use super::TargetError;

/// A mesh's meshlets, and what making them took.
#[derive(Debug, Clone)]
pub struct Prepared {
    meshlets: Vec<Meshlet>,
    time: Duration,
}

/// What a mesh's meshlets cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Preparation {
    /// How many there are.
    pub meshlets: usize,
    /// How long making them took, once, their memory included; in milliseconds.
    pub ms: f64,
    /// What they take.
    pub bytes: usize,
}

impl Prepared {
    /// Of triangles of three indices each into positions.
    ///
    /// # Errors
    ///
    /// [`TargetError::Meshlets`] for indices that are no good.
    pub fn new(positions: &[[f32; 3]], indices: &[u32]) -> Result<Self, TargetError> {
        let started = Instant::now();
        let mut meshlets = vec![Meshlet::EMPTY; max_meshlets(indices.len() / 3)];
        let made = make_meshlets(positions, indices, &mut meshlets)?.len();
        meshlets.truncate(made);
        meshlets.shrink_to_fit();
        Ok(Self { meshlets, time: started.elapsed() })
    }

    /// The meshlets.
    #[must_use]
    pub fn meshlets(&self) -> &[Meshlet] {
        &self.meshlets
    }

    /// What they cost.
    #[must_use]
    pub fn preparation(&self) -> Preparation {
        Preparation {
            meshlets: self.meshlets.len(),
            ms: self.time.as_secs_f64() * 1e3,
            bytes: size_of_val(self.meshlets()),
        }
    }
}

impl fmt::Display for Preparation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} meshlets of {} bytes, made once in {:.3} ms", self.meshlets, self.bytes, self.ms)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_prepared_is_told() {
        let positions = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let indices: Vec<u32> = (0..3).cycle().take(3 * 200).collect();
        let prepared = Prepared::new(&positions, &indices).unwrap();
        let Preparation { meshlets, ms, bytes } = prepared.preparation();
        // 200 triangles are more than one meshlet holds, and fewer than two.
        assert_eq!((meshlets, bytes), (2, 2 * size_of::<Meshlet>()));
        assert!(ms > 0.0);
        let text = prepared.preparation().to_string();
        assert!(text.starts_with(&format!("2 meshlets of {bytes} bytes, made once in ")), "{text}");
        assert_eq!(Prepared::new(&[], &[]).unwrap().preparation().meshlets, 0);
    }

    #[test]
    fn indices_that_do_not_exist_are_refused() {
        let error = Prepared::new(&[[0.0; 3]; 2], &[0, 1, 2]).unwrap_err();
        assert!(error.to_string().contains("index"), "{error}");
        assert!(matches!(Prepared::new(&[], &[0]), Err(TargetError::Meshlets(_))));
    }
}
