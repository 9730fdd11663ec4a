//! Variables of a MAT file of version 7.3, which is an HDF5 file after a MATLAB header of 512 bytes.
//!
//! | file | content |
//! |---|---|
//! | [`hdf5`] | blocks, objects and data sets of an HDF5 file, in the forms that MATLAB and h5py write |
//! | this file | the selection of the data sets that are variables |
//!
//! A general HDF5 reader follows links and unpacks chunks without a limit, so a small file could require gigabytes.
//! This reader limits both.

mod hdf5;

use super::Variable;
use crate::source::Budget;
use hdf5::File;

/// Largest number of variables of a file.
const MOST: usize = 4096;

/// Returns vectors and single numbers at the top level of the file. Skips structures, texts and matrices.
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
