//! Greatest bending moment and shear of a simply supported span under a moving pattern, over all of its positions.
//!
//! At a section under an axle the moment is a polynomial of the axle's place, of third degree at most, between the places
//! where some load enters or leaves the span: it is found from four values and its greatest value from its derivative. So
//! are shears, of second degree. Without uniform loads that move along, the greatest moment is always under an axle; with
//! them it may lie under the uniform load, and these places are searched as well.

use crate::{Axle, Pattern, Stretch};

/// The greatest bending moment in a simply supported span [m], in [N m].
pub fn greatest_bending(pattern: &Pattern, span: f64) -> f64 {
    let load = Load { pattern, span };
    let mut best = 0.0_f64;
    for (k, axle) in pattern.axles.iter().enumerate() {
        // The axle stands at x: a place of the first axle.
        let mut breaks = vec![0.0, span];
        for place in load.edges() {
            // This edge crosses a support, or the axle itself for edges of uniform loads at it.
            breaks.extend([axle.offset - place, span + place - axle.offset].map(|b| b.clamp(0.0, span)));
            breaks.extend([place - axle.offset, span - (axle.offset - place)].map(|b| b.clamp(0.0, span)));
        }
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        best = most(best, &breaks, |x| load.moment(x, x + axle.offset, Some(k)));
    }
    if pattern.stretches.iter().any(|s| s.from.is_finite() || s.to.is_finite()) || pattern.axles.is_empty() {
        return under_uniform_loads(&load, best);
    }
    best
}

/// The greatest bending moment at one section, a share of a simply supported span [m] from its left support, in [N m].
pub fn greatest_bending_at(pattern: &Pattern, span: f64, share: f64) -> f64 {
    let x = share * span;
    over_passages(pattern, span, &[0.0, x, span], |load, s| load.moment(x, s, None))
}

/// The greatest shear: a reaction of a simply supported span [m], in [N].
pub fn greatest_shear(pattern: &Pattern, span: f64) -> f64 {
    over_passages(pattern, span, &[0.0, span], |load, s| load.reaction(s))
}

/// The greatest effect of a pattern that drives over the span either way, by the place of its first axle: smooth while nothing crosses one of
/// `sections`.
fn over_passages(pattern: &Pattern, span: f64, sections: &[f64], effect: impl Fn(&Load, f64) -> f64) -> f64 {
    [pattern, &pattern.reversed()].into_iter().fold(0.0, |best, pattern| {
        let load = Load { pattern, span };
        most(best, &load.breaks_of_passage(sections), |s| effect(&load, s))
    })
}

/// The greatest value of a function between breaks where it is above `best`.
fn most(best: f64, breaks: &[f64], f: impl Fn(f64) -> f64) -> f64 {
    let places = breaks.windows(2).flat_map(|pair| peaks(pair[0], pair[1], &f));
    places.map(&f).fold(best, f64::max)
}

/// The uniform load, as a total [N], that gives a span [m] the same greatest bending moment and the same greatest shear.
pub fn equivalent_uniform_load(pattern: &Pattern, span: f64) -> [f64; 2] {
    [8.0 * greatest_bending(pattern, span) / span, 2.0 * greatest_shear(pattern, span)]
}

struct Load<'a> {
    pattern: &'a Pattern,
    span: f64,
}

impl Load<'_> {
    /// Offsets behind the first axle of everything that can enter or leave [m].
    fn edges(&self) -> impl Iterator<Item = f64> {
        let axles = self.pattern.axles.iter().map(|a| a.offset);
        let stretches = self.pattern.stretches.iter().flat_map(|s| [s.from, s.to]).filter(|e| e.is_finite());
        axles.chain(stretches)
    }

    /// Places of the first axle [m] between which the effect of the pattern is smooth while it drives over the span: at each an
    /// edge crosses one of `sections`. They begin at 0 at the latest and end one span after the last edge has left.
    fn breaks_of_passage(&self, sections: &[f64]) -> Vec<f64> {
        let mut breaks: Vec<f64> = self.edges().flat_map(|edge| sections.iter().map(move |x| x + edge)).collect();
        breaks.push(0.0);
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        let reach = breaks.last().copied().unwrap_or(0.0) + self.span;
        breaks.push(reach);
        breaks
    }

    /// Moment at section `x` with the first axle at `s`; axle `there` stands at the section whatever round-off says.
    fn moment(&self, x: f64, s: f64, there: Option<usize>) -> f64 {
        let l = self.span;
        let influence = |at: f64| if at <= x { at * (l - x) / l } else { x * (l - at) / l };
        let mut sum = 0.0;
        for (k, Axle { force, offset }) in self.pattern.axles.iter().enumerate() {
            let at = if there == Some(k) { x } else { s - offset };
            if (0.0..=l).contains(&at) {
                sum += force * influence(at);
            }
        }
        for Stretch { force, from, to, .. } in &self.pattern.stretches {
            let [a, b] = [(s - to).clamp(0.0, l), (s - from).clamp(0.0, l)];
            let left = |a: f64, b: f64| 0.5 * (b * b - a * a) * (l - x) / l;
            let right = |a: f64, b: f64| 0.5 * ((l - a) * (l - a) - (l - b) * (l - b)) * x / l;
            sum += force * (left(a.min(x), b.min(x)) + right(a.max(x), b.max(x)));
        }
        sum
    }

    /// Reaction of the left support with the first axle at `s`; an axle on the support counts.
    fn reaction(&self, s: f64) -> f64 {
        let l = self.span;
        let mut sum = 0.0;
        for Axle { force, offset } in &self.pattern.axles {
            let at = s - offset;
            // Round-off must not take an axle off the support.
            if at >= -1e-12 * (1.0 + s.abs()) && at <= l {
                sum += force * (1.0 - at.max(0.0) / l);
            }
        }
        for Stretch { force, from, to, .. } in &self.pattern.stretches {
            let [a, b] = [(s - to).clamp(0.0, l), (s - from).clamp(0.0, l)];
            sum += force * ((b - a) - 0.5 * (b * b - a * a) / l);
        }
        sum
    }
}

/// Where a polynomial of third degree at most may be greatest on [a, b]: its ends and where its derivative vanishes.
fn peaks(a: f64, b: f64, f: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut places = vec![a, b];
    let h = b - a;
    if h <= 1e-12 * (1.0 + a.abs() + b.abs()) {
        return places;
    }
    // Inner points, since the function jumps where loads enter: t = 1/5 .. 4/5. Newton's form by differences.
    let y: Vec<f64> = (1..5).map(|k| f(a + h * k as f64 / 5.0)).collect();
    let [d1, d2, d3] = [y[1] - y[0], y[2] - 2.0 * y[1] + y[0], y[3] - 3.0 * y[2] + 3.0 * y[1] - y[0]];
    // p(u) = y0 + d1 u + d2 u(u-1)/2 + d3 u(u-1)(u-2)/6 with u = 5 t - 1; its derivative is a quadratic.
    let (q2, q1, q0) = (0.5 * d3, d2 - d3, d1 - 0.5 * d2 + d3 / 3.0);
    let scale = y.iter().fold(f64::MIN_POSITIVE, |m, v| m.max(v.abs()));
    let roots = if q2.abs() > 1e-10 * scale {
        let disc = q1 * q1 - 4.0 * q2 * q0;
        let root = disc.max(0.0).sqrt();
        let q = -0.5 * (q1 + root.copysign(q1));
        if disc < 0.0 { vec![] } else { vec![q / q2, if q == 0.0 { 0.0 } else { q0 / q }] }
    } else if q1.abs() > 0.0 {
        vec![-q0 / q1]
    } else {
        vec![]
    };
    places.extend(roots.into_iter().map(|u| a + h * (u + 1.0) / 5.0).filter(|x| (a..=b).contains(x)));
    places
}

/// Searches sections that no axle stands at: for each place of the pattern the greatest moment over the sections is concave
/// between axles, and over places the greatest one is sought between the places where something enters or leaves.
fn under_uniform_loads(load: &Load, mut best: f64) -> f64 {
    let l = load.span;
    let mut breaks: Vec<f64> = load.edges().flat_map(|place| [place, l + place]).collect();
    breaks.push(0.0);
    breaks.sort_by(f64::total_cmp);
    let (first, last) = (breaks[0] - l, breaks[breaks.len() - 1] + l);
    breaks.insert(0, first);
    breaks.push(last);
    breaks.dedup();
    for pair in breaks.windows(2).filter(|pair| pair[1] > pair[0]) {
        const PARTS: usize = 8;
        let over = |s: f64| golden(0.0, l, 64, |x| load.moment(x, s, None));
        for part in 0..PARTS {
            let at = |k: usize| pair[0] + (pair[1] - pair[0]) * k as f64 / PARTS as f64;
            let value = golden(at(part), at(part + 1), 48, over);
            if value > best * (1.0 + 1e-12) {
                best = value;
            }
        }
    }
    best
}

/// The greatest value of a function with one peak on [a, b], by golden sections.
fn golden(mut a: f64, mut b: f64, steps: usize, f: impl Fn(f64) -> f64) -> f64 {
    const SHARE: f64 = 0.618_033_988_749_894_8;
    let (mut x1, mut x2) = (b - SHARE * (b - a), a + SHARE * (b - a));
    let (mut y1, mut y2) = (f(x1), f(x2));
    for _ in 0..steps {
        if y1 < y2 {
            (a, x1, y1) = (x1, x2, y2);
            x2 = a + SHARE * (b - a);
            y2 = f(x2);
        } else {
            (b, x2, y2) = (x2, x1, y1);
            x1 = b - SHARE * (b - a);
            y1 = f(x1);
        }
    }
    if y1 > y2 { y1 } else { y2 }
}
