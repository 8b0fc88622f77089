//! The coverage that third-party rasterizers produced: no sample may differ.

use halfplane::{Coordinate, Format, Small, Standard};
use halfplane_tests::{
    Failure, Frame,
    golden::{Case, Golden, files, folder},
    properties::coverage,
    shapes::Corners,
};

/// The frame of a golden's target and one of its samples.
fn frame<F: Format>(golden: &Golden, sample: usize) -> Frame {
    let [width, height] = golden.size;
    let position = golden.samples[sample].map(|v| u32::from(v) >> (8 - F::SUBPIXEL_BITS));
    Frame { sample: position, ..Frame::whole::<F>(width, height) }
}

fn compare<F: Format>(golden: &Golden, case: &Case, corners: &Corners) -> Result<(), Failure> {
    for (sample, spans) in case.spans.iter().enumerate() {
        let frame = frame::<F>(golden, sample);
        let (_, drawn) = coverage::drawn::<F>(&frame, corners)?;
        let mut expected = vec![false; drawn.len()];
        for &(y, start, end) in spans {
            expected[frame.place((start, y))..=frame.place((end - 1, y))].fill(true);
        }
        if let Some((pixel, _)) = frame.pixels().zip(drawn.iter().zip(&expected)).find(|(_, (a, b))| a != b) {
            return Err(Failure(format!("sample {sample}: pixel {pixel:?} differs")));
        }
    }
    Ok(())
}

#[test]
fn coverage_equals_the_goldens() {
    let Some(folder) = folder() else {
        println!("skipped: the folder ../shared/goldens is not beside the repository");
        return;
    };
    let mut cases = 0;
    for path in files(&folder).unwrap() {
        let golden = Golden::read(&path).unwrap();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        for (number, case) in golden.cases.iter().enumerate() {
            let outcome = if name.starts_with("snap16") {
                snapped(case).and_then(|corners| compare::<Small>(&golden, case, &corners))
            } else {
                assert_eq!(golden.subpixel_bits, 8, "{name}: not in steps of the standard format");
                compare::<Standard>(&golden, case, &case.corners)
            };
            if let Err(failure) = outcome {
                panic!("{name}, case {number}, corners {:?}: {failure:?}", case.corners);
            }
            cases += 1;
        }
    }
    println!("{cases} golden cases");
    assert!(cases > 0, "there is no golden file in {}", folder.display());
}

/// Inputs with 16 fractional bits, snapped to 1/16 px; below 2^24 units, so that a float has them.
fn snapped(case: &Case) -> Result<Corners, Failure> {
    let mut corners = [[0; 2]; 3];
    for (to, &from) in corners.as_flattened_mut().iter_mut().zip(case.corners.as_flattened()) {
        if from.unsigned_abs() > 1 << 24 {
            return Err(Failure(format!("{from} units are no float")));
        }
        let snapped = Coordinate::<Small>::snap(from as f32 / 65_536.0);
        *to = snapped.ok_or_else(|| Failure::new("a finite coordinate is refused"))?.steps();
    }
    Ok(corners)
}

#[test]
fn truncated_goldens_are_refused() {
    let good = [b"TRIGOLD1".as_slice(), &[0; 32]].concat();
    assert!(Golden::parse(&good).is_ok());
    assert!(Golden::parse(&good[..39]).is_err());
    assert!(Golden::parse(&[good.as_slice(), &[0]].concat()).is_err());
    assert!(Golden::parse(&[b"TRIGOLD2".as_slice(), &[0; 32]].concat()).is_err());
}
