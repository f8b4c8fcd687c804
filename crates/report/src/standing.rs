//! Where the train stands when the bridge answers most.

use crate::numbers::digits;
use outcome::facts::{SectionFacts, ServiceFacts, Watched};

/// Of every load, kind of place and quantity the least and the greatest value, and where the first axle stands then: load, place, value, position [m].
pub(crate) fn standing(facts: &ServiceFacts) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    for load in &facts.loads {
        let mut kinds: Vec<(&SectionFacts, &SectionFacts)> = Vec::new();
        for one in &load.places {
            let same = kinds.iter_mut().find(|(least, _)| least.place == one.place && least.quantity == one.quantity);
            match same {
                None => kinds.push((one, one)),
                Some((least, greatest)) => {
                    if one.minimum < least.minimum {
                        *least = one;
                    }
                    if one.maximum > greatest.maximum {
                        *greatest = one;
                    }
                }
            }
        }
        for (least, greatest) in kinds {
            let (unit, signs) = match least.quantity {
                Watched::Deflection => ("mm", ["downwards", "upwards"]),
                Watched::Stress => ("MPa", ["compression", "tension"]),
            };
            let row = |one: &SectionFacts, value: f64, at: f64, sign: &str| {
                vec![
                    load.name.clone(),
                    format!("{}, most {sign}", one.about),
                    format!("{} {unit}", digits(value)),
                    format!("{at:.2}").replace('-', "−"),
                ]
            };
            rows.push(row(least, least.minimum, least.minimum_at_m, signs[0]));
            rows.push(row(greatest, greatest.maximum, greatest.maximum_at_m, signs[1]));
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use outcome::facts::ServiceLoadFacts;

    #[test]
    fn the_place_that_answers_most_is_told_with_the_first_axle() {
        let place = |span: usize, minimum: f64, at: f64| SectionFacts {
            about: format!("crown of span {span}, deflection"),
            minimum,
            minimum_at_m: at,
            maximum: 0.1,
            maximum_at_m: -2.0,
            ..SectionFacts::default()
        };
        let load = ServiceLoadFacts {
            name: "train".into(),
            places: vec![place(1, -0.4, 4.5), place(2, -0.5, 12.25)],
            ..Default::default()
        };
        let rows = standing(&ServiceFacts { loads: vec![load], ..ServiceFacts::default() });
        assert_eq!(rows[0], ["train", "crown of span 2, deflection, most downwards", "−0.500 mm", "12.25"]);
        assert_eq!(rows[1][2..], ["0.100 mm", "−2.00"]);
        assert!(standing(&ServiceFacts::default()).is_empty());
    }
}
