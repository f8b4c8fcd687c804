//! The engines of collapse behind one trait. No engine knows another, and none knows a question: a question hands it a bridge and is given a
//! result. What each knows stands in [`can`].

pub mod can;
pub mod continuum;
pub mod dem;
pub(crate) mod elements;
pub(crate) mod joints;
mod limit;
pub(crate) mod path;
pub mod rigid;
pub(crate) mod rings;
pub(crate) mod scene;
mod steps;

use crate::analysis::AnalysisError;
use bridge::{Bridge, Method};
use can::{Cannot, Feature};
use mechanics::watch::Watch;
use outcome::collapse::Collapse;
use rings::{MovedSupport, RingThickness};
use structure::blocks::Scene;
use structure::discretise::Discretised;

/// A way to find when a bridge collapses. Everything that the file says of the bridge is taken as it is: what may come and go is for the caller.
pub trait Engine: Sync {
    /// What it is called in files.
    fn method(&self) -> Method;

    /// Refuses a bridge whose joints lack what the engine needs of them.
    ///
    /// # Errors
    /// Joints without stiffness.
    fn joints(&self, bridge: &Bridge) -> Result<(), AnalysisError>;

    /// Refuses what [`load`](Self::load) would refuse before it computes.
    ///
    /// # Errors
    /// Those of an analysis that cannot be set up.
    fn ready(&self, bridge: &Bridge) -> Result<(), AnalysisError> {
        self.joints(bridge)?;
        match rigid::prepared(bridge)?.loading.variable.is_empty() {
            true => Err(AnalysisError::NoLoad),
            false => Ok(()),
        }
    }

    /// Raises the loads of the file until the bridge collapses. `resume` is a state that [`Watch::keep`] was offered.
    ///
    /// # Errors
    /// An analysis that cannot be set up.
    fn load(&self, bridge: &Bridge, resume: Option<&[u8]>, watch: &mut dyn Watch) -> Result<Collapse, AnalysisError>;

    /// Narrows the thickness at which the rings just stand.
    ///
    /// # Errors
    /// An analysis that cannot be set up, or that the engine does not make.
    fn thickness(&self, _: &RingThickness<'_>, _: &mut dyn Watch) -> Result<Collapse, AnalysisError> {
        Err(Cannot::of(self.method(), Feature::Thickness).into())
    }

    /// Moves a support until the bridge collapses.
    ///
    /// # Errors
    /// An analysis that cannot be set up, or that the engine does not make.
    fn support_movement(
        &self,
        _: &MovedSupport<'_>,
        _: Option<&[u8]>,
        _: &mut dyn Watch,
    ) -> Result<Collapse, AnalysisError> {
        Err(Cannot::of(self.method(), Feature::SupportMovement).into())
    }

    /// Raises the loads of blocks of a file or a drawing until they collapse.
    ///
    /// # Errors
    /// An analysis that cannot be set up, or that the engine does not make.
    fn drawn(
        &self,
        _: &Scene,
        _: &Discretised,
        _: Option<&[u8]>,
        _: &mut dyn Watch,
    ) -> Result<Collapse, AnalysisError> {
        Err(Cannot::of(self.method(), Feature::DrawnBlocks).into())
    }
}

/// The engine of a method.
#[must_use]
pub fn by(method: Method) -> &'static dyn Engine {
    match method {
        Method::Limit => &limit::Limit,
        Method::Path => &path::Path,
        Method::Dem => &dem::Dem,
        Method::Fe => &elements::Elements,
    }
}

/// The engine that raises the loads of a bridge by a method: fill that yields has its own in limit analysis.
#[must_use]
pub fn raising(method: Method, bridge: &Bridge) -> &'static dyn Engine {
    match structure::discretise::continuum::wanted(bridge) {
        Some(_) if method == Method::Limit => &continuum::Continuum,
        _ => by(method),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use can::{Knows, knows};
    use mechanics::watch::Unwatched;

    /// The table says what the engines do.
    #[test]
    fn what_the_table_refuses_is_what_an_engine_does_not_make() {
        let bridge = crate::samples::bridgemill();
        for method in Method::ALL {
            let refuses = by(*method).thickness(&RingThickness { bridge: &bridge }, &mut Unwatched).is_err();
            assert_eq!(refuses, knows(*method, Feature::Thickness) == Knows::No, "{method}");
            assert_eq!(by(*method).method(), *method);
        }
    }
}
