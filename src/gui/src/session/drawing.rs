//! The dimensions of the damper, and the physical quantities of gas, oil and valves that follow from dimensions and model.

use crate::session::Session;
use dashpot_core::Params;
use dashpot_dimensions::entry::{DESIGN, ENTRIES};
use dashpot_dimensions::{Dimensions, Explanation, explain, read};
use dashpot_messages::Sentence;
use dashpot_records::read_small_text;
use std::path::{Path, PathBuf};

/// An open file of dimensions.
pub struct Drawing {
    /// Path of the file.
    pub path: PathBuf,
    dimensions: Dimensions,
    /// The last explanation and the parameter values for which it was computed.
    explained: Option<(Params, Explanation)>,
}

impl Session {
    /// Opens a file of dimensions. Returns whether the file was readable.
    pub fn open_drawing(&mut self, path: &Path) -> bool {
        match read(path) {
            Ok(dimensions) => {
                self.drawing = Some(Drawing { path: path.to_owned(), dimensions, explained: None });
                self.is_drawing_new = true;
                self.say(path.display().to_string());
                true
            }
            Err(error) => {
                self.complain(Sentence::as_it_is(error));
                false
            }
        }
    }

    /// Explains the current model by the dimensions. Returns `None` without a model or without dimensions.
    pub fn explain(&mut self) -> Option<&Explanation> {
        let (drawing, model) = (self.drawing.as_mut()?, self.model.as_ref()?);
        let params = model.params();
        if drawing.explained.as_ref().is_none_or(|(known, _)| known != params) {
            drawing.explained = Some((*params, explain(&model.file(), &drawing.dimensions)));
        }
        drawing.explained.as_ref().map(|(_, explanation)| explanation)
    }

    /// Discards the explanation. Another model file has other intervals and notes, even if its values are equal.
    pub(super) fn forget_explanation(&mut self) {
        if let Some(drawing) = &mut self.drawing {
            drawing.explained = None;
        }
    }
}

/// Returns whether a file contains dimensions. Its name is `dimensions.toml`, or it has an entry of dimensions and is not a model.
pub fn is_drawing(path: &Path) -> bool {
    if path.file_name().is_some_and(|name| name == "dimensions.toml") {
        return true;
    }
    let Ok(text) = read_small_text(path) else { return false };
    let begins = |line: &str, key: &str| line.strip_prefix(key).is_some_and(|rest| rest.trim_start().starts_with('='));
    let is_model = text.lines().any(|line| begins(line.trim_start(), "format"));
    let keys = || ENTRIES.iter().map(|row| row.key).chain([DESIGN]);
    !is_model && text.lines().any(|line| keys().any(|key| begins(line.trim_start(), key)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawing_is_known_by_its_name_or_its_entries() {
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str, text: &str| {
            let path = folder.path().join(name);
            std::fs::write(&path, text).unwrap();
            is_drawing(&path)
        };
        assert!(file("dimensions.toml", "") && file("front.toml", "# front axle\nbore_mm = 36\n"));
        assert!(file("f.toml", "design=\"monotube\"\n"));
        assert!(!file("m.toml", "format = 1\nbore_mm = 3\n") && !file("n.toml", "gas_force = 80\n"));
        assert!(!is_drawing(&folder.path().join("absent.toml")));
    }
}
