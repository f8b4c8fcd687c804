//! Reading whole files.

mod files;
mod reading;
