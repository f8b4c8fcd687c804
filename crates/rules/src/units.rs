//! How many units of a reference loading a vehicle is worth: as many as give a simple span the same greatest bending moment,
//! or the same greatest shear. With the units of Type RA1 loading this gives the Route Availability number of a vehicle.

use crate::{Library, Vehicle, equivalent_uniform_load};

/// How many units a vehicle is worth on one span.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Units {
    /// Span [m].
    pub span: f64,
    /// Units with the same greatest bending moment.
    pub bending: f64,
    /// Units with the same greatest shear.
    pub shear: f64,
}

/// The Route Availability number of a vehicle.
#[derive(Debug, Clone, PartialEq)]
pub struct RouteAvailability {
    /// The number: RA8 is 8, and stands for 18 units.
    pub number: u32,
    /// Units on every span that the reference loading may be used for.
    pub units: Vec<Units>,
}

/// Greatest bending moment [N m] and shear [N] of a simple span [m] over all arrangements of a vehicle, with its uniform
/// loads.
pub fn greatest_of(vehicle: &Vehicle, span: f64) -> [f64; 2] {
    vehicle
        .patterns()
        .iter()
        .map(|pattern| equivalent_uniform_load(pattern, span))
        .fold([0.0; 2], |most, [m, v]| [most[0].max(m * span / 8.0), most[1].max(v / 2.0)])
}

/// How many units a vehicle is worth on each span [m], where `reference` is so many units.
pub fn equivalent_units(vehicle: &Vehicle, reference: &Vehicle, units: f64, spans: &[f64]) -> Vec<Units> {
    let worth = |&span: &f64| {
        let ([m, v], [unit_m, unit_v]) = (greatest_of(vehicle, span), greatest_of(reference, span));
        Units { span, bending: units * m / unit_m, shear: units * v / unit_v }
    };
    spans.iter().map(worth).collect()
}

impl Units {
    /// The larger of both.
    pub fn governing(&self) -> f64 {
        self.bending.max(self.shear)
    }
}

impl Library {
    /// The Route Availability number of a vehicle from its greatest moments and shears on simple spans [m], beside those of
    /// the vehicle `ra10`, which is 20 units; RA n stands for n + 10 units. Spans beyond the limit of that model are left
    /// out; none where no span is left. A hundredth of a unit counts as rounding of axle loads.
    pub fn route_availability(&self, vehicle: &Vehicle, spans: &[f64]) -> Option<RouteAvailability> {
        let (model, reference) = self.vehicle("ra10")?;
        let longest = model.span_limit.as_ref().map_or(f64::INFINITY, |limit| limit.longest_m);
        let within: Vec<f64> = spans.iter().copied().filter(|span| *span > 0.0 && *span <= longest).collect();
        let units = equivalent_units(vehicle, reference, 20.0, &within);
        let most = units.iter().map(Units::governing).reduce(f64::max)?;
        Some(RouteAvailability { number: (most - 10.01).ceil().max(0.0) as u32, units })
    }
}
