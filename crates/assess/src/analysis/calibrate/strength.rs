//! The contacts with which the fill has a wanted friction angle and cohesion.
//!
//! Discs roll past one another, so fill is weaker than its contacts, and beyond some angle of contact it gets no stronger: what
//! is wanted may be out of reach, and then the answer says so.

use super::crowd::Halt;
use outcome::calibration::strength::{ANGLE, COHESION, SHARE};
use outcome::calibration::{Contact, Strength, TargetStrength};

/// How a search for strength ended: what contacts make, and whether it is what is wanted, or the strongest fill, weaker than wanted, or the
/// weakest, stronger than wanted; none where the samples could not be tested.
pub(super) type Fitted = Option<(Strength, bool)>;

/// Friction angles of contacts between which the search moves [rad].
const ANGLES: [f64; 2] = [0.05, 1.2];
/// Most measurements for one of the two.
const MOST: usize = 8;
/// Rounds over both: cohesion of contacts hardly changes the friction angle.
const ROUNDS: usize = 2;

/// A measurement; none where no sample could be tested.
pub(super) type Measure<'a> = dyn FnMut(Contact) -> Result<Option<Strength>, Halt> + 'a;

/// Finds contacts with the wanted strength, from those of the file on.
pub(super) fn fit(wanted: TargetStrength, first: Contact, measure: &mut Measure<'_>) -> Result<Fitted, Halt> {
    let mut contact = first;
    let mut found = None;
    for _ in 0..ROUNDS {
        if let Some(angle) = wanted.friction_angle {
            let off = |s: &Strength| s.friction_angle.mean - angle;
            let with = |x: f64| Contact { friction_angle: x, ..contact };
            match one(off, ANGLE, ANGLES, contact.friction_angle, with, measure)? {
                Some((strength, true)) => (contact, found) = (strength.contact, Some(strength)),
                other => return Ok(other),
            }
        }
        if let Some(cohesion) = wanted.cohesion {
            let off = |s: &Strength| s.cohesion.mean - cohesion;
            let with = |x: f64| Contact { cohesion: x, ..contact };
            let range = [0.0, 20.0 * cohesion.max(COHESION)];
            match one(off, (SHARE * cohesion).max(COHESION), range, contact.cohesion.max(cohesion), with, measure)? {
                Some((strength, true)) => (contact, found) = (strength.contact, Some(strength)),
                other => return Ok(other),
            }
        }
        let met = found.as_ref().is_some_and(|s| wanted.met_by(s));
        if met {
            break;
        }
    }
    Ok(found.map(|strength| (strength, true)))
}

/// One quantity by false position (Illinois variant): strength grows with what contacts have.
fn one(
    off: impl Fn(&Strength) -> f64,
    within: f64,
    range: [f64; 2],
    first: f64,
    with: impl Fn(f64) -> Contact,
    measure: &mut Measure<'_>,
) -> Result<Fitted, Halt> {
    let mut ends: [Option<(f64, f64)>; 2] = [None, None];
    let mut x = first.clamp(range[0], range[1]);
    let mut nearest: Option<Strength> = None;
    let mut stayed = None;
    for _ in 0..MOST {
        let Some(strength) = measure(with(x))? else { return Ok(None) };
        let distance = off(&strength);
        if nearest.as_ref().is_none_or(|old| distance.abs() < off(old).abs()) {
            nearest = Some(strength.clone());
        }
        if distance.abs() <= within {
            return Ok(Some((strength, true)));
        }
        let side = usize::from(distance > 0.0);
        if x == range[1 - side] {
            return Ok(Some((strength, false)));
        }
        ends[side] = Some((x, distance));
        if stayed == Some(side) {
            ends[1 - side] = ends[1 - side].map(|(x, off)| (x, 0.5 * off));
        }
        stayed = Some(side);
        x = match ends {
            [Some((a, below)), Some((b, above))] if b > a => {
                let share = (below / (below - above)).clamp(0.05, 0.95);
                a + (b - a) * share
            }
            _ => range[1 - side],
        };
    }
    Ok(nearest.map(|strength| (strength, true)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::calibration::Spread;

    /// A fill whose angle levels off at 24 degrees, with a third of the contacts' cohesion.
    fn fill(contact: Contact) -> Strength {
        let spread = |value: f64| Spread::of(&[(0, value)]).unwrap();
        let angle = 24f64.to_radians() * (1.0 - (-2.5 * contact.friction_angle.tan()).exp());
        Strength {
            contact,
            friction_angle: spread(angle),
            cohesion: spread(contact.cohesion / 3.0),
            peaks: Vec::new(),
            left_out: 0,
        }
    }

    fn found(friction_angle: Option<f64>, cohesion: Option<f64>) -> (Fitted, usize) {
        let mut count = 0;
        let mut measure = |contact| {
            count += 1;
            Ok(Some(fill(contact)))
        };
        let first = Contact { friction_angle: 35.6f64.to_radians(), cohesion: 10e3 };
        let wanted = TargetStrength { friction_angle: friction_angle.map(f64::to_radians), cohesion };
        (fit(wanted, first, &mut measure).unwrap(), count)
    }

    #[test]
    fn both_are_found_in_a_few_measurements() {
        let (Some((strength, true)), count) = found(Some(15.0), Some(8e3)) else { panic!() };
        assert!((strength.friction_angle.mean.to_degrees() - 15.0).abs() < 0.51, "{strength:?}");
        assert!((strength.cohesion.mean / 8e3 - 1.0).abs() < 0.07 && count <= 12, "{strength:?} {count}");
    }

    #[test]
    fn an_angle_that_discs_do_not_reach_is_out_of_reach() {
        let (Some((strength, false)), _) = found(Some(35.0), None) else { panic!() };
        assert!(strength.friction_angle.mean.to_degrees() < 24.0 && strength.contact.friction_angle == ANGLES[1]);
    }
}
