//! Triangles into bins.

use super::{BinnedTriangle, Bins, MAX_TRIANGLES};
use crate::{
    attachments::OutsideAttachment,
    draw::{self, DrawError, Index, State, Statistics},
    geometry::{Assembly, Culled, Footprint, Overlap, Positions, Region, Uncertainty, Vertex},
    numbers::Format,
    traversal::TILE,
};
use core::sync::atomic::AtomicBool;

/// What was done with the first triangles of a list.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Added {
    /// How many triangles of the list were taken, from its beginning. Where it is less than there are, the bins are
    /// full for the next one: draw them and go on from there. Where they are empty, the next one does not fit by
    /// itself: draw it with [`draw`](crate::draw()).
    pub taken: usize,
    /// All that were taken are [submitted](Statistics::submitted), and those that are not in the bins are counted by
    /// what became of them; [`Bins::finish`] counts the others.
    pub statistics: Statistics,
}

impl<F: Format> Bins<'_, F> {
    /// Adds triangles behind those that wait, as long as there is room. Whatever was added is drawn in that order.
    ///
    /// All triangles that wait have one sample position: bins that wait with another one are full.
    ///
    /// # Errors
    ///
    /// [`DrawError`], before anything is added: as [`draw`](crate::draw()), the bins' region standing for an
    /// attachment's.
    pub fn add<P, I>(
        &mut self,
        positions: &P,
        indices: &[I],
        first_id: u32,
        state: &State<F>,
    ) -> Result<Added, DrawError>
    where
        P: Positions<F> + ?Sized,
        I: Index,
    {
        let triangles = draw::check_indices(indices, positions.count())?;
        let area = self.check(positions, triangles.len(), first_id, state)?;
        Ok(self.add_checked(positions, triangles, first_id, state, area))
    }

    /// The pixels that a draw may write, if nothing is wrong with it but, maybe, its indices.
    pub(super) fn check<P: Positions<F> + ?Sized>(
        &self,
        positions: &P,
        triangles: usize,
        first_id: u32,
        state: &State<F>,
    ) -> Result<Option<Region<F>>, DrawError> {
        let (_, area) = draw::check_draw(positions, triangles, first_id, state, &())?;
        if let Some(area) = area {
            OutsideAttachment::unless_contained(area, self.region)?;
        }
        Ok(area)
    }

    /// [`add`](Self::add) after the checks.
    pub(super) fn add_checked<P, I>(
        &mut self,
        positions: &P,
        triangles: &[[I; 3]],
        first_id: u32,
        state: &State<F>,
        area: Option<Region<F>>,
    ) -> Added
    where
        P: Positions<F> + ?Sized,
        I: Index,
    {
        let mut added = Added::default();
        if self.is_empty() {
            self.sample = state.sample;
        }
        if self.sample != state.sample {
            return added;
        }
        // As many ids as there are triangles were found to exist.
        let ids = first_id..first_id.saturating_add(triangles.len() as u32);
        for (id, corners) in ids.zip(triangles) {
            let before = self.count;
            let mut full = false;
            // Of the last piece.
            let mut culled = None;
            let assembly = positions.assemble(corners.map(Index::to_usize), |vertices| {
                let outcome = match area {
                    Some(area) if !full => draw::bounds(vertices, area, state).and_then(|bounds| {
                        full = !self.insert(vertices, bounds, id, self.count > before);
                        Err(Culled::NoSample)
                    }),
                    _ => Err::<(), _>(Culled::Outside),
                };
                culled = outcome.err();
            });
            if full {
                self.forget(before);
                break;
            }
            added.taken += 1;
            added.statistics.submitted += 1;
            let waits = self.triangles.get_mut(before..self.count).and_then(<[_]>::last_mut);
            match (waits, culled) {
                (Some(last), Some(culled)) => {
                    last.otherwise = culled;
                    added.statistics.clipped += u32::from(assembly == Assembly::Clipped);
                }
                (_, culled) => added.statistics.count(assembly, culled.map(Err)),
            }
        }
        added
    }

    /// Adds a window triangle to the tiles that it touches; `false`, and it is in some of them, where there is no
    /// room.
    fn insert(&mut self, vertices: [Vertex<F>; 3], bounds: Region<F>, id: u32, continued: bool) -> bool {
        let number = self.count;
        let (Some(to), Ok(entry)) = (self.triangles.get_mut(number), u32::try_from(number)) else {
            return false;
        };
        *to = BinnedTriangle {
            vertices,
            bounds: [bounds.x0(), bounds.y0(), bounds.x1(), bounds.y1()],
            id,
            continued,
            otherwise: Culled::NoSample,
            drawn: AtomicBool::new(false),
        };
        self.count += 1;
        let (left, right) = (bounds.x0() / TILE, (bounds.x1() - 1) / TILE);
        let (top, bottom) = (bounds.y0() / TILE, (bounds.y1() - 1) / TILE);
        if left == right && top == bottom {
            return self.lists.push(self.place(left, top), entry);
        }
        let footprint = Footprint::new(vertices, Uncertainty::None);
        for row in top..=bottom {
            for column in left..=right {
                let (x, y) = (TILE * column, TILE * row);
                let Some(tile) = bounds.cut(x, y, x + TILE, y + TILE) else { continue };
                let entry = match footprint.overlap(tile) {
                    Overlap::Outside => continue,
                    Overlap::Covers => entry | MAX_TRIANGLES as u32,
                    Overlap::Within | Overlap::Partial => entry,
                };
                if !self.lists.push(self.place(column, row), entry) {
                    return false;
                }
            }
        }
        true
    }

    /// Takes away all triangles from a number on.
    fn forget(&mut self, from: usize) {
        self.lists.pop_while(|entry| entry as usize & (MAX_TRIANGLES - 1) >= from);
        self.count = from;
    }
}
