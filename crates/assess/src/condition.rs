//! Condition: what records say of the bridge's materials, in words that its owner understands.

use crate::evidence::Evidence;
use bridge::assess::Expected;
use bridge::quantity;
use outcome::condition::{Condition, Standing};
use outcome::update::Update;

/// Every parameter of the update, in its order, then expectations that no parameter meets.
pub fn condition(assessment: &Evidence) -> Vec<Condition> {
    let Some(update) = assessment.facts.update.made() else { return Vec::new() };
    let expected = &assessment.asked.expected;
    let all = Sought::all(update);
    let mut list: Vec<Condition> = all.iter().map(|one| judged(one, expected)).collect();
    for lone in expected.iter().filter(|lone| all.iter().all(|one| one.name != lone.parameter)) {
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

/// A parameter that was sought.
#[derive(Default)]
struct Sought {
    name: String,
    unit: String,
    /// Value of the start model.
    start: f64,
    /// Value at the end.
    value: Option<f64>,
    at_bound: bool,
    /// Whether the records tell it.
    identifiable: Option<bool>,
    /// Whether they tell it no better than the loads of the train and the width that carries them are known.
    limited_by_gain: bool,
    interval_95: Option<[f64; 2]>,
}

impl Sought {
    fn all(update: &Update) -> Vec<Sought> {
        let one = |(k, parameter): (usize, &calibrate::Parameter)| {
            let end = update.found().map(|found| &found.parameters[k]);
            Sought {
                name: parameter.name.clone(),
                unit: parameter.unit.clone(),
                start: parameter.start,
                value: end.map(|end| end.value),
                at_bound: end.is_some_and(|end| end.at_bound),
                identifiable: update.identifiable(k),
                limited_by_gain: update.limited_by_gain(k),
                interval_95: update.summary(k).map(|summary| summary.interval_95),
            }
        };
        update.problem.parameters().iter().enumerate().map(one).collect()
    }
}

fn judged(one: &Sought, expected: &[Expected]) -> Condition {
    let wanted = expected.iter().find(|wanted| wanted.parameter == one.name);
    // Ends of ranges are SI or bare; the parameter has a unit of its own.
    let size = match one.unit.as_str() {
        "" => 1.0,
        unit => quantity::parse(&format!("1 {unit}")).map_or(1.0, |one| one.si()),
    };
    let range = wanted.map(|wanted| [wanted.lower / size, wanted.upper / size]);
    // An interval that holds what the loads may be off by is concluded from where it lies on one side of every limit.
    let settled = |[low, high]: [f64; 2], [lower, upper]: [f64; 2]| {
        high < lower || low > upper || (low >= lower && high <= upper)
    };
    let open = match (one.interval_95, range) {
        (Some(interval), Some(range)) => !settled(interval, range),
        _ => true,
    };
    let (standing, words) = match (one.value, range, wanted) {
        (None, _, _) => (Standing::Untold, "No value was found that fits the measurements, so nothing is known about \
                                            it.".to_owned()),
        (Some(_), _, _) if one.at_bound => (
            Standing::Untold,
            "The measurements led to the end of its allowed range, so its true value is not known. Nothing is \
             concluded from it: have the range reviewed, or this part inspected."
                .to_owned(),
        ),
        (Some(_), Some(_), _) if one.identifiable == Some(false) && one.limited_by_gain && open => (
            Standing::Untold,
            "The measurements determine it only as well as the weight of the vehicle and the width that carries it are known, and its \
             interval reaches past an end of the expected range. Nothing is concluded from it, neither good nor bad; a weighed vehicle would \
             give more information."
                .to_owned(),
        ),
        (Some(_), _, _) if one.identifiable == Some(false) && !one.limited_by_gain => (
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

    fn parameter(value: f64) -> Sought {
        Sought { name: "mortar".into(), unit: "MPa".into(), start: 1250.0, value: Some(value), ..Sought::default() }
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
        let bound = Sought { at_bound: true, ..parameter(500.0) };
        let blind = Sought { identifiable: Some(false), ..parameter(500.0) };
        assert_eq!(
            (judged(&bound, &expected()).standing, judged(&blind, &expected()).standing),
            (Standing::Untold, Standing::Untold)
        );
    }

    /// Mortar that scales all channels: known as well as the loads, expected between 1000 and 2000 MPa.
    #[test]
    fn what_the_loads_leave_open_is_concluded_from_where_the_whole_interval_agrees() {
        let with = |value: f64, interval: [f64; 2]| {
            let (identifiable, interval_95) = (Some(false), Some(interval));
            judged(&Sought { identifiable, interval_95, limited_by_gain: true, ..parameter(value) }, &expected())
        };
        assert_eq!(with(700.0, [550.0, 900.0]).standing, Standing::Lower);
        assert_eq!(with(1500.0, [1200.0, 1800.0]).standing, Standing::AsExpected);
        assert_eq!(with(2800.0, [2200.0, 3400.0]).standing, Standing::Higher);
        let open = with(900.0, [720.0, 1100.0]);
        assert!(open.standing == Standing::Untold && open.words.contains("weight of the vehicle"), "{open:?}");
        let unknown = Sought { identifiable: Some(false), limited_by_gain: true, ..parameter(900.0) };
        assert_eq!(judged(&unknown, &expected()).standing, Standing::Untold);
    }
}
