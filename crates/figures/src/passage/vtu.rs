//! The moments as a ParaView series: elements with stress and zone, nodes with displacement; joints as points.

use crate::file::File;
use crate::vtk::{Array, Cells, Grid, over_time};
use outcome::passage::{Moment, Pair, PairState, Passage, RowKind};

/// The ParaView files of a passage: one VTU a moment for the mesh and one for the joints, and their series over time.
pub fn files(passage: &Passage) -> Vec<File> {
    // In order of time.
    let mut order: Vec<usize> = (0..passage.moments.len()).collect();
    order.sort_by(|a, b| passage.moments[*a].time.total_cmp(&passage.moments[*b].time));
    type Writer = fn(&Passage, &Moment) -> Option<String>;
    let mut files = Vec::new();
    for (kind, write) in [("mesh", mesh as Writer), ("joints", joints as Writer)] {
        let moments = order.iter().map(|k| (*k, &passage.moments[*k]));
        files.extend(over_time(kind, moments.filter_map(|(k, one)| Some((k, one.time, write(passage, one)?)))));
    }
    files
}

fn mesh(passage: &Passage, moment: &Moment) -> Option<String> {
    let mesh = &passage.mesh;
    if moment.displacements.len() != mesh.nodes.len() || mesh.quads.is_empty() {
        return None;
    }
    let names: Vec<String> = mesh.zones.iter().enumerate().map(|(k, zone)| format!("{k} {}", zone.name)).collect();
    let remark =
        format!("{}; {}. SI units, y up, tension positive. zone: {}.", passage.bridge, moment.name, names.join(", "));
    let mut at_cells = vec![Array::whole("zone", mesh.zone_of.iter().map(|zone| *zone as i64))];
    if moment.stresses.len() == mesh.quads.len() {
        let stresses = moment.stresses.iter().flat_map(|s| [s[0], s[1], s[3], s[2], 0.0, 0.0]);
        at_cells.push(Array::real("stress", 6, stresses));
    }
    if moment.yielding.len() == mesh.quads.len() {
        at_cells.push(Array::whole("yielding", moment.yielding.iter().map(|yields| i64::from(*yields))));
    }
    let grid = Grid {
        short: true,
        remark: &remark,
        field: &[("time", moment.time), ("first axle", moment.position)],
        points: mesh.nodes.clone(),
        cells: Cells::of(Cells::QUAD, mesh.quads.iter().copied()),
        at_points: vec![
            Array::vectors("displacement", moment.displacements.iter().copied()),
            Array::vectors("displacement by the train", super::scene::by_train(passage, moment)),
        ],
        at_cells,
    };
    Some(grid.file())
}

fn joints(passage: &Passage, moment: &Moment) -> Option<String> {
    let pairs: Vec<_> = moment.rows.iter().flat_map(|row| row.pairs.iter().map(move |pair| (row.kind, pair))).collect();
    if pairs.is_empty() {
        return None;
    }
    let real = |name, value: fn(&Pair) -> f64| Array::real(name, 1, pairs.iter().map(|(_, pair)| value(pair)));
    let state = pairs.iter().map(|(_, pair)| match pair.state {
        PairState::Closed => 0,
        PairState::Open => 1,
        PairState::Sliding => 2,
    });
    let remark =
        format!("{}; {}. SI units, tension positive. state: 0 closed, 1 open, 2 sliding.", passage.bridge, moment.name);
    let grid = Grid {
        short: true,
        remark: &remark,
        field: &[("time", moment.time), ("first axle", moment.position)],
        points: pairs.iter().map(|(_, pair)| pair.at).collect(),
        cells: Cells::points(pairs.len()),
        at_points: vec![
            real("normal traction", |pair| pair.normal),
            real("shear traction", |pair| pair.shear),
            real("opening", |pair| pair.opening),
            real("sliding", |pair| pair.sliding),
            Array::whole("state", state),
            Array::whole("contact with fill", pairs.iter().map(|(kind, _)| i64::from(*kind == RowKind::Contact))),
        ],
        ..Grid::default()
    };
    Some(grid.file())
}
