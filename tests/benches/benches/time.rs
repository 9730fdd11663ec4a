//! Measures the time of a thousand time steps of a damper, of a fit and of reading a campaign on this machine. Run
//! `cargo bench -p dashpot-benches --bench time`.

use dashpot_benches::{STEPS, Steps, files, fit, read};
use dashpot_identification::Family;
use divan::Bencher;
use divan::counter::ItemsCount;

fn main() {
    divan::main();
}

#[divan::bench(args = ["default", "cheap", "gas_spring", "moving_mass", "aeration"])]
fn thousand_steps(bencher: Bencher<'_, '_>, damper: &str) {
    let mut steps = Steps::of(damper);
    bencher.counter(ItemsCount::new(STEPS)).bench_local(|| steps.run());
}

#[divan::bench(sample_count = 20, sample_size = 1)]
fn reading(bencher: Bencher<'_, '_>) {
    let files = files();
    bencher.bench_local(|| read(&files));
}

#[divan::bench(sample_count = 5, sample_size = 1)]
fn fit_of_the_model(bencher: Bencher<'_, '_>) {
    let campaign = read(&files());
    bencher.bench_local(|| fit(&campaign, Family::Thesis));
}

#[divan::bench(sample_count = 20, sample_size = 1)]
fn fit_of_the_plain_curve(bencher: Bencher<'_, '_>) {
    let campaign = read(&files());
    bencher.bench_local(|| fit(&campaign, Family::Fv));
}
