//! Model updating: the parameters of any model from measured channels, and what the data cannot tell.
//!
//! The crate knows no element, no file, no clock and no thread. The model is a [`Forward`]; many points are evaluated at
//! once by the caller's [`Map`]; finished evaluations are offered line by line to the caller's [`Watch`], so that a search
//! that was stopped or killed goes on from its [`Log`] without doing any evaluation twice.
//!
//! # Reading order
//! 1. [`parameter`], [`channel`], [`forward`]: what is posed.
//! 2. [`misfit`]: errors, weights and norm of the railway paper (eq. 3, eq. 4), and alternatives.
//! 3. [`search::hierarchical`]: the paper's search, its Fig. 4.
//! 4. [`search::modern`]: trust-region least squares from many starts; [`search::referee`] and [`search::gradient`] beside it.
//! 5. [`identify`], [`posterior`]: what the data can and cannot tell.
//!
//! # Conventions
//! - Values carry the units of the caller; nothing is converted. Signs are those of the records.
//! - A *point* has one value for each parameter, in the order of the problem; a column of derivatives belongs to one parameter.
//! - A *share* is a place in a parameter's range, 0 at the lower and 1 at the upper bound.
//! - How a search ends is a named status and never an error.
//! - Results are the same bits whatever the caller's map does.

pub mod basis;
pub mod channel;
pub mod evaluator;
pub mod forward;
pub mod identify;
pub mod linearised;
pub mod log;
pub mod misfit;
pub mod parameter;
pub mod posterior;
pub mod problem;
pub mod report;
pub mod search;
pub mod surrogate;
pub mod watch;

pub use basis::{Basis, Halt};
pub use channel::Channel;
pub use evaluator::Evaluator;
pub use forward::{Evaluation, Failure, Forward, Map, Request, Response, STOPPED, Samples, Serial};
pub use linearised::Linearised;
pub use linearised::design::{Design, Expected};
pub use log::Log;
pub use misfit::Misfit;
pub use parameter::{Parameter, Scale, Start};
pub use problem::{Flaw, Problem};
pub use report::{Found, FoundChannel, FoundParameter};
pub use watch::{Progress, Stopped, Unwatched, Watch};
