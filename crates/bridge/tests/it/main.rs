//! Reading whole files.

mod cards;
mod files;
mod reading;
mod reference;
