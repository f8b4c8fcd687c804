//! The loads of a file as an engineer asked for them: an axle has a width of its own, so that its load times the width of the bridge
//! is no load that anybody asked for.

use super::Collapse;
use bridge::{Bridge, LoadKind};

/// Axles of a load, on a width of their own.
#[derive(Debug, Clone, PartialEq)]
pub struct AskedAxles {
    /// Name of the load.
    pub name: String,
    /// Forces of its axles as the file has them [N].
    pub axles: Vec<f64>,
    /// Width of the barrel that carries an axle [m].
    pub effective_width: f64,
}

/// Loads of axles, in the order of the file.
pub fn asked(bridge: &Bridge) -> Vec<AskedAxles> {
    let axles = bridge.loads.iter().filter_map(|load| match &load.kind {
        LoadKind::Axles { axles, effective_width, .. } => Some(AskedAxles {
            name: load.name.clone(),
            axles: axles.iter().map(|axle| axle.0).collect(),
            effective_width: *effective_width,
        }),
        _ => None,
    });
    axles.collect()
}

impl Collapse {
    /// How often the loads of the file are carried.
    pub fn load_factor(&self) -> Option<f64> {
        Some(self.carried().filter(|_| self.reference_load > 0.0)? / self.reference_load)
    }

    /// Whether loads have widths of their own, so that a load per metre times the width of the bridge is nothing that was asked for.
    pub fn has_own_widths(&self) -> bool {
        self.asked.iter().any(|asked| (asked.effective_width - self.width).abs() > 1e-9)
    }
}
