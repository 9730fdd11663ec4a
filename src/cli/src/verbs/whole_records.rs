//! How far a model is off over whole records: the same figures in fit, validate and diagnose, so that they can be laid side by side.
//!
//! A fit and a diagnosis work on mean cycles, in which noise is averaged out, and a diagnosis refits first; their own figures are smaller
//! than those of `dashpot validate`, which takes every sample of every record from the settled start.

use dashpot_core::Params;
use dashpot_identification::model_file;
use dashpot_identification::validation::{Compared, Deviation, validate};
use dashpot_records::Record;
use dashpot_records::smoothing::smooth;
use dashpot_report::numbers::digits;
use dashpot_simulation::prediction::predict;
use rayon::prelude::*;

/// Mean figures of a model over records, as `dashpot validate` measures them.
pub fn deviation(params: &Params, records: &[&Record]) -> anyhow::Result<Deviation> {
    let model = model_file::prepared(params)?;
    let compared: Vec<Compared> = records
        .par_iter()
        .map(|record| {
            let forces = predict(&model, record, &smooth(record));
            Compared { record, fv_only: forces.clone(), model: forces, used_in_fit: true }
        })
        .collect();
    Ok(validate(&compared)?.overall.errors.model)
}

/// In words: "12.3 N mean (0.46 %)".
pub fn in_words(deviation: &Deviation) -> String {
    format!("{} N mean ({} %)", digits(deviation.mean_error_n, 3), digits(deviation.error_percent, 2))
}
