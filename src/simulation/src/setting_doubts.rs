//! Records whose forces belong to another setting than the one that they state.

use crate::prediction::predict;
use crate::warm_starts::WarmStarts;
use dashpot_identification::family::{LABEL_DOUBT_RATIO, interpolated_between};
use dashpot_identification::model_file::{ModelFile, prepared};
use dashpot_identification::validation::{Compared, SettingDoubt};
use dashpot_records::Record;
use dashpot_records::smoothing::smooth;
use rayon::prelude::*;

/// Mean error of a test, relative to its largest force, up to which the setting of the test is not questioned.
///
/// At settings left out of the fits of the physical valve, the mean error is 0.7 to 2.2 % (`prove_semi_active 4 3040000`). The test
/// `a_validation_names_tests_whose_forces_are_those_of_another_setting` checks the limit.
const CLEAR: f64 = 0.05;
/// Largest number of tests that are examined. They are those with the largest errors. The number is small, because each test is simulated
/// at every candidate setting.
const EXAMINED: usize = 8;
/// Number of candidate settings in each interval of the grid. With 4, a setting differs from the nearest candidate by at most an eighth of
/// an interval.
const CANDIDATES: usize = 4;

/// Returns doubts about the settings of records whose forces another setting predicts clearly better. Examines the records with the largest
/// errors. `settings` contains the setting of each record, or `None` if the setting changes within it.
///
/// At a setting between two values of the grid, the model interpolates the force. A large error there may come from the interpolation and
/// not from a wrong setting, so such a test is not examined.
pub fn doubt_settings(file: &ModelFile, compared: &[Compared<'_>], settings: &[Option<f64>]) -> Vec<SettingDoubt> {
    let grid = file.axis.grid();
    let mut worst: Vec<(usize, f64, f64)> = compared
        .iter()
        .zip(settings)
        .enumerate()
        .filter_map(|(place, (of, setting))| {
            let error = mean_error(of.record, &of.model);
            let top = of.record.force.iter().fold(0.0f64, |top, force| top.max(force.abs()));
            setting
                .filter(|setting| error > CLEAR * top && interpolated_between(grid, *setting).is_none())
                .map(|setting| (place, setting, error))
        })
        .collect();
    if worst.is_empty() {
        return Vec::new();
    }
    worst.sort_by(|a, b| b.2.total_cmp(&a.2));
    worst.truncate(EXAMINED);
    worst.sort_by_key(|of| of.0);
    let mut candidates: Vec<f64> =
        grid.windows(2).flat_map(|pair| (0..CANDIDATES).map(|k| between(pair[0], pair[1], k))).collect();
    candidates.extend(grid.last());
    let records: Vec<&Record> = compared.iter().map(|of| of.record).collect();
    let warm = WarmStarts::new(&records);
    let examine = |(place, stated, error): (usize, f64, f64)| {
        let record = records[place];
        let motion = smooth(record);
        let at = |setting: &f64| {
            let params = file.definition().params_at(*setting);
            let forces = predict(&prepared(&params).ok()?, record, &motion, warm.rise(&params, place));
            Some((*setting, mean_error(record, &forces)))
        };
        let best = candidates.iter().filter_map(at).min_by(|a, b| a.1.total_cmp(&b.1));
        best.filter(|(_, other)| LABEL_DOUBT_RATIO * other < error).map(|(fitting, other)| SettingDoubt {
            test: record.name.clone(),
            stated,
            fitting,
            stated_error_n: error,
            fitting_error_n: other,
        })
    };
    worst.into_par_iter().filter_map(examine).collect()
}

/// Returns candidate `k` between two settings, with nine digits: 1.2 instead of 1.2000000000000002.
fn between(low: f64, high: f64, k: usize) -> f64 {
    if k == 0 {
        return low;
    }
    let setting = low + (high - low) * k as f64 / CANDIDATES as f64;
    format!("{setting:.8e}").parse().unwrap_or(setting)
}

fn mean_error(record: &Record, forces: &[f64]) -> f64 {
    let sum: f64 = record.force.iter().zip(forces).map(|(measured, force)| (measured - force).abs()).sum();
    sum / forces.len().max(1) as f64
}
