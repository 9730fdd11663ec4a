use dashpot_estimation::structure::{search::*, starts};
use dashpot_estimation::{heating::Heating, samples::{self, Thin}};
use dashpot_records as records;
use std::sync::Arc;
fn main() {
    let dir = std::env::args().nth(1).unwrap(); let dir = if dir.len() == 3 { format!("/tmp/ol/{dir}") } else { format!("/work/shared/data/reports/{dir}") };
    let options = records::Options::default();
    let c = records::load(&[dir.into()], &options, &|_| ()).unwrap();
    let r: Vec<_> = c.records.iter().collect();
    let t0 = std::time::Instant::now();
    let tests = samples::tests(&r);
    let heating = Arc::new(Heating::new(&r, &tests));
    let thin = Thin::new(&tests).tests;
    eprintln!("{} tests, {} samples, thin {}", tests.len(), tests.iter().map(|t| t.count()).sum::<usize>(), thin.iter().map(|t| t.segment.force.len()).sum::<usize>());
    let starts = starts::plain(&thin, &heating, &|_| true);
    let context = SearchContext { records: &r, tests: &thin, is_allowed: &|_, _| true, changes: &[], most: 9, progress: &|_| () };
    let s = StructureSearch::run(&context, starts).unwrap();
    println!("{:.1}s {:.1} ms {:.2} points {}", t0.elapsed().as_secs_f64(), s.best.log_posterior, s.best.evidence.mean(), curve_points(&s.best));
    for c in &s.best.components { println!("  {} {}", c.effect, c.form); }
    let mut m: Vec<_> = s.best.evidence.mean_squares.iter().zip(&thin).collect(); m.sort_by(|a,b| b.0.total_cmp(a.0)); for (q,t) in m.iter().take(6) { print!("{:.1}:{} A{:.1} v{:.2} top{:.0} unit{:.1} n{}; ", q, t.segment.name, 1e3*t.segment.amplitude, t.segment.peak_velocity, t.segment.top, t.unit(), t.count()); } println!();
    for t in [1.0, 2.0] { let mut p: Vec<_> = s.probabilities(t).into_iter().collect(); p.sort_by(|a,b| b.1.total_cmp(&a.1)); println!("{:?}", p.iter().take(14).map(|(a,b)| format!("{a} {b:.2}")).collect::<Vec<_>>()); }
}
