//! Supports, spans, cracks and walls.

use crate::sentences::{kilo, listed, notes};

notes! {
    /// Of the bridge as a plane model has it.
    Barrel {
        Plane => "The problem is plane: one metre of width, loads uniform across it.";
        FromLibrary { values: Vec<String> } =>
            "Not measured, the usual values of the library: {}.", values.join(", ");
        OutOfPlane => "A plane model does not include spandrel walls that lean or slide outwards, cracks along the barrel, or edges that \
                       separate from it.";
        /// Supports carry whatever reaches them.
        SupportsHold => "Abutments and the ground below foundations are rigid and resist any force: spreading, settlement, bearing and scour \
                         are not checked, and each of them lowers the load.";
        GroundHolds => "The ground below foundations and abutments is rigid and resists any force, and an abutment that is fixed neither \
                        slides nor tilts: settlement, bearing and scour are not checked, and each of them lowers the load.";
        ForcesAlong => "Forces along the bridge act at the surface and are shared out as the vertical load disperses; all of them reach the \
                        rings or the ground right below, none the ground before and behind.";
        Springings { level: bool } => "{}; piers stand on fixed foundations that carry no tension.",
            if *level { "All springings are at one level" } else { "Springings lie at the levels of the file" };
        SpringingsOfOneSpan => "The springings lie at the levels of the file.";
        PiersAcross => "Piers weigh by their width across the bridge over that of the barrel, cutwaters by their area. Where they are wider, \
                        their joints have the strength of the barrel's width; where they are narrower, of their own.";
        /// The load of the same rings as one.
        RingsApart { bonded [N/m]: f64 } => "Rings lie on one another with friction alone between them, as if their mortar were lost. Bonded into one \
             they would carry {} kN/m by limit analysis: sounding and cores tell which is nearer.", kilo(*bonded);
        Cracks { strips [m]: Vec<f64> } => "Longitudinal cracks through the barrel leave strips of {}: each carries by itself what stands on \
             it, and no load passes a crack. The load per metre of width is that of every strip; vehicles of a sweep stand where they load \
             one most, and an effective width of the file holds for loads that stand on one strip alone.",
            listed(strips.iter().map(|width| format!("{width:.2} m")));
        SupportMoved { by [m]: f64 } => "A support has moved by {:.1} mm before the loads came: blocks followed it as the mechanism that their \
             weight allows, joints that opened are brought together again halfway, and the loads act on that shape. Loads may have to turn \
             joints back that opened before the bridge carries this much: the nearer a movement is to the one that brings the bridge down, \
             the less this load says. A joint that is to stay open is a defect, \"open-joint\". The cover weighs what it weighed as built.",
            1e3 * by;
        /// The strip below the spandrel walls: bricks, ends [m], height above the crown.
        WallStrip { pieces: usize, brick [m]: [f64; 2], ends [m]: [f64; 2], height [m]: f64, end_walls: bool } =>
            "The strip is a metre of the spandrel walls' own thickness: {pieces} pieces of bricks of {:.3} x {:.3} m stand on the ring from \
             x = {:.3} to {:.3} m, up to {height:.3} m above the crown; {}; cover does not act here.",
            brick[0], brick[1], ends[0], ends[1],
            if *end_walls { "fixed walls stand at both ends" } else { "its ends are free" };
        /// Loads on the strip below the walls, through a block.
        WallLoadedByBlock => "Loads act through a block that cannot rotate, whose weight is part of the load; walls do not lean out of their plane.";
        /// Loads on bricks: how many, or as many as lie under them.
        WallLoadedOnBricks { bricks: Option<usize> } => "Loads act {}; walls do not lean out of their plane.",
            match bricks {
                None => "as forces on the bricks of the uppermost course under them, by their loaded length".to_owned(),
                Some(count) => format!("as forces on the {count} nearest bricks of the uppermost course, with the same resultant"),
            };
        StripsSideBySide => "The strips act side by side without a force between them, and both reach their loads at the same time, whatever \
                             their displacements (a rough estimate: Rouxinol, Providência and Lemos, section 3.5).";
        StripsUniform => "Loads are the same in every metre of the width; what the barrel gains as a shell, and what walls lose by leaning \
                          outwards, is left out.";
        NoSum { strip: bridge::Strip } => "No load was found to be carried by the strip \"{strip}\": there is no sum.";
        BricksLoaded => "Blocks bring the loads onto the fill; on the walls the loads are forces on bricks.";
        AtRest => "Weights and reactions are those of one metre of the barrel between its spandrel walls, without factors and without loads; \
                   totals are these times the width of the barrel.";
        ElasticReactions => "Reactions at rest are those of elastic blocks on rigid supports whose joints open nowhere: one of many states in \
             which the bridge stands. A support that gives, or a centring that was struck late, changes thrust and eccentricity, the vertical \
             sum stays.";
    }
}
