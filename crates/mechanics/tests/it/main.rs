//! Integration tests of the crate, in one binary.

mod dem_bridgemill;
mod dem_broken;
mod dem_contacts;
mod dem_dynamics;
mod dem_friction;
mod dem_laws;
mod dem_resume;
mod dem_stress;
mod dem_support;
