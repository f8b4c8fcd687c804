//! Loads of the file moved over the bridge: what was found.

use crate::collapse::Status;
use crate::help::NotCounted;
use crate::note::Note;
use crate::published::list;
use crate::warning::Warning;
use crate::wire::published;
use crate::words::words;
use serde::{Deserialize, Serialize};

published! {
    /// The load at one position of a sweep over a bridge of a width [m].
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct SweepPoint |point, width: f64| {
        /// Position of the first load's reference point [m].
        pub position: f64 [m],
        /// How far the loads were moved from where the file places them [m].
        pub offset: f64 [m],
        /// How the worst subset of axles ended; not converged where one of them found no answer.
        pub status: Status,
        /// Least load factor over the subsets of axles; none where one of them found no answer.
        pub load_factor: Option<f64>,
        /// Where a subset found no answer: the least factor of the others, which the true one does not exceed.
        pub load_factor_at_most?: Option<f64>,
        /// Least load factor of rigid blocks, where deformable joints were followed too: `load_factor` is the smaller one then.
        pub rigid_factor?: Option<f64>,
        /// Least load factor in balance on deformable joints.
        pub deformable_factor?: Option<f64>,
        /// Lower bound of the load factor, where fill yields as a continuum.
        = lower_bound_factor?: Option<f64> = point.upper_factor.and(point.load_factor),
        /// Upper bound of the load factor, where fill yields as a continuum: `load_factor` is the lower one then, and `rigid_factor` that of
        /// fill as weight alone.
        pub upper_factor?: Option<f64> as upper_bound_factor,
        /// Limit load of the governing subset; its lower bound, which is carried.
        = last_stable_load: Option<f64> [kN/m] = point.collapse_load,
        /// The same on the whole width.
        = last_stable_load: Option<f64> [kN] = point.collapse_load.map(|load| load * width),
        /// Limit load of the governing subset [N/m]; its lower bound, which is carried.
        pub collapse_load: Option<f64> [kN/m],
        /// The same on the whole width.
        = collapse_load: Option<f64> [kN] = point.collapse_load.map(|load| load * width),
        /// First axle of the governing subset, over all loads in the order of the file, from 1.
        = first_axle: usize = point.axles[0] + 1,
        /// Last axle of the governing subset.
        = last_axle: usize = point.axles[1] + 1,
        /// First and last axle of the governing subset, over all loads in the order of the file.
        pub axles: [usize; 2] [kept],
    }
}

impl SweepPoint {
    /// The load factor, or what bounds it from above.
    pub fn bound(&self) -> Option<f64> {
        self.load_factor.or(self.load_factor_at_most)
    }
}

published! {
    /// A sweep over a bridge of a name and a width [m].
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Sweep |sweep, bridge: &str, width: f64| {
        = schema: String = "extrados.sweep/1",
        = status: String = sweep.ended(),
        = bridge: String = bridge,
        /// The position with the least load factor, or the least bound on it.
        = governing: Option<SweepPoint> = sweep.governing.map(|k| sweep.points[k].object(width)),
        /// Index of the position with the least load factor, or the least bound on it.
        pub governing: Option<usize> [kept],
        = ..NotCounted = sweep.not_counted.told(),
        /// What may help the bridge and is not counted at the governing position.
        pub not_counted: NotCounted [kept],
        /// At how many positions a case found no answer.
        = positions_not_converged: usize = sweep.positions_not_converged(),
        /// Distance between positions [m], before the worst one was sought between them.
        pub step: f64 [m],
        /// Positions from left to right.
        pub points: Vec<SweepPoint> as positions = list(&sweep.points, |point| point.object(width)),
        /// What was assumed.
        pub assumptions: Vec<Note>,
        /// What a reader should look at.
        pub warnings: Vec<Warning>,
        /// Whether every position was answered before the onlooker wished to stop.
        pub whole: bool [kept],
    }
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
    /// How a sweep ended, or a calibration.
    #[derive(Default)]
    pub enum Ended {
        /// Everything that was asked for was answered.
        #[default]
        Completed = "completed",
        /// Something was not answered, or no position makes a mechanism.
        Undetermined = "undetermined",
        /// Stopped by its onlooker; what was done is there.
        Cancelled = "cancelled",
    }
}
