//! Spandrel walls, and whether they fit the bridge.

use super::material::joint;
use crate::card::Section;
use crate::cards::*;
use crate::choice::choice;
use crate::findings::Findings;
use crate::model::{Abutment, CoursesFrom, Joint, Masonry, SpandrelWall};
use crate::tree::Table;
use crate::values::read;

choice! {
    /// How courses are shifted.
    enum Bond {
        /// every other course is shifted by half a brick
        Half = "half",
        /// every other course is shifted by a third of a brick
        Third = "third",
        /// head joints are above one another
        Stack = "stack",
    }
}

pub(super) static SPANDREL_WALL: Section = Section {
    path: "spandrel_wall",
    doc: "Spandrel walls of coursed masonry that stand on the rings. Bricks are cut along the backs of the voussoirs; all \
          walls of the bridge are taken together.",
    fields: &[
        length("brick_length", "length of a brick with its joint", "0.60 m").positive(),
        length("brick_height", "height of a course with its joint", "0.40 m").positive(),
        length("thickness", "thickness of all walls together across the bridge", "0.44 m").positive(),
        word::<Bond>("bond", "how courses are shifted", "half").default(Bond::Half.word()),
        density("density", "mass density of the wall", "2100 kg/m^3").positive().optional("as [masonry] says"),
        length("rounding", "radius of the bricks' rounded corners", "10 mm")
            .at_least(0.0)
            .optional("as [masonry] says"),
        length("top", "level of the wall's top above the highest crown's extrados", "0.478 m")
            .positive()
            .optional("the road surface"),
        length("extent", "how far the wall reaches behind the outer springings, measured at the extrados", "1.5 m")
            .positive()
            .optional("to the backs of the abutments"),
        flag("end_walls", "whether fixed walls stand at both ends", "false").default("false"),
        word::<CoursesFrom>("courses_from", "where courses are counted from", "top").default(CoursesFrom::Top.word()),
        length(
            "head_joint",
            "place of a head joint of the uppermost course, from the left springing of the first span",
            "9.15 m",
        )
        .optional("the middle of the bridge"),
        count(
            "loaded_bricks",
            "how many bricks of the uppermost course carry a load, those nearest to its middle",
            "2",
        )
        .between(1.0, 100.0)
        .optional("the bricks under the load, each by its loaded length"),
        number(
            "least_piece",
            "share of a brick or a voussoir's back below which no piece of a cut brick is left",
            "0.25",
        )
        .between(0.05, 0.5)
        .default("0.25"),
    ],
};

/// What the wall takes from other parts of the file.
pub(crate) struct Parts<'a> {
    pub(crate) width: Option<f64>,
    pub(crate) masonry: Option<&'a Masonry>,
    pub(crate) joint: Option<&'a Joint>,
    pub(crate) abutments: Option<&'a [Abutment; 2]>,
}

/// The walls; `None` inside where the file has none.
pub(crate) fn spandrel_wall(
    file: &Table<'_>,
    parts: &Parts<'_>,
    findings: &mut Findings,
) -> Option<Option<SpandrelWall>> {
    let own = if file.has("wall_joint") { Some(joint(file, "wall_joint", findings)) } else { None };
    if !file.has("spandrel_wall") {
        if file.has("wall_joint") {
            findings.error(
                "B213",
                file.known("wall_joint").map_or(file.range, |table| table.range),
                "there is no spandrel wall for these joints",
                "joints of a wall that the file does not describe",
                "describe the wall with [spandrel_wall], or remove [wall_joint]",
            );
        }
        return Some(None);
    }
    let table = &file.table("spandrel_wall", findings)?;
    let bond = table.read("bond", findings);
    let [density, rounding] = ["density", "rounding"].map(|key| table.read::<Option<f64>>(key, findings));
    let (density, rounding) = (density?, rounding?);
    // A contact point of a ring joint stands for half the ring's thickness; that of a wall's joint for half its own.
    let inherited = || parts.joint.map(|joint| Joint { fixed_length: None, least_length: None, ..*joint });
    let wall = read!(
        table,
        findings,
        SpandrelWall {
            brick_length,
            brick_height,
            thickness,
            top,
            extent,
            end_walls,
            courses_from,
            head_joint,
            loaded_bricks,
            least_piece;
            bond: Bond::shift(bond?),
            density: density.or(parts.masonry.map(|masonry| masonry.density))?,
            rounding: rounding.or(parts.masonry.map(|masonry| masonry.rounding))?,
            joint: match own {
                Some(own) => own?,
                None => inherited()?,
            },
        }
    )?;
    fits(table, &wall, parts, findings);
    Some(Some(wall))
}

impl Bond {
    /// Share of a brick by which every other course is shifted.
    fn shift(self) -> f64 {
        match self {
            Bond::Half => 0.5,
            Bond::Third => 1.0 / 3.0,
            Bond::Stack => 0.0,
        }
    }
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
