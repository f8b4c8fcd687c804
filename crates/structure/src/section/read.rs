//! Tables of points as scanners and spreadsheets write them.

use super::SectionError;
use crate::extent::extent;

/// Units of length that a table may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LengthUnit {
    /// As it is written.
    pub symbol: &'static str,
    /// In metres.
    pub size: f64,
}

/// Longest first, so that "mm" is not read as "m".
const UNITS: [LengthUnit; 5] = [
    LengthUnit { symbol: "mm", size: 1e-3 },
    LengthUnit { symbol: "cm", size: 1e-2 },
    LengthUnit { symbol: "ft", size: 0.3048 },
    LengthUnit { symbol: "in", size: 0.0254 },
    LengthUnit { symbol: "m", size: 1.0 },
];

impl LengthUnit {
    /// By its symbol.
    pub fn named(symbol: &str) -> Option<LengthUnit> {
        UNITS.into_iter().find(|unit| unit.symbol == symbol)
    }

    /// That which ends a heading: `x_mm`, `x [mm]`, `x (mm)`.
    fn of_heading(heading: &str) -> Option<LengthUnit> {
        let word = heading.trim().trim_end_matches([')', ']']).to_lowercase();
        let before = |c: char| matches!(c, '_' | ' ' | '(' | '[');
        UNITS.into_iter().find(|unit| word.strip_suffix(unit.symbol).is_some_and(|rest| rest.ends_with(before)))
    }
}

/// Sections from here on are no arch [m]; the longest of masonry spans half of it.
const LONGEST: f64 = 300.0;
/// Nor are shorter ones [m].
const SHORTEST: f64 = 0.3;
/// Lengths of arches that stand, among which another unit is looked for [m].
const USUAL: std::ops::RangeInclusive<f64> = 1.0..=60.0;

/// A table as it was read.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Its points [m].
    pub points: Vec<[f64; 2]>,
    /// The unit that the heading names, where another was given and taken.
    pub overruled: Option<LengthUnit>,
}

/// Points of a table with two columns, distance along the bridge and height [m]: separated by commas, semicolons, tabs or blanks, with
/// or without a heading; lines that begin with # are comments. The unit of each column is that of its heading, or of the other where it has none,
/// unless another is given for both.
///
/// # Errors
/// The first row that is no point, no unit, or one in which the section is no arch.
pub fn read(text: &str, given: Option<LengthUnit>) -> Result<Table, SectionError> {
    let text = text.trim_start_matches('\u{feff}');
    let lines = text.lines().enumerate().map(|(k, line)| (k + 1, line.trim()));
    let rows = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let separator = separator(rows.clone().take(2).last().map_or("", |(_, line)| line));
    let mut headed = [None; 2];
    let mut points = Vec::new();
    for (index, (line, row)) in rows.enumerate() {
        let cells = cells(row, separator);
        let numbers: Vec<Option<f64>> = cells.iter().map(|cell| number(cell, separator)).collect();
        if index == 0 && numbers.iter().all(Option::is_none) {
            let of = |k: usize| cells.get(k).and_then(|cell| LengthUnit::of_heading(cell));
            headed = [of(0).or(of(1)), of(1).or(of(0))];
            continue;
        }
        let wrong = |what: String| SectionError::Row { line, what };
        let &[Some(x), Some(y)] = &numbers[..] else {
            return Err(wrong(
                match (numbers.len(), cells.iter().zip(&numbers).find(|(_, number)| number.is_none())) {
                    (2, Some((cell, _))) => format!("\"{cell}\" is not a number"),
                    (count, _) => format!("{count} columns, and a section has two: distance along the bridge, height"),
                },
            ));
        };
        points.push([x, y]);
    }
    let [Some(x), Some(y)] = headed.map(|unit| given.or(unit)) else { return Err(SectionError::NoUnit) };
    doubt(&points, x)?;
    let points = points.into_iter().map(|point| [point[0] * x.size, point[1] * y.size]).collect();
    Ok(Table { points, overruled: headed.into_iter().flatten().find(|unit| given.is_some_and(|given| given != *unit)) })
}

/// Refuses a length that no arch has, and says in which units it would be one.
fn doubt(points: &[[f64; 2]], unit: LengthUnit) -> Result<(), SectionError> {
    let [from, to] = extent(points.iter().map(|point| point[0]));
    let number = to - from;
    let span = number * unit.size;
    if points.len() < 2 || (SHORTEST..LONGEST).contains(&span) {
        return Ok(());
    }
    let others = UNITS.iter().filter(|other| **other != unit).map(|other| (other.symbol, number * other.size));
    let candidates = others.filter(|(_, span)| USUAL.contains(span)).collect();
    Err(SectionError::Unlikely { span, unit: unit.symbol, candidates })
}

/// What stands between two cells of a row.
fn separator(row: &str) -> char {
    [';', '\t', ','].into_iter().find(|mark| row.contains(*mark)).unwrap_or(' ')
}

fn cells(row: &str, separator: char) -> Vec<&str> {
    match separator {
        ' ' => row.split_whitespace().collect(),
        _ => row
            .split(separator)
            .map(|cell| cell.trim_matches(['"', ' ', '\t']))
            .filter(|cell| !cell.is_empty())
            .collect(),
    }
}

/// A number, with a decimal comma where commas do not separate.
fn number(cell: &str, separator: char) -> Option<f64> {
    let text = if separator == ',' { cell.to_owned() } else { cell.replace(',', ".") };
    text.parse::<f64>().ok().filter(|value| value.is_finite() && value.abs() < 1e7)
}
