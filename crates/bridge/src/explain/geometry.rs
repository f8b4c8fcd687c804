//! Cards of errors in geometry, loads and plan.

use super::file_card::FileCard;

/// The cards, in the order of their codes.
pub(super) const CARDS: &[FileCard] = &[
    FileCard {
        code: "B201",
        title: "a rise that does not fit its profile",
        meaning: "A segment and a three-centred arch rise by at most half their span, a semicircle by exactly half.",
        why: "Beyond that the curve would lean outwards over its springings; span and rise are probably swapped or in different units.",
        wrong: r#"rise = "12.85 m""#,
        right: r#"rise = "2.85 m""#,
        source: "geometry of the circle",
    },
    FileCard {
        code: "B202",
        title: "haunch circles too large",
        meaning: "The radius of the haunch circles must be less than the rise.",
        why: "With a radius equal to the rise or larger, no crown circle is tangent to both haunch circles.",
        wrong: r#"haunch_radius = "3.5 m""#,
        right: r#"haunch_radius = "1.5 m""#,
        source: "geometry of three-centred arches",
    },
    FileCard {
        code: "B203",
        title: "a pointed arch without a point",
        meaning: "A pointed arch of two arcs centred on the springing line rises by more than half its span.",
        why: "With less rise its two arcs do not meet in a point at the crown.",
        wrong: r#"profile = "pointed"
span = "4.0 m"
rise = "1.9 m""#,
        right: r#"profile = "pointed"
span = "4.0 m"
rise = "3.0 m""#,
        source: "geometry of pointed arches",
    },
    FileCard {
        code: "B204",
        title: "measured points that do not form an intrados",
        meaning: "There are at least three surveyed points, from the left to the right springing, without turning \
                  back, and all others lie above the line between the two ends.",
        why: "Joints are perpendicular to a smooth curve through the points; a wrong point tilts the joints near it.",
        wrong: r#"["12.0 m", "6.45 m"], ["11.5 m", "6.60 m"], ["14.0 m", "6.45 m"]"#,
        right: r#"["12.0 m", "6.45 m"], ["13.0 m", "6.60 m"], ["14.0 m", "6.45 m"]"#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B205",
        title: "a ring thicker than half its span",
        meaning: "The thickness of a ring is less than half its span.",
        why: "A thicker ring would not be an arch; a unit is probably wrong.",
        wrong: r#"thickness = "11.0 m""#,
        right: r#"thickness = "0.711 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B206",
        title: "joints that cross",
        meaning: "The two joints of a voussoir, perpendicular to the intrados, must not meet inside the ring.",
        why: "A block whose sides cross is impossible. This happens only where a measured intrados bends outwards.",
        wrong: r#"["12.7 m", "6.60 m"], ["13.0 m", "6.30 m"], ["13.3 m", "6.60 m"]"#,
        right: r#"["12.0 m", "6.45 m"], ["13.0 m", "6.60 m"], ["14.0 m", "6.45 m"]"#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B207",
        title: "rounding too large for the joint",
        meaning: "Two rounded corners must fit on every joint, and on every voussoir's edge, with some straight face between.",
        why: "Contact points lie one radius inside each edge; with larger radii no face is left between them.",
        wrong: r#"rounding = "0.36 m""#,
        right: r#"rounding = "10 mm""#,
        source: "Rouxinol, Providência and Lemos, section 3.1",
    },
    FileCard {
        code: "B208",
        title: "a contact length longer than the joint",
        meaning: "The length of joint that a contact point represents, fixed or least, is at most the length of the \
                  joint.",
        why: "A joint has two contact points; each represents about half of it.",
        wrong: r#"fixed_length = "0.80 m""#,
        right: r#"fixed_length = "0.3455 m""#,
        source: "Rouxinol, Providência and Lemos, Table 2",
    },
    FileCard {
        code: "B209",
        title: "the wrong number of piers",
        meaning: "There is one pier between every two adjacent spans; a single [[pier]] describes all of them.",
        why: "Without a pier two springings would be at the same point; the position of an extra pier is unknown.",
        wrong: "repeat = 3",
        right: "repeat = 2",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B210",
        title: "a pier too narrow for its rings",
        meaning: "The two skewbacks on a pier must fit side by side on its top. The width of a skewback is the ring \
                  thickness times the cosine of its inclination.",
        why: "Otherwise the voussoirs of neighbouring spans overlap.",
        wrong: r#"width = "0.20 m""#,
        right: r#"width = "0.80 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B211",
        title: "backing above the road",
        meaning: "Backing ends below the road surface.",
        why: "Its height is measured from the springings, not from the foundation.",
        wrong: r#"height = "6.0 m""#,
        right: r#"height = "0.60 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B212",
        title: "too many spans or voussoirs",
        meaning: "More than 200 spans, or 100,000 voussoirs and courses of piers, are not analysed as one structure.",
        why: "A load has an effect over a few spans; more spans only cost time.",
        wrong: "repeat = 300",
        right: "repeat = 2",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B213",
        title: "a spandrel wall that does not fit",
        meaning: "The walls' total thickness is less than the width of the bridge, they stand on the abutments, and \
                  their bricks are larger than their rounded corners.",
        why: "Cut bricks need faces on which they touch, and a wall needs a support below it.",
        wrong: r#"thickness = "44 m""#,
        right: r#"thickness = "0.44 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B214",
        title: "smallest and largest diameter are swapped",
        meaning: "The smallest diameter of the particles is at most the largest.",
        why: "Sizes are spread evenly between the two.",
        wrong: r#"smallest_diameter = "0.19 m""#,
        right: r#"smallest_diameter = "0.12 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B215",
        title: "particles that stick together",
        meaning: "Contacts of particles carry no tension.",
        why: "Fill is soil or rubble. Its cohesion adds to friction while a contact is closed (Rouxinol, Providência and Lemos, Table 2).",
        wrong: r#"tensile_strength = "10 kPa""#,
        right: r#"fixed_length = "0.15 m""#,
        source: "Rouxinol, Providência and Lemos, Table 2",
    },
    FileCard {
        code: "B216",
        title: "bodies of cover without particles",
        meaning: "Layers as blocks and backing as particles need particles around them: at least one layer of the \
                  cover must be modelled as particles.",
        why: "Without particles the cover is weight alone. Bodies in it would carry nothing.",
        wrong: "thickness = \"0.150 m\"\nas = \"blocks\"\nblock_length = \"1 m\"\ndensity = \"2200 kg/m^3\"",
        right: "thickness = \"0.150 m\"\nweighs = false",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B217",
        title: "a drawing in place of a bridge file",
        meaning: "The file is a drawing (DXF). A bridge file is text; a drawing is named in a block model file.",
        why: "A drawing has outlines but no materials, supports or loads: nothing can be computed from it alone.",
        wrong: "extrados collapse bridge.dxf",
        right: "extrados collapse blocks.toml # with [drawing] file = \"bridge.dxf\"",
        source: "the format of block model files",
    },
    FileCard {
        code: "B218",
        title: "a workbook or an archive in place of a bridge file",
        meaning: "The file is a workbook (XLSX, XLS) or an archive (ZIP). A bridge file is text.",
        why: "Its bytes are not text, and the contents of its cells have no meaning here.",
        wrong: "extrados check survey.xlsx",
        right: "extrados check bridge.toml",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B219",
        title: "a continuum on a layer that is none",
        meaning: "Layers that are a continuum are the lowest of the cover. Layers above them are weight or nothing.",
        why: "The continuum rests on the rings and carries what lies on it. A layer of weight alone below it cannot carry it.",
        wrong: "[[cover]]\nlayer = \"fill\"\nthickness = \"0.10 m\"\ndensity = \"1900 kg/m^3\"\n\n[[cover]]\nlayer = \
                \"sub-base\"\nthickness = \"0.30 m\"\ndensity = \"1900 kg/m^3\"\nas = \"continuum\"",
        right: "[[cover]]\nlayer = \"sub-base\"\nthickness = \"0.30 m\"\ndensity = \"1900 kg/m^3\"\nas = \"continuum\"",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B220",
        title: "backing and cover that do not fit together",
        meaning: "Backing that is a continuum lies under cover whose lowest layer is a continuum. Under such cover backing is a \
                  continuum or blocks.",
        why: "The continuum fills the space above the rings. Backing that is weight alone would leave a hole in it, and backing that \
              yields would bear against nothing above its level.",
        wrong: "as = \"weight\"",
        right: "as = \"continuum\"\nfriction_angle = \"40 deg\"\ncohesion = \"50 kPa\"\ntensile_strength = \"10 \
                kPa\"\ncompressive_strength = \"2 MPa\"",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B221",
        title: "a soil without strength",
        meaning: "A continuum has a friction angle or a cohesion.",
        why: "Soil without both is a fluid: it carries no load beside the rings, and no limit load exists.",
        wrong: "friction_angle = \"0 deg\"\ncohesion = \"0 kPa\"",
        right: "friction_angle = \"32 deg\"\ncohesion = \"2 kPa\"",
        source: "the Mohr-Coulomb law",
    },
    FileCard {
        code: "B222",
        title: "a continuum without depth over the crown",
        meaning: "The layers that are a continuum are together at least 10 mm thick over the crown.",
        why: "Loads stand on the continuum. Where it has no depth they would stand on the ring.",
        wrong: "thickness = \"0 m\"\ndensity = \"1900 kg/m^3\"\nas = \"continuum\"",
        right: "thickness = \"0.30 m\"\ndensity = \"1900 kg/m^3\"\nas = \"continuum\"",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B223",
        title: "fill held by walls that are not described",
        meaning: "confinement = \"spandrel-walls\" in [continuum] needs a [spandrel_wall].",
        why: "The fill is as strong as the pressure that holds it sideways allows, and what a wall holds follows from its thickness, its \
              weight and its friction.",
        wrong: "# no [spandrel_wall]",
        right: "[spandrel_wall]\nbrick_length = \"0.60 m\"\nbrick_height = \"0.30 m\"\nthickness = \"0.90 m\"",
        source: "Cavicchi and Gambarotta, two-dimensional limit analysis of masonry arches and fill (2007)",
    },
    FileCard {
        code: "B224",
        title: "a defect where there is nothing that could have it",
        meaning: "A defect lies on a span of the bridge, from a place to one further right, on a ring that the span has.",
        why: "A defect beside the span would take nothing away, and the bridge would seem sound. Rings separate, and stones drop out, only \
              where there are several.",
        wrong: "[[defect]]\nkind = \"lost-mortar\"\nspan = 7",
        right: "[[defect]]\nkind = \"lost-mortar\"\nspan = 1",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B225",
        title: "defects that leave nothing of a ring",
        meaning: "All depths that are lost from a ring at one place leave at least 20 mm of it.",
        why: "Where nothing is left there is no bridge to assess: most often a unit or a digit is wrong.",
        wrong: "depth = \"0.9 m\"",
        right: "depth = \"40 mm\"",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B226",
        title: "a road that cannot lie there",
        meaning: "The levels of a road are points from left to right, and the surface lies above the extrados by the layers that lie on the \
                  fill, or more.",
        why: "Where the road would cut the ring, a level, the datum or a unit is wrong; the weight of the fill, and how far loads spread, \
              depend on the depth.",
        wrong: "springing_level = \"109.80 m\"",
        right: "springing_level = \"99.80 m\"",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B227",
        title: "cases or cracks that do not fit the file",
        meaning: "Cases have names of their own and act with loads of the file, each named once; longitudinal cracks lie within the barrel, \
                  from one edge to the other.",
        why: "A case with a load that is not there would be a lighter case; a crack beside the barrel would divide nothing.",
        wrong: "name = \"tandem at mid-span\"",
        right: "name = \"tandem\"",
        source: "the format of bridge files",
    },
    FileCard {
        code: "B228",
        title: "a square section that is not turned",
        meaning: "The square span of a segmental, semicircular, elliptical, parabolic or three-centred profile is turned into the section \
                  along the road; pointed and measured profiles are given along the road.",
        why: "Which of both a survey measured changes span and shape.",
        wrong: "profile = \"pointed\"\nsquare_span",
        right: "profile = \"segmental\"\nsquare_span",
        source: "geometry of skew barrels",
    },
    FileCard {
        code: "B229",
        title: "springings that no arch of this profile joins",
        meaning: "The springings differ by less than the span, and the intrados rises from both of them. A pointed profile springs from one level.",
        why: "A ring that falls from a springing has no abutment there that it could push; it is a strut, or a ramp.",
        wrong: r#"right_springing = "8.0 m""#,
        right: r#"right_springing = "0.25 m""#,
        source: "geometry of arches between springings at unequal levels",
    },
    FileCard {
        code: "B230",
        title: "a pier whose head is a stair",
        meaning: "The uppermost stone of a pier carries both skewbacks; where their springings differ it is convex.",
        why: "Blocks are convex: a stone with a notch would be two stones, and where it breaks is for the engineer.",
        wrong: r#"step = "1.5 m""#,
        right: r#"step = "0.05 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B231",
        title: "a void that cannot be",
        meaning: "A void has a floor below its roof and its left end before its right one, its roof is carried by one place on each side, and no \
                  two voids lie over one another.",
        why: "What lies over it is handed to these two places as by a beam.",
        wrong: r#"roof = "0.2 m""#,
        right: r#"roof = "2.2 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B232",
        title: "a share of the width that cannot be",
        meaning: "Internal walls together are no thicker than the bridge is wide, and backing over a share of the width is weight or blocks.",
        why: "In a plane model they are means over the width of the barrel.",
        wrong: r#"thickness = "12 m""#,
        right: r#"thickness = "1.2 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B240",
        title: "water that fills no pores",
        meaning: "[water] gives the level of the water in the lowest layer of [[cover]], which weighs or is a continuum, and the density of that \
                  layer with its pores full, no less than its own. The level stands in one place.",
        why: "Water in particles, in what weighs nothing, or in no layer would act on nothing; saturated fill that is lighter would float.",
        wrong: "saturated_density = \"1200 kg/m^3\"",
        right: "saturated_density = \"2050 kg/m^3\"",
        source: "saturated unit weight of soils: dry unit weight plus that of the water in the pores",
    },
    FileCard {
        code: "B242",
        title: "a vehicle that overturns",
        meaning: "Centrifugal force, cant and side force move the resultant of a vehicle by less than half of the track gauge.",
        why: "Beyond it the inner or outer wheel lifts off, and no width of the barrel describes what carries it.",
        wrong: "speed = \"400 km/h\"",
        right: "speed = \"50 km/h\"",
        source: "moments about the middle of the track",
    },
    FileCard {
        code: "B243",
        title: "a block model file in place of a bridge file",
        meaning: "The file lists blocks, or names a drawing of them. A command that asks about a bridge was given it.",
        why: "Vehicles, trains, records and verdicts are about spans, rings and cover, which blocks do not tell.",
        wrong: "extrados assess blocks.toml",
        right: "extrados collapse blocks.toml",
        source: "the format of block model files",
    },
    FileCard {
        code: "B301",
        title: "a load off the bridge",
        meaning: "A load is between the first and the last springing, on an existing span.",
        why: "A load beside the bridge has no effect, and no factor makes it a collapse load.",
        wrong: r#"at = "1/4 of span 3""#,
        right: r#"at = "1/4 of span 1""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B302",
        title: "axles and spacings do not match",
        meaning: "A pattern of axles has one spacing less than it has axles.",
        why: "Every axle needs a position.",
        wrong: r#"axle_spacings = ["1.8 m", "1.8 m"]"#,
        right: r#"axle_spacings = ["1.8 m"]"#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B303",
        title: "an axle wider than the barrel",
        meaning: "The effective width that carries an axle is at most the width of the barrel.",
        why: "A larger width would make the load per metre too small.",
        wrong: r#"effective_width = "12.5 m""#,
        right: r#"effective_width = "2.5 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B304",
        title: "dispersal without depth",
        meaning: "Rules that divide by the depth of the extrados need a cover above the crown.",
        why: "At the crown the pressure would be infinite.",
        wrong: r#"[dispersal]
rule = "inverse-depth"
slope = "2:1"
"#,
        right: r#"[dispersal]
rule = "none"
"#,
        source: "Rouxinol, Providência and Lemos, eq. 2",
    },
    FileCard {
        code: "B305",
        title: "a loading block without a support below it",
        meaning: "A load through a block needs a wall on which the block stands.",
        why: "Cover that is weight alone cannot support the block.",
        wrong: r#"strip = "fill""#,
        right: r#"strip = "wall""#,
        source: "Rouxinol, Providência and Lemos, section 3.4",
    },
    FileCard {
        code: "B401",
        title: "the method needs more data than the file has",
        meaning: "The discrete element method needs stiffnesses and a load step; the series rule needs the moduli of the blocks.",
        why: "Joint stiffness changes the collapse load of Bridgemill by about a tenth; it cannot be assumed.",
        wrong: r#"[joint]
shear_stiffness = "0.573 GPa/m""#,
        right: r#"[joint]
normal_stiffness = "4.84 GPa/m"
shear_stiffness = "0.573 GPa/m""#,
        source: "Rouxinol, Providência and Lemos, eq. 1",
    },
    FileCard {
        code: "B402",
        title: "nothing to analyse",
        meaning: "The analysis of a load needs a [[load]], that of a support movement a [support_movement]. A file with a [passage] or a \
                  [sweep] and no [analysis] plans none of them and needs neither.",
        why: "Without one there is no load or movement to increase until collapse.",
        wrong: "# no load",
        right: r#"[[load]]
kind = "knife-edge"
force = "100 kN"
length = "0.3 m"
position = "2.0 m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B403",
        title: "a support movement without direction",
        meaning: "At least one of `horizontal`, `vertical` and `rotation` is not zero.",
        why: "A support that does not move cannot cause a collapse.",
        wrong: r#"horizontal = 0.0
vertical = 0.0
rotation = "0 deg/m""#,
        right: r#"horizontal = 1.0
vertical = -0.5
rotation = "0.5 deg/m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B404",
        title: "no such support",
        meaning: r#"Supports are "left abutment", "pier 1" and so on from the left, and "right abutment"."#,
        why: "Only an existing support can move.",
        wrong: r#"support = "pier 5""#,
        right: r#"support = "pier 1""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B405",
        title: "steps larger than their limit",
        meaning: "For a load or a movement, the resolution is smaller than the step, and the step smaller than the \
                  limit.",
        why: "Otherwise the first step would exceed the limit, or the refinement would be coarser than the steps.",
        wrong: r#"load_step = "5 MN/m""#,
        right: r#"load_step = "5 kN/m""#,
        source: "the format of bridge files",
    },
    FileCard {
        code: "B406",
        title: "a strip that the bridge does not have",
        meaning: "The strip \"wall\" needs a [spandrel_wall], and both strips together are analysed for a load only.",
        why: "Without a wall both strips are the same.",
        wrong: r#"analysis = "thickness"
strip = "both""#,
        right: r#"analysis = "load"
strip = "wall""#,
        source: "the format of bridge files",
    },
];
