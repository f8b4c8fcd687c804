//! Condition: what records say of the bridge's materials, in words that its owner understands.

use crate::evidence::Evidence;
use bridge::assess::Expected;
use bridge::quantity;
use outcome::condition::{Condition, Standing};
use outcome::facts::ParameterFacts;

/// Every parameter of the update, in its order, then expectations that no parameter meets.
pub fn condition(assessment: &Evidence) -> Vec<Condition> {
    let Some(facts) = assessment.facts.update.made() else { return Vec::new() };
    let expected = &assessment.asked.expected;
    let mut list: Vec<Condition> = facts.parameters.iter().map(|one| judged(one, expected)).collect();
    for lone in expected.iter().filter(|lone| facts.parameters.iter().all(|one| one.name != lone.parameter)) {
        list.push(Condition {
            parameter: lone.parameter.clone(),
            unit: String::new(),
            before: f64::NAN,
            after: None,
            expected: None,
            source: lone.source.clone(),
            standing: Standing::Untold,
            words: format!(
                "The file expects something of {}, which is none of its [[parameter]] tables.",
                lone.parameter
            ),
        });
    }
    list
}

fn judged(one: &ParameterFacts, expected: &[Expected]) -> Condition {
    let wanted = expected.iter().find(|wanted| wanted.parameter == one.name);
    // Ends of ranges are SI or bare; the parameter has a unit of its own.
    let size = match one.unit.as_str() {
        "" => 1.0,
        unit => quantity::parse(&format!("1 {unit}")).map_or(1.0, |one| one.si()),
    };
    let range = wanted.map(|wanted| [wanted.lower / size, wanted.upper / size]);
    let (standing, words) = match (one.value, range, wanted) {
        (None, _, _) => (Standing::Untold, "No value was found that fits the measurements, so nothing is known about \
                                            it.".to_owned()),
        (Some(_), _, _) if one.at_bound => (
            Standing::Untold,
            "The measurements led to the end of its allowed range, so its true value is not known. Nothing is \
             concluded from it: have the range reviewed, or this part inspected."
                .to_owned(),
        ),
        (Some(_), _, _) if one.identifiable == Some(false) => (
            Standing::Untold,
            "The measurements do not determine it: very different values would fit them equally well. Nothing is \
             concluded from it, neither good nor bad; sensors closer to this part would give more \
             information.".to_owned(),
        ),
        (Some(_), None, _) => (Standing::NothingExpected, "The file gives no expected range for it.".to_owned()),
        (Some(value), Some([lower, _]), Some(wanted)) if value < lower => (
            Standing::Lower,
            wanted.below.clone().unwrap_or_else(|| {
                "It is lower than in a sound bridge of this kind: ask for an inspection of this part.".to_owned()
            }),
        ),
        (Some(value), Some([_, upper]), Some(wanted)) if value > upper => (
            Standing::Higher,
            wanted.above.clone().unwrap_or_else(|| {
                "It is higher than expected: the bridge is stiffer here than was assumed. Ask why before relying on it.".to_owned()
            }),
        ),
        _ => (Standing::AsExpected, "It is as expected in a sound bridge of this kind.".to_owned()),
    };
    Condition {
        parameter: one.name.clone(),
        unit: one.unit.clone(),
        before: one.start,
        after: one.value,
        expected: range,
        source: wanted.and_then(|wanted| wanted.source.clone()),
        standing,
        words,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parameter(value: f64) -> ParameterFacts {
        ParameterFacts {
            name: "mortar".into(),
            unit: "MPa".into(),
            start: 1250.0,
            value: Some(value),
            ..ParameterFacts::default()
        }
    }

    fn expected() -> Vec<Expected> {
        let below = Some("deteriorated".to_owned());
        vec![Expected { parameter: "mortar".into(), lower: 1e9, upper: 2e9, source: None, below, above: None }]
    }

    #[test]
    fn a_value_is_judged_in_its_own_unit() {
        let low = judged(&parameter(972.0), &expected());
        assert_eq!(
            (low.standing, low.words.as_str(), low.expected),
            (Standing::Lower, "deteriorated", Some([1000.0, 2000.0]))
        );
        assert_eq!(judged(&parameter(1500.0), &expected()).standing, Standing::AsExpected);
        assert_eq!(judged(&parameter(2500.0), &expected()).standing, Standing::Higher);
        assert_eq!(judged(&parameter(2500.0), &[]).standing, Standing::NothingExpected);
    }

    #[test]
    fn nothing_is_concluded_from_what_the_records_do_not_tell() {
        let bound = ParameterFacts { at_bound: true, ..parameter(500.0) };
        let blind = ParameterFacts { identifiable: Some(false), ..parameter(500.0) };
        assert_eq!(
            (judged(&bound, &expected()).standing, judged(&blind, &expected()).standing),
            (Standing::Untold, Standing::Untold)
        );
    }
}
