//! Converts stored numbers to physical values by the numeric rules of MDF. Formulas, and rules whose result is a text,
//! have no value.

use super::blocks::Mdf;

/// A conversion and the unit of its result.
#[derive(Debug, Clone, Default)]
pub(super) struct Conversion {
    rule: Rule,
    /// Unit of the physical value; may be empty.
    pub unit: String,
}

#[derive(Debug, Clone, Default)]
enum Rule {
    #[default]
    Same,
    /// Offset and factor, for y = offset + factor · x, with the stored number x and the physical value y.
    Linear([f64; 2]),
    /// Coefficients a to f, for y = (a x² + b x + c) / (d x² + e x + f). The stored number is x, the physical value y.
    Rational([f64; 6]),
    /// Pairs of stored and physical value. Between two pairs, the value is interpolated if `straight` is true, else it
    /// is the value of the nearest pair. Outside the pairs, it is the value of the first or last pair.
    Table { pairs: Vec<[f64; 2]>, straight: bool },
}

impl Conversion {
    /// Reads the conversion that a channel links to. Without a link, it is the identity.
    pub fn read(mdf: &Mdf<'_>, at: u64) -> Result<Self, String> {
        if at == 0 {
            return Ok(Self::default());
        }
        let block = mdf.block(at, "CC")?;
        let (kind, count) = (block.u8(0)?, usize::from(block.u16(6)?));
        let value = |k: usize| block.f64(24 + 8 * k);
        let few = |wanted: usize| {
            if count < wanted {
                Err(format!("a conversion has {count} numbers where it needs {wanted}"))
            } else {
                Ok(())
            }
        };
        let rule = match kind {
            0 => Rule::Same,
            1 => {
                few(2)?;
                Rule::Linear([value(0)?, value(1)?])
            }
            2 => {
                few(6)?;
                Rule::Rational([value(0)?, value(1)?, value(2)?, value(3)?, value(4)?, value(5)?])
            }
            4 | 5 => {
                few(2)?;
                mdf.budget.numbers(count as u64)?;
                let pairs: Vec<[f64; 2]> =
                    (0..count / 2).map(|k| Ok([value(2 * k)?, value(2 * k + 1)?])).collect::<Result<_, String>>()?;
                Rule::Table { pairs, straight: kind == 4 }
            }
            // A channel with a formula or texts contains a state or a name, not a measurement of a rig.
            _ => Rule::Table { pairs: Vec::new(), straight: false },
        };
        Ok(Self { rule, unit: mdf.text(block.link(1)) })
    }

    /// Makes the identity, for which the stored number is the physical value.
    pub fn same(unit: String) -> Self {
        Self { rule: Rule::Same, unit }
    }

    /// Makes a linear conversion from offset and factor.
    pub fn linear(numbers: &[f64], unit: String) -> Self {
        Self { rule: Rule::Linear([numbers[0], numbers[1]]), unit }
    }

    /// Makes a rational conversion from three coefficients of the numerator and three of the denominator, beginning
    /// with the squares.
    pub fn rational(numbers: &[f64], unit: String) -> Self {
        let mut six = [0.0; 6];
        six.copy_from_slice(&numbers[..6]);
        Self { rule: Rule::Rational(six), unit }
    }

    /// Makes a table from pairs of stored and physical value.
    pub fn table(pairs: Vec<[f64; 2]>, straight: bool, unit: String) -> Self {
        Self { rule: Rule::Table { pairs, straight }, unit }
    }

    /// Makes a conversion without any numeric value.
    pub fn none(unit: String) -> Self {
        Self::table(Vec::new(), false, unit)
    }

    /// Returns the physical value, or NaN if the rule gives no value.
    pub fn physical(&self, raw: f64) -> f64 {
        let value = match &self.rule {
            Rule::Same => raw,
            Rule::Linear([offset, factor]) => offset + factor * raw,
            Rule::Rational([a, b, c, d, e, f]) => ((a * raw + b) * raw + c) / ((d * raw + e) * raw + f),
            Rule::Table { pairs, straight } => {
                let above = pairs.partition_point(|p| p[0] <= raw);
                match (above.checked_sub(1).and_then(|k| pairs.get(k)), pairs.get(above)) {
                    (Some(low), Some(high)) => {
                        let share = (raw - low[0]) / (high[0] - low[0]);
                        let share = if *straight { share } else { share.round() };
                        low[1] + share * (high[1] - low[1])
                    }
                    (Some(end), None) | (None, Some(end)) => end[1],
                    (None, None) => f64::NAN,
                }
            }
        };
        if value.is_finite() { value } else { f64::NAN }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_give_physical_values() {
        let of = |rule: Rule, raw: f64| Conversion { rule, unit: String::new() }.physical(raw);
        assert_eq!(of(Rule::Linear([-10.0, 0.5]), 40.0), 10.0);
        assert_eq!(of(Rule::Rational([0.0, 2.0, 0.0, 0.0, 0.0, 4.0]), 6.0), 3.0);
        let pairs = vec![[0.0, 10.0], [2.0, 20.0]];
        assert_eq!(of(Rule::Table { pairs: pairs.clone(), straight: true }, 0.5), 12.5);
        assert_eq!(of(Rule::Table { pairs: pairs.clone(), straight: false }, 0.5), 10.0);
        assert_eq!(of(Rule::Table { pairs, straight: true }, 9.0), 20.0);
        assert!(of(Rule::Rational([0.0; 6]), 1.0).is_nan());
    }
}
