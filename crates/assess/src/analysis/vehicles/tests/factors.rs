//! Factors of rules on weights, strengths and loads, and the load models that a rule is made for.

use super::*;
use outcome::vehicles::Weights;

#[test]
fn factors_of_a_rule_divide_the_factor() {
    // Axles, and axles with uniform loads beside them.
    let mut b = bridgemill(&["cs454-single", "lm71"]);
    let before = swept(&b);
    let text = rules::FILES[1].iter().find(|f| f.0 == "characteristic").unwrap().1;
    let twice = text.replacen("[factors.live_load]\nvalue = 1.0", "[factors.live_load]\nvalue = 2.0", 1);
    let worse = twice.replacen("[factors.condition]\nvalue = 1.0", "[factors.condition]\nvalue = 0.8", 1);
    let plan = b.sweep.as_mut().unwrap();
    plan.rule_file = Some("own.toml".into());
    plan.texts = vec![("own.toml".into(), worse)];
    let found = swept(&b);
    for (plain, v) in before.vehicles.iter().zip(&found.vehicles) {
        let share = v.adequacy.unwrap() / plain.adequacy.unwrap();
        assert!((share / (0.8 / 2.0) - 1.0).abs() < 1e-9, "{}: {share}", v.code);
    }
    assert_eq!(found.vehicles[0].load_factors, [2.0, 1.8]);
    // A factor left out is no factor of one.
    b.sweep.as_mut().unwrap().texts[0].1 = text.replacen("[factors.live_load]", "[factors.lively_load]", 1);
    let said = vehicle_sweep(&b, &mut Unwatched).unwrap_err().to_string();
    assert!(said.contains("own.toml") && said.contains("lively_load"), "{said}");
}

/// More weight holds an arch of this shape together, so that adverse factors would raise its adequacy: weights that help have
/// their favourable factor, and no factor on weights may give more than weights without factors.
#[test]
fn weights_that_help_have_the_favourable_factor() {
    let mut b = bridgemill(&["hb-45", "cs454-single"]);
    b.cover.layers.push(Layer {
        name: LayerKind::Surfacing,
        thickness: 0.1,
        density: 2300.0,
        ..b.cover.layers[0].clone()
    });
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    // One lane: what stands beside HB is another matter.
    b.carriageway = Some(bridge::Carriageway { lanes: Some(1), ..bridge::Carriageway::default() });
    let found = swept(&b);
    assert_eq!(found.weights.len(), 8);
    let (rule, _) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    let text = rules::FILES[1].iter().find(|f| f.0 == "cs-454").unwrap().1.to_owned();
    let with = |factors: [f64; 3]| {
        let [m, f, s] = factors;
        let text = text
            .replacen("value = 1.15", &format!("value = {m:?}"), 1)
            .replacen("value = 1.2", &format!("value = {f:?}"), 1)
            .replacen("value = 1.75", &format!("value = {s:?}"), 1);
        // One set of factors, whatever helps.
        let mut plan = b.sweep.clone().unwrap();
        plan.rule_file = Some("own.toml".into());
        plan.texts = vec![("own.toml".into(), text)];
        let mut one = b.clone();
        one.sweep = Some(plan);
        let (own, vehicles) = chosen(&one, one.sweep.as_ref().unwrap()).unwrap();
        let weights = vec![Weights { masonry: m, fill: Some(f), surfacing: Some(s) }];
        assert_eq!(own.factors.masonry_weight.value, m);
        search::all(
            &Traffic::new(&one, (&own, one.sweep.as_ref().unwrap()), (&vehicles, &weights)).unwrap(),
            (found.step, true),
            &mut Unwatched,
        )
        .unwrap()
    };
    let (plain, adverse) = (with([1.0; 3]), with([1.15, 1.2, 1.75]));
    for (k, v) in found.vehicles.iter().enumerate() {
        let [least, plain, adverse] = [v, &plain[k], &adverse[k]].map(|v| v.adequacy.unwrap());
        assert!(adverse > 1.02 * plain, "{}: adverse factors alone would raise {plain} to {adverse}", v.code);
        assert!(least <= plain * (1.0 + 1e-9), "{}: {least} {plain}", v.code);
        // Another road: every combination by a sweep of its own.
        let all = found.weights.iter().map(|w| {
            let one = search::all(
                &Traffic::new(
                    &b,
                    (&rule, b.sweep.as_ref().unwrap()),
                    (&chosen(&b, b.sweep.as_ref().unwrap()).unwrap().1, &[*w]),
                )
                .unwrap(),
                (found.step, true),
                &mut Unwatched,
            );
            one.unwrap()[k].adequacy.unwrap()
        });
        let smallest = all.fold(f64::INFINITY, f64::min);
        // The worst place between positions is sought under the weights that govern at positions.
        assert!((least / smallest - 1.0).abs() < 1e-6, "{}: {least} {smallest}", v.code);
    }
    let is_lightest = |said: &Note| {
        let Note::Moving(Moving::EveryWeight { combinations: 8, governing }) = said else { return false };
        matches!(governing, Governing::Vehicle { weights, .. } if weights.masonry == 1.0)
    };
    assert!(found.assumptions.iter().any(is_lightest), "{:?}", found.assumptions);
    // Heavier masonry by a tenth must not make the bridge better than it is without factors.
    let mut heavy = b.clone();
    heavy.masonry.density *= 1.1;
    let heavier = swept(&heavy).vehicles[0].adequacy.unwrap();
    assert!(heavier < adverse[0].adequacy.unwrap());
}

/// The factor is a concave function of the weights, so that it is least at a corner.
#[test]
fn no_weight_between_the_factors_is_worse() {
    let mut b = bridgemill(&["hb-45"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    let found = swept(&b);
    let (rule, vehicles) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    let least = found.vehicles[0].adequacy.unwrap();
    for (m, f) in [(1.05, 1.0), (1.15, 1.1), (1.0, 1.13), (1.1, 1.05)] {
        let weights = [Weights { masonry: m, fill: Some(f), surfacing: None }];
        let between = search::all(
            &Traffic::new(&b, (&rule, b.sweep.as_ref().unwrap()), (&vehicles, &weights)).unwrap(),
            (found.step, true),
            &mut Unwatched,
        )
        .unwrap();
        let between = between[0].adequacy.unwrap();
        assert!(between > least * (1.0 - 1e-6), "{m} {f}: {between} {least}");
    }
}

/// The text of a rule with other values in the place of its factors, as an engineer's own file.
pub(super) fn own_rule(b: &mut Bridge, code: &str, changes: &[(&str, &str)]) {
    let mut text = rules::FILES[1].iter().find(|f| f.0 == code).unwrap().1.to_owned();
    for (old, new) in changes {
        assert!(text.contains(old), "{old}");
        text = text.replacen(old, new, 1);
    }
    let plan = b.sweep.as_mut().unwrap();
    plan.rule_file = Some("own.toml".into());
    plan.texts = vec![("own.toml".into(), text)];
}

/// Factors on what resists divide it: a bridge with them is one of that much weaker stuff, and never stronger.
#[test]
fn factors_on_resistance_make_the_bridge_weaker() {
    let mut b = bridgemill(&["cs454-single"]);
    b.masonry.compressive_strength = Some(10e6);
    b.fill_pressure = Some(bridge::FillPressure {
        applies: true,
        friction_angle: 30f64.to_radians(),
        cohesion: 10e3,
        mobilisation: 0.5,
        cohesion_mobilisation: 0.1,
        least: bridge::LeastPressure::AtRest,
        half_movement: 0.02,
    });
    let factor = |name: &str, value: &str| {
        (format!("[factors.{name}]\nvalue = 1.0"), format!("[factors.{name}]\nvalue = {value}"))
    };
    // As described: what fill pressure adds is not counted, and would not show.
    let adequacy = |b: &Bridge| with_braking(b, &mut Unwatched).unwrap().vehicles[0].adequacy.unwrap();
    let plain = adequacy(&b);
    for name in ["masonry_strength", "friction", "fill_pressure"] {
        let (old, new) = factor(name, "1.25");
        let mut with = b.clone();
        own_rule(&mut with, "characteristic", &[(&old, &new)]);
        let mut weaker = b.clone();
        match name {
            "masonry_strength" => weaker.masonry.compressive_strength = Some(8e6),
            "friction" => {
                for joint in [&mut weaker.joint, &mut weaker.ring_joint] {
                    joint.friction_angle = (0.8 * joint.friction_angle.tan()).atan();
                }
            }
            _ => {
                let fill = weaker.fill_pressure.as_mut().unwrap();
                (fill.mobilisation, fill.cohesion_mobilisation) = (0.4, 0.08);
            }
        }
        let [with, weaker] = [adequacy(&with), adequacy(&weaker)];
        assert!((with / weaker - 1.0).abs() < 1e-9, "{name}: {with} {weaker}");
        assert!(with <= plain * (1.0 + 1e-9), "{name}: {with} {plain}");
    }
    let (rule, _) = {
        let (old, new) = factor("friction", "1.25");
        own_rule(&mut b, "characteristic", &[(&old, &new)]);
        chosen(&b, b.sweep.as_ref().unwrap()).unwrap()
    };
    let weights = Weights { masonry: 1.0, fill: Some(1.0), surfacing: None };
    let joint = factored::bridge(&b, &rule, &weights).joint;
    assert!((joint.friction_angle.tan() / b.joint.friction_angle.tan() - 0.8).abs() < 1e-12);
}

/// Every weight of the bridge has the factor of its own group.
#[test]
fn every_weight_has_the_factor_of_its_group() {
    let mut b = bridgemill(&[]);
    b.cover.layers.push(Layer { name: LayerKind::Surfacing, ..b.cover.layers[0].clone() });
    b.cover.layers.push(Layer { name: LayerKind::Ballast, ..b.cover.layers[0].clone() });
    b.cover.backing = Some(samples::backing(1.0));
    b.spandrel_wall = Some(samples::spandrel_wall(&b));
    let mut factored = b.clone();
    weights::put(&Weights { masonry: 2.0, fill: Some(3.0), surfacing: Some(5.0) }, &mut factored);
    assert_eq!(factored.masonry.density / b.masonry.density, 2.0);
    let layers: Vec<f64> =
        factored.cover.layers.iter().zip(&b.cover.layers).map(|(a, b)| a.density / b.density).collect();
    assert_eq!(layers, [3.0, 5.0, 5.0]);
    assert_eq!(factored.cover.backing.unwrap().density, 6000.0);
    assert_eq!(factored.spandrel_wall.unwrap().density, 4000.0);
}

/// The rule spreads loads through the cover, and what is spread harms less.
#[test]
fn loads_spread_as_the_rule_says() {
    let mut b = bridgemill(&["cs454-single"]);
    own_rule(&mut b, "cs-454", &[("length_per_depth = 1.0", "length_per_depth = 0.0")]);
    let on_a_spot = swept(&b).vehicles[0].adequacy.unwrap();
    own_rule(&mut b, "cs-454", &[("length_per_depth = 1.0", "length_per_depth = 2.0")]);
    let wide = swept(&b).vehicles[0].adequacy.unwrap();
    b.sweep = Some(SweepPlan { rule: "cs-454".into(), ..plan(&["cs454-single"]) });
    let spread = swept(&b).vehicles[0].adequacy.unwrap();
    assert!(on_a_spot < 0.99 * spread && spread < 0.99 * wide, "{on_a_spot} {spread} {wide}");
}

/// A rule acts on the load models that it was made for, and refuses others by name, all of them at once.
#[test]
fn a_vehicle_is_refused_under_a_rule_that_was_not_made_for_it() {
    let mut b = bridgemill(&["lm1", "hl-93-truck", "LM71", "cs454-single", "hb46"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    let said = vehicle_sweep(&b, &mut Unwatched).unwrap_err().to_string();
    for part in ["\"lm1\"", "\"hl-93-truck\"", "\"LM71\"", "characteristic, en-1991-2", "[[under]]"] {
        assert!(said.contains(part), "{part}: {said}");
    }
    assert!(said.contains("\"hb46\"") && !said.contains("cs454-single\" of load"), "{said}");
    // Names are the same in capitals, and a near one is told.
    let known = bridgemill(&["LM71", "Cs454-Bogie-10"]);
    assert_eq!(chosen(&known, known.sweep.as_ref().unwrap()).unwrap().1.len(), 2);
    let near = bridgemill(&["cs454-bogie-11"]);
    let said = vehicle_sweep(&near, &mut Unwatched).unwrap_err().to_string();
    assert!(said.contains("write \"cs454-bogie-10\", or"), "{said}");
}

/// HB contains impact: under CS 454 it has 1.3 and nothing on top, where axles of CS 454 have 1.9 and 1.8 on the critical one.
#[test]
fn loads_that_contain_impact_get_none() {
    let mut b = bridgemill(&["hb-45", "cs454-single"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    let found = swept(&b);
    let factors: Vec<[f64; 2]> = found.vehicles.iter().map(|v| v.load_factors).collect();
    assert_eq!(factors, [[1.3, 1.0], [1.9, 1.8]]);
    assert!(found.vehicles[0].case.as_ref().unwrap().critical_axle.is_none());
    let said: Vec<&str> = found.warnings.iter().map(|w| w.code()).collect();
    assert!(said.contains(&warning::RECALLED_FACTOR) && said.contains(&warning::NO_LONGITUDINAL), "{said:?}");
}

/// A load model is refused on spans for which it is known to fall short, and left out, with a word, where it was not named.
#[test]
fn spans_that_are_too_long_for_a_load_model_are_refused() {
    let mut b = spans(2);
    b.spans[1].span = 16.0;
    b.spans[1].rise = 4.0;
    b.sweep = Some(SweepPlan { rule: "irs-bridge-rules".into(), ..plan(&["25t-2008"]) });
    let said = vehicle_sweep(&b, &mut Unwatched).unwrap_err().to_string();
    assert!(said.contains("not made for spans over 14 m") && said.contains("16 m"), "{said}");
    b.sweep.as_mut().unwrap().vehicles.clear();
    let out = crate::vehicles::left_out(&b, b.sweep.as_ref().unwrap());
    assert!(out.len() == 2 && out[0].model == "25t-2008", "{out:?}");
    b.spans[1] = b.spans[0].clone();
    let (_, vehicles) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    assert!(vehicles.iter().any(|v| v.vehicle.code == "25t-2008"));
}

/// Load models that are taken only by name stay out of a sweep of all that a rule is made for; named, they are swept, and a
/// vehicle of uniform loads alone has a factor with both bounds.
#[test]
fn some_load_models_are_taken_only_by_name() {
    let mut b = bridgemill(&["sw-0", "lm2"]);
    let found = swept(&b);
    assert_eq!(found.vehicles.len(), 2);
    for (k, v) in found.vehicles.iter().enumerate() {
        let [lower, upper] = v.bounds.unwrap();
        assert!((upper / lower - 1.0).abs() < 1e-8, "{}: {lower} {upper}", v.code);
        assert!((lower / alone(&b, &found, k) - 1.0).abs() < 1e-6, "{}", v.code);
    }
    let case = found.vehicles[0].case.clone().unwrap();
    assert!(case.axles.is_none() && case.uniform.is_some(), "{case:?}");
    b.sweep.as_mut().unwrap().vehicles.clear();
    let (_, all) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    assert!(all.iter().any(|v| v.vehicle.code == "lm71") && all.iter().all(|v| v.vehicle.code != "sw-0"));
}

/// On spans of 3 and 12 m an axle has the coefficient of the span that it stands on, not the shortest's on both.
#[test]
fn motion_adds_by_the_span_that_is_loaded() {
    let mut b = spans(2);
    b.cover.depth = 0.0;
    b.spans[0].span = 3.0;
    b.spans[0].rise = 0.75;
    b.spans[1].span = 12.0;
    b.spans[1].rise = 3.0;
    b.sweep = Some(SweepPlan { rule: "irs-bridge-rules".into(), ..plan(&["25t-2008-close"]) });
    let (rule, vehicles) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    let foot = factored::footprint(&b, b.sweep.as_ref().unwrap(), &rule, &vehicles[0]);
    let long = 1.0 + 0.15 + 8.0 / 18.0;
    let places = [-1.0, 1.5, 3.5, 4.5, 10.0, 20.0].map(|x| foot.axle_at(x));
    for (found, wanted) in places.iter().zip([2.0, 2.0, 2.0, long, long, long]) {
        assert!((found - wanted).abs() < 1e-12, "{places:?}");
    }
    let pieces = foot.pieces(1.0, 6.0);
    for (found, wanted) in pieces.iter().zip([(1.0, 4.0, 2.0), (4.0, 6.0, long)]) {
        let apart = [found.0 - wanted.0, found.1 - wanted.1, found.2 - wanted.2];
        assert!(pieces.len() == 2 && apart.iter().all(|d| d.abs() < 1e-12), "{pieces:?}");
    }
}

/// Cohesion and tension of joints are divided as friction and strength are.
#[test]
fn cohesion_of_joints_has_a_factor() {
    let mut b = bridgemill(&["cs454-single"]);
    b.sweep.as_mut().unwrap().rule = "cs-454".into();
    for joint in [&mut b.joint, &mut b.ring_joint] {
        (joint.cohesion, joint.tensile_strength) = (100e3, 40e3);
    }
    let (rule, _) = chosen(&b, b.sweep.as_ref().unwrap()).unwrap();
    let weights = Weights { masonry: 1.0, fill: Some(1.0), surfacing: None };
    let factored = factored::bridge(&b, &rule, &weights);
    for joint in [factored.joint, factored.ring_joint] {
        assert_eq!((joint.cohesion, joint.tensile_strength), (50e3, 20e3), "as the strength of masonry, 2");
    }
    let text = rules::FILES[1].iter().find(|f| f.0 == "cs-454").unwrap().1;
    let own = format!(
        "{text}\n[factors.cohesion]\nvalue = 4.0\nsource = {{ text = \"own\", date = \"2026\", confidence = \"assumed\" }}\n"
    );
    let own = rules::read_rule("own.toml", &own).unwrap();
    assert_eq!(factored::bridge(&b, &own, &weights).joint.cohesion, 25e3);
}
