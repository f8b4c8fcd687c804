//! Curves against closed forms, and against what every curve must be.

use super::*;

/// Rounding of a few operations on lengths of some ten metres.
const EXACT: f64 = 1e-12;

fn close(a: f64, b: f64) {
    assert!((a - b).abs() <= EXACT * b.abs().max(1.0), "{a} {b}");
}

fn profiles() -> Vec<(Profile, f64, f64)> {
    let circle: Vec<[f64; 2]> = (0..=20)
        .map(|index| {
            let angle = -0.6 + 0.06 * f64::from(index);
            [16.0 * (angle.sin() + 0.6f64.sin()), 16.0 * (angle.cos() - 0.6f64.cos())]
        })
        .collect();
    vec![
        (Profile::Segmental, 18.30, 2.85),
        (Profile::Semicircular, 10.0, 5.0),
        (Profile::Parabolic, 18.30, 2.85),
        (Profile::Elliptical, 12.0, 3.0),
        (Profile::Elliptical, 6.0, 5.0),
        (Profile::ThreeCentred { haunch_radius: 1.5 }, 12.0, 3.5),
        (Profile::Pointed, 6.0, 4.5),
        (Profile::Pointed, 6.0, 7.5),
        (Profile::Measured { points: circle }, 32.0 * 0.6f64.sin(), 16.0 * (1.0 - 0.6f64.cos())),
    ]
}

#[test]
fn segment_of_bridgemill() {
    let intrados = Intrados::between(&Profile::Segmental, 18.30, 2.85, 0.0).unwrap();
    let half_angle = 2.0 * (2.85f64 / 9.15).atan();
    let radius = 9.15 / half_angle.sin();
    assert!((radius - 16.1131).abs() < 1e-4);
    assert!((half_angle.to_degrees() - 34.601).abs() < 1e-3);
    close(intrados.length(), 2.0 * radius * half_angle);
    let springing = intrados.at(0.0);
    close(springing.normal[0], -half_angle.sin());
    // Centre-line spacing of 62 voussoirs of 0.711 m: 0.3208 m in Table 1 of Rouxinol, Providência and Lemos.
    assert!((2.0 * half_angle * (radius + 0.3555) / 62.0 - 0.3208).abs() < 1e-4);
}

#[test]
fn parabola_length() {
    let intrados = Intrados::between(&Profile::Parabolic, 18.30, 2.85, 0.0).unwrap();
    let root = (1.0 + 16.0 * (2.85f64 / 18.30).powi(2)).sqrt();
    let closed = 0.5 * 18.30 * root + 18.30 * 18.30 / (8.0 * 2.85) * (4.0 * 2.85f64 / 18.30 + root).ln();
    close(intrados.length(), closed);
}

#[test]
fn ellipse_length() {
    // A circle, whose perimeter is known, and series of Gauss and Kummer for ellipses round and flat.
    close(Intrados::between(&Profile::Elliptical, 10.0, 5.0, 0.0).unwrap().length(), 5.0 * std::f64::consts::PI);
    for (span, rise) in [(12.0, 3.0), (6.0, 5.0), (10.0, 1.0)] {
        let (a, b) = (0.5 * span, rise);
        let h = ((a - b) / (a + b)) * ((a - b) / (a + b));
        let (mut sum, mut coefficient, mut power) = (1.0, 1.0, 1.0);
        for n in 1..4000 {
            let n = f64::from(n);
            coefficient *= (1.5 - n) / n;
            power *= h;
            sum += coefficient * coefficient * power;
        }
        close(
            Intrados::between(&Profile::Elliptical, span, rise, 0.0).unwrap().length(),
            0.5 * std::f64::consts::PI * (a + b) * sum,
        );
    }
}

#[test]
fn three_centred_arcs_meet_without_a_kink() {
    let (span, rise, haunch_radius) = (12.0, 3.5, 1.5);
    let intrados = Intrados::between(&Profile::ThreeCentred { haunch_radius }, span, rise, 0.0).unwrap();
    let crown_radius = (4.5f64 * 4.5 + 3.5 * 3.5 - 1.5 * 1.5) / (2.0 * 2.0);
    let junction = 4.5f64.atan2(crown_radius - 3.5);
    let haunch = haunch_radius * (0.5 * std::f64::consts::PI - junction);
    close(intrados.length(), 2.0 * (haunch + crown_radius * junction));
    // At the junction both circles have the same normal.
    let station = intrados.at(haunch / intrados.length());
    close(station.normal[0], -junction.sin());
    close(station.point[0], haunch_radius - haunch_radius * junction.sin());
    assert!(intrados.at(0.0).normal[1].abs() < EXACT);
}

#[test]
fn pointed_crown_has_a_point() {
    let intrados = Intrados::between(&Profile::Pointed, 6.0, 4.5, 0.0).unwrap();
    let crown = intrados.at(0.5);
    assert_eq!(crown.normal, [0.0, 1.0]);
    close(crown.point[0], 3.0);
    close(crown.point[1], 4.5);
    // (3² + 4.5²) / 6 = 4.875: the normal beside the crown points away from a centre 1.875 m beyond it.
    let beside = intrados.at(0.5 - 1e-14);
    assert!((beside.normal[0] + 1.875 / 4.875).abs() < 1e-9);
}

#[test]
fn semicircle_is_the_highest_segment_and_the_roundest_ellipse() {
    let circle = Intrados::between(&Profile::Semicircular, 10.0, 5.0, 0.0).unwrap();
    for other in [Profile::Segmental, Profile::Elliptical] {
        let other = Intrados::between(&other, 10.0, 5.0, 0.0).unwrap();
        for step in 0..=40 {
            let share = f64::from(step) / 40.0;
            for i in 0..2 {
                assert!((circle.at(share).point[i] - other.at(share).point[i]).abs() < 1e-11);
                assert!((circle.at(share).normal[i] - other.at(share).normal[i]).abs() < 1e-11);
            }
        }
    }
}

#[test]
fn surveyed_circle_comes_out_as_a_circle() {
    let (profile, span, rise) = profiles().pop().unwrap();
    let intrados = Intrados::between(&profile, span, rise, 0.0).unwrap();
    let centre = [0.5 * span, rise - 16.0];
    for step in 0..=300 {
        let station = intrados.at(f64::from(step) / 300.0);
        let radius = (station.point[0] - centre[0]).hypot(station.point[1] - centre[1]);
        // A cubic deviates from an arc of 0.06 rad by some 1e-12 of its radius (sixth order in the angle).
        assert!((radius - 16.0).abs() < 1e-9, "{}", radius - 16.0);
    }
    assert!((intrados.length() - 16.0 * 1.2).abs() < 1e-9);
}

#[test]
fn stations_divide_every_curve_evenly() {
    for (profile, span, rise) in profiles() {
        let intrados = Intrados::between(&profile, span, rise, 0.0).unwrap();
        let (left, right, crown) = (intrados.at(0.0).point, intrados.at(1.0).point, intrados.at(0.5).point);
        close(left[0], 0.0);
        close(left[1], 0.0);
        close(right[0], span);
        close(right[1] + 1.0, 1.0);
        close(crown[0], 0.5 * span);
        close(crown[1], rise);
        // Chords of 20,000 stations fall short of the curve by the square of their number.
        const CHORDS: u32 = 20_000;
        let mut length = 0.0;
        let mut longest = 0.0f64;
        let mut last = intrados.at(0.0);
        for index in 1..=CHORDS {
            let next = intrados.at(f64::from(index) / f64::from(CHORDS));
            let chord = [next.point[0] - last.point[0], next.point[1] - last.point[1]];
            let size = chord[0].hypot(chord[1]);
            length += size;
            longest = longest.max(size);
            close(next.normal[0].hypot(next.normal[1]), 1.0);
            assert!(chord[0] * last.tangent()[0] + chord[1] * last.tangent()[1] > 0.0);
            last = next;
        }
        assert!((length - intrados.length()).abs() < 1e-7 * intrados.length(), "{profile:?}: {length}");
        assert!(longest <= intrados.length() / f64::from(CHORDS) * (1.0 + 1e-9), "{profile:?}");
    }
}

#[test]
fn symmetric_to_the_last_bit() {
    for (profile, span, rise) in profiles() {
        if matches!(profile, Profile::Measured { .. }) {
            continue;
        }
        let intrados = Intrados::between(&profile, span, rise, 0.0).unwrap();
        for step in 0..=32 {
            let (left, right) = (intrados.at(f64::from(step) / 64.0), intrados.at(1.0 - f64::from(step) / 64.0));
            assert_eq!(left.point[1], right.point[1]);
            assert_eq!(left.normal[0], -right.normal[0]);
            assert_eq!(span - left.point[0], if step == 32 { left.point[0] } else { right.point[0] });
        }
    }
}

#[test]
fn impossible_shapes_are_named() {
    let measured = |points: &[[f64; 2]]| Profile::Measured { points: points.to_vec() };
    let cases = [
        (Profile::Segmental, 10.0, 5.1, "the rise of a segment is more than half its span"),
        (Profile::Semicircular, 10.0, 4.0, "the rise of a semicircle is not half its span"),
        (Profile::ThreeCentred { haunch_radius: 3.0 }, 10.0, 3.0, "the haunch circles leave no room"),
        (Profile::ThreeCentred { haunch_radius: 1.0 }, 10.0, 6.0, "the rise of a three-centred arch is more than"),
        (Profile::Pointed, 10.0, 5.0, "a pointed arch rises by more than half its span"),
        (Profile::Parabolic, 10.0, 0.0, "span and rise must be positive"),
        (Profile::Elliptical, f64::NAN, 1.0, "span and rise must be positive"),
        (measured(&[[0.0, 0.0], [1.0, 0.0]]), 1.0, 1.0, "a measured profile needs at least three points"),
        (measured(&[[0.0, 0.0], [2.0, 1.0], [1.0, 0.0]]), 1.0, 1.0, "measured point 3 does not lie to the right"),
        (measured(&[[0.0, 0.0], [2.0, -1.0], [4.0, 0.0]]), 4.0, 1.0, "measured point 2 is not above the springings"),
    ];
    for (profile, span, rise, message) in cases {
        let misfit = Intrados::between(&profile, span, rise, 0.0).unwrap_err();
        assert!(misfit.message.starts_with(message), "{profile:?}: {misfit}");
    }
    let sloping = [
        (Profile::Segmental, 10.0, 1.0, 4.0, "the intrados falls from its right springing"),
        (Profile::Segmental, 10.0, 4.9, -3.0, "the circle through both springings"),
        (Profile::Parabolic, 10.0, 1.0, -4.5, "the intrados falls from its left springing"),
        (Profile::Elliptical, 10.0, 1.0, 10.5, "the springings differ by more than the span"),
        (Profile::Pointed, 6.0, 4.5, 0.2, "a pointed arch between springings at unequal levels"),
        (Profile::ThreeCentred { haunch_radius: 3.8 }, 12.0, 3.5, 0.3, "no crown circle touches both haunch circles"),
        (
            measured(&[[0.0, 0.0], [2.0, 1.0], [4.0, 2.5]]),
            4.0,
            1.0,
            2.5,
            "measured point 2 is not above the springings",
        ),
        (measured(&[[0.0, 0.0], [2.0, 1.6], [4.0, 2.5]]), 4.0, 1.0, 2.5, "the intrados falls from its right springing"),
    ];
    for (profile, span, rise, right, message) in sloping {
        let misfit = Intrados::between(&profile, span, rise, right).unwrap_err();
        assert!(misfit.message.starts_with(message), "{profile:?}: {misfit}");
    }
}

/// Profiles that can spring from unequal levels, with a span and a rise.
fn sloping() -> Vec<(Profile, f64, f64)> {
    vec![
        (Profile::Segmental, 18.30, 2.85),
        (Profile::Parabolic, 18.30, 2.85),
        (Profile::Elliptical, 12.0, 3.0),
        (Profile::Elliptical, 6.0, 5.0),
        (Profile::ThreeCentred { haunch_radius: 1.5 }, 12.0, 3.5),
        (Profile::Semicircular, 10.0, f64::NAN),
    ]
}

fn between(profile: &Profile, span: f64, rise: f64, right: f64) -> Intrados {
    let size = super::sized(profile, span, if rise.is_nan() { 0.5 * span } else { rise }, right);
    Intrados::between(profile, size.span, size.rise, size.right).unwrap()
}

#[test]
fn unequal_springings_are_those_of_the_file_and_the_rise_that_of_the_middle() {
    for (profile, span, rise) in sloping() {
        for right in [0.9, 0.2, -0.2, -0.9] {
            let rise = if rise.is_nan() { super::semicircular::sloping_rise(span, right) } else { rise };
            let intrados = between(&profile, span, rise, right);
            assert_eq!(intrados.at(0.0).point, [0.0, 0.0], "{profile:?}");
            let end = intrados.at(1.0).point;
            assert!((end[0] - span).abs() < 1e-12 && (end[1] - right).abs() < 1e-12, "{profile:?}: {end:?}");
            assert!((intrados.level(0.5 * span) - 0.5 * right - rise).abs() < 1e-9, "{profile:?} {right}");
            // The highest point is where the normal stands upright.
            let top = intrados.highest();
            let sampled = (0..=4000).map(|k| intrados.at(f64::from(k) / 4000.0).point[1]).fold(f64::MIN, f64::max);
            assert!(top >= sampled - 1e-9 && top - sampled < 1e-5, "{profile:?} {right}: {top} {sampled}");
            // Stations divide the length evenly, and normals are square to it.
            let chords: f64 = (0..2_000)
                .map(|k| {
                    let [a, b] = [k, k + 1].map(|k| intrados.at(f64::from(k) / 2_000.0));
                    let step = [b.point[0] - a.point[0], b.point[1] - a.point[1]];
                    let tilt = (step[0] * a.normal[0] + step[1] * a.normal[1]) / step[0].hypot(step[1]);
                    // An arc of this length bends by half of it over the radius: at the springing of the flat ellipse 0.75 m.
                    assert!(tilt.abs() < 1e-2, "{profile:?} {right} {k}: {tilt}");
                    step[0].hypot(step[1])
                })
                .sum();
            assert!((chords / intrados.length() - 1.0).abs() < 1e-5, "{profile:?} {right}");
        }
    }
}

#[test]
fn the_curve_follows_the_difference_of_the_springings_through_zero_and_is_mirrored_with_it() {
    for (profile, span, rise) in sloping() {
        let level = between(&profile, span, rise, 0.0);
        for right in [1e-6, -1e-6] {
            let near = between(&profile, span, rise, right);
            for k in 0..=64 {
                let share = f64::from(k) / 64.0;
                let (a, b) = (level.at(share), near.at(share));
                let apart = (a.point[0] - b.point[0]).hypot(a.point[1] - b.point[1]);
                assert!(apart < 1e-5, "{profile:?} {right} {k}: {apart}");
            }
        }
        let [one, other] = [0.7, -0.7].map(|right| between(&profile, span, rise, right));
        for k in 0..=64 {
            let share = f64::from(k) / 64.0;
            let (a, b) = (one.at(share), other.at(1.0 - share));
            close(a.point[0], span - b.point[0]);
            assert!((a.point[1] - b.point[1] - 0.7).abs() < 1e-11, "{profile:?} {k}");
            assert!((a.normal[0] + b.normal[0]).abs() < 1e-10, "{profile:?} {k}");
        }
    }
}

/// Every point of a segment lies on the circle through its springings and its middle, and a cut semicircle on that of its span.
#[test]
fn circles_between_unequal_springings() {
    for right in [1.3, -0.4] {
        let segment = between(&Profile::Segmental, 9.0, 2.0, right);
        // The circle through (0, 0), (span, right) and (span / 2, right / 2 + rise), by its equation x² + y² = a x + b y.
        let (mx, my) = (4.5, 0.5 * right + 2.0);
        let determinant = 9.0 * my - right * mx;
        let a = ((81.0 + right * right) * my - (mx * mx + my * my) * right) / determinant;
        let b = (9.0 * (mx * mx + my * my) - mx * (81.0 + right * right)) / determinant;
        for k in 0..=50 {
            let [x, y] = segment.at(f64::from(k) / 50.0).point;
            assert!((x * x + y * y - a * x - b * y).abs() < 1e-10, "{right} {k}");
        }
        assert!((segment.circle().unwrap() - 0.5 * a.hypot(b)).abs() < 1e-10);
        let cut = between(&Profile::Semicircular, 9.0, f64::NAN, right);
        let radius = (81.0 + right * right) / 18.0;
        let centre = if right > 0.0 { [radius, 0.0] } else { [9.0 - radius, right] };
        for k in 0..=50 {
            let [x, y] = cut.at(f64::from(k) / 50.0).point;
            assert!(((x - centre[0]).hypot(y - centre[1]) - radius).abs() < 1e-10, "{right} {k}");
        }
        let upright = cut.at(if right > 0.0 { 0.0 } else { 1.0 });
        assert!(upright.normal[1].abs() < 1e-12 && upright.point[1] == right.min(0.0));
    }
}
