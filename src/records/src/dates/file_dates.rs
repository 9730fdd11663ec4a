//! What the dates of one file tell of the order of day and month.

use super::clock::{self, DAY};
use super::date_order::DateOrder;
use crate::numbers::range;

/// What the dates of a file tell.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Dates {
    /// The date by which the test began, where it is one in either order.
    pub(crate) open: Option<Open>,
    /// What another date of the file decides.
    pub(crate) decided: Option<DateOrder>,
    /// How programs write dates that write numbers as this file does.
    pub likely: Option<DateOrder>,
}

/// A date that is one in either order.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Open {
    pub text: String,
    pub read: DateOrder,
    /// From the date as it was read to the other one, s.
    pub shift: f64,
}

impl Dates {
    /// Of lines above a table, the test of which began on the date `began`.
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

    /// Sees a date, or a date with a time, by which a test began, or one below it.
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

    /// Whether a date that is seen may still decide.
    pub fn is_open(&self) -> bool {
        self.open.is_some() && self.decided.is_none()
    }

    fn decide(&mut self, date: &str) {
        if let Some(clock::Date { order: Some(order), other: None, .. }) = clock::date(date) {
            self.decided = self.decided.or(Some(order));
        }
    }

    /// Takes the other order for the times of a column, s, where the order is open and they lie closer together by
    /// it.
    ///
    /// No test goes on for a month. Dates that only one order reads stay.
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
