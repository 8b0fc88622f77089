//! Every level of this machine draws the built-in scene the same, whole and by its stages.

mod common;

use common::{state, view};
use halfplane_cli::level::{self, Level};
use halfplane_cli::target::{Attachments, Prepared, Stage, Target};

const SIZE: (u32, u32) = (97, 55);

#[test]
fn every_level_draws_the_same() {
    let (mesh, matrix) = view(SIZE);
    let mirrored = std::array::from_fn(|k| if k % 4 == 0 { -matrix[k] } else { matrix[k] });
    let prepared = Prepared::new(&mesh.positions, &mesh.indices).unwrap();
    let mut target = Target::new(&mesh.positions, &mesh.indices, &state(SIZE)).unwrap();
    for attachments in Attachments::ALL {
        let picture = |target: &mut Target<'_>, level| {
            let statistics = target.frame(level, attachments, &matrix).unwrap();
            let rows = (target.depth_rows(attachments).unwrap(), target.id_rows(attachments).unwrap());
            (statistics, target.covered(attachments), target.fingerprint(attachments), rows)
        };
        let mut fresh = Target::new(&mesh.positions, &mesh.indices, &state(SIZE)).unwrap();
        let fallback = picture(&mut fresh, Level::FALLBACK);
        assert!(fallback.1 > 97 * 55 / 2 && fallback.0.drawn > 1000, "{attachments:?}");
        let (depths, ids) = &fallback.3;
        assert_eq!(depths.is_empty(), !(attachments.has_depth32() || attachments.has_depth16()));
        assert_eq!(ids.is_empty(), !attachments.has_ids());
        let ways = [None, Some(prepared.meshlets())];
        for (level, way) in level::available().into_iter().flat_map(|l| ways.map(|way| (l, way))) {
            target.set_meshlets(way);
            // The second frame must not see the first.
            target.frame(level, attachments, &mirrored).unwrap();
            target.stage(level, Stage::Transform, &matrix).unwrap();
            let how = (attachments, level.name(), way.map(<[_]>::len));
            assert!(picture(&mut target, level) == fallback, "{how:?}");
        }
    }
}

#[test]
fn a_frame_is_its_stages() {
    let (mesh, matrix) = view(SIZE);
    let mut target = Target::new(&mesh.positions, &mesh.indices, &state(SIZE)).unwrap();
    let attachments = Attachments::DepthIds32;
    let prepared = Prepared::new(&mesh.positions, &mesh.indices).unwrap();
    let ways = [None, Some(prepared.meshlets())];
    for (level, way) in level::available().into_iter().flat_map(|l| ways.map(|way| (l, way))) {
        target.set_meshlets(way);
        target.frame(level, attachments, &matrix).unwrap();
        let whole = target.fingerprint(attachments);
        target.stage(level, Stage::Clear(attachments), &matrix).unwrap();
        assert_ne!(target.fingerprint(attachments), whole);
        for stage in [Stage::Transform, Stage::Setup, Stage::Traverse, Stage::Draw(attachments)] {
            target.stage(level, stage, &matrix).unwrap();
        }
        assert_eq!(target.fingerprint(attachments), whole, "{}", level.name());
    }
}
