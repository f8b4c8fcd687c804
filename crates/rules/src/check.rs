//! Published numbers, and numbers worked out by hand, against what the vehicles give.

use crate::{
    LoadModel, Pattern, Published, PublishedQuantity, Rule, equivalent_uniform_load, greatest_bending,
    greatest_bending_at, greatest_shear,
};

/// A number of a table beside what the vehicle gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked<'t> {
    /// The table that it stands in.
    pub table: &'t Published,
    /// Span [m].
    pub span: f64,
    /// Published [kN, kN m or none].
    pub published: f64,
    /// Found, in the same unit; the greatest over the vehicle's arrangements.
    pub found: f64,
}

impl Checked<'_> {
    /// Relative difference of the found from the published number.
    pub fn difference(&self) -> f64 {
        self.found / self.published - 1.0
    }
    /// Whether they agree.
    pub fn agrees(&self) -> bool {
        let Published { tolerance, above, .. } = *self.table;
        (-tolerance..=tolerance.max(above)).contains(&self.difference())
    }
}

/// Every published number of a model that its vehicles should give, and every one worked out by hand. Dynamic augments are those of `rule`, where one is given.
pub fn check<'m>(model: &'m LoadModel, rule: Option<&Rule>) -> Vec<Checked<'m>> {
    model.tables().flat_map(|table| compared(model, table, rule)).collect()
}

/// The numbers of one table of a model; none where its vehicle is not said to give them.
pub fn compared<'t>(model: &LoadModel, table: &'t Published, rule: Option<&Rule>) -> Vec<Checked<'t>> {
    let vehicle = model.vehicle(&table.vehicle).filter(|_| table.not_from_vehicle.is_empty());
    let Some(vehicle) = vehicle else { return Vec::new() };
    let mut patterns = vehicle.own_patterns();
    if !table.with_uniform {
        patterns.iter_mut().for_each(|pattern| pattern.stretches.clear());
    }
    let row = |(&span, &published): (&f64, &f64)| {
        let greatest = |of: &dyn Fn(&Pattern) -> f64| patterns.iter().map(of).fold(0.0, f64::max);
        let bending = |p: &Pattern| match table.section {
            Some(share) => greatest_bending_at(p, span, share),
            None => greatest_bending(p, span),
        };
        // A uniform load of a total W has the moment W L x (1 - x) / 2 at a share x of the span.
        let shape = table.section.map_or(0.125, |x| 0.5 * x * (1.0 - x));
        let found = match table.quantity {
            PublishedQuantity::EudlBending => 1e-3 * greatest(&|p| bending(p) / (shape * span)),
            PublishedQuantity::EudlShear => 1e-3 * greatest(&|p| equivalent_uniform_load(p, span)[1]),
            PublishedQuantity::Bending => 1e-3 * greatest(&bending),
            PublishedQuantity::Shear => 1e-3 * greatest(&|p| greatest_shear(p, span)),
            PublishedQuantity::DynamicAugment => rule?.impact_of(&model.code)?.total_augment(span)?,
        };
        Some(Checked { table, span, published, found })
    };
    table.spans_m.iter().zip(&table.values).filter_map(row).collect()
}
