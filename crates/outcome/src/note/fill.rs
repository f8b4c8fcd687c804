//! Fill, backing, water, road and dispersal.

use crate::sentences::{listed, notes};
use bridge::DispersalRule;

notes! {
    /// What is assumed of fill and backing that weigh, press and disperse.
    Fill {
        /// Pressure of fill at once: shares of its vertical stress, at least and at most, what its cohesion adds, and what is mobilised.
        Presses { least: f64, most: f64, cohesion [Pa]: f64, mobilised: f64, friction_angle [rad]: f64, cohesion_mobilised: f64 } =>
            "Fill presses sideways on the backs with {least:.2} of its vertical stress, and with up to {most:.2} of it plus {:.1} kPa where a \
             back moves against it: {:.0} % of Rankine's passive pressure for {:.1} degrees and {:.0} % of that for cohesion. It acts at once; \
             real fill needs movement.",
            cohesion / 1e3, 100.0 * mobilised, friction_angle.to_degrees(), 100.0 * cohesion_mobilised;
        /// The same with movement: half of what movement adds is there at a share of the depth; what is mobilised at the largest load.
        PressesWithMovement { least: f64, most: f64, cohesion [Pa]: f64, half_movement: f64, mobilised: f64 } =>
            "Fill presses sideways on the backs with {least:.2} of its vertical stress, and the more the further a back moves against it: half \
             of the way to {most:.2} of it plus {:.1} kPa at a movement of {:.1} % of the depth below the top of the fill. At the largest load \
             {:.0} % of what movement could add is there. Movement counts from the blocks as built.",
            cohesion / 1e3, 100.0 * half_movement, 100.0 * mobilised;
        PressesBetweenSpans => "Between two spans each level of fill pushes both rings with the same force; where only one of them has a back \
                                at a level, only pressure at rest acts.";
        BackingPresses => "Backing presses and resists no more than fill in its place: its own strength is left out. as = \"blocks\" in \
                           [backing] includes it.";
        PressesInSweep => "Fill presses against movement as [fill_pressure] says.";
        DoesNotPress => "[fill_pressure] applies to limit analysis only: here the fill has weight and does not press sideways.";
        /// Backing of blocks, and how far it reaches over the abutments.
        BackingBlocks { pieces: usize, over_abutments [m]: [f64; 2], pressed: bool } =>
            "Backing is {pieces} blocks of sound masonry with joints as between voussoirs: stones with level beds on backs steeper than 45 \
             degrees, a column on every flatter one. It reaches over the tops of the abutments ({:.2} m and {:.2} m), where friction alone \
             holds it; {}. A trial pit or a core must confirm that it is sound and reaches so far.",
            over_abutments[0], over_abutments[1],
            match pressed {
                true => "fill behind it presses and resists as on the backs",
                false => "there is no fill pressure behind it",
            };
        Particles => "Fill is rigid discs in deformable point contact; their density is that of the layer divided by the share of the region \
                      that they cover. Discs roll, so the friction angle of the fill is smaller than that of its contacts.";
        /// Its packing; without a seed it is one from a file.
        Packing { seed: Option<u64>, solid_fraction: f64, coordination: f64, mean_stress [Pa]: f64 } =>
            "The packing is one of many ({}): solid fraction {solid_fraction:.3}, {coordination:.2} contacts a particle, mean stress {:.1} kPa \
             at rest.",
            seed.map_or("read from a file".to_owned(), |seed| format!("seed {seed}")), mean_stress / 1e3;
        ParticlesAsWeight => "Layers that are particles in the file, and slabs on them, are weight here, and loads spread through them by rule: \
                              discrete elements take them for what they are.";
        BearingNotChecked => "Dispersal is a rule: bearing failure of the fill under a wheel or a loading beam is not checked.";
        /// Water above the left springing, and the density of what is saturated.
        Water { level [m]: f64, saturated_density [kg/m^3]: f64 } =>
            "Water stands in the pores of the lowest layer up to {level:.2} m above the left springing: below it the layer weighs \
             {saturated_density:.0} kg/m^3, and the water presses on the backs whatever moves. The intrados is dry, backing holds no water, and \
             what water does to strength, to walls and to foundations is left out.";
        /// A road with levels, and the least cover over a crown.
        Road { cover [m]: f64 } =>
            "The surface follows the levels of [road]; layers above the fill keep their thickness. Loads stay vertical, and rules that ask for \
             one depth of cover take the least over a crown, {cover:.3} m.";
        Weightless { layers: Vec<String> } => "The weight of these layers is left out, as the file says: {}.", listed(layers);
        /// Dispersal, with vertical lengths to one horizontal.
        Dispersal { rule: DispersalRule, slope: f64 } => "{}", match rule {
            DispersalRule::None => "Loads act straight down on the extrados.".to_owned(),
            DispersalRule::Uniform => format!(
                "Loads spread {slope} vertical to 1 horizontal, on steep haunches no further than the depth of cover under them allows, uniform \
                 at the extrados."
            ),
            DispersalRule::InverseDepth => format!(
                "Loads spread {slope} vertical to 1 horizontal; pressures at the two ends are inversely proportional to their depth (Rouxinol, \
                 Providência and Lemos, eq. 2)."
            ),
            DispersalRule::Boussinesq => format!(
                "Loads spread as under a strip on an elastic half space, cut off at {slope} vertical to 1 horizontal and scaled to the whole force."
            ),
        };
    }
}
