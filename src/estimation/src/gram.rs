//! Products of all pairs of columns of a tall matrix, for the normal equations of least squares.

use nalgebra::DMatrix;

/// Tile size, columns: a tile contains the products of this number of columns with an equal number of columns.
///
/// Nine sums of two rows each, and six factors, fill the registers of a 64-bit processor.
const TILE: usize = 3;
/// Block size, rows: a tile is summed over one block before the next tile begins. Six columns of a block, 24 KB, fit
/// into the first-level cache. A sum over a block also has a smaller rounding error than a sum over all rows.
const ROWS: usize = 512;

/// Two rows of a column.
type Pair = [f64; 2];

/// Computes `columnsᵀ columns`. The result is symmetric. Its number of rows and columns is the number of columns of
/// `columns`.
///
/// Each product is summed in the same order on every machine. A library for such products (`matrixmultiply`) selects
/// code according to the processor, so the digits of a fit would depend on the processor. The library is faster for the
/// full product, but this function computes only half of the products, because the result is symmetric.
pub fn gram(columns: &DMatrix<f64>) -> DMatrix<f64> {
    let (rows, n) = columns.shape();
    let tiles = n.div_ceil(TILE);
    let padded: Vec<Vec<Pair>> = (0..tiles * TILE)
        .map(|j| if j < n { in_pairs(columns.column(j).as_slice()) } else { vec![[0.0; 2]; rows.div_ceil(2)] })
        .collect();
    let mut squares = DMatrix::zeros(n, n);
    for start in (0..rows.div_ceil(2)).step_by(ROWS / 2) {
        let end = rows.div_ceil(2).min(start + ROWS / 2);
        let of_tile = |tile: usize| std::array::from_fn(|k| &padded[tile * TILE + k][start..end]);
        for right in 0..tiles {
            for left in 0..=right {
                let products = products(of_tile(left), of_tile(right));
                for (a, of_row) in products.into_iter().enumerate() {
                    for (b, product) in of_row.into_iter().enumerate() {
                        let (i, j) = (left * TILE + a, right * TILE + b);
                        if i <= j && j < n {
                            squares[(i, j)] += product;
                        }
                    }
                }
            }
        }
    }
    squares.fill_lower_triangle_with_upper_triangle();
    squares
}

/// Groups a column into pairs of rows; a zero row completes the last pair of an odd number of rows.
fn in_pairs(column: &[f64]) -> Vec<Pair> {
    let (pairs, rest) = column.as_chunks();
    pairs.iter().copied().chain(rest.first().map(|last| [*last, 0.0])).collect()
}

/// Computes the products of each of the left columns with each of the right columns.
fn products(left: [&[Pair]; TILE], right: [&[Pair]; TILE]) -> [[f64; TILE]; TILE] {
    let rows = left[0].len();
    // With slices of equal length, the compiler omits bounds checks in the loop.
    let (left, right) = (left.map(|column| &column[..rows]), right.map(|column| &column[..rows]));
    let mut sums = [[[0.0; 2]; TILE]; TILE];
    for row in 0..rows {
        for a in 0..TILE {
            for b in 0..TILE {
                for lane in 0..2 {
                    sums[a][b][lane] += left[a][row][lane] * right[b][row][lane];
                }
            }
        }
    }
    sums.map(|of_row| of_row.map(|[even, odd]| even + odd))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares [`gram`] with term-by-term sums, for numbers of rows and columns that are not multiples of pair, tile
    /// or block.
    #[test]
    fn every_product_is_that_of_its_columns() {
        for (rows, n) in [(0, 2), (1, 1), (2, 3), (7, 4), (513, 5), (1200, 11), (4097, 8)] {
            let columns =
                DMatrix::from_fn(rows, n, |i, j| libm::sin(0.37 * i as f64 + 1.9 * j as f64) * (j + 1) as f64);
            let squares = gram(&columns);
            for i in 0..n {
                for j in 0..n {
                    let exact: f64 = (0..rows).map(|r| columns[(r, i)] * columns[(r, j)]).sum();
                    let size = columns.column(i).norm() * columns.column(j).norm();
                    assert!((squares[(i, j)] - exact).abs() <= 1e-14 * size, "{rows} rows, {n} columns: {i}, {j}");
                    assert_eq!(squares[(i, j)].to_bits(), squares[(j, i)].to_bits());
                }
            }
        }
    }
}
