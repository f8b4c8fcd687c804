//! The library of load models against the tables that were published for its vehicles, and against numbers worked out by hand.

use rules::{Published, PublishedQuantity};

/// A table beside what its vehicle gives.
#[derive(Debug, Clone, PartialEq)]
pub struct TableRow {
    /// Code of the load model.
    pub model: String,
    /// The table.
    pub table: Published,
    /// What the numbers are, with their unit.
    pub quantity: &'static str,
    /// Where they are from, with date and confidence.
    pub source: String,
    /// Whether somebody published the numbers; they were worked out by hand otherwise.
    pub published: bool,
    /// How many numbers were compared; none of a table that the vehicle alone does not give.
    pub numbers: usize,
    /// Largest difference, relative; at which span [m].
    pub difference: f64,
    /// See above.
    pub span: f64,
    /// Why the numbers are read and not compared, where they are not.
    pub left_out: String,
}

impl TableRow {
    /// Whether every number agrees that was compared.
    pub fn agrees(&self) -> bool {
        let Published { tolerance, above, .. } = self.table;
        self.numbers == 0 || (-tolerance..=tolerance.max(above)).contains(&self.difference)
    }
}

/// Every table of the library, published or worked out by hand; what is wrong with the library where it cannot be read.
///
/// # Errors
/// What is wrong with the library.
pub fn tables() -> Result<Vec<TableRow>, String> {
    let library =
        rules::library().map_err(|problems| problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))?;
    // Dynamic augments are printed with the loads of the Indian railways alone.
    let rule = library.rule("irs-bridge-rules");
    let mut list = Vec::new();
    for model in &library.models {
        for (k, table) in model.tables().enumerate() {
            let compared = rules::compared(model, table, rule);
            // Each difference as a share of what is allowed on its side.
            let share = |row: &rules::Checked| match row.difference() {
                short if short < 0.0 => -short / table.tolerance,
                over => over / table.tolerance.max(table.above),
            };
            let worst = compared.iter().max_by(|a, b| share(a).total_cmp(&share(b)));
            let source = &table.source;
            list.push(TableRow {
                model: model.code.clone(),
                table: table.clone(),
                quantity: words(table.quantity),
                source: format!("{} ({}, {})", source.text, source.date, source.confidence.word()),
                published: k < model.published.len(),
                numbers: compared.len(),
                difference: worst.map_or(0.0, rules::Checked::difference),
                span: worst.map_or(0.0, |row| row.span),
                left_out: match (compared.is_empty(), table.not_from_vehicle.is_empty()) {
                    (true, true) => "no rule of the library says how to find it".to_owned(),
                    _ => table.not_from_vehicle.clone(),
                },
            });
        }
    }
    Ok(list)
}

fn words(quantity: PublishedQuantity) -> &'static str {
    match quantity {
        PublishedQuantity::EudlBending => "equivalent uniform load for bending [kN]",
        PublishedQuantity::EudlShear => "equivalent uniform load for shear [kN]",
        PublishedQuantity::Bending => "greatest bending moment [kN m]",
        PublishedQuantity::Shear => "greatest shear [kN]",
        PublishedQuantity::DynamicAugment => "coefficient of dynamic augment [-]",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_load_model_is_compared_and_agrees() {
        let list = tables().unwrap();
        assert!(list.iter().all(TableRow::agrees), "{list:?}");
        let compared: usize = list.iter().map(|row| row.numbers).sum();
        assert!(compared > 55, "{compared}");
        assert!(list.iter().all(|row| row.numbers > 0 || !row.left_out.is_empty()));
        let worse = TableRow { difference: -2.0 * list[0].table.tolerance, numbers: 1, ..list[0].clone() };
        assert!(!worse.agrees());
    }
}
