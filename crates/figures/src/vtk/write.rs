//! The XML of unstructured grids, with arrays in base64: little-endian numbers after their length in bytes.

use crate::sheet::escape;
use base64::{Engine, engine::general_purpose::STANDARD};
use std::fmt::Write as _;

/// Values of one array.
pub enum Values<'a> {
    /// Numbers with a fraction.
    Real(&'a [f64]),
    /// Whole numbers.
    Whole(&'a [i64]),
    /// Small whole numbers without sign.
    Small(&'a [u8]),
}

/// An array with its name and the number of values that belong together.
pub struct Array<'a> {
    /// Name in ParaView.
    pub name: &'a str,
    pub components: usize,
    pub values: Values<'a>,
}

impl<'a> Array<'a> {
    /// Numbers with a fraction.
    pub fn real(name: &'a str, components: usize, values: &'a [f64]) -> Array<'a> {
        Array { name, components, values: Values::Real(values) }
    }
    /// Whole numbers.
    pub fn whole(name: &'a str, values: &'a [i64]) -> Array<'a> {
        Array { name, components: 1, values: Values::Whole(values) }
    }

    fn write(&self, out: &mut String, short: bool) {
        let (kind, bytes): (_, Vec<u8>) = match self.values {
            Values::Real(v) if short => ("Float32", v.iter().flat_map(|&x| (x as f32).to_le_bytes()).collect()),
            Values::Whole(v) if short => ("Int32", v.iter().flat_map(|&x| (x as i32).to_le_bytes()).collect()),
            // ParaView shows what is not a number as such; it must not stop the file from loading.
            Values::Real(v) => ("Float64", v.iter().flat_map(|x| x.to_le_bytes()).collect()),
            Values::Whole(v) => ("Int64", v.iter().flat_map(|x| x.to_le_bytes()).collect()),
            Values::Small(v) => ("UInt8", v.to_vec()),
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

pub struct Grid<'a> {
    /// Whether numbers are written with four bytes instead of eight: seven digits, enough for what is looked at.
    pub short: bool,
    /// Remark at the head of the file.
    pub remark: &'a str,
    /// Numbers that belong to the whole, one value each.
    pub field: &'a [(&'a str, f64)],
    /// Points, three coordinates each [m].
    pub points: &'a [f64],
    /// Point numbers of all cells, one after the other.
    pub connectivity: &'a [i64],
    /// End of each cell in `connectivity`.
    pub offsets: &'a [i64],
    /// Kind of each cell, as VTK numbers them.
    pub kinds: &'a [u8],
    /// Values at points.
    pub at_points: &'a [Array<'a>],
    /// Values of cells.
    pub at_cells: &'a [Array<'a>],
}

impl Grid<'_> {
    pub fn file(&self) -> String {
        let mut out = String::from("<?xml version=\"1.0\"?>\n");
        // Two hyphens would end the remark.
        let _ = writeln!(out, "<!-- {} -->", escape(self.remark).replace("--", "–"));
        out.push_str(
            "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n",
        );
        if !self.field.is_empty() {
            out.push_str("<FieldData>\n");
            for (name, value) in self.field {
                let array = Array::real(name, 1, std::slice::from_ref(value));
                let mut text = String::new();
                array.write(&mut text, false);
                out.push_str(&text.replace("NumberOfComponents=\"1\"", "NumberOfTuples=\"1\""));
            }
            out.push_str("</FieldData>\n");
        }
        let _ = writeln!(
            out,
            "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">",
            self.points.len() / 3,
            self.offsets.len()
        );
        let mut section = |name: &str, arrays: &[Array]| {
            let _ = writeln!(out, "<{name}>");
            arrays.iter().for_each(|a| a.write(&mut out, self.short));
            let _ = writeln!(out, "</{name}>");
        };
        section("PointData", self.at_points);
        section("CellData", self.at_cells);
        section("Points", &[Array::real("Points", 3, self.points)]);
        let kinds = Array { name: "types", components: 1, values: Values::Small(self.kinds) };
        section(
            "Cells",
            &[Array::whole("connectivity", self.connectivity), Array::whole("offsets", self.offsets), kinds],
        );
        out.push_str("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
        out
    }
}
