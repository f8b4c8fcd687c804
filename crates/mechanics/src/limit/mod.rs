//! Limit analysis.
