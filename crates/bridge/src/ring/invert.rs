//! The parameter at which a growing length reaches a target.

/// Solves length(t) = target for t between 0 and `end`, by Newton's steps kept inside a shrinking bracket. `speed` is
/// the derivative of the length, not negative.
pub(super) fn invert(length: impl Fn(f64) -> f64, speed: impl Fn(f64) -> f64, target: f64, end: f64) -> f64 {
    let (mut low, mut high) = (0.0, end);
    let total = length(end);
    if target <= 0.0 {
        return 0.0;
    }
    if target >= total {
        return end;
    }
    let mut t = end * target / total;
    // Bisection alone would take some 60 rounds to the last bit; Newton takes a handful.
    for _ in 0..200 {
        let excess = length(t) - target;
        if excess > 0.0 {
            high = t;
        } else {
            low = t;
        }
        let newton = t - excess / speed(t);
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - t).abs() <= f64::EPSILON * end {
            return next;
        }
        t = next;
    }
    t
}
