//! Runs: units of work in one process, each with its own inputs and its own permission to replace files. A command is
//! one run and sets inputs and permission for the whole process. The Python package makes many runs, some of them
//! concurrently.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

/// Settings of the run of this thread.
#[derive(Debug, Default, Clone)]
struct Run {
    force: bool,
    reads: Vec<PathBuf>,
}

thread_local! {
    static RUN: RefCell<Run> = RefCell::default();
}

/// Guard that restores the previous run when the work ends, even by a panic.
struct Before(Option<Run>);

impl Drop for Before {
    fn drop(&mut self) {
        if let Some(before) = self.0.take() {
            RUN.set(before);
        }
    }
}

/// Runs work that writes files in this thread.
///
/// With `force`, outputs may replace any file. Without `force`, they must not replace a file in `reads`, just as on the
/// command line.
pub fn as_a_run<'a, T>(force: bool, reads: impl IntoIterator<Item = &'a Path>, work: impl FnOnce() -> T) -> T {
    let reads = reads.into_iter().filter_map(|path| std::fs::canonicalize(path).ok()).collect();
    let _before = Before(Some(RUN.replace(Run { force, reads })));
    work()
}

/// Returns whether the run of this thread may replace any file.
pub fn is_forced() -> bool {
    RUN.with_borrow(|run| run.force)
}

/// Returns the inputs of the run of this thread, after resolution of links.
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
