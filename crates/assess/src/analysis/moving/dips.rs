//! Places beside which a load may fall below the least of all places.

/// Of the loads of places in order, none where nothing is known, those that are no larger than the loads beside them, and lie above the least of all by less
/// than they lie below one of these: between places a load dips no further, as far as can be told, than it changes from place to place. `together`
/// tells whether a place and the one after it belong to one drive.
pub(crate) fn dips(loads: &[Option<f64>], together: impl Fn(usize) -> bool) -> Vec<usize> {
    let least = loads.iter().flatten().fold(f64::INFINITY, |least, load| load.min(least));
    let is_dip = |k: &usize| {
        let Some(load) = loads[*k] else { return false };
        let before = k.checked_sub(1).filter(|before| together(*before)).and_then(|before| loads[before]);
        let after = loads.get(k + 1).copied().flatten().filter(|_| together(*k));
        let change = [before, after].into_iter().flatten().fold(0.0, |most: f64, beside| most.max(beside - load));
        before.is_none_or(|before| load <= before)
            && after.is_none_or(|after| load <= after)
            && (load - change < least || load <= least)
    };
    (0..loads.len()).filter(is_dip).collect()
}

#[cfg(test)]
mod tests {
    use super::dips;

    #[test]
    fn places_are_dips_from_which_less_may_be_found_than_the_least() {
        let loads = [5.0, 3.0, 4.0, 3.5, 6.0, 9.0, 8.9, 9.0].map(Some);
        // The third dip is far above the least and changes by little.
        assert_eq!(dips(&loads, |_| true), [1, 3]);
        // The last place of a drive has nothing after it.
        assert_eq!(dips(&loads, |k| k != 2), [1, 3]);
        assert_eq!(dips(&[Some(2.0), None, Some(2.5)], |_| true), [0]);
        // Of equal places each counts, from whichever side they are read.
        assert_eq!(dips(&[Some(2.0); 3], |_| true), [0, 1, 2]);
        assert!(dips(&[None], |_| true).is_empty());
    }
}
