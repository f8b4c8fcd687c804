//! Rigid blocks in contact: discrete elements, the equilibrium path and limit analysis on one block model.
//!
//! This crate computes and has never heard of a bridge. It owns no file, clock or thread, and no format but the bytes of stopped
//! runs ([`kept`]).
//!
//! # Conventions, stated once
//! - SI units throughout: m, kg, s, N, Pa. The plane problem is one metre wide, so a mass is in kg per metre
//!   of width, a force in N/m, a moment in N (N·m/m).
//! - x to the right, y up; rotations and moments counter-clockwise positive [rad].
//! - Polygons run counter-clockwise.
//! - Interface forces are named, never signed by convention: `compression` is positive when the two sides are
//!   pressed together. `shear` is positive when the force on the *second* body acts along the contact's tangent.
//! - Stress tensors are tension-positive.
//! - Results do not depend on the number of threads: every sum has a fixed order.

mod acting;
mod banded;
pub mod blocks;
pub mod contact;
pub mod dem;
pub mod fem;
pub mod ids;
pub mod kept;
pub mod limit;
mod numbering;
pub mod path;
pub mod plane;
pub mod watch;
mod wide;
