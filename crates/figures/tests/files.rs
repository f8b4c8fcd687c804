//! Files as they are written: PNG pictures and ParaView grids, read back.

mod sample;

use base64::{Engine, engine::general_purpose::STANDARD};
use outcome::picture::{Motion, Picture};
use roxmltree::Document;

fn bytes(document: &Document, name: &str) -> Vec<u8> {
    let array = document.descendants().find(|n| n.attribute("Name") == Some(name)).unwrap_or_else(|| panic!("{name}"));
    let packed = STANDARD.decode(array.text().unwrap()).unwrap();
    let (head, body) = packed.split_at(8);
    assert_eq!(u64::from_le_bytes(head.try_into().unwrap()) as usize, body.len(), "{name}");
    body.to_vec()
}

fn reals(document: &Document, name: &str) -> Vec<f64> {
    bytes(document, name).chunks_exact(8).map(|c| f64::from_le_bytes(c.try_into().unwrap())).collect()
}

fn wholes(document: &Document, name: &str) -> Vec<i64> {
    bytes(document, name).chunks_exact(8).map(|c| i64::from_le_bytes(c.try_into().unwrap())).collect()
}

#[test]
fn blocks_read_back_as_written() {
    let mut picture = sample::single_block();
    let quarter = Motion { translation: [0.5, 0.25], rotation: std::f64::consts::FRAC_PI_2 };
    let mut state = sample::arch().snapshots[0].clone();
    state.load = 1234.5;
    state.motions = vec![quarter, Motion::default()];
    state.velocities = vec![[1.0, 2.0], [0.0, 0.0]];
    state.stresses = vec![[-3.0, 1.0, 0.5], [0.0; 3]];
    picture.snapshots = vec![state];
    let file = figures::vtk::blocks(&picture, 0).unwrap();
    let document = Document::parse(&file).unwrap();
    assert_eq!(wholes(&document, "connectivity"), (0..8).collect::<Vec<i64>>());
    assert_eq!(wholes(&document, "offsets"), [4, 8]);
    assert_eq!(bytes(&document, "types"), [7, 7]);
    assert_eq!(wholes(&document, "role"), [4, 1]);
    assert_eq!(wholes(&document, "held"), [0, 1]);
    assert_eq!(reals(&document, "load"), [1234.5]);
    assert_eq!(reals(&document, "velocity"), [1.0, 2.0, 0.0, 0.0, 0.0, 0.0]);
    assert_eq!(reals(&document, "stress")[..9], [-3.0, 0.5, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0, 0.0]);
    let (points, moves) = (reals(&document, "Points"), reals(&document, "displacement"));
    assert_eq!((points.len(), moves.len()), (24, 24));
    // The corner at (0, 0) of the block 10 by 20 mm turns about (5, 10) mm to (15, 5) mm, then moves on.
    let now = [points[0] + moves[0], points[1] + moves[1]];
    assert!((now[0] - 0.515).abs() < 1e-15 && (now[1] - 0.255).abs() < 1e-15, "{now:?}");
    assert_eq!(moves[12..], [0.0; 12]);
}

#[test]
fn contacts_read_back_as_written() {
    let picture = sample::arch();
    let file = figures::vtk::contacts(&picture, 3).unwrap();
    let document = Document::parse(&file).unwrap();
    let list = &picture.snapshots[3].contacts;
    let expected = |f: fn(&outcome::picture::ContactForce) -> f64| list.iter().map(f).collect::<Vec<f64>>();
    assert_eq!(reals(&document, "compression"), expected(|c| c.compression));
    assert_eq!(reals(&document, "shear"), expected(|c| c.shear));
    assert_eq!(reals(&document, "stress"), expected(|c| c.stress));
    assert_eq!(reals(&document, "normal").len(), 3 * list.len());
    assert!(bytes(&document, "types").iter().all(|&t| t == 1));
    assert_eq!(wholes(&document, "second block"), list.iter().map(|c| c.blocks[1] as i64).collect::<Vec<_>>());
}

#[test]
fn the_series_names_files_that_are_written_at_times_that_grow() {
    let files = figures::paraview(&sample::arch());
    for series in ["blocks", "contacts"] {
        let file = files.iter().find(|f| f.name == format!("paraview/{series}.pvd")).unwrap();
        let text = String::from_utf8(file.bytes.clone()).unwrap();
        let document = Document::parse(&text).unwrap();
        let sets: Vec<_> = document.descendants().filter(|n| n.has_tag_name("DataSet")).collect();
        assert_eq!(sets.len(), 9);
        let times: Vec<f64> = sets.iter().map(|n| n.attribute("timestep").unwrap().parse().unwrap()).collect();
        assert!(times.windows(2).all(|w| w[1] > w[0]), "{times:?}");
        // Load in kN/m, where it grows.
        assert!((times[3] - 204.82).abs() < 1e-3, "{times:?}");
        for set in sets {
            let name = format!("paraview/{}", set.attribute("file").unwrap());
            assert!(files.iter().any(|f| f.name == name), "{name}");
        }
    }
}

#[test]
fn the_mechanism_is_a_grid_of_its_own() {
    let picture = sample::arch();
    let file = figures::vtk::mechanism(&picture).unwrap();
    let moves = reals(&Document::parse(&file).unwrap(), "displacement");
    let largest = moves.chunks(3).map(|u| u[0].hypot(u[1])).fold(0.0, f64::max);
    // The centroid that moves most moves by 1 m; the corners of its block by a little more.
    assert!((1.0..1.3).contains(&largest), "{largest}");
    assert!(figures::vtk::mechanism(&Picture::default()).is_none());
}

#[test]
fn everything_is_the_same_twice_and_named_once() {
    let (a, b) = (sample::all(&sample::two_rings()).unwrap(), sample::all(&sample::two_rings()).unwrap());
    assert!(!a.is_empty());
    assert!(a == b, "files differ between two calls");
    let names: std::collections::BTreeSet<_> = a.iter().map(|f| &f.name).collect();
    assert_eq!(names.len(), a.len());
    assert!(names.iter().all(|n| !n.starts_with('/') && !n.contains("..")));
}

#[test]
fn pictures_are_as_wide_as_asked_and_their_text_is_there() {
    let svg = figures::bridge_as_drawn(&sample::arch());
    let size = |png: &[u8]| {
        let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
        assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
        (number(16), number(20))
    };
    let png = figures::png(&svg, 1600).unwrap();
    let document = Document::parse(&svg).unwrap();
    let view: Vec<f64> =
        document.root_element().attribute("viewBox").unwrap().split(' ').map(|v| v.parse().unwrap()).collect();
    let (wide, high) = size(&png);
    assert_eq!(wide, 1600);
    assert!((f64::from(high) - 1600.0 * view[3] / view[2]).abs() <= 1.0);
    let mute: String = svg.lines().filter(|l| !l.starts_with("<text")).collect();
    let mute = figures::png(&mute, 1600).unwrap();
    assert_eq!(size(&mute), (wide, high));
    assert_ne!(mute, png, "text is not drawn");
}

#[test]
fn a_broken_drawing_or_an_absurd_size_is_an_answer() {
    assert!(matches!(figures::png("<svg", 100), Err(figures::RasterError::Svg(_))));
    let svg = figures::bridge_as_drawn(&Picture::default());
    assert!(matches!(figures::png(&svg, 0), Err(figures::RasterError::Size(0, _))));
    assert!(matches!(figures::png(&svg, 1_000_000), Err(figures::RasterError::Size(..))));
}

fn singles(document: &Document, name: &str) -> Vec<f32> {
    bytes(document, name).chunks_exact(4).map(|c| f32::from_le_bytes(c.try_into().unwrap())).collect()
}

fn shorts(document: &Document, name: &str) -> Vec<i32> {
    bytes(document, name).chunks_exact(4).map(|c| i32::from_le_bytes(c.try_into().unwrap())).collect()
}

#[test]
fn particles_and_their_forces_read_back_as_written() {
    let picture = sample::filled();
    let state = &picture.snapshots[5];
    let file = figures::vtk::particles(&picture, 5).unwrap();
    let document = Document::parse(&file).unwrap();
    let count = picture.particles.len();
    assert!(bytes(&document, "types").iter().all(|&t| t == 1));
    assert_eq!(singles(&document, "radius_m"), picture.particles.iter().map(|d| d.radius as f32).collect::<Vec<_>>());
    assert_eq!(shorts(&document, "layer")[0], picture.particles[0].layer as i32);
    assert_eq!(
        singles(&document, "stress_yy_kpa"),
        state.particles.iter().map(|p| (p.stress[1] / 1e3) as f32).collect::<Vec<_>>()
    );
    let (points, moved) = (singles(&document, "Points"), singles(&document, "displacement_m"));
    for k in 0..count {
        assert_eq!([points[3 * k], points[3 * k + 1]], state.particles[k].centre.map(|c| c as f32));
        // Seven digits of some metres.
        let packed = picture.particles[k].centre[1] as f32;
        assert!((points[3 * k + 1] - moved[3 * k + 1] - packed).abs() < 2e-6);
    }

    let file = figures::vtk::particle_forces(&picture, 5).unwrap();
    let document = Document::parse(&file).unwrap();
    let list = &state.particle_forces;
    assert!(bytes(&document, "types").iter().all(|&t| t == 3));
    assert_eq!(shorts(&document, "offsets").last(), Some(&(2 * list.len() as i32)));
    let expected: Vec<f32> = list.iter().map(|f| (f.compression / 1e3) as f32).collect();
    assert_eq!(singles(&document, "compression_kn_per_m"), expected);
    let (block, other) = (shorts(&document, "partner_block"), shorts(&document, "partner_particle"));
    assert!(block.iter().zip(&other).all(|(b, o)| (*b < 0) != (*o < 0)));
    assert!(figures::vtk::particles(&sample::arch(), 0).is_none());
}

#[test]
fn the_animation_has_a_frame_for_every_state_and_says_for_how_long() {
    let file = figures::animation(&sample::filled()).unwrap().unwrap();
    assert!(file.len() < 2_000_000, "{} bytes", file.len());
    let mut reader = png::Decoder::new(&file[..]).read_info().unwrap();
    assert_eq!(reader.info().animation_control.unwrap().num_frames, 9);
    let mut buffer = vec![0; reader.output_buffer_size()];
    for k in 0..9 {
        reader.next_frame(&mut buffer).unwrap();
        let shown = reader.info().frame_control().unwrap().delay_num;
        assert_eq!(
            shown,
            if k < 4 {
                400
            } else if k < 8 {
                160
            } else {
                2500
            }
        );
    }
    assert!(figures::animation(&sample::two_rings()).unwrap().is_none());
}

#[test]
fn runs_without_particles_have_none_of_their_files() {
    let names: Vec<String> = sample::all(&sample::arch()).unwrap().into_iter().map(|f| f.name).collect();
    for part in ["packing", "force-chains", "displacement.", "fill-stress", "particle"] {
        let own = |n: &String| n.trim_start_matches("paraview/").starts_with(part);
        assert!(!names.iter().any(own), "{part}: {names:?}");
    }
    let names: Vec<String> = sample::all(&sample::filled()).unwrap().into_iter().map(|f| f.name).collect();
    for name in ["packing.svg", "force-chains.png", "displacement.svg", "fill-stress.svg", "animation.png"] {
        assert!(names.iter().any(|n| n == name), "{name}: {names:?}");
    }
    for name in ["paraview/particles.pvd", "paraview/particle-forces-0008.vtu"] {
        assert!(names.iter().any(|n| n == name), "{name}: {names:?}");
    }
}

#[test]
fn a_mesh_reads_back_as_written() {
    use outcome::mesh::{MadeOf, MeshPicture, Zone};
    let zone = |name: &str, made_of| Zone { name: name.into(), made_of, quads: 1 };
    let mesh = MeshPicture {
        nodes: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 0.5], [0.0, 0.5], [1.0, 1.0], [0.0, 1.0]],
        quads: vec![[0, 1, 2, 3], [3, 2, 4, 5]],
        zone_of: vec![0, 1],
        scaled_jacobian: vec![1.0, 1.0],
        zones: vec![zone("voussoirs span 1", MadeOf::Voussoirs), zone("fill", MadeOf::Fill)],
        interfaces: vec![(vec![0, 3], "mortar joint".into())],
        surface: vec![[0.0, 1.0], [1.0, 1.0]],
        springings: vec![],
        base: vec![0, 1],
        remark: "2 elements".into(),
    };
    let file = figures::vtk::mesh(&mesh);
    let document = Document::parse(&file).unwrap();
    assert_eq!(wholes(&document, "connectivity"), [0, 1, 2, 3, 3, 2, 4, 5]);
    assert_eq!(wholes(&document, "offsets"), [4, 8]);
    assert_eq!(bytes(&document, "types"), [9, 9]);
    assert_eq!(wholes(&document, "zone"), [0, 1]);
    assert_eq!(reals(&document, "Points")[6..9], [1.0, 0.5, 0.0]);
    let drawing = figures::mesh("Small & square", &mesh);
    Document::parse(&drawing).unwrap();
    assert!(
        drawing.contains("voussoirs (1)") && drawing.contains("Small &amp; square") && drawing.contains("2 elements.")
    );
    let nothing =
        MeshPicture { nodes: vec![], quads: vec![], zone_of: vec![], interfaces: vec![], base: vec![], ..mesh };
    Document::parse(&figures::mesh("Nothing", &nothing)).unwrap();
}

#[test]
fn soil_reads_back_as_written() {
    let picture = sample::soils::two_triangles();
    let file = figures::vtk::soil(&picture).unwrap();
    let document = Document::parse(&file).unwrap();
    let piece = document.descendants().find(|n| n.has_tag_name("Piece")).unwrap();
    assert_eq!((piece.attribute("NumberOfPoints"), piece.attribute("NumberOfCells")), (Some("4"), Some("2")));
    assert_eq!(wholes(&document, "connectivity"), [0, 1, 2, 0, 2, 3]);
    assert_eq!(wholes(&document, "offsets"), [3, 6]);
    assert_eq!(bytes(&document, "types"), [5, 5]);
    assert_eq!(wholes(&document, "region"), [0, 0]);
    assert_eq!(reals(&document, "dissipation"), [1.0, 0.0]);
    assert_eq!(reals(&document, "gap"), [0.75, 0.25]);
    assert_eq!(reals(&document, "motion")[..6], [0.5, 0.0, 0.0, 0.5, 0.0, 0.0]);
    // The mean of three equal thirds.
    let stress = [-2e3, 1e3, 0.0, 1e3, -10e3, 0.0, 0.0, 0.0, 0.0];
    for (read, written) in reals(&document, "stress")[9..].iter().zip(stress) {
        assert!((read - written).abs() < 1e-9, "{read} {written}");
    }
    let names: Vec<String> = figures::paraview(&picture).into_iter().map(|f| f.name).collect();
    assert!(names.contains(&"paraview/soil.vtu".to_owned()), "{names:?}");
    assert!(figures::vtk::soil(&sample::arch()).is_none());
}
