//! Warnings of an analysis, each with a card that explains it.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

/// A warning; in files it is a pair, code and words.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(into = "(String, String)")]
pub struct Warning {
    /// Stable code, `A…`.
    pub code: &'static str,
    /// What was found, with numbers.
    pub message: String,
}

impl From<Warning> for (String, String) {
    fn from(warning: Warning) -> (String, String) {
        (warning.code.to_owned(), warning.message)
    }
}

impl<'de> Deserialize<'de> for Warning {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Warning, D::Error> {
        let (code, message) = <(String, String)>::deserialize(from)?;
        let card = CARDS.iter().find(|card| card.code == code);
        let unknown = || D::Error::custom(format!("there is no warning {code}"));
        Ok(Warning { code: card.ok_or_else(unknown)?.code, message })
    }
}

/// What a code means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Card {
    /// The code.
    pub code: &'static str,
    /// In a few words.
    pub title: &'static str,
    /// Why it matters and what to do.
    pub text: &'static str,
}

macro_rules! cards {
    ($($(#[$meta:meta])* $name:ident = $code:literal, $title:literal, $text:literal;)*) => {
        $($(#[$meta])* pub const $name: &str = $code;)*
        /// Every card, in order of the codes.
        pub const CARDS: &[Card] = &[$(Card { code: $code, title: $title, text: $text }),*];
    };
}

cards! {
    /// Associated friction where sliding takes part.
    ASSOCIATED_SLIDING = "A101", "associated friction where joints slide",
        "Limit analysis with associated friction lets a sliding joint open by the friction angle. Real joints do not, so \
         where sliding takes part in the mechanism the load is an upper bound that can be half as much again as what the \
         blocks carry. Use friction = \"non-associated\" or \"automatic\" in the plan, or the discrete element method \
         (Gilbert, Casapulla and Ahmed 2006).";
    /// The dispersal rule moves the load.
    SHIFTED_LOAD = "A102", "the dispersal rule moves the load along the bridge",
        "A pressure inversely proportional to depth (Rouxinol, Providência and Lemos, eq. 2) has the load's size but not \
         its place: its centre lies nearer to the shallow end. The rule is applied as published; the message gives the \
         distance. The rule \"none\" keeps the load where it stands.";
    /// Part of the load goes to the ground.
    GROUND_LOAD = "A103", "part of the load reaches the ground beside the rings",
        "What disperses onto an abutment's upper face or beyond it does not act on the rings. The collapse load still \
         counts the whole load on the road.";
    /// Where the joints' contact points lie.
    INSET = "A104", "contact points lie inside the edges",
        "Blocks with rounded corners touch inside their edges by the radius of rounding, so the effective ring is thinner \
         than drawn. At Bridgemill 10 mm at each edge take 5 % off the limit load (231.5 to 219.4 kN/m). State the inset \
         with the load; contact_points = \"full-ring\" analyses the drawn thickness.";
    /// The published load is the last stable one.
    PUBLISHED_STEP = "A105", "which load step is called the collapse load",
        "collapse_load is the first load that did not come to rest, last_stable_load the one before it. Rouxinol, \
         Providência and Lemos print the last stable step as collapse load for their cases 1 and 2 (204.82 and \
         325.30 kN/m), and the collapsing one for case 3.";
    /// Discrete elements against the limit load.
    ABOVE_LIMIT = "A106", "the discrete element load lies above the limit load",
        "Deformable joints and displacements lower the load of an arch below the limit load of the same blocks as built, \
         usually by 0 to 15 %. A load above it has a reason: crushing, which limit analysis puts under the edge about which \
         a joint turns, while a contact point spreads its force over the length it stands for (compare with the limit \
         load of masonry that is \"unlimited\", and use the smaller number); friction that dilates less than assumed elsewhere, thrust \
         lines that displacements improve, or a load step that is too coarse. Find it before using the number.";
    /// Far below the limit load.
    FAR_BELOW_LIMIT = "A107", "the discrete element load lies far below the limit load",
        "More than 15 % below the limit load of the same blocks: soft joints, large displacements before collapse, or \
         sliding that associated friction overestimates. Try stiffer joints to see which.";
    /// A run broke off.
    BROKEN = "A108", "the run broke off at a block",
        "A number stopped being finite or a block ran away within one step. The message names the block and the \
         iteration; a smaller time_step_factor or a look at that block's joints helps.";
    /// The stress passes the strength.
    ABOVE_STRENGTH = "A109", "stress above the compressive strength",
        "The largest compressive stress at rest is above the strength of the masonry. With a strength in the file the \
         contacts crush at it; the message compares the two.";
    /// Crushing left out.
    UNLIMITED_STRENGTH = "A110", "compressive strength without limit",
        "The file gives no compressive strength, or calls it unlimited, so hinges turn about a line and nothing can be \
         said about crushing. With a strength the joints of limit analysis carry thrust blocks at that strength and \
         turn about a point inside; unlimited_strength_load stands beside the result.";
    /// Fill as weight alone.
    FILL_AS_WEIGHT = "A111", "fill acts by its weight alone",
        "Cover is weight and a path for loads; it does not push back on a ring that moves into it. That leaves out what makes a bridge \
         stronger, and still it is not always on the safe side, since rigid blocks leave out what makes it weaker: Bridgemill was \
         predicted at 1.14 of what its test carried, three other tests at 0.50 to 0.85. [fill_pressure] and backing as = \"blocks\" add \
         what fill and backing carry; with pressure Bridgemill is predicted at 1.33. Neither is a bound of the bridge: A191 has the model \
         factor, and docs/theory/fill-pressure.md says when to ask for them.";
    /// Numbers chosen for the reader.
    CHOSEN = "A112", "a number of the plan was chosen",
        "The plan leaves a number of the method out (never a physical value), and it was chosen as the message says. \
         Write it into the plan to keep it.";
    /// Bounds apart.
    BOUNDS_APART = "A113", "the bounds of limit analysis differ",
        "The load recomputed from the forces and the load recomputed from the mechanism differ by more than the \
         tolerance. Trust the lower one.";
    /// Strips added up.
    STRIPS_ADDED = "A114", "the loads of two strips are added up",
        "The strip between the walls and that below them are analysed by themselves, and their collapse loads added up by \
         their widths. Both must reach them together for the sum to hold: a stiff wall fails while the rest is still far \
         from its load, and walls lean outwards before they fail in their plane. Where the walls carry much more of the \
         sum than their share of the width, rely on the strip between them.";
    /// Particles that bridge the cover.
    COARSE_PARTICLES = "A115", "a particle is larger than the cover is deep",
        "The largest particle reaches from the ring to the road at the shallowest place of the cover. There the fill is single \
         stones wedged between load and ring, and neither its weight nor its strength is that of a fill. Take more particles \
         until several lie above one another at the crown: compare the answers of several seeds and counts.";
    /// A wanted modulus of fill that no stiffness gives.
    OUT_OF_REACH = "A120", "the wanted modulus of the fill is out of reach",
        "Stiffer contacts make the fill stiffer only as long as contacts are what yields: particles that slide and roll past \
         one another yield whatever their stiffness, and the modulus levels off. At the soft end contacts overlap so much that \
         they are no model of fill. The message gives the range that was tried. A denser packing (packing_stress, \
         solid_fraction), more friction or other load steps move the range; a larger `multiples` widens the search.";
    /// A check that does not bear the search out.
    CHECK_APART = "A121", "other packings do not have the wanted modulus",
        "The stiffness was found on the packings of some seeds and checked on as many others, whose mean should be within 5 % of \
         the wanted modulus. It is not: the scatter between packings is too large for so few of them. Use more `seeds` in \
         [calibration] until the standard error in the message is below 2 %.";
    /// Samples left out of the mean.
    LEFT_OUT = "A122", "samples were left out",
        "A sample counts only if it came to rest in every load step and became shorter in each. The message says how many did \
         not, and at which multiple of the stiffness. Many of them make the mean doubtful: use smaller load steps, or fewer.";
    /// Too many particles for figures.
    NOT_DRAWN = "A123", "too many particles to be drawn",
        "Drawings hold at most 200 000 particles; above that no viewer of drawings would open them. The figures show blocks, \
         supports and loads only, and those that need particles are left out. ParaView files and tables hold every particle.";
    /// Rings that share shear by friction alone.
    RINGS_SHARE = "A124", "rings that slide on one another share their load in a way that statics does not fix",
        "How much shear passes from ring to ring depends on the force that presses them together, and equilibrium allows many such \
         forces. Limit analysis looks for the largest load, with or without dilation, and so may choose the state in which the rings \
         press hard; discrete elements arrived at 0.66 to 0.82 of its load for nine bridges with two rings \
         (docs/verification/profiles.md). Take the smaller of both methods, or a low friction angle in [ring_joint].";
    /// One packing is one sample.
    ONE_PACKING = "A125", "one packing of particles is one sample",
        "Packings made by the same recipe with another seed carry loads that differ by tens of kN/m and now and then by more than a \
         hundred: five of Bridgemill lay between 223 and 403 kN/m with one recipe and between 403 and 427 with another \
         (docs/verification/fill.md). Run several seeds, as in --set analysis.seed=1,2,3,4,5 of extrados vary, and judge by the \
         low end of what they give, not by one of them.";
    /// Spandrel walls that a passage does not have.
    WALLS_LEFT_OUT = "A127", "spandrel walls are left out of the passage",
        "The strip that finite elements model lies between the walls. Walls stiffen a bridge and relieve it; they may also part from \
         it, so that records taken near them belong to another structure. Stresses and deflections are those of a barrel that \
         carries everything by itself; parameters identified from records take the walls' stiffness for that of ring and fill.";
    /// A passage broke off.
    BROKEN_PASSAGE = "A130", "the passage broke off",
        "A load step found no equilibrium within its iterations, however small it was cut. The records end at the last position \
         that was solved, and the message says where that is. Steps that do not converge have a reason: fill that fails under an \
         axle (look at cohesion and friction of [fill]), a ring near its collapse load (try extrados collapse), or a tolerance below \
         what rounding allows.";
    /// The solver's numbers are not what was asked for.
    LOOSE_PASSAGE = "A131", "the passage was solved with a loose tolerance",
        "Peaks of channels depend on the out-of-balance force that is left. With a thousandth, the railway paper's setting, they \
         differ by up to a percent from those with 1e-6; sensitivities and updating need 1e-8.";
    /// Records that were computed.
    SYNTHETIC = "A140", "the records are synthetic",
        "A record says in its first line that it was computed and not measured. What is found from it tells how well the method \
         works, and nothing of a bridge.";
    /// A parameter on its bound.
    AT_BOUND = "A141", "a parameter stands on a bound of its range",
        "The records ask for a value beyond the range, or they do not see the parameter. It has not converged, whatever the norm \
         says. Look at `identifiable` and at the sweep of this parameter; widen the range only with a reason that is not the norm.";
    /// Peaks outside the slices.
    WANDERED = "A142", "a peak lies outside the slices of the search",
        "The search looked for peaks at the places where a full passage had them. By the parameters that it ended with, a channel \
         peaks elsewhere: the norm of the full passage counts. Write slices = false in [update] to compare full passages.";
    /// Something that could not be told.
    UNTOLD = "A143", "what the data can tell could not be found out",
        "The model failed close to what was found, or the posterior could not be posed. The parameters stand; how well the records \
         tell them is not known. The message says why.";
    /// Factors from memory.
    RECALLED_FACTOR = "A150", "factors of the rule must be confirmed",
        "A rule holds every factor with its source and how sure it is. Those in the message are recalled and not read in the \
         document that the rule names: look them up there before a verdict rests on them, and put your own into a file of a rule \
         (rule_file in [sweep]).";
    /// A road rule for a train, or the other way round.
    RULE_FOR_OTHER_WAYS = "A151", "the rule is not made for this vehicle",
        "A rule says whether it is made for roads, for railways or for both. Impact, dispersal and partial factors of a road rule \
         mean nothing for a train, and those of a railway rule nothing for a lorry. Choose another rule or other vehicles.";
    /// Vehicles that limit analysis passes by less than discrete elements take off.
    NEAR_THE_LIMIT = "A152", "vehicles that only limit analysis passes",
        "The governing vehicle alone is made by discrete elements, whose joints deform; they carry less than rigid blocks do. The \
         vehicles in the message are met by limit analysis with less room than that: with the same share taken off they would not \
         be met. Name each of them alone in vehicles of [sweep] to have it made by discrete elements too, and judge by the smaller \
         number.";
    /// Plain elements that flow.
    LOCKING_FILL = "A153", "fill flows in plain elements, which lock",
        "Soil that yields is made of plain four-node elements. Plastic flow keeps volume in a fixed ratio to shear at each of their four points, \
         which is more than four nodes can follow: where every point of an element flows, it locks and carries too much (Nagtegaal, Parks \
         and Rice 1974). A footing on such elements ends 12 % above Prandtl's load, and a slope stands at 1.6 that fails at 1.4; \
         peaks of a ring under such fill are a little low. Halve size in [mesh] and compare the peaks; where they \
         move, halve it again. More cohesion or a denser fill, if that is what is there, keeps it from flowing.";
    /// A stage of an assessment that failed.
    STAGE_FAILED = "A160", "a stage of the assessment came to no end",
        "An analysis that the file asks for could not be set up or found no answer; the message says which and why. The other \
         stages stand. Checks that rest on this one are not made, and as long as everything else is met the verdict is \
         undetermined. Mend the cause and repeat the command: finished stages are taken up.";
    /// Built without the typesetter.
    WITHOUT_PDF = "A161", "this program writes no report.pdf",
        "The typesetter behind report.pdf is some 200 packages, so that it is built only where it is asked for: \
         cargo install --path crates/cli --features pdf. report.html holds the same and prints on A4; verdict and numbers do \
         not depend on it.";
    /// The report could not be set.
    UNSET_PDF = "A162", "the report could not be typeset as PDF",
        "The typesetter refused the report; the message holds its words. report.html and result.json are complete, verdict and \
         numbers stand. The usual cause is a drawing that is no valid SVG, which is a mistake of this program: please report it with \
         the bridge file.";
    /// A wanted strength of fill that no contacts give.
    STRENGTH_OUT_OF_REACH = "A163", "the wanted strength of the fill is out of reach",
        "Discs roll past one another, so a fill of them is weaker than its contacts: beyond some friction of the contacts they roll \
         instead of sliding, and the fill gets no stronger. The message gives the strength that was reached. A fill that is stronger \
         in truth is then modelled on the safe side: keep the contacts of the message, or take a smaller wanted value. \
         docs/theory/calibration.md.";
    /// A check of strength that does not bear the search out.
    STRENGTH_CHECK_APART = "A164", "other packings do not have the wanted strength",
        "Friction and cohesion of the contacts were found on the packings of some seeds and checked on as many others, whose mean \
         should be within 2 degrees and 10 % of the wanted cohesion (or 1 kPa). It is not: use more `seeds` and `sheared_samples` in [calibration].";
    /// Samples left out of the strength.
    NOT_SHEARED = "A165", "sheared samples were left out",
        "A sample counts only if it rested under every confining pressure and gave way under each. The message says how many did not.";
    /// No end of the iteration without dilation; a lower load in its place.
    WITHOUT_FRICTION = "A170", "a lower load without friction where joints slide",
        "Joints slide in the mechanism, and the iteration that finds the load without dilation came to no end. The associated load \
         is an upper bound that real joints need not reach, and it never takes the place of the answer. What is reported as carried is the \
         load of the same blocks without friction and cohesion in the joints that slide. It is proven for some mechanisms only: none in \
         which no other joint slides can form below it (Radenkovic 1961, second theorem), and one in which others slide is not excluded. \
         It is often far below the true load. The status stays not-converged: use discrete elements for a closer answer.";
    /// Positions without an answer.
    POSITIONS_NOT_CONVERGED = "A175", "positions of a sweep were not answered",
        "At the positions that the message counts, limit analysis found no answer that it can vouch for: the iteration for friction \
         without dilation, or the solver, did not converge. Their loads may govern, so that the vehicle has no adequacy factor and the \
         sweep is undetermined. The factor in the message is the least of the answered cases: the true one is not above it. Ask the \
         discrete element method for that position (extrados collapse --method dem), or look at friction and thickness of the rings.";
    /// Discrete elements with two contact points.
    TWO_POINT_JOINTS = "A176", "joints of discrete elements bear on two points",
        "A closed joint on two points near its edges is three times as stiff in rotation as one that bears over its whole face with the \
         same stiffness: k (h/2)^2 against k h^2 / 12 for each unit of area. Rings with the stiffer joints deform less and carry more. \
         Bridgemill falls from 205 to 132 kN/m with distributed joints of the same stiffness. A load found with two-point joints is \
         one estimate, not a proof of another method's load: vary the joints' stiffness and use the smaller number.";
    /// One method says that the bridge falls.
    METHODS_APART = "A177", "limit analysis finds no equilibrium under self-weight",
        "The discrete element method carries loads on blocks that limit analysis does not let stand under their own weight. One of \
         the two is wrong for this bridge: friction, tension or the shape of the blocks. Nothing is carried until the reason is found.";
    /// Crushing left out by contact points.
    CRUSHING_LEFT_OUT = "A178", "discrete elements leave crushing out of collapse",
        "A contact point of a joint stands for half of it and crushes only at half the joint times the strength, so that a hinge turns \
         about the very edge. Limit analysis lets a hinge turn about the strip that its thrust needs, and carries less: 4 to 38 % in \
         the cases that were compared. Beside blocks the message gives its load, and the smaller of the two is the headline. \
         With particles there is no such load: take the share in the message off the load that was found.";
    /// A step that neither rests nor falls.
    STALLED = "A179", "a load step neither came to rest nor collapsed",
        "The out-of-balance force of the step in the message oscillates without settling, and no block runs away. It is no collapse \
         load, and none is given. The last stable load is sound. Another damping or a smaller time_step_factor often decides.";
    /// Vehicles whose axles are no copy of a standard.
    VEHICLE_NOT_READ = "A180", "a vehicle that was not read in its standard",
        "Axle loads or distances of the vehicles in the message are recalled, assumed, or calculated from published tables, as the \
         message says. Wrong distances move an arch's load by tens of percent. Look the loading diagram up, put it into a file of your \
         own (docs/input/vehicles.md), and judge by that. A vehicle whose loads are assumed can turn a bridge down, and never makes it adequate.";
    /// Load models that the spans are too long for.
    SPAN_TOO_LONG = "A181", "a load model is not made for so long a span",
        "On longer spans more of the loading stands than the model holds, so that the model is known or feared to fall short. The \
         models in the message were left out: what the sweep says does not cover them. Name the whole train in a file of your own.";
    /// Lanes and edges that the file does not give.
    ACROSS_ASSUMED = "A182", "where vehicles stand across the bridge is assumed",
        "Two vehicles abreast share the width between them, which may give a fifth more load per metre than one alone; a vehicle at the \
         edge of the barrel lacks the width beyond it. Write lanes, lane_width and edge_distance into [carriageway]: every arrangement \
         up to them is then tried, and the worst counts.";
    /// A skew bridge analysed as a square one.
    SKEW = "A183", "skew is not modelled",
        "A skew barrel carries along the shorter way between its obtuse corners and twists; a plane, square model finds neither, and its \
         load is not a bound for it. Use the span along the road, which is the longer one, and confirm by a model in three dimensions or by a \
         test. Beyond 10 degrees a bridge is called adequate only where skew_source in [assess] names what confirms it.";
    /// Horizontal forces of vehicles.
    NO_LONGITUDINAL = "A184", "braking and traction are left out",
        "Vehicles brake and pull: on railways up to a quarter of the axle loads along the track. Track and fill carry much of that to \
         the ground, and piers and slender rings feel the rest. No analysis here moves horizontal forces with a vehicle; a horizontal \
         load cannot be described. Look at tall piers and short spans by hand.";
    /// No ultimate check under sourced factors.
    STRENGTH_OPEN = "A190", "strength was not assessed",
        "The ladder of verdicts, from its lowest rung: inadequate, a limit is not met (exit code 1); undetermined, an analysis that a \
         check rests on came to no end (3); undetermined, limits are met or there are none, but no ultimate check was made under \
         factors with a source, so that strength was not assessed (1); adequate, strength was assessed so and every limit that was \
         compared with is met (0). An ultimate check under factors with a source is C204 by a rule with a live load factor above 1 that is \
         read, calculated or recalled in a named document, or C201 with adequacy_source in [assess] and a factor above 1. Deflections, stresses, lines of \
         thrust, shares of a load and MEXE assess no strength at ultimate. The message says what is missing.";
    /// The program's own model factor.
    MODEL_SCATTER = "A191", "the model factor of limit analysis is the program's own",
        "Limit analysis with fill by its weight alone, beside tests to collapse at full scale: test over prediction has a median of 1.34, a \
         scatter of 0.35 (standard deviation of the logarithm) and, from four tests, a 5 % fractile of 0.53. Its reciprocal, 1.9, is the \
         model factor that counts where the rule's own was not read in its source, and under adequacy_factor of [assess] without \
         model_factor. Below the rule's limit a bridge is not adequate; from the limit to the limit times the model factor strength is \
         not assessed; above that it is. A rule_file with a model factor that was read, or model_factor in [assess], goes before it. \
         docs/verification/model-factor.md has the tests.";
    /// Cohesion at hinges.
    COHESION_PRESSED = "A192", "cohesion of joints counts where they are pressed",
        "A joint that turns about its edge is in contact over the thrust over the strength, and open beyond. Limit analysis therefore gives \
         cohesion to that part alone, as friction that is larger by cohesion over compressive strength; without a strength in the file it \
         gives none. A tensile strength is different: it acts along the whole joint as if it never broke, while a real joint breaks once \
         and for all. Compare the load with tensile_strength = \"0 kPa\".";
    /// Ring joints that were not described.
    RING_JOINT_COPIED = "A193", "the joint between rings has the cohesion of the joints within them",
        "The file describes no [ring_joint], so the joints between rings are those of [joint], with its cohesion and tension. Joints \
         between rings are what fails first in brick arches; their mortar is often gone. Describe them in [ring_joint], without cohesion \
         where nobody has seen that they hold.";
    /// One ring that may be several.
    ONE_PIECE = "A194", "a thick ring in one piece",
        "The ring is thicker than a brick is long and is modelled in one piece. Where it is of brick in rings, the rings can part: a bridge \
         with separated rings carried a third less than a bonded one (Melbourne and Gilbert 1995) [recalled], and nothing here shows it. \
         Describe the rings in [[span.ring]] with their [ring_joint]. Where stones reach through the whole ring there is nothing to do.";
    /// What pressure adds, and on what a verdict rests.
    PRESSURE_RANGE = "A195", "fill pressure: a range, and a verdict on its lower end",
        "What fill adds depends on how far it is mobilised, which nothing tells of a bridge: with half of the passive pressure one test is \
         predicted at 1.33 of what it carried and another at 0.53. A result with [fill_pressure] has the load by weight alone and that with \
         all of the passive pressure beside its own, and checks at ultimate rest on the lower end.";
}

impl Warning {
    /// A warning with its message.
    pub fn new(code: &'static str, message: impl Into<String>) -> Warning {
        Warning { code, message: message.into() }
    }
}

/// The card of a code.
pub fn explain(code: &str) -> Option<&'static Card> {
    CARDS.iter().find(|c| c.code.eq_ignore_ascii_case(code))
}

#[cfg(test)]
mod tests {
    #[test]
    fn codes_are_unique_and_in_order() {
        assert!(super::CARDS.windows(2).all(|w| w[0].code < w[1].code));
    }
}
