//! The parts of a frame of the built-in scene. Each of `setup`, `traverse` and the draws holds the work
//! of those before it, so differences are what a part costs (see `halfplane_measure::target::Stage`); `frame` is everything.

use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use halfplane_benches::ours::{self, Attachments, MEASURED, Stage, Target, drawn};
use halfplane_benches::scenes::files;

fn stages(criterion: &mut Criterion) {
    let views = files::built_in();
    let view = &views[0];
    let mut target = ours::target(view);
    let mut stages = vec![
        ("clear depth".to_owned(), Stage::Clear(Attachments::Depth32)),
        ("transform".to_owned(), Stage::Transform),
        ("setup".to_owned(), Stage::Setup),
        ("traverse".to_owned(), Stage::Traverse),
    ];
    stages.extend(MEASURED.map(|a| (format!("draw {}", a.name()), Stage::Draw(a))));
    stages.push(("frame depth".to_owned(), Stage::Frame(Attachments::Depth32)));
    for level in ours::available() {
        let mut group = criterion.benchmark_group(format!("{} {}", view.name, level.name()));
        drawn(target.stage(level, Stage::Transform, &view.matrix));
        for (name, stage) in stages.iter().filter(|(_, stage)| Target::has(level, *stage)) {
            group.bench_function(name, |bencher| {
                bencher.iter(|| drawn(target.stage(level, *stage, &view.matrix)));
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
    targets = stages
}
criterion_main!(benches);
