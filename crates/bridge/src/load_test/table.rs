//! A table of readings: a row for each position, a column for each sensor, as it is pasted from a spreadsheet.

use super::{LoadTest, measured};
use crate::quantity::{Dimension, Unit};
use crate::tree::shorten;

/// Columns that say when and how something was read; they are passed over.
const BESIDE: [&str; 8] = ["date", "time", "temperature", "load", "remark", "remarks", "note", "notes"];

/// What a column holds.
enum Column {
    /// Readings of a sensor, in a unit.
    Of(usize, &'static Unit),
    /// Nothing that is read here.
    PassedOver,
}

impl LoadTest {
    /// Takes readings from a table: its first line names the sensors with their units (`crown displacement [mm]`), its first column the positions.
    /// Columns are parted by commas, semicolons or tabs; an empty cell or a dash is no reading. Lines that begin with # are remarks; `# synthetic: …` says that the table was computed. What is wrong is said line by line.
    ///
    /// # Errors
    /// A heading that is no sensor with a unit, a row that is no position of the file, a cell that is no number, or a table without a reading.
    pub fn take_table(&mut self, text: &str) -> Result<(), Vec<String>> {
        let lines = text.trim_start_matches('\u{feff}').lines().enumerate().map(|(k, line)| (k + 1, line));
        let mut lines = lines.filter(|(_, line)| !line.trim().is_empty() && !line.trim_start().starts_with('#'));
        let Some((number, head)) = lines.next() else { return Err(vec!["the table has no line".to_owned()]) };
        let mark = [b'\t', b';'].into_iter().find(|mark| head.as_bytes().contains(mark)).unwrap_or(b',');
        let mut wrong = Vec::new();
        let columns = self.columns(number, &cells(head, mark), &mut wrong);
        let mut values = vec![vec![None; self.positions.len()]; self.sensors.len()];
        let mut seen = vec![false; self.positions.len()];
        for (number, line) in lines {
            let cells = cells(line, mark);
            let name = cells.first().map_or("", String::as_str);
            let Some(position) = self.positions.iter().position(|position| same(&position.name, name)) else {
                wrong.push(format!(
                    "line {number}: there is no position \"{}\"; the positions are {}",
                    shorten(name),
                    self.named()
                ));
                continue;
            };
            if std::mem::replace(&mut seen[position], true) {
                wrong.push(format!("line {number}: position \"{name}\" is there twice"));
            }
            if cells.len() > columns.len() + 1 {
                let (more, head) = (cells.len(), columns.len() + 1);
                wrong.push(format!(
                    "line {number}: {more} cells below a heading of {head}; part numbers by points, 0.31"
                ));
                continue;
            }
            for (column, cell) in columns.iter().zip(&cells[1..]) {
                let Column::Of(sensor, unit) = *column else { continue };
                match reading(cell, unit, mark) {
                    Ok(value) => values[sensor][position] = value,
                    Err(why) => wrong.push(format!("line {number}, {}: {why}", self.sensors[sensor].name)),
                }
            }
        }
        if wrong.is_empty() && !values.iter().flatten().any(Option::is_some) {
            wrong.push("the table has no reading".to_owned());
        }
        if wrong.is_empty() {
            let label = |line: &str| {
                Some(
                    line.trim_start_matches('\u{feff}')
                        .strip_prefix('#')?
                        .trim()
                        .strip_prefix("synthetic:")?
                        .trim()
                        .to_owned(),
                )
            };
            self.readings.synthetic = text.lines().find_map(label);
            self.readings.values = values;
            return Ok(());
        }
        Err(wrong)
    }

    /// What the columns behind the first one hold.
    fn columns(&self, line: usize, head: &[String], wrong: &mut Vec<String>) -> Vec<Column> {
        let mut seen = vec![false; self.sensors.len()];
        let mut column = |heading: &String| {
            let plain = plain(heading);
            // With a unit in brackets the rest is the name.
            let alone = heading.rfind(['[', '(']).map(|at| self::plain(&heading[..at]));
            if BESIDE.contains(&alone.as_ref().unwrap_or(&plain).as_str()) || plain.is_empty() {
                return Column::PassedOver;
            }
            // Without brackets it is the longest one: one name may be the beginning of another.
            let named = self.sensors.iter().enumerate().filter_map(|(k, sensor)| {
                let name = self::plain(&sensor.name);
                let rest = match &alone {
                    Some(alone) => (*alone == name).then_some("")?,
                    None => plain.strip_prefix(&name).filter(|rest| rest.is_empty() || rest.starts_with(' '))?,
                };
                Some((k, rest.trim().to_owned()))
            });
            let Some((sensor, unit)) = named.max_by_key(|(k, _)| self.sensors[*k].name.len()) else {
                let names: Vec<&str> = self.sensors.iter().map(|sensor| sensor.name.as_str()).collect();
                let named = names.join(", ");
                wrong.push(format!("line {line}: \"{}\" is no sensor; the sensors are {named}", shorten(heading)));
                return Column::PassedOver;
            };
            let dimension = measured(&self.sensors[sensor]);
            let name = &self.sensors[sensor].name;
            if std::mem::replace(&mut seen[sensor], true) {
                wrong.push(format!("line {line}: two columns are named after {name}"));
            }
            match unit_of(heading, &unit, dimension) {
                Some(unit) => Column::Of(sensor, unit),
                None => {
                    let usual = dimension.units().map(|unit| unit.symbol).find(|symbol| *symbol != "m").unwrap_or("");
                    let what = dimension.name();
                    wrong.push(format!(
                        "line {line}: write the column of {name} with the unit of {what}: {name} [{usual}]"
                    ));
                    Column::PassedOver
                }
            }
        };
        head.iter().skip(1).map(&mut column).collect()
    }

    /// The names of the positions, in a list.
    pub(crate) fn named(&self) -> String {
        self.positions.iter().map(|position| position.name.as_str()).collect::<Vec<_>>().join(", ")
    }
}

/// The cells of a line, without blanks and quotes around them.
fn cells(line: &str, mark: u8) -> Vec<String> {
    let (mut cells, mut cell, mut quoted) = (Vec::new(), String::new(), false);
    for letter in line.chars() {
        match letter {
            '"' => quoted = !quoted,
            letter if letter == char::from(mark) && !quoted => cells.push(std::mem::take(&mut cell)),
            letter => cell.push(letter),
        }
    }
    cells.push(cell);
    cells.into_iter().map(|cell| cell.trim().to_owned()).collect()
}

/// Letters, figures and single blanks, in small letters: programs write names in many ways.
fn plain(name: &str) -> String {
    let letters = |c: char| if c.is_alphanumeric() { c } else { ' ' };
    let spaced: String = name.to_lowercase().chars().map(letters).collect();
    spaced.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn same(a: &str, b: &str) -> bool {
    a == b || (plain(a) == plain(b) && !plain(a).is_empty())
}

/// The unit of a heading: in brackets, or its last word.
fn unit_of(heading: &str, rest: &str, dimension: Dimension) -> Option<&'static Unit> {
    let inside = [('[', ']'), ('(', ')')].into_iter().find_map(|(open, close)| {
        let (_, after) = heading.rsplit_once(open)?;
        Some(after.split_once(close)?.0.trim())
    });
    let words = [inside, heading.rsplit(['_', ' ', ',']).next(), Some(rest)];
    words.into_iter().flatten().find_map(|word| {
        let known = crate::quantity::parse(&format!("1 {word}")).ok().map(|quantity| quantity.unit.symbol);
        dimension.units().find(|unit| known == Some(unit.symbol) || unit.symbol.eq_ignore_ascii_case(word))
    })
}

/// A reading [SI]; none in an empty cell.
fn reading(cell: &str, unit: &Unit, mark: u8) -> Result<Option<f64>, String> {
    if ["", "-", "–", "—"].contains(&cell) {
        return Ok(None);
    }
    let mut text = cell.replace('−', "-");
    if mark != b',' {
        text = text.replace(',', ".");
    }
    let value = text.parse::<f64>().ok().map(|number| number * unit.size).filter(|value| value.is_finite());
    match value {
        Some(value) if value.abs() <= unit.dimension.most() => Ok(Some(value)),
        Some(_) => Err(format!("{} {} is beyond anything that a bridge can have", shorten(cell), unit.symbol)),
        None => Err(format!("\"{}\" is no number: write -0.31, or leave the cell empty", shorten(cell))),
    }
}
