//! What a code of a finding means.

findings::cards! {
    "D101", "not a readable drawing",
        "The file is empty, binary, incomplete, or not a DXF file; or it has no outline or circle. Save the drawing as \
         DXF with text (ASCII), version R2000 or later, with the outlines of the blocks in model space.";
    "D102", "the unit of the drawing is not known",
        "The header of a DXF file gives the unit in $INSUNITS. Without it a bridge of 18 m might be one of 18 mm, so \
         nothing is assumed: state unit = \"mm\" in [drawing], or --unit mm with `extrados convert`.";
    "D103", "an entity has values that cannot be read",
        "A coordinate is missing, not a number or infinite, or a spline has knots or weights that do not define a \
         curve. The drawing is refused, because a block would be missing. Draw the entity again.";
    "D104", "entities left out",
        "Texts, dimensions, hatches, points, solids and similar entities are not outlines. They are counted by layer \
         and kind and left out, and so are single open lines, as of levels and loads, on a layer that has no outline beside layers \
         that have some. If one of them is meant to be a block, draw its outline as a closed polyline. Layers \
         with role = \"ignore\" are not read.";
    "D105", "an entity outside the plane",
        "The model is plane: everything is drawn at z = 0 and seen from above (a mirror image, extrusion direction (0, 0, -1), is \
        turned back). Heights up to the gap tolerance pass. Move the entity into the plane, or project the drawing.";
    "D106", "more than a drawing of a bridge holds",
        "Files above 64 MB, more than 200 000 entities or 5000 layers, references that multiply without end, outlines \
         of thousands of points, and coordinates beyond 1000 km are not a drawing of blocks, and may be meant to do \
         harm. Export only the outlines, near the origin.";
    "D107", "a block reference that cannot be expanded",
        "The block is not in the file (an external reference that was not bound), refers to itself, lies too deep inside others, or \
        is inserted with a scale of zero. Bind or explode the reference before the export.";
    "D108", "two units for one drawing",
        "The header names a unit and the model file, or --unit, another. The stated one is used. Take it out if the header is right.";
    "D109", "entities that the drawing does not show",
        "Entities on layers that are off or frozen, entities that are marked invisible, and paper space are left out, counted by layer: what \
        nobody sees in the drawing becomes no block. A block reference on a frozen layer is left out whole; of one on a layer that is off, \
        what lies on other layers is read. Switch the layer on, or give it role = \"ignore\".";
    "D110", "a spline by fit points",
        "The spline gives the points that it passes through and no control points. It is read as the cubic with continuous curvature through them, \
        with the length of chords as parameter, its tangents where they are given and no curvature at the ends where they are not. The message \
        says how far a curve by another usual parameter (the root of that length) lies from it between the points.";
    "D111", "a header that contradicts its unit",
        "$INSUNITS names the unit of the drawing. $MEASUREMENT (English or metric patterns) and $LUNITS (lengths shown in feet and inches) belong to \
        another: one of them was not set by whoever drew. $INSUNITS is taken; check a known length, and state unit = \"mm\" in [drawing] or --unit mm \
        if it is wrong.";
    "D201", "duplicate points removed",
        "Points less than a micrometre apart are one corner. Nothing has to be done.";
    "D202", "points on straight edges dropped",
        "A point within a micrometre of the line between its neighbours is not a corner. Nothing has to be done.";
    "D203", "curves made into chords",
        "Blocks have straight edges. Arcs, bulges, ellipses and splines become chords that lie no farther from the curve than \
        chord_tolerance, a millimetre unless it is stated. The ends of a curve stay where they are.";
    "D204", "a gap closed",
        "Two ends within gap_tolerance of one another were joined in the middle of the gap. Check that they are meant \
         to meet.";
    "D205", "lines and arcs chained",
        "Loose lines and arcs of one layer whose ends meet became one closed outline. Nothing has to be done.";
    "D206", "a clockwise outline turned",
        "Outlines run counter-clockwise. Nothing has to be done.";
    "D207", "a concave outline cut into pieces",
        "Blocks are convex. With concave = \"cut\" a concave outline is cut along its diagonals, and each piece is a block of its own: \
        the cuts open and slide like the other joints of that material, so the model is weaker than one solid stone.";
    "D301", "an outline that is not closed",
        "A chain of lines ends without meeting its start, or three and more ends of a layer meet in one point, so that \
         it is not clear which belong together. Close the outline, or draw each block as a closed polyline; a larger \
         gap_tolerance closes larger gaps.";
    "D302", "an outline that crosses itself",
        "The outline of a block runs around it once. The message names the first crossing.";
    "D303", "a concave outline",
        "Blocks are convex: contacts between them are found by their edges. A voussoir whose intrados is drawn as an arc is concave by \
        the sagitta of that arc: a chord_tolerance at least as large makes one chord of it. Otherwise cut the block in two in the \
        drawing, or state concave = \"cut\".";
    "D304", "an outline without area",
        "The corners lie on one line, or a radius is zero. Take the entity out.";
    "D305", "outlines that overlap",
        "Two blocks cannot overlap, except by rounding: by a hundred-thousandth of the smaller one's half diagonal. \
         The same outline drawn twice is reported as such.";
    "D401", "a layer that no entry maps",
        "Every layer of the drawing with outlines or circles has a [[drawing.layer]] that says what is on it: role = \"block\", \
        \"support\" or \"particles\" with a material, or role = \"ignore\". The message shows the lines to add.";
    "D402", "a layer that is not in the drawing",
        "A [[drawing.layer]] names a layer on which nothing is drawn. Names are not case-sensitive, but must otherwise \
         be the same.";
    "D403", "circles and outlines on the wrong layer",
        "Circles stand for particles, outlines for blocks and supports. A circle on a layer of blocks, or an outline \
         on a layer of particles, is most likely on the wrong layer. Draw a round block as a polygon.";
    "D404", "a load that finds no block",
        "A load at a point acts on the block that holds this point, or on whose edge it lies. If there is none, or \
         only a support, the load would have no effect. The message names the nearest block.";
    "D405", "the model cannot be built",
        "The outlines are valid, but do not form a model: there is no free block, a rounding leaves nothing of an \
         edge, a block file names a block twice, or the chosen analysis needs an arch.";
    "D406", "particles need discrete elements",
        "Limit analysis has blocks only. A model with circles on layers with role = \"particles\" is analysed with \
         method = \"dem\" and a load_step; role = \"ignore\" leaves the circles out.";
    "D407", "circles drawn over other bodies",
        "Particles touch, or overlap slightly where they press on one another. A circle that overlaps another, or a \
         block, by more than a tenth of the smaller radius would be thrown out when the run starts.";
    "D408", "particles that stick or crush",
        "Contacts of particles carry no tension and do not crush. Give particles a material of their own with a [[joint]] whose \
        tensile_strength is zero; the compressive strength of that material is not used.";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cards_are_complete_and_in_order() {
        assert!(findings::Card::are_complete(CARDS));
        assert!(CARDS.iter().all(|card| card.text.len() > 40));
    }
}
