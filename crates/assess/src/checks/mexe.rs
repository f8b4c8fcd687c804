//! The modified MEXE method, as pure functions: lengths in metres, loads in tonnes.

use bridge::Bridge;
use bridge::assess::Mexe;
use bridge::ring::Intrados;

/// Geometry and factors of one span.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inputs {
    /// Span [m].
    pub span: f64,
    /// Rise at the crown [m].
    pub rise: f64,
    /// Rise at the quarter points [m].
    pub quarter_rise: f64,
    /// Thickness of the ring [m].
    pub ring: f64,
    /// Depth of fill at the crown [m].
    pub fill: f64,
    /// Barrel factor.
    pub barrel_factor: f64,
    /// Fill factor.
    pub fill_factor: f64,
    /// Joint width factor.
    pub width_factor: f64,
    /// Joint depth factor.
    pub depth_factor: f64,
    /// Mortar factor.
    pub mortar_factor: f64,
    /// Condition factor.
    pub condition_factor: f64,
    /// Span/rise factor read off the method's figure.
    pub span_rise_factor: Option<f64>,
}

/// What the method gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Allowed {
    /// Depth of fill that counts [m].
    pub fill: f64,
    /// Provisional axle load [t].
    pub provisional: f64,
    /// Span/rise factor.
    pub span_rise: f64,
    /// Profile factor.
    pub profile: f64,
    /// Material factor.
    pub material: f64,
    /// Joint factor.
    pub joint: f64,
    /// Modified axle load [t].
    pub modified: f64,
}

/// Largest provisional axle load [t].
const MOST: f64 = 70.0;
/// Span over rise up to which the span/rise factor is 1.
const STEEP: f64 = 4.0;
/// Quarter rise over rise up to which the profile factor is 1.
const FULL: f64 = 0.75;

/// Provisional axle load [t]: 740 (d + h)^2 / L^1.3, at most 70.
pub fn provisional(span: f64, ring: f64, fill: f64) -> f64 {
    (740.0 * (ring + fill).powi(2) / span.powf(1.3)).min(MOST)
}

/// Profile factor: 1 up to a quarter rise of 0.75 rises, 2.3 ((r_c - r_q) / r_c)^0.6 beyond.
pub fn profile(rise: f64, quarter_rise: f64) -> f64 {
    match quarter_rise / rise {
        ratio if ratio <= FULL => 1.0,
        ratio => 2.3 * (1.0 - ratio).max(0.0).powf(0.6),
    }
}

/// Material factor: the factors of barrel and fill by their depths.
pub fn material(barrel_factor: f64, ring: f64, fill_factor: f64, fill: f64) -> f64 {
    (barrel_factor * ring + fill_factor * fill) / (ring + fill)
}

/// The method; none where the span/rise factor must be read off its figure and was not given.
pub fn allowed(inputs: &Inputs) -> Option<Allowed> {
    // No more fill counts than the ring is thick.
    let fill = inputs.fill.min(inputs.ring);
    let steep = inputs.span / inputs.rise <= STEEP;
    let span_rise = inputs.span_rise_factor.or(steep.then_some(1.0))?;
    let provisional = provisional(inputs.span, inputs.ring, fill);
    let profile = profile(inputs.rise, inputs.quarter_rise);
    let material = material(inputs.barrel_factor, inputs.ring, inputs.fill_factor, fill);
    let joint = inputs.width_factor * inputs.depth_factor * inputs.mortar_factor;
    let modified = span_rise * profile * material * joint * inputs.condition_factor * provisional;
    Some(Allowed { fill, provisional, span_rise, profile, material, joint, modified })
}

/// The inputs of a bridge and its factors; none where the profile has no curve.
pub fn inputs(bridge: &Bridge, factors: &Mexe) -> Option<Inputs> {
    let span = bridge.spans.get(factors.span)?;
    let curve = Intrados::new(&span.profile, span.span, span.rise).ok()?;
    let height = |x: f64| {
        // The curve is told by its length; x grows with it.
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if curve.at(middle).point[0] < x { low = middle } else { high = middle }
        }
        curve.at(0.5 * (low + high)).point[1]
    };
    let quarter = 0.5 * (height(0.25 * span.span) + height(0.75 * span.span));
    Some(Inputs {
        span: span.span,
        rise: span.rise,
        quarter_rise: factors.quarter_rise.unwrap_or(quarter),
        ring: factors.ring_thickness.unwrap_or_else(|| span.rings.iter().map(|ring| ring.crown_thickness).sum()),
        fill: factors.fill_depth.unwrap_or(bridge.cover.depth),
        barrel_factor: factors.barrel_factor,
        fill_factor: factors.fill_factor,
        width_factor: factors.width_factor,
        depth_factor: factors.depth_factor,
        mortar_factor: factors.mortar_factor,
        condition_factor: factors.condition_factor,
        span_rise_factor: factors.span_rise_factor,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The worked case of REFERENCE: span 5.23 m, rise 1.57 m, quarter rise 1.373 m, ring 0.34 m.
    const CASE: Inputs = Inputs {
        span: 5.23,
        rise: 1.57,
        quarter_rise: 1.373,
        ring: 0.34,
        fill: 0.5,
        barrel_factor: 0.8,
        fill_factor: 0.7,
        width_factor: 0.9,
        depth_factor: 1.0,
        mortar_factor: 0.9,
        condition_factor: 0.7,
        span_rise_factor: None,
    };

    /// Printed to these digits: half of the last one is the tolerance. The modified load is the product of factors rounded
    /// to two digits in print, which moves it by less than a tenth of a tonne.
    #[test]
    fn the_worked_case_gives_its_printed_loads() {
        let found = allowed(&CASE).unwrap();
        assert_eq!(found.fill, 0.34);
        assert!((found.provisional - 39.83).abs() < 0.005, "{}", found.provisional);
        assert!((found.profile - 0.66).abs() < 0.005 && (found.material - 0.75).abs() < 1e-12);
        assert!((found.joint - 0.81).abs() < 1e-12);
        assert!((found.modified - 11.2).abs() < 0.1, "{}", found.modified);
        let rounded = 1.0 * 0.66 * 0.75 * 0.81 * 0.7 * found.provisional;
        assert!((rounded - 11.2).abs() < 0.05, "{rounded}");
    }

    #[test]
    fn flat_arches_need_the_figure_and_loads_are_capped() {
        let flat = Inputs { rise: 1.0, quarter_rise: 0.75, ..CASE };
        assert_eq!(allowed(&flat), None);
        let read = Inputs { span_rise_factor: Some(0.9), ..flat };
        assert_eq!(allowed(&read).map(|found| (found.span_rise, found.profile)), Some((0.9, 1.0)));
        assert_eq!(provisional(1.0, 1.0, 1.0), 70.0);
        assert_eq!(profile(1.0, 1.0), 0.0);
    }

    /// A parabola is three quarters up at its quarter points.
    #[test]
    fn the_quarter_rise_is_that_of_the_profile() {
        let mut bridge = crate::samples::bridgemill();
        bridge.spans[0].profile = bridge::ring::Profile::Parabolic;
        let factors = Mexe {
            span: 0,
            barrel_factor: 1.0,
            fill_factor: 0.7,
            width_factor: 1.0,
            depth_factor: 1.0,
            mortar_factor: 1.0,
            condition_factor: 1.0,
            span_rise_factor: None,
            quarter_rise: None,
            ring_thickness: None,
            fill_depth: None,
            axle_load: None,
        };
        let found = inputs(&bridge, &factors).unwrap();
        assert!((found.quarter_rise - 0.75 * found.rise).abs() < 1e-9, "{}", found.quarter_rise);
    }
}
