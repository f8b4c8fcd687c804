//! What every engine does.

use super::can::{Cannot, Feature};
use super::rigid;
use super::rings::{MovedSupport, RingThickness};
use crate::analysis::AnalysisError;
use bridge::{Bridge, Method};
use mechanics::watch::Watch;
use outcome::collapse::Collapse;
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
    fn joints(&self, _: &Bridge) -> Result<(), AnalysisError> {
        Ok(())
    }

    /// Refuses what [`load`](Self::load) would refuse before it computes.
    ///
    /// # Errors
    /// Those of an analysis that cannot be set up.
    fn ready(&self, bridge: &Bridge) -> Result<(), AnalysisError> {
        self.joints(bridge)?;
        rigid::loaded(rigid::prepared(bridge)?).map(|_| ())
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
