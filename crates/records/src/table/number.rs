//! What stands in a cell.

/// A cell, read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Cell {
    /// A finite number, and its decimals where it has no exponent.
    Number(f64, Option<usize>),
    /// Nothing, or a word for it.
    Empty,
    /// NaN or infinite, or beyond the range of numbers.
    NotFinite,
    /// Anything else.
    Text,
}

/// Words by which loggers and spreadsheets say that there is no number.
const NOTHING: [&str; 6] = ["", "-", "na", "n/a", "#n/a", "null"];
/// Words for what is no number.
const NOT_FINITE: [&str; 8] = ["nan", "-nan", "inf", "-inf", "+inf", "infinity", "-infinity", "#div/0!"];

/// Reads a cell whose decimal mark is a comma or a point.
pub(super) fn cell(text: &str, decimal_comma: bool) -> Cell {
    let text = text.trim();
    let plain = text.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.' | b',' | b'e' | b'E'));
    if plain && text.len() >= 2 {
        return number(text, decimal_comma);
    }
    match text.to_lowercase().as_str() {
        word if NOTHING.contains(&word) => Cell::Empty,
        word if NOT_FINITE.contains(&word) => Cell::NotFinite,
        _ if text.len() == 1 => number(text, decimal_comma),
        _ => Cell::Text,
    }
}

fn number(text: &str, decimal_comma: bool) -> Cell {
    let mark = if decimal_comma { b',' } else { b'.' };
    let other = if decimal_comma { b'.' } else { b',' };
    // A mark of the other kind would be one of thousands: 1.234 may be a thousand or one, so it is not guessed.
    if text.bytes().any(|byte| byte == other) {
        return Cell::Text;
    }
    let parsed = if decimal_comma { text.replace(',', ".").parse::<f64>() } else { text.parse::<f64>() };
    let has_exponent = text.bytes().any(|byte| matches!(byte, b'e' | b'E'));
    let decimals = || text.bytes().rposition(|byte| byte == mark).map_or(0, |at| text.len() - at - 1);
    match parsed {
        Ok(number) if number.is_finite() => Cell::Number(number, (!has_exponent).then(decimals)),
        Ok(_) => Cell::NotFinite,
        Err(_) => Cell::Text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_numbers_or_say_why_not() {
        assert_eq!(cell(" -0.30 ", false), Cell::Number(-0.3, Some(2)));
        assert_eq!(cell("-0,30", true), Cell::Number(-0.3, Some(2)));
        assert_eq!(cell("7", false), Cell::Number(7.0, Some(0)));
        assert_eq!(cell("1e-3", false), Cell::Number(1e-3, None));
        assert_eq!(cell("0,30", false), Cell::Text);
        assert_eq!(cell("1.234,5", true), Cell::Text);
        assert_eq!(cell("0.3x", false), Cell::Text);
        assert_eq!(cell("--3", false), Cell::Text);
        assert_eq!(cell("e", false), Cell::Text);
        assert_eq!(cell("", false), Cell::Empty);
        assert_eq!(cell("NaN", false), Cell::NotFinite);
        assert_eq!(cell("-Inf", false), Cell::NotFinite);
        assert_eq!(cell("1e999", false), Cell::NotFinite);
    }
}
