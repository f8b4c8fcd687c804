//! Entities as a DXF file gives them: in its unit, each in its own plane, block references not yet expanded.
//! Meanings of group codes and their defaults after Autodesk, DXF Reference (2018).

use crate::Point;
use crate::shown::{Hidden, HiddenLayers};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A point or a direction in space.
pub(crate) type Space = [f64; 3];

/// The groups of an entity that describe geometry, in the order of the file; the sieve has checked every number.
#[derive(Debug, Clone, Default)]
pub(crate) struct Record {
    pub(crate) kind: &'static str,
    /// Whether it stands in the section of blocks.
    pub(crate) in_blocks: bool,
    pub(crate) layer: String,
    /// Hexadecimal; empty where it has none.
    pub(crate) handle: String,
    /// Why it is not shown, as far as it says so itself.
    pub(crate) hidden: Option<Hidden>,
    /// Group 2: the name of a block.
    pub(crate) name: String,
    pub(crate) numbers: Vec<(i32, f64)>,
}

impl Record {
    fn all(&self, code: i32) -> impl Iterator<Item = f64> + '_ {
        self.numbers.iter().filter(move |(own, _)| *own == code).map(|(_, number)| *number)
    }

    /// A group that stands once; where it stands more often, the last counts.
    fn number(&self, code: i32, default: f64) -> f64 {
        self.all(code).last().unwrap_or(default)
    }

    /// Groups of whole numbers.
    fn whole(&self, code: i32, default: i16) -> i16 {
        self.number(code, f64::from(default)) as i16
    }

    /// A triple of groups ten apart: 10, 20, 30 and so on.
    fn space(&self, code: i32, default: Space) -> Space {
        [0, 1, 2].map(|k| self.number(code + 10 * k as i32, default[k]))
    }

    fn normal(&self) -> Space {
        self.space(210, [0.0, 0.0, 1.0])
    }
}

/// What is drawn, where it is said.
#[derive(Debug, Clone)]
pub(crate) struct Entity {
    pub(crate) kind: &'static str,
    pub(crate) layer: String,
    /// Empty where the file gives none.
    pub(crate) handle: String,
    /// Why it is not shown, as far as it says so itself; its layer may hide it too.
    pub(crate) hidden: Option<Hidden>,
    pub(crate) shape: Shape,
}

/// A corner of a polyline.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Vertex {
    pub(crate) at: Point,
    pub(crate) height: f64,
    /// Of the edge to the next corner.
    pub(crate) bulge: f64,
}

/// Geometry of an entity.
#[derive(Debug, Clone)]
pub(crate) enum Shape {
    Line([Space; 2]),
    /// Of both kinds, LWPOLYLINE and POLYLINE.
    Polyline {
        vertices: Vec<Vertex>,
        height: f64,
        closed: bool,
        /// Whether it is a mesh in space.
        mesh: bool,
        normal: Space,
    },
    /// Angles in degrees.
    Arc {
        centre: Space,
        radius: f64,
        from: f64,
        to: f64,
        normal: Space,
    },
    Circle {
        centre: Space,
        radius: f64,
        normal: Space,
    },
    /// Parameters in radians.
    Ellipse {
        centre: Space,
        major: Space,
        /// Minor by major axis.
        share: f64,
        from: f64,
        to: f64,
        normal: Space,
    },
    Spline {
        degree: usize,
        knots: Vec<f64>,
        weights: Vec<f64>,
        points: Vec<Space>,
        /// Points that the curve passes through, where it is given by them.
        fit: Vec<Space>,
        closed: bool,
        /// Directions at its start and end.
        tangents: [Option<Space>; 2],
    },
    Insert(Insert),
}

/// A reference to a block, with its rows and columns.
#[derive(Debug, Clone)]
pub(crate) struct Insert {
    pub(crate) name: String,
    pub(crate) at: Space,
    pub(crate) scales: [f64; 2],
    /// Degrees.
    pub(crate) rotation: f64,
    pub(crate) columns: i16,
    pub(crate) rows: i16,
    /// From column to column and from row to row.
    pub(crate) spacings: [f64; 2],
    pub(crate) normal: Space,
}

/// A block that references insert.
#[derive(Debug, Clone, Default)]
pub(crate) struct Block {
    pub(crate) base: Point,
    pub(crate) entities: Vec<Entity>,
}

/// The content of a file.
#[derive(Debug, Clone, Default)]
pub(crate) struct Content {
    /// By name in capitals.
    pub(crate) blocks: BTreeMap<String, Block>,
    pub(crate) entities: Vec<Entity>,
    pub(crate) hidden_layers: HiddenLayers,
}

/// Puts records together: vertices to their polylines, entities to their blocks.
pub(crate) fn content(records: Vec<Record>, hidden_layers: HiddenLayers) -> Content {
    let mut content = Content { hidden_layers, ..Content::default() };
    let mut block: Option<(String, Block)> = None;
    let mut takes_vertices = false;
    for record in records {
        if matches!(record.kind, "BLOCK" | "ENDBLK") || !record.in_blocks {
            // A block ends at its own end, at the next block and with its section.
            content.blocks.extend(block.take());
        }
        if record.kind == "BLOCK" && record.in_blocks {
            let base = [record.number(10, 0.0), record.number(20, 0.0)];
            block = Some((record.name.to_uppercase(), Block { base, entities: Vec::new() }));
            takes_vertices = false;
            continue;
        }
        let entities = match &mut block {
            Some((_, block)) => &mut block.entities,
            None if record.in_blocks => continue,
            None => &mut content.entities,
        };
        if record.kind == "VERTEX" {
            if let Some(Entity { shape: Shape::Polyline { vertices, .. }, .. }) = entities.last_mut()
                && takes_vertices
            {
                vertices.extend(vertex(&record));
            }
            continue;
        }
        takes_vertices = record.kind == "POLYLINE";
        if let Some(shape) = shape(&record) {
            let Record { kind, layer, handle, hidden, .. } = record;
            entities.push(Entity { kind, layer, handle, hidden, shape });
        }
    }
    content.blocks.extend(block);
    content
}

fn shape(record: &Record) -> Option<Shape> {
    let origin = [0.0; 3];
    Some(match record.kind {
        "LINE" => Shape::Line([record.space(10, origin), record.space(11, origin)]),
        "LWPOLYLINE" | "POLYLINE" => {
            let (flags, light) = (record.whole(70, 0), record.kind == "LWPOLYLINE");
            Shape::Polyline {
                vertices: if light { light_vertices(record) } else { Vec::new() },
                height: record.number(if light { 38 } else { 30 }, 0.0),
                closed: flags & 1 != 0,
                // 16 and 64: meshes in space. 8 is a line in space, which may lie in the plane.
                mesh: !light && flags & (16 | 64) != 0,
                normal: record.normal(),
            }
        }
        "ARC" => Shape::Arc {
            centre: record.space(10, origin),
            radius: record.number(40, 0.0),
            from: record.number(50, 0.0),
            to: record.number(51, 360.0),
            normal: record.normal(),
        },
        "CIRCLE" => {
            Shape::Circle { centre: record.space(10, origin), radius: record.number(40, 0.0), normal: record.normal() }
        }
        "ELLIPSE" => Shape::Ellipse {
            centre: record.space(10, origin),
            major: record.space(11, [1.0, 0.0, 0.0]),
            share: record.number(40, 1.0),
            from: record.number(41, 0.0),
            to: record.number(42, TAU),
            normal: record.normal(),
        },
        "SPLINE" => Shape::Spline {
            degree: usize::try_from(record.whole(71, 1)).unwrap_or(0),
            knots: record.all(40).collect(),
            weights: record.all(41).collect(),
            points: spline_points(record, [10, 20, 30]),
            fit: spline_points(record, [11, 21, 31]),
            closed: record.whole(70, 0) & 1 != 0,
            tangents: [12, 13].map(|code| record.all(code).next().map(|_| record.space(code, origin))),
        },
        "INSERT" => Shape::Insert(Insert {
            name: record.name.clone(),
            at: record.space(10, origin),
            scales: [record.number(41, 1.0), record.number(42, 1.0)],
            rotation: record.number(50, 0.0),
            columns: record.whole(70, 1),
            rows: record.whole(71, 1),
            spacings: [record.number(44, 0.0), record.number(45, 0.0)],
            normal: record.normal(),
        }),
        _ => return None,
    })
}

/// Each vertex starts with its x.
fn light_vertices(record: &Record) -> Vec<Vertex> {
    let mut vertices: Vec<Vertex> = Vec::new();
    for &(code, number) in &record.numbers {
        match (code, vertices.last_mut()) {
            (10, _) => vertices.push(Vertex { at: [number, 0.0], height: 0.0, bulge: 0.0 }),
            (20, Some(vertex)) => vertex.at[1] = number,
            (42, Some(vertex)) => vertex.bulge = number,
            _ => {}
        }
    }
    vertices
}

/// A vertex of a POLYLINE, unless it only controls a fitted curve, which the fitted vertices follow.
fn vertex(record: &Record) -> Option<Vertex> {
    let [x, y, height] = record.space(10, [0.0; 3]);
    (record.whole(70, 0) & 16 == 0).then(|| Vertex { at: [x, y], height, bulge: record.number(42, 0.0) })
}

/// Control points or fit points; the first height belongs to the first point, and what has none lies at zero.
fn spline_points(record: &Record, [x, y, z]: [i32; 3]) -> Vec<Space> {
    let heights = record.all(z).chain(std::iter::repeat(0.0));
    record.all(x).zip(record.all(y)).zip(heights).map(|((x, y), z)| [x, y, z]).collect()
}
