//! Evidence for the order of day and month in the dates of one file.

use super::clock::{self, DAY};
use super::date_order::DateOrder;
use crate::numbers::range;

/// Evidence from the dates of a file.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Dates {
    /// Start date of the test, if it is valid in both orders.
    pub(crate) open: Option<Open>,
    /// Order of day and month in the dates of the file, if one of them is valid in only one order.
    pub(crate) decided: Option<DateOrder>,
    /// Order that is typical of programs with the number format of this file.
    pub likely: Option<DateOrder>,
}

/// A date that is valid in both orders.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Open {
    pub text: String,
    pub read: DateOrder,
    /// The date in the other order minus the date as read, s.
    pub shift: f64,
}

impl Dates {
    /// Collects the evidence of the lines above a table. `began` is the start date of the test.
    pub fn of_lines<'a>(lines: impl Iterator<Item = &'a str>, began: Option<&str>) -> Dates {
        let mut dates = Dates::default();
        if let Some(began) = began {
            dates.see(began);
        }
        for word in lines.flat_map(clock::words) {
            dates.decide(word);
        }
        dates
    }

    /// Adds a date to the evidence: the start date of the test, with or without a time, or a date in the time column.
    pub fn see(&mut self, text: &str) {
        let text = text.trim();
        let date = text.split([' ', 'T']).next().unwrap_or_default();
        self.decide(date);
        if self.open.is_none()
            && let Some(clock::Date { number, order: Some(read), other: Some(other) }) = clock::date(date)
        {
            self.open = Some(Open { text: date.to_owned(), read, shift: (other - number) * DAY });
        }
    }

    /// Returns whether a further date may still determine the order.
    pub fn is_open(&self) -> bool {
        self.open.is_some() && self.decided.is_none()
    }

    fn decide(&mut self, date: &str) {
        if let Some(clock::Date { order: Some(order), other: None, .. }) = clock::date(date) {
            self.decided = self.decided.or(Some(order));
        }
    }

    /// Uses the other order for the times of a column, s, if the order is ambiguous and the other order puts them
    /// closer together.
    ///
    /// A test is shorter than a month, whereas days that follow each other lie a month apart in the wrong order. Dates
    /// that are valid in only one order stay unchanged.
    pub fn resolve_column(&mut self, times: &mut [f64]) {
        let Some(open) = self.open.as_mut().filter(|_| self.decided.is_none()) else { return };
        let other: Vec<f64> = times.iter().map(|time| clock::swapped(*time).unwrap_or(*time)).collect();
        if range(&other) + 0.5 * DAY < range(times) {
            times.copy_from_slice(&other);
            self.decided = Some(match open.read {
                DateOrder::DayFirst => DateOrder::MonthFirst,
                DateOrder::MonthFirst => DateOrder::DayFirst,
            });
            self.open = None;
        }
    }
}
