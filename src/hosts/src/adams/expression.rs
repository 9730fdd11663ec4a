//! Evaluation of the function expression of a force-velocity (FV) damper at a velocity. The result shows whether the damper force is
//! positive in rebound or in compression.

use anyhow::{Context as _, bail};

/// Values of the names in an expression.
pub struct Meaning<'a> {
    /// Ids of the markers I and J of the damper's SFORCE, if known.
    pub markers: [Option<u64>; 2],
    /// Velocity VR between the markers of the SFORCE, in model units.
    pub speed: f64,
    /// Function that returns the value of the spline with an id at an abscissa.
    pub spline: &'a dyn Fn(u64, f64) -> anyhow::Result<f64>,
}

/// Largest nesting depth of brackets, signs and powers. It limits the recursion of [`Reader`]. The function of a real damper has a few
/// levels.
const DEEPEST: usize = 100;

/// Evaluates an expression in capitals without spaces.
///
/// # Errors
/// The expression has content that does not belong to an FV damper, such as other functions or markers, or it is empty.
pub fn evaluate(text: &str, meaning: &Meaning<'_>) -> anyhow::Result<f64> {
    let mut reader = Reader { rest: text, meaning, depth: 0 };
    let value = reader.sum()?;
    if !reader.rest.is_empty() {
        bail!("\"{}\" in its function is not understood", reader.rest);
    }
    Ok(value)
}

struct Reader<'a> {
    rest: &'a str,
    depth: usize,
    meaning: &'a Meaning<'a>,
}

impl Reader<'_> {
    fn take(&mut self, symbol: &str) -> bool {
        self.rest.strip_prefix(symbol).map(|rest| self.rest = rest).is_some()
    }

    fn sum(&mut self) -> anyhow::Result<f64> {
        let mut value = self.product()?;
        loop {
            if self.take("+") {
                value += self.product()?;
            } else if self.take("-") {
                value -= self.product()?;
            } else {
                return Ok(value);
            }
        }
    }

    fn product(&mut self) -> anyhow::Result<f64> {
        let mut value = self.factor()?;
        loop {
            if self.take("*") {
                value *= self.factor()?;
            } else if self.take("/") {
                value /= self.factor()?;
            } else {
                return Ok(value);
            }
        }
    }

    /// Parses a power. As in Fortran, a power binds more tightly than a sign or a product, and several powers are evaluated from right to
    /// left.
    fn power(&mut self) -> anyhow::Result<f64> {
        let base = self.atom()?;
        if self.take("**") { Ok(libm::pow(base, self.factor()?)) } else { Ok(base) }
    }

    fn factor(&mut self) -> anyhow::Result<f64> {
        self.depth += 1;
        if self.depth > DEEPEST {
            bail!("its function is nested more than {DEEPEST} deep");
        }
        let value = self.factor_within();
        self.depth -= 1;
        value
    }

    fn factor_within(&mut self) -> anyhow::Result<f64> {
        if self.take("-") {
            return Ok(-self.factor()?);
        }
        if self.take("+") {
            return self.factor();
        }
        self.power()
    }

    fn atom(&mut self) -> anyhow::Result<f64> {
        if self.take("(") {
            let value = self.sum()?;
            return if self.take(")") { Ok(value) } else { bail!("its function lacks a closing bracket") };
        }
        if self.rest.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return self.number();
        }
        let length = self.rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(self.rest.len());
        let (name, rest) = self.rest.split_at(length);
        self.rest = rest;
        if name.is_empty() || !self.take("(") {
            bail!("\"{name}{rest}\" in its function is not understood");
        }
        let mut arguments = vec![self.sum()?];
        while self.take(",") {
            arguments.push(self.sum()?);
        }
        if !self.take(")") {
            bail!("its function lacks a closing bracket");
        }
        self.call(name, &arguments)
    }

    fn number(&mut self) -> anyhow::Result<f64> {
        let bytes = self.rest.as_bytes();
        let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit() || **b == b'.').count();
        let mut length = digits(0);
        if matches!(bytes.get(length), Some(b'E' | b'D')) {
            let sign = usize::from(matches!(bytes.get(length + 1), Some(b'+' | b'-')));
            let power = digits(length + 1 + sign);
            if power > 0 {
                length += 1 + sign + power;
            }
        }
        let (number, rest) = self.rest.split_at(length);
        self.rest = rest;
        number.replace('D', "E").parse().with_context(|| format!("\"{number}\" in its function is no number"))
    }

    fn call(&self, name: &str, arguments: &[f64]) -> anyhow::Result<f64> {
        let id = |value: f64| (value >= 0.0 && value.fract() == 0.0).then_some(value as u64);
        match (name, arguments) {
            ("VR", [i, j, ..]) => {
                let (mut named, mut own) = ([id(*i), id(*j)], self.meaning.markers);
                named.sort_unstable();
                own.sort_unstable();
                if own[0].is_some() && named != own {
                    bail!("its function uses VR({i},{j}), which are not its own markers");
                }
                Ok(self.meaning.speed)
            }
            ("AKISPL" | "CUBSPL", [x, _, spline, order @ ..]) => {
                if order.iter().any(|o| *o != 0.0) {
                    bail!("its function takes the slope of a spline");
                }
                (self.meaning.spline)(id(*spline).context("its spline has no plain number")?, *x)
            }
            ("STEP" | "STEP5" | "HAVSIN", [x, x0, h0, x1, h1]) => {
                let s = ((x - x0) / (x1 - x0)).clamp(0.0, 1.0);
                Ok(h0 + (h1 - h0) * s * s * (3.0 - 2.0 * s))
            }
            ("ABS", [x]) => Ok(x.abs()),
            _ => bail!("its function uses {name}, which is no part of an FV damper"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_bind_as_in_fortran() {
        let meaning = Meaning { markers: [None; 2], speed: 3.0, spline: &|_, x| Ok(10.0 * x) };
        for (text, value) in [
            ("2*3**2", 18.0),
            ("-2**2", -4.0),
            ("(-2)**2", 4.0),
            ("2**3**2", 512.0),
            ("2**-1*4", 2.0),
            ("8/2*4", 16.0),
            ("1-2-3", -4.0),
            ("-VR(1,2)**2+1.5D1", 6.0),
            ("AKISPL(VR(1,2),0,9)*2**2", 120.0),
        ] {
            assert_eq!(evaluate(text, &meaning).expect(text), value, "{text}");
        }
    }
}
