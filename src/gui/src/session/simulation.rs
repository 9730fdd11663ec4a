//! Simulation of the forces of the model for every test in the background. The newest request has priority.

use crate::session::Waker;
use crate::session::campaign::{Loaded, Seen};
use crate::session::dampers::Dampers;
use dashpot_records::Record;
use dashpot_records::smoothing::Motion;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard};
use std::time::{Duration, Instant};

/// Request for a simulation.
pub struct Wanted {
    /// The damper of each test.
    pub dampers: Dampers,
    /// The campaign whose tests are simulated.
    pub loaded: Arc<Loaded>,
    /// Whether one cycle of each test suffices, because a slider is moving.
    pub quick: bool,
}

/// Forces and errors of all tests.
pub struct Simulated {
    /// The damper of each test.
    pub dampers: Dampers,
    /// The campaign of the simulated tests.
    pub loaded: Arc<Loaded>,
    /// Forces and errors of each test.
    pub tests: Vec<OfTest>,
    /// Whether the simulation covers only one cycle of each test.
    pub quick: bool,
    /// Computing time.
    pub took: Duration,
}

/// Forces and errors of a test.
#[derive(Debug, Clone)]
pub struct OfTest {
    /// Forces over the shown cycle, N.
    pub shown: Vec<f64>,
    /// Decimation factor: `shown` has every `stride`-th sample.
    pub stride: usize,
    /// Mean of |computed − measured|, N.
    pub mean_error: f64,
    /// Mean error in percent of the largest measured force.
    pub percent: f64,
    /// Root mean square of computed − measured, N.
    pub rmse: f64,
}

impl OfTest {
    /// Compares forces with a record. `shown` is the range of the shown cycle in the record.
    fn new(forces: &[f64], record: &Record, shown: std::ops::Range<usize>, stride: usize, max_force: f64) -> OfTest {
        let n = record.force.len().min(forces.len()).max(1) as f64;
        let errors = || forces.iter().zip(&record.force).map(|(f, m)| f - m);
        let mean_error = errors().map(f64::abs).sum::<f64>() / n;
        OfTest {
            shown: forces.get(shown).map(<[f64]>::to_vec).unwrap_or_default(),
            stride,
            mean_error,
            percent: 100.0 * mean_error / max_force.max(1e-9),
            rmse: (errors().map(|e| e * e).sum::<f64>() / n).sqrt(),
        }
    }

    /// Simulates a whole test, or only its shown cycle if `quick` is set. `predict` computes the forces along a record.
    pub fn simulate(
        predict: impl Fn(&Record, &Motion) -> Vec<f64>,
        record: &Record,
        seen: &Seen,
        quick: bool,
    ) -> OfTest {
        if quick {
            let forces = predict(&seen.cycle, &seen.cycle_motion);
            OfTest::new(&forces, &seen.cycle, 0..seen.cycle_samples, seen.stride, seen.max_force)
        } else {
            OfTest::new(&predict(record, &seen.motion), record, seen.shown.clone(), 1, seen.max_force)
        }
    }
}

struct Desk {
    wanted: Option<(u64, Wanted)>,
    done: Option<Simulated>,
    closed: bool,
}

struct Shared {
    desk: Mutex<Desk>,
    news: Condvar,
    /// Serial number of the newest request.
    newest: AtomicU64,
    /// 1 while the thread is computing, otherwise 0.
    busy: AtomicU64,
}

impl Shared {
    fn desk(&self) -> MutexGuard<'_, Desk> {
        self.desk.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

/// A thread that computes the newest request.
pub struct Simulator {
    shared: Arc<Shared>,
}

impl Simulator {
    /// Starts the thread, which calls `waker` after each result.
    pub fn new(waker: Waker) -> Simulator {
        let shared = Arc::new(Shared {
            desk: Mutex::new(Desk { wanted: None, done: None, closed: false }),
            news: Condvar::new(),
            newest: AtomicU64::new(0),
            busy: AtomicU64::new(0),
        });
        let own = shared.clone();
        let _ = std::thread::Builder::new().name("simulator".into()).spawn(move || work(&own, &waker));
        Simulator { shared }
    }

    /// Requests a simulation. The request replaces a waiting one and aborts a running full simulation.
    pub fn order(&self, wanted: Wanted) {
        let number = 1 + self.shared.newest.fetch_add(1, Ordering::Relaxed);
        self.shared.desk().wanted = Some((number, wanted));
        self.shared.news.notify_one();
    }

    /// Returns the newest result, only once.
    pub fn take(&self) -> Option<Simulated> {
        self.shared.desk().done.take()
    }

    /// Returns whether a request is waiting or running, or its result is not collected yet.
    pub fn is_busy(&self) -> bool {
        let desk = self.shared.desk();
        desk.wanted.is_some() || desk.done.is_some() || self.shared.busy.load(Ordering::Relaxed) > 0
    }
}

impl Drop for Simulator {
    fn drop(&mut self) {
        self.shared.desk().closed = true;
        self.shared.news.notify_one();
    }
}

fn work(shared: &Shared, waker: &Waker) {
    loop {
        let (number, wanted) = {
            let mut desk = shared.desk();
            loop {
                if desk.closed {
                    return;
                }
                if let Some(wanted) = desk.wanted.take() {
                    shared.busy.store(1, Ordering::Relaxed);
                    break wanted;
                }
                desk = shared.news.wait(desk).unwrap_or_else(std::sync::PoisonError::into_inner);
            }
        };
        // A quick simulation always completes, so that the plots follow the mouse. A full simulation is aborted if newer values arrive.
        let outdated = || !wanted.quick && shared.newest.load(Ordering::Relaxed) != number;
        let result = simulate(&wanted, &outdated);
        {
            let mut desk = shared.desk();
            if result.is_some() {
                desk.done = result;
            }
            shared.busy.store(0, Ordering::Relaxed);
        }
        waker();
    }
}

/// Simulates all tests. Returns `None` if the request becomes outdated or the values are not a valid model.
pub fn simulate(wanted: &Wanted, outdated: &(dyn Fn() -> bool + Sync)) -> Option<Simulated> {
    let began = Instant::now();
    let loaded = &wanted.loaded;
    let prepared = wanted.dampers.prepare(&loaded.campaign.records)?;
    let all = loaded.campaign.records.par_iter().zip(&loaded.tests).enumerate();
    let of_test = |(k, (record, seen)): (usize, (&Record, &Seen))| {
        let predict = |record: &Record, motion: &Motion| prepared.predict(loaded, k, record, motion);
        (!outdated()).then(|| OfTest::simulate(predict, record, seen, wanted.quick))
    };
    let tests: Option<Vec<OfTest>> = all.map(of_test).collect();
    Some(Simulated {
        dampers: wanted.dampers.clone(),
        loaded: wanted.loaded.clone(),
        tests: tests?,
        quick: wanted.quick,
        took: began.elapsed(),
    })
}
