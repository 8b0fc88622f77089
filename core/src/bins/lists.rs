//! The lists of the tiles: chunks of entries, from a caller's memory.

/// Entries in a chunk: with its links, a cache line.
pub(super) const ENTRIES: usize = 14;

/// No chunk.
const NONE: u32 = u32::MAX;

/// Memory for some of the triangles of one tile: 64 bytes.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct BinChunk {
    entries: [u32; ENTRIES],
    previous: u32,
    next: u32,
}

impl BinChunk {
    /// To fill arrays with.
    pub const EMPTY: Self = Self { entries: [0; ENTRIES], previous: NONE, next: NONE };
}

/// Memory for the beginning of one tile's list.
#[derive(Clone, Copy, Debug)]
pub struct BinTile {
    first: u32,
    last: u32,
    count: u32,
}

impl BinTile {
    /// To fill arrays with.
    pub const EMPTY: Self = Self { first: NONE, last: NONE, count: 0 };
}

/// Lists of numbers, one for each tile.
#[derive(Debug)]
pub(super) struct Lists<'m> {
    tiles: &'m mut [BinTile],
    chunks: &'m mut [BinChunk],
    /// Chunks in use: the first ones.
    used: usize,
}

impl<'m> Lists<'m> {
    /// Empty lists.
    pub(super) fn new(tiles: &'m mut [BinTile], chunks: &'m mut [BinChunk]) -> Self {
        // What a link names exists.
        let count = chunks.len().min(NONE as usize);
        let chunks = chunks.get_mut(..count).unwrap_or_default();
        let mut lists = Self { tiles, chunks, used: 0 };
        lists.clear();
        lists
    }

    /// Takes all entries away.
    pub(super) fn clear(&mut self) {
        self.tiles.fill(BinTile::EMPTY);
        self.used = 0;
    }

    /// Adds an entry at the end of a tile's list; `false`, and nothing is changed, where there is no such tile or no
    /// more memory.
    pub(super) fn push(&mut self, tile: usize, entry: u32) -> bool {
        let Some(list) = self.tiles.get_mut(tile) else { return false };
        let at = list.count as usize % ENTRIES;
        if at == 0 {
            let (Some(chunk), Ok(number)) = (self.chunks.get_mut(self.used), u32::try_from(self.used)) else {
                return false;
            };
            *chunk = BinChunk { previous: list.last, ..BinChunk::EMPTY };
            if let Some(last) = self.chunks.get_mut(list.last as usize) {
                last.next = number;
            } else {
                list.first = number;
            }
            list.last = number;
            self.used += 1;
        }
        if let Some(to) = self.chunks.get_mut(list.last as usize).and_then(|chunk| chunk.entries.get_mut(at))
        {
            *to = entry;
        }
        list.count += 1;
        true
    }

    /// Takes away what was added last: the entries that `gone` says, at the ends of all lists.
    pub(super) fn pop_while(&mut self, gone: impl Fn(u32) -> bool) {
        for list in &mut *self.tiles {
            while let Some(at) = list.count.checked_sub(1) {
                let Some(chunk) = self.chunks.get(list.last as usize) else { break };
                let place = at as usize % ENTRIES;
                if !chunk.entries.get(place).is_some_and(|&entry| gone(entry)) {
                    break;
                }
                list.count = at;
                if place == 0 {
                    // Chunks that are given back are the last ones that were taken.
                    self.used -= 1;
                    list.last = chunk.previous;
                }
            }
        }
    }

    /// A tile's entries, in the order in which they were added.
    pub(super) fn entries(&self, tile: usize) -> impl Iterator<Item = u32> {
        let list = self.tiles.get(tile).copied().unwrap_or(BinTile::EMPTY);
        let mut chunk = self.chunks.get(list.first as usize);
        (0..list.count as usize).map_while(move |at| {
            let place = at % ENTRIES;
            if place == 0 && at > 0 {
                chunk = chunk.and_then(|chunk| self.chunks.get(chunk.next as usize));
            }
            chunk.and_then(|chunk| chunk.entries.get(place)).copied()
        })
    }
}
