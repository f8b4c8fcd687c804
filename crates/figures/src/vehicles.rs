//! Adequacy factors of vehicles, worst first, and the factor of the governing one over its position.

use crate::envelope::{Ordinate, Sweep, envelope};
use crate::factor_bars::{Bar, factor_bars};
use outcome::vehicles::{Direction, EnvelopePoint, Swept, VehicleSweep};

/// Names and drawings of a sweep of vehicles.
pub fn vehicles(found: &VehicleSweep) -> Vec<(&'static str, String)> {
    let governing = found.governing.and_then(|k| found.vehicles.get(k)).and_then(|v| {
        let title = format!("{}: {}", found.bridge, v.title);
        let case = found.collapse.as_ref().and_then(|collapse| collapse.picture.case.as_ref());
        let note = case.map(|case| format!("Governing: {case} The first axle is the foremost of the whole vehicle, whether it stands on the bridge or has passed it."));
        envelope(&title, Ordinate::Adequacy, &curves(v), note.as_deref())
    });
    let all = [("adequacy", adequacy(found)), ("envelope", governing)];
    all.into_iter().filter_map(|(name, svg)| Some((name, svg?))).collect()
}

/// One of the factors at a position.
type Factor = fn(&EnvelopePoint) -> Option<f64>;

/// The least factor over arrangements at every place of the first axle, one curve for each way.
fn curves(v: &Swept) -> Vec<Sweep> {
    // Beside the spans factors grow without bound; far above the governing one they are only a line that leaves the frame.
    let least = v.envelope.iter().filter_map(|p| p.adequacy).fold(f64::INFINITY, f64::min);
    let drawn = |a: Option<f64>| a.map_or(f64::NAN, |a| a.min(8.0 * least));
    let ways = [(Direction::Right, "travelling to the right"), (Direction::Left, "travelling to the left")];
    let factors: &[(Factor, &str)] = match v.deformable {
        Some(_) => &[(|p| p.deformable, "deformable joints"), (|p| p.rigid, "rigid blocks")],
        None => &[(|p| p.adequacy, "")],
    };
    let both_ways = ways.iter().all(|(way, _)| v.envelope.iter().any(|p| p.case.direction == *way));
    let mut curves = Vec::new();
    for (factor, method) in factors {
        for (way, words) in ways {
            // A case answered by one method alone is no gap in the other's curve.
            let own = v.envelope.iter().filter(|p| p.case.direction == way);
            let own = own.filter(|p| v.deformable.is_none() || factor(p).is_some() || !p.converged);
            let mut points: Vec<(f64, f64)> = own.map(|p| (p.case.position, drawn(factor(p)))).collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            points.dedup_by(|next, kept| {
                let same = (next.0 - kept.0).abs() < 1e-6;
                if same && (next.1 < kept.1 || kept.1.is_nan()) {
                    kept.1 = next.1;
                }
                same
            });
            let words: Vec<&str> =
                [*method, if both_ways { words } else { "" }].into_iter().filter(|w| !w.is_empty()).collect();
            if !points.is_empty() {
                curves.push(Sweep { label: words.join(", "), points });
            }
        }
    }
    // A vehicle that looks the same from both ends drives one way only, and needs no key.
    if let [alone] = &mut curves[..] {
        alone.label.clear();
    }
    curves
}

/// A bar for every vehicle, worst on top, with a line where the factor is one.
fn adequacy(found: &VehicleSweep) -> Option<String> {
    let mut bars: Vec<Bar<'_>> = found
        .vehicles
        .iter()
        .filter_map(|v| Some(Bar { label: &v.code, factor: v.adequacy?, beyond: v.rigid }))
        .collect();
    bars.sort_by(|a, b| a.factor.total_cmp(&b.factor).then_with(|| a.label.cmp(b.label)));
    let least = bars.first()?.factor;
    let both = found.vehicles.iter().any(|v| v.deformable.is_some());
    let method = if both { ", the smaller of rigid blocks and deformable joints" } else { " by limit analysis" };
    let words = match least < 1.0 {
        true => "left of the dashed line the bridge does not carry the vehicle with the rule's factors",
        false => "right of the dashed line the bridge carries the vehicle with the rule's factors",
    };
    let outlined = if both { "; outlined: what rigid blocks would carry" } else { "" };
    let second = format!("Adequacy factor of vehicles{method}, rule \u{201c}{}\u{201d}", found.rule.code);
    let words = format!("{words}{outlined}");
    factor_bars("adequacy", [&found.bridge, &second], "adequacy factor [–]", &bars, &words)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::factor_bars::{ENOUGH, SHORT};
    use outcome::collapse::Status;
    use outcome::vehicles::{Across, Case, Weights};

    fn swept(code: &str, adequacy: Option<f64>) -> Swept {
        let case = |k: usize, direction| Case {
            position: k as f64,
            direction,
            arrangement: String::new(),
            axles: Some([0, 0]),
            critical_axle: None,
            uniform: None,
            horizontal: 0.0,
            load: 0.0,
            weights: Weights { masonry: 1.0, fill: None, surfacing: None },
        };
        let point = |k: usize, direction| EnvelopePoint {
            adequacy: adequacy.map(|a| a * (1.0 + (k as f64 - 5.0).powi(2))),
            ..EnvelopePoint::at(case(k, direction))
        };
        let library = outcome::rules::library().expect("library");
        let (rule, model) = (library.rule("cs-454").expect("rule"), library.model("cs-454").expect("model"));
        Swept {
            across: Across { abreast: 1, axles: 3.0, ..Across::default() },
            span_factors: vec![1.0],
            acting: rule.acting(model).expect("factors"),
            source: model.source.clone(),
            code: code.to_owned(),
            title: code.to_uppercase(),
            model: code.to_owned(),
            grade: None,
            status: Status::Collapsed,
            adequacy,
            adequacy_at_most: None,
            positions_not_converged: 0,
            bounds: adequacy.map(|a| [a; 2]),
            without_dilation: None,
            case: None,
            weights: None,
            envelope: (0..11).flat_map(|k| [point(k, Direction::Right), point(k, Direction::Left)]).collect(),
            sections: Vec::new(),
            effective_width: 3.0,
            load_factors: [1.0; 2],
            cases: 22,
            by_interior_point: 0,
            rigid: None,
            deformable: None,
            not_counted: Default::default(),
        }
    }

    fn sweep(vehicles: Vec<Swept>, governing: Option<usize>) -> VehicleSweep {
        VehicleSweep {
            restrictions: Vec::new(),
            bridge: "Bridge".into(),
            rule: outcome::rules::library().expect("library").rules.remove(0),
            weights: Vec::new(),
            vehicles,
            governing,
            collapse: None,
            discrete_elements: None,
            step: 1.0,
            warnings: Vec::new(),
            assumptions: Vec::new(),
        }
    }

    #[test]
    fn every_vehicle_has_a_bar_and_the_governing_one_its_curves() {
        let found = sweep(vec![swept("strong", Some(4.0)), swept("locks", None), swept("weak", Some(0.8))], Some(2));
        let drawings = vehicles(&found);
        let names: Vec<&str> = drawings.iter().map(|d| d.0).collect();
        assert_eq!(names, ["adequacy", "envelope"]);
        let bars = &drawings[0].1;
        assert_eq!(bars.matches("class=\"vehicle\"").count(), 2, "{bars}");
        assert!(bars.find(">weak<") < bars.find(">strong<"), "worst on top");
        assert!(bars.contains(SHORT) && bars.contains(ENOUGH) && !bars.contains(">locks<"));
        let curves = &drawings[1].1;
        assert_eq!(curves.matches("class=\"sweep\"").count(), 2);
        assert!(curves.contains("governing: 0.8 at 5") || curves.contains("governing: 0.8000 at 5"), "{curves}");
        assert!(vehicles(&sweep(vec![swept("locks", None)], None)).is_empty());
    }
}
