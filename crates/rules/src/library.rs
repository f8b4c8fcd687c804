//! Every load model and rule that comes with the program.

use crate::{LoadModel, Problem, Rule, Vehicle, read_load_model, read_rule};
use std::sync::OnceLock;

/// Load models and rules.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Library {
    /// Load models.
    pub models: Vec<LoadModel>,
    /// Rules.
    pub rules: Vec<Rule>,
}

macro_rules! files {
    ($folder:literal: $($name:literal),* $(,)?) => {
        &[$(($name, include_str!(concat!("../data/", $folder, "/", $name, ".toml")))),*]
    };
}

/// A file: its name without ending, and its text.
pub(crate) type File = (&'static str, &'static str);

/// The texts of all files: load models, then rules.
pub const FILES: [&[File]; 2] = [
    files!("loads":
        "25t-2008", "hml-30t", "lm71", "cooper-e80", "hl-93", "lm1", "hb", "cs-454", "ra", "lm2", "lm3", "sw", "en-15528",
        "sv", "gb-restrictions", "hs20", "aashto-legal", "mbg-1987", "dfc-32.5t",
    ),
    files!("rules": "characteristic", "cs-454", "irs-bridge-rules", "nr-civ-025", "en-1991-2", "aashto-mbe"),
];

/// The library, read once in a process: reading takes 10 ms, and every bridge that is read asks for it. A test reads it too, so that
/// complaints reach users only from files of their own.
///
/// # Errors
/// Everything that is wrong with its files.
pub fn library() -> Result<Library, Vec<Problem>> {
    static LIBRARY: OnceLock<Result<Library, Vec<Problem>>> = OnceLock::new();
    LIBRARY.get_or_init(read).clone()
}

fn read() -> Result<Library, Vec<Problem>> {
    let mut problems = Vec::new();
    let models = read_all(FILES[0], read_load_model, &mut problems);
    let mut library = Library { models, rules: read_all(FILES[1], read_rule, &mut problems) };
    problems.append(&mut library.join_levels());
    if problems.is_empty() { Ok(library) } else { Err(problems) }
}

/// What can be read of some files; what is wrong with the others joins the problems.
fn read_all<T>(files: &[File], read: fn(&str, &str) -> Result<T, Vec<Problem>>, problems: &mut Vec<Problem>) -> Vec<T> {
    let one =
        |(name, text): &File| read(&format!("{name}.toml"), text).map_err(|mut found| problems.append(&mut found));
    files.iter().flat_map(one).collect()
}

impl Library {
    /// Looks up the vehicles that belong to the level of another one (`with`). What cannot be found, or stands on the road in another way,
    /// is a problem.
    pub fn join_levels(&mut self) -> Vec<Problem> {
        let mut problems = Vec::new();
        let all: Vec<Vehicle> = self.vehicles().map(|(_, vehicle)| vehicle.clone()).collect();
        for vehicle in self.models.iter_mut().flat_map(|model| &mut model.vehicles) {
            vehicle.level.clear();
            for code in &vehicle.with {
                let found = all.iter().find(|other| other.code.eq_ignore_ascii_case(code));
                let alike = |other: &&Vehicle| {
                    other.wheel_track_m == vehicle.wheel_track_m
                        && other.contact_length_m == vehicle.contact_length_m
                        && other.uniform.is_empty()
                        && other.with.is_empty()
                };
                match found.filter(alike) {
                    Some(other) => vehicle.level.push(other.clone()),
                    None => problems.push(Problem {
                        file: vehicle.code.clone(),
                        key: "with".to_owned(),
                        line: 0,
                        message: format!(
                            "there is no vehicle \"{code}\" with the same wheel track and contact length, without uniform loads and without \
                             a level of its own"
                        ),
                    }),
                }
            }
        }
        problems
    }

    /// The load model of this code.
    pub fn model(&self, code: &str) -> Option<&LoadModel> {
        self.models.iter().find(|model| model.code.eq_ignore_ascii_case(code))
    }
    /// The vehicle of this code and its load model.
    pub fn vehicle(&self, code: &str) -> Option<(&LoadModel, &Vehicle)> {
        self.models.iter().find_map(|model| model.vehicle(code).map(|vehicle| (model, vehicle)))
    }
    /// The rule of this code.
    pub fn rule(&self, code: &str) -> Option<&Rule> {
        self.rules.iter().find(|rule| rule.code.eq_ignore_ascii_case(code))
    }
    /// Every vehicle with its load model, in the order of the files.
    pub fn vehicles(&self) -> impl Iterator<Item = (&LoadModel, &Vehicle)> {
        self.models.iter().flat_map(|model| model.vehicles.iter().map(move |vehicle| (model, vehicle)))
    }
}
