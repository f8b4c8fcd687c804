//! The multiple of the stiffness at which the fill has the wanted modulus. The modulus grows with stiffness, the more
//! slowly the more the particles move instead of yielding: nearly straight pieces in logarithms, closed in on by the rule
//! of false position (Illinois variant, Dowell and Jarratt 1971).

use super::crowd::Halt;
use bridge::Modulus;
use outcome::calibration::{At, Measured};

/// What is measured at the multiple with the wanted modulus, or the lowest and the highest modulus that stiffness reaches.
pub(super) type Found = Result<Measured, [At; 2]>;

/// Doublings beyond the multiples of the table, to either side.
const BEYOND: u32 = 3;

/// Most presses while closing in; false position needs three or four.
const MOST: u32 = 12;

/// Finds the multiple by pressing at more of them than the table has.
pub(super) fn search(
    wanted: f64,
    tolerance: f64,
    modulus: Modulus,
    table: &[Measured],
    press: &mut dyn FnMut(f64) -> Result<Measured, Halt>,
) -> Result<Found, Halt> {
    let mut known: Vec<(At, Measured)> = table.iter().filter_map(|m| Some((m.at(modulus)?, m.clone()))).collect();
    known.sort_by(|a, b| a.0.multiple.total_cmp(&b.0.multiple));
    let mut beyond = [BEYOND; 2];
    loop {
        if let Some((_, near)) = nearest(&known, wanted).filter(|k| off(k.0, wanted).abs() <= tolerance) {
            return Ok(Ok(near.clone()));
        }
        if let Some(k) = known.windows(2).position(|p| p[0].0.modulus <= wanted && wanted <= p[1].0.modulus) {
            let [low, high] = [known[k].0, known[k + 1].0];
            return close_in(wanted, tolerance, modulus, [low, high], known, press);
        }
        // Beyond either end of what is known.
        let (Some(first), Some(last)) = (known.first(), known.last()) else {
            let nowhere = At { multiple: 1.0, modulus: 0.0 };
            return Ok(Err([nowhere; 2]));
        };
        let up = last.0.modulus < wanted;
        let left = &mut beyond[usize::from(up)];
        if *left == 0 {
            let least = known.iter().map(|k| k.0).min_by(|a, b| a.modulus.total_cmp(&b.modulus));
            let most = known.iter().map(|k| k.0).max_by(|a, b| a.modulus.total_cmp(&b.modulus));
            return Ok(Err([least.unwrap_or(first.0), most.unwrap_or(last.0)]));
        }
        *left -= 1;
        let multiple = if up { 2.0 * last.0.multiple } else { 0.5 * first.0.multiple };
        let measured = press(multiple)?;
        match measured.at(modulus) {
            Some(at) => {
                let place = if up { known.len() } else { 0 };
                known.insert(place, (at, measured));
            }
            // No sample holds so stiff or so soft: what is known is the reach.
            None => *left = 0,
        }
    }
}

fn close_in(
    wanted: f64,
    tolerance: f64,
    modulus: Modulus,
    [mut low, mut high]: [At; 2],
    mut known: Vec<(At, Measured)>,
    press: &mut dyn FnMut(f64) -> Result<Measured, Halt>,
) -> Result<Found, Halt> {
    let mut weights = [off(low, wanted), off(high, wanted)];
    let mut stayed = None;
    for _ in 0..MOST {
        // Grains that rearrange make small jumps; a bracket narrower than the tolerance holds one.
        if high.multiple / low.multiple <= 1.0 + tolerance {
            break;
        }
        let (a, b) = (low.multiple.ln(), high.multiple.ln());
        let share = (weights[0] / (weights[0] - weights[1])).clamp(0.02, 0.98);
        let measured = press((a + (b - a) * share).exp())?;
        let Some(at) = measured.at(modulus) else { break };
        known.push((at, measured));
        let distance = off(at, wanted);
        if distance.abs() <= tolerance {
            break;
        }
        // The weight of an end that stays for a second time is halved, so that it gives way.
        let below = distance < 0.0;
        let stays = if stayed == Some(below) { 0.5 } else { 1.0 };
        stayed = Some(below);
        if below {
            low = at;
            weights = [distance, stays * weights[1]];
        } else {
            high = at;
            weights = [stays * weights[0], distance];
        }
    }
    match nearest(&known, wanted) {
        Some((_, near)) => Ok(Ok(near.clone())),
        None => Ok(Err([low, high])),
    }
}

/// Logarithm of modulus over wanted modulus.
fn off(at: At, wanted: f64) -> f64 {
    (at.modulus / wanted).ln()
}

fn nearest(known: &[(At, Measured)], wanted: f64) -> Option<&(At, Measured)> {
    known.iter().min_by(|a, b| off(a.0, wanted).abs().total_cmp(&off(b.0, wanted).abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::calibration::Spread;
    use std::cell::Cell;

    /// A fill whose modulus [MPa] is a function of the multiple.
    fn find(modulus: impl Fn(f64) -> f64, wanted: f64, table: &[f64]) -> (Found, u32) {
        let at = |multiple: f64| bare(multiple, modulus(multiple));
        let table: Vec<Measured> = table.iter().map(|&m| at(m)).collect();
        let presses = Cell::new(0);
        let mut press = |multiple: f64| {
            presses.set(presses.get() + 1);
            Ok(at(multiple))
        };
        let found = search(wanted, 0.01, Modulus::Tangent, &table, &mut press);
        (found.unwrap(), presses.get())
    }

    /// Nothing but a modulus.
    fn bare(multiple: f64, modulus: f64) -> Measured {
        let spread = Spread::of(&[(0, modulus)]);
        Measured {
            multiple,
            tangent: spread,
            least_squares: spread,
            secant: spread,
            late_secant: spread,
            left_out: 0,
            curve: Vec::new(),
            samples: Vec::new(),
            iterations: 0,
            drawn: None,
        }
    }

    #[test]
    fn the_multiple_is_found_inside_and_beyond_the_table() {
        // As published, about 22 MPa times the multiple to the power 0.375: 40 MPa at 4.92.
        let soft = |m: f64| 22.0 * m.powf(0.375);
        for table in [&[1.0, 2.0, 4.0, 6.0, 8.0][..], &[8.0, 1.0], &[1.0], &[16.0]] {
            let (found, presses) = find(soft, 40.0, table);
            let Ok(found) = found else { panic!("{table:?}") };
            // One percent of the modulus is 2.7 % of the multiple.
            assert!(
                (found.multiple / 4.925 - 1.0).abs() < 0.028 && presses <= 6,
                "{table:?} {} {presses}",
                found.multiple
            );
        }
        let Ok(found) = find(soft, 28.5, &[1.0, 2.0]).0 else { panic!() };
        assert_eq!(found.multiple, 2.0, "a multiple of the table that fits needs no press");
    }

    #[test]
    fn a_modulus_that_saturates_is_out_of_reach() {
        let (found, presses) = find(|m| 50.0 * m / (1.0 + m), 80.0, &[1.0, 8.0]);
        let Err([low, high]) = found else { panic!() };
        assert_eq!((presses, low.multiple, high.multiple), (3, 1.0, 64.0));
        assert!(high.modulus < 50.0 && low.modulus == 25.0);
        let Err([low, _]) = find(|m| 20.0 + m, 10.0, &[1.0, 8.0]).0 else { panic!() };
        assert_eq!(low.multiple, 0.125);
    }

    #[test]
    fn a_jump_ends_the_search_at_its_nearer_side() {
        let (found, presses) = find(|m| if m < 3.0 { 30.0 } else { 45.0 }, 40.0, &[1.0, 8.0]);
        let Ok(found) = found else { panic!() };
        assert!(presses <= MOST && found.multiple >= 3.0, "{} {presses}", found.multiple);
    }
}
