//! Parser and evaluation of Adams function expressions. The caller supplies all functions except SQRT, ABS and SIGN.

/// Callback that returns the value of a function of an expression for its name and arguments.
pub type Call<'a> = &'a dyn Fn(&str, &[f64]) -> f64;

/// A parsed expression for repeated evaluation.
pub struct Expression(Term);

enum Term {
    Number(f64),
    Negative(Box<Term>),
    Operation(fn(f64, f64) -> f64, Box<[Term; 2]>),
    Function(String, Vec<Term>),
}

impl Expression {
    /// Parses `text`, which may contain blanks.
    ///
    /// # Panics
    /// If the text is not an expression.
    pub fn read(text: &str) -> Self {
        let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
        let mut reader = Reader { rest: &text };
        let term = reader.sum();
        assert!(reader.rest.is_empty(), "\"{}\" is left of {text}", reader.rest);
        Self(term)
    }

    /// Evaluates the expression. `call` evaluates all functions except SQRT, ABS and SIGN.
    pub fn evaluate(&self, call: Call) -> f64 {
        self.0.evaluate(call)
    }
}

impl Term {
    fn evaluate(&self, call: Call) -> f64 {
        match self {
            Self::Number(value) => *value,
            Self::Negative(term) => -term.evaluate(call),
            Self::Operation(operation, terms) => operation(terms[0].evaluate(call), terms[1].evaluate(call)),
            Self::Function(name, terms) => {
                let arguments: Vec<f64> = terms.iter().map(|term| term.evaluate(call)).collect();
                match (name.as_str(), &arguments[..]) {
                    ("SQRT", [x]) => x.sqrt(),
                    ("ABS", [x]) => x.abs(),
                    ("SIGN", [size, of]) => size.abs() * if *of < 0.0 { -1.0 } else { 1.0 },
                    _ => call(name, &arguments),
                }
            }
        }
    }

    fn with(self, operation: fn(f64, f64) -> f64, other: Self) -> Self {
        Self::Operation(operation, Box::new([self, other]))
    }
}

struct Reader<'a> {
    rest: &'a str,
}

impl Reader<'_> {
    fn take(&mut self, symbol: char) -> bool {
        self.rest.strip_prefix(symbol).map(|rest| self.rest = rest).is_some()
    }

    fn sum(&mut self) -> Term {
        let mut term = self.product();
        loop {
            if self.take('+') {
                term = term.with(|a, b| a + b, self.product());
            } else if self.take('-') {
                term = term.with(|a, b| a - b, self.product());
            } else {
                return term;
            }
        }
    }

    fn product(&mut self) -> Term {
        let mut term = self.power();
        loop {
            if self.take('*') {
                term = term.with(|a, b| a * b, self.power());
            } else if self.take('/') {
                term = term.with(|a, b| a / b, self.power());
            } else {
                return term;
            }
        }
    }

    /// Parses a power, which has precedence over a product and associates to the right.
    fn power(&mut self) -> Term {
        let base = self.atom();
        match self.rest.strip_prefix("**") {
            Some(rest) => {
                self.rest = rest;
                base.with(f64::powf, self.power())
            }
            None => base,
        }
    }

    fn atom(&mut self) -> Term {
        if self.take('-') {
            // A power has precedence over a sign: -2**2 is -4. In Adams, a product also has precedence over a sign. In
            // this parser, a sign has precedence over a product, but the values are equal.
            return Term::Negative(Box::new(self.power()));
        }
        if self.take('(') {
            let term = self.sum();
            assert!(self.take(')'), "a bracket is open before \"{}\"", self.rest);
            return term;
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
            return Term::Number(number.parse().unwrap_or_else(|_| panic!("\"{number}\" is no number")));
        }
        let (name, rest) = self.rest.split_at(of(|c| c.is_ascii_alphanumeric(), self.rest));
        self.rest = rest;
        assert!(self.take('('), "\"{name}{rest}\" is no expression");
        let mut arguments = vec![self.sum()];
        while self.take(',') {
            arguments.push(self.sum());
        }
        assert!(self.take(')'), "{name} lacks a bracket before \"{}\"", self.rest);
        Term::Function(name.into(), arguments)
    }
}
