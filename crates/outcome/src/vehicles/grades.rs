//! What a bridge is worth in the grades of load models.

use super::VehicleSweep;
use super::swept::Swept;
use crate::wire::published;
use serde::{Deserialize, Serialize};

/// A grade of bridges: that of one which carries a certain vehicle.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Grade {
    /// What it is of: "Route Availability".
    pub of: String,
    /// Its name: "RA8".
    pub name: String,
    /// Its place among all of them, from the lightest up.
    pub rank: usize,
}

published! {
    /// What a bridge is worth in the grades of a load model, lightest first: those of the vehicles that were asked for.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct Graded {
        /// What the grades are of: "Route Availability".
        pub of: String,
        /// The last grade up to which every one is carried with an adequacy factor of 1 or more.
        pub highest: Option<String>,
        /// Those that are carried.
        pub carried: Vec<String>,
        /// Those that are not.
        pub not_carried: Vec<String>,
        /// Those for which nothing is settled.
        pub unanswered: Vec<String>,
    }
}

impl Graded {
    /// Every grade in words: what is carried, what is not, what is not settled.
    pub fn all_told(&self) -> String {
        let lists = [("carried", &self.carried), ("not carried", &self.not_carried), ("not settled", &self.unanswered)];
        let told = lists.iter().filter(|(_, grades)| !grades.is_empty());
        told.map(|(words, grades)| format!("{words}: {}", grades.join(", "))).collect::<Vec<_>>().join("; ")
    }

    /// The highest grade in words.
    pub fn told(&self) -> String {
        match (&self.highest, self.not_carried.first().or(self.unanswered.first())) {
            (Some(highest), _) => highest.clone(),
            (None, Some(first)) => format!("less than {first}"),
            (None, None) => "nothing is settled".to_owned(),
        }
    }
}

impl VehicleSweep {
    /// The grades of the bridge, one list for each load model that has them: of the vehicles that were asked for, and of restrictions that were looked up.
    pub fn grades(&self) -> Vec<Graded> {
        let mut vehicles: Vec<(&Grade, &Swept)> =
            self.vehicles.iter().chain(&self.restrictions).filter_map(|one| Some((one.grade.as_ref()?, one))).collect();
        vehicles.sort_by_key(|(grade, _)| grade.rank);
        let mut found: Vec<Graded> = Vec::new();
        for (Grade { of, name, .. }, one) in vehicles {
            let at = found.iter().position(|graded| graded.of == *of).unwrap_or_else(|| {
                found.push(Graded { of: of.clone(), ..Graded::default() });
                found.len() - 1
            });
            let graded = &mut found[at];
            let list = match one.is_carried() {
                Some(true) => &mut graded.carried,
                Some(false) => &mut graded.not_carried,
                None => &mut graded.unanswered,
            };
            list.push(name.clone());
            if graded.not_carried.is_empty() && graded.unanswered.is_empty() {
                graded.highest = Some(name.clone());
            }
        }
        found
    }
}
