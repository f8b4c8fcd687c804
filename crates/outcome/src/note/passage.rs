//! Trains that pass over finite elements.

use crate::sentences::notes;

notes! {
    /// What a passage assumes.
    InPassage {
        /// An axle: the width that carries it, its heaviest load, the width to which sleepers and ballast alone spread it.
        Width { width [m]: f64, of_file: bool, heaviest [N/m]: f64, spread [m]: f64 } =>
            "an axle is carried by {width:.3} m of the bridge's width, {}; the heaviest brings {:.2} kN/m; sleepers and ballast alone spread it \
             over {spread:.2} m",
            if *of_file { "as the file says" } else { "the width of the barrel" }, heaviest / 1e3;
        Sleeper { pressed [m]: f64 } => "a sleeper presses evenly on {pressed:.3} m of the top of the fill";
        Rails => "half of an axle bears on each rail, a beam on equal springs under its sleepers that carry tension as well; a sleeper lies in \
                  the middle of the bridge";
        /// An axle on a road: the width that carries it, its heaviest load.
        WheelWidth { width [m]: f64, of_file: bool, heaviest [N/m]: f64 } =>
            "an axle is carried by {width:.3} m of the bridge's width, {}; the heaviest brings {:.2} kN/m",
            if *of_file { "as the file says" } else { "1.8 m between its wheels spread 1:2 to either side through the cover over the crown" },
            heaviest / 1e3;
        /// Wheels on the surface of a road.
        Wheels { pressed [m]: f64 } =>
            "a wheel presses evenly on {pressed:.3} m of the road; what is modelled below it spreads that along the bridge";
        TrackWeight { pressure [Pa]: f64 } =>
            "{:.2} kPa of ballast, sleepers and rails press on the fill, a part of the self-weight", pressure / 1e3;
        Sensors => "the file names no sensors: those of the railway paper's Table 1, on the first span";
        AllFreedoms => "all degrees of freedom were solved at every position in place of the condensed path: a transient analysis, large \
                        displacements and sensors of stress need them";
        PlaneStrain => "Plane strain: a metre of the barrel's width, the same across it. Stone, piers, abutments and backing are linear \
                        elastic, of elements with incompatible modes; soil that yields is of plain four-node elements.";
        Mortar { shear: JointShear } => "Joints are springs of the mortar's modulus over its thickness, without tension beyond their lift-off, \
                                         {shear}; stones reach to the middle of the joints.";
        FillContact { stiffness [Pa/m]: f64, friction: f64, parts: bool } =>
            "Fill touches masonry through {:.1} GPa/m, friction {friction:.2}, and {}.", stiffness / 1e9,
            if *parts { "parts from it without tension" } else { "slides along it but never parts from it" };
        Base => "The base of piers, abutments and the fill behind them is fixed; the side boundaries hold the fill horizontally.";
        SelfWeight => "Self-weight is carried by the finished bridge, without the centring's stages, and taken off the records.";
        Piers => "Piers weigh by their mean width across the bridge and have the stiffness of the barrel's width; steps of their footings are \
                  part of the fixed base.";
        Abutments => "Abutments of blocks are elastic here and held by the fixed base: they neither slide nor tilt.";
    }
}

notes! {
    /// What carries shear in joints of mortar.
    #[derive(Copy)]
    JointShear {
        /// Panels of this strength [Pa], whatever presses on them.
        Panels(strength: f64) =>
            "beside panels that shear like stone up to {:.3} MPa whatever presses on them, where springs have lifted off too", strength / 1e6;
        /// Friction [rad] and cohesion [Pa] of joints, and of those between rings.
        Friction(joints: [(f64, f64); 2]) =>
            "and shear like stone up to friction and cohesion of [joint], {}: nothing where they have opened, friction alone once they have",
            match joints.map(|(angle, cohesion)| format!("tan {:.1}° and {:.1} kPa", angle.to_degrees(), cohesion / 1e3)) {
                [joint, rings] if rings == joint => joint,
                [joint, rings] => format!("{joint} ({rings} between rings)"),
            };
    }
}
