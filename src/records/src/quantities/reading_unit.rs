//! Practical units in which reports show quantities stored in SI units.

/// Returns the factor from the SI unit to the practical unit, and the practical unit. If `size` is below one, lengths,
/// times and speeds are in thousandths, such as mm. Stiffnesses are per millimeter. `size` is the largest value of a
/// table or plot.
pub fn reading_unit(size: f64, si: &str) -> (f64, String) {
    let small = size.abs() < 1.0;
    match si {
        "m" if small => (1e3, "mm".into()),
        "s" if small => (1e3, "ms".into()),
        "m/s" if small => (1e3, "mm/s".into()),
        "N/m" => (1e-3, "N/mm".into()),
        "N/m^3" => (1e-9, "N/mm³".into()),
        "-" => (1.0, String::new()),
        _ => {
            let raised = ["^2", "^3", "^4"].iter().zip(["²", "³", "⁴"]);
            (1.0, raised.fold(si.replace(' ', "\u{b7}"), |text, (from, to)| text.replace(from, to)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::reading_unit;

    #[test]
    fn lengths_of_a_damper_are_read_in_millimetres() {
        let of = |size, si| reading_unit(size, si);
        assert_eq!(of(2.24e-4, "m"), (1e3, "mm".into()));
        assert_eq!(of(3.5, "m"), (1.0, "m".into()));
        assert_eq!(of(2e6, "N/m"), (1e-3, "N/mm".into()));
        assert_eq!(of(0.3, "-"), (1.0, String::new()));
        assert_eq!(of(70.0, "N s^2/m^2"), (1.0, "N·s²/m²".into()));
    }
}
