//! Integration tests of the crate, in one binary.

mod limit_any;
mod limit_arch;
mod limit_models;
mod limit_movement;
mod limit_oracle;
mod limit_section;
mod limit_thickness;
mod limit_walls;
