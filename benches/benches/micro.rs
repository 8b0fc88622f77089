//! Made-up triangles of one kind each: time per triangle. Throughput is in triangles; the same views with
//! a million triangles are in `compare`.

use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use halfplane_benches::ours::{self, Attachments, drawn};
use halfplane_benches::scenes::{View, micro};

fn views() -> Vec<View> {
    let random =
        |side: u32, count: u32| micro::random(&format!("random {side} px"), count, side as f32, micro::SIZE);
    vec![
        random(2, 20_000),
        random(8, 20_000),
        random(32, 5_000),
        random(128, 500),
        micro::slivers("slivers", 1_000, micro::SIZE),
        micro::fullscreen("fullscreen front-to-back", 10, true, micro::SIZE),
        micro::fullscreen("fullscreen back-to-front", 10, false, micro::SIZE),
    ]
}

fn micros(criterion: &mut Criterion) {
    for level in ours::available() {
        let mut group = criterion.benchmark_group(format!("micro {}", level.name()));
        for view in views() {
            let mut target = ours::target(&view);
            group.throughput(Throughput::Elements(view.mesh.triangles() as u64));
            group.bench_function(&view.name, |bencher| {
                bencher.iter(|| drawn(target.frame(level, Attachments::Depth32, &view.matrix)));
            });
        }
        group.finish();
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(600));
    targets = micros
}
criterion_main!(benches);
