//! Numbers as people read them.

/// Three significant digits, more where they stand before the point; a true minus sign.
pub(crate) fn digits(value: f64) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    if value.abs() >= 1e15 {
        return "beyond all bounds".to_owned();
    }
    let size = value.abs();
    let decimals = match size {
        0.0 => 0,
        s if s >= 100.0 => 0,
        s => (2.0 - s.log10().floor()).clamp(0.0, 6.0) as usize,
    };
    let text = format!("{value:.decimals$}");
    // Minus nothing is nothing.
    let text = if text.trim_start_matches(['-', '0', '.']).is_empty() { text.replace('-', "") } else { text };
    text.replace('-', "−")
}

/// Likewise with its unit.
pub(crate) fn with_unit(value: f64, unit: &str) -> String {
    if unit.is_empty() { digits(value) } else { format!("{} {unit}", digits(value)) }
}

/// A number that may be missing.
pub(crate) fn maybe(value: Option<f64>) -> String {
    value.map_or("–".to_owned(), digits)
}

/// A share in per cent.
pub(crate) fn percent(share: f64) -> String {
    match 100.0 * share {
        p if p >= 1e5 => "far above 100 %".to_owned(),
        p if p < 0.05 => "0 %".to_owned(),
        p if p < 10.0 => format!("{p:.1} %"),
        p => format!("{p:.0} %"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_three_digits() {
        let shown: Vec<String> = [1234.5, -0.5849, 12.345, 0.001234, 0.0, -1e-9, f64::NAN].map(digits).to_vec();
        assert_eq!(shown, ["1234", "−0.585", "12.3", "0.00123", "0", "0.000000", "–"]);
        assert_eq!(
            (percent(0.464), percent(f64::MAX), percent(0.0123)),
            ("46 %".into(), "far above 100 %".into(), "1.2 %".into())
        );
    }
}
