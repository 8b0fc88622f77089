//! Reading requests: exact lengths, no trust in counts, nothing read beyond the request.

use std::io::{self, Read};

use halfplane::{Region, Standard, Vertex};

use super::{Problem, ProtocolError};

/// A request's input.
pub(super) struct Input<R> {
    reader: R,
    protocol: &'static str,
}

impl<R: Read> Input<R> {
    /// Checks the protocol's name.
    pub(super) fn open(reader: R, protocol: &'static str) -> Result<Self, ProtocolError> {
        let mut input = Self { reader, protocol };
        let mut magic = Vec::new();
        let length = protocol.len() as u64;
        let read = input.reader.by_ref().take(length).read_to_end(&mut magic);
        read.map_err(|error| input.error(Problem::Read(error)))?;
        if magic == protocol.as_bytes() { Ok(input) } else { Err(input.error(Problem::Magic)) }
    }

    pub(super) fn error(&self, problem: Problem) -> ProtocolError {
        ProtocolError { protocol: self.protocol, problem }
    }

    /// `count` 32-bit numbers. Memory grows with what arrives, not with what was promised.
    pub(super) fn words(&mut self, count: u64, part: &str) -> Result<Vec<u32>, ProtocolError> {
        let needed = count * 4;
        let mut bytes = Vec::new();
        let read = self.reader.by_ref().take(needed).read_to_end(&mut bytes);
        read.map_err(|error| self.error(Problem::Read(error)))?;
        let given = bytes.len() as u64;
        if given != needed {
            return Err(self.error(Problem::Truncated { part: part.to_owned(), given, needed }));
        }
        let word = |b: &[u8]| u32::from_le_bytes([b[0], b[1], b[2], b[3]]);
        Ok(bytes.chunks_exact(4).map(word).collect())
    }

    /// The target of a request.
    pub(super) fn region(&self, width: u32, height: u32) -> Result<Region<Standard>, ProtocolError> {
        Region::of_size(width, height).map_err(|_| self.error(Problem::Size { width, height }))
    }

    /// A vertex in units of 2^-`bits` px, snapped to the nearest 1/256 px with ties to even.
    pub(super) fn vertex(
        &self,
        (triangle, vertex): (usize, usize),
        [x, y]: [u32; 2],
        z: u32,
        bits: u32,
    ) -> Result<Vertex<Standard>, ProtocolError> {
        let steps = |word: u32| i32::try_from(snap(word as i32, bits)).ok();
        steps(x)
            .zip(steps(y))
            .and_then(|(x, y)| Vertex::new(x, y, z).ok())
            .ok_or_else(|| self.error(Problem::GuardBand { triangle, vertex }))
    }
}

/// Writing an answer failed.
pub(super) fn write_error(protocol: &'static str) -> impl Fn(io::Error) -> ProtocolError {
    move |error| ProtocolError { protocol, problem: Problem::Write(error) }
}

/// 2^-`bits` px, at most 16 bits, as 2^-8 px: exact up to 8 bits, else the nearest, ties to even.
fn snap(value: i32, bits: u32) -> i64 {
    let value = i64::from(value);
    let Some(extra) = bits.checked_sub(8).filter(|&extra| extra > 0) else {
        return value << (8 - bits);
    };
    let (down, half) = (value >> extra, 1 << (extra - 1));
    let rest = value - (down << extra);
    let up = rest > half || (rest == half && down & 1 == 1);
    down + i64::from(up)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coarse_coordinates_are_scaled_exactly_and_fine_ones_go_to_the_nearest_even() {
        assert_eq!([snap(3, 0), snap(-3, 4), snap(-3, 8)], [768, -48, -3]);
        // 1/512 px: halves.
        assert_eq!([-3, -2, -1, 0, 1, 2, 3, 5].map(|v| snap(v, 9)), [-2, -1, 0, 0, 0, 1, 2, 2]);
        assert_eq!([127, 128, 129, 384, -128, -129, -384].map(|v| snap(v, 16)), [0, 0, 1, 2, 0, -1, -2]);
        assert_eq!(snap(i32::MIN, 0), -(1 << 39));
    }
}
