//! Cards of the warnings, and what makes the warnings of one subject, each with its card.

/// Warnings of one subject: `CODE: Name { number [unit]: Type } => "sentence", its arguments;`.
macro_rules! warnings {
    ($(#[$meta:meta])* $Subject:ident { $(
        $(#[$about:meta])* $code:ident: $Name:ident $({ $($field:ident $([$($unit:tt)+])? : $Type:ty),* })? => $words:literal $(, $part:expr)*;
    )* }) => {
        crate::sentences::notes! {
            $(#[$meta])* $Subject { $(
                $(#[$about])* $Name $({ $($field $([$($unit)+])? : $Type),* })? => $words $(, $part)*;
            )* }
        }

        impl $Subject {
            /// Its code.
            pub fn code(&self) -> &'static str {
                match self { $($Subject::$Name { .. } => crate::warning::cards::$code,)* }
            }
        }
    };
}

pub(super) use warnings;

findings::cards! {
    ASSOCIATED_SLIDING = "A101", "associated friction where joints slide",
        "In limit analysis with associated friction a sliding joint also opens, at the friction angle. Real joints do \
         not, so where joints slide in the mechanism the load is an upper bound, which can be one and a half times \
         what the blocks carry. Use friction = \"non-associated\" or \"automatic\" in the plan, or the discrete \
         element method (docs/theory/limit-analysis.md).";
    SHIFTED_LOAD = "A102", "the dispersal rule moves the load along the bridge",
        "A pressure inversely proportional to depth (Rouxinol, Providência and Lemos, eq. 2) conserves the force but \
         not its position: its resultant lies nearer to the shallow end. The rule is applied as published; the message \
         gives the distance. The rule \"none\" does not move the load.";
    GROUND_LOAD = "A103", "part of the load reaches the ground beside the rings",
        "Load that disperses onto an abutment's upper face or beyond it does not act on the rings. The collapse load \
         is still the whole load on the road.";
    INSET = "A104", "contact points lie inside the edges",
        "Blocks with rounded corners touch inside their edges by the radius of rounding, so the effective ring is \
         thinner than drawn. At Bridgemill 10 mm at each edge lower the limit load by 5 % (231.5 to 219.4 kN/m). State \
         the inset with the load; contact_points = \"full-ring\" analyses the thickness as drawn.";
    PUBLISHED_STEP = "A105", "which load step is called the collapse load",
        "collapse_load is the first load that did not come to rest, last_stable_load the one before it. Rouxinol, \
         Providência and Lemos print the last stable step as collapse load for their cases 1 and 2 (204.82 and \
         325.30 kN/m), and the collapsing one for case 3.";
    ABOVE_LIMIT = "A106", "the load lies above the limit load of the same blocks",
        "Deformable joints and displacements lower the load of an arch below the limit load of the same blocks as \
         built, usually by 0 to 15 %. A load above it has one of these reasons: crushing, which limit analysis places \
         under the edge about which a joint turns, while a contact point spreads its force over the length that it \
         represents (compare with the limit load for \"unlimited\" strength, and use the smaller number); friction \
         with less dilation than limit analysis assumes; displacements that improve the thrust line; or a load step \
         that is too coarse. In finite elements joints do not slide (A205). Find the reason before you use the number; the smaller load leads.";
    FAR_BELOW_LIMIT = "A107", "the discrete element load lies far below the limit load",
        "The load is more than 15 % below the limit load of the same blocks. Possible reasons are soft joints, large \
         displacements before collapse, or sliding whose resistance associated friction overestimates. Try stiffer \
         joints to see which applies.";
    BROKEN = "A108", "the run broke off at a block",
        "A number stopped being finite or a block ran away within one step. The message names the block and the \
         iteration. Try a smaller time_step_factor, or check that block's joints.";
    ABOVE_STRENGTH = "A109", "stress above the compressive strength",
        "The largest compressive stress at rest is above the strength of the masonry. If the file gives a strength, \
         the contacts crush at it; the message compares the two.";
    UNLIMITED_STRENGTH = "A110", "compressive strength without limit",
        "The file gives no compressive strength, or calls it unlimited, so hinges turn about an edge and crushing is \
         left out. With a strength, joints in limit analysis carry the thrust over a length at that strength and turn \
         about a point inside the edge; the result then also gives unlimited_strength_load.";
    FILL_AS_WEIGHT = "A111", "fill acts by its weight alone",
        "Cover weighs and spreads loads, but it does not resist a ring that moves into it. This leaves out effects \
         that make a bridge stronger. It is still not always on the safe side, because rigid blocks leave out effects \
         that make it weaker: the prediction for Bridgemill was 1.14 times the test load, for three other tests 0.50 \
         to 0.85. [fill_pressure] and backing as = \"blocks\" add what fill and backing carry; with pressure the \
         prediction for Bridgemill is 1.33. Neither load is a bound for the bridge: A191 explains the model factor, \
         and docs/theory/fill-pressure.md says when to use these tables.";
    CHOSEN = "A112", "a number of the plan was chosen",
        "The plan does not give a numerical setting of the method, and the program chose it as the message says. It \
         never chooses a physical value. Write the setting into the plan to keep it.";
    BOUNDS_APART = "A113", "the bounds of limit analysis differ",
        "The load recomputed from the forces and the load recomputed from the mechanism differ by more than the \
         tolerance. Trust the lower one.";
    STRIPS_ADDED = "A114", "the loads of two strips are added up",
        "The strip between the walls and the strip below them are analysed separately, and their collapse loads are \
         added in proportion to their widths. The sum is valid only if both strips reach their loads together: a stiff \
         wall may fail while the rest is still far from its load, and walls lean outwards before they fail in their \
         plane. Where the walls carry much more of the sum than their share of the width, rely on the strip between \
         them.";
    COARSE_PARTICLES = "A115", "a particle is larger than the cover is deep",
        "The largest particle reaches from the ring to the road where the cover is shallowest. There the fill consists \
         of single stones wedged between load and ring, and neither its weight nor its strength is that of fill. Use \
         more particles, until several lie above one another at the crown, and compare the results for several seeds \
         and counts.";
    OUT_OF_REACH = "A120", "the wanted modulus of the fill is out of reach",
        "Stiffer contacts make the fill stiffer only as long as contact deformation governs: particles also slide and \
         roll past one another, whatever their stiffness, and the modulus levels off. At the soft end contacts overlap \
         so much that they no longer represent fill. The message gives the range that was tried. A denser packing \
         (packing_stress, solid_fraction), more friction or other load steps move the range; a larger `multiples` \
         widens the search.";
    CHECK_APART = "A121", "other packings do not have the wanted modulus",
        "The stiffness was found on the packings of some seeds and checked on as many others, whose mean should be within 5 % of \
         the wanted modulus. It is not: the scatter between packings is too large for so few of them. Use more `seeds` in \
         [calibration] until the standard error in the message is below 2 %.";
    LEFT_OUT = "A122", "samples were left out",
        "A sample counts only if it came to rest in every load step and became shorter in each. The message says how many did \
         not, and at which multiple of the stiffness. Many of them make the mean doubtful: use smaller load steps, or fewer.";
    NOT_DRAWN = "A123", "too many particles to be drawn",
        "Drawings hold at most 200 000 particles; viewers could not open larger ones. The figures show blocks, \
         supports and loads only, and those that need particles are left out. ParaView files and tables hold every \
         particle.";
    RINGS_SHARE = "A124", "the shear between rings that slide on one another is statically indeterminate",
        "The shear between rings depends on the force that presses them together, and equilibrium allows many such \
         forces. Limit analysis finds the largest load with dilation, and without it the one that weight and load between stiff \
         joints come to. Joints that deform let rings lose their shape before they reach it: the equilibrium path and discrete elements carry \
         less, as much as the limit load where joints are made ever stiffer, and half to three quarters of it with joints of usual stiffness \
         (docs/verification/brick-rings.md). Use the smaller result.";
    ONE_PACKING = "A125", "one packing of particles is one sample",
        "The loads of packings with the same settings but another seed differ by tens of kN/m, sometimes by more than \
         a hundred: five of Bridgemill gave 223 to 403 kN/m with one set of settings and 403 to 427 with another \
         (docs/verification/fill.md). Run several seeds, as in --set analysis.seed=1,2,3,4,5 of extrados vary, and \
         judge by the low end of the results, not by one of them.";
    WALLS_LEFT_OUT = "A127", "spandrel walls are left out of the passage",
        "The finite element model is the strip between the walls. Walls stiffen a bridge and relieve it; they may also \
         separate from it, so that records taken near them belong to another structure. Stresses and deflections are \
         those of a barrel that carries everything by itself; parameters identified from records include the walls' \
         stiffness in that of ring and fill.";
    BROKEN_PASSAGE = "A130", "the passage broke off",
        "A load step found no equilibrium within its iterations, even with the smallest substeps. The records end at \
         the last position that was solved, which the message gives. Usual reasons are fill that fails under an axle \
         (check cohesion and friction of [fill]), a ring near its collapse load (try extrados collapse), or a \
         tolerance below what rounding allows.";
    LOOSE_PASSAGE = "A131", "the passage was solved with a loose tolerance",
        "Peaks of channels depend on the remaining out-of-balance force. With a thousandth, the railway paper's \
         setting, they differ by up to a percent from those with 1e-6; sensitivities and updating need 1e-8.";
    SYNTHETIC = "A140", "the records are synthetic",
        "The first line of a record says that it was computed and not measured. Results from it show how well the \
         method works, but say nothing about a bridge.";
    AT_BOUND = "A141", "a parameter is on a bound of its range",
        "The records fit best with a value beyond the range, or they hardly depend on the parameter. It has not \
         converged, whatever the norm. Check `identifiable` and the sweep of this parameter; widen the range only for \
         a reason other than the norm.";
    WANDERED = "A142", "a peak lies outside the slices of the search",
        "The search compared peaks at the positions where a full passage had them. With the final parameters a channel \
         peaks at another position: the norm of the full passage counts. Write slices = false in [update] to compare \
         full passages.";
    UNTOLD = "A143", "identifiability could not be determined",
        "The model failed close to the solution, or the posterior could not be set up. The parameters are valid, but \
         how well the records determine them is not known. The message says why.";
    RECALLED_FACTOR = "A150", "factors of the rule must be confirmed",
        "A rule gives the source and the certainty of every factor. Those in the message are recalled, not read in the \
         document that the rule names: look them up there before a verdict rests on them, and put the right ones into \
         a rule file (rule_file in [sweep]).";
    RULE_FOR_OTHER_WAYS = "A151", "the rule is not made for this vehicle",
        "A rule says whether it is made for roads, for railways or for both. Impact, dispersal and partial factors of a road rule \
         mean nothing for a train, and those of a railway rule nothing for a lorry. Choose another rule or other vehicles.";
    NEAR_THE_LIMIT = "A152", "vehicles that only limit analysis passes",
        "Only the governing vehicle is analysed by discrete elements, whose deformable joints carry less than rigid \
         blocks. The vehicles in the message pass by limit analysis with a smaller margin: with the same reduction \
         they would fail. Name each of them alone in vehicles of [sweep] to analyse it by discrete elements too, and \
         judge by the smaller number.";
    LOCKING_FILL = "A153", "fill yields in plain elements, which lock",
        "Soil that yields is modelled by plain four-node elements. Plastic flow couples volume to shear at each of \
         their four points, and four nodes cannot satisfy all these constraints: where every point of an element \
         yields, the element locks and carries too much (Nagtegaal, Parks and Rice 1974). A footing on such elements \
         ends 12 % above Prandtl's load, and a slope that should fail at a factor of 1.4 stands at 1.6; peaks of a \
         ring under such fill are a little low. Halve size in [mesh] and compare the peaks; if they change, halve it \
         again. A larger cohesion or friction angle, if the real fill has it, prevents yielding.";
    COARSE_PASSAGE = "A154", "positions of a passage are far apart",
        "A record has a value for each position of its vehicle, `time_step` times its speed apart. Where a record bends much at its peak, the peak lies between two          positions: by the parabola through three of them up to an eighth of their second difference above what was found. The message names records of          which that is more than a twentieth. Write a smaller `time_step` in [passage].";
    NO_INFLUENCE_LINES = "A155", "no influence lines",
        "After a passage the heaviest axle crosses by itself, in places 0.25 m apart, and what the sensors read is drawn over its place. At one place the          solution found no balance, and no line is given rather than a part of one. The passage itself is not concerned. A smaller `size` in [mesh] or more          `load_steps` in [passage] may help.";
    STAGE_FAILED = "A160", "a stage of the assessment did not finish",
        "An analysis of the file could not be set up or found no result; the message says which one and why. The other \
         stages are valid. Checks that depend on this one are not made, and if all others are met the verdict is \
         undetermined. Remove the cause and repeat the command: it uses the finished stages.";
    WITHOUT_PDF = "A161", "nothing was found that makes report.pdf",
        "With --pdf the report is set by extrados-pdf, which lies beside the program in the release archive (from source: cargo install \
         --path crates/report-pdf). Without it a browser prints report.html: the first of Chromium, Chrome, Edge and Brave that is found, or the one \
         that EXTRADOS_BROWSER names. Firefox prints from its menu alone: open report.html there. Verdict and numbers do not depend on it.";
    UNSET_PDF = "A162", "the report could not be made a PDF",
        "The message says why. report.html and result.json are complete, and verdict and numbers are valid: print report.html from any browser. \
         EXTRADOS_BROWSER names another browser for --pdf. Where the typesetter refuses a report, this is an error of ours: please \
         report it with the bridge file.";
    STRENGTH_OUT_OF_REACH = "A163", "the wanted strength of the fill is out of reach",
        "Discs roll past one another, so fill made of discs is weaker than its contacts: above a certain contact \
         friction they roll instead of sliding, and the fill becomes no stronger. The message gives the strength that \
         was reached. If the real fill is stronger, this is on the safe side: keep the contacts of the message, or use \
         a smaller wanted value (docs/theory/calibration.md).";
    STRENGTH_CHECK_APART = "A164", "other packings do not have the wanted strength",
        "Friction and cohesion of the contacts were found on the packings of some seeds and checked on as many others, whose mean \
         should be within 2 degrees and 10 % of the wanted cohesion (or 1 kPa). It is not: use more `seeds` and `sheared_samples` in [calibration].";
    NOT_SHEARED = "A165", "sheared samples were left out",
        "A sample counts only if it came to rest under every confining pressure and failed under each. The message \
         says how many did not.";
    WITHOUT_FRICTION = "A170", "a lower load without friction where joints slide",
        "Joints slide in the mechanism, and the way to a load without dilation has no end. The \
         associated load is an upper bound that real joints may not reach, so it never replaces the result. The load \
         reported as carried is that of the same blocks without friction and cohesion in the joints that slide. It is \
         proven for some mechanisms only: no mechanism in which only these joints slide can form below it (Radenkovic \
         1961, second theorem), but one in which others slide is not excluded. It is often far below the true load. \
         The status stays not-converged: use discrete elements for a closer result.";
    POSITIONS_NOT_CONVERGED = "A175", "positions of a sweep have no result",
        "At the positions that the message counts, limit analysis found no reliable result: the way without dilation \
         has no end, or the solver did not converge. These positions may govern, so the vehicle has no adequacy \
         factor and the sweep is undetermined. The factor in the message is the least of the other cases: the true one \
         is not above it. Analyse such a position by discrete elements (extrados collapse --method dem), or check \
         friction and thickness of the rings.";
    TWO_POINT_JOINTS = "A176", "joints of discrete elements bear on two points",
        "A closed joint on two points near its edges is three times as stiff in rotation as one that bears over its \
         whole face with the same stiffness: k (h/2)^2 against k h^2 / 12 per unit of area. Rings with stiffer joints \
         deform less and carry more: with distributed joints of the same stiffness Bridgemill falls from 205 to 132 \
         kN/m. A load found with two-point joints is one estimate and does not confirm another method's load: vary the \
         joints' stiffness and use the smaller number.";
    METHODS_APART = "A177", "limit analysis finds no equilibrium under self-weight",
        "By discrete elements the blocks carry loads, but by limit analysis they do not stand under their own weight. \
         One of the two is wrong for this bridge because of friction, tension or the shape of the blocks. No load \
         counts as carried until you find the reason.";
    CRUSHING_LEFT_OUT = "A178", "discrete elements leave crushing out of collapse",
        "A contact point represents half of its joint and crushes only at half the joint times the strength, so a \
         hinge turns about the edge itself. In limit analysis a hinge turns about a point inside the length that its \
         thrust needs, and the load is lower: by 4 to 38 % in the cases that were compared. Without particles the \
         message gives this load, and the smaller of the two is the headline. With particles there is no such load: \
         reduce the load that was found by the percentage in the message.";
    STALLED = "A179", "a load step neither came to rest nor collapsed",
        "In the step that the message names the out-of-balance force oscillates without settling, and no block runs \
         away. This step is not a collapse load, and none is given. The last stable load is valid. Another damping or \
         a smaller time_step_factor often gives a clear result.";
    VEHICLE_NOT_READ = "A180", "a vehicle that was not read in its standard",
        "Axle loads or distances of the vehicles in the message are recalled, assumed, or calculated from published \
         tables, as the message says. Wrong distances change an arch's load by tens of per cent. Look up the loading \
         diagram, put it into your own file (docs/input/vehicles.md), and judge by that. A vehicle whose loads are \
         assumed can make a bridge inadequate, but never adequate.";
    SPAN_TOO_LONG = "A181", "a span is too long for a load model",
        "Longer spans carry more of the loading than the model holds, so the model is known or suspected to \
         underestimate it. The sweep leaves out the models in the message, and its result does not cover them. Give \
         the whole train in your own file.";
    ACROSS_ASSUMED = "A182", "the positions of vehicles across the bridge are assumed",
        "Two vehicles abreast share the width between them, which may give a fifth more load per metre than one alone; \
         for a vehicle at the edge of the barrel the width beyond the edge is missing. Write lanes, lane_width and \
         edge_distance into [carriageway]: every arrangement within them is then tried, and the worst counts.";
    SKEW = "A183", "skew is not modelled",
        "A skew barrel carries along the shorter path between its obtuse corners and twists; a plane, square model \
         includes neither effect, and its load is not a bound. Use the span along the road, which is the longer one, \
         and confirm the result by a three-dimensional model or by a test. Beyond 10 degrees a bridge is called \
         adequate only where skew_source in [assess] names what confirms it.";
    NO_LONGITUDINAL = "A184", "braking and traction are left out",
        "Braking and traction apply horizontal forces: on railways up to a quarter of the axle loads. Track and fill \
         carry much of this to the ground; the rest acts on piers and slender rings. This result applies none. Write \
         braking in [sweep], a share of all loads that is tried to the right and to the left, or horizontal in a [[load]]; \
         what rule of yours asks for it, and how much, is for the assessor.";
    STRENGTH_OPEN = "A190", "strength was not assessed",
        "The ladder of verdicts, from its lowest rung: not adequate, a limit is not met (exit code 1); undetermined, an \
         analysis on which a check depends did not finish (3), or something is missing that the rule asks for (1); limits \
         met, strength not asked for, where the file names no rule (1); adequate by a named rule, whose every check was \
         made and met (0). The rule is that of [sweep]: it is met by every load case of its loading that applies to the \
         spans, under the factors that acted, above 1 on live loads and with a source, with strength, dispersal, braking, \
         directions and skew as it asks. Without [sweep] it is adequacy_factor of [assess] with its source. A stage that \
         the file asks for and the command skips leaves the verdict undetermined. Checks of deflection, stress, thrust \
         line, share of a load and MEXE do not assess ultimate strength. The message says what is missing.";
    MODEL_SCATTER = "A191", "the model factor is that of tests to collapse",
        "The factors of a standard cover its own method, and no model factor of the program multiplies them: the record \
         of the method stands beside the verdict. Under factors of the engineer's own (adequacy_factor without \
         model_factor, a rule_file whose model factor was not read) a verdict needs the model factor of bridges that were \
         tested to collapse: the reciprocal of what 95 % of further bridges are expected to carry of the prediction of \
         limit analysis with fill as weight and without crushing. Between the limit and the limit times that factor \
         nothing is settled. model_factor in [assess] with its source replaces it, and model_factor = \"tests\" brings it \
         into every check of strength. docs/verification/model-factor.md lists the tests.";
    COHESION_PRESSED = "A192", "cohesion of joints counts where they are compressed",
        "A joint that turns about its edge is in contact over a length of thrust divided by strength, and open \
         elsewhere. Limit analysis therefore counts cohesion on that part only, as a friction coefficient that is \
         larger by cohesion over compressive strength; without a strength in the file cohesion does not count. A \
         tensile strength is different: it acts along the whole joint as if it never broke, while a real joint breaks \
         permanently. Compare with the load for tensile_strength = \"0 kPa\".";
    RING_JOINT_COPIED = "A193", "the joint between rings has the cohesion of the joints within them",
        "The file describes no [ring_joint], so the joints between rings are those of [joint], with its cohesion and \
         tension. In brick arches the joints between rings fail first, and their mortar is often gone. Describe them \
         in [ring_joint], without cohesion unless an inspection has confirmed it.";
    ONE_PIECE = "A194", "a thick ring in one piece",
        "The ring is thicker than a brick is long and is modelled in one piece. If it consists of brick rings, they \
         can separate: a bridge with separated rings carried a third less than a bonded one (Melbourne and Gilbert \
         1995) [recalled], and this model does not show it. Describe the rings in [[span.ring]] with their \
         [ring_joint]. If stones reach through the whole ring, there is nothing to do.";
    PRESSURE_RANGE = "A195", "fill pressure gives a range, and a verdict uses its lower end",
        "The effect of fill depends on how far its pressure is mobilised, which is not known for any bridge: with half \
         of the passive pressure the prediction is 1.33 times the load of one test and 0.53 times that of another. A \
         result with [fill_pressure] leads with the load by weight alone where that is less, and gives the load with the file's share of the \
         passive pressure and with all of it beside; ultimate checks use the lower end. Along the equilibrium path the movement of the ring decides what is \
         mobilised; its result gives the load by weight alone and that of rigid blocks beside it.";
    PATHS_BROKEN_OFF = "A196", "an equilibrium path broke off",
        "On deformable joints, the path of balanced states could not be followed to its largest load, in a sweep at some positions, or \
         no state was found under self-weight. Where a path broke off, the factor of its last balanced state counts: that load is \
         carried in the model, and more may be. Where no state was found under self-weight, nothing is settled, and the factor is \
         at most that of rigid blocks. Rings that slide on each other are the usual reason. Analyse the position by itself (extrados \
         collapse --method path, or --method dem), or check the stiffness and the friction of the joints.";
    STIFFNESS_TAKEN = "A197", "the stiffness of joints is taken from the modulus of the units",
        "The file gives no stiffness for some joints, and the equilibrium path needs one. The masonry is taken to have a tenth of \
         the modulus of its units, the ratio of Bridgemill's published joints, over the length of the longest voussoir. Joints decide \
         what a flat ring carries: at Bridgemill 132 kN/m with these, 182 with ten times as stiff ones, 231 as rigid blocks. Measure \
         the stiffness, or vary it (extrados vary), and write normal_stiffness and shear_stiffness into [joint] and [ring_joint].";
    STRENGTH_RANGE = "A198", "the load depends on how much of the soil's strength is mobilised",
        "Soil reaches its peak strength only after it has strained, and not everywhere at once: what moves with an arch has \
         mobilised a part of it. How large a part is not known for any bridge. Every load with a continuum therefore comes with a \
         range: the lower bound with half of the strength and the upper bound with all of it. mobilised_share in [continuum] says \
         which share the load of the headline has.";
    SOIL_BEARS_FIRST = "A199", "the soil fails under the load before the arch does",
        "In the mechanism of the upper bound the soil is pushed aside below the load and the rings hardly move. The load is then the \
         bearing capacity of the soil under a rigid plate as long as the load's strip. Surfacing spreads a wheel or a beam further: \
         model it as a layer of its own with its strength, or give the length over which it spreads the load as contact_length, \
         with the reason. The arch by itself may carry more.";
    SOIL_FALLS = "A200", "soil and rings do not carry their own weight",
        "No stresses within strength were found that carry the weight of the soil and of the blocks. Steep soil without cohesion at \
         free ends (ends = \"free\"), water above the ground behind the abutments, or a ring too thin for its fill are the usual \
         reasons. Give the ends a wall (ends = \"slide\"), cohesion that was measured, or look at the ring by itself (as = \
         \"weight\"). With confinement = \"spandrel-walls\" it may be the walls: thin ones do not hold deep fill by their weight alone.";
    WALLS_GIVE_FIRST = "A201", "spandrel walls tilt or slide outwards before the fill is as strong as in plane strain",
        "Fill bears a load by what holds it sideways. In plane strain that is whatever pressure it needs; spandrel walls hold no more than \
         their weight resists before they tilt about their outer toe or slide on their bed. Here they give first, and the load \
         is that of fill held by no more. Friction between fill and rings, bonding of wall and barrel, ties, and what a wall hands on \
         along the bridge are left out, and they help. Look for bulging, leaning and longitudinal cracks inside the walls.";
    VOIDS = "A202", "what lies over a void is carried to two places as by a beam",
        "A plane model has no relieving arch. Weight over the roof of a [[void]], and the part of a load that would disperse into it, are \
         handed to two places beside it with the same force and moment, as by a simply supported beam. Its roof is not checked: neither its own \
         strength, nor its thrust on what carries it, nor what it weighs more or less than the fill. Check the relieving arch as a bridge of its \
         own, with its own span.";
    MOVABLE_ABUTMENT = "A203", "an abutment can move, and earth pressure at a stated coefficient holds it",
        "The abutment stands on the ground by friction without tension, and the soil behind it presses with a constant horizontal share of its \
         vertical stress. That pressure holds against the arch's thrust: it is there at rest and falls to the active one only where the abutment \
         moves towards the span. Passive resistance, which would need movement into the soil, is never counted; neither is soil in front. The \
         ground does not give: settlement and bearing failure under the toe are left out, so compare the bearing pressure of the reactions with \
         what the ground can take.";
    MEAN_OVER_WIDTH = "A204", "what fills a share of the width is a mean over the width",
        "Internal spandrel walls, and backing over a share of the width, act on every metre of the barrel with their mean weight. In truth the \
         barrel carries more under a wall and less between two, and loads come down through walls, not through voids: check the strip under a wall \
         with the whole density. Friction and bending of the walls themselves are left out.";
    HELD_AGAINST_SLIDING = "A205", "joints that finite elements do not let slide would slide",
        "Joints of finite elements shear elastically and never slide. At each load that was in balance their shear is held against what friction \
         on their compression, and cohesion on their compressed length, hold. Where it is more, the joint would slide there, and loads above the one \
         that is named may be too high: use limit analysis or the equilibrium path, in which joints slide.";
    JAMMED = "A206", "what blocks carry depends on how hard they are jammed",
        "Friction holds blocks only where they are pressed together. Between faces that do not give, blocks may be pressed by nothing but \
         self-stress: a key between two parallel walls holds any load where it was driven in hard, and slips under its own weight where it was \
         not. How hard they were jammed no analysis of rigid blocks can tell, and no load is given. With dilation, as associated friction has \
         it, such blocks wedge themselves as they slide, and seem to lock. Discrete elements begin with blocks that are not jammed; \
         support them by faces that lean against their load, or by what they rest on.";
    HELP_NOT_COUNTED = "A207", "what may come and go helps the bridge, and is not counted",
        "Water in the fill, a support that has moved, the tensile strength and the cohesion of joints, and parapets may help a bridge today and be \
         gone tomorrow: drains are cleared, joints crack, mortar is washed out, walls are taken down. Every analysis is made with and without \
         them, and what is least leads; the message gives both. A joint that has once opened or slid has lost its bond for good, and the bond \
         of a brittle joint is not there all at once along its length. Where the load rests on it, ask what the load without it means for the \
         bridge; a strength that was measured does not change that. Fill pressure is treated alike and told by A195.";
    DOUBTFUL_FILE = "A208", "doubtful values in a file of vehicles or of a rule",
        "Values in the message lie outside what is usual, as axles of 11.5 kN where 11.5 t were meant: a slip of unit makes any bridge strong. Each \
         has a code that `extrados explain` tells more of. The result stands by the file as it is.";
}

/// Warnings of where a load goes at one position: they matter where that position governs.
pub const OF_A_POSITION: [&str; 2] = [SHIFTED_LOAD, GROUND_LOAD];

#[cfg(test)]
mod tests {
    #[test]
    fn codes_are_unique_and_in_order() {
        assert!(findings::Card::are_complete(super::CARDS));
    }
}
