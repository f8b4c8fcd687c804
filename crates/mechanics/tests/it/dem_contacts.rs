//! Contact detection against brute force.
