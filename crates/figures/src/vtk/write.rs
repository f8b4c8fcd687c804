//! The XML of unstructured grids, with arrays in base64: little-endian numbers after their length in bytes.

use crate::sheet::escape;
use base64::{Engine, engine::general_purpose::STANDARD};
use outcome::picture::Point;
use std::fmt::Write as _;

/// Values of one array.
enum Values {
    Real(Vec<f64>),
    Whole(Vec<i64>),
    Small(Vec<u8>),
}

/// An array with its name and the number of values that belong together.
pub(crate) struct Array<'a> {
    name: &'a str,
    components: usize,
    values: Values,
}

impl<'a> Array<'a> {
    /// Numbers with a fraction, so many that belong together.
    pub(crate) fn real(name: &'a str, components: usize, values: impl IntoIterator<Item = f64>) -> Array<'a> {
        Array { name, components, values: Values::Real(values.into_iter().collect()) }
    }
    /// Vectors in the plane.
    pub(crate) fn vectors(name: &'a str, values: impl IntoIterator<Item = Point>) -> Array<'a> {
        Array::real(name, 3, values.into_iter().flat_map(|[x, y]| [x, y, 0.0]))
    }
    /// Whole numbers.
    pub(crate) fn whole(name: &'a str, values: impl IntoIterator<Item = i64>) -> Array<'a> {
        Array { name, components: 1, values: Values::Whole(values.into_iter().collect()) }
    }

    fn write(&self, out: &mut String, short: bool) {
        let (kind, bytes): (_, Vec<u8>) = match &self.values {
            Values::Real(v) if short => ("Float32", v.iter().flat_map(|&x| (x as f32).to_le_bytes()).collect()),
            Values::Whole(v) if short => ("Int32", v.iter().flat_map(|&x| (x as i32).to_le_bytes()).collect()),
            // ParaView shows what is not a number as such; it must not stop the file from loading.
            Values::Real(v) => ("Float64", v.iter().flat_map(|x| x.to_le_bytes()).collect()),
            Values::Whole(v) => ("Int64", v.iter().flat_map(|x| x.to_le_bytes()).collect()),
            Values::Small(v) => ("UInt8", v.clone()),
        };
        let mut packed = (bytes.len() as u64).to_le_bytes().to_vec();
        packed.extend(bytes);
        let _ = writeln!(
            out,
            "<DataArray type=\"{kind}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}</DataArray>",
            escape(self.name),
            self.components,
            STANDARD.encode(packed)
        );
    }
}

/// Cells of one kind, as VTK numbers them.
#[derive(Default)]
pub(crate) struct Cells {
    kind: u8,
    /// Point numbers of all cells, one after the other, and where each cell ends among them.
    corners: Vec<i64>,
    ends: Vec<i64>,
}

impl Cells {
    pub(crate) const LINE: u8 = 3;
    pub(crate) const TRIANGLE: u8 = 5;
    pub(crate) const POLYGON: u8 = 7;
    pub(crate) const QUAD: u8 = 9;

    /// The points of every cell.
    pub(crate) fn of<C: IntoIterator<Item = usize>>(kind: u8, cells: impl IntoIterator<Item = C>) -> Cells {
        let mut made = Cells { kind, ..Cells::default() };
        for cell in cells {
            made.corners.extend(cell.into_iter().map(|corner| corner as i64));
            made.ends.push(made.corners.len() as i64);
        }
        made
    }
    /// Each point by itself.
    pub(crate) fn points(count: usize) -> Cells {
        Cells::of(1, (0..count).map(|point| [point]))
    }
}

#[derive(Default)]
pub(crate) struct Grid<'a> {
    /// Whether numbers are written with four bytes instead of eight: seven digits, enough for what is looked at.
    pub short: bool,
    /// Remark at the head of the file.
    pub remark: &'a str,
    /// Numbers that belong to the whole, one value each.
    pub field: &'a [(&'a str, f64)],
    /// Points [m].
    pub points: Vec<Point>,
    pub cells: Cells,
    /// Values at points.
    pub at_points: Vec<Array<'a>>,
    /// Values of cells.
    pub at_cells: Vec<Array<'a>>,
}

impl Grid<'_> {
    pub(crate) fn file(&self) -> String {
        let mut out = String::from("<?xml version=\"1.0\"?>\n");
        // Two hyphens would end the remark.
        let _ = writeln!(out, "<!-- {} -->", escape(self.remark).replace("--", "–"));
        out.push_str(
            "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n",
        );
        if !self.field.is_empty() {
            out.push_str("<FieldData>\n");
            for (name, value) in self.field {
                let array = Array::real(name, 1, [*value]);
                let mut text = String::new();
                array.write(&mut text, false);
                out.push_str(&text.replace("NumberOfComponents=\"1\"", "NumberOfTuples=\"1\""));
            }
            out.push_str("</FieldData>\n");
        }
        let (points, cells) = (self.points.len(), self.cells.ends.len());
        let _ = writeln!(out, "<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">");
        let mut section = |name: &str, arrays: &[Array]| {
            let _ = writeln!(out, "<{name}>");
            arrays.iter().for_each(|a| a.write(&mut out, self.short));
            let _ = writeln!(out, "</{name}>");
        };
        section("PointData", &self.at_points);
        section("CellData", &self.at_cells);
        section("Points", &[Array::vectors("Points", self.points.iter().copied())]);
        let kinds = Array { name: "types", components: 1, values: Values::Small(vec![self.cells.kind; cells]) };
        let corners = Array::whole("connectivity", self.cells.corners.iter().copied());
        section("Cells", &[corners, Array::whole("offsets", self.cells.ends.iter().copied()), kinds]);
        out.push_str("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
        out
    }
}
