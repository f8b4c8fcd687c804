//! Work that several processes share without speaking to one another: each of n makes every n-th piece.

use std::fmt;
use std::str::FromStr;

/// A part of a piece of work: number `number` of `of`, counted from 1. Written as `2/8`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Shard {
    number: usize,
    of: usize,
}

/// More shards than this are refused: a mistake of typing, most often.
pub const MOST: usize = 100_000;

impl Shard {
    /// Number `number` of `of`; none where there is no such part.
    pub fn new(number: usize, of: usize) -> Option<Shard> {
        (1..=of.min(MOST)).contains(&number).then_some(Shard { number, of }).filter(|one| one.of <= MOST)
    }

    /// Its number, from 1.
    pub fn number(self) -> usize {
        self.number
    }

    /// How many there are.
    pub fn of(self) -> usize {
        self.of
    }

    /// Whether it makes the piece at this place of the list, counted from 0. Neighbours, which take about as long as one another, go to
    /// different shards.
    pub fn makes(self, place: usize) -> bool {
        place % self.of == self.number - 1
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Shard, String> {
        let numbers = text.split_once('/').and_then(|(number, of)| Some((number.parse().ok()?, of.parse().ok()?)));
        numbers
            .and_then(|(number, of)| Shard::new(number, of))
            .ok_or_else(|| format!("write the number of the shard and how many there are, such as 2/8, up to {MOST}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_piece_is_made_by_one_shard() {
        for of in 1..=7 {
            for place in 0..20 {
                let made = (1..=of).filter(|number| Shard::new(*number, of).is_some_and(|one| one.makes(place)));
                assert_eq!(made.count(), 1, "{place} of {of}");
            }
        }
    }

    #[test]
    fn words_are_read_and_written() {
        assert_eq!("2/8".parse::<Shard>().map(|one| one.to_string()), Ok("2/8".to_owned()));
        for wrong in ["", "2", "0/8", "9/8", "a/8", "1/0", "-1/8", "1/8/9", "1/100001"] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
    }
}
