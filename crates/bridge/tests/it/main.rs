//! Reading whole files.

mod blocks;
mod cards;
mod files;
mod help;
mod load_test;
mod materials;
mod messages;
mod mutation;
mod reading;
mod reference;
mod vary;
mod written;
