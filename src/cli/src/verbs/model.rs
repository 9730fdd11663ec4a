//! Reading of the model files that the command line names.

use dashpot_core::family::Axis;
use dashpot_identification::model_file::{self, ModelFile, ModelFileError};
use dashpot_messages::{Sentence, format_number};
use std::path::Path;

/// Reads a model file of an ordinary damper, and prints its notes.
pub fn read(path: &Path) -> Result<ModelFile, ModelFileError> {
    with_notes_printed(path, model_file::read(path)?)
}

/// Reads a model file of an ordinary or an adjustable damper, and prints its notes.
pub fn read_family(path: &Path) -> Result<ModelFile, ModelFileError> {
    with_notes_printed(path, model_file::read_family(path)?)
}

/// Reads a model file of an ordinary or an adjustable damper, and prints only its notes on numbers.
pub fn read_for_check(path: &Path) -> Result<ModelFile, ModelFileError> {
    let file = model_file::read_family(path)?;
    print_notes(path, file.remarks_on_numbers());
    Ok(file)
}

fn with_notes_printed(path: &Path, file: ModelFile) -> Result<ModelFile, ModelFileError> {
    print_notes(path, file.remarks());
    Ok(file)
}

/// Prints notes to standard error, because the result may go to standard output.
fn print_notes(path: &Path, notes: Vec<Sentence>) {
    notes.iter().for_each(|note| dashpot_output::warn(&format!("note: {}: {note}", path.display())));
}

/// Returns the name of the setting on which a damper depends, or "setting" if the model file does not name it.
pub fn setting_name(axis: &Axis) -> &str {
    if axis.name().is_empty() { "setting" } else { axis.name() }
}

/// Formats a value of the setting: `current = 0.8 A`.
pub fn setting_at(axis: &Axis, value: f64) -> String {
    format!("{} = {} {}", setting_name(axis), format_number(value), axis.unit()).trim_end().to_owned()
}
