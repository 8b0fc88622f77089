//! The vector levels.

/// A vector level that the processor has, or none: then plain arrays and scalar code draw the same.
#[derive(Clone, Copy, Debug)]
pub struct Level(pub(super) Option<fearless_simd::Level>);

impl From<fearless_simd::Level> for Level {
    fn from(level: fearless_simd::Level) -> Self {
        Self(if level.is_fallback() { None } else { Some(level) })
    }
}

impl Level {
    /// Plain arrays.
    pub const FALLBACK: Self = Self(None);

    /// The best level that every processor of the compilation target has.
    #[must_use]
    pub fn baseline() -> Self {
        fearless_simd::Level::baseline().into()
    }

    /// The best level of the processor that this runs on.
    #[cfg(feature = "std")]
    #[must_use]
    pub fn detect() -> Self {
        fearless_simd::Level::new().into()
    }

    /// This level and all below it, best first; the last is [`FALLBACK`](Self::FALLBACK).
    pub fn and_below(self) -> impl Iterator<Item = Self> {
        below(self.0).into_iter().flatten().map(|level| Self(Some(level))).chain([Self::FALLBACK])
    }

    /// `avx512`, `avx2`, `sse4.2`, `sse2`, `neon`, `wasm128` or `fallback`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self.0 {
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Some(fearless_simd::Level::Avx512(_)) => "avx512",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Some(fearless_simd::Level::Avx2(_)) => "avx2",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Some(fearless_simd::Level::Sse4_2(_)) => "sse4.2",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Some(fearless_simd::Level::Sse2(_)) => "sse2",
            #[cfg(target_arch = "aarch64")]
            Some(fearless_simd::Level::Neon(_)) => "neon",
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            Some(fearless_simd::Level::WasmSimd128(_)) => "wasm128",
            _ => "fallback",
        }
    }
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn below(level: Option<fearless_simd::Level>) -> [Option<fearless_simd::Level>; 4] {
    let Some(level) = level else { return [None; 4] };
    [
        level.as_avx512().map(fearless_simd::Level::Avx512),
        level.as_avx2().map(fearless_simd::Level::Avx2),
        level.as_sse4_2().map(fearless_simd::Level::Sse4_2),
        level.as_sse2().map(fearless_simd::Level::Sse2),
    ]
}

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
fn below(level: Option<fearless_simd::Level>) -> [Option<fearless_simd::Level>; 1] {
    [level]
}
