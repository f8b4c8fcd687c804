//! The engines of collapse behind one trait. No engine knows another, and none knows a question: a question hands it a bridge and is given a
//! result. What each knows stands in [`can`].

pub mod can;
pub mod continuum;
pub mod dem;
pub(crate) mod elements;
mod interface;
pub(crate) mod joints;
mod limit;
pub(crate) mod path;
pub mod rigid;
pub(crate) mod rings;
pub(crate) mod scene;
mod steps;

pub use interface::Engine;

use bridge::{Bridge, Method};

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
        Some(_) if can::knows(method, can::Feature::Continuum) == can::Knows::Yes => &continuum::Continuum,
        _ => by(method),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use can::{Feature, Knows, knows};
    use mechanics::watch::Unwatched;
    use rings::RingThickness;

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
