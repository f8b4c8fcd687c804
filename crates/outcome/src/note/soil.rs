//! Fill and backing that yield as a continuum.

use crate::sentences::{kilo, notes};
use bridge::{Confinement, FillEnds};

notes! {
    /// What is assumed of soil.
    Soil {
        Bounds => "Rigid blocks as built beside soil that yields: nothing deforms before collapse. Friction of joints is associated: where \
                   joints slide in the mechanism the bounds are those of joints that dilate.";
        /// Strength: the share that is mobilised, the angle of dilatancy where it dilates, and that of its joint with masonry where it is given.
        Strength { mobilised: f64, dilatancy_angle [rad]: Option<f64>, interface_angle [rad]: Option<f64> } =>
            "Soil yields by Mohr and Coulomb in plane strain with {:.0} % of the cohesion and of the tangent of the friction angle that the \
             file gives, reduced after Davis {}; between soil and masonry it slides at {}, reduced alike, and carries no tension.",
            100.0 * mobilised,
            match dilatancy_angle {
                Some(angle) => format!("for a dilatancy angle of {:.1} degrees", angle.to_degrees()),
                None => "for soil that does not dilate".to_owned(),
            },
            match interface_angle {
                Some(angle) => format!("{:.1} degrees", angle.to_degrees()),
                None => "two thirds of its friction angle".to_owned(),
            };
        Associated { bounds [N/m]: [f64; 2] } =>
            "Soil that dilates by its friction angle, at the same share of its strength, would carry {} to {} kN/m.", kilo(bounds[0]), kilo(bounds[1]);
        Iterated { load [N/m]: f64, dilatancy_angle [rad]: f64 } =>
            "An iteration in which soil keeps its whole strength and dilates by {:.1} degrees settles at {} kN/m on a coarser mesh: an estimate \
             and no bound, which does not lead.",
            dilatancy_angle.to_degrees(), kilo(*load);
        Plates => "Wheels and beams stand on the upper face of the soil on rigid plates that sink, slide and turn freely; pressures stay \
                   uniform; nothing disperses by a rule. Layers above the soil weigh and do nothing else.";
        /// How far the fill reaches, where the file says so, and what holds its ends.
        Ends { extent [m]: Option<f64>, ends: FillEnds } => "The fill reaches {} behind the outer springings on rigid ground; its ends {}.",
            extent.map_or("twice its height or over the abutments".to_owned(), |extent| format!("{extent:.2} m")),
            match ends {
                FillEnds::Slide => "slide along smooth walls",
                FillEnds::Hold => "are held by rough walls",
                FillEnds::Free => "are free",
            };
        /// What holds the fill across the bridge.
        Confined { by: Confinement } => "{}", match by {
            Confinement::PlaneStrain => {
                "Spandrel walls hold the fill sideways: what they bear is not checked, and a wall that leans or slides lowers the load."
            }
            Confinement::SpandrelWalls => {
                "Spandrel walls hold the fill sideways by their weight alone, in panels of about a metre: no more than they bear before they \
                 tilt about their outer toe or slide on their bed. Friction of the fill on rings is not counted across the bridge."
            }
        };
        AsWeight => "The file has fill or backing as a continuum: this method takes it as weight, with dispersal by rule. Limit analysis takes \
                     it for what it is.";
        AsWeightOfMovements => "Support movements know fill as weight alone: the continuum of the file is taken as that here, with dispersal \
                                by rule.";
        AsWeightOfPlaces => "Layers that are a continuum in the file are weight alone here.";
        InSweep => "Fill yields as a continuum: each factor is a lower bound, with an upper one beside it, of the whole vehicle or of the \
                    neighbouring axles that govern where fill is weight alone, whichever is smaller. Places that cannot govern are answered \
                    coarsely. The worst place is one of those asked for: none is sought between them.";
        InSweepOfVehicles => "Fill yields as a continuum: at up to 49 positions of each drive the whole vehicle, and what governs there with \
             fill as weight and dispersal, stand on it over the width to which axles disperse; then every combination of weights at the worst \
             of these positions, and the positions left out beside it. Factors are lower bounds, and the smaller of both models counts; \
             elsewhere fill is weight. One wheel by itself is not asked.";
    }
}
