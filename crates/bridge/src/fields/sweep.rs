//! Vehicles that are moved over the bridge, and fill that helps.

use crate::card::{Section, joined};
use crate::cards::*;
use crate::diagnostic::TextRange;
use crate::findings::Findings;
use crate::model::{Carriageway, FillPressure, SweepPlan};
use crate::tree::{At, Table};

pub(super) static SWEEP: Section = Section {
    path: "sweep",
    doc: "Vehicles that `extrados collapse --sweep` moves over the bridge by limit analysis: every position, both \
          directions, every group of neighbouring axles, with the factors of a rule on loads and weights. Vehicles and \
          rules of the library are listed in docs/theory/load-rules.md.",
    fields: &joined::<13>(&[
        SweepPlan::CARDS,
        &[flag("confirm", "the former name of `discrete_elements`", "true").default("false")],
    ]),
};

pub(super) static CARRIAGEWAY: Section = Section {
    path: "carriageway",
    doc: "Possible positions of vehicles of [sweep] across the bridge. In a plane model they determine the width of \
          the barrel that carries one vehicle: two abreast share the width between them, and for one at the edge the \
          width beyond it is missing. The worst arrangement counts.",
    fields: &joined::<12>(&[
        Carriageway::CARDS,
        &[
            length(
                "track_offset",
                "distance of the middle of the outermost track or lane from the middle of the barrel, where vehicles keep to it; in place of \
                 `edge_distance`",
                "0.6 m",
            )
            .at_least(0.0)
            .optional("as `edge_distance` says"),
            length(
                "track_gauge",
                "distance between the middles of both rails, or of wheels on an axle, for `track_offset`, `cant` and forces across",
                "1.5 m",
            )
            .positive()
            .optional("1.5 m"),
            length("curve_radius", "radius of the curve on which vehicles run", "300 m")
                .positive()
                .optional("straight: no centrifugal force"),
            speed("speed", "speed on that curve, for the centrifugal force", "60 km/h")
                .at_least(0.0)
                .optional("needed where there is a `curve_radius`"),
            length("cant", "level of the outer rail above the inner one", "90 mm").at_least(0.0).optional("no cant"),
            number(
                "side_force",
                "force across the bridge as a share of every axle, to either side: wind on the vehicle, as the rule asks",
                "0.05",
            )
            .between(0.0, 1.0)
            .optional("none"),
            length("side_force_height", "height above rail or road at which centrifugal and side forces act", "1.8 m")
                .at_least(0.0)
                .optional("1.8 m"),
        ],
    ]),
};

pub(super) static FILL_PRESSURE: Section = Section {
    path: "fill_pressure",
    doc: "Horizontal pressure of the fill on the rings' backs in limit analysis and along the equilibrium path: between the \
          pressure at rest and a share of Rankine's passive pressure. In limit analysis all of that share is there where a back \
          moves against the fill; along the path it grows with the movement. docs/theory/fill-pressure.md gives the sources of \
          the shares. The discrete element method does not use this table: particles exert pressure themselves.",
    fields: FillPressure::CARDS,
};

/// The sweep that the file asks for.
pub(crate) fn sweep(table: &Table<'_>, findings: &mut Findings) -> Option<SweepPlan> {
    if table.has("rule") && table.has("rule_file") {
        table.exclude::<()>("rule", "`rule_file`", findings);
    }
    SweepPlan::of(table, findings)
}

/// Beyond this skew [rad] a square model says nothing that a verdict may rest on.
pub const DOUBTFUL_SKEW: f64 = 10.0 * std::f64::consts::PI / 180.0;

/// Where vehicles may stand across a barrel so wide [m].
pub(crate) fn carriageway(table: &Table<'_>, width: Option<f64>, findings: &mut Findings) -> Option<Carriageway> {
    let skew: Option<Option<At<f64>>> = table.read("skew", &mut Findings::default());
    if let Some(At { value, range }) = skew.flatten() {
        doubt(value, range, findings);
    }
    let offset: Option<Option<f64>> = table.read("track_offset", findings);
    let found = Carriageway::of(table, findings);
    if table.has("edge_distance") && table.has("track_offset") {
        table.exclude::<()>("edge_distance", "`track_offset`", findings);
    }
    let mut found = found?;
    let gauge = found.sideways.gauge;
    if let (Some(width), Some(offset)) = (width, offset?) {
        let edge = 0.5 * (width - gauge) - offset;
        if edge < 0.0 {
            findings.error(
                "B660",
                table.place("track_offset"),
                "the outer rail or wheel stands beside the barrel",
                format!("the barrel is {width} m wide, and rails or wheels are {gauge} m apart"),
                format!("write an offset of at most {:.3} m", (0.5 * (width - gauge)).max(0.0)),
            );
        }
        found.edge_distance = Some(edge.max(0.0));
    }
    if let (Some(width), Some(edge)) = (width, found.edge_distance)
        && edge > 0.5 * width
    {
        findings.error(
            "B660",
            table.place("edge_distance"),
            "the nearest wheel stands beyond the middle of the barrel",
            format!("the barrel is {width} m wide"),
            format!("write a distance of at most {} m, half the width", 0.5 * width),
        );
    }
    if let (Some(width), Some(lanes), Some(lane)) = (width, found.lanes, found.lane_width)
        && (lanes as f64 - 1.0) * lane > width
    {
        findings.error(
            "B661",
            table.place("lanes"),
            format!("{lanes} vehicles {lane} m apart do not stand on a barrel of {width} m"),
            "vehicles abreast on this bridge",
            "write fewer lanes, or the distance that they have",
        );
    }
    let beyond = width.is_some_and(|width| found.cracks.iter().any(|crack| *crack >= width));
    if beyond || found.cracks.windows(2).any(|pair| pair[0] >= pair[1]) {
        findings.error(
            "B227",
            table.place("cracks"),
            "longitudinal cracks do not lie in this barrel in this order",
            width.map_or_else(
                || "cracks from one edge to the other".to_owned(),
                |width| format!("the barrel is {width} m wide"),
            ),
            "give their distances from one edge of the barrel, the least first",
        );
    }
    Some(found)
}

/// Says what a plane model leaves open of a skew span [rad].
pub(crate) fn doubt(skew: f64, place: TextRange, findings: &mut Findings) {
    if skew > DOUBTFUL_SKEW {
        findings.warning(
            "P060",
            place,
            "the bridge is skew, and the model is square",
            "skew barrels carry from obtuse corner to obtuse corner",
            "give the spans along the road, which are the longer ones, and confirm the load by a model in three dimensions or by test",
        );
    }
}
