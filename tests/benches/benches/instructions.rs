//! Counts the processor instructions of a thousand time steps, of a fit and of reading a campaign with callgrind. The
//! counts do not depend on other load on the machine. Run `cargo bench -p dashpot-benches --bench instructions`. The
//! benchmark needs valgrind, and iai-callgrind-runner in the version of `Cargo.toml`.
#![allow(missing_docs)]

use dashpot_benches::{Steps, files, fit, one_thread, read};
use dashpot_identification::{Family, Fit};
use dashpot_records::Campaign;
use iai_callgrind::{library_benchmark, library_benchmark_group, main};
use std::hint::black_box;
use tempfile::TempDir;

fn measured() -> Campaign {
    one_thread();
    read(&files())
}

fn written() -> TempDir {
    one_thread();
    files()
}

#[library_benchmark(setup = Steps::of)]
#[bench::default("default")]
#[bench::cheap("cheap")]
#[bench::gas_spring("gas_spring")]
#[bench::moving_mass("moving_mass")]
#[bench::aeration("aeration")]
fn thousand_steps(mut steps: Steps) -> f64 {
    black_box(steps.run())
}

#[library_benchmark]
#[bench::campaign(written())]
fn reading(files: TempDir) -> (Campaign, TempDir) {
    (black_box(read(&files)), files)
}

#[library_benchmark]
#[bench::model(measured(), Family::Thesis)]
#[bench::plain_curve(measured(), Family::Fv)]
fn fitting(campaign: Campaign, family: Family) -> Fit {
    black_box(fit(&campaign, family))
}

library_benchmark_group!(name = step; benchmarks = thousand_steps);
library_benchmark_group!(name = records; benchmarks = reading);
library_benchmark_group!(name = identification; benchmarks = fitting);
main!(library_benchmark_groups = step, records, identification);
