//! Reads dates and times of day in the notations of files, in a column or above the table, and writes them for reports.

use super::date_order::DateOrder;

/// Seconds of a day.
pub(crate) const DAY: f64 = 86_400.0;
/// The first instant of 1980, s since 1970, at which clocks start if nobody sets them.
pub(crate) const FIRST_OF_1980: f64 = 3652.0 * DAY;

/// Finds the start of a test in the lines above its table (`Date: 25.11.2026` and `Time: 10:03:22`, or both in one
/// line).
///
/// Returns the start by the rig's own clock, or `None` without a date or without a time. A line with date and time has
/// precedence over separate lines.
pub(crate) fn begins<'a>(lines: impl Iterator<Item = &'a str>) -> Option<Began<'a>> {
    let (mut date, mut time) = (None, None);
    let both = |(day, word): (f64, &'a str), time: f64| Began { at: day + time, date: Some(word) };
    for line in lines {
        match date_and_time(line) {
            (Some(date), Some(time)) => return Some(both(date, time)),
            (d, t) => (date, time) = (date.or(d), time.or(t)),
        }
    }
    Some(both(date?, time?))
}

/// Start of a test, s since 1970, and the date as written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Began<'a> {
    pub at: f64,
    pub date: Option<&'a str>,
}

/// Splits a line into words. A date and a time of day joined by `T` give two words.
pub(crate) fn words(line: &str) -> impl Iterator<Item = &str> {
    let is_between = |c: char| c.is_whitespace() || ",;\"'()[]=".contains(c);
    line.split(is_between).flat_map(|word| word.split('T')).filter(|word| !word.is_empty())
}

/// Returns the first date in a line, s since 1970, with its text, and the first time of day, s.
fn date_and_time(line: &str) -> (Option<(f64, &str)>, Option<f64>) {
    let mut words = words(line).peekable();
    let (mut date, mut time) = (None, None);
    while let Some(word) = words.next() {
        if !word.starts_with(|c: char| c.is_ascii_digit()) {
            continue;
        }
        if let Some(number) = day(word) {
            date = date.or(Some((number * DAY, word)));
        } else if word.matches(':').count() == 2 {
            let half = words.next_if(|next| ["AM", "PM"].iter().any(|half| next.eq_ignore_ascii_case(half)));
            time = time.or(seconds(&format!("{word} {}", half.unwrap_or_default())));
        }
    }
    (date, time)
}

/// Formats a time, s since 1970, for reports, to the second: `2026-11-25 10:03:22`. A value below one day has an
/// unknown date, so only the time is written.
pub fn written(seconds: f64) -> String {
    let whole = seconds.floor();
    let (days, of_day) = ((whole / DAY).floor(), whole.rem_euclid(DAY));
    let (hour, minute, second) = ((of_day / 3600.0).floor(), (of_day / 60.0).floor() % 60.0, of_day % 60.0);
    let time = format!("{hour:02}:{minute:02}:{second:02}");
    if days == 0.0 {
        return time;
    }
    let (year, month, day) = civil(days);
    format!("{year:04}-{month:02}-{day:02} {time}")
}

/// Converts the number of a day, days since 1970, to year, month and day (algorithm of Hinnant, as in `number_of_day`).
fn civil(days: f64) -> (f64, f64, f64) {
    let days = days + 719_468.0;
    let era = (days / 146_097.0).floor();
    let of_era = days - era * 146_097.0;
    let year_of_era =
        ((of_era - (of_era / 1460.0).floor() + (of_era / 36_524.0).floor() - (of_era / 146_096.0).floor()) / 365.0)
            .floor();
    let of_year = of_era - (365.0 * year_of_era + (year_of_era / 4.0).floor() - (year_of_era / 100.0).floor());
    let from_march = ((5.0 * of_year + 2.0) / 153.0).floor();
    let day = of_year - ((153.0 * from_march + 2.0) / 5.0).floor() + 1.0;
    let month = if from_march < 10.0 { from_march + 3.0 } else { from_march - 9.0 };
    (year_of_era + era * 400.0 + f64::from(u8::from(month <= 2.0)), month, day)
}

/// Exchanges day and month of a time, s since 1970. Returns `None` if there is no date or the exchange gives an invalid
/// date.
pub(crate) fn swapped(seconds: f64) -> Option<f64> {
    if !(seconds >= DAY && seconds.is_finite()) {
        return None;
    }
    let days = (seconds / DAY).floor();
    let (year, month, day) = civil(days);
    Some(number_of_day(year, day, month)? * DAY + (seconds - days * DAY))
}

/// Reads a time of day, with or without a date: `12:34:56.789`, `34:56.789`, `2024-03-01 12:34:56,789`, `01.03.2024
/// 12:34:56`, `3/1/2024 1:05:09 PM`, `2024-03-01T12:34:56Z`.
///
/// With a date, the result is in seconds since 1970. Without a date, it is in seconds since midnight. Returns `None`
/// for any other text.
pub fn seconds(text: &str) -> Option<f64> {
    /// Longest text of a time, bytes, including a date and the name of a day. A longer text is not a time.
    const LONGEST: usize = 100;
    if text.len() > LONGEST {
        return None;
    }
    let text = text.trim().trim_end_matches('Z');
    let (text, half) = match text.get(text.len().saturating_sub(2)..).map(str::to_ascii_uppercase).as_deref() {
        Some("AM") => (text[..text.len() - 2].trim_end(), Some(0.0)),
        Some("PM") => (text[..text.len() - 2].trim_end(), Some(12.0)),
        _ => (text, None),
    };
    let (date, time) = match text.rsplit_once([' ', 'T']) {
        Some((date, time)) => (Some(date.trim()), time),
        None => (None, text),
    };
    // Spreadsheets write the time of a run as minutes and seconds. The decimals distinguish such a time from hours and
    // minutes.
    if let (None, None, Some((minutes, seconds))) = (date, half, time.split_once(':'))
        && seconds.contains(['.', ','])
        && !seconds.contains(':')
        && seconds.starts_with(|c: char| c.is_ascii_digit())
    {
        let seconds = seconds.replace(',', ".").parse::<f64>().ok().filter(|s| *s < 60.0)?;
        return Some(whole(minutes)? * 60.0 + seconds);
    }
    let mut parts = time.split(':');
    let mut hours: f64 = whole(parts.next()?)?;
    let minutes = whole(parts.next()?)?;
    let seconds = match parts.next() {
        Some(text) if text.starts_with(|c: char| c.is_ascii_digit()) => text.replace(',', ".").parse::<f64>().ok()?,
        Some(_) => return None,
        // `12:34` alone may also be minutes and seconds, so it is not read. With a date, the text is a time of day.
        None if date.is_some() => 0.0,
        None => return None,
    };
    if parts.next().is_some() || minutes >= 60.0 || !(0.0..61.0).contains(&seconds) {
        return None;
    }
    if let Some(half) = half {
        hours = hours % 12.0 + half;
    }
    let days = match date {
        Some(date) => day(date)?,
        None => 0.0,
    };
    Some(days * DAY + hours * 3600.0 + minutes * 60.0 + seconds)
}

fn whole(text: &str) -> Option<f64> {
    (!text.is_empty() && text.len() <= 4 && text.bytes().all(|b| b.is_ascii_digit())).then(|| text.parse().ok())?
}

/// A date, and its alternative reading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Date {
    /// Number of the day, days since 1970.
    pub number: f64,
    /// Order of day and month with which the date was read. `None` if the order is unambiguous: the year comes first,
    /// points separate the parts, or day and month are equal.
    pub order: Option<DateOrder>,
    /// Number of the day with day and month exchanged, if the exchange gives a valid and different date.
    pub other: Option<f64>,
}

/// Returns the number of a day, days since 1970, as read by [`date`].
fn day(text: &str) -> Option<f64> {
    date(text).map(|date| date.number)
}

/// Reads a date from year, month and day. The separators determine the order. With points, the day comes first. With
/// slashes, the month comes first if possible, as in America. With hyphens, the day comes first if possible. A number
/// above 31 at the beginning is the year. The module `campaign::date_agreement` then selects the order for the
/// campaign.
pub(crate) fn date(text: &str) -> Option<Date> {
    let separator = text.chars().find(|c| !c.is_ascii_digit()).filter(|c| "-./".contains(*c))?;
    let parts: Vec<f64> = text.split(separator).map(whole).collect::<Option<_>>()?;
    let &[a, b, c] = parts.as_slice() else { return None };
    if a > 31.0 {
        return Some(Date { number: number_of_day(a, b, c)?, order: None, other: None });
    }
    let (day_first, month_first) = (number_of_day(c, b, a), number_of_day(c, a, b));
    let (number, order, other) = match (separator, day_first, month_first) {
        ('.', Some(number), _) => return Some(Date { number, order: None, other: None }),
        ('/', other, Some(number)) => (number, DateOrder::MonthFirst, other),
        ('/' | '-', Some(number), other) => (number, DateOrder::DayFirst, other),
        ('-', None, Some(number)) => (number, DateOrder::MonthFirst, None),
        _ => return None,
    };
    Some(Date { number, order: Some(order).filter(|_| a != b), other: other.filter(|_| a != b) })
}

/// Returns the number of the day of a civil date, days since 1970 (Hinnant, chrono-compatible low-level date
/// algorithms, 2013). Returns `None` if month or day is out of range.
fn number_of_day(year: f64, month: f64, day: f64) -> Option<f64> {
    if !(1.0..=12.0).contains(&month) || !(1.0..=31.0).contains(&day) {
        return None;
    }
    let year = year - f64::from(u8::from(month <= 2.0));
    let era = (year / 400.0).floor();
    let of_era = year - 400.0 * era;
    let of_year = ((153.0 * (month + if month > 2.0 { -3.0 } else { 9.0 }) + 2.0) / 5.0).floor() + day - 1.0;
    let days = era * 146_097.0 + of_era * 365.0 + (of_era / 4.0).floor() - (of_era / 100.0).floor() + of_year;
    Some(days - 719_468.0)
}

/// Makes times of day relative to the first one and returns the first. A backward step of more than half a day means
/// that midnight has passed. Returns `None` if no time is finite.
pub(crate) fn from_first(times: &mut [f64]) -> Option<f64> {
    let &first = times.iter().find(|t| t.is_finite())?;
    let (mut before, mut midnights) = (first, 0.0);
    for time in times {
        if !time.is_finite() {
            continue;
        }
        if *time - before < -0.5 * DAY {
            midnights += DAY;
        }
        before = *time;
        *time += midnights - first;
    }
    Some(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_of_day_are_read_with_and_without_dates() {
        assert_eq!(seconds("12:34:56.5"), Some(45_296.5));
        assert_eq!(seconds("12:34:56,5"), Some(45_296.5));
        assert_eq!(seconds("34:56.5"), Some(2096.5));
        assert_eq!(seconds("0:06,25"), Some(6.25));
        assert_eq!(seconds("1:05:09 PM"), Some(47_109.0));
        assert_eq!(seconds("12:00:00 AM"), Some(0.0));
        let first = seconds("2024-02-28 23:59:59").unwrap();
        for (text, later) in [
            ("2024-02-29T00:00:00Z", 1.0),
            ("29.02.2024 00:00:00", 1.0),
            ("2/29/2024 12:00:00 AM", 1.0),
            ("2024/03/01 00:00:00.25", 86_401.25),
        ] {
            assert!((seconds(text).unwrap() - first - later).abs() < 1e-6, "{text}");
        }
        for text in [
            "",
            "12:34",
            "1.5",
            "a:b:c",
            "12:75:00",
            "12:75.5",
            "12:.5",
            "12:34:56:78",
            "32.13.2024 00:00:00",
            "12:34:-5",
            "time",
        ] {
            assert_eq!(seconds(text), None, "{text}");
        }
    }

    #[test]
    fn a_time_since_1970_is_written_and_read_back() {
        assert_eq!(seconds("1970-01-01 00:00:00"), Some(0.0));
        assert_eq!(written(36_001.5), "10:00:01");
        assert_eq!(seconds("2001-09-09T01:46:40Z"), Some(1e9));
        for text in ["2024-02-29 23:59:59", "2000-03-01 00:00:00", "1999-12-31 12:00:01", "2026-11-25 10:03:22"] {
            assert_eq!(written(seconds(text).unwrap()), text);
        }
    }

    #[test]
    fn when_a_test_began_is_found_above_its_table() {
        let at = |text: &str| begins(text.lines()).map(|began| written(began.at));
        let wanted = Some("2026-11-25 10:03:22".to_owned());
        for text in [
            "Operator\tmh\nDate\t25.11.2026\nTime\t10:03:22\nRate\t1000",
            "Data Acquisition: Timed\tTime: 3.2451172 Sec\t11/25/2026 10:03:22 AM",
            "# run 7, 2026-11-25T10:03:22",
            "Datum;25.11.2026\nUhrzeit;10:03:22,5",
            "Created 1.1.2020\nStart: 25.11.2026 10:03:22\nEnd: 25.11.2026 10:09:01",
        ] {
            assert_eq!(at(text), wanted, "{text}");
        }
        for text in ["", "Time: 10:03:22", "Date: 25.11.2026", "1.2.3\t12:75:00", "Part no. 4-11-2026x\t10:03:22"] {
            assert_eq!(at(text), None, "{text}");
        }
    }

    #[test]
    fn midnight_is_no_step_back() {
        let mut times = vec![86_399.0, 86_399.5, 0.0, 0.5, f64::NAN, 1.0];
        from_first(&mut times);
        assert_eq!(times[..4], [0.0, 0.5, 1.0, 1.5]);
        assert_eq!(times[5], 2.0);
    }
}
