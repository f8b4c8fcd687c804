//! Trains: axles and the distances between them. Those that come with the program stand in `crates/bridge/data/trains/`.

use crate::diagnostic::Diagnostic;
use crate::fields::train;

/// A train as it drives: to the right, its first vehicle first.
#[derive(Debug, Clone, PartialEq)]
pub struct Train {
    /// What it is called.
    pub name: String,
    /// A file of vehicles, relative to the bridge file; `vehicles` is empty until somebody reads it.
    pub file: Option<String>,
    /// Vehicles from the first to the last, alike ones together.
    pub vehicles: Vec<Vehicle>,
}

/// So many vehicles of one kind.
#[derive(Debug, Clone, PartialEq)]
pub struct Vehicle {
    /// What it is called.
    pub name: String,
    /// How many follow one another.
    pub count: usize,
    /// What each axle brings onto the rails, from the first one back.
    pub loads: AxleLoads,
    /// Distances between neighbouring axles [m]: one fewer than axles.
    pub spacings: Vec<f64>,
    /// From the front coupler to the first axle, and from the last axle to the rear coupler [m].
    pub overhangs: [f64; 2],
}

/// What axles bring onto the rails.
#[derive(Debug, Clone, PartialEq)]
pub enum AxleLoads {
    /// Masses [kg]; gravity makes forces of them.
    Masses(Vec<f64>),
    /// Forces [N].
    Forces(Vec<f64>),
}

/// One axle of a train.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axle {
    /// Force on both rails together [N].
    pub force: f64,
    /// Distance behind the first axle of the train [m].
    pub offset: f64,
}

impl Vehicle {
    /// Distance between its couplers [m].
    pub fn length(&self) -> f64 {
        self.overhangs.iter().sum::<f64>() + self.spacings.iter().sum::<f64>()
    }

    /// Force of each axle [N].
    pub fn forces(&self, gravity: f64) -> Vec<f64> {
        match &self.loads {
            AxleLoads::Masses(masses) => masses.iter().map(|mass| mass * gravity).collect(),
            AxleLoads::Forces(forces) => forces.clone(),
        }
    }
}

impl Train {
    /// Every axle, from the first one back. `gravity` [m/s^2].
    pub fn axles(&self, gravity: f64) -> Vec<Axle> {
        let mut axles = Vec::new();
        let mut front = 0.0;
        for vehicle in &self.vehicles {
            let forces = vehicle.forces(gravity);
            for _ in 0..vehicle.count {
                let mut at = front + vehicle.overhangs[0];
                for (k, &force) in forces.iter().enumerate() {
                    axles.push(Axle { force, offset: at });
                    at += vehicle.spacings.get(k).copied().unwrap_or(0.0);
                }
                front += vehicle.length();
            }
        }
        let first = axles.first().map_or(0.0, |axle| axle.offset);
        axles.iter_mut().for_each(|axle| axle.offset -= first);
        axles
    }

    /// Distance from the first axle to the last [m].
    pub fn wheelbase(&self) -> f64 {
        self.axles(1.0).last().map_or(0.0, |axle| axle.offset)
    }
}

/// A train of the library: its name and the text of its file.
#[derive(Debug, Clone, Copy)]
pub struct BuiltIn {
    /// The name that `name` in `[train]` takes.
    pub name: &'static str,
    /// What it is, in a line.
    pub about: &'static str,
    /// Its file: vehicles, with assumptions and sources as comments.
    pub text: &'static str,
}

/// Every train of the library.
pub const LIBRARY: &[BuiltIn] = &[
    BuiltIn {
        name: "paper-short",
        about: "two locomotives of six 20.5 t axles and eight wagons of four 22 t axles, as the railway paper computed",
        text: include_str!("../data/trains/paper-short.toml"),
    },
    BuiltIn {
        name: "paper-full",
        about: "two locomotives, 58 wagons and two locomotives, as the railway paper measured",
        text: include_str!("../data/trains/paper-full.toml"),
    },
    BuiltIn {
        name: "paper-short-light",
        about: "paper-short with wagons of 22 t each in place of axles of 22 t: the other reading of the paper",
        text: include_str!("../data/trains/paper-short-light.toml"),
    },
];

/// The train of this name, if the library has it.
pub fn built_in(name: &str) -> Option<&'static BuiltIn> {
    LIBRARY.iter().find(|train| train.name == name)
}

/// What reading a file of vehicles gives.
#[derive(Debug, Clone)]
pub struct ReadTrain {
    /// The vehicles, unless a finding is an error.
    pub vehicles: Option<Vec<Vehicle>>,
    /// Every finding, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a file of vehicles: TOML with `[[vehicle]]` tables.
pub fn read_toml(text: &[u8]) -> ReadTrain {
    let (vehicles, diagnostics) = crate::plain::read_sound(text, &train::FILE, train::vehicles);
    ReadTrain { vehicles, diagnostics }
}

/// Most axles of a train; the longest trains have some 3,000.
pub const MOST_AXLES: usize = 20_000;

/// Reads a table of axles: a header `axle_load_t,distance_m` (or `axle_force_kn,distance_m`), and a line for each axle with
/// its distance behind the first. What is wrong is said line by line.
///
/// # Errors
/// Another header, every line that is no axle behind the one before, or a table without axles.
pub fn read_csv(text: &str) -> Result<Vec<Vehicle>, Vec<String>> {
    let mut lines = text
        .lines()
        .enumerate()
        .map(|(k, line)| (k + 1, line.trim()))
        .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let masses = match lines.next().map(|(number, line)| (number, line.replace(' ', ""))) {
        Some((_, header)) if header == "axle_load_t,distance_m" => true,
        Some((_, header)) if header == "axle_force_kn,distance_m" => false,
        Some((number, _)) => {
            return Err(vec![format!(
                "line {number}: the header is axle_load_t,distance_m or axle_force_kn,distance_m"
            )]);
        }
        None => return Err(vec!["the table has no line".to_owned()]),
    };
    let (mut loads, mut places, mut complaints) = (Vec::<f64>::new(), Vec::<f64>::new(), Vec::new());
    for (number, line) in lines.take(MOST_AXLES) {
        let cells: Vec<Option<f64>> = line.split(',').map(|cell| cell.trim().parse().ok()).collect();
        match cells[..] {
            [Some(load), Some(place)] if load > 0.0 && load < 1e4 && (0.0..1e5).contains(&place) => {
                if places.last().is_some_and(|before| *before >= place) {
                    complaints.push(format!("line {number}: the axle does not stand behind the one before"));
                }
                loads.push(1e3 * load);
                places.push(place);
            }
            _ => complaints
                .push(format!("line {number}: write a positive load and a distance of 0 m or more, as 20.5,1.85")),
        }
    }
    if complaints.is_empty() && loads.is_empty() {
        complaints.push("the table has no axle".to_owned());
    }
    if !complaints.is_empty() {
        return Err(complaints);
    }
    let spacings = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let loads = if masses { AxleLoads::Masses(loads) } else { AxleLoads::Forces(loads) };
    Ok(vec![Vehicle { name: "train".to_owned(), count: 1, loads, spacings, overhangs: [0.0; 2] }])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn train(name: &str) -> Train {
        let read = read_toml(built_in(name).unwrap().text.as_bytes());
        assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
        Train { name: name.to_owned(), file: None, vehicles: read.vehicles.unwrap() }
    }

    #[test]
    fn the_library_has_the_trains_of_the_paper() {
        let short = train("paper-short").axles(9.81);
        assert_eq!(short.len(), 12 + 32, "two locomotives and eight wagons (section 3.3)");
        assert_eq!(train("paper-full").axles(9.81).len(), 24 + 4 * 58, "and the whole train (section 3.2)");
        // 20.5 t on a metre of a barrel 4.87 m wide.
        assert!((short[0].force / 4.87 - 41.3e3).abs() < 50.0, "{}", short[0].force / 4.87);
        assert!(short.windows(2).all(|pair| pair[1].offset > pair[0].offset + 1.0));
        assert_eq!(short[0].offset, 0.0);
        let light = train("paper-short-light").axles(9.81);
        assert!((light.iter().skip(12).take(4).map(|axle| axle.force).sum::<f64>() - 22e3 * 9.81).abs() < 1e-6);
    }

    #[test]
    fn vehicles_stand_coupler_to_coupler() {
        let two = Train {
            name: String::new(),
            file: None,
            vehicles: vec![Vehicle {
                name: String::new(),
                count: 2,
                loads: AxleLoads::Forces(vec![1.0, 2.0]),
                spacings: vec![3.0],
                overhangs: [1.0, 0.5],
            }],
        };
        let offsets: Vec<f64> = two.axles(9.81).iter().map(|axle| axle.offset).collect();
        assert_eq!(offsets, [0.0, 3.0, 4.5, 7.5]);
        assert_eq!(two.wheelbase(), 7.5);
    }

    #[test]
    fn tables_of_axles_are_read_or_refused_line_by_line() {
        let read = read_csv("# test\naxle_load_t, distance_m\n20.5,0\n20.5,1.85\n").unwrap();
        assert_eq!(read[0].loads, AxleLoads::Masses(vec![20.5e3, 20.5e3]));
        assert_eq!(read[0].spacings, [1.85]);
        let wrong = read_csv("axle_force_kn,distance_m\n200,0\nx,1\n200,0\n-1,5\n").unwrap_err();
        assert_eq!(wrong.len(), 3, "{wrong:?}");
        assert!(wrong[0].starts_with("line 3"));
        assert!(
            read_csv("").is_err() && read_csv("load\n1\n").is_err() && read_csv("axle_load_t,distance_m\n").is_err()
        );
    }
}
