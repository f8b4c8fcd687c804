//! What may be asked of a bridge, each answered with one number of which more is better.

use assess::analysis::engine::can;
use assess::analysis::placing::Placing;
use assess::analysis::{AnalysisError, Places, collapse, sweep, vehicle_sweep};
use bridge::{Analysis, Bridge, Method};
use mechanics::watch::Unwatched;
use outcome::collapse::{Collapse, Sought, Status};
use outcome::warning::RINGS_SHARE;
use structure::discretise::bridge_length;

/// A question.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Question {
    /// What the loads may be multiplied by.
    Load,
    /// The same at the worst of many places.
    Sweep,
    /// The same of vehicles under a rule.
    Vehicles,
    /// What is carried where somebody drags the loads to.
    Dragged,
    /// How thin the rings may be.
    Thickness,
    /// How far a support may move.
    Movement,
}

/// An answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Found {
    /// More is better; infinite where nothing makes the bridge fall.
    Size(f64),
    /// Nothing is known.
    Open,
    /// The method does not know the question or the bridge, or nothing of the file asks for it.
    NotAsked,
}

impl Question {
    pub(crate) const ALL: [Question; 6] = [
        Question::Load,
        Question::Sweep,
        Question::Vehicles,
        Question::Dragged,
        Question::Thickness,
        Question::Movement,
    ];

    fn analysis(self) -> Analysis {
        match self {
            Question::Thickness => Analysis::Thickness,
            Question::Movement => Analysis::SupportMovement,
            Question::Load | Question::Sweep | Question::Vehicles | Question::Dragged => Analysis::Load,
        }
    }
}

/// Places of loads that are moved, over the whole bridge.
const PLACES: usize = 9;

/// The answer of a bridge by the method of its plan.
pub(crate) fn asked(question: Question, bridge: &Bridge) -> Found {
    answered(question, bridge, PLACES, false)
}

/// The answer of a bridge that is seen from its other side.
pub(crate) fn mirrored(question: Question, bridge: &Bridge) -> Found {
    answered(question, bridge, PLACES, true)
}

/// Places that are halved: less than a voussoir apart, or what lies between them is passed over.
const FINE: usize = 33;

/// The answer at places and at those at half their distance; none of questions without places.
pub(crate) fn halved(question: Question, bridge: &Bridge) -> Option<[Found; 2]> {
    match question {
        Question::Sweep => Some([FINE, 2 * FINE - 1].map(|places| answered(question, bridge, places, false))),
        Question::Vehicles => {
            let mut own = bridge.clone();
            own.sweep.as_mut()?.step = Some(0.5 * bridge.sweep.as_ref()?.step?);
            Some([bridge, &own].map(|one| answered(question, one, PLACES, false)))
        }
        Question::Load | Question::Dragged | Question::Thickness | Question::Movement => None,
    }
}

/// By how large a share, and by how much, an answer may be above another one that it is said not to be above: steps of a method, and places
/// that are sought between others.
pub(crate) fn no_more(question: Question, bridge: &Bridge) -> [f64; 2] {
    let step = match (question, bridge.plan.method) {
        (Question::Load, Method::Dem) => bridge.plan.load_step.unwrap_or(f64::INFINITY),
        _ => 0.0,
    };
    let share = match question {
        Question::Load | Question::Dragged => 1e-6,
        Question::Sweep | Question::Vehicles => 1e-4,
        // Thickness and movement are narrowed to a thousandth, thickness by discrete elements to a two-hundredth.
        Question::Thickness if bridge.plan.method == Method::Dem => 5e-3,
        Question::Thickness | Question::Movement => 2e-3,
    };
    [share, step]
}

/// The same of answers that are said to be the same.
pub(crate) fn same(question: Question, bridge: &Bridge) -> [f64; 2] {
    let [share, step] = no_more(question, bridge);
    match bridge.plan.method {
        // Crushing is followed along chords within 2e-5 of its parabola. The worst place is sought to a hundredth of a step, from other places
        // where the steps are others.
        Method::Limit => {
            [share.max(if matches!(question, Question::Sweep | Question::Vehicles) { 1e-3 } else { 2e-5 }), step]
        }
        // What is narrowed to a share lies within it of two loads that round-off sets apart.
        Method::Path | Method::Dem | Method::Fe => [share + 1e-3, step],
    }
}

/// Whether a bridge and its mirror image go the same way. As a support moves, rings on one another have several motions that their programs cannot
/// tell apart, and which one is followed is not unique: the movement that they survive differs by some per cent.
pub(crate) fn is_followed_alike(question: Question, bridge: &Bridge) -> bool {
    question != Question::Movement || bridge.spans.iter().all(|span| span.rings.len() == 1)
}

fn answered(question: Question, bridge: &Bridge, places: usize, is_mirrored: bool) -> Found {
    let mut own = bridge.clone();
    own.plan.analysis = question.analysis();
    if can::refused(&own).is_err() {
        return Found::NotAsked;
    }
    match question {
        Question::Load if own.loads.is_empty() => Found::NotAsked,
        Question::Movement if own.plan.support_movement.is_none_or(|moves| moves.before.is_some()) => Found::NotAsked,
        Question::Load | Question::Thickness | Question::Movement => {
            collapse(&own, None, &mut Unwatched).map_or_else(|error| refused(&error), |found| size(&found))
        }
        Question::Sweep if moves(&own) => {
            let all = Places::Between([0.0, bridge_length(&own)], places);
            let found = sweep(&own, all, true, &mut Unwatched);
            found.map_or_else(
                |error| refused(&error),
                // A sweep with places that are not answered has no number, and one whose load comes and goes the least of many, which their results say as well.
                |found| {
                    let is_open = found.points.iter().any(|one| one.status == Status::NotConverged)
                        || found.warnings.iter().any(|told| told.code() == RINGS_SHARE);
                    let worst = found.worst().filter(|_| !is_open);
                    worst.and_then(|worst| worst.load_factor).map_or(Found::Open, Found::Size)
                },
            )
        }
        Question::Vehicles if own.sweep.is_some() => {
            let found = vehicle_sweep(&own, &mut Unwatched);
            found.map_or_else(
                |error| refused(&error),
                |found| {
                    let least = found
                        .vehicles
                        .iter()
                        .map(|one| one.adequacy)
                        .min_by(|a, b| a.unwrap_or(f64::NEG_INFINITY).total_cmp(&b.unwrap_or(f64::NEG_INFINITY)));
                    least.flatten().map_or(Found::Open, Found::Size)
                },
            )
        }
        // Loads are dragged by limit analysis alone.
        Question::Dragged if moves(&own) && own.plan.method == Method::Limit => dragged(&own, is_mirrored),
        Question::Sweep | Question::Vehicles | Question::Dragged => Found::NotAsked,
    }
}

/// Whether the loads of a file may be moved.
fn moves(bridge: &Bridge) -> bool {
    !bridge.loads.is_empty() && bridge.loads.iter().all(|load| load.block.is_none())
}

/// The least factor of three places.
fn dragged(bridge: &Bridge, is_mirrored: bool) -> Found {
    let length = bridge_length(bridge);
    let mut placing = match Placing::loads(bridge) {
        Ok(placing) => placing,
        Err(error) => return refused(&error),
    };
    let mut least = f64::INFINITY;
    for share in [0.2, 0.45, 0.7] {
        let place = length * if is_mirrored { 1.0 - share } else { share };
        let found = placing.carried(place);
        match (found.factor, found.status) {
            (Some(factor), _) => least = least.min(factor),
            (None, Status::Locks) => {}
            (None, Status::UnstableUnderSelfWeight) => return Found::Size(0.0),
            (None, _) => return Found::Open,
        }
    }
    Found::Size(least)
}

/// What a bridge cannot be asked, by its own words; anything that a bridge should not meet is an error of the test.
fn refused(error: &AnalysisError) -> Found {
    match error {
        AnalysisError::Cannot(_) | AnalysisError::NoStiffness { .. } | AnalysisError::NoLoad => Found::NotAsked,
        AnalysisError::Discretise(_) | AnalysisError::Vehicles(_) | AnalysisError::MovedBlock => Found::NotAsked,
        // Discrete elements ask for a largest load where limit analysis finds none: the bridge falls, or locks.
        AnalysisError::Missing { .. } => Found::NotAsked,
        other => panic!("{other}"),
    }
}

fn size(found: &Collapse) -> Found {
    let known = match found.sought {
        Sought::Load => found.carried(),
        Sought::Thickness(report) => report.map(|report| -report.factor[1]),
        Sought::SupportMovement(report) => report.last_stable,
    };
    match (known, found.status) {
        (_, Status::NotConverged | Status::StepLimit | Status::Cancelled) => Found::Open,
        (Some(known), _) => Found::Size(known),
        (None, Status::Locks | Status::StableToLastLoad) => Found::Size(f64::INFINITY),
        (None, Status::UnstableUnderSelfWeight) => Found::Size(0.0),
        (None, _) => Found::Open,
    }
}
