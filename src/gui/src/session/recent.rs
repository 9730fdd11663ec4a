//! Recently opened campaigns.

use std::path::{Path, PathBuf};

/// Largest number of stored campaigns, so that the menu stays short.
const KEPT: usize = 8;

/// The list of recently opened campaigns, and the file that stores the list.
pub struct Recent {
    file: Option<PathBuf>,
    /// Paths of the campaigns. The newest comes first.
    pub paths: Vec<PathBuf>,
}

impl Recent {
    /// Reads the list from a file. The list is empty if there is no file.
    pub fn read(file: Option<PathBuf>) -> Recent {
        let text = file.as_ref().and_then(|f| dashpot_records::read_small_text(f).ok()).unwrap_or_default();
        Recent { file, paths: text.lines().filter(|l| !l.is_empty()).map(PathBuf::from).take(KEPT).collect() }
    }

    /// Returns the path of the file in the user's configuration folder, or `None` if that folder is unknown.
    pub fn place() -> Option<PathBuf> {
        let var = |name: &str| std::env::var_os(name).filter(|v| !v.is_empty()).map(PathBuf::from);
        let folder = if cfg!(windows) {
            var("APPDATA")?
        } else {
            var("XDG_CONFIG_HOME").or_else(|| Some(var("HOME")?.join(".config")))?
        };
        Some(folder.join("dashpot").join("recent.txt"))
    }

    /// Puts a path at the beginning of the list, and writes the list. A failure to write is ignored.
    pub fn add(&mut self, path: &Path) {
        let Ok(path) = std::path::absolute(path) else { return };
        self.paths.retain(|p| *p != path);
        self.paths.insert(0, path);
        self.paths.truncate(KEPT);
        if let Some(file) = &self.file {
            let lines: String = self.paths.iter().map(|p| format!("{}\n", p.display())).collect();
            let _ = file.parent().map(std::fs::create_dir_all);
            let _ = std::fs::write(file, lines);
        }
    }
}
