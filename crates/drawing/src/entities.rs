//! From the entities of the crate `dxf` to strands of points and circles in metres, with block references expanded.

use crate::Point;
use crate::curve::{self, Spline};
use crate::finding::{Findings, Place};
use crate::read::{Options, is_ignored};
use crate::transform::Transform;
use dxf::entities::{Entity, EntityType, Insert};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Points drawn in one go, from where a file is no drawing of a bridge.
const MOST_POINTS: usize = 2_000_000;
/// Expanded entities, likewise: a few nested references with rows and columns multiply beyond any memory.
const MOST_EXPANDED: usize = 100_000;
/// Block references inside one another.
const DEEPEST: usize = 16;
/// Coordinates beyond this belong to no bridge [m].
pub(crate) const FARTHEST: f64 = 1e6;

/// A curve as points, or a circle.
#[derive(Debug, Clone)]
pub(crate) struct Strand {
    pub(crate) place: Place,
    /// Points [m]; the last is not the first again where it is closed.
    pub(crate) points: Vec<Point>,
    pub(crate) closed: bool,
    /// Whether curves were made into chords.
    pub(crate) flattened: bool,
}

/// A circle as drawn.
#[derive(Debug, Clone)]
pub(crate) struct Ring {
    pub(crate) place: Place,
    pub(crate) centre: Point,
    pub(crate) radius: f64,
}

/// What the entities of a drawing amount to.
#[derive(Debug, Default)]
pub(crate) struct Strands {
    pub(crate) strands: Vec<Strand>,
    pub(crate) rings: Vec<Ring>,
}

pub(crate) struct Expansion<'a> {
    pub(crate) options: &'a Options,
    pub(crate) blocks: BTreeMap<String, &'a dxf::Block>,
    pub(crate) out: Strands,
    pub(crate) findings: &'a mut Findings,
    expanded: usize,
    points: usize,
    full: bool,
}

/// Where an entity stands: its map to metres, the layer and the name of the reference it came through.
#[derive(Clone)]
struct Context {
    map: Transform,
    layer: Option<String>,
    through: String,
    depth: usize,
}

/// Expands all entities of a drawing.
pub(crate) fn expand(drawing: &dxf::Drawing, metres: f64, options: &Options, findings: &mut Findings) -> Strands {
    let blocks = drawing.blocks().map(|block| (block.name.to_uppercase(), block)).collect();
    let out = Strands::default();
    let mut expansion = Expansion { options, blocks, out, findings, expanded: 0, points: 0, full: false };
    let context = Context { map: Transform::scale(metres), layer: None, through: String::new(), depth: 0 };
    for entity in drawing.entities() {
        expansion.entity(entity, &context);
    }
    expansion.out
}

impl Expansion<'_> {
    fn entity(&mut self, entity: &Entity, context: &Context) {
        if self.full || entity.common.is_in_paper_space {
            return;
        }
        let place = place(entity, context);
        if self.is_full(&place) {
            return;
        }
        if let EntityType::Insert(insert) = &entity.specific {
            return self.insert(insert, &place, context);
        }
        if is_ignored(self.options, &place.layer) {
            return;
        }
        match &entity.specific {
            EntityType::Line(line) => {
                let ends = [&line.p1, &line.p2];
                if self.is_flat(&place, context, ends.iter().map(|p| p.z)) {
                    let points = ends.iter().map(|p| context.map.point([p.x, p.y])).collect();
                    self.strand(place, points, false, false);
                }
            }
            EntityType::LwPolyline(line) => {
                let Some(map) = self.plane(&place, context, &line.extrusion_direction) else { return };
                if self.is_flat(&place, context, [entity.common.elevation].into_iter()) {
                    let vertices: Vec<_> = line.vertices.iter().map(|v| ([v.x, v.y], v.bulge)).collect();
                    self.polyline(place, &vertices, line.is_closed(), &map);
                }
            }
            EntityType::Polyline(line) => {
                // 16 and 64: meshes in space. 8 is a line in space, which may lie in the plane.
                if line.flags & (16 | 64) != 0 {
                    let help = "explode it and draw the outlines of the blocks";
                    return self.findings.error("D105", place, "a mesh in space is no outline", help);
                }
                let Some(map) = self.plane(&place, context, &line.normal) else { return };
                // 16: control points of a fitted curve, which the fitted vertices follow.
                let vertices: Vec<_> = line.vertices().filter(|v| v.flags & 16 == 0).collect();
                let heights = vertices.iter().map(|v| v.location.z).chain([line.location.z]);
                if self.is_flat(&place, context, heights.collect::<Vec<_>>().into_iter()) {
                    let vertices: Vec<_> = vertices.iter().map(|v| ([v.location.x, v.location.y], v.bulge)).collect();
                    self.polyline(place, &vertices, line.is_closed(), &map);
                }
            }
            EntityType::Arc(arc) => {
                let Some(map) = self.plane(&place, context, &arc.normal) else { return };
                let from = arc.start_angle.to_radians();
                let sweep = curve::sweep(from, arc.end_angle.to_radians());
                let round = [arc.center.x, arc.center.y];
                if self.is_flat(&place, context, [arc.center.z].into_iter()) && self.has_size(&place, arc.radius) {
                    let points = curve::arc(round, arc.radius, from, sweep, self.tolerance(&map));
                    let points = points.into_iter().map(|p| map.point(p)).collect();
                    self.strand(place, points, false, true);
                }
            }
            EntityType::Circle(circle) => {
                let Some(map) = self.plane(&place, context, &circle.normal) else { return };
                let centre = [circle.center.x, circle.center.y];
                if self.is_flat(&place, context, [circle.center.z].into_iter()) && self.has_size(&place, circle.radius)
                {
                    self.circle(place, centre, circle.radius, &map);
                }
            }
            EntityType::Ellipse(ellipse) => self.ellipse(place, ellipse, context),
            EntityType::Spline(spline) => self.spline(place, spline, context),
            _ => {}
        }
    }

    fn polyline(&mut self, place: Place, vertices: &[(Point, f64)], closed: bool, map: &Transform) {
        let tolerance = self.tolerance(map);
        let Some(&(first, _)) = vertices.first() else { return };
        let mut points = vec![first];
        let mut flattened = false;
        for pair in vertices.windows(2) {
            flattened |= pair[0].1 != 0.0;
            points.extend(curve::bulge(pair[0].0, pair[1].0, pair[0].1, tolerance));
        }
        let (last, bulge) = vertices[vertices.len() - 1];
        if closed && bulge != 0.0 {
            flattened = true;
            points.extend(curve::bulge(last, first, bulge, tolerance));
            points.pop();
        }
        let points = points.into_iter().map(|p| map.point(p)).collect();
        self.strand(place, points, closed, flattened);
    }

    fn circle(&mut self, place: Place, centre: Point, radius: f64, map: &Transform) {
        match map.similarity() {
            Some(size) => {
                let (centre, radius) = (map.point(centre), radius * size);
                if self.is_near(&place, &[centre, [radius, 0.0]]) {
                    self.points += 1;
                    self.out.rings.push(Ring { place, centre, radius });
                }
            }
            // Stretched in one direction, it is an ellipse.
            None => {
                let mut points = curve::arc(centre, radius, 0.0, TAU, self.tolerance(map));
                points.pop();
                self.strand(place, points.into_iter().map(|p| map.point(p)).collect(), true, true);
            }
        }
    }

    fn ellipse(&mut self, place: Place, ellipse: &dxf::entities::Ellipse, context: &Context) {
        // Centre and axes are in the drawing's own coordinates; the normal only decides which way round.
        let Some(_) = self.plane(&place, context, &ellipse.normal) else { return };
        let turn = if ellipse.normal.z < 0.0 { -1.0 } else { 1.0 };
        let (major, share) = ([ellipse.major_axis.x, ellipse.major_axis.y], ellipse.minor_axis_ratio);
        let heights = [ellipse.center.z, ellipse.major_axis.z];
        if !self.is_flat(&place, context, heights.into_iter())
            || !self.has_size(&place, share * major[0].hypot(major[1]))
        {
            return;
        }
        let minor = [-turn * share * major[1], turn * share * major[0]];
        let (from, to) = (ellipse.start_parameter, ellipse.end_parameter);
        let whole = (to - from).abs() >= TAU - 1e-9;
        let sweep = if whole { TAU } else { curve::sweep(from, to) };
        let centre = [ellipse.center.x, ellipse.center.y];
        let mut points = curve::ellipse(centre, major, minor, from, sweep, self.tolerance(&context.map));
        let closed = sweep >= TAU - 1e-9;
        if closed {
            points.pop();
        }
        self.strand(place, points.into_iter().map(|p| context.map.point(p)).collect(), closed, true);
    }

    fn spline(&mut self, place: Place, spline: &dxf::entities::Spline, context: &Context) {
        let points: Vec<Point> = spline.control_points.iter().map(|p| [p.x, p.y]).collect();
        if !self.is_flat(&place, context, spline.control_points.iter().map(|p| p.z)) {
            return;
        }
        let curve = Spline {
            degree: usize::try_from(spline.degree_of_curve).unwrap_or(0),
            knots: &spline.knot_values,
            points: &points,
            weights: &spline.weight_values,
        };
        if let Some(defect) = curve.defect() {
            let message = format!("the spline cannot be drawn: it has {defect}");
            return self.findings.error("D103", place, message, "convert it to a polyline");
        }
        let points = curve.points(self.tolerance(&context.map));
        self.strand(place, points.into_iter().map(|p| context.map.point(p)).collect(), false, true);
    }

    fn insert(&mut self, insert: &Insert, place: &Place, context: &Context) {
        let Some(&block) = self.blocks.get(&insert.name.to_uppercase()) else {
            let message = format!("the block {} is not in the file", insert.name);
            let help = "bind external references before the export, or take this one out";
            return self.findings.error("D107", place.clone(), message, help);
        };
        if context.depth >= DEEPEST {
            let message = format!("block references lie more than {DEEPEST} deep inside one another");
            return self.findings.error("D107", place.clone(), message, "explode the references");
        }
        let Some(map) = self.plane(place, context, &insert.extrusion_direction) else { return };
        let scales = [insert.x_scale_factor, insert.y_scale_factor];
        if scales.contains(&0.0) {
            let message = format!("the block {} is inserted with a scale of zero", insert.name);
            return self.findings.error("D107", place.clone(), message, "take it out");
        }
        if !self.is_flat(place, context, [insert.location.z].into_iter()) {
            return;
        }
        let (s, c) = insert.rotation.to_radians().sin_cos();
        let base = [block.base_point.x, block.base_point.y];
        for row in 0..insert.row_count.max(1) {
            for column in 0..insert.column_count.max(1) {
                // Every repetition counts, even of an empty block.
                if self.is_full(place) {
                    return;
                }
                let (dx, dy) = (f64::from(column) * insert.column_spacing, f64::from(row) * insert.row_spacing);
                let mut own = Transform {
                    x: [scales[0] * c, scales[0] * s],
                    y: [-scales[1] * s, scales[1] * c],
                    origin: [insert.location.x + c * dx - s * dy, insert.location.y + s * dx + c * dy],
                };
                let moved = own.vector(base);
                own.origin = [own.origin[0] - moved[0], own.origin[1] - moved[1]];
                let inner = Context {
                    map: map.after(&own),
                    layer: Some(place.layer.clone()),
                    through: place.entity.clone(),
                    depth: context.depth + 1,
                };
                for entity in &block.entities {
                    self.entity(entity, &inner);
                }
            }
        }
    }

    fn strand(&mut self, place: Place, points: Vec<Point>, closed: bool, flattened: bool) {
        if !points.is_empty() && self.is_near(&place, &points) {
            self.points += points.len();
            let place = place.at(points[0]);
            self.out.strands.push(Strand { place, points, closed, flattened });
        }
    }

    /// Counts one more entity or repetition; whether there are more than a drawing of a bridge holds, which is said once.
    fn is_full(&mut self, place: &Place) -> bool {
        self.expanded += 1;
        if !self.full && (self.expanded > MOST_EXPANDED || self.points > MOST_POINTS) {
            self.full = true;
            let message = "block references and curves expand to more than a drawing of a bridge holds";
            self.findings.error("D106", place.clone(), message, "export only the outlines of the blocks");
        }
        self.full
    }

    /// The tolerance of chords before a map.
    fn tolerance(&self, map: &Transform) -> f64 {
        self.options.chord_tolerance / map.stretch().max(f64::MIN_POSITIVE)
    }

    /// The map of an entity drawn in its own plane: seen from above, or from below as a mirror image.
    fn plane(&mut self, place: &Place, context: &Context, normal: &dxf::Vector) -> Option<Transform> {
        let size = (normal.x * normal.x + normal.y * normal.y + normal.z * normal.z).sqrt();
        // Round-off of a turned coordinate system.
        let upright = normal.x.hypot(normal.y) <= 1e-9 * size && size > 0.0;
        if !upright {
            let message = format!("the entity lies in a plane with normal ({}, {}, {})", normal.x, normal.y, normal.z);
            self.findings.error("D105", place.clone(), message, "draw it in the plane z = 0");
            return None;
        }
        Some(if normal.z < 0.0 { context.map.after(&Transform::mirrored()) } else { context.map })
    }

    /// Whether all heights are zero, to the gap tolerance.
    fn is_flat(&mut self, place: &Place, context: &Context, heights: impl Iterator<Item = f64>) -> bool {
        let size = context.map.stretch();
        let farthest = heights.map(|z| z * size).fold(0.0, |most: f64, z| if z.abs() > most.abs() { z } else { most });
        if farthest.abs() > self.options.gap_tolerance {
            let message = format!("the entity leaves the plane z = 0: z = {farthest:.4} m");
            self.findings.error("D105", place.clone(), message, "move it into the plane z = 0");
            return false;
        }
        true
    }

    fn has_size(&mut self, place: &Place, radius: f64) -> bool {
        if radius > 0.0 {
            return true;
        }
        let message = format!("a radius of {radius} is none");
        self.findings.error("D304", place.clone(), message, "take it out");
        false
    }

    fn is_near(&mut self, place: &Place, points: &[Point]) -> bool {
        let near = points.iter().flatten().all(|x| x.abs() <= FARTHEST);
        if !near {
            let message = format!("coordinates beyond {:.0} km belong to no bridge", FARTHEST / 1e3);
            let help = "move the drawing to the origin, and check its unit";
            self.findings.error("D106", place.clone(), message, help);
        }
        near
    }
}

/// Where an entity stands. What a block draws on layer 0 lies on the layer of its reference.
fn place(entity: &Entity, context: &Context) -> Place {
    let kind = match &entity.specific {
        EntityType::Line(_) => "LINE",
        EntityType::LwPolyline(_) => "LWPOLYLINE",
        EntityType::Polyline(_) => "POLYLINE",
        EntityType::Arc(_) => "ARC",
        EntityType::Circle(_) => "CIRCLE",
        EntityType::Ellipse(_) => "ELLIPSE",
        EntityType::Spline(_) => "SPLINE",
        EntityType::Insert(_) => "INSERT",
        _ => "entity",
    };
    let handle = entity.common.handle.as_string();
    let own = if handle == "0" { kind.to_owned() } else { format!("{kind} {handle}") };
    let inside = |outer: &String| if outer.is_empty() { own.clone() } else { format!("{own} in {outer}") };
    let layer = match &context.layer {
        Some(outer) if entity.common.layer == "0" => outer.clone(),
        _ => entity.common.layer.clone(),
    };
    Place { layer, entity: inside(&context.through), at: None }
}
