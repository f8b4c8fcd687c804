//! Searches for the parameters: the paper's, a modern one, a global referee and a plain gradient search.

pub mod gradient;
pub mod hierarchical;
pub mod jacobian;
pub mod modern;
pub mod record;
pub mod referee;
mod refined;
mod replay;
pub mod surface;
pub mod sweep;
