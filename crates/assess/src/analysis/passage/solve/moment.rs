//! The bridge at one moment, for pictures.

use super::mean_stress;
use crate::analysis::passage::Setup;
use mechanics::fem::joint;
use mechanics::fem::{Model, Spring, State};
use mechanics::ids::Id;
use outcome::passage::{Moment, Pair, PairState, Row, RowKind};

/// What stands where in a state; `at` is time [s] and place of the first axle [m] while a train is there.
pub(super) fn moment(setup: &Setup, model: &Model, state: &State, name: &str, at: Option<(f64, f64)>) -> Moment {
    let mesh = &model.mesh;
    let surface = |k: Option<&mechanics::ids::NodeId>| k.map_or(0.0, |node| mesh.nodes[*node].x);
    let ends = (surface(setup.meshed.sets.surface.first()), surface(setup.meshed.sets.surface.last()));
    let axles = at.map_or_else(Vec::new, |(_, front)| setup.loads.axles_above(front, ends.0, ends.1));
    let (time, position) = at.unwrap_or((0.0, 0.0));
    let of_quad = |quad| {
        let [xx, yy, zz, xy] = mean_stress(state, quad);
        [xx, yy, xy, zz]
    };
    Moment {
        name: name.to_owned(),
        time,
        position,
        axles,
        displacements: state.displacements.chunks_exact(2).map(|u| [u[0], u[1]]).collect(),
        stresses: mesh.quads.ids().map(of_quad).collect(),
        yielding: state.points.chunks_exact(4).map(|points| points.iter().any(|point| point.yields)).collect(),
        rows: rows(setup, model, state),
    }
}

fn rows(setup: &Setup, model: &Model, state: &State) -> Vec<Row> {
    let contact = |_| Row { kind: RowKind::Contact, pairs: Vec::new() };
    let mut rows: Vec<Row> = setup.meshed.mesh.interfaces.iter().map(contact).collect();
    for (span, sets) in setup.meshed.sets.spans.iter().enumerate() {
        for (joint, id) in sets.joints[0].iter().enumerate() {
            rows[id.index()].kind = RowKind::Joint { span, joint };
        }
    }
    for (spring, bond) in model.springs.iter().zip(&state.bonds) {
        let state = match bond.state {
            joint::PairState::Closed => PairState::Closed,
            joint::PairState::Open => PairState::Open,
            joint::PairState::Sliding => PairState::Sliding,
        };
        rows[spring.interface.index()].pairs.push(Pair {
            at: place(model, spring),
            area: spring.area,
            normal: bond.traction[0],
            shear: bond.traction[1],
            opening: bond.opening[0],
            sliding: bond.opening[1],
            state,
        });
    }
    rows
}

/// Where a spring was before anything moved [m].
fn place(model: &Model, spring: &Spring) -> [f64; 2] {
    let nodes = spring.shares();
    let sum = nodes.iter().fold([0.0; 3], |[x, y, all], (node, share)| {
        let at = model.mesh.nodes[*node];
        [x + share * at.x, y + share * at.y, all + share]
    });
    [sum[0] / sum[2], sum[1] / sum[2]]
}
