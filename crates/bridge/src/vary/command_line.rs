//! Ranges as the command line has them: `joint.friction_angle=30deg..40deg:5`, `analysis.damping=local,viscous`.

use toml_edit::Value;

use super::spread::of_values;
use super::{Request, Slip, Spread, find};
use crate::card::Kind;
use crate::edit::Document;
use crate::tree::shorten;

/// Reads `PATH=a,b,c`, `PATH=FROM..TO:POINTS` or `PATH=FROM..TO:POINTS:geometric`.
///
/// # Errors
/// A path that leads to no quantity (B501, B502), or values that are in none of these forms (B503).
pub fn parse_setting(document: &Document, text: &str) -> Result<Request, Slip> {
    let wrong = |message: String| {
        let help = "write joint.friction_angle=30deg..40deg:5, or values with commas: analysis.damping=local,viscous";
        Slip { label: String::new(), ..of_values(message, help) }
    };
    let (path, values) =
        text.split_once('=').ok_or_else(|| wrong(format!("`{}` has no values behind an =", shorten(text))))?;
    let (path, values) = (path.trim(), values.trim());
    let quantity = find(document, path)?;
    let bare = matches!(quantity.field.kind, Kind::Number | Kind::Count | Kind::Flag);
    let literal = |word: &str| {
        let word = word.trim();
        // A relative value is text whatever it is relative to.
        let plain = bare && !word.starts_with('x') && !word.ends_with('%');
        if plain { word.to_owned() } else { Value::from(word).to_string() }
    };
    let spread = match values.split_once("..") {
        None => Spread::List(values.split(',').map(literal).collect()),
        Some((from, rest)) => {
            let (rest, geometric) = match rest.strip_suffix(":geometric") {
                Some(rest) => (rest, true),
                None => (rest, false),
            };
            let points = rest.rsplit_once(':').and_then(|(to, points)| Some((to, points.trim().parse::<u64>().ok()?)));
            let Some((to, points)) = points.filter(|(_, points)| (2..=1000).contains(points)) else {
                return Err(wrong(format!("`{}` does not end in a number of points from 2 to 1000", shorten(text))));
            };
            Spread::Range { from: literal(from), to: literal(to), points, geometric }
        }
    };
    Ok(Request { quantity: path.to_owned(), spread, places: None })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_and_ranges_are_read() {
        let document = Document::parse("[joint]\nfriction_angle = \"30 deg\"\n[dispersal]\nslope = \"2:1\"\n").unwrap();
        let spread = |text: &str| parse_setting(&document, text).map(|request| request.spread);
        let quoted = |words: &[&str]| Spread::List(words.iter().map(|word| format!("\"{word}\"")).collect());
        assert_eq!(spread("joint.friction_angle=30deg,40 deg"), Ok(quoted(&["30deg", "40 deg"])));
        assert_eq!(spread("analysis.seed=1,2"), Ok(Spread::List(vec!["1".into(), "2".into()])));
        assert_eq!(spread("dispersal.slope=2:1,1:1"), Ok(quoted(&["2:1", "1:1"])));
        let range = |from: &str, to: &str, points, geometric| Spread::Range {
            from: from.into(),
            to: to.into(),
            points,
            geometric,
        };
        assert_eq!(spread("joint.friction_angle=x0.5..x2:3:geometric"), Ok(range("\"x0.5\"", "\"x2\"", 3, true)));
        assert_eq!(spread("dispersal.slope=1:1..2:1:5"), Ok(range("\"1:1\"", "\"2:1\"", 5, false)));
        for text in ["joint.friction_angle", "joint.friction_angle=30deg..40deg", "joint.friction_angle=1deg..2deg:1"] {
            assert_eq!(spread(text).map_err(|slip| slip.code), Err("B503"), "{text}");
        }
        assert_eq!(spread("joint.friction=30deg").map_err(|slip| slip.code), Err("B501"));
    }
}
