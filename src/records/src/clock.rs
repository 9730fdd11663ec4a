//! Time columns that hold the time of day, with or without the date.

/// Seconds of a day.
const DAY: f64 = 86_400.0;

/// Reads `12:34:56.789`, `34:56.789`, `2024-03-01 12:34:56,789`, `01.03.2024 12:34:56`, `3/1/2024 1:05:09 PM`, `2024-03-01T12:34:56Z`:
/// seconds from an arbitrary but fixed midnight. Nothing where the text is no such time.
pub(crate) fn seconds(text: &str) -> Option<f64> {
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
    // Minutes and seconds, as a spreadsheet shows the time of a run: the decimals tell them from hours and minutes.
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
        // `12:34` alone may be minutes and seconds as well; with a date it is a time of day.
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

/// Number of a day, from year, month and day in the orders that the separators tell.
fn day(date: &str) -> Option<f64> {
    let separator = date.chars().find(|c| !c.is_ascii_digit()).filter(|c| "-./".contains(*c))?;
    let parts: Vec<f64> = date.split(separator).map(whole).collect::<Option<_>>()?;
    let &[a, b, c] = parts.as_slice() else { return None };
    let (year, month, day) = match separator {
        _ if a > 31.0 => (a, b, c),
        // Month first in America; a first number above 12 can only be a day.
        '/' if a <= 12.0 => (c, a, b),
        _ => (c, b, a),
    };
    if !(1.0..=12.0).contains(&month) || !(1.0..=31.0).contains(&day) {
        return None;
    }
    // Days from civil date (Hinnant, chrono-compatible low-level date algorithms, 2013).
    let year = year - f64::from(u8::from(month <= 2.0));
    let era = (year / 400.0).floor();
    let of_era = year - 400.0 * era;
    let of_year = ((153.0 * (month + if month > 2.0 { -3.0 } else { 9.0 }) + 2.0) / 5.0).floor() + day - 1.0;
    Some(era * 146_097.0 + of_era * 365.0 + (of_era / 4.0).floor() - (of_era / 100.0).floor() + of_year)
}

/// Times of day as seconds from the first one on; a step back by most of a day is midnight.
pub(crate) fn from_first(times: &mut [f64]) {
    let Some(&first) = times.iter().find(|t| t.is_finite()) else { return };
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
    fn midnight_is_no_step_back() {
        let mut times = vec![86_399.0, 86_399.5, 0.0, 0.5, f64::NAN, 1.0];
        from_first(&mut times);
        assert_eq!(times[..4], [0.0, 0.5, 1.0, 1.5]);
        assert_eq!(times[5], 2.0);
    }
}
