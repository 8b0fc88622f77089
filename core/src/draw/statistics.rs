//! What became of every triangle.

use crate::geometry::{Assembly, Culled};
use core::{fmt, ops::AddAssign};

/// Triangles by what became of them: `drawn + culled.total() + rejected.total() == submitted`.
///
/// All counts saturate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Statistics {
    /// Triangles in the index lists.
    pub submitted: u32,
    /// Triangles that covered a sample, whether it passed a depth test or not.
    pub drawn: u32,
    /// Triangles that cover nothing, by cause.
    pub culled: CulledCounts,
    /// Triangles that cannot be drawn, by cause.
    pub rejected: RejectedCounts,
    /// Triangles that were clipped; each is counted above as well.
    pub clipped: u32,
}

/// Culled triangles by cause; see [`Culled`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CulledCounts {
    /// Facing the culled way.
    pub facing: u32,
    /// Without area after snapping.
    pub zero_area: u32,
    /// Between the samples.
    pub no_sample: u32,
    /// Outside scissor, viewport or frustum.
    pub outside: u32,
    /// In a box that is hidden behind what was drawn before; only where a draw asks, as `simd::draw_batches` does.
    pub hidden: u32,
}

/// Rejected triangles by cause.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct RejectedCounts {
    /// With a NaN or an infinity among their coordinates.
    pub non_finite: u32,
    /// With a vertex that [`Positions`](crate::Positions) counted but did not have; never with the
    /// crate's own.
    pub no_vertex: u32,
}

impl CulledCounts {
    /// The sum.
    #[must_use]
    pub const fn total(self) -> u32 {
        let uncovered = self.facing.saturating_add(self.zero_area).saturating_add(self.no_sample);
        uncovered.saturating_add(self.outside).saturating_add(self.hidden)
    }
}

impl RejectedCounts {
    /// The sum.
    #[must_use]
    pub const fn total(self) -> u32 {
        self.non_finite.saturating_add(self.no_vertex)
    }
}

impl Statistics {
    /// Counts one triangle: how it was assembled, and what became of its pieces.
    pub(crate) fn count(&mut self, assembly: Assembly, outcome: Option<Result<(), Culled>>) {
        if assembly == Assembly::Clipped {
            add(&mut self.clipped, 1);
        }
        add(
            match (assembly, outcome) {
                (_, Some(Ok(()))) => &mut self.drawn,
                (_, Some(Err(Culled::Facing))) => &mut self.culled.facing,
                (_, Some(Err(Culled::ZeroArea))) => &mut self.culled.zero_area,
                (_, Some(Err(Culled::NoSample))) => &mut self.culled.no_sample,
                (_, Some(Err(Culled::Outside))) | (Assembly::Outside, None) => &mut self.culled.outside,
                // Clipped to nothing that has an area.
                (Assembly::Whole | Assembly::Clipped, None) => &mut self.culled.zero_area,
                (Assembly::NonFinite, None) => &mut self.rejected.non_finite,
                (Assembly::NoVertex, None) => &mut self.rejected.no_vertex,
            },
            1,
        );
    }
}

/// Adds to a count, which saturates.
pub(crate) fn add(count: &mut u32, more: u32) {
    *count = count.saturating_add(more);
}

impl AddAssign for Statistics {
    fn add_assign(&mut self, more: Self) {
        self.include(more);
    }
}

impl Statistics {
    /// Adds those of other triangles.
    pub(crate) fn include(&mut self, more: Self) {
        add(&mut self.submitted, more.submitted);
        add(&mut self.drawn, more.drawn);
        add(&mut self.culled.facing, more.culled.facing);
        add(&mut self.culled.zero_area, more.culled.zero_area);
        add(&mut self.culled.no_sample, more.culled.no_sample);
        add(&mut self.culled.outside, more.culled.outside);
        add(&mut self.culled.hidden, more.culled.hidden);
        add(&mut self.rejected.non_finite, more.rejected.non_finite);
        add(&mut self.rejected.no_vertex, more.rejected.no_vertex);
        add(&mut self.clipped, more.clipped);
    }
}

impl fmt::Display for Statistics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { submitted, drawn, culled, rejected, clipped } = self;
        let CulledCounts { facing, zero_area, no_sample, outside, hidden } = culled;
        let RejectedCounts { non_finite, no_vertex } = rejected;
        writeln!(f, "submitted {submitted}, drawn {drawn} (clipped {clipped})")?;
        writeln!(
            f,
            "culled {}: facing {facing}, zero area {zero_area}, no sample {no_sample}, outside {outside}, \
             hidden {hidden}",
            culled.total()
        )?;
        write!(f, "rejected {}: non-finite {non_finite}, no vertex {no_vertex}", rejected.total())
    }
}
