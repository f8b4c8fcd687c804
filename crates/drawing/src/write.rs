//! Writing a drawing: closed polylines, lines and circles on named layers, DXF version R2010 in metres.
//!
//! R12 would lose polylines without a word, so that newer versions alone are written.

use crate::Point;
use dxf::entities::{Circle, Entity, EntityType, LwPolyline};
use dxf::enums::{AcadVersion, DrawingUnits, Units};
use dxf::{Color, LwPolylineVertex};

/// Group 440, said outright: some programs take the default of zero for invisible. DXF Reference: 2 in the highest byte
/// for a value of its own, 255 in the lowest for opaque.
const OPAQUE: i32 = 0x0200_00FF;
/// Group 370: as wide as the layer says.
const BY_LAYER: i16 = -1;

/// A layer of a sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// Its name; see [`layer_name`].
    pub name: String,
    /// AutoCAD colour index: 1 red, 2 yellow, 3 green, 4 cyan, 5 blue, 6 magenta, 7 black or white, 8 grey.
    pub colour: u8,
}

/// Something drawn.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// Straight edges from point to point [m].
    Line {
        /// Name of the layer.
        layer: String,
        /// Points; the first is not repeated where it is closed.
        points: Vec<Point>,
        /// Whether the last point is joined to the first.
        closed: bool,
    },
    /// A circle [m].
    Circle {
        /// Name of the layer.
        layer: String,
        /// Centre.
        centre: Point,
        /// Radius.
        radius: f64,
    },
}

/// A drawing to be written.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sheet {
    /// Its layers; those that items name and are not here are drawn black.
    pub layers: Vec<Layer>,
    /// What is on it, in order.
    pub items: Vec<Item>,
}

/// A name as layers may have it: without the characters that DXF forbids there.
pub fn layer_name(words: &str) -> String {
    let allowed = |c: char| !c.is_control() && !"<>/\\\":;?*|=`,".contains(c);
    let name: String = words.trim().chars().map(|c| if allowed(c) { c } else { '-' }).take(200).collect();
    if name.is_empty() { "0".to_owned() } else { name }
}

impl Sheet {
    /// Adds a layer unless it is there.
    pub fn layer(&mut self, name: &str, colour: u8) {
        if self.layers.iter().all(|layer| layer.name != name) {
            self.layers.push(Layer { name: name.to_owned(), colour });
        }
    }

    /// The bytes of the file; the same sheet gives the same bytes.
    pub fn dxf(&self) -> Vec<u8> {
        let mut drawing = dxf::Drawing::new();
        let header = &mut drawing.header;
        header.version = AcadVersion::R2010;
        header.default_drawing_units = Units::Meters;
        header.drawing_units = DrawingUnits::Metric;
        // Nothing of the moment of writing goes into the file.
        header.creation_date = Default::default();
        header.creation_date_universal = Default::default();
        header.update_date = Default::default();
        header.update_date_universal = Default::default();
        header.fingerprint_guid = Default::default();
        header.version_guid = Default::default();
        for layer in &self.layers {
            drawing.add_layer(dxf::tables::Layer {
                name: layer_name(&layer.name),
                color: Color::from_index(layer.colour),
                ..Default::default()
            });
        }
        for item in &self.items {
            drawing.add_entity(entity(item));
        }
        let mut bytes = Vec::new();
        // Writing to memory does not fail, and every value has a form.
        let _ = drawing.save(&mut bytes);
        bytes
    }
}

fn entity(item: &Item) -> Entity {
    let (layer, specific) = match item {
        Item::Line { layer, points, closed } => {
            let mut line = LwPolyline::default();
            line.set_is_closed(*closed);
            line.vertices = points.iter().map(|&[x, y]| LwPolylineVertex { x, y, ..Default::default() }).collect();
            (layer, EntityType::LwPolyline(line))
        }
        Item::Circle { layer, centre: [x, y], radius } => {
            (layer, EntityType::Circle(Circle::new(dxf::Point::new(*x, *y, 0.0), *radius)))
        }
    };
    let mut entity = Entity::new(specific);
    entity.common.layer = layer_name(layer);
    entity.common.transparency = OPAQUE;
    entity.common.lineweight_enum_value = BY_LAYER;
    entity
}
