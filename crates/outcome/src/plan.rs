//! What a load test would tell, before anyone goes out.

use crate::note::Note;
use crate::published::{Object, list, object};
use crate::wire::published;
use serde::{Deserialize, Serialize};

/// A parameter that the test is to tell.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Sought {
    /// Its name.
    pub name: String,
    /// Unit of its values.
    pub unit: String,
    /// Value of the start model.
    pub start: f64,
    /// Its range: what is known before.
    pub range: [f64; 2],
}

published! {
    /// Readings that would be taken, and what they would tell beside all before them.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Telling |telling, of: &LoadTestPlan| {
        /// Name of the position or of the sensor.
        pub name: String,
        /// What they would add to what those before them tell of all parameters together [bit].
        pub information: f64 as information_bit,
        /// Interval that would hold each parameter with 95 %, by name.
        = interval_95: Object = of.by_name(&telling.intervals),
        /// The same in the order of the parameters [unit of the parameter].
        pub intervals: Vec<[f64; 2]> [kept],
    }
}

published! {
    /// What the readings of a load test would tell of the parameters, at the start model.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct LoadTestPlan |plan| {
        /// What is sought: `name`, `unit`, `start`, `range`.
        pub sought: Vec<Sought> as parameters = list(&plan.sought, |one| object! {
            name: one.name,
            unit: one.unit,
            start: one.start,
            range: one.range,
        }),
        /// What all of it would tell together [bit].
        pub information: f64 as information_bit,
        /// Interval that would hold each parameter with 95 % after the whole test, by name.
        = interval_95: Object = plan.by_name(&plan.intervals),
        /// The same in the order of the parameters [unit of the parameter].
        pub intervals: Vec<[f64; 2]> [kept],
        /// Positions, all sensors read in each, in the order in which each adds most.
        pub positions: Vec<Telling> = list(&plan.positions, |one| one.object(plan)),
        /// Sensors, each read in all positions, likewise.
        pub sensors: Vec<Telling> = list(&plan.sensors, |one| one.object(plan)),
        /// How many more positions and sensors there are: each adds less than the last that is listed, or nothing to speak of.
        pub not_listed: [usize; 2],
        /// What was assumed, in words.
        pub assumptions: Vec<Note>,
    }
}

impl LoadTestPlan {
    fn by_name(&self, intervals: &[[f64; 2]]) -> Object {
        self.sought.iter().zip(intervals).map(|(one, interval)| (one.name.clone(), interval.to_vec().into())).collect()
    }
}
