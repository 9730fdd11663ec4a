//! The cases of the benchmark.

use dashpot_rig::{EFFECTS, Plan, UNKNOWN_EFFECTS};
use dashpot_severity::case::Case;

/// A case with its block of the suite.
#[derive(Debug, Clone)]
pub struct Entry {
    /// Block to which the case belongs.
    pub block: &'static str,
    /// Case.
    pub case: Case,
}

/// Blocks of the suite.
pub const BLOCKS: [&str; 9] =
    ["single", "null_white", "null_coloured", "null_form", "unknown", "pair", "poor", "whole_fit", "null_whole_fit"];

/// Effects that a fit with all elements already contains.
const FITTED: [&str; 2] = ["stribeck_friction", "side_force_friction"];

/// Numbers of cases of each kind in a suite.
#[derive(Debug, Clone, Copy)]
pub struct Size {
    /// Number of seeds per effect and severity.
    pub seeds: u64,
    /// Severities of single effects.
    pub severities: &'static [f64],
    /// Number of cases of each kind without injected effects.
    pub nothing: u64,
    /// Number of seeds per unknown effect and severity.
    pub unknown: u64,
    /// Number of pairs of effects.
    pub pairs: u64,
    /// Number of cases with poor test plans, such as one amplitude or no slow tests.
    pub poor: u64,
    /// Severities of single effects for a fit with all elements, one seed each. The number of cases without effects is
    /// equal.
    pub whole_fit: &'static [f64],
}

impl Size {
    /// Suite of hundreds of cases.
    pub const FULL: Size = Size {
        seeds: 3,
        severities: &[0.5, 1.0, 2.0, 4.0],
        nothing: 60,
        unknown: 2,
        pairs: 60,
        poor: 40,
        whole_fit: &[1.0, 2.0, 4.0],
    };
    /// Suite of some ten minutes, for the results in the README.
    pub const MEDIUM: Size = Size {
        seeds: 1,
        severities: &[0.5, 1.0, 2.0, 4.0],
        nothing: 8,
        unknown: 1,
        pairs: 8,
        poor: 15,
        whole_fit: &[2.0],
    };
    /// Suite of a few minutes.
    pub const SHORT: Size =
        Size { seeds: 1, severities: &[1.5], nothing: 4, unknown: 1, pairs: 4, poor: 4, whole_fit: &[] };
}

/// Returns all cases of a size. Each case has a separate seed, and seeds count up from `first_seed + 1`.
pub fn suite(size: Size, first_seed: u64) -> Vec<Entry> {
    let mut seed = first_seed;
    let mut next = || {
        seed += 1;
        Case::nothing(seed)
    };
    let mut all = Vec::new();
    let mut add = |block: &'static str, case: Case| all.push(Entry { block, case });
    for effect in EFFECTS {
        for severity in size.severities {
            for _ in 0..size.seeds {
                add("single", next().hiding(effect, *severity));
            }
        }
    }
    for _ in 0..size.nothing {
        add("null_white", next());
        let mut coloured = next();
        coloured.options.noise_colour = 0.5 + 0.45 * ((coloured.options.seed % 10) as f64 / 9.0);
        coloured.options.hum_n = 2.0;
        coloured.options.bits = Some(14);
        add("null_coloured", coloured);
        add("null_form", Case { linear_curve: true, ..next() });
    }
    for effect in UNKNOWN_EFFECTS {
        for severity in [1.0, 3.0] {
            for _ in 0..size.unknown {
                add("unknown", next().hiding(effect, severity));
            }
        }
    }
    for k in 0..size.pairs {
        let n = EFFECTS.len() as u64;
        let (a, b) = ((7 * k + 3) % n, (11 * k + 3 + 1 + k / n) % n);
        if a != b {
            let [a, b] = [a, b].map(|i| EFFECTS[i as usize]);
            add("pair", next().hiding(a, 2.0).hiding(b, 2.0));
        }
    }
    let plans = [Plan::OneAmplitude, Plan::OneFrequency, Plan::NoSlowTests, Plan::Centred, Plan::NoSideForce];
    for k in 0..size.poor {
        let mut case = next().hiding(EFFECTS[(5 * k as usize + 2) % EFFECTS.len()], 2.0);
        case.plan = plans[k as usize % plans.len()];
        case.options.temperature_channel = k % 2 == 0;
        add("poor", case);
    }
    for severity in size.whole_fit {
        for effect in EFFECTS.iter().filter(|e| !FITTED.contains(e)) {
            add("whole_fit", Case { whole_fit: true, ..next().hiding(effect, *severity) });
            add("null_whole_fit", Case { whole_fit: true, ..next() });
        }
    }
    all
}
