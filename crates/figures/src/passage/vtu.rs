//! The moments as a ParaView series: elements with stress and zone, nodes with displacement; joints as points.

use crate::all::File;
use crate::vtk::{Array, Grid, series};
use outcome::passage::Passage;
use outcome::passage::{Moment, PairState, RowKind};

/// VTK's numbers of a quadrilateral and of a point.
const QUAD: u8 = 9;
const VERTEX: u8 = 1;

/// One VTU a moment for the mesh and one for the joints, and their series over time.
pub fn files(passage: &Passage) -> Vec<File> {
    let mut files = Vec::new();
    let mut put = |name: String, text: String| {
        files.push(File { name: format!("paraview/{name}"), bytes: text.into_bytes() });
    };
    type Writer = fn(&Passage, &Moment) -> Option<String>;
    for (kind, write) in [("mesh", mesh as Writer), ("joints", joints as Writer)] {
        let mut listed: Vec<(f64, String)> = Vec::new();
        // In order of time; ParaView takes files of the same time for parts of one state.
        let mut order: Vec<usize> = (0..passage.moments.len()).collect();
        order.sort_by(|a, b| passage.moments[*a].time.total_cmp(&passage.moments[*b].time));
        for k in order {
            let moment = &passage.moments[k];
            let Some(text) = write(passage, moment) else { continue };
            let name = format!("{kind}-{k:04}.vtu");
            let time = match listed.last() {
                Some((last, _)) if moment.time <= *last => last + 1e-6,
                _ => moment.time,
            };
            listed.push((time, name.clone()));
            put(name, text);
        }
        if !listed.is_empty() {
            put(format!("{kind}.pvd"), series(&listed));
        }
    }
    files
}

fn mesh(passage: &Passage, moment: &Moment) -> Option<String> {
    let mesh = &passage.mesh;
    if moment.displacements.len() != mesh.nodes.len() || mesh.quads.is_empty() {
        return None;
    }
    let flat = |points: &[[f64; 2]]| -> Vec<f64> { points.iter().flat_map(|p| [p[0], p[1], 0.0]).collect() };
    let (points, displacement) = (flat(&mesh.nodes), flat(&moment.displacements));
    let train = flat(&super::scene::by_train(passage, moment));
    let connectivity: Vec<i64> = mesh.quads.iter().flatten().map(|node| *node as i64).collect();
    let offsets: Vec<i64> = (1..=mesh.quads.len()).map(|k| 4 * k as i64).collect();
    let zone: Vec<i64> = mesh.zone_of.iter().map(|zone| *zone as i64).collect();
    let stress: Vec<f64> = moment.stresses.iter().flat_map(|s| [s[0], s[1], s[3], s[2], 0.0, 0.0]).collect();
    let yielding: Vec<i64> = moment.yielding.iter().map(|yields| i64::from(*yields)).collect();
    let names: Vec<String> = mesh.zones.iter().enumerate().map(|(k, zone)| format!("{k} {}", zone.name)).collect();
    let remark =
        format!("{}; {}. SI units, y up, tension positive. zone: {}.", passage.bridge, moment.name, names.join(", "));
    let mut cells = vec![Array::whole("zone", &zone)];
    if moment.stresses.len() == mesh.quads.len() {
        cells.push(Array::real("stress", 6, &stress));
    }
    if moment.yielding.len() == mesh.quads.len() {
        cells.push(Array::whole("yielding", &yielding));
    }
    let grid = Grid {
        short: true,
        remark: &remark,
        field: &[("time", moment.time), ("first axle", moment.position)],
        points: &points,
        connectivity: &connectivity,
        offsets: &offsets,
        kinds: &vec![QUAD; mesh.quads.len()],
        at_points: &[
            Array::real("displacement", 3, &displacement),
            Array::real("displacement by the train", 3, &train),
        ],
        at_cells: &cells,
    };
    Some(grid.file())
}

fn joints(passage: &Passage, moment: &Moment) -> Option<String> {
    let pairs: Vec<_> = moment.rows.iter().flat_map(|row| row.pairs.iter().map(move |pair| (row.kind, pair))).collect();
    if pairs.is_empty() {
        return None;
    }
    let points: Vec<f64> = pairs.iter().flat_map(|(_, pair)| [pair.at[0], pair.at[1], 0.0]).collect();
    let numbers: Vec<i64> = (0..pairs.len() as i64).collect();
    let offsets: Vec<i64> = (1..=pairs.len() as i64).collect();
    let of =
        |value: fn(&outcome::passage::Pair) -> f64| -> Vec<f64> { pairs.iter().map(|(_, pair)| value(pair)).collect() };
    let state: Vec<i64> = pairs
        .iter()
        .map(|(_, pair)| match pair.state {
            PairState::Closed => 0,
            PairState::Open => 1,
            PairState::Sliding => 2,
        })
        .collect();
    let contact: Vec<i64> = pairs.iter().map(|(kind, _)| i64::from(*kind == RowKind::Contact)).collect();
    let (normal, shear) = (of(|pair| pair.normal), of(|pair| pair.shear));
    let (opening, sliding) = (of(|pair| pair.opening), of(|pair| pair.sliding));
    let remark =
        format!("{}; {}. SI units, tension positive. state: 0 closed, 1 open, 2 sliding.", passage.bridge, moment.name);
    let grid = Grid {
        short: true,
        remark: &remark,
        field: &[("time", moment.time), ("first axle", moment.position)],
        points: &points,
        connectivity: &numbers,
        offsets: &offsets,
        kinds: &vec![VERTEX; pairs.len()],
        at_points: &[
            Array::real("normal traction", 1, &normal),
            Array::real("shear traction", 1, &shear),
            Array::real("opening", 1, &opening),
            Array::real("sliding", 1, &sliding),
            Array::whole("state", &state),
            Array::whole("contact with fill", &contact),
        ],
        at_cells: &[],
    };
    Some(grid.file())
}
