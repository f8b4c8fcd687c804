//! The equilibrium path: rigid blocks whose joints give, from their own weight to the largest load and past it.
//!
//! Each joint answers the overlap of its two sides (`contact`), the blocks move by any amount, and Newton's method with exact
//! tangents finds the states in which all forces balance. The length of the path, and not the load, is what is prescribed
//! (Riks 1979; Crisfield 1981), so that the load may fall.
//!
//! Read in the order of the method: `model` numbers the equations, `joint` gives the forces of one joint, `restraint` that of
//! fill which a block moves against, and `system` those of all, `correct` balances a guess, `inertia` tells whether what is balanced stands, `relax` lets blocks come to rest or
//! fall, `stand` finds the first state, `trace` goes from state to state, `frame` and `mechanism` say what a state is like and how it ends, `sweep` follows many loads on the same blocks.

mod beyond;
mod correct;
mod dual;
mod first_met;
mod frame;
mod inertia;
mod joint;
mod mechanism;
mod model;
mod near;
mod onset;
mod outcome;
mod relax;
mod restraint;
mod rise;
mod settings;
mod stand;
mod sweep;
mod system;
mod trace;

pub use onset::{Measure, Onset};
pub use outcome::{Cause, EndState, Frame, JointState, Outcome, PathPoint, Status};
pub use settings::{Program, Settings};
pub use sweep::{Ground, Sweeper};
pub use trace::collapse;
