//! Loads of the file moved over the bridge: what was found.

use crate::collapse::Status;
use crate::help::NotCounted;
use crate::note::Note;
use crate::warning::Warning;
use crate::words::words;
use serde::{Deserialize, Serialize};

/// The load at one position.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SweepPoint {
    /// How far the loads were moved from where the file places them [m].
    pub offset: f64,
    /// Position of the first load's reference point [m].
    pub position: f64,
    /// How the worst subset of axles ended; not converged where one of them found no answer.
    pub status: Status,
    /// Least load factor over the subsets of axles; none where one of them found no answer.
    pub load_factor: Option<f64>,
    /// Where a subset found no answer: the least factor of the others, which the true one does not exceed.
    pub load_factor_at_most: Option<f64>,
    /// Limit load of the governing subset [N/m]; its lower bound, which is carried.
    pub collapse_load: Option<f64>,
    /// First and last axle of the governing subset, over all loads in the order of the file.
    pub axles: [usize; 2],
    /// Least load factor of rigid blocks, where deformable joints were followed too: `load_factor` is the smaller one then.
    pub rigid_factor: Option<f64>,
    /// Least load factor in balance on deformable joints.
    pub deformable_factor: Option<f64>,
    /// Upper bound of the load factor, where fill yields as a continuum: `load_factor` is the lower one then, and `rigid_factor` that of fill
    /// as weight alone.
    #[serde(default)]
    pub upper_factor: Option<f64>,
}

impl SweepPoint {
    /// The load factor, or what bounds it from above.
    pub fn bound(&self) -> Option<f64> {
        self.load_factor.or(self.load_factor_at_most)
    }
}

/// A sweep.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Sweep {
    /// Positions from left to right.
    pub points: Vec<SweepPoint>,
    /// Index of the position with the least load factor, or the least bound on it.
    pub governing: Option<usize>,
    /// Distance between positions [m], before the worst one was sought between them.
    pub step: f64,
    /// Whether every position was answered before the onlooker wished to stop.
    pub whole: bool,
    /// What may help the bridge and is not counted at the governing position.
    #[serde(default)]
    pub not_counted: NotCounted,
    /// What a reader should look at.
    pub warnings: Vec<Warning>,
    /// What was assumed.
    pub assumptions: Vec<Note>,
}

impl Sweep {
    /// At how many positions a case found no answer.
    pub fn positions_not_converged(&self) -> usize {
        self.points.iter().filter(|p| p.status == Status::NotConverged).count()
    }

    /// How it ended: completed only where every position was answered.
    pub fn ended(&self) -> Ended {
        match self.governing {
            _ if !self.whole => Ended::Cancelled,
            Some(_) if self.positions_not_converged() == 0 => Ended::Completed,
            _ => Ended::Undetermined,
        }
    }

    /// Whether deformable joints were followed.
    pub fn is_deformable(&self) -> bool {
        self.points.iter().any(|point| point.deformable_factor.is_some())
    }

    /// The governing position.
    pub fn worst(&self) -> Option<&SweepPoint> {
        self.points.get(self.governing?)
    }
}

words! {
    /// How a sweep ended.
    pub enum Ended {
        /// Every position was answered.
        Completed = "completed",
        /// A position was not answered, or no position makes a mechanism.
        Undetermined = "undetermined",
        /// Stopped by its onlooker; what was done is there.
        Cancelled = "cancelled",
    }
}
