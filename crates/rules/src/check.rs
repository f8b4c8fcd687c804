//! Published numbers, and numbers worked out by hand, against what the vehicles give.

use crate::{
    LoadModel, Pattern, PublishedQuantity, Rule, equivalent_uniform_load, greatest_bending, greatest_bending_at,
    greatest_shear,
};

/// A published number beside what the vehicle gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked {
    /// The vehicle.
    pub vehicle: String,
    /// What it is.
    pub quantity: PublishedQuantity,
    /// Span [m].
    pub span: f64,
    /// Published [kN, kN m or none].
    pub published: f64,
    /// Found, in the same unit; the greatest over the vehicle's arrangements.
    pub found: f64,
    /// Most difference, relative.
    pub tolerance: f64,
    /// Most that it may lie above, relative: more than the tolerance where the vehicle covers the number.
    pub above: f64,
}

impl Checked {
    /// Relative difference of the found from the published number.
    pub fn difference(&self) -> f64 {
        self.found / self.published - 1.0
    }
    /// Whether they agree.
    pub fn agrees(&self) -> bool {
        (-self.tolerance..=self.tolerance.max(self.above)).contains(&self.difference())
    }
}

/// Every published number of a model that its vehicles should give, and every one worked out by hand. Dynamic augments are those of `rule`, where one is given.
pub fn check(model: &LoadModel, rule: Option<&Rule>) -> Vec<Checked> {
    let mut rows = Vec::new();
    for table in model.tables().filter(|table| table.not_from_vehicle.is_empty()) {
        let Some(vehicle) = model.vehicle(&table.vehicle) else { continue };
        let mut patterns = vehicle.own_patterns();
        if !table.with_uniform {
            patterns.iter_mut().for_each(|pattern| pattern.stretches.clear());
        }
        for (&span, &published) in table.spans_m.iter().zip(&table.values) {
            let greatest = |of: &dyn Fn(&Pattern) -> f64| patterns.iter().map(of).fold(0.0, f64::max);
            let bending = |p: &Pattern| match table.section {
                Some(share) => greatest_bending_at(p, span, share).value,
                None => greatest_bending(p, span).value,
            };
            // A uniform load of a total W has the moment W L x (1 - x) / 2 at a share x of the span.
            let shape = table.section.map_or(0.125, |x| 0.5 * x * (1.0 - x));
            let found = match table.quantity {
                PublishedQuantity::EudlBending => 1e-3 * greatest(&|p| bending(p) / (shape * span)),
                PublishedQuantity::EudlShear => 1e-3 * greatest(&|p| equivalent_uniform_load(p, span)[1]),
                PublishedQuantity::Bending => 1e-3 * greatest(&bending),
                PublishedQuantity::Shear => 1e-3 * greatest(&|p| greatest_shear(p, span).value),
                PublishedQuantity::DynamicAugment => {
                    match rule.and_then(|rule| rule.impact_of(&model.code)?.total_augment(span)) {
                        Some(augment) => augment,
                        None => continue,
                    }
                }
            };
            let (vehicle, quantity) = (table.vehicle.clone(), table.quantity);
            let (tolerance, above) = (table.tolerance, table.above);
            rows.push(Checked { vehicle, quantity, span, published, found, tolerance, above });
        }
    }
    rows
}
