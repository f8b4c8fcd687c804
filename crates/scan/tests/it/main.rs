//! Clouds that are written here are cut where they are known.

use scan::{CELL, CloudError, Cut, Format, cut};
use std::io::Cursor;

/// A barrel of 6 m span and 1.5 m rise, 4 m wide, that runs from (100, 50) at 30 degrees in plan; springings at 20 m.
fn barrel() -> Vec<[f64; 3]> {
    let radius = (3.0_f64.powi(2) + 1.5_f64.powi(2)) / 3.0;
    let half = (3.0 / radius).asin();
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    (0..400)
        .flat_map(|k| {
            let angle = half * (2.0 * f64::from(k) / 399.0 - 1.0);
            let [x, z] = [3.0 + radius * angle.sin(), 20.0 + 1.5 - radius * (1.0 - angle.cos())];
            (0..81).map(move |w| {
                let across = 0.05 * f64::from(w) - 2.0;
                [100.0 + x * cos - across * sin, 50.0 + x * sin + across * cos, z]
            })
        })
        .collect()
}

fn middle() -> Cut {
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let end = |x: f64| [100.0 + x * cos, 50.0 + x * sin];
    Cut { ends: [end(-0.001), end(6.001)], thickness: 0.12, levels: [f64::NEG_INFINITY, f64::INFINITY] }
}

fn las(points: &[[f64; 3]]) -> Vec<u8> {
    let mut builder = las::Builder::from((1, 4));
    builder.transforms = las::Vector {
        x: las::Transform { scale: 0.001, offset: 0.0 },
        y: las::Transform { scale: 0.001, offset: 0.0 },
        z: las::Transform { scale: 0.001, offset: 0.0 },
    };
    let mut writer = las::Writer::new(Cursor::new(Vec::new()), builder.into_header().unwrap()).unwrap();
    for &[x, y, z] in points {
        writer.write_point(las::Point { x, y, z, ..Default::default() }).unwrap();
    }
    writer.into_inner().unwrap().into_inner()
}

/// As two scans, the second in the coordinates of its own station.
fn e57(points: &[[f64; 3]]) -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    let mut writer = e57::E57Writer::new(&mut file, "of a test").unwrap();
    let (first, second) = points.split_at(points.len() / 2);
    for (name, points, station) in [("first", first, [0.0; 3]), ("second", second, [90.0, 40.0, 10.0])] {
        let records = vec![e57::Record::CARTESIAN_X_F64, e57::Record::CARTESIAN_Y_F64, e57::Record::CARTESIAN_Z_F64];
        let mut scan = writer.add_pointcloud(name, records).unwrap();
        let [x, y, z] = station;
        scan.set_transform(Some(e57::Transform {
            rotation: e57::Quaternion { w: 1.0, x: 0.0, y: 0.0, z: 0.0 },
            translation: e57::Translation { x, y, z },
        }));
        for point in points {
            let values = [0, 1, 2].map(|i| e57::RecordValue::Double(point[i] - station[i]));
            scan.add_point(values.to_vec()).unwrap();
        }
        scan.finalize().unwrap();
    }
    writer.finalize().unwrap();
    drop(writer);
    file.into_inner()
}

#[test]
fn the_section_of_a_barrel_lies_on_its_circle_whatever_the_format() {
    let cloud = barrel();
    let of_las = cut(Cursor::new(las(&cloud)), Format::Las, 1.0, Some(&middle())).unwrap();
    let of_e57 = cut(Cursor::new(e57(&cloud)), Format::E57, 1.0, Some(&middle())).unwrap();
    for slice in [&of_las, &of_e57] {
        // Three of the 81 lines along the barrel lie within 60 mm of its middle.
        assert_eq!((slice.of, slice.taken), (400 * 81, 400 * 3));
        assert!(slice.points.len() > 200 && slice.points.len() <= 400, "{}", slice.points.len());
        for [x, y] in &slice.points {
            let radius = (3.0_f64.powi(2) + 1.5_f64.powi(2)) / 3.0;
            let off = (x - 3.001).hypot(y - (21.5 - radius)) - radius;
            assert!(off.abs() < 1.5e-3, "{x} {y}: {off}");
        }
        assert!((slice.extent[2][1] - 21.5).abs() < 2e-3 && (slice.extent[2][0] - 20.0).abs() < 2e-3);
    }
    assert!(of_las.points.windows(2).all(|pair| pair[0][0] < pair[1][0] + CELL), "from left to right");
    // Levels leave out what lies beyond them, and another unit is another size.
    let upper = Cut { levels: [21.0, 22.0], ..middle() };
    assert!(cut(Cursor::new(las(&cloud)), Format::Las, 1.0, Some(&upper)).unwrap().points.iter().all(|p| p[1] >= 21.0));
    let feet = cut(Cursor::new(las(&cloud)), Format::Las, 0.3048, None).unwrap();
    assert!((feet.extent[2][1] - 0.3048 * 21.5).abs() < 1e-3 && feet.points.is_empty());
}

#[test]
fn a_file_that_is_no_cloud_says_so() {
    let no_cloud = |bytes: Vec<u8>, format| cut(Cursor::new(bytes), format, 1.0, None).unwrap_err();
    for format in [Format::Las, Format::E57] {
        assert!(
            matches!(no_cloud(b"bridge = {}".to_vec(), format), CloudError::Unreadable(words) if !words.is_empty())
        );
        assert!(matches!(no_cloud(Vec::new(), format), CloudError::Unreadable(_)));
    }
    let whole = las(&barrel());
    assert!(matches!(no_cloud(whole[..whole.len() / 2].to_vec(), Format::Las), CloudError::Unreadable(_)));
    let whole = e57(&barrel());
    assert!(matches!(no_cloud(whole[..whole.len() / 2].to_vec(), Format::E57), CloudError::Unreadable(_)));
    assert!(matches!(no_cloud(las(&[]), Format::Las), CloudError::Empty));
}
