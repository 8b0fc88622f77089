//! Survivors of culling on their way to set-up.

/// How many triangles are collected before they are drawn.
const CAPACITY: usize = 64;

/// Triangles in submitted order, with their ids; some are left to the scalar path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Queue {
    /// Corners; eight more places than are used, for reading eight at a time.
    corners: [[u32; 3]; CAPACITY + 8],
    ids: [u32; CAPACITY + 8],
    /// One bit for each triangle that is left to the scalar path.
    slow: u64,
    len: usize,
}

impl Queue {
    pub(super) const EMPTY: Self =
        Self { corners: [[0; 3]; CAPACITY + 8], ids: [0; CAPACITY + 8], slow: 0, len: 0 };

    #[inline(always)]
    pub(super) const fn clear(&mut self) {
        self.slow = 0;
        self.len = 0;
    }

    #[inline(always)]
    pub(super) const fn len(&self) -> usize {
        self.len
    }

    /// Whether eight more triangles fit.
    #[inline(always)]
    pub(super) const fn has_room(&self) -> bool {
        self.len + 8 <= CAPACITY
    }

    /// Adds a triangle; there is room.
    #[inline(always)]
    pub(super) fn push(&mut self, corners: [u32; 3], id: u32, slow: bool) {
        if let (Some(to), Some(to_id)) = (self.corners.get_mut(self.len), self.ids.get_mut(self.len)) {
            *to = corners;
            *to_id = id;
            self.slow |= u64::from(slow) << (self.len & 63);
            self.len += 1;
        }
    }

    /// The corners and ids of eight triangles from place `at` on, and how many of them are there and
    /// belong to the fast path.
    #[inline(always)]
    pub(super) fn run(&self, at: usize) -> (&[[u32; 3]; 8], &[u32; 8], usize) {
        let fast = (self.slow >> (at & 63)).trailing_zeros() as usize;
        let count = fast.min(8).min(self.len.saturating_sub(at));
        match (
            self.corners.get(at..).and_then(<[_]>::first_chunk),
            self.ids.get(at..).and_then(<[_]>::first_chunk),
        ) {
            (Some(corners), Some(ids)) => (corners, ids, count),
            _ => (&[[0; 3]; 8], &[0; 8], 0),
        }
    }

    /// The corners and id of the triangle at a place.
    #[inline(always)]
    pub(super) fn slow(&self, at: usize) -> ([u32; 3], u32) {
        match (self.corners.get(at), self.ids.get(at)) {
            (Some(&corners), Some(&id)) => (corners, id),
            _ => ([u32::MAX; 3], 0),
        }
    }
}
