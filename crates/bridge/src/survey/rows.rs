//! Tables of numbers, as spreadsheets and other programs have them, read as answers of a survey: a name, a value, a unit on each line.

use super::names::{Named, is_unit, named};
use super::questions::{FILL_COHESION, OTHERS};
use super::{MORE, PIER, QUESTIONS, Question};
use crate::quantity::{self, Unreadable};

/// A line that answers a question.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Taken {
    /// Its number, from 1.
    pub line: usize,
    /// The name that it has.
    pub name: String,
    /// The question: `span`, `rise_2`.
    pub key: String,
    /// The answer, with its unit where it has one.
    pub text: String,
    /// What was assumed in reading it; empty where nothing was.
    pub assumed: String,
}

/// A line that answers none.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Left {
    /// Its number, from 1.
    pub line: usize,
    /// What stands there.
    pub text: String,
    /// Why it was not taken.
    pub why: String,
    /// What to write instead.
    pub help: String,
}

/// What a table says.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Rows {
    /// Lines that answer a question, in their order.
    pub taken: Vec<Taken>,
    /// Lines with a value that do not.
    pub left: Vec<Left>,
}

impl Rows {
    /// The answer to a question.
    pub fn answer(&self, key: &str) -> Option<String> {
        self.of(key).map(|taken| taken.text.clone())
    }

    /// The line that answers a question.
    pub fn of(&self, key: &str) -> Option<&Taken> {
        self.taken.iter().find(|taken| taken.key == key)
    }
}

/// Most of a line that is shown.
const SHOWN: usize = 80;

/// Whether a text is a table of named numbers, and no list of points: a line begins with a word and has a number after it, and none begins with a number.
pub fn is_table(text: &str) -> bool {
    let lines = || lines(text).map(|(_, line)| line.trim_start_matches(['"', ' ']));
    let starts = |line: &str| line.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    !lines().any(starts) && lines().any(|line| split(line, between(text)).is_some_and(|cells| cells[1].contains(digit)))
}

/// What a table says: two or three columns, name, value and unit, separated by tabs, semicolons, commas or blanks, or as `name = value`. A value
/// may have its unit, or the name may have it in brackets; a number without one is in the unit of its question, which is told.
pub fn rows(text: &str) -> Rows {
    let mut rows = Rows::default();
    let mut square = None;
    let between = between(text);
    for (line, written) in lines(text) {
        // Titles, and headings over the columns.
        let Some([name, value, more]) = split(written, between).filter(|cells| !is_heading(cells)) else { continue };
        let leave = |why: String, help: String| Left { line, text: written.chars().take(SHOWN).collect(), why, help };
        let (key, coefficient) = match named(&name) {
            Named::Question { key, coefficient, square: is_square } => {
                square = square.or(is_square.then_some(line));
                (key, coefficient)
            }
            Named::Elsewhere(how) => {
                rows.left.push(leave("not asked by a survey".to_owned(), format!("into the bridge file: {how}")));
                continue;
            }
            Named::Unknown => {
                let help = "use a name of docs/input/other-programs.md, or write it into the bridge file".to_owned();
                rows.left.push(leave(format!("no question of a survey is called \"{name}\""), help));
                continue;
            }
        };
        if let Some(known) = rows.of(&key) {
            rows.left.push(leave(format!("line {} answers {key} already", known.line), "keep one of both".to_owned()));
            continue;
        }
        match valued(&key, &name, &value, &more, coefficient) {
            Ok((text, assumed)) => rows.taken.push(Taken { line, name, key, text, assumed }),
            Err((why, help)) => rows.left.push(leave(why, help)),
        }
    }
    if let (Some(line), Some(_)) = (square, rows.of("skew"))
        && let Some(at) = rows.taken.iter().position(|taken| taken.line == line)
    {
        let taken = rows.taken.remove(at);
        rows.left.push(Left {
            line,
            text: format!("{}: {}", taken.name, taken.text),
            why: "a square span of a skew bridge".to_owned(),
            help: "write span as it is along the road, or square_span into [[span]] of the file".to_owned(),
        });
    }
    rows
}

/// The lines that say something, with their numbers from 1.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let text = text.trim_start_matches('\u{feff}');
    text.lines()
        .enumerate()
        .map(|(k, line)| (k + 1, line.trim()))
        .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
}

fn digit(c: char) -> bool {
    c.is_ascii_digit()
}

/// What stands between the cells of a table, where it is a mark: a comma only where nothing else does.
fn between(text: &str) -> Option<char> {
    ['\t', ';', ','].into_iter().find(|mark| lines(text).any(|(_, line)| line.contains(*mark)))
}

/// Name, value and what stands behind it; none where there is no value.
fn split(line: &str, between: Option<char>) -> Option<[String; 3]> {
    let cells: Vec<String> = match between.filter(|mark| line.contains(*mark)) {
        Some(mark) => cells(line, mark),
        None => {
            let marked = line.split_once('=').or_else(|| line.split_once(": ")).or_else(|| line.split_once("  "));
            let (name, value) = marked.or_else(|| {
                let at = line.match_indices(' ').find(|(at, _)| line[at + 1..].starts_with(digit))?.0;
                Some((&line[..at], &line[at + 1..]))
            })?;
            vec![name.trim().to_owned(), value.trim().to_owned()]
        }
    };
    let mut cells = cells.into_iter();
    let [name, value, more] = std::array::from_fn(|_| cells.next().unwrap_or_default());
    let named = name.starts_with(|c: char| c.is_alphabetic()) && !value.is_empty();
    named.then(|| [name.trim_end_matches([':', '=', ' ']).to_owned(), value, more])
}

/// The cells of a line; one in quotation marks may hold what separates them.
fn cells(line: &str, mark: char) -> Vec<String> {
    let mut cells = Vec::new();
    let mut rest = line.trim_start();
    loop {
        let quoted = rest.strip_prefix('"').and_then(|inner| {
            let end = inner.find(&format!("\"{mark}")).or_else(|| inner.strip_suffix('"').map(str::len))?;
            Some((&inner[..end], &inner[end + 1..]))
        });
        let (cell, after) = match quoted {
            Some((cell, after)) => (cell.replace("\"\"", "\""), after.strip_prefix(mark)),
            None => match rest.split_once(mark) {
                Some((cell, after)) => (cell.to_owned(), Some(after)),
                None => (rest.to_owned(), None),
            },
        };
        cells.push(cell.trim().to_owned());
        match after {
            Some(after) => rest = after.trim_start_matches(' '),
            None => return cells,
        }
    }
}

/// A line over the columns.
fn is_heading(cells: &[String; 3]) -> bool {
    const HEADS: [&str; 10] =
        ["value", "values", "unit", "units", "measured", "quantity", "amount", "number", "result", "input"];
    let value = cells[1].to_lowercase();
    HEADS.iter().any(|head| value.split([' ', '[', '(']).next() == Some(*head)) && !value.contains(digit)
}

/// The answer in the text of a cell, and what was assumed in reading it; else why there is none, and what to write.
fn valued(
    key: &str,
    name: &str,
    value: &str,
    more: &str,
    coefficient: bool,
) -> Result<(String, String), (String, String)> {
    if ["name", "reference", "rule", "vehicles", "profile"].contains(&key) {
        return match key {
            "profile" => shape(value).map(|word| (word.to_owned(), String::new())),
            _ => Ok((value.to_owned(), String::new())),
        };
    }
    let thousands = value.split_once(',').is_some_and(|(whole, rest)| {
        let first = whole.trim_start_matches(['+', '-']);
        let three = rest.chars().take_while(|c| digit(*c)).count() == 3;
        three && first != "0" && !first.is_empty() && first.len() <= 3 && first.chars().all(digit)
    });
    if thousands || more.starts_with(digit) {
        let why = "a comma that may stand for thousands or for a decimal point".to_owned();
        return Err((why, format!("write {} with a point, such as 1200 or 0.45", quoted(value, more))));
    }
    // A decimal comma.
    let value = match value.find(',') {
        Some(at) if value[at + 1..].starts_with(digit) => value.replacen(',', ".", 1),
        _ => value.to_owned(),
    };
    let question = question(key);
    let (unit, example) = question.map_or(("", "1"), |question| (question.unit, question.example));
    let help = || format!("write {name}; {example}");
    let is_number = value.parse::<f64>().is_ok();
    if coefficient {
        return match value.parse::<f64>() {
            Ok(ratio) if ratio > 0.0 && ratio < 3.0 => {
                let angle = (100.0 * ratio.atan().to_degrees()).round() / 100.0;
                Ok((format!("{angle} deg"), format!("the angle of friction whose tangent is {value}")))
            }
            _ => Err((
                format!("\"{value}\" is no coefficient of friction"),
                "write such as 0.6, or an angle in deg".to_owned(),
            )),
        };
    }
    if unit.is_empty() {
        return Ok((value, String::new()));
    }
    let told = [bracketed(name), Some(more)]
        .into_iter()
        .flatten()
        .map(str::trim)
        .find(|unit| !unit.is_empty() && *unit != "-");
    let text = match told.filter(|_| is_number) {
        Some(told) => format!("{value} {told}"),
        None if is_number => return Ok((format!("{value} {unit}"), format!("without a unit: taken in {unit}"))),
        None => value,
    };
    match quantity::parse(&text) {
        Ok(_) => Ok((text, String::new())),
        Err(Unreadable::UnknownUnit(number, written, Some(near))) if is_unit(&written) => {
            Ok((format!("{number} {}", near.symbol), format!("{written} is read as {}", near.symbol)))
        }
        Err(Unreadable::UnknownUnit(_, written, _)) => Err((format!("\"{written}\" is no unit that is known"), help())),
        Err(_) => Err((format!("\"{text}\" is no number with a unit"), help())),
    }
}

/// A number as it was written; its decimals where a comma cut them off.
fn quoted(value: &str, more: &str) -> String {
    if more.starts_with(digit) { format!("\"{value},{more}\"") } else { format!("\"{value}\"") }
}

/// The unit that a name has in brackets.
fn bracketed(name: &str) -> Option<&str> {
    let inside = &name[name.rfind(['(', '['])? + 1..];
    let unit = &inside[..inside.find([')', ']'])?];
    is_unit(unit).then_some(unit)
}

fn question(key: &str) -> Option<&'static Question> {
    let first = key.trim_end_matches(|c: char| digit(c)).trim_end_matches('_');
    QUESTIONS
        .iter()
        .chain(&MORE)
        .chain(&OTHERS)
        .chain(&PIER)
        .chain([&FILL_COHESION])
        .find(|question| question.key == key || question.key == first)
}

/// The word of a shape in bridge files.
fn shape(said: &str) -> Result<&'static str, (String, String)> {
    const SHAPES: [(&str, &[&str]); 4] = [
        ("segmental", &["segment", "circular", "arc of a circle", "semicircular", "semi circular", "half circle"]),
        ("parabolic", &["parabola"]),
        ("elliptical", &["ellipse", "semi elliptical", "elliptic", "half ellipse"]),
        ("pointed", &["gothic", "pointed segmental"]),
    ];
    let plain = said.to_lowercase().replace(['-', '_'], " ");
    let known = SHAPES.iter().find(|(word, others)| *word == plain || others.contains(&plain.as_str()));
    known.map(|(word, _)| *word).ok_or_else(|| {
        let help = "write segmental, semicircular, parabolic, elliptical or pointed; three-centred and surveyed shapes are written into \
                    the file: profile in [[span]]";
        (format!("\"{said}\" is no shape that a survey has"), help.to_owned())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Severity;
    use crate::survey::{file, findings};

    const SHEET: &str = "Bridge\tMill Lane\nClear span\t6000\tmm\nRise at crown (m)\t1,5\nArch ring thickness\t18\tin\n\
        Width between parapets: \t16' 6\"\nDepth of fill at crown\t0.5 m\nMasonry unit weight\t22\tkN/m3\nCrushing strength\t5\tN/mm2\n\
        Axle load\t11.5\tt\nMortar loss\t20\tmm\nColour\t7\n";

    #[test]
    fn a_pasted_table_is_the_bridge_that_it_describes() {
        assert!(is_table(SHEET) && !is_table("x [mm];y [mm]\n0;0\n1;2\n") && !is_table("0 1\n2 3\n"));
        let found = rows(SHEET);
        let text = file(&found.answer("name").unwrap(), &|key| found.answer(key)).unwrap();
        let bridge = crate::read(text.as_bytes()).bridge.unwrap_or_else(|| panic!("{text}"));
        let ring = &bridge.spans[0];
        for (value, wanted) in
            [(ring.span, 6.0), (ring.rise, 1.5), (bridge.width, 16.5 * 0.3048), (bridge.masonry.density, 22e3 / 9.81)]
        {
            assert!((value / wanted - 1.0).abs() < 1e-9, "{value} is not {wanted}\n{text}");
        }
        assert!(text.contains("thickness = \"18 in\"") && text.contains("axle_force = \"11.5 t\""), "{text}");
        let left: Vec<usize> = found.left.iter().map(|left| left.line).collect();
        assert_eq!(left, [10, 11], "{:?}", found.left);
        assert!(found.left[0].help.contains("[[defect]]") && found.left[1].why.contains("Colour"), "{:?}", found.left);
    }

    #[test]
    fn separators_units_and_spellings_of_one_bridge_make_one_file() {
        let forms = [
            "span;6;m\nrise;1.5;m\nthickness;0.45;m\nwidth;5;m\ncover;0.5;m\nfriction;30;deg\n",
            "Name,Value,Unit\nClear span,6,m\nRise,1.5,m\nRing thickness,0.45,m\nWidth,5,m\nFill depth at crown,0.5,m\nFriction angle,30,degrees\n",
            "Span = 6 m\nRise = 1.5 m\nBarrel thickness = 0.45 m\nBridge width = 5 m\nCover = 0.5 m\nphi = 30 deg\n",
            "Span: 6 m\nRise: 1.5 m\nArch depth: 0.45 m\nWidth: 5 m\nCover: 0.5 m\nAngle of friction: 30 °\n",
            "Span  6 m\nRise  1.5 M\nRing thickness  0.45 m\nWidth  5 m\nCover  0.5 m\nJoint friction  30 deg\n",
            "\"Span [m]\";\"6,0\"\n\"Rise [m]\";\"1,50\"\n\"Ring thickness (m)\";0,45\nWidth [m];5,00\nCover [m];0,50\nFriction [deg];30\n",
        ];
        let made: Vec<crate::Bridge> = forms
            .iter()
            .map(|form| {
                let found = rows(form);
                assert_eq!((found.left.len(), found.taken.len()), (0, 6), "{form}\n{found:?}");
                let text = file("x", &|key| found.answer(key)).unwrap();
                crate::read(text.as_bytes()).bridge.unwrap_or_else(|| panic!("{text}"))
            })
            .collect();
        assert!(made.iter().all(|one| format!("{one:?}") == format!("{:?}", made[0])));
    }

    #[test]
    fn what_other_programs_ask_beyond_the_ten_numbers_is_in_the_file() {
        let found = rows(
            "Span;9;m\nRise;3;m\nThickness;690;mm\nWidth;8;m\nFill depth at crown;300;mm\nShape;parabola\nNumber of rings;3\nNumber of blocks;40\n\
             Skew;10;deg\nFill unit weight;19;kN/m3\nBallast depth;0.3;m\nBallast unit weight;18;kN/m3\nBacking height;1.2;m\nBacking unit weight;21;kN/m3\n\
             Radial coefficient of friction;0.6\nTangential coefficient of friction;0.5\nFill angle of friction;32;deg\nFill cohesion;0;kPa\nStructure no;AB/12\n",
        );
        assert!(found.left.is_empty(), "{:?}", found.left);
        let text = file("x", &|key| found.answer(key)).unwrap();
        let read = crate::read(text.as_bytes());
        let errors: Vec<_> = read.diagnostics.iter().filter(|one| one.severity == Severity::Error).collect();
        assert!(errors.is_empty(), "{errors:?}\n{text}");
        for line in [
            "profile = \"parabolic\"",
            "thickness = \"230 mm\"",
            "voussoirs = 40",
            "skew = \"10 deg\"",
            "layer = \"surfacing\"",
            "density = \"18 kN/m3\"",
            "density = \"21 kN/m3\"",
            "friction_angle = \"30.96 deg\"",
            "friction_angle = \"26.57 deg\"",
            "[fill_pressure]",
            "structure_number = \"AB/12\"",
        ] {
            assert!(text.contains(line), "{line} is not in\n{text}");
        }
        assert_eq!(text.matches("[[span.ring]]").count(), 3);
    }

    #[test]
    fn what_cannot_be_read_is_told_at_its_line_with_what_to_write() {
        let found = rows(
            "Span;1,200;mm\nRise;high\nThickness;0.45;furlong\nWidth;5\nSquare span;6;m\nWidth;6;m\nCover;0.5 m\nSkew;20 deg\nSpan;7;m\n",
        );
        let left: Vec<(usize, &str)> = found.left.iter().map(|left| (left.line, left.why.as_str())).collect();
        assert_eq!(left.iter().map(|one| one.0).collect::<Vec<_>>(), [1, 2, 3, 6, 9, 5], "{left:?}");
        assert!(found.left.iter().all(|left| !left.help.is_empty()), "{:?}", found.left);
        assert_eq!(found.of("width").unwrap().assumed, "without a unit: taken in m");
        // Every line, whatever stands on it.
        for text in [
            "",
            "\"",
            "a\t\"",
            "Span;;;",
            "Span=",
            "Span 2 = 1e999 m",
            "\u{feff}Rise;1 m",
            "é;1",
            "Span (;6;m",
            "a  1",
            "Friction coefficient;9",
        ] {
            let found = rows(text);
            let _ = findings("x", &|key| found.answer(key));
        }
    }
}
