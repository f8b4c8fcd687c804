//! `extrados verify`: runs the verification cases and prints the manual's table.

use super::Desk;
use crate::args::Verify;
use crate::failure::Failure;
use crate::report::Report;

pub fn run(_desk: &mut Desk, _arguments: &Verify) -> Result<Report, Failure> {
    todo!()
}
