//! The searches and the posterior on functions whose answers are known, without an element in sight.

mod common;
mod coverage;
mod functions;
mod hierarchy;
mod identify;
mod resume;
mod two_storey;
