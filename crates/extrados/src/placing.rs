//! Loads or a vehicle in the hands of the caller: put anywhere on the bridge, answered at once.

use crate::choice::Choice;
use crate::collapse::planned;
use crate::project::Project;
use crate::refusal::Refusal;
use assess::analysis::placing;
pub use assess::analysis::placing::{Carried, Placed};
use assess::analysis::vehicles::Driven;
use bridge::{Directions, SweepPlan};
use outcome::vehicles::Direction;
use std::ops::{Deref, DerefMut};

/// A bridge that was prepared once and answers wherever its loads stand, by limit analysis of rigid rings. At the place that its file
/// gives, loads carry what [`collapse`](crate::collapse()) finds with the friction of the plan, or what a [`sweep`](crate::sweep()) does. What it is asked is that of the analysis itself.
pub struct Placing(placing::Placing);

/// A vehicle that is to be put on a bridge.
#[derive(Debug, Clone, Default)]
pub struct VehicleChoice {
    /// Its code in the library; empty for the first that the file's `[sweep]` moves.
    pub vehicle: String,
    /// The rule whose factors it has; empty for that of the file's `[sweep]`, or `characteristic`, which has none.
    pub rule: String,
    /// Whether it drives to the left.
    pub leftward: bool,
}

impl Placing {
    /// The loads of the file, which move together; the reference point of the first one tells the place.
    ///
    /// # Errors
    /// A file that cannot be used or has no loads, or loads that cannot be moved (F108).
    pub fn loads(project: &Project, choice: &Choice) -> Result<Placing, Refusal> {
        let bridge = planned(project, choice)?;
        Ok(Placing(placing::Placing::loads(&bridge)?))
    }

    /// A vehicle under the factors of a rule, the first axle of which tells the place: at every place it carries what a sweep finds there.
    ///
    /// # Errors
    /// A file that cannot be used, a vehicle or a rule that is not known, or that do not go together (F108).
    pub fn vehicle(project: &Project, choice: &Choice, asked: &VehicleChoice) -> Result<Placing, Refusal> {
        let bridge = planned(project, choice)?;
        let mut plan = bridge.sweep.clone().unwrap_or_else(characteristic);
        if !asked.rule.is_empty() {
            (plan.rule, plan.rule_file) = (asked.rule.clone(), None);
        }
        let direction = if asked.leftward { Direction::Left } else { Direction::Right };
        let driven = Driven::new(&bridge, &plan, &asked.vehicle, direction)
            .map_err(|unknown| Refusal::new("F108", unknown.to_string(), "extrados vehicles lists what there is"))?;
        Ok(Placing(placing::Placing::vehicle(&bridge, &driven)?))
    }
}

impl Deref for Placing {
    type Target = placing::Placing;

    fn deref(&self) -> &placing::Placing {
        &self.0
    }
}

impl DerefMut for Placing {
    fn deref_mut(&mut self) -> &mut placing::Placing {
        &mut self.0
    }
}

/// What a file without `[sweep]` says of vehicles: as they are, without factors.
fn characteristic() -> SweepPlan {
    SweepPlan {
        condition_factor: None,
        rule: "characteristic".to_owned(),
        rule_file: None,
        vehicles: Vec::new(),
        vehicle_files: Vec::new(),
        step: None,
        directions: Directions::Both,
        subsets: true,
        own_dispersal: false,
        braking: 0.0,
        braking_given: false,
        braking_reason: None,
        discrete_elements: false,
        texts: Vec::new(),
    }
}
