//! Depth as greys: near is light, far is dark, nothing is black.
//!
//! Perspective crowds almost all depths together at the far end: 1 - depth falls with the inverse of
//! the distance. The grey is the fourth root of that, stretched from the farthest to the nearest
//! depth in the picture; it never turns round the order of two pixels.

use crate::render::Picture;

/// The darkest grey of something drawn; black is background.
const DARKEST: f64 = 3000.0;

/// One grey per pixel.
#[must_use]
pub fn grey(picture: &Picture) -> Vec<u16> {
    let far = picture.far();
    let drawn = || picture.depth.iter().copied().filter(|&depth| depth != far);
    let (Some(nearest), Some(farthest)) = (drawn().min(), drawn().max()) else {
        return vec![0; picture.depth.len()];
    };
    let curve = |depth: u32| (f64::from(far - depth) / f64::from(far)).sqrt().sqrt();
    let (light, dark) = (curve(nearest), curve(farthest));
    let range = if light > dark { light - dark } else { 1.0 };
    let grey = |depth: u32| {
        if depth == far {
            return 0;
        }
        let part = if light > dark { (curve(depth) - dark) / range } else { 1.0 };
        (DARKEST + part * (65535.0 - DARKEST) + 0.5) as u16
    };
    picture.depth.iter().map(|&depth| grey(depth)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfplane::Statistics;

    fn picture(depth: Vec<u32>) -> Picture {
        let ids = vec![0; depth.len()];
        let statistics = Statistics::default();
        Picture { width: depth.len() as u32, height: 1, bits: 32, depth, ids, ordered: true, statistics }
    }

    #[test]
    fn nearer_is_lighter_and_nothing_is_black() {
        let greys = grey(&picture(vec![u32::MAX, u32::MAX - 3, 1 << 31, 2]));
        assert_eq!(greys, [0, 3000, greys[2], 65535]);
        assert!(greys[1] < greys[2] && greys[2] < greys[3]);
        assert_eq!(grey(&picture(vec![7, 7])), [65535, 65535]);
        assert_eq!(grey(&picture(vec![u32::MAX])), [0]);
    }
}
