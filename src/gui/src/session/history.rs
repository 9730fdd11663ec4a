//! What was, is and will be again: undo and redo.

/// Steps that can be taken back; a model takes a few kilobytes, so all of them a few megabytes.
const DEPTH: usize = 500;

/// A value with its past and its future. `C` is what a change belongs to.
pub struct History<T, C> {
    past: Vec<T>,
    now: T,
    future: Vec<T>,
    /// What the change under way belongs to; a change of the same kind takes its place.
    open: Option<C>,
}

impl<T: Clone + PartialEq, C: PartialEq> History<T, C> {
    /// Nothing was before `now`.
    pub fn new(now: T) -> Self {
        History { past: Vec::new(), now, future: Vec::new(), open: None }
    }

    /// The value as it is.
    pub fn now(&self) -> &T {
        &self.now
    }

    /// Takes another value; whether it is another.
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

    /// Ends the change under way.
    pub fn seal(&mut self) {
        self.open = None;
    }

    /// One step back.
    pub fn undo(&mut self) -> bool {
        self.open = None;
        let Some(before) = self.past.pop() else { return false };
        self.future.push(std::mem::replace(&mut self.now, before));
        true
    }

    /// One step forth.
    pub fn redo(&mut self) -> bool {
        self.open = None;
        let Some(after) = self.future.pop() else { return false };
        self.past.push(std::mem::replace(&mut self.now, after));
        true
    }

    /// Forgets what was taken back: another value takes the place of what would be done again.
    pub fn forget_future(&mut self) {
        self.open = None;
        self.future.clear();
    }

    /// Whether there is a step back, and one forth.
    pub fn can(&self) -> (bool, bool) {
        (!self.past.is_empty(), !self.future.is_empty())
    }
}
