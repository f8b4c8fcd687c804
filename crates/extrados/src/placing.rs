//! Loads or a vehicle in the hands of the caller: put anywhere on the bridge, answered at once.

use crate::choice::Choice;
use crate::collapse::planned;
use crate::project::Project;
use crate::refusal::Refusal;
use assess::analysis::placing;
pub use assess::analysis::placing::{Carried, Placed};
use assess::analysis::vehicles::Driven;
use bridge::{Directions, SweepPlan};
use outcome::note::Note;
use outcome::picture::Point;
use outcome::vehicles::Direction;

/// A bridge that was prepared once and answers wherever its loads stand, by limit analysis of rigid rings. At the place that its file
/// gives, loads carry what [`collapse`](crate::collapse()) finds with the friction of the plan, or what a [`sweep`](crate::sweep()) does.
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
        placing::Placing::loads(&bridge).map(Placing).map_err(|error| Refusal::not_set_up(&error))
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
        placing::Placing::vehicle(&bridge, &driven).map(Placing).map_err(|error| Refusal::not_set_up(&error))
    }

    /// Places at which something acts on the arches [m].
    pub fn range(&self) -> [f64; 2] {
        self.0.range()
    }

    /// What is carried with the loads at a place [m]: a factor on all of them, without forces.
    pub fn carried(&mut self, position: f64) -> Carried {
        self.0.carried(position)
    }

    /// What is carried at a place with lines of thrust, mechanism, hinges and joints that slide.
    pub fn put(&mut self, position: f64) -> Placed {
        self.0.put(position)
    }

    /// The same with dilatant friction alone, where loads move too fast for the load without: the answer says where that is open.
    pub fn put_quickly(&mut self, position: f64) -> Placed {
        self.0.put_quickly(position)
    }

    /// For each ring the zone in which the line of thrust can lie under so many times the loads at a place: the lowest and the highest
    /// point of each joint [m]; empty where they are not carried.
    ///
    /// # Errors
    /// Blocks that cannot be analysed (F108).
    pub fn zone(&mut self, position: f64, factor: f64) -> Result<Vec<Vec<[Point; 2]>>, Refusal> {
        self.0.zone(position, factor).map_err(|error| Refusal::not_set_up(&error))
    }

    /// The vehicle, where one is put.
    pub fn driven(&self) -> Option<&Driven> {
        self.0.driven()
    }

    /// The factors that act on the loads, in words; those of a file are nominal.
    pub fn factors(&self) -> String {
        self.0.factors()
    }

    /// Whether the bridge carries its own weight.
    pub fn stands(&self) -> bool {
        self.0.stands()
    }

    /// Whether places are answered by the quick method; where not, each takes as long as an analysis by itself.
    pub fn is_quick(&self) -> bool {
        self.0.is_quick()
    }

    /// What is assumed.
    pub fn assumptions(&self) -> Vec<Note> {
        self.0.assumptions()
    }
}

/// What a file without `[sweep]` says of vehicles: as they are, without factors.
fn characteristic() -> SweepPlan {
    SweepPlan {
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
