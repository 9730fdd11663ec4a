//! The error matrix: rows by amplitude, columns by peak velocity or frequency.

use dashpot_identification::validation::SLOW_PEAK_VELOCITY;
use dashpot_records::Record;

/// Quantity of the columns of the error matrix.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Across {
    /// Peak velocity.
    #[default]
    Velocity,
    /// Frequency.
    Frequency,
}

/// The tests by amplitude and by peak velocity or frequency.
#[derive(Debug, Clone, Default)]
pub struct Grid {
    /// Amplitudes of the rows, m.
    pub rows: Vec<f64>,
    /// Peak velocities, m/s, or frequencies, Hz, of the columns.
    pub columns: Vec<f64>,
    /// Indices of the tests in each cell, row by row.
    pub cells: Vec<Vec<usize>>,
    /// Indices of the slow tests for friction and gas force. They have no columns, because their many velocities would fill the matrix. The
    /// report lists slow tests separately too.
    pub slow: Vec<usize>,
    /// Indices of the tests without whole cycles, which are outside the matrix.
    pub elsewhere: Vec<usize>,
}

/// Largest relative difference of amplitudes in one row, and of velocities or frequencies in one column. Rigs reach their targets within a
/// few percent.
const SAME: f64 = 0.06;

/// Groups values that differ by at most [`SAME`] from the smallest value of their group. Returns the mean of each group, in increasing
/// order.
fn clusters(mut values: Vec<f64>) -> Vec<f64> {
    values.sort_by(f64::total_cmp);
    let mut groups: Vec<Vec<f64>> = Vec::new();
    for value in values {
        match groups.last_mut() {
            Some(group) if value <= group[0] * (1.0 + SAME) => group.push(value),
            _ => groups.push(vec![value]),
        }
    }
    groups.into_iter().map(|g| g.iter().sum::<f64>() / g.len() as f64).collect()
}

fn nearest(of: &[f64], value: f64) -> Option<usize> {
    (0..of.len()).min_by(|a, b| libm::log(of[*a] / value).abs().total_cmp(&libm::log(of[*b] / value).abs()))
}

impl Grid {
    /// Assigns the tests to cells.
    pub fn new(records: &[Record], across: Across) -> Grid {
        let of = |r: &Record| match across {
            Across::Velocity => r.peak_velocity,
            Across::Frequency => r.frequency,
        };
        let periodic = |r: &Record| r.frequency > 0.0 && r.amplitude > 0.0 && of(r) > 0.0;
        let is_slow = |r: &Record| periodic(r) && r.peak_velocity < SLOW_PEAK_VELOCITY;
        let placed = |r: &Record| periodic(r) && !is_slow(r);
        let rows = clusters(records.iter().filter(|r| placed(r)).map(|r| r.amplitude).collect());
        let columns = clusters(records.iter().filter(|r| placed(r)).map(of).collect());
        let mut grid = Grid {
            cells: vec![Vec::new(); rows.len() * columns.len()],
            rows,
            columns,
            slow: Vec::new(),
            elsewhere: Vec::new(),
        };
        for (k, record) in records.iter().enumerate() {
            match (nearest(&grid.rows, record.amplitude), nearest(&grid.columns, of(record))) {
                (Some(row), Some(column)) if placed(record) => grid.cells[row * grid.columns.len() + column].push(k),
                _ if is_slow(record) => grid.slow.push(k),
                _ => grid.elsewhere.push(k),
            }
        }
        grid
    }

    /// Returns the tests of a cell.
    pub fn cell(&self, row: usize, column: usize) -> &[usize] {
        self.cells.get(row * self.columns.len() + column).map_or(&[], Vec::as_slice)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_test_has_one_place() {
        let record = |amplitude: f64, frequency: f64| Record {
            amplitude,
            frequency,
            peak_velocity: std::f64::consts::TAU * frequency * amplitude,
            ..Record::default()
        };
        let slow = record(0.02, 0.01);
        let records = [record(0.05, 1.0), record(0.0502, 2.0), record(0.005, 10.0), record(0.02, 0.0), slow];
        for across in [Across::Velocity, Across::Frequency] {
            let grid = Grid::new(&records, across);
            assert_eq!(grid.rows.len(), 2);
            let mut all: Vec<usize> = grid.cells.concat();
            all.extend(grid.elsewhere.iter().chain(&grid.slow));
            all.sort_unstable();
            assert_eq!(all, [0, 1, 2, 3, 4]);
            assert_eq!((&grid.elsewhere[..], &grid.slow[..]), (&[3][..], &[4][..]));
        }
    }
}
