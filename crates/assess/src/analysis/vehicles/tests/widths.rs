//! How vehicles stand across a bridge: abreast, at its edge, beside the middle of a track, beside a crack.

use super::*;

/// Two vehicles abreast share the width between them, one at the edge lacks the width beyond it, and a lane's uniform load
/// stands on its own width.
#[test]
fn vehicles_abreast_and_at_the_edge_have_less_width() {
    let mut b = bridgemill(&["cs454-single"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    let width = |b: &Bridge| {
        let (rule, vehicles) = chosen(b, b.sweep.as_ref().unwrap()).unwrap();
        across::worst(b, &rule, &vehicles[0])
    };
    let with = |b: &Bridge, lanes: Option<usize>, edge: Option<f64>| {
        let mut b = b.clone();
        b.carriageway = Some(bridge::Carriageway { lanes, edge_distance: edge, ..Default::default() });
        width(&b)
    };
    let alone = with(&b, Some(1), None);
    assert!((alone.axles - 3.778).abs() < 1e-9 && alone.abreast == 1, "{alone:?}");
    let two = with(&b, Some(2), None);
    assert!((two.axles - 0.5 * (3.778 + 2.5)).abs() < 1e-9 && two.abreast == 2, "{two:?}");
    assert_eq!(width(&b), two, "two fit on 8.3 m");
    let edge = with(&b, Some(1), Some(0.4));
    assert!(edge.derivation.ends_with("0.59 m of it lie beyond the edge"), "{edge:?}");
    assert!((edge.axles - (3.778 - (0.989 - 0.4))).abs() < 1e-9 && edge.at_edge, "{edge:?}");
    let both = with(&b, Some(2), Some(0.4));
    assert!((both.axles - 0.5 * (3.778 + 2.5 - 0.589)).abs() < 1e-9 && both.at_edge, "{both:?}");
    assert_eq!(with(&b, Some(1), Some(2.0)).axles, alone.axles, "far from the edge");
    // A barrel narrower than the load has spread carries as a whole, wherever the vehicle stands.
    b.width = 2.6;
    let narrow = with(&b, Some(1), Some(0.4));
    assert!((narrow.axles - 2.6).abs() < 1e-9 && narrow.derivation.contains("the barrel has 2.60 m"), "{narrow:?}");
    b.width = 8.3;
    // Multiple presence of HL-93: one lane counts 1.2, two count 1.
    b.sweep = Some(plan(&["hl-93-tandem"]));
    let one = width(&b);
    assert!((one.axles - 0.5 * (3.778 + 2.5)).abs() < 1e-9);
    // Its lane load stands on 3 m and what it spreads, not on an axle's width.
    let lane = (3.0 + 0.478) / 1.2;
    assert!((one.uniform[0] - lane).abs() < 1e-9, "{one:?}");
    // One abnormal vehicle at a time.
    b.sweep = Some(plan(&["hb-45"]));
    assert_eq!(width(&b).abreast, 1);
    // A skew bridge says that it was taken as square.
    let mut skew = bridgemill(&["cs454-single"]);
    skew.spans[0].skew = 0.3;
    let said: Vec<&str> = swept(&skew).warnings.iter().map(|w| w.code()).collect();
    assert!(said.contains(&warning::SKEW) && said.contains(&warning::ACROSS_ASSUMED), "{said:?}");
}

/// A resultant beside the middle of the track leaves the part that is centred on it, and the heavier rail its half of the width; it never
/// helps, and the width follows radius, speed, cant and side force without jumps.
#[test]
fn centrifugal_and_side_forces_move_the_resultant() {
    let mut b = bridgemill(&["cs454-single"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    let (rule, vehicles) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    let width = |sideways: bridge::Sideways, edge: Option<f64>, lanes: usize| {
        let mut b = b.clone();
        b.carriageway =
            Some(bridge::Carriageway { lanes: Some(lanes), edge_distance: edge, sideways, ..Default::default() });
        across::worst(&b, &rule, &vehicles[0])
    };
    let none = bridge::Sideways::default();
    let alone = width(none, None, 1).axles;
    assert!((alone - 3.778).abs() < 1e-9);
    // By hand: 60 km/h on 300 m is 0.0944 of the weight, at 1.8 m of height 0.170 m outwards; cant of 90 mm on 1.5 m takes 0.108 m of it.
    let speed = 60.0 / 3.6;
    let curve = bridge::Sideways { curve: Some((300.0, speed)), ..none };
    let shift = 1.8 * speed * speed / (9.81 * 300.0);
    assert!((curve.eccentricity(9.81).0 - shift).abs() < 1e-12 && (shift - 0.1699).abs() < 1e-4, "{shift}");
    let canted = bridge::Sideways { cant: 0.09, ..curve };
    let (left, moving) = canted.eccentricity(9.81);
    assert!((left - 0.108).abs() < 1e-9 && !moving, "standing on the cant governs: {left}");
    // Centred part: 3.778 - 2 e; heavier rail: 3.778 / (1 + 2 e / 1.5).
    let found = width(curve, None, 1);
    assert!((found.axles - (alone - 2.0 * shift).min(alone / (1.0 + 2.0 * shift / 1.5))).abs() < 1e-9, "{found:?}");
    assert!(found.derivation.contains("that moves lies 0.170 m beside"), "{}", found.derivation);
    for edge in [None, Some(0.4)] {
        for lanes in [1, 2] {
            let mut before = width(none, edge, lanes).axles;
            for step in 1..=60 {
                let side = bridge::Sideways { side_force: 0.005 * f64::from(step), ..none };
                let found = width(side, edge, lanes).axles;
                assert!(found <= before + 1e-12 && found > 0.9 * before, "{edge:?} {lanes}: {found} after {before}");
                before = found;
            }
        }
    }
    // On strips between cracks the heavier wheel counts.
    let mut cracked = b.clone();
    let asked = |sideways| bridge::Carriageway {
        lanes: Some(1),
        edge_distance: Some(0.4),
        cracks: vec![0.8],
        sideways,
        ..Default::default()
    };
    cracked.carriageway = Some(asked(curve));
    let strip = across::worst(&cracked, &rule, &vehicles[0]);
    assert!((strip.axles - 0.8 / (0.5 + shift / 1.5)).abs() < 1e-9, "{strip:?}");
    // The result says what is left out of forces across.
    let mut told = b.clone();
    told.carriageway = Some(asked(curve));
    assert!(swept(&told).warnings.iter().any(|w| w.message().contains("not as forces on walls")));
}

/// A longitudinal crack never helps, follows its place without jumps, and leaves an edge strip what a closed form says.
#[test]
fn longitudinal_cracks_leave_strips() {
    for code in ["cs454-single", "cs454-double", "hl-93-tandem"] {
        let mut b = bridgemill(&[code]);
        b.sweep.as_mut().unwrap().rule = "cs-454".into();
        let Ok((rule, vehicles)) = chosen(&b, b.sweep.as_ref().unwrap()) else { continue };
        let width = |cracks: &[f64], lanes: Option<usize>, edge: Option<f64>| {
            let mut b = b.clone();
            let asked =
                bridge::Carriageway { lanes, edge_distance: edge, cracks: cracks.to_vec(), ..Default::default() };
            b.carriageway = Some(asked);
            across::worst(&b, &rule, &vehicles[0])
        };
        let sound = width(&[], Some(1), Some(0.4));
        let mut last: Option<f64> = None;
        for step in 1..830 {
            let at = 0.01 * f64::from(step);
            let one = width(&[at], Some(1), Some(0.4));
            assert!(one.axles <= sound.axles + 1e-12, "{code}: a crack at {at} m helps");
            assert_eq!(one.strip.is_some(), one.axles < sound.axles - 1e-12);
            let mirrored = width(&[b.width - at], Some(1), Some(0.4));
            assert!((one.axles - mirrored.axles).abs() < 1e-9, "{code}, {at} m: {} {}", one.axles, mirrored.axles);
            let two = width(&[at.min(4.0), 4.1], Some(1), Some(0.4));
            assert!(two.axles <= width(&[4.1], Some(1), Some(0.4)).axles + 1e-9, "{code}: a second crack helps");
            // A tyre is 0.3 m wide: over 10 mm its share changes by a thirtieth, and what it stands on by no more than that.
            if let Some(last) = last {
                assert!((one.axles / last - 1.0).abs() < 0.15, "{code}: from {last} to {} at {at} m", one.axles);
            }
            last = Some(one.axles);
        }
        // A crack at the very edge changes nothing.
        assert!((width(&[1e-6], Some(1), Some(0.4)).axles - sound.axles).abs() < 1e-5);
    }
    // One wheel on an edge strip 0.8 m wide, 0.4 m from the edge: half the axle on 0.8 m, as the whole axle on 1.6 m.
    let mut b = bridgemill(&["cs454-single"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    b.carriageway =
        Some(bridge::Carriageway { lanes: Some(1), edge_distance: Some(0.4), cracks: vec![0.8], ..Default::default() });
    let (rule, vehicles) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    let found = across::worst(&b, &rule, &vehicles[0]);
    assert!((found.axles - 1.6).abs() < 1e-9 && found.strip == Some([0.0, 0.8]), "{found:?}");
    assert!(found.derivation.contains("1.60 m"), "{}", found.derivation);
}

/// What stands beside an abnormal vehicle is found from what each carries by itself. Both on the bridge at once, on the width that they
/// share, carry no less, and not much more: they are worst at the same place.
#[test]
fn traffic_beside_an_abnormal_vehicle_is_counted_on_the_safe_side() {
    let mut b = bridgemill(&["hb-30"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    let plan = b.sweep.clone().unwrap();
    let found = swept(&b);
    let least = found.vehicles[0].adequacy.unwrap();
    let (rule, bare) = chosen(&b, &plan).unwrap();
    let given = (&found.weights[..], found.step);
    let with = beside::loaded(&b, (&rule, &plan), bare.clone(), given, &mut Unwatched).unwrap();
    let lane = with[0].beside.clone().unwrap();
    assert!(lane.share > 0.1 && found.vehicles[0].across.beside == lane.code, "{lane:?}");
    // The traffic by itself, at its own worst place, on a lane of its own.
    let mut own = b.clone();
    own.carriageway = Some(bridge::Carriageway { lanes: Some(1), ..bridge::Carriageway::default() });
    own.sweep.as_mut().unwrap().vehicles = vec![lane.code.clone()];
    let traffic = swept(&own);
    let (_, theirs) = chosen(&own, own.sweep.as_ref().unwrap()).unwrap();
    // Both cases under the weights of the first, each over the width that both share.
    let case = found.vehicles[0].case.as_ref().unwrap();
    let shared = found.vehicles[0].across.axles * (1.0 + lane.share);
    let factored = factored::bridge(&b, &rule, &case.weights);
    let first = factored::with_case(&factored, &plan, &rule, &bare[0], case);
    let second = factored::with_case(&factored, &plan, &rule, &theirs[0], traffic.vehicles[0].case.as_ref().unwrap());
    let (share, length) = (bare[0].acting.beside.as_ref().unwrap().share, structure::discretise::bridge_length(&b));
    // The bridge is symmetric: the traffic's worst place is on either side.
    let together = [false, true].map(|mirrored| {
        let mut both = first.clone();
        both.loads.iter_mut().for_each(|load| on_width(load, shared, 1.0));
        both.loads.extend(second.loads.iter().cloned().map(|mut load| {
            on_width(&mut load, shared, share);
            load.position = if mirrored { length - load.position } else { load.position };
            load
        }));
        both.plan.friction = bridge::Friction::Associated;
        let run = crate::analysis::collapse_by_limit(&both, &mut Unwatched).unwrap();
        run.collapse_load.unwrap() / run.reference_load * rule.capacity_factor()
    });
    let together = together[0].min(together[1]);
    assert!(least <= together * (1.0 + 1e-6) && least > 0.8 * together, "{least} {together}");
}

/// An axle of a share of its force over a width.
fn on_width(load: &mut bridge::Load, width: f64, share: f64) {
    let bridge::LoadKind::Axles { axles, effective_width, .. } = &mut load.kind else { panic!("an axle") };
    axles.iter_mut().for_each(|axle| axle.0 *= share);
    *effective_width = width;
}
