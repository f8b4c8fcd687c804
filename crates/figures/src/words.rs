//! Values as they are written in figures: unit beside, no more digits than matter.

/// A number with four significant digits, without trailing zeros.
pub fn four_digits(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return if x == 0.0 { "0".into() } else { "–".into() };
    }
    let decimals = (3 - x.abs().log10().floor() as i32).clamp(0, 12) as usize;
    let text = format!("{x:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    text.replace('-', "−")
}

/// A length [m] to the millimetre, in millimetres below a tenth of a metre.
pub(crate) fn metres(x: f64) -> String {
    if x.abs() < 0.0995 {
        return format!("{} mm", three_digits(1e3 * x));
    }
    let text = format!("{x:.3}");
    format!("{} m", text.trim_end_matches('0').trim_end_matches('.'))
}

/// A force per metre of width [N/m], written in kN/m unless it is very small.
pub(crate) fn force(x: f64) -> String {
    if x.abs() < 100.0 && x != 0.0 {
        format!("{} N/m", four_digits(x))
    } else {
        format!("{} kN/m", four_digits(x / 1e3))
    }
}

/// A number with three significant digits.
pub(crate) fn three_digits(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return four_digits(x);
    }
    let unit = 10f64.powf(x.abs().log10().floor() - 2.0);
    four_digits((x / unit).round() * unit)
}

/// A unit as print has it: exponents raised.
pub(crate) fn raised(unit: &str) -> String {
    unit.replace("^2", "²").replace("^3", "³")
}

/// A name with its unit in brackets, as axes have it.
pub(crate) fn named(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name} [{}]", raised(unit)) }
}

/// A number with its unit.
pub(crate) fn with_unit(number: String, unit: &str) -> String {
    if unit.is_empty() { number } else { format!("{number} {}", raised(unit)) }
}

/// A factor by which something is drawn larger.
pub(crate) fn times(x: f64) -> String {
    format!("{} times", four_digits(x))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_that_matter() {
        assert_eq!(force(204_820.0), "204.8 kN/m");
        assert_eq!(force(-3_000.0), "−3 kN/m");
        assert_eq!(metres(18.3), "18.3 m");
        assert_eq!(metres(0.7114), "0.711 m");
        assert_eq!([metres(0.0049), metres(0.0), force(12.0)], ["4.9 mm", "0 mm", "12 N/m"]);
        assert_eq!(three_digits(1.08249), "1.08");
        assert_eq!([four_digits(0.0), four_digits(12345.6), four_digits(0.00123)], ["0", "12346", "0.00123"]);
        assert_eq!(four_digits(100.0), "100");
    }
}
