//! The font of every figure. It is embedded, so that text is as wide on a machine without any font as on ours.

use super::Style;
use std::sync::LazyLock;
use ttf_parser::Face;

/// What figures ask for; Verdana has nearly the same widths, where a viewer has no DejaVu.
pub(crate) const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";

/// The two font files, for the rasteriser.
pub(crate) fn files() -> [&'static [u8]; 2] {
    [dejavu::sans::regular(), dejavu::sans::bold()]
}

/// Height of capital letters and digits over the font size.
pub(crate) const CAPITAL: f64 = 0.73;
/// Depth of descending letters over the font size.
pub(crate) const DESCENT: f64 = 0.24;

static REGULAR: LazyLock<Option<Face<'static>>> = LazyLock::new(|| Face::parse(dejavu::sans::regular(), 0).ok());
static BOLD: LazyLock<Option<Face<'static>>> = LazyLock::new(|| Face::parse(dejavu::sans::bold(), 0).ok());

impl Style {
    /// Width of a text, in the unit of its size. Kerning is left out: it would narrow a line by a few thousandths.
    pub(crate) fn width(&self, text: &str) -> f64 {
        let face = if self.bold { &BOLD } else { &REGULAR };
        let Some(face) = face.as_ref() else { return 0.7 * self.size * text.chars().count() as f64 };
        let em = f64::from(face.units_per_em());
        let advance = |c: char| {
            let glyph = face.glyph_index(c).unwrap_or_default();
            f64::from(face.glyph_hor_advance(glyph).unwrap_or(0)) / em
        };
        text.chars().map(advance).sum::<f64>() * self.size
    }

    /// Breaks a text into lines no wider than `limit`, at spaces; a single longer word is cut.
    pub(crate) fn wrap(&self, text: &str, limit: f64) -> Vec<String> {
        let mut lines: Vec<String> = Vec::new();
        let mut line = String::new();
        for word in text.split_whitespace() {
            let longer = if line.is_empty() { word.to_string() } else { format!("{line} {word}") };
            if self.width(&longer) <= limit {
                line = longer;
                continue;
            }
            if !line.is_empty() {
                lines.push(std::mem::take(&mut line));
            }
            for c in word.chars() {
                line.push(c);
                if line.chars().count() > 1 && self.width(&line) > limit {
                    line.pop();
                    lines.push(std::mem::take(&mut line));
                    line.push(c);
                }
            }
        }
        if !line.is_empty() {
            lines.push(line);
        }
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_equally_wide_and_bold_is_wider() {
        let plain = Style::default();
        assert_eq!(plain.width("11111"), plain.width("04826"));
        assert!(Style { bold: true, ..plain }.width("springing") > plain.width("springing"));
    }

    #[test]
    fn no_line_is_wider_than_asked_and_no_letter_is_lost() {
        let text = "The mechanism of an arch with averyveryverylongwordthatfitsnowhere in it";
        let lines = Style::small().wrap(text, 120.0);
        assert!(lines.len() > 3);
        for line in &lines {
            assert!(Style::small().width(line) <= 120.0, "{line}");
        }
        let letters = |s: &str| s.chars().filter(|c| !c.is_whitespace()).collect::<String>();
        assert_eq!(letters(&lines.concat()), letters(text));
    }
}
