//! Writing a drawing: closed polylines, lines and circles on named layers, DXF version R2010 in metres.
//!
//! The frame around them is the least that programs ask for: tables, both spaces as blocks, a root dictionary, and a handle
//! with its owner for each. Groups after Autodesk, DXF Reference (2010).

use crate::Point;
use std::collections::BTreeSet;
use std::fmt::{Display, Write};

/// Group 440, said outright: some programs take the default of zero for invisible. DXF Reference: 2 in the highest byte
/// for a value of its own, 255 in the lowest for opaque.
const OPAQUE: i32 = 0x0200_00FF;
/// Group 370: as wide as the layer says.
const BY_LAYER: i16 = -1;

/// Colour of layers that were given none.
const BLACK: u8 = 7;

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

impl Item {
    fn layer(&self) -> &str {
        let (Item::Line { layer, .. } | Item::Circle { layer, .. }) = self;
        layer
    }
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
        let mut layers = vec![("0".to_owned(), BLACK)];
        let listed = self.layers.iter().map(|layer| (layer_name(&layer.name), layer.colour));
        let named = self.items.iter().map(|item| (layer_name(item.layer()), BLACK));
        let mut known: BTreeSet<String> = layers.iter().map(|(name, _)| name.clone()).collect();
        layers.extend(listed.chain(named).filter(|(name, _)| known.insert(name.clone())));
        let mut body = Groups { text: String::new(), handle: LAST_FIXED };
        body.tables(&layers);
        body.blocks();
        body.section("ENTITIES", |groups| self.items.iter().for_each(|item| groups.item(item)));
        body.objects();
        let mut file = Groups { text: String::new(), handle: body.handle };
        file.header();
        file.text.push_str(&body.text);
        file.put(0, "EOF");
        file.text.into_bytes()
    }
}

/// Handles that others point at [hexadecimal].
const MODEL_SPACE: &str = "1";
const PAPER_SPACE: &str = "2";
const ROOT: &str = "3";
const GROUPS: &str = "4";
const LAST_FIXED: u32 = 4;
const NOBODY: &str = "0";

/// Pairs of a group code and a value, and the last handle that was given.
struct Groups {
    text: String,
    handle: u32,
}

impl Groups {
    fn put(&mut self, code: u32, value: impl Display) {
        // Writing to memory does not fail.
        let _ = write!(self.text, "{code:>3}\r\n{value}\r\n");
    }

    fn all(&mut self, pairs: &[(u32, &str)]) {
        pairs.iter().for_each(|(code, value)| self.put(*code, value));
    }

    /// A number with decimals: the shortest that reads back to the same, never with an exponent.
    fn number(&mut self, code: u32, number: f64) {
        let point = if number.fract() == 0.0 { ".0" } else { "" };
        self.put(code, format_args!("{number}{point}"));
    }

    fn section(&mut self, name: &str, content: impl FnOnce(&mut Groups)) {
        self.all(&[(0, "SECTION"), (2, name)]);
        content(self);
        self.put(0, "ENDSEC");
    }

    fn next(&mut self) -> String {
        self.handle += 1;
        format!("{:X}", self.handle)
    }

    fn header(&mut self) {
        let seed = format!("{:X}", self.handle + 1);
        self.section("HEADER", |groups| {
            // R2010; metres; metric; the next free handle.
            let variables = [("$ACADVER", 1, "AC1024"), ("$INSUNITS", 70, "6"), ("$MEASUREMENT", 70, "1")];
            for (name, code, value) in variables.into_iter().chain([("$HANDSEED", 5, seed.as_str())]) {
                groups.all(&[(9, name), (code, value)]);
            }
        });
    }

    /// A table and its rows: name, special handle, groups after the name.
    fn table(&mut self, kind: &str, class: &str, rows: &[Row<'_>]) {
        let table = self.next();
        self.all(&[(0, "TABLE"), (2, kind), (5, &table), (330, NOBODY), (100, "AcDbSymbolTable")]);
        self.put(70, rows.len());
        if kind == "DIMSTYLE" {
            self.put(100, "AcDbDimStyleTable");
        }
        for row in rows {
            let handle = row.handle.map_or_else(|| self.next(), str::to_owned);
            // Group 5 is the size of arrow heads there.
            self.all(&[(0, kind), (if kind == "DIMSTYLE" { 105 } else { 5 }, &handle), (330, &table)]);
            self.all(&[(100, "AcDbSymbolTableRecord"), (100, class), (2, row.name)]);
            self.all(row.rest);
        }
        self.put(0, "ENDTAB");
    }

    fn tables(&mut self, layers: &[(String, u8)]) {
        const PLAIN: &[(u32, &str)] = &[(70, "0")];
        const SOLID: &[(u32, &str)] = &[(70, "0"), (3, ""), (72, "65"), (73, "0"), (40, "0.0")];
        const TEXT: &[(u32, &str)] =
            &[(70, "0"), (40, "0.0"), (41, "1.0"), (50, "0.0"), (71, "0"), (42, "0.2"), (3, "txt"), (4, "")];
        fn row<'a>(name: &'a str, rest: &'a [(u32, &'a str)]) -> Row<'a> {
            Row { name, handle: None, rest }
        }
        self.section("TABLES", |groups| {
            groups.table("VPORT", "AcDbViewportTableRecord", &[row("*ACTIVE", PLAIN)]);
            let lines = [row("ByBlock", SOLID), row("ByLayer", SOLID), row("Continuous", SOLID)];
            groups.table("LTYPE", "AcDbLinetypeTableRecord", &lines);
            let colours: Vec<String> = layers.iter().map(|(_, colour)| colour.to_string()).collect();
            let rest: Vec<[(u32, &str); 3]> =
                colours.iter().map(|colour| [(70, "0"), (62, colour.as_str()), (6, "Continuous")]).collect();
            let rows: Vec<Row<'_>> = layers.iter().zip(&rest).map(|((name, _), rest)| row(name, rest)).collect();
            groups.table("LAYER", "AcDbLayerTableRecord", &rows);
            groups.table("STYLE", "AcDbTextStyleTableRecord", &[row("Standard", TEXT)]);
            groups.table("VIEW", "AcDbViewTableRecord", &[]);
            groups.table("UCS", "AcDbUCSTableRecord", &[]);
            groups.table("APPID", "AcDbRegAppTableRecord", &[row("ACAD", PLAIN)]);
            groups.table("DIMSTYLE", "AcDbDimStyleTableRecord", &[row("Standard", PLAIN)]);
            let spaces = [("*Model_Space", MODEL_SPACE), ("*Paper_Space", PAPER_SPACE)];
            let rows = spaces.map(|(name, handle)| Row { name, handle: Some(handle), rest: &[] });
            groups.table("BLOCK_RECORD", "AcDbBlockTableRecord", &rows);
        });
    }

    /// The empty blocks that stand for model space and paper space.
    fn blocks(&mut self) {
        self.section("BLOCKS", |groups| {
            for (name, space) in [("*Model_Space", MODEL_SPACE), ("*Paper_Space", PAPER_SPACE)] {
                groups.entity("BLOCK", space, "0", "AcDbBlockBegin");
                groups.all(&[(2, name), (70, "0")]);
                for code in [10, 20, 30] {
                    groups.number(code, 0.0);
                }
                groups.all(&[(3, name), (1, "")]);
                groups.entity("ENDBLK", space, "0", "AcDbBlockEnd");
            }
        });
    }

    fn entity(&mut self, kind: &str, space: &str, layer: &str, class: &str) {
        let handle = self.next();
        self.all(&[(0, kind), (5, &handle), (330, space), (100, "AcDbEntity"), (8, layer)]);
        if space == MODEL_SPACE && !matches!(kind, "BLOCK" | "ENDBLK") {
            self.put(370, BY_LAYER);
            self.put(440, OPAQUE);
        }
        self.put(100, class);
    }

    fn item(&mut self, item: &Item) {
        let layer = layer_name(item.layer());
        match item {
            Item::Line { points, closed, .. } => {
                self.entity("LWPOLYLINE", MODEL_SPACE, &layer, "AcDbPolyline");
                self.put(90, points.len());
                self.put(70, u8::from(*closed));
                for &[x, y] in points {
                    self.number(10, x);
                    self.number(20, y);
                }
            }
            Item::Circle { centre: [x, y], radius, .. } => {
                self.entity("CIRCLE", MODEL_SPACE, &layer, "AcDbCircle");
                for (code, number) in [(10, *x), (20, *y), (30, 0.0), (40, *radius)] {
                    self.number(code, number);
                }
            }
        }
    }

    /// The root dictionary and the one entry that it must have.
    fn objects(&mut self) {
        self.section("OBJECTS", |groups| {
            for (handle, owner) in [(ROOT, NOBODY), (GROUPS, ROOT)] {
                groups.all(&[(0, "DICTIONARY"), (5, handle), (330, owner), (100, "AcDbDictionary"), (281, "1")]);
                if handle == ROOT {
                    groups.all(&[(3, "ACAD_GROUP"), (350, GROUPS)]);
                }
            }
        });
    }
}

/// A row of a table.
struct Row<'a> {
    name: &'a str,
    /// Where others point at it.
    handle: Option<&'a str>,
    rest: &'a [(u32, &'a str)],
}
