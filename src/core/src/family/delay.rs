//! Dead time: a signal delayed by a fixed time.
//!
//! [`CELLS`] cells of equal length store the signal of the last dead time. Each cell stores the mean of the signal over
//! its length. The output of a step is the mean of the delayed signal over the step. For any step lengths, every part
//! of the signal contributes exactly once to the outputs. The delay of a change equals the dead time to within the
//! length of a cell.

use crate::math::max;

/// Number of cells in a dead time. The delay of a change is accurate to a sixteenth of the dead time.
pub const CELLS: usize = 16;

/// Mark that distinguishes a stored signal from uninitialized memory.
const MARK: f64 = 1_346_454_016.0;

/// The signal (the commanded setting) of the last dead time, as stored means.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Delay {
    /// Mean of the signal over each cell; the oldest cell is overwritten next.
    cells: [f64; CELLS],
    /// Integral of the signal over the elapsed part of the cell that is being stored.
    filled: f64,
    /// Length of the elapsed part of the cell that is being stored, s.
    elapsed: f64,
    /// Index of the oldest cell, a whole number from 0.
    oldest: f64,
    /// [`MARK`] if a signal is stored.
    mark: f64,
}

impl Default for Delay {
    fn default() -> Delay {
        Delay::UNSET
    }
}

impl Delay {
    /// A delay without a stored signal.
    pub const UNSET: Delay = Delay { cells: [0.0; CELLS], filled: 0.0, elapsed: 0.0, oldest: 0.0, mark: 0.0 };

    /// Makes the delay for a signal that has been constant for at least the dead time.
    pub fn constant(signal: f64) -> Delay {
        Delay { cells: [signal; CELLS], mark: MARK, ..Delay::UNSET }
    }

    /// Returns whether a signal is stored and all its numbers are finite.
    pub fn is_set(&self) -> bool {
        let sum = self.cells.iter().fold(self.filled + self.elapsed, |sum, cell| sum + cell);
        let counts = self.oldest >= 0.0 && self.oldest < CELLS as f64 && self.elapsed >= 0.0;
        self.mark == MARK && counts && sum * 0.0 == 0.0
    }

    /// Advances by a step of `dt`, s, in which the signal is constant; returns the mean of the delayed signal over the
    /// step. `dead_time` is in s.
    pub fn advance(&mut self, signal: f64, dead_time: f64, dt: f64) -> f64 {
        if dt >= 2.0 * dead_time {
            // During the step, the output is the stored signal, followed by the new signal. Afterwards, only the new
            // signal is stored.
            let cell = dead_time / CELLS as f64;
            let oldest = self.cells.get(self.oldest as usize).copied().unwrap_or(signal);
            let all = self.cells.iter().fold(0.0, |sum, mean| sum + mean * cell);
            let kept = all - oldest * self.elapsed + self.filled;
            *self = Delay::constant(signal);
            return (kept + signal * (dt - dead_time)) / dt;
        }
        let cell = dead_time / CELLS as f64;
        let (mut left, mut sum) = (dt, 0.0);
        // A step shorter than two dead times needs at most this many parts of cells. The limit prevents an endless loop
        // if other code has overwritten this memory.
        for _ in 0..2 * CELLS + 2 {
            if left <= 0.0 {
                break;
            }
            let Some(mean) = self.cells.get_mut(self.oldest as usize) else { return signal };
            let rest = max(cell - self.elapsed, 0.0);
            let part = if left < rest { left } else { rest };
            sum += *mean * part;
            self.filled += signal * part;
            self.elapsed += part;
            left -= part;
            if part == rest {
                *mean = self.filled / cell;
                self.oldest = if self.oldest + 1.0 < CELLS as f64 { self.oldest + 1.0 } else { 0.0 };
                (self.filled, self.elapsed) = (0.0, 0.0);
            }
        }
        sum / dt
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_comes_out_a_dead_time_later_and_none_of_it_is_lost() {
        for (dead_time, dt) in [(5e-3, 1e-3), (5e-3, 0.7e-3), (4e-3, 1e-4), (2e-3, 3e-3), (1e-3, 4e-3), (10e-3, 1e-3)] {
            let mut delay = Delay::constant(1.0);
            let (mut came_in, mut came_out, mut rose_at) = (0.0, 0.0, None);
            for k in 0..200 {
                // The signal steps between 1, 2 and 3 for 100 steps and is constant afterwards.
                let signal = if k < 100 { 1.0 + f64::from(k / 10 % 3) } else { 2.0 };
                let out = delay.advance(signal, dead_time, dt);
                (came_in, came_out) = (came_in + (signal - 1.0) * dt, came_out + (out - 1.0) * dt);
                if out > 1.0 + 1e-9 && rose_at.is_none() {
                    rose_at = Some(f64::from(k + 1) * dt);
                }
            }
            // The first change is in the step that begins at 10 dt.
            let late = rose_at.unwrap() - 10.0 * dt;
            assert!(
                late > dead_time - dead_time / 16.0 - 1e-12 && late <= dead_time + dt + 1e-9,
                "{late} for {dead_time}"
            );
            // The last value of the signal, 1 above the initial one, fills the stored dead time. The integrals of input
            // and output differ by that area.
            assert!((came_in - came_out - dead_time).abs() < 1e-9, "{came_in} {came_out} {dead_time} {dt}");
            assert!((delay.advance(2.0, dead_time, dt) - 2.0).abs() < 1e-9);
        }
    }

    #[test]
    fn what_nobody_wrote_is_no_signal() {
        assert!(!Delay::UNSET.is_set() && Delay::constant(0.5).is_set());
        assert!(!Delay { oldest: 16.0, ..Delay::constant(0.5) }.is_set());
        assert!(!Delay { filled: f64::NAN, ..Delay::constant(0.5) }.is_set());
    }
}
