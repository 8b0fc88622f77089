//! What a frame writes, by name.

/// What a frame writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Attachments {
    /// 32-bit depth.
    Depth32,
    /// 16-bit depth.
    Depth16,
    /// Triangle ids; the last one drawn wins.
    Ids,
    /// 32-bit depth and the id of the nearest triangle.
    DepthIds32,
    /// 16-bit depth and the id of the nearest triangle.
    DepthIds16,
    /// One bit per pixel.
    Coverage,
}

impl Attachments {
    /// All there are.
    pub const ALL: [Self; 6] =
        [Self::Depth32, Self::Depth16, Self::Ids, Self::DepthIds32, Self::DepthIds16, Self::Coverage];

    /// Its name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Depth32 => "depth",
            Self::Depth16 => "depth D16",
            Self::Ids => "ids",
            Self::DepthIds32 => "depth+ids",
            Self::DepthIds16 => "depth D16+ids",
            Self::Coverage => "coverage",
        }
    }

    /// Whether 32-bit depth is written.
    #[must_use]
    pub const fn has_depth32(self) -> bool {
        matches!(self, Self::Depth32 | Self::DepthIds32)
    }

    /// Whether 16-bit depth is written.
    #[must_use]
    pub const fn has_depth16(self) -> bool {
        matches!(self, Self::Depth16 | Self::DepthIds16)
    }

    /// Whether ids are written.
    #[must_use]
    pub const fn has_ids(self) -> bool {
        matches!(self, Self::Ids | Self::DepthIds32 | Self::DepthIds16)
    }

    /// Whether coverage is written.
    #[must_use]
    pub const fn has_coverage(self) -> bool {
        matches!(self, Self::Coverage)
    }
}
