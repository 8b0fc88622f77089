//! Index types.

mod sealed {
    pub trait Sealed {}
    impl Sealed for u8 {}
    impl Sealed for u16 {}
    impl Sealed for u32 {}
}

/// The type of a vertex index: `u8`, `u16` or `u32`.
pub trait Index: sealed::Sealed + Copy {
    /// The index of the first vertex.
    const ZERO: Self;

    /// The index as a `u32`.
    fn to_u32(self) -> u32;

    /// The index as a place in a slice; larger than any slice where it does not fit.
    #[inline]
    fn to_usize(self) -> usize {
        usize::try_from(self.to_u32()).unwrap_or(usize::MAX)
    }
}

impl Index for u8 {
    const ZERO: Self = 0;

    #[inline]
    fn to_u32(self) -> u32 {
        u32::from(self)
    }
}

impl Index for u16 {
    const ZERO: Self = 0;

    #[inline]
    fn to_u32(self) -> u32 {
        u32::from(self)
    }
}

impl Index for u32 {
    const ZERO: Self = 0;

    #[inline]
    fn to_u32(self) -> u32 {
        self
    }
}
