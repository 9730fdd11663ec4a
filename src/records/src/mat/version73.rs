//! Variables of a MAT file of version 7.3, which is an HDF5 file behind 512 bytes of MATLAB's own.

use hdf5_pure::File;

use super::Variable;

/// Numbers that a file may hold, whatever its size: compressed constants take next to no room.
const NUMBERS: u64 = 4 << 20;
/// Variables that a file may have.
const MOST: usize = 4096;

/// Vectors and single numbers at the top of the file; structures and matrices are passed over.
pub(super) fn variables(bytes: Vec<u8>) -> Result<Vec<Variable>, String> {
    let wrong = |e: hdf5_pure::Error| e.to_string();
    let mut room = NUMBERS.max(bytes.len() as u64);
    let file = File::from_bytes(bytes).map_err(wrong)?;
    let root = file.root();
    let names = root.datasets().map_err(wrong)?;
    if names.len() > MOST {
        return Err(format!("it has more than {MOST} variables"));
    }
    let mut found = Vec::new();
    for name in names {
        let data = root.dataset(&name).map_err(wrong)?;
        let shape = data.shape().map_err(wrong)?;
        let is_vector = shape.iter().filter(|n| **n != 1).count() == 1;
        if !is_vector && !shape.iter().all(|n| *n == 1) {
            continue;
        }
        // A chunk is unpacked as a whole, however little of it the variable uses.
        let chunk = data.chunk_shape().map_err(wrong)?.unwrap_or_default();
        let size = |shape: &[u64]| shape.iter().fold(1_u64, |n, k| n.saturating_mul(*k));
        let needed = size(&shape).max(size(&chunk));
        room = room
            .checked_sub(needed)
            .ok_or_else(|| format!("'{name}' announces more numbers than the file can hold"))?;
        // Texts and the like are no channels.
        let Ok(values) = data.read_f64() else { continue };
        let values = values.into_iter().map(|v| if v.is_finite() { v } else { f64::NAN }).collect();
        found.push(Variable { name, is_vector, values });
    }
    Ok(found)
}
