//! The searches and the posterior on functions whose answers are known, without an element in sight.

mod common;
mod common_gain;
mod coverage;
mod functions;
mod gain;
mod hierarchy;
mod identify;
mod linearised;
mod resume;
mod two_storey;
