//! Tests of meshes.
