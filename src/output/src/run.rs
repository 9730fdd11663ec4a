//! One piece of work among many of a process: what it reads and whether it may replace other files is its own matter. A command does one and says both
//! for the whole process; the Python package does many, beside each other.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

/// What is said of the work of this thread.
#[derive(Debug, Default, Clone)]
struct Run {
    force: bool,
    reads: Vec<PathBuf>,
}

thread_local! {
    static RUN: RefCell<Run> = RefCell::default();
}

/// Puts back what was said before, however the work ends.
struct Before(Option<Run>);

impl Drop for Before {
    fn drop(&mut self) {
        if let Some(before) = self.0.take() {
            RUN.set(before);
        }
    }
}

/// Does work that writes files in this thread.
///
/// With `force` they may replace anything, without it none of the files that it reads, as if these had been named to
/// the command.
pub fn as_a_run<'a, T>(force: bool, reads: impl IntoIterator<Item = &'a Path>, work: impl FnOnce() -> T) -> T {
    let reads = reads.into_iter().filter_map(|path| std::fs::canonicalize(path).ok()).collect();
    let _before = Before(Some(RUN.replace(Run { force, reads })));
    work()
}

/// Whether the work of this thread may replace anything.
pub fn is_forced() -> bool {
    RUN.with_borrow(|run| run.force)
}

/// What the work of this thread reads, links followed.
pub fn reads() -> Vec<PathBuf> {
    RUN.with_borrow(|run| run.reads.clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::write;

    #[test]
    fn what_one_run_may_do_another_may_not() {
        let folder = tempfile::tempdir().unwrap();
        let (read, other) = (folder.path().join("read.toml"), folder.path().join("other.csv"));
        let model = "format = 1\nelements = []\n";
        std::fs::write(&read, model).unwrap();
        std::fs::write(&other, "a,b\n1,2\n").unwrap();
        let refusal = as_a_run(false, [read.as_path()], || write(&read, model)).unwrap_err();
        assert!(crate::format_once(&refusal).contains("is read by this run"), "{refusal:?}");
        as_a_run(true, [read.as_path()], || {
            write(&read, model).unwrap();
            write(&other, model).unwrap();
            assert!(as_a_run(false, [], || write(&other, "a,b\n")).is_err(), "a run within another has its own leave");
            write(&other, model).unwrap();
        });
        write(&read, model).unwrap();
        assert!(write(&other, "a,b\n").is_err());
        let ended = std::panic::catch_unwind(|| as_a_run(true, [], || panic!("work that fails")));
        assert!(ended.is_err() && !is_forced());
    }
}
