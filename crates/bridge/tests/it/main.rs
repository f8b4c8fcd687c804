//! Reading whole files.

mod reading;
