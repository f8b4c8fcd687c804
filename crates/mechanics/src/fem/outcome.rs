//! How a run ended, and what each step took.

/// How it ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// All of the load is carried.
    Completed,
    /// No balance was found beyond the load reached, however small the step.
    NotConverged,
    /// The tangent has no inverse beyond the load reached, however small the step: a mechanism, or a part without support.
    Singular,
    /// The onlooker stopped it.
    Cancelled,
}

/// One attempt at a load step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Step {
    /// Share of the load at its end, 0 to 1.
    pub reached: f64,
    /// Iterations it took.
    pub iterations: u32,
    /// Out-of-balance force over applied force at its end.
    pub unbalanced: f64,
    /// Points that flow or crack.
    pub yielding: usize,
    /// Plain elements (`Q4`, and `QM6` whose modes found no balance in flow that is not associated) in which every point flows. Flow keeps volume in a fixed ratio to shear, to which four such points bind more than the
    /// element's nodes can follow: it locks, and what it carries is too much.
    pub locking: usize,
    /// Springs of interfaces that are open.
    pub open: usize,
    /// Springs of interfaces that slide.
    pub sliding: usize,
    /// Whether it was kept; otherwise the step was halved.
    pub kept: bool,
}

/// A run.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// How it ended.
    pub status: Status,
    /// Share of the load carried, 0 to 1; the state stands there.
    pub reached: f64,
    /// Iterations of all attempts.
    pub iterations: u64,
    /// Every attempt, in order.
    pub steps: Vec<Step>,
}
