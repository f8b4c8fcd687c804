//! Spandrel walls, and whether they fit the bridge.

use crate::findings::Findings;
use crate::model::{Abutment, CoursesFrom, Joint, Masonry, SpandrelWall};
use crate::tree::Table;

use super::materials::{joint, maybe};

/// What the wall takes from other parts of the file.
pub(super) struct Parts<'a> {
    pub(super) width: Option<f64>,
    pub(super) masonry: Option<&'a Masonry>,
    pub(super) joint: Option<&'a Joint>,
    pub(super) abutments: Option<&'a [Abutment; 2]>,
}

/// The walls; `None` inside where the file has none.
pub(super) fn spandrel_wall(
    file: &Table<'_>,
    parts: &Parts<'_>,
    findings: &mut Findings,
) -> Option<Option<SpandrelWall>> {
    let own = if file.has("wall_joint") { Some(joint(file, "wall_joint", findings)) } else { None };
    if !file.has("spandrel_wall") {
        if file.has("wall_joint") {
            let mut unheard = Findings::default();
            let range = file.table("wall_joint", &mut unheard).map_or(file.range, |table| table.range);
            findings.error(
                "B213",
                range,
                "there is no spandrel wall for these joints",
                "joints of a wall that the file does not describe",
                "describe the wall with [spandrel_wall], or remove [wall_joint]",
            );
        }
        return Some(None);
    }
    let table = file.table("spandrel_wall", findings)?;
    let brick_length = table.quantity("brick_length", findings);
    let brick_height = table.quantity("brick_height", findings);
    let thickness = table.quantity("thickness", findings);
    let bond = table.word("bond", findings);
    let density = table.quantity("density", findings);
    let rounding = table.quantity("rounding", findings);
    let top = table.quantity("top", findings);
    let extent = table.quantity("extent", findings);
    let end_walls = table.flag("end_walls", findings);
    let courses_from = table.word("courses_from", findings);
    let head_joint = table.quantity("head_joint", findings);
    let loaded_bricks = table.count("loaded_bricks", findings);
    let least_piece = table.number("least_piece", findings);
    let given_density = maybe(&table, "density", density)?;
    let given_rounding = maybe(&table, "rounding", rounding)?;
    // A contact point of a ring joint stands for half the ring's thickness; that of a wall's joint for half its own.
    let inherited = || parts.joint.map(|joint| Joint { fixed_length: None, least_length: None, ..*joint });
    let wall = SpandrelWall {
        brick_length: brick_length?.value,
        brick_height: brick_height?.value,
        thickness: thickness?.value,
        bond: match maybe(&table, "bond", bond)? {
            Some("stack") => 0.0,
            Some("third") => 1.0 / 3.0,
            _ => 0.5,
        },
        density: given_density.or(parts.masonry.map(|masonry| masonry.density))?,
        rounding: given_rounding.or(parts.masonry.map(|masonry| masonry.rounding))?,
        joint: match own {
            Some(own) => own?,
            None => inherited()?,
        },
        top: maybe(&table, "top", top)?,
        extent: maybe(&table, "extent", extent)?,
        end_walls: maybe(&table, "end_walls", end_walls)?.unwrap_or(false),
        courses_from: match maybe(&table, "courses_from", courses_from)? {
            Some("springings") => CoursesFrom::Springings,
            _ => CoursesFrom::Top,
        },
        head_joint: maybe(&table, "head_joint", head_joint)?,
        loaded_bricks: maybe(&table, "loaded_bricks", loaded_bricks)?.map(|count| count as usize),
        least_piece: maybe(&table, "least_piece", least_piece)?.unwrap_or(0.25),
    };
    fits(&table, &wall, parts, findings);
    Some(Some(wall))
}

fn fits(table: &Table<'_>, wall: &SpandrelWall, parts: &Parts<'_>, findings: &mut Findings) {
    if let Some(width) = parts.width
        && wall.thickness >= width
    {
        findings.error(
            "B213",
            table.place("thickness"),
            "the walls are as thick as the bridge is wide",
            format!("the barrel is {width} m wide"),
            "give the thickness of all walls together, less than the width",
        );
    }
    // No piece is thinner than this where voussoirs are no shorter than bricks.
    let least = wall.least_piece * wall.brick_height.min(wall.brick_length);
    if 2.0 * wall.rounding >= least {
        let place = if table.has("rounding") { table.place("rounding") } else { table.place("brick_height") };
        findings.error(
            "B213",
            place,
            "rounded corners leave nothing of the smallest pieces of cut bricks",
            format!("twice the rounding is no less than the least piece, {least:.4} m"),
            "give a smaller `rounding` or a larger `least_piece` in [spandrel_wall]",
        );
    }
    if let (Some(extent), Some(abutments)) = (wall.extent, parts.abutments) {
        let shortest = abutments[0].top_width.min(abutments[1].top_width);
        if extent > shortest {
            findings.error(
                "B213",
                table.place("extent"),
                "the wall reaches beyond the abutments",
                format!("the shorter abutment's upper face has {shortest} m"),
                "give a larger `top_width` in [abutment], on which the wall stands, or a smaller `extent`",
            );
        }
    }
}
