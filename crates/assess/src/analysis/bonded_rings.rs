//! What rings that lie on one another would carry as one.

use super::AnalysisError;
use super::engine::rigid;
use super::policy::bare;
use super::state::{Change, with};
use bridge::{Bridge, Method};
use mechanics::watch::Watch;
use outcome::collapse::{Collapse, Sought};
use outcome::note;
use structure::discretise::continuum;

/// Puts the limit load of the rings as one beside a load. Whether mortar still bonds them moves a load more than most that is known of a bridge, and
/// no drawing tells it: rings are analysed with friction alone between them, and this is the other end. Rings that cannot be drawn as one have none.
pub(super) fn beside(bridge: &Bridge, found: &mut Collapse, watch: &mut dyn Watch) {
    let is_load = matches!(found.sought, Sought::Load) && !found.is_cancelled();
    if is_load && bridge.spans.iter().any(|span| span.rings.len() > 1) && continuum::wanted(bridge).is_none() {
        found.bonded_rings_load = as_one(bridge, watch).unwrap_or_default();
        found.assumptions.extend(found.bonded_rings_load.map(|load| note::Barrel::RingsApart { bonded: load }.into()));
    }
}

/// The limit load of the rings as one [N/m], where there is any.
fn as_one(bridge: &Bridge, watch: &mut dyn Watch) -> Result<Option<f64>, AnalysisError> {
    let by_limit = with(bridge, &[Change::Method(Method::Limit)]);
    let own = with(&bare(&by_limit), &[Change::BondedRings, Change::LoadsThroughCover]);
    let d = rigid::loaded(rigid::prepared(&own)?)?;
    Ok(rigid::watched(&d, &rigid::single(&own, &d), watch)?.factor.map(|factor| d.load(factor)))
}

#[cfg(test)]
mod tests {
    use super::super::collapse;
    use bridge::defect::{Defect, DefectKind, Face};
    use bridge::{Bridge, Method};
    use mechanics::watch::Unwatched;

    /// Bridgemill's arch, in two rings of half its thickness.
    fn two_rings() -> Bridge {
        let mut b = crate::samples::bridgemill();
        let ring = b.spans[0].rings[0].clone();
        let half = bridge::Ring {
            crown_thickness: 0.5 * ring.crown_thickness,
            springing_thickness: 0.5 * ring.springing_thickness,
            ..ring
        };
        b.spans[0].rings = vec![half.clone(), half];
        b.plan.method = Method::Limit;
        b
    }

    #[test]
    fn rings_as_one_carry_what_one_ring_carries_and_more_than_apart() {
        let mut whole = crate::samples::bridgemill();
        whole.plan.method = Method::Limit;
        let of = |b: &Bridge| collapse(b, None, &mut Unwatched).unwrap();
        let one = of(&whole);
        assert_eq!(one.bonded_rings_load, None);
        let mut two = two_rings();
        let found = of(&two);
        let (bonded, apart) = (found.bonded_rings_load.unwrap(), found.carried().unwrap());
        assert!((bonded / one.carried().unwrap() - 1.0).abs() < 1e-6, "{bonded} {:?}", one.carried());
        assert!(bonded > 1.2 * apart, "{bonded} {apart}");
        // A ring that has come off counts apart alone.
        let shares = [0.2, 0.4];
        let off = DefectKind::RingSeparation { ring: 0, friction_angle: Some(0.3) };
        two.spans[0].defects =
            vec![Defect { kind: off, from_to: shares.map(|share| share * two.spans[0].span), shares }];
        assert_eq!(of(&two).bonded_rings_load, Some(bonded));
    }

    /// A number beside a load never takes the load away: what is left of rings as one may be no stone at all.
    #[test]
    fn rings_that_cannot_be_drawn_as_one_have_a_load_apart() {
        let mut b = two_rings();
        let (shares, depth) = ([0.3, 0.5], 0.5 * b.spans[0].rings[1].crown_thickness);
        let from_to = shares.map(|share| share * b.spans[0].span);
        let thin = DefectKind::ThinRing { face: Face::Extrados, depth: depth + b.spans[0].rings[0].crown_thickness };
        b.spans[0].defects = [DefectKind::MissingStones, thin].map(|kind| Defect { kind, from_to, shares }).to_vec();
        assert!(super::as_one(&b, &mut Unwatched).is_err());
        let mut found = collapse(&two_rings(), None, &mut Unwatched).unwrap();
        let carried = found.carried();
        super::beside(&b, &mut found, &mut Unwatched);
        assert_eq!((found.carried(), found.bonded_rings_load), (carried, None));
    }

    #[test]
    fn stones_that_have_fallen_thin_rings_as_one() {
        let (mut two, mut one) = (two_rings(), crate::samples::bridgemill());
        one.plan.method = Method::Limit;
        let shares = [0.3, 0.5];
        let with = |b: &mut Bridge, kind| {
            let from_to = shares.map(|share| share * b.spans[0].span);
            b.spans[0].defects = vec![Defect { kind, from_to, shares }];
            collapse(b, None, &mut Unwatched).unwrap()
        };
        let depth = 0.5 * one.spans[0].rings[0].crown_thickness;
        let fallen = with(&mut two, DefectKind::MissingStones).bonded_rings_load.unwrap();
        let thin = with(&mut one, DefectKind::ThinRing { face: Face::Intrados, depth }).collapse_load.unwrap();
        assert!((fallen / thin - 1.0).abs() < 1e-6, "{fallen} {thin}");
    }
}
