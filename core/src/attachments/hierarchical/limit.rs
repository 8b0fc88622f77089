//! The stored depths that hide something.

use super::range::DepthRange;
use crate::{
    attachments::{depth::Compare, depth_format::DepthFormat},
    lanes::Lanes,
    numbers::{DEPTH32_MAX, DEPTH32_MIN, Format, Word},
};

/// The depths that nothing from some depth on can pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::attachments) enum Limit {
    /// This one and all smaller.
    UpTo(u32),
    /// This one and all greater.
    From(u32),
}

impl Limit {
    /// Of what is nowhere nearer than `nearest`, a vertex's depth; `None` where no depth hides it.
    ///
    /// A sample's depth is less than two units before the nearest of its vertices
    /// ([`MAX_DEPTH_ERROR_2_16`](crate::Bounds::MAX_DEPTH_ERROR_2_16)), so at most one.
    #[inline(always)]
    pub(in crate::attachments) fn new<F: Format, D: DepthFormat<F>>(
        compare: Compare,
        nearest: u32,
    ) -> Option<Self> {
        // As vertices have it.
        let nearest = nearest.clamp(DEPTH32_MIN, DEPTH32_MAX);
        let depth = D::vertex(nearest) >> (F::Word::HALF_BITS - D::BITS);
        match compare {
            Compare::Less => depth.checked_sub(1).map(Self::UpTo),
            Compare::LessEqual => depth.checked_sub(2).map(Self::UpTo),
            Compare::Greater => depth.checked_add(1).map(Self::From),
            Compare::GreaterEqual => depth.checked_add(2).map(Self::From),
            Compare::Always => None,
        }
    }

    /// Whether every depth of a range hides it.
    #[inline(always)]
    pub(in crate::attachments) const fn hides(self, range: DepthRange) -> bool {
        match self {
            Self::UpTo(limit) => range.high <= limit,
            Self::From(limit) => range.low >= limit,
        }
    }

    /// The lanes whose depth does not hide it.
    #[inline(always)]
    pub(in crate::attachments) fn shows<L: Lanes>(self, token: L::Token, stored: L) -> u16 {
        L::bits(match self {
            Self::UpTo(limit) => L::splat(token, limit).less(stored),
            Self::From(limit) => stored.less(L::splat(token, limit)),
        })
    }
}
