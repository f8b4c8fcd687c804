//! The modified MEXE method, as pure functions: lengths in metres, loads in tonnes.

use bridge::Bridge;
use bridge::assess::{Mexe, MexeAxles};

/// Geometry of one span, and the factors of its file.
#[derive(Debug, Clone, PartialEq)]
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
    /// Level of the right springing above the left one [m].
    pub right_springing: f64,
    /// Skew [rad].
    pub skew: f64,
    /// Factors of the file.
    pub factors: Mexe,
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
    /// Whether that is the curve's, as recalled, and not the file's.
    pub recalled: bool,
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
/// Span over rise and span/rise factor: BA 16/97, Figure 3/3. What its axes reach (4 to 8, 0.6 to 1.0) is read, the curve between
/// is recalled, to some 0.03; Pippard's elastic arch, from which the method comes, gives a band about it (see the tests).
const SPAN_RISE: [(f64, f64); 5] = [(4.0, 1.0), (5.0, 0.88), (6.0, 0.77), (7.0, 0.68), (8.0, 0.60)];
/// How far the recalled curve may be from the figure.
pub const READING: f64 = 0.03;
/// Spans [m], and thicknesses of ring and fill together [m], on the nomogram of BA 16/97, Figure 3/1.
const SPANS: [f64; 2] = [1.5, 18.0];
/// Largest skew [rad]: BD 21 and CS 454 do not use the method for more than 35 degrees (recalled).
const SKEW: f64 = 35.0 * std::f64::consts::PI / 180.0;
const DEPTHS: [f64; 2] = [0.25, 1.8];
/// Quarter rise over rise up to which the profile factor is 1.
const FULL: f64 = 0.75;

/// Springings that differ by more than this share of the span are not level.
const UNEQUAL: f64 = 0.01;

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

/// Span/rise factor: 1 up to a span of four rises, then the method's curve; none beyond its end at eight.
pub fn span_rise(ratio: f64) -> Option<f64> {
    if ratio <= SPAN_RISE[0].0 {
        return Some(1.0);
    }
    let piece = SPAN_RISE.windows(2).find(|pair| ratio <= pair[1].0)?;
    let [(x0, y0), (x1, y1)] = [piece[0], piece[1]];
    Some(y0 + (y1 - y0) * (ratio - x0) / (x1 - x0))
}

/// The method; none where the span/rise factor is beyond its curve and was not given.
pub fn allowed(inputs: &Inputs) -> Option<Allowed> {
    let factors = &inputs.factors;
    // No more fill counts than the ring is thick.
    let fill = inputs.fill.min(inputs.ring);
    let ratio = inputs.span / inputs.rise;
    let recalled = factors.span_rise_factor.is_none() && ratio > SPAN_RISE[0].0;
    let span_rise = factors.span_rise_factor.or_else(|| span_rise(ratio))?;
    let provisional = provisional(inputs.span, inputs.ring, fill);
    let profile = profile(inputs.rise, inputs.quarter_rise);
    let material = material(factors.barrel_factor, inputs.ring, factors.fill_factor, fill);
    let joint = factors.width_factor * factors.depth_factor * factors.mortar_factor;
    let modified = span_rise * profile * material * joint * factors.condition_factor * provisional;
    Some(Allowed { fill, provisional, span_rise, recalled, profile, material, joint, modified })
}

/// Axle factor A_f: the modified axle load is that on each axle of a bogie of two that keep on the ground; other axles have a figure of
/// their own (BA 16/97, 3.33 and Figures 3/5), which is not known here. One axle alone does no more than one of a pair: 1. None where
/// the file must give it.
pub fn axle_factor(factors: &Mexe) -> Option<f64> {
    match (factors.axle_factor, factors.axles, factors.lift_off) {
        (Some(read), ..) => Some(read),
        (None, MexeAxles::Single, _) | (None, MexeAxles::Bogie, false) => Some(1.0),
        (None, MexeAxles::Bogie, true) | (None, MexeAxles::Triple, _) => None,
    }
}

/// In what the span lies outside of what the method was made for; none where it does not.
pub fn outside(inputs: &Inputs) -> Option<String> {
    let depth = inputs.ring + inputs.fill.min(inputs.ring);
    let ratio = inputs.span / inputs.rise;
    let [(low, high), (thin, thick)] = [SPANS, DEPTHS].map(|range| (range[0], range[1]));
    let last = SPAN_RISE[SPAN_RISE.len() - 1].0;
    let mut found = Vec::new();
    if inputs.right_springing.abs() > UNEQUAL * inputs.span {
        found.push(format!(
            "it is made for level springings, and these differ by {:.2} m",
            inputs.right_springing.abs()
        ));
    }
    if !(low..=high).contains(&inputs.span) {
        found.push(format!("it is made for spans of {low} to {high} m, and this one is {:.2} m", inputs.span));
    }
    if !(thin..=thick).contains(&depth) {
        found.push(format!("it is made for {thin} to {thick} m of ring and fill, and here {depth:.2} m count"));
    }
    if inputs.skew > SKEW + 1e-9 {
        found.push(format!(
            "it is made for skews of up to {:.0} degrees, and this one is {:.0} degrees",
            SKEW.to_degrees(),
            inputs.skew.to_degrees()
        ));
    }
    if ratio > last && inputs.factors.span_rise_factor.is_none() {
        found.push(format!(
            "its curve of the span/rise factor ends at {last}, and span over rise is {ratio:.2}: span_rise_factor in [mexe] could go beyond it, at the \
             engineer's own judgement"
        ));
    }
    (!found.is_empty()).then(|| found.join("; "))
}

/// The inputs of a bridge and its factors; none where the profile has no curve.
pub fn inputs(bridge: &Bridge, factors: &Mexe) -> Option<Inputs> {
    let span = bridge.spans.get(factors.span)?;
    let curve = span.intrados().ok()?;
    let right = span.right_springing;
    // Above the line between the springings.
    let height = |x: f64| curve.level(x) - right * (x / span.span);
    let quarter = 0.5 * (height(0.25 * span.span) + height(0.75 * span.span));
    Some(Inputs {
        span: span.span,
        rise: if right == 0.0 { span.rise } else { height(0.5 * span.span) },
        quarter_rise: factors.quarter_rise.unwrap_or(quarter),
        ring: factors.ring_thickness.unwrap_or_else(|| span.rings.iter().map(|ring| ring.crown_thickness).sum()),
        fill: factors.fill_depth.unwrap_or(bridge.cover.depth),
        right_springing: right,
        skew: span.skew,
        factors: factors.clone(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const FACTORS: Mexe = Mexe {
        span: 0,
        barrel_factor: 0.8,
        fill_factor: 0.7,
        width_factor: 0.9,
        depth_factor: 1.0,
        mortar_factor: 0.9,
        condition_factor: 0.7,
        span_rise_factor: None,
        quarter_rise: None,
        ring_thickness: None,
        fill_depth: None,
        axle_load: None,
        axles: MexeAxles::Single,
        lift_off: false,
        axle_factor: None,
    };

    /// A worked case: span 5.23 m, rise 1.57 m, quarter rise 1.373 m, ring 0.34 m.
    const CASE: Inputs = Inputs {
        span: 5.23,
        rise: 1.57,
        quarter_rise: 1.373,
        ring: 0.34,
        fill: 0.5,
        skew: 0.0,
        right_springing: 0.0,
        factors: FACTORS,
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
    fn flat_arches_follow_the_curve_and_loads_are_capped() {
        let flat = |rise: f64| Inputs { rise, quarter_rise: 0.75 * rise, ..CASE };
        let at = |ratio: f64| allowed(&flat(5.23 / ratio)).map(|found| (found.span_rise, found.recalled));
        assert_eq!((at(3.9), at(8.01)), (Some((1.0, false)), None));
        assert!(at(6.5).is_some_and(|(factor, recalled)| (factor - 0.725).abs() < 1e-9 && recalled));
        let factors = Mexe { span_rise_factor: Some(0.55), ..FACTORS };
        let read = allowed(&Inputs { factors, ..flat(0.6) }).unwrap();
        assert_eq!((read.span_rise, read.recalled, read.profile), (0.55, false, 1.0));
        assert_eq!(provisional(1.0, 1.0, 1.0), 70.0);
        assert_eq!(profile(1.0, 1.0), 0.0);
    }

    /// The method's load is that of an axle of a bogie whose axles keep on the ground; other axles need the method's figure.
    #[test]
    fn other_axles_than_a_bogie_need_their_factor() {
        let with = |axles, lift_off, axle_factor| super::axle_factor(&Mexe { axles, lift_off, axle_factor, ..FACTORS });
        assert_eq!(with(MexeAxles::Bogie, false, None), Some(1.0));
        assert_eq!(with(MexeAxles::Single, false, None), Some(1.0));
        assert_eq!((with(MexeAxles::Bogie, true, None), with(MexeAxles::Triple, false, None)), (None, None));
        assert_eq!(with(MexeAxles::Bogie, true, Some(0.8)), Some(0.8));
    }

    #[test]
    fn what_lies_outside_of_the_method_is_named() {
        assert_eq!(outside(&CASE), None);
        assert!(outside(&Inputs { skew: 40_f64.to_radians(), ..CASE }).is_some_and(|why| why.contains("40 degrees")));
        assert!(outside(&Inputs { skew: 30_f64.to_radians(), ..CASE }).is_none());
        let wide = Inputs { span: 18.3, rise: 1.0, ring: 1.0, fill: 2.0, ..CASE };
        let said = outside(&wide).unwrap();
        for words in ["18.30 m", "2.00 m count", "span over rise is 18.30"] {
            assert!(said.contains(words), "{said}");
        }
    }

    /// Another road to the curve: the arch from which the method was made, parabolic, on two pins, as strong as 1.4 MPa, with soil
    /// and stone of 22 kN/m^3 up to the road and the load at its crown on a width of twice the depth there (Pippard 1948). How much
    /// less a flatter one carries depends on its span; the curve must lie between 5 m and 18 m.
    #[test]
    fn the_curve_lies_between_the_elastic_arches_of_short_and_long_spans() {
        let carries = |ratio: f64, span: f64, ring: f64, fill: f64| {
            let (rise, n) = (span / ratio, 2000);
            let place = |k: usize| span * k as f64 / n as f64;
            let height = |x: f64| 4.0 * rise * x * (span - x) / span.powi(2);
            let weight = |x: f64| 22e3 * (ring + fill + rise - height(x));
            let step = span / n as f64;
            let loads: Vec<f64> = (0..n).map(|k| weight(place(k) + 0.5 * step) * step).collect();
            let (mut shear, mut moment) = (0.5 * loads.iter().sum::<f64>(), 0.0);
            let (mut work, mut square, mut crown) = (0.0, 0.0, 0.0);
            for (k, load) in loads.iter().enumerate() {
                let before = moment;
                moment += (shear - 0.5 * load) * step;
                shear -= load;
                let y = height(place(k) + 0.5 * step);
                work += 0.5 * (before + moment) * y * step;
                square += y * y * step;
                if k + 1 == n / 2 {
                    crown = moment;
                }
            }
            let thrust = work / square;
            let stress = |thrust: f64, moment: f64| thrust / ring + 6.0 * moment / ring.powi(2);
            let dead = stress(thrust, crown - thrust * rise);
            let thrust = 25.0 / 128.0 * ratio;
            let live = stress(thrust, 0.25 * span - thrust * rise) / (2.0 * (ring + fill));
            (1.4e6 - dead) / live
        };
        for (ratio, factor) in SPAN_RISE {
            let of =
                |span: f64, ring: f64, fill: f64| carries(ratio, span, ring, fill) / carries(4.0, span, ring, fill);
            let (short, long) = (of(5.0, 0.34, 0.34), of(18.0, 0.72, 0.5));
            assert!(long <= factor && factor <= short, "{ratio}: {long} {factor} {short}");
        }
    }

    /// A parabola is three quarters up at its quarter points.
    #[test]
    fn the_quarter_rise_is_that_of_the_profile() {
        let mut bridge = crate::samples::bridgemill();
        bridge.spans[0].profile = bridge::ring::Profile::Parabolic;
        let found = inputs(&bridge, &FACTORS).unwrap();
        assert!((found.quarter_rise - 0.75 * found.rise).abs() < 1e-9, "{}", found.quarter_rise);
    }
}
