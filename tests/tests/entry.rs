//! The same picture from every entry point.

use halfplane::{D16, D32, DepthFormat, Format, Small, Standard};
use halfplane_tests::{
    properties::entry,
    run::check,
    sizes,
    strategies::{numbers, scene, shot},
    toy::Toy,
};

fn entries<F: Format, D: DepthFormat<F>>() {
    check(sizes::ENTRY, (scene::<F>(32, 30), numbers::<7>()), |((_, shots), numbers)| {
        let [w, h, x, y, right, bottom, cut] = numbers;
        let size = [16 << (w % 3), 16 << (h % 3)];
        let (x0, y0) = (x % size[0], y % size[1]);
        let scissor = [x0, y0, x0 + 1 + right % (size[0] - x0), y0 + 1 + bottom % (size[1] - y0)];
        let scissor = if cut % 2 == 0 { [0, 0, size[0], size[1]] } else { scissor };
        let triangles =
            shots.iter().map(|shot| (shot.corners, shot.z.map(|z| (z >> 8) as f32 / (1 << 24) as f32)));
        entry::all_draw_the_same::<F, D>(&entry::Scene::new::<F>(
            triangles.collect(),
            size,
            scissor,
            cut as usize / 2,
        ))
    });
}

#[test]
fn every_entry_point_draws_the_same_standard_d32() {
    entries::<Standard, D32>();
}

#[test]
fn every_entry_point_draws_the_same_standard_d16() {
    entries::<Standard, D16>();
}

#[test]
fn every_entry_point_draws_the_same_small_d16() {
    entries::<Small, D16>();
}

#[test]
fn every_entry_point_draws_the_same_toy_d16() {
    entries::<Toy, D16>();
}

#[test]
fn careless_attachments_cover_nothing_more() {
    check(sizes::ENTRY, shot::<Standard>(), |shot| {
        entry::careless_attachments_cover_nothing_more::<Standard>(&shot.frame, &shot.corners)
    });
}
