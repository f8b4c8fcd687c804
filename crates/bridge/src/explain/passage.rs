//! Cards of trains, tracks, passages and sensors.

use super::file_card::FileCard;

/// The cards, in the order of their codes.
pub(super) const CARDS: &[FileCard] = &[
    FileCard {
        code: "B651",
        title: "no such train",
        meaning: "A train without vehicles and without a file must have the name of a train of the library.",
        why: "Axle loads and spacings determine every peak; they are never assumed.",
        wrong: r#"name = "paper-long""#,
        right: r#"name = "paper-short""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B652",
        title: "axles that do not add up",
        meaning: "A vehicle has one load for each axle, or one for all, and one spacing between every two adjacent \
                  axles; a train has 20,000 axles at most.",
        why: "An extra or a missing axle shifts every load behind it.",
        wrong: r#"axle_loads = ["20 t", "21 t", "22 t"]"#,
        right: r#"axle_loads = ["20 t", "21 t"]"#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B653",
        title: "sleepers that overlap",
        meaning: "A sleeper is narrower along the bridge than the distance to the next.",
        why: "The two lengths are probably swapped.",
        wrong: r#"sleeper_breadth = "0.95 m""#,
        right: r#"sleeper_breadth = "0.25 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B654",
        title: "damping without two frequencies in order",
        meaning: "Rayleigh damping has the given ratio at two frequencies; give the lower one first.",
        why: "Damping is proportional to mass and to stiffness; two frequencies determine the two coefficients.",
        wrong: r#"damping_frequencies = ["40 Hz", "8 Hz"]"#,
        right: r#"damping_frequencies = ["8 Hz", "40 Hz"]"#,
        source: "R. W. Clough and J. Penzien, Dynamics of Structures: Rayleigh damping",
    },
    FileCard {
        code: "B655",
        title: "a passage that ends before it starts, or has too many positions",
        meaning: "The first axle starts to the left of its end position, and there are at most 720,000 positions \
                  between the two.",
        why: "Trains travel to the right; more positions are probably an error of unit.",
        wrong: r#"to = "-60 m""#,
        right: r#"to = "60 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B656",
        title: "a sensor position that the bridge does not have",
        meaning: "A sensor is on an existing span, at a springing that this span has, and a strain gauge fits on one \
                  voussoir.",
        why: "A gauge across a joint would measure the relative movement of two voussoirs, and a sensor on another \
              span would give another record.",
        wrong: r#"gauge_length = "900 mm""#,
        right: r#"gauge_length = "100 mm""#,
        source: "the railway paper, section 3.2",
    },
    FileCard {
        code: "B657",
        title: "channels that cannot be told apart",
        meaning: "Every sensor has a unique name that can be a column heading of a table, and there are 1000 sensors \
                  at most.",
        why: "Records are compared by the names of their channels.",
        wrong: r#"name = "crown, strain""#,
        right: r#"name = "crown strain""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B660",
        title: "an edge distance beyond the middle of the barrel",
        meaning: "edge_distance of [carriageway] is at most half the width of the barrel.",
        why: "It is measured from the nearer edge of the barrel to the nearest wheel or rail.",
        wrong: r#"edge_distance = "80 m""#,
        right: r#"edge_distance = "0.8 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B661",
        title: "more vehicles abreast than fit",
        meaning: "The vehicles of [carriageway] must fit on the barrel: (lanes - 1) times lane_width is not more than \
                  its width.",
        why: "Each vehicle needs its part of the barrel to carry it.",
        wrong: r#"lanes = 20"#,
        right: r#"lanes = 2"#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "P051",
        title: "an unusual axle load",
        meaning: "Railway axles carry 1 to 45 t.",
        why: "Tonnes, kilograms and kilonewtons are easily confused, and every peak is nearly proportional to the \
              load.",
        wrong: r#"axle_loads = ["200 kg", "21 t"]"#,
        right: r#"axle_loads = ["20 t", "21 t"]"#,
        source: "EN 15528 (axle loads of line categories, up to 25 t); heavy haul lines up to 40 t",
    },
    FileCard {
        code: "P052",
        title: "an unusual track",
        meaning: "Track moduli are 5 to 200 MPa for one rail, bending stiffnesses of rails 0.5 to 10 MNm^2, and \
                  sleepers are 0.4 to 1 m apart.",
        why: "They determine over how many sleepers an axle load spreads.",
        wrong: r#"track_modulus = "300 MPa""#,
        right: r#"track_modulus = "30 MPa""#,
        source: "A. D. Kerr, Fundamentals of Railway Track Engineering, 2003; C. Esveld, Modern Railway Track, 2001",
    },
    FileCard {
        code: "P053",
        title: "an unusual speed",
        meaning: "Trains cross masonry bridges at 1 to 250 km/h.",
        why: "m/s and km/h are easily confused; the speed sets the distance between positions.",
        wrong: r#"speed = "150 m/s""#,
        right: r#"speed = "45 km/h""#,
        source: "common range",
    },
    FileCard {
        code: "P054",
        title: "an effective width smaller than the sleepers",
        meaning: "The effective width of an axle is less than the length of its sleepers.",
        why: "An axle load first spreads over its sleepers; every peak is inversely proportional to the width.",
        wrong: r#"effective_width = "1.0 m""#,
        right: r#"effective_width = "3.9 m""#,
        source: "NR/GN/CIV/025 and CS 454: load spreads from the sleeper's ends outwards",
    },
    FileCard {
        code: "P060",
        title: "a skew bridge",
        meaning: "The bridge is skew by more than 10 degrees; every model here is plane and square.",
        why: "Skew barrels carry along the shorter path between obtuse corners, twist, and separate along the \
              spandrels: the result of a plane model is not a bound for them. Spans measured along the road are longer \
              than those square to the springings and carry less, so they are conservative. A verdict needs another \
              model or a test, named as skew_source in [assess].",
        wrong: r#"skew = "40 deg""#,
        right: r#"skew = "5 deg""#,
        source: "CIRIA C656, Masonry arch bridges, 2006 [recalled]; common limit of plane analysis",
    },
];
