//! Choice of left-out tests, which show whether the model also improves on records that no refit has used.

use dashpot_records::Record;

/// One of this many tests is left out.
const ONE_IN: usize = 4;
/// Smallest number of tests in a campaign at which some are left out.
const FEWEST: usize = 8;

/// Marks the tests to leave out. In a campaign of fewer than eight tests, no test is left out.
///
/// The tests with the extremes of amplitude, speed, reached displacement and side force are never left out. An effect
/// could not be identified if its only test were left out. Of the other tests, every fourth is left out. These other
/// tests are ordered by side force, mean displacement, amplitude and speed, so that all values are represented. `seed`
/// selects the first left-out test.
pub fn choose(records: &[&Record], seed: u64) -> Vec<bool> {
    let n = records.len();
    let mut out = vec![false; n];
    if n < FEWEST {
        return out;
    }
    let side = |r: &Record| {
        r.side_force.as_ref().map_or(0.0, |c| c.iter().map(|f| f.abs()).sum::<f64>() / c.len().max(1) as f64)
    };
    let band = |x: f64| if x > 0.0 { (2.0 * libm::log2(x)).round() } else { -1000.0 };
    let key = |r: &Record| {
        [(side(r) / 100.0).round(), (r.mean_displacement / 0.01).round(), band(r.amplitude), r.peak_velocity]
    };
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|a, b| {
        let (ka, kb) = (key(records[*a]), key(records[*b]));
        ka.iter().zip(&kb).map(|(a, b)| a.total_cmp(b)).find(|o| o.is_ne()).unwrap_or(a.cmp(b))
    });
    let mut keep = vec![false; n];
    let mut extreme = |of: &dyn Fn(&Record) -> f64| {
        let by = |a: &usize, b: &usize| of(records[*a]).total_cmp(&of(records[*b]));
        if let (Some(low), Some(high)) = ((0..n).min_by(by), (0..n).max_by(by)) {
            keep[low] = true;
            keep[high] = true;
        }
    };
    extreme(&|r| r.amplitude);
    extreme(&|r| r.peak_velocity);
    extreme(&|r| r.mean_displacement + r.amplitude);
    extreme(&|r| r.mean_displacement - r.amplitude);
    extreme(&side);
    let offset = 1 + (seed as usize) % (ONE_IN - 1);
    let spare: Vec<usize> = order.into_iter().filter(|k| !keep[*k]).collect();
    for place in spare.iter().skip(offset).step_by(ONE_IN) {
        out[*place] = true;
    }
    out
}
