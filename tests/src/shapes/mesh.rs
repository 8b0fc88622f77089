//! Meshes with shared edges that fill a rectangle: each sample inside belongs to exactly one triangle.

use super::{Corners, doubled_area, numbers::Random};

/// Triangles that share vertices and fill a rectangle without overlap, all clockwise on the screen.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// Positions in steps.
    pub xy: Vec<[i32; 2]>,
    /// Three indices each.
    pub triangles: Vec<[u32; 3]>,
    /// `[x0, y0, x1, y1]` in steps: what the triangles fill.
    pub outline: [i32; 4],
}

impl Mesh {
    /// The corners of a triangle of the mesh.
    pub fn corners(&self, triangle: [u32; 3]) -> Corners {
        triangle.map(|index| self.xy[index as usize])
    }

    /// Each triangle with its corners begun anywhere and its winding turned at random, and the
    /// triangles in any order.
    pub fn shuffled(&self, random: &mut Random) -> Vec<[u32; 3]> {
        let mut triangles: Vec<_> = self
            .triangles
            .iter()
            .map(|triangle| super::ORDERS[random.below(6)].map(|corner| triangle[corner]))
            .collect();
        for last in (1..triangles.len()).rev() {
            triangles.swap(last, random.below(last + 1));
        }
        triangles
    }

    fn rectangle([x0, y0, x1, y1]: [i32; 4]) -> Self {
        Self {
            xy: vec![[x0, y0], [x1, y0], [x1, y1], [x0, y1]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            outline: [x0, y0, x1, y1],
        }
    }
}

/// A random triangulation of a rectangle with slivers of every size: points are put into the triangle,
/// or onto the edge, that has them, and that is cut there. Exact in integers.
pub fn triangulation(outline: [i32; 4], points: &[[i32; 2]]) -> Mesh {
    let mut mesh = Mesh::rectangle(outline);
    for &point in points {
        insert(&mut mesh, point);
    }
    mesh
}

fn insert(mesh: &mut Mesh, point: [i32; 2]) {
    let inside = |mesh: &Mesh, triangle: [u32; 3]| {
        let [a, b, c] = mesh.corners(triangle);
        let areas = [[b, c, point], [c, a, point], [a, b, point]].map(|corners| doubled_area(&corners));
        areas.iter().all(|&area| area >= 0).then_some(areas)
    };
    let found: Vec<(usize, [i64; 3])> = mesh
        .triangles
        .iter()
        .enumerate()
        .filter_map(|(place, &triangle)| Some((place, inside(mesh, triangle)?)))
        .collect();
    // At a vertex, or outside: nothing to do.
    if found.iter().any(|(_, areas)| areas.iter().filter(|&&area| area == 0).count() > 1) {
        return;
    }
    let new = mesh.xy.len() as u32;
    mesh.xy.push(point);
    for (place, areas) in found {
        let triangle = mesh.triangles[place];
        let mut pieces = (0..3).filter(|&k| areas[k] != 0).map(|k| {
            let mut piece = triangle;
            piece[k] = new;
            piece
        });
        if let Some(piece) = pieces.next() {
            mesh.triangles[place] = piece;
        }
        mesh.triangles.extend(pieces);
    }
}

/// A grid of `columns` x `rows` cells over a rectangle, inner vertices moved by up to a bit less than
/// half a cell, each cell cut along a diagonal that leaves both triangles clockwise.
///
/// A vertex that no cell round it can be cut with goes back to its place.
pub fn grid(outline: [i32; 4], columns: u32, rows: u32, random: &mut Random) -> Mesh {
    let [x0, y0, x1, y1] = outline.map(i64::from);
    let (columns, rows) = (i64::from(columns.max(1)), i64::from(rows.max(1)));
    let regular = |i: i64, j: i64| [x0 + (x1 - x0) * i / columns, y0 + (y1 - y0) * j / rows];
    let (reach_x, reach_y) = (((x1 - x0) / columns / 2 - 1).max(0), ((y1 - y0) / rows / 2 - 1).max(0));
    let mut mesh = Mesh { xy: Vec::new(), triangles: Vec::new(), outline };
    for j in 0..=rows {
        for i in 0..=columns {
            let [x, y] = regular(i, j);
            let dx = if i == 0 || i == columns { 0 } else { random.between(-reach_x, reach_x) };
            let dy = if j == 0 || j == rows { 0 } else { random.between(-reach_y, reach_y) };
            mesh.xy.push([(x + dx) as i32, (y + dy) as i32]);
        }
    }
    for j in 0..rows {
        for i in 0..columns {
            let at = |i: i64, j: i64| (j * (columns + 1) + i) as u32;
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            let cuts = [[[a, b, c], [a, c, d]], [[a, b, d], [b, c, d]]];
            let fits = |cut: &&[[u32; 3]; 2]| cut.iter().all(|&t| doubled_area(&mesh.corners(t)) >= 0);
            // A quadrilateral has a diagonal inside it; random first, so that both are met.
            let first = random.below(2);
            let cut = [cuts[first], cuts[1 - first]].iter().find(fits).copied().unwrap_or(cuts[0]);
            mesh.triangles.extend(cut);
        }
    }
    mesh
}

/// A fan round one vertex, anywhere inside a square of side `2 half` steps: `count` triangles, a multiple
/// of 4, to as many points on the square's outline; fewer where it has not so many.
pub fn fan(center: [i32; 2], half: i32, count: u32, random: &mut Random) -> Mesh {
    let half = i64::from(half.max(4));
    let count = i64::from(count.max(4));
    let [cx, cy] = center.map(i64::from);
    // The four corners, and distinct points between them.
    let between = count / 4 - 1;
    let slot = ((2 * half - 1) / between.max(1)).max(1);
    let mut places = Vec::new();
    for corner in (0..4).map(|side| side * 2 * half) {
        places.push(corner);
        let free = (0..between).map(|k| 1 + slot * k + random.between(0, slot - 1));
        places.extend(free.filter(|&place| place < 2 * half).map(|place| corner + place));
    }
    let on_outline = |place: i64| {
        let along = place % (2 * half) - half;
        match place / (2 * half) {
            0 => [along, -half],
            1 => [half, along],
            2 => [-along, half],
            _ => [-half, -along],
        }
    };
    let hub = [cx + random.between(1 - half, half - 1), cy + random.between(1 - half, half - 1)];
    let mut mesh = Mesh {
        xy: vec![hub.map(|v| v as i32)],
        triangles: Vec::new(),
        outline: [cx - half, cy - half, cx + half, cy + half].map(|v| v as i32),
    };
    mesh.xy.extend(places.iter().map(|&place| {
        let [x, y] = on_outline(place);
        [(cx + x) as i32, (cy + y) as i32]
    }));
    let ring = places.len() as u32;
    mesh.triangles.extend((0..ring).map(|k| [0, 1 + k, 1 + (k + 1) % ring]));
    mesh
}
