//! Made-up triangles of one kind each, given in pixels: object space is clip space with w = 1.

use std::sync::Arc;

use halfplane_cli::mesh::Mesh;

use super::View;

/// Clip space as it is.
const IDENTITY: [f32; 16] = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

/// The size of the micro views.
pub const SIZE: (u32, u32) = (1280, 720);

/// A view that is made when it is wanted.
pub struct Later {
    /// The name that the view will have.
    pub name: String,
    /// Makes it.
    pub make: Box<dyn Fn(&str) -> View>,
}

/// All micro views of `compare`. Where so many triangles would take the other crates minutes,
/// they have a smaller number on a view of its own.
#[must_use]
pub fn views() -> Vec<Later> {
    fn later(name: String, make: impl Fn(&str) -> View + 'static) -> Later {
        Later { name, make: Box::new(make) }
    }
    let of_size = |side: u32, count: u32, peers: bool| {
        let make = move |name: &str| View { peers, ..random(name, count, side as f32, SIZE) };
        later(format!("micro random {side} px, {count}"), make)
    };
    let slivers = |count: u32, peers: bool| {
        let make = move |name: &str| View { peers, ..slivers(name, count, SIZE) };
        later(format!("micro slivers, {count}"), make)
    };
    let screens = |order: &str, front_to_back: bool, count: u32, peers: bool| {
        let make = move |name: &str| View { peers, ..fullscreen(name, count, front_to_back, SIZE) };
        later(format!("micro fullscreen {order}, {count}"), make)
    };
    vec![
        of_size(2, 1_000_000, true),
        of_size(8, 1_000_000, true),
        of_size(32, 1_000_000, false),
        of_size(128, 1_000_000, false),
        of_size(32, 50_000, true),
        of_size(128, 2_000, true),
        slivers(50_000, false),
        slivers(1_000, true),
        screens("front-to-back", true, 1000, false),
        screens("back-to-front", false, 1000, false),
        screens("front-to-back", true, 20, true),
        screens("back-to-front", false, 20, true),
    ]
}

/// Triangles whose corners lie anywhere in squares of `side` pixels that lie anywhere in the target,
/// with at least an eighth of the square's area (a quarter on average), and any depths.
#[must_use]
pub fn random(name: &str, count: u32, side: f32, size: (u32, u32)) -> View {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let mut pixels = Pixels::new(size);
    let (width, height) = pixels.size;
    while pixels.triangles() < count {
        let (x, y) = (random.below(width - side), random.below(height - side));
        let corners = [0, 1, 2].map(|_| [x + random.below(side), y + random.below(side)]);
        if area(corners).abs() >= side * side / 8.0 {
            let depths = [0, 1, 2].map(|_| random.below(1.0));
            pixels.push(corners, depths);
        }
    }
    pixels.view(name)
}

/// Triangles with two sides of `side` pixels and a right angle between, anywhere in the target, each nearer
/// than those before it.
#[must_use]
pub fn nearer(name: &str, count: u32, side: f32, size: (u32, u32)) -> View {
    let mut random = Random(0xA24B_AED4_963E_E407);
    let mut pixels = Pixels::new(size);
    let (width, height) = pixels.size;
    for layer in 0..count {
        let (x, y) = (random.below(width - side), random.below(height - side));
        let depth = (count - layer) as f32 / (count + 1) as f32;
        pixels.push([[x, y], [x + side, y], [x, y + side]], [depth; 3]);
    }
    pixels.view(name)
}

/// Triangles up to the target's diagonal long and a tenth of a pixel to 2 pixels thick.
#[must_use]
pub fn slivers(name: &str, count: u32, size: (u32, u32)) -> View {
    let mut random = Random(0xD1B5_4A32_D192_ED03);
    let mut pixels = Pixels::new(size);
    let (width, height) = pixels.size;
    while pixels.triangles() < count {
        let point = |random: &mut Random| [random.below(width), random.below(height)];
        let (a, b) = (point(&mut random), point(&mut random));
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = (dx * dx + dy * dy).sqrt();
        let thick = 0.1 + random.below(1.9);
        let c = [a[0] - dy / length * thick, a[1] + dx / length * thick];
        let inside = (0.0..=width).contains(&c[0]) && (0.0..=height).contains(&c[1]);
        if length > 16.0 && inside {
            let depths = [0, 1, 2].map(|_| random.below(1.0));
            pixels.push([a, b, c], depths);
        }
    }
    pixels.view(name)
}

/// Triangles that each cover the whole target, one exactly at each of `count` depths.
#[must_use]
pub fn fullscreen(name: &str, count: u32, front_to_back: bool, size: (u32, u32)) -> View {
    let mut pixels = Pixels::new(size);
    let (width, height) = pixels.size;
    for layer in 0..count {
        let place = if front_to_back { layer } else { count - 1 - layer };
        let depth = (place + 1) as f32 / (count + 2) as f32;
        pixels.push([[0.0, 0.0], [2.0 * width, 0.0], [0.0, 2.0 * height]], [depth; 3]);
    }
    pixels.view(name)
}

/// A little of everything, half of it facing away: for counting instructions.
#[must_use]
pub fn mixed() -> View {
    let parts = [
        random("", 4000, 3.0, SIZE),
        random("", 3000, 16.0, SIZE),
        random("", 400, 100.0, SIZE),
        slivers("", 100, SIZE),
        fullscreen("", 2, true, SIZE),
    ];
    let mut mesh = Mesh::plain(Vec::new(), Vec::new());
    for part in parts {
        let first = mesh.positions.len() as u32;
        mesh.positions.extend(&part.mesh.positions);
        for (place, &[a, b, c]) in part.mesh.indices.as_chunks::<3>().0.iter().enumerate() {
            let order = if place % 2 == 0 { [a, b, c] } else { [a, c, b] };
            mesh.indices.extend(order.map(|index| first + index));
        }
    }
    let mesh = Arc::new(mesh);
    View { name: "mixed".to_owned(), mesh, matrix: IDENTITY, size: SIZE, peers: false, detail: false }
}

/// Triangles in pixels.
struct Pixels {
    size: (f32, f32),
    target: (u32, u32),
    mesh: Mesh,
}

impl Pixels {
    fn new(target: (u32, u32)) -> Self {
        let mesh = Mesh::plain(Vec::new(), Vec::new());
        Self { size: (target.0 as f32, target.1 as f32), target, mesh }
    }

    fn triangles(&self) -> u32 {
        self.mesh.triangles() as u32
    }

    /// Adds a triangle, wound clockwise on the screen.
    fn push(&mut self, corners: [[f32; 2]; 3], depths: [f32; 3]) {
        let (width, height) = self.size;
        let first = self.mesh.positions.len() as u32;
        for ([x, y], z) in corners.into_iter().zip(depths) {
            self.mesh.positions.push([x / width * 2.0 - 1.0, 1.0 - y / height * 2.0, z]);
        }
        let order = if area(corners) > 0.0 { [0, 1, 2] } else { [0, 2, 1] };
        self.mesh.indices.extend(order.map(|corner| first + corner));
    }

    fn view(self, name: &str) -> View {
        let Self { target: size, mesh, .. } = self;
        View {
            name: name.to_owned(),
            mesh: Arc::new(mesh),
            matrix: IDENTITY,
            size,
            peers: true,
            detail: false,
        }
    }
}

/// Twice the area of which a triangle is half, in pixels: positive where it is clockwise.
fn area([a, b, c]: [[f32; 2]; 3]) -> f32 {
    0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]))
}

/// Numbers without a pattern that matters (Vigna's xorshift64*), the same on every machine.
struct Random(u64);

impl Random {
    /// In `0.0..end`.
    fn below(&mut self, end: f32) -> f32 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let bits = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 40;
        bits as f32 / (1 << 24) as f32 * end
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ours::{self, Attachments, Level, drawn};

    #[test]
    fn every_triangle_faces_the_viewer_and_most_cover_something() {
        let size = (320, 200);
        for (view, least) in [
            (random("test", 300, 8.0, size), 0.99),
            (slivers("test", 300, size), 0.9),
            (fullscreen("test", 5, true, size), 1.0),
        ] {
            let mut target = ours::target(&view);
            let drawn = drawn(target.frame(Level::FALLBACK, Attachments::Coverage, &view.matrix));
            assert_eq!((drawn.culled.facing, drawn.culled.outside), (0, 0), "{}", view.name);
            assert!(f64::from(drawn.drawn) >= least * f64::from(drawn.submitted), "{drawn}");
        }
    }

    #[test]
    fn a_fullscreen_triangle_covers_the_target() {
        let view = fullscreen("test", 1, false, (64, 48));
        let mut target = ours::target(&view);
        drawn(target.frame(Level::FALLBACK, Attachments::Depth32, &view.matrix));
        assert_eq!(target.covered(Attachments::Depth32), 64 * 48);
    }
}
