//! Undo and redo of a value.
//!
//! Each step has a serial number, so that steps of several values can be undone in the order of their changes.

use std::sync::atomic::{AtomicU64, Ordering};

/// Largest number of undo steps. A model has a few kilobytes, so all steps need a few megabytes.
const DEPTH: usize = 500;

/// Returns the serial number of a new step. It is larger than those of all steps before.
pub fn next_serial() -> u64 {
    static NEWEST: AtomicU64 = AtomicU64::new(0);
    1 + NEWEST.fetch_add(1, Ordering::Relaxed)
}

/// A value with its undo and redo steps. `C` is the type that identifies the subject of a change.
#[derive(Clone)]
pub struct History<T, C> {
    /// Values before each undo step, with the serial number of the step.
    past: Vec<(u64, T)>,
    now: T,
    /// Values after each redo step, with the serial number of the step.
    future: Vec<(u64, T)>,
    /// Subject of the current change. A further change of this subject adds no undo step.
    open: Option<C>,
}

impl<T: Clone + PartialEq, C: PartialEq> History<T, C> {
    /// Begins the history with `now`.
    pub fn new(now: T) -> Self {
        History { past: Vec::new(), now, future: Vec::new(), open: None }
    }

    /// Returns the current value.
    pub fn now(&self) -> &T {
        &self.now
    }

    /// Sets the value and discards the redo steps. Successive changes of one subject are one undo step. Returns whether
    /// the new value differs from the previous value.
    pub fn change(&mut self, change: C, value: T) -> bool {
        if value == self.now {
            return false;
        }
        let before = std::mem::replace(&mut self.now, value);
        let change = Some(change);
        if self.open != change {
            self.past.push((next_serial(), before));
            if self.past.len() > DEPTH {
                self.past.remove(0);
            }
        }
        self.open = change;
        self.future.clear();
        true
    }

    /// Ends the current change, so that the next change has a separate undo step.
    pub fn seal(&mut self) {
        self.open = None;
    }

    /// Restores the value before the last undo step. Returns `false` if there is none.
    pub fn undo(&mut self) -> bool {
        self.open = None;
        let Some((serial, before)) = self.past.pop() else { return false };
        self.future.push((serial, std::mem::replace(&mut self.now, before)));
        true
    }

    /// Restores the value before the last undo. Returns `false` if there is none.
    pub fn redo(&mut self) -> bool {
        self.open = None;
        let Some((serial, after)) = self.future.pop() else { return false };
        self.past.push((serial, std::mem::replace(&mut self.now, after)));
        true
    }

    /// Discards the redo steps, and ends the current change.
    pub fn forget_future(&mut self) {
        self.open = None;
        self.future.clear();
    }

    /// Returns the value that undo would restore, or `None` without an undo step.
    pub fn before(&self) -> Option<&T> {
        self.past.last().map(|(_, value)| value)
    }

    /// Returns the value that redo would restore, or `None` without a redo step.
    pub fn after(&self) -> Option<&T> {
        self.future.last().map(|(_, value)| value)
    }

    /// Returns the serial numbers of the step that undo would undo and of the step that redo would redo.
    pub fn steps(&self) -> (Option<u64>, Option<u64>) {
        let serial = |steps: &[(u64, T)]| steps.last().map(|(serial, _)| *serial);
        (serial(&self.past), serial(&self.future))
    }
}
