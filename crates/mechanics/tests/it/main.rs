//! Integration tests of the crate, in one binary.

mod dem_abutment;
mod dem_bridgemill;
mod dem_broken;
mod dem_contacts;
mod dem_dynamics;
mod dem_energy;
mod dem_friction;
mod dem_heaps;
mod dem_laws;
mod dem_resume;
mod dem_stress;
mod dem_support;
mod dem_table;
mod dem_time_step;
mod dem_viscous;
mod limit_any;
mod limit_arch;
mod limit_models;
mod limit_movement;
mod limit_oracle;
mod limit_section;
mod limit_thickness;
mod limit_walls;
mod particle_lattice;
mod particle_pairs;
mod particle_support;
