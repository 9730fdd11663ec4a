//! The value of an Adams function expression, by whatever its functions mean to the caller.

/// What a function gives for its arguments.
pub type Call<'a> = &'a dyn Fn(&str, &[f64]) -> f64;

/// The value of `text`, which may have blanks in it.
///
/// # Panics
/// Where it is no expression.
pub fn evaluate(text: &str, call: Call) -> f64 {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let mut reader = Reader { rest: &text, call };
    let value = reader.sum();
    assert!(reader.rest.is_empty(), "\"{}\" is left of {text}", reader.rest);
    value
}

struct Reader<'a> {
    rest: &'a str,
    call: Call<'a>,
}

impl Reader<'_> {
    fn take(&mut self, symbol: char) -> bool {
        self.rest.strip_prefix(symbol).map(|rest| self.rest = rest).is_some()
    }

    fn sum(&mut self) -> f64 {
        let mut value = self.product();
        loop {
            if self.take('+') {
                value += self.product();
            } else if self.take('-') {
                value -= self.product();
            } else {
                return value;
            }
        }
    }

    fn product(&mut self) -> f64 {
        let mut value = self.power();
        loop {
            if self.take('*') {
                value *= self.power();
            } else if self.take('/') {
                value /= self.power();
            } else {
                return value;
            }
        }
    }

    /// Binds stronger than a product, and from the right.
    fn power(&mut self) -> f64 {
        let base = self.atom();
        match self.rest.strip_prefix("**") {
            Some(rest) => {
                self.rest = rest;
                base.powf(self.power())
            }
            None => base,
        }
    }

    fn atom(&mut self) -> f64 {
        if self.take('-') {
            // A sign binds weaker than a product, which gives the same value.
            return -self.atom();
        }
        if self.take('(') {
            let value = self.sum();
            assert!(self.take(')'), "a bracket is open before \"{}\"", self.rest);
            return value;
        }
        let of = |allowed: fn(char) -> bool, text: &str| text.find(|c| !allowed(c)).unwrap_or(text.len());
        if self.rest.starts_with(|c: char| c.is_ascii_digit()) {
            let mut end = of(|c| c.is_ascii_digit() || c == '.', self.rest);
            if self.rest[end..].starts_with(['e', 'E']) {
                end += 2;
                end += of(|c| c.is_ascii_digit(), &self.rest[end..]);
            }
            let (number, rest) = self.rest.split_at(end);
            self.rest = rest;
            return number.parse().unwrap_or_else(|_| panic!("\"{number}\" is no number"));
        }
        let (name, rest) = self.rest.split_at(of(|c| c.is_ascii_alphanumeric(), self.rest));
        self.rest = rest;
        assert!(self.take('('), "\"{name}{rest}\" is no expression");
        let mut arguments = vec![self.sum()];
        while self.take(',') {
            arguments.push(self.sum());
        }
        assert!(self.take(')'), "{name} lacks a bracket before \"{}\"", self.rest);
        match (name, &arguments[..]) {
            ("SQRT", [x]) => x.sqrt(),
            ("ABS", [x]) => x.abs(),
            ("SIGN", [size, of]) => size.abs() * if *of < 0.0 { -1.0 } else { 1.0 },
            _ => (self.call)(name, &arguments),
        }
    }
}
