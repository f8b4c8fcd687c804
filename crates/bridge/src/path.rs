//! Paths of quantities in a bridge file: `span[1].ring[2].thickness`, counted from 1 as messages count.

use serde::{Deserialize, Serialize};
use std::fmt;

/// The path of a quantity.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Path {
    /// From the outermost section to the key; never empty.
    pub steps: Vec<Step>,
}

/// One part of a path, between dots.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Step {
    /// The key.
    pub key: String,
    /// Which of several, from 1; none where there is only one.
    pub index: Option<usize>,
}

/// Deeper paths lead nowhere: the deepest section lies two below the file.
const MOST_STEPS: usize = 8;

impl Path {
    /// Reads a path; what it leads to is for the file to say.
    pub fn parse(text: &str) -> Option<Path> {
        let steps: Option<Vec<Step>> = text.trim().split('.').take(MOST_STEPS + 1).map(Step::parse).collect();
        steps.filter(|steps| steps.len() <= MOST_STEPS).map(|steps| Path { steps })
    }
}

impl Step {
    fn parse(text: &str) -> Option<Step> {
        let (key, index) = match text.strip_suffix(']') {
            Some(rest) => {
                let (key, digits) = rest.split_once('[')?;
                let index = digits.trim().parse::<usize>().ok().filter(|index| *index >= 1)?;
                (key, Some(index))
            }
            None => (text, None),
        };
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        (!key.is_empty() && key.chars().all(plain)).then(|| Step { key: key.to_owned(), index })
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, step) in self.steps.iter().enumerate() {
            let dot = if number == 0 { "" } else { "." };
            write!(f, "{dot}{step}")?;
        }
        Ok(())
    }
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.index {
            Some(index) => write!(f, "{}[{index}]", self.key),
            None => write!(f, "{}", self.key),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_written_as_they_are_read() {
        for text in ["joint.friction_angle", "span[1].ring[2].thickness", "load[3].axle_forces[2]", "analysis.seed"] {
            assert_eq!(Path::parse(text).map(|path| path.to_string()).as_deref(), Some(text));
        }
    }

    #[test]
    fn what_is_no_path_is_none() {
        for text in
            ["", ".", "span[0].rise", "span[.rise", "span[1]]", "a b", "span[-1]", "a.b.c.d.e.f.g.h.i", "span[1"]
        {
            assert_eq!(Path::parse(text), None, "{text}");
        }
    }
}
