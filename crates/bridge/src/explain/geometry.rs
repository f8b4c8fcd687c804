//! Cards of errors in geometry, loads and plan.

use super::Card;

/// The cards, in the order of their codes.
pub(super) const CARDS: &[Card] = &[
    Card {
        code: "B201",
        title: "a rise that does not fit its profile",
        meaning: "A segment and a three-centred arch rise by at most half their span, a semicircle by exactly half.",
        why: "Beyond that the curve would lean outwards over its springings; span and rise are probably swapped or in different units.",
        wrong: r#"rise = "12.85 m""#,
        right: r#"rise = "2.85 m""#,
        source: "geometry of the circle",
    },
    Card {
        code: "B202",
        title: "haunch circles too large",
        meaning: "The radius of the haunch circles must be less than the rise.",
        why: "With a radius of the rise or more no circle for the crown touches both.",
        wrong: r#"haunch_radius = "3.5 m""#,
        right: r#"haunch_radius = "1.5 m""#,
        source: "geometry of three-centred arches",
    },
    Card {
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
    Card {
        code: "B204",
        title: "measured points that are no intrados",
        meaning: "Surveyed points run from the left to the right springing, at least three of them, the ends level within 1 mm, all others above, without turning back.",
        why: "A smooth curve is drawn through them, to which joints are perpendicular; a stray point tilts its joints.",
        wrong: r#"["12.0 m", "6.45 m"], ["11.5 m", "6.60 m"], ["14.0 m", "6.45 m"]"#,
        right: r#"["12.0 m", "6.45 m"], ["13.0 m", "6.60 m"], ["14.0 m", "6.45 m"]"#,
        source: "the format of bridge files",
    },
    Card {
        code: "B205",
        title: "a ring thicker than half its span",
        meaning: "The thickness of a ring is less than half its span.",
        why: "That is a block with a hole, not an arch; a unit is probably wrong.",
        wrong: r#"thickness = "11.0 m""#,
        right: r#"thickness = "0.711 m""#,
        source: "the format of bridge files",
    },
    Card {
        code: "B206",
        title: "joints that cross",
        meaning: "The two joints of a voussoir, perpendicular to the intrados, must not meet inside the ring.",
        why: "A block whose sides cross is no block. It happens only where a measured intrados bends outwards.",
        wrong: r#"["12.7 m", "6.60 m"], ["13.0 m", "6.30 m"], ["13.3 m", "6.60 m"]"#,
        right: r#"["12.0 m", "6.45 m"], ["13.0 m", "6.60 m"], ["14.0 m", "6.45 m"]"#,
        source: "the format of bridge files",
    },
    Card {
        code: "B207",
        title: "rounding that eats the joint",
        meaning: "Two rounded corners must fit on every joint, and on every voussoir's edge, with some straight face between.",
        why: "Contact points lie one radius inside each edge; with larger radii none are left.",
        wrong: r#"rounding = "0.36 m""#,
        right: r#"rounding = "10 mm""#,
        source: "Rouxinol, Providência and Lemos, section 3.1",
    },
    Card {
        code: "B208",
        title: "a contact length longer than the joint",
        meaning: "The length that a contact point stands for, fixed or least, is at most the joint's.",
        why: "Two contact points share a joint; each stands for about half of it.",
        wrong: r#"fixed_length = "0.80 m""#,
        right: r#"fixed_length = "0.3455 m""#,
        source: "Rouxinol, Providência and Lemos, Table 2",
    },
    Card {
        code: "B209",
        title: "the wrong number of piers",
        meaning: "Between each two spans stands one pier; one [[pier]] alone stands for all.",
        why: "Without a pier two springings would share one point, with one too many its place is unknown.",
        wrong: "repeat = 3",
        right: "repeat = 2",
        source: "the format of bridge files",
    },
    Card {
        code: "B210",
        title: "a pier too narrow for its rings",
        meaning: "The two skewbacks on a pier, thickness times the lean of the springing, must fit side by side on its top.",
        why: "Otherwise the voussoirs of neighbouring spans overlap.",
        wrong: r#"width = "0.20 m""#,
        right: r#"width = "0.80 m""#,
        source: "the format of bridge files",
    },
    Card {
        code: "B211",
        title: "backing above the road",
        meaning: "Backing ends below the road surface.",
        why: "Its height is measured from the springings, not from the foundation.",
        wrong: r#"height = "6.0 m""#,
        right: r#"height = "0.60 m""#,
        source: "the format of bridge files",
    },
    Card {
        code: "B212",
        title: "too many spans or voussoirs",
        meaning: "More than 200 spans or 100,000 voussoirs are not analysed as one structure.",
        why: "A load is felt a few spans away; the rest only costs time.",
        wrong: "repeat = 300",
        right: "repeat = 2",
        source: "the format of bridge files",
    },
    Card {
        code: "B213",
        title: "a spandrel wall that does not fit",
        meaning: "Walls are thinner than the bridge is wide, stand on the abutments, and their bricks are larger than their rounded corners.",
        why: "Pieces of cut bricks need faces to touch with, and a wall needs something below it.",
        wrong: r#"thickness = "44 m""#,
        right: r#"thickness = "0.44 m""#,
        source: "the format of bridge files",
    },
    Card {
        code: "B214",
        title: "diameters the wrong way round",
        meaning: "The smallest diameter of the particles is at most the largest.",
        why: "Sizes are spread evenly between the two.",
        wrong: r#"smallest_diameter = "0.19 m""#,
        right: r#"smallest_diameter = "0.12 m""#,
        source: "the format of bridge files",
    },
    Card {
        code: "B215",
        title: "particles that stick together",
        meaning: "Contacts of particles carry no tension.",
        why: "Fill is soil or rubble. Its cohesion adds to friction while a contact is closed (Rouxinol, Providência and Lemos, Table 2).",
        wrong: r#"tensile_strength = "10 kPa""#,
        right: r#"fixed_length = "0.15 m""#,
        source: "Rouxinol, Providência and Lemos, Table 2",
    },
    Card {
        code: "B216",
        title: "bodies of cover without particles",
        meaning: "Layers that are blocks, and backing that is particles, stand among particles: at least one layer of the cover must be modelled so.",
        why: "Without particles the cover is weight alone. What is described as bodies would carry nothing, and slabs would not even weigh.",
        wrong: "thickness = \"0.150 m\"\nas = \"blocks\"\nblock_length = \"1 m\"\ndensity = \"2200 kg/m^3\"",
        right: "thickness = \"0.150 m\"\nweighs = false",
        source: "the format of bridge files",
    },
    Card {
        code: "B217",
        title: "a drawing in the place of a bridge file",
        meaning: "The file is a drawing (DXF). A bridge file is text; a drawing is named in a block model file.",
        why: "A drawing has outlines and no materials, supports or loads: nothing can be computed from it alone.",
        wrong: "extrados collapse bridge.dxf",
        right: "extrados collapse blocks.toml # with [drawing] file = \"bridge.dxf\"",
        source: "the format of block model files",
    },
    Card {
        code: "B218",
        title: "a workbook or an archive in the place of a bridge file",
        meaning: "The file is a workbook (XLSX, XLS) or an archive (ZIP). A bridge file is text.",
        why: "Its bytes are no text, and what is in its cells has no meaning here.",
        wrong: "extrados check survey.xlsx",
        right: "extrados check bridge.toml",
        source: "the format of bridge files",
    },
    Card {
        code: "B301",
        title: "a load off the bridge",
        meaning: "A load stands between the first and the last springing, on a span that there is.",
        why: "A load beside the bridge does nothing, and no factor makes it a collapse load.",
        wrong: r#"at = "1/4 of span 3""#,
        right: r#"at = "1/4 of span 1""#,
        source: "the format of bridge files",
    },
    Card {
        code: "B302",
        title: "axles and spacings do not match",
        meaning: "A pattern of axles has one spacing fewer than axles.",
        why: "Every axle needs a place.",
        wrong: r#"axle_spacings = ["1.8 m", "1.8 m"]"#,
        right: r#"axle_spacings = ["1.8 m"]"#,
        source: "the format of bridge files",
    },
    Card {
        code: "B303",
        title: "an axle wider than the barrel",
        meaning: "The effective width that carries an axle is at most the width of the barrel.",
        why: "More width than there is would make the load per metre too small.",
        wrong: r#"effective_width = "12.5 m""#,
        right: r#"effective_width = "2.5 m""#,
        source: "the format of bridge files",
    },
    Card {
        code: "B304",
        title: "dispersal without depth",
        meaning: "Rules that divide by the depth of the extrados need a cover above the crown.",
        why: "At the crown they would put an infinite pressure.",
        wrong: r#"[dispersal]
rule = "inverse-depth"
slope = "2:1"
"#,
        right: r#"[dispersal]
rule = "none"
"#,
        source: "Rouxinol, Providência and Lemos, eq. 2",
    },
    Card {
        code: "B305",
        title: "a loading block with nothing below it",
        meaning: "A load through a block needs a wall on which the block stands.",
        why: "Cover that is weight alone has no surface: the block would hang in the air.",
        wrong: r#"strip = "fill""#,
        right: r#"strip = "wall""#,
        source: "Rouxinol, Providência and Lemos, section 3.4",
    },
    Card {
        code: "B401",
        title: "the method needs more than the file says",
        meaning: "The discrete element method needs stiffnesses and a load step; the series rule needs the moduli of the blocks.",
        why: "Joint stiffness decides about a tenth of the collapse load of Bridgemill; it cannot be assumed.",
        wrong: r#"[joint]
shear_stiffness = "0.573 GPa/m""#,
        right: r#"[joint]
normal_stiffness = "4.84 GPa/m"
shear_stiffness = "0.573 GPa/m""#,
        source: "Rouxinol, Providência and Lemos, eq. 1",
    },
    Card {
        code: "B402",
        title: "nothing to analyse",
        meaning: "The analysis of a load needs a [[load]], that of a support movement a [support_movement]. A file with a [passage] or a \
                  [sweep] and no [analysis] plans none of them and needs neither.",
        why: "Without it there is nothing to raise until the bridge collapses.",
        wrong: "# no load",
        right: r#"[[load]]
kind = "knife-edge"
force = "100 kN"
length = "0.3 m"
position = "2.0 m""#,
        source: "the format of bridge files",
    },
    Card {
        code: "B403",
        title: "a support movement without direction",
        meaning: "At least one of `horizontal`, `vertical` and `rotation` is other than zero.",
        why: "A support that stays where it is brings nothing down.",
        wrong: r#"horizontal = 0.0
vertical = 0.0
rotation = "0 deg/m""#,
        right: r#"horizontal = 1.0
vertical = -0.5
rotation = "0.5 deg/m""#,
        source: "the format of bridge files",
    },
    Card {
        code: "B404",
        title: "no such support",
        meaning: r#"Supports are "left abutment", "pier 1" and so on from the left, and "right abutment"."#,
        why: "A movement must be given to a support that there is.",
        wrong: r#"support = "pier 5""#,
        right: r#"support = "pier 1""#,
        source: "the format of bridge files",
    },
    Card {
        code: "B405",
        title: "steps larger than their limit",
        meaning: "Resolution, step and limit of a load or movement must grow in this order.",
        why: "The first step would pass the limit, or refining would be coarser than stepping.",
        wrong: r#"load_step = "5 MN/m""#,
        right: r#"load_step = "5 kN/m""#,
        source: "the format of bridge files",
    },
    Card {
        code: "B406",
        title: "a strip that the bridge does not have",
        meaning: "The strip \"wall\" needs a [spandrel_wall], and both strips together are analysed for a load only.",
        why: "Without a wall the strip below it is the same as that between the walls.",
        wrong: r#"analysis = "thickness"
strip = "both""#,
        right: r#"analysis = "load"
strip = "wall""#,
        source: "the format of bridge files",
    },
];
