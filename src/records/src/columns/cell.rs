//! Numbers in the cells of a table.

/// Reads a number. `decimal_comma` also allows a decimal comma. Empty and not-a-number cells give NaN. Other texts give
/// `None`.
pub(crate) fn number(text: &str, decimal_comma: bool) -> Option<f64> {
    let text = text.trim();
    if let Ok(value) = text.parse::<f64>() {
        return Some(if value.is_finite() { value } else { f64::NAN });
    }
    // Handle a typographic minus sign, and the exponents that Fortran writes.
    if let Some(plain) = text.strip_prefix('\u{2212}') {
        return number(plain, decimal_comma).map(|value| -value);
    }
    if let Some((mantissa, exponent)) = text.split_once(['D', 'd'])
        && let (Some(mantissa), Ok(exponent)) = (number(mantissa, decimal_comma), exponent.parse::<i32>())
        && mantissa.is_finite()
    {
        return format!("{mantissa}e{exponent}").parse().ok().filter(|v: &f64| v.is_finite());
    }
    if ["", "-", "--", "n/a", "na", "#n/a", "null", "#num!", "1.#qnan", "-1.#ind"]
        .iter()
        .any(|empty| text.eq_ignore_ascii_case(empty))
    {
        return Some(f64::NAN);
    }
    if decimal_comma && text.bytes().filter(|&b| b == b',').count() == 1 && !text.contains('.') {
        return text.replace(',', ".").parse().ok().filter(|v: &f64| v.is_finite());
    }
    None
}
