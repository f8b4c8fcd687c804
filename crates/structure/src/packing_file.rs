//! A packing of particles in a file: written beside the results, and read in place of packing anew.
//!
//! Numbers are written with the fewest digits that read back to the same bits, so that a run with a saved packing is
//! the run that saved it.

use findings::visible::{cell, harmless_line};
use outcome::collapse::Collapse;
use std::fmt::Write as _;
use thiserror::Error;

/// More complaints than this are counted and not listed.
const MOST: usize = 10;

/// A packing that cannot be read: each complaint with its line, counted from 1.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{}", self.words())]
pub struct PackingFileError {
    /// Line and what is wrong with it, in the order of the file.
    pub complaints: Vec<(u64, String)>,
}

impl PackingFileError {
    fn at(line: u64, what: impl Into<String>) -> PackingFileError {
        PackingFileError { complaints: vec![(line, what.into())] }
    }
    fn words(&self) -> String {
        let mut lines: Vec<String> =
            self.complaints.iter().take(MOST).map(|(line, what)| format!("line {line}: {what}")).collect();
        if self.complaints.len() > MOST {
            lines.push(format!("and {} more", self.complaints.len() - MOST));
        }
        lines.join("; ")
    }
}

/// Centre and radius of each particle [m], as `packing.csv` holds them. Lines that begin with `#` are remarks; the
/// columns are found by their names, and others than `x_m`, `y_m` and `radius_m` are left alone.
///
/// # Errors
/// Columns that are missing, every line that is no particle, or no particle at all.
pub fn read(text: &[u8]) -> Result<Vec<[f64; 3]>, PackingFileError> {
    let mut table = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).flexible(true).from_reader(text);
    let line_of = |error: &csv::Error| error.position().map_or(1, csv::Position::line);
    let names = table.headers().map_err(|e| PackingFileError::at(line_of(&e), "is not text in UTF-8"))?.clone();
    let head = names.position().map_or(1, csv::Position::line);
    let mut columns = [0; 3];
    let mut missing = Vec::new();
    for (column, name) in columns.iter_mut().zip(["x_m", "y_m", "radius_m"]) {
        match names.iter().position(|n| n == name) {
            Some(at) => *column = at,
            None => missing.push(name),
        }
    }
    if !missing.is_empty() {
        let what = format!("the heading has no {}: it must name the columns x_m,y_m,radius_m", missing.join(", "));
        return Err(PackingFileError::at(head, what));
    }
    let (mut grains, mut complaints) = (Vec::new(), Vec::new());
    for row in table.records() {
        match row {
            Ok(row) => match grain(&row, columns) {
                Ok(grain) => grains.push(grain),
                Err(what) => complaints.push((row.position().map_or(0, csv::Position::line), what)),
            },
            Err(error) => complaints.push((line_of(&error), "is not text in UTF-8".to_string())),
        }
    }
    if complaints.is_empty() && grains.is_empty() {
        complaints.push((head, "no particle follows the heading".to_string()));
    }
    if complaints.is_empty() { Ok(grains) } else { Err(PackingFileError { complaints }) }
}

fn grain(row: &csv::StringRecord, columns: [usize; 3]) -> Result<[f64; 3], String> {
    let mut grain = [0.0_f64; 3];
    for ((value, column), name) in grain.iter_mut().zip(columns).zip(["x_m", "y_m", "radius_m"]) {
        let Some(text) = row.get(column) else { return Err(format!("{name} is missing")) };
        *value = text.parse().map_err(|_| format!("{name} is \"{text}\": write a number"))?;
        if !value.is_finite() {
            return Err(format!("{name} is {value}: write a finite number"));
        }
    }
    if grain[2] > 0.0 { Ok(grain) } else { Err(format!("radius_m is {}: it must be above zero", grain[2])) }
}

/// The packing of a run, as [`read`] reads it; empty where there is none.
pub fn write(found: &Collapse) -> String {
    let Some(packing) = &found.packing else { return String::new() };
    let origin = packing.seed.map_or("read from a file".to_string(), |seed| format!("seed {seed}"));
    let mut text = format!(
        "# Packing of {} particles for {}, {origin}.\n\
         # Centres and radii as packed, under the lid. At rest under its own weight:\n\
         # solid fraction {}, {} contacts a particle, mean stress {} kPa.\n\
         # To use it again, copy it beside the bridge file and write file = \"packing.csv\" in [particles].\n",
        packing.grains.len(),
        harmless_line(&found.bridge),
        packing.solid_fraction,
        packing.coordination,
        packing.mean_stress / 1e3
    );
    text += "x_m,y_m,radius_m,layer\n";
    let discs = &found.picture.particles;
    for (k, [x, y, radius]) in packing.grains.iter().enumerate() {
        let layer = discs.get(k).map_or(0, |disc| disc.layer);
        let _ =
            writeln!(text, "{x},{y},{radius},{}", cell(found.picture.layers.get(layer).map_or("fill", |name| name)));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back_to_the_same_bits() {
        let values = [0.1 + 0.2, 1.0 / 3.0, 5e-324];
        let text = format!("# a remark\nlayer,radius_m,y_m,x_m\nfill,{},{},{}\n", values[2], values[1], values[0]);
        let read = read(text.as_bytes()).unwrap();
        assert_eq!(read[0].map(f64::to_bits), values.map(f64::to_bits));
    }

    #[test]
    fn every_bad_line_is_named() {
        let text = "# remark\nx_m,y_m,radius_m\n1,2,0.1\n1,two,0.1\n1,2\n1,2,-0.1\n1,inf,0.1\n";
        let words = read(text.as_bytes()).unwrap_err().to_string();
        for part in ["line 4: y_m is \"two\"", "line 5: radius_m is missing", "line 6: radius_m is -0.1", "line 7: y_m"]
        {
            assert!(words.contains(part), "{part} in {words}");
        }
        assert!(!words.contains("line 3"), "{words}");
    }

    #[test]
    fn any_bytes_get_an_answer() {
        let no_column = read(b"x_m,y_m\n1,2\n").unwrap_err().to_string();
        assert!(no_column.contains("radius_m"), "{no_column}");
        let texts: [&[u8]; 6] =
            [b"", b"\xff\xfe", b"\n\n\n", b"x_m,y_m,radius_m\n", b"x_m,y_m,radius_m\n\xff,1,2\n", b"# only"];
        for text in texts {
            assert!(read(text).is_err(), "{text:?}");
        }
        let many = format!("x_m,y_m,radius_m\n{}", "a,b,c\n".repeat(500));
        assert!(read(many.as_bytes()).unwrap_err().to_string().ends_with("and 490 more"));
    }
}
