//! Entities as a DXF file gives them: in its unit, each in its own plane, block references not yet expanded.
//! Meanings of group codes and their defaults after Autodesk, DXF Reference (2018).

use crate::Point;
use crate::shown::{Hidden, HiddenLayers};
use std::collections::BTreeMap;

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
    /// Why it is not shown, as far as it says so itself; its layer may hide it too.
    pub(crate) hidden: Option<Hidden>,
    /// Group 2: the name of a block.
    pub(crate) name: String,
    pub(crate) numbers: Vec<(i32, f64)>,
    /// Those that follow a POLYLINE.
    pub(crate) following: Vec<Vertex>,
}

impl Record {
    pub(crate) fn all(&self, code: i32) -> impl Iterator<Item = f64> + '_ {
        self.numbers.iter().filter(move |(own, _)| *own == code).map(|(_, number)| *number)
    }

    /// A group that stands once; where it stands more often, the last counts.
    pub(crate) fn number(&self, code: i32, default: f64) -> f64 {
        self.all(code).last().unwrap_or(default)
    }

    /// Groups of whole numbers.
    pub(crate) fn whole(&self, code: i32, default: i16) -> i16 {
        self.number(code, f64::from(default)) as i16
    }

    /// A triple of groups ten apart: 10, 20, 30 and so on.
    pub(crate) fn space(&self, code: i32, default: Space) -> Space {
        [0, 1, 2].map(|k| self.number(code + 10 * k as i32, default[k]))
    }

    pub(crate) fn normal(&self) -> Space {
        self.space(210, [0.0, 0.0, 1.0])
    }

    /// Corners of a polyline of either kind, LWPOLYLINE and POLYLINE.
    pub(crate) fn vertices(&self) -> Vec<Vertex> {
        let mut vertices: Vec<Vertex> = Vec::new();
        if self.kind == "LWPOLYLINE" {
            // Each vertex starts with its x; a bulge or a height before the first belongs to none.
            for &(code, number) in &self.numbers {
                match (code, vertices.last_mut()) {
                    (10, _) => vertices.push(Vertex { at: [number, 0.0], height: 0.0, bulge: 0.0 }),
                    (20, Some(vertex)) => vertex.at[1] = number,
                    (42, Some(vertex)) => vertex.bulge = number,
                    _ => {}
                }
            }
        }
        vertices.extend(&self.following);
        vertices
    }

    /// Control points or fit points of a spline; the first height belongs to the first point, and what has none lies at zero.
    pub(crate) fn points(&self, [x, y, z]: [i32; 3]) -> Vec<Space> {
        let heights = self.all(z).chain(std::iter::repeat(0.0));
        self.all(x).zip(self.all(y)).zip(heights).map(|((x, y), z)| [x, y, z]).collect()
    }
}

/// A corner of a polyline.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Vertex {
    pub(crate) at: Point,
    pub(crate) height: f64,
    /// Of the edge to the next corner.
    pub(crate) bulge: f64,
}

impl Vertex {
    /// That of a record, unless it only controls a fitted curve, which the fitted vertices follow.
    fn of(record: &Record) -> Option<Vertex> {
        let [x, y, height] = record.space(10, [0.0; 3]);
        (record.whole(70, 0) & 16 == 0).then(|| Vertex { at: [x, y], height, bulge: record.number(42, 0.0) })
    }
}

/// A block that references insert.
#[derive(Debug, Clone, Default)]
pub(crate) struct Block {
    pub(crate) base: Point,
    pub(crate) entities: Vec<Record>,
}

/// The content of a file.
#[derive(Debug, Clone, Default)]
pub(crate) struct Content {
    /// By name in capitals.
    pub(crate) blocks: BTreeMap<String, Block>,
    pub(crate) entities: Vec<Record>,
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
        match record.kind {
            "VERTEX" => {
                let is_polyline = |known: &&mut Record| takes_vertices && known.kind.ends_with("POLYLINE");
                if let Some(polyline) = entities.last_mut().filter(is_polyline) {
                    polyline.following.extend(Vertex::of(&record));
                }
                continue;
            }
            kind => takes_vertices = kind == "POLYLINE",
        }
        if !matches!(record.kind, "SEQEND" | "BLOCK" | "ENDBLK") {
            entities.push(record);
        }
    }
    content.blocks.extend(block);
    content
}
