//! What a file asks beside its bridge, where that speaks of quantities of the file by their paths: ranges, cases, parameters.

pub(crate) mod case;
pub(crate) mod update;
pub(crate) mod vary;
