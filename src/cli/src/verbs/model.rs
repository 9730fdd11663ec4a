//! Model files that the command line names.

use dashpot_identification::model_file::{self, ModelFile, ModelFileError};
use std::path::Path;

/// Reads a model file, and says what does nothing in it.
pub fn read(path: &Path) -> Result<ModelFile, ModelFileError> {
    let file = model_file::read(path)?;
    // Beside the result, which may go to standard output.
    file.idle().iter().for_each(|note| dashpot_output::warn(&format!("note: {}: {note}", path.display())));
    Ok(file)
}
