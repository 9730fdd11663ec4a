//! Variables of a MAT file of version 7.3, which is an HDF5 file behind 512 bytes of MATLAB's own.
//!
//! | file | what |
//! |---|---|
//! | [`hdf5`] | blocks, objects and data sets of an HDF5 file, as far as MATLAB and h5py write them |
//! | this file | which data sets are variables |
//!
//! A reader of our own: a general one follows links and unpacks chunks without a bound, and a small file then costs gigabytes.

mod hdf5;

use super::Variable;
use crate::source::Budget;
use hdf5::File;

/// Variables that a file may have.
const MOST: usize = 4096;

/// Vectors and single numbers at the top of the file; structures, texts and matrices are skipped.
pub(super) fn variables(bytes: &[u8], budget: &Budget) -> Result<Vec<Variable>, String> {
    let file = File::open(bytes, budget)?;
    let objects = file.objects()?;
    if objects.len() > MOST {
        return Err(format!("it has more than {MOST} variables"));
    }
    let mut found = Vec::new();
    for (name, at) in objects {
        let Some(data) = file.data_set(at).map_err(|cause| format!("'{name}': {cause}"))? else { continue };
        let long = data.shape.iter().filter(|n| **n != 1).count();
        if long > 1 || data.shape.contains(&0) {
            continue;
        }
        let values = file.values(&data).map_err(|cause| format!("'{name}': {cause}"))?;
        let values = values.into_iter().map(|v| if v.is_finite() { v } else { f64::NAN }).collect();
        found.push(Variable { name, is_vector: long == 1, values });
    }
    Ok(found)
}
