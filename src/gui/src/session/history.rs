//! Undo and redo of a value.

/// Largest number of undo steps. A model has a few kilobytes, so all steps need a few megabytes.
const DEPTH: usize = 500;

/// A value with its undo and redo steps. `C` is the type that identifies the subject of a change.
#[derive(Clone)]
pub struct History<T, C> {
    past: Vec<T>,
    now: T,
    future: Vec<T>,
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
            self.past.push(before);
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
        let Some(before) = self.past.pop() else { return false };
        self.future.push(std::mem::replace(&mut self.now, before));
        true
    }

    /// Restores the value before the last undo. Returns `false` if there is none.
    pub fn redo(&mut self) -> bool {
        self.open = None;
        let Some(after) = self.future.pop() else { return false };
        self.past.push(std::mem::replace(&mut self.now, after));
        true
    }

    /// Discards the redo steps, and ends the current change.
    pub fn forget_future(&mut self) {
        self.open = None;
        self.future.clear();
    }

    /// Returns whether undo and redo are possible.
    pub fn can(&self) -> (bool, bool) {
        (!self.past.is_empty(), !self.future.is_empty())
    }
}
