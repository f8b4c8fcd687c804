//! Loads and vehicles that move.

use crate::sentences::{listed, notes};
use crate::vehicles::{Across, Weights};
use bridge::Method;
use findings::words::counted;
use rules::{Acting, Source};

notes! {
    /// What is assumed of loads and vehicles that move.
    Moving {
        RigidAlone => "Rings are rigid: deformable joints carry less, flat rings under long loads by more than half \
                       (docs/verification/deformable-joints.md); method = \"path\" in [analysis] follows them too.";
        /// Distance of positions, of loads.
        Positions { apart [m]: f64 } => "Positions lie {apart:.3} m apart; the worst one is then sought to a hundredth of that.";
        /// Distance of positions, of vehicles.
        PositionsOfVehicles { apart [m]: f64 } => "Positions lie {apart:.3} m apart; the worst one is then sought to a hundredth of that. \
                                                   Between positions the factor changes steadily.";
        /// Up to how many times the least factor friction without dilation is asked.
        WithoutDilation { times: f64 } =>
            "Cases up to {times} times the least factor are answered without dilation too, and the least counts. Others keep dilatant friction, \
             which gives more.";
        Proven { cases: usize } => "For {cases} cases no largest factor was found, but one above the least of the others is shown to be \
                                    carried, and stands in its place.";
        DeformableJoints => "On deformable joints the axles that govern for rigid blocks are followed at every position; of all axles, and of \
             those that governed at the position before, it is asked there whether they carry as much, from the states of similar loads; at the \
             worst position every run of axles is followed. The smaller factor of both methods counts. Fill acts by its weight alone there.";
        DeformableJointsOfVehicles => "On deformable joints what governs for rigid blocks is followed at every position, up to four times the \
             least factor of rigid blocks; of all that may stand there, and of what governs beside it, it is asked whether it carries as much, \
             from the states of similar loads. At the worst position axles, uniform loads, factors on weights and critical axle are varied one \
             after the other, and each is followed. The smaller adequacy factor of both methods counts. States in service are sought in what \
             governs for rigid blocks and in all that may stand there, at every position, and in what is varied at the worst one: other runs of \
             axles may come to them under less load. They are told where they are met below the least factor of rigid blocks. Fill acts by its \
             weight alone there.";
        InsteadOf { method: Method } => "Positions are answered by limit analysis, not by method \"{method}\" of the file: it answers one \
                                         position, without --sweep.";
        Shorter { load: String, of [m]: f64, length [m]: f64 } =>
            "A uniform load may be shorter: \"{load}\" of {of:.2} m does most harm where {length:.2} m of it act, and its factor is that of this \
             part. Write whole_length = true in [[load]] where it cannot be shorter.";
        Adequacy => "The adequacy factor multiplies all loads of the vehicle together; weights stay as they are.";
        OneWeight { weights: Weights } => "Dead load has one set of factors, also where it helps: {}.", weights.told();
        EveryWeight { combinations: usize, governing: Governing } =>
            "Weights that help have the rule's favourable factor: each of {combinations} combinations of adverse and favourable factors on \
             masonry, fill and surfacing was tried at every position, and the least adequacy factor counts ({governing}).";
        UniformLoads => "Uniform loads that may be left out stand on any run of half spans; those of a lane spread over its width, others over \
                         that of an axle.";
        /// Vehicles across the bridge, each with its place.
        Across { vehicles: Vec<(String, Across)> } =>
            "Across the bridge vehicles stand where they load a metre of its width most: {}.", across(vehicles);
        /// Concurrent values at critical joints: how many, and of how many the thrust lies outside.
        Sections { outside: usize, of: usize } =>
            "Concurrent values at critical joints are those of elastic blocks whose joints open nowhere, under the vehicle with its factors.{}",
            match outside {
                0 => String::new(),
                _ => format!(
                    " At {outside} of {of} of these the thrust would lie outside its joint (outside_section in sections.csv): no ring without \
                     tension carries it so, joints open and hinges form."
                ),
            };
        /// Cases that were not answered, whose bounds lie so many times above the least factor.
        FarAbove { times: f64 } =>
            "Where cases had to be left to the slower method, those were not answered whose upper bound, by the mechanisms met before, lies more \
             than {times} times above the least factor at the position, and as many times more as such bounds lay too high at the position \
             before.";
        Sliding { vehicles: usize } =>
            "For {} joints slide: cases were answered without dilation too, from the least factor with dilation up to where one could govern \
             only if dilation were worth a quarter more there than in any case before, and the least counts.",
            counted(*vehicles, "vehicle");
        Inset { by [m]: f64 } =>
            "Discrete elements bear on contact points {:.0} mm inside the edges of the blocks, where the thrusts of limit analysis at its \
             hinges would crush the masonry.",
            1e3 * by;
        /// The factors of a rule, and what it does with the loads of which models.
        Rule { code: String, factors: Vec<(String, f64)>, acting: Vec<(String, Acting)> } => "Rule \"{code}\": {}.",
            listed(factors.iter().map(|(name, factor)| format!("{name} {factor}")).chain(acting.iter().map(|(models, acting)| {
                format!("on loads of {models}: live load {}, impact {}", acting.live_load.value, acting.told())
            })));
        /// Traffic in the lanes beside a vehicle: the share of its loads by the rule, and what it counts as.
        LanesBeside { vehicle: String, beside: String, loads: f64, times: f64, source: Source } =>
            "In the lanes beside {vehicle} stands {beside} with {loads} of its factored loads, wherever it is worst: on the width that both \
             share it counts as {times:.2} times the vehicle, by 1/λ = 1/λ₁ + 1/λ₂ of what each carries by itself, a lower bound ({}, {}).",
            source.text, source.confidence.word();
        /// Braking and traction, as a share of all loads, and whether forces across the bridge move loads.
        Braking { share: f64, sideways: Sideways } =>
            "Braking and traction: {:.0} % of every axle and uniform load acts along the bridge at the surface as well, to the right, to the \
             left or not at all, whichever is worst for a vehicle; all of it reaches the rings, and none the ground before and behind. Of \
             forces across the bridge: {sideways}.",
            100.0 * share;
        CasesAtPlaces => "At every place that case of the vehicle counts that carries least, as in a sweep: which axles and uniform loads stand, \
                          which axle is the critical one, and which weights help.";
        Width { across: Across } => "{:.2} m of the barrel carry an axle: {}.", across.axles, across.told();
    }
}

notes! {
    /// What is done with forces across the bridge.
    #[derive(Copy, Eq)]
    Sideways {
        /// They move loads across the bridge.
        Counted => "centrifugal and side forces count by the load that they move across the bridge, and not as forces on walls, parapets and \
                    piers";
        LeftOut => "curvature and wind are left out";
    }
}

notes! {
    /// Which combination of weights governs.
    Governing {
        Vehicle { code: String, weights: Weights } => "{code} governs with {}", weights.told();
        Falls { weights: Weights } => "with {} the bridge does not stand", weights.told();
        Unanswered { code: String } => "{code} is not answered everywhere";
        Nothing => "no combination governs";
    }
}

/// How vehicles stand across the bridge: those that stand alike together.
fn across(vehicles: &[(String, Across)]) -> String {
    let mut list: Vec<(String, Vec<&str>)> = Vec::new();
    for (code, across) in vehicles {
        let told = across.told();
        match list.iter_mut().find(|(known, _)| *known == told) {
            Some((_, codes)) => codes.push(code),
            None => list.push((told, vec![code])),
        }
    }
    let each = list.iter().map(|(told, codes)| match list.len() {
        1 => told.clone(),
        _ => format!("{told} ({})", codes.join(", ")),
    });
    each.collect::<Vec<_>>().join("; ")
}
