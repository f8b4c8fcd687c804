//! Which runs there are.

use crate::words::words;
use serde::{Deserialize, Serialize};

words! {
    /// How values of several quantities are put together.
    pub enum Design {
        /// One quantity after the other, all others as the file has them.
        OneAtATime = "one-at-a-time",
        /// Every value of each quantity with every value of all others.
        Grid = "grid",
    }
}

/// The values of one run.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Variation {
    /// For each quantity, which of its values; none for the file's own.
    pub choice: Vec<Option<usize>>,
    /// The one quantity that was varied; none for the file's own bridge and in a grid.
    pub varied: Option<usize>,
}

/// How many runs there are, with so many values of each quantity, the file's own bridge included; none beyond what can be counted.
pub fn count(design: Design, values: &[usize]) -> Option<usize> {
    let runs = match design {
        Design::OneAtATime => values.iter().try_fold(0_usize, |sum, count| sum.checked_add(*count)),
        Design::Grid => values.iter().try_fold(1_usize, |product, count| product.checked_mul(*count)),
    };
    runs?.checked_add(1)
}

/// The file's own bridge, then every run: quantity by quantity, or the grid with its last quantity turning fastest.
pub fn runs(design: Design, values: &[usize]) -> Vec<Variation> {
    let own = Variation { choice: vec![None; values.len()], varied: None };
    let mut all = vec![own.clone()];
    match design {
        Design::OneAtATime => {
            for (quantity, count) in values.iter().enumerate() {
                all.extend((0..*count).map(|value| {
                    let mut run = Variation { varied: Some(quantity), ..own.clone() };
                    run.choice[quantity] = Some(value);
                    run
                }));
            }
        }
        Design::Grid => {
            let cells: usize = values.iter().product();
            all.extend((0..cells).map(|cell| {
                let mut rest = cell;
                let mut run = own.clone();
                for (quantity, count) in values.iter().enumerate().rev() {
                    run.choice[quantity] = Some(rest % count);
                    rest /= count;
                }
                run
            }));
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(design: Design, values: &[usize]) -> Vec<String> {
        let letter = |value: &Option<usize>| value.map_or("-".to_owned(), |value| value.to_string());
        runs(design, values).iter().map(|run| run.choice.iter().map(letter).collect()).collect()
    }

    #[test]
    fn one_at_a_time_goes_quantity_by_quantity() {
        assert_eq!(words(Design::OneAtATime, &[2, 3]), ["--", "0-", "1-", "-0", "-1", "-2"]);
        assert_eq!(count(Design::OneAtATime, &[2, 3]), Some(6));
    }

    #[test]
    fn a_grid_turns_its_last_quantity_fastest() {
        assert_eq!(words(Design::Grid, &[2, 3]), ["--", "00", "01", "02", "10", "11", "12"]);
        assert_eq!(count(Design::Grid, &[2, 3]), Some(7));
        assert_eq!(count(Design::Grid, &[1 << 40, 1 << 40]), None);
        assert_eq!(runs(Design::Grid, &[2, 3, 4]).len(), 25);
    }
}
