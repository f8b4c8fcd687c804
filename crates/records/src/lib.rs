//! Measured records: read from files, judged, prepared, and what their peaks say. A leaf: it knows neither bridges nor
//! mechanics.
//!
//! The way of a record, each step a function from data to data:
//!
//! 1. [`read`](fn@read) makes a [`Recording`] of the text of a table, whatever the bytes are, and names every cell and row it could not take;
//! 2. [`examine`](fn@examine) judges clocks and channels, leaves out what cannot be trusted and says why: only what has gone through
//!    it is a [`Series`], and only a [`Series`] can be used further;
//! 3. [`prepare`](fn@prepare) sets to zero, takes off drift, filters, resamples, cuts and aligns, and lists what was done in words;
//! 4. [`peaks`](fn@peaks) picks the peak of every channel of every run, and [`dynamics`](fn@dynamics) and [`plane_strain`](fn@plane_strain) say what they tell.
//!
//! [`synthesise`](fn@synthesise) goes the other way: exact histories become a run with stated noise, labelled synthetic, and [`write`](fn@write)
//! puts a run into the format that [`read`](fn@read) takes.
//!
//! Numbers are in SI inside ([s], [m], [-], [m/s]); units are converted in `unit.rs` alone.

mod cards;
mod finding;
mod health;
mod peaks;
mod prepare;
mod series;
mod signal;
mod synthetic;
mod table;
mod unit;
mod verdict;
mod write;

pub use cards::CARDS;
pub use finding::{Done, Finding, Place};
pub use findings::Severity;
pub use health::{Accept, Expected, LeaveOut, Scrutiny, examine};
pub use peaks::{Peak, PeakTable, peaks};
pub use prepare::{Align, Cut, Detrend, Preparation, Reference, Zero, noise_bandwidth, prepare};
pub use series::{Channel, Recording, Series};
pub use synthetic::{Exact, Noise, synthesise};
pub use table::{Column, Dialect, Mapping, Others, Read, ReadOptions, Source, read};
pub use unit::{Dimension, UNITS, Unit};
pub use verdict::{Answer, ChannelTest, Dynamics, LineTest, PlaneStrain, Test, dynamics, plane_strain};
pub use write::write;
