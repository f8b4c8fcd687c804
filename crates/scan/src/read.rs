//! Points of an E57, LAS or LAZ file, one after the other.

use e57::{CartesianCoordinate, E57Reader};
use std::io::{Read, Seek};

/// Points of a LAS file that are held at once.
const PIECE: u64 = 65_536;

/// How a cloud is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// ASTM E2807; its coordinates are metres.
    E57,
    /// ASPRS LAS, packed as LAZ or not.
    Las,
}

impl Format {
    /// By the ending of a file's name, in small letters.
    pub fn of_ending(ending: &str) -> Option<Format> {
        match ending {
            "e57" => Some(Format::E57),
            "las" | "laz" => Some(Format::Las),
            _ => None,
        }
    }
}

/// Why there is no cloud.
#[derive(Debug, thiserror::Error)]
pub enum CloudError {
    /// The library's words.
    #[error("{0}")]
    Unreadable(String),
    /// No point has coordinates.
    #[error("it holds no point")]
    Empty,
}

/// Gives every point that has coordinates, in those of the project: scans of several stations stand where they were registered.
///
/// # Errors
/// A file that is no cloud, ends early or holds no point.
pub fn points(
    file: impl Read + Seek + Send + Sync + 'static,
    format: Format,
    each: &mut dyn FnMut([f64; 3]),
) -> Result<(), CloudError> {
    let mut any = false;
    let mut give = |point: [f64; 3]| {
        if point.iter().all(|value| value.is_finite()) {
            any = true;
            each(point);
        }
    };
    match format {
        Format::E57 => of_e57(file, &mut give).map_err(|error| CloudError::Unreadable(told(&error)))?,
        Format::Las => of_las(file, &mut give).map_err(|error| CloudError::Unreadable(told(&error)))?,
    }
    if any { Ok(()) } else { Err(CloudError::Empty) }
}

fn of_e57(file: impl Read + Seek, give: &mut dyn FnMut([f64; 3])) -> e57::Result<()> {
    let mut reader = E57Reader::new(file)?;
    for scan in reader.pointclouds() {
        let mut points = reader.pointcloud_simple(&scan)?;
        points.intensity_to_color(false);
        points.cartesian_to_spherical(false);
        for point in points {
            if let CartesianCoordinate::Valid { x, y, z } = point?.cartesian {
                give([x, y, z]);
            }
        }
    }
    Ok(())
}

fn of_las(file: impl Read + Seek + Send + Sync + 'static, give: &mut dyn FnMut([f64; 3])) -> las::Result<()> {
    let mut reader = las::Reader::new(std::io::BufReader::new(file))?;
    let mut left = reader.header().number_of_points();
    let mut piece = reader.read_points(0)?;
    while left > 0 {
        let read = reader.fill_points(left.min(PIECE), &mut piece)?;
        if read == 0 {
            break;
        }
        for ((x, y), z) in piece.x().zip(piece.y()).zip(piece.z()) {
            give([x, y, z]);
        }
        left = left.saturating_sub(read);
    }
    Ok(())
}

/// An error with what lies below it.
fn told(error: &dyn std::error::Error) -> String {
    let mut words = error.to_string();
    let mut below = error.source();
    while let Some(cause) = below {
        words = format!("{words}: {cause}");
        below = cause.source();
    }
    words
}
