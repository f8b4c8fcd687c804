//! Tables of `extrados.vehicle-sweep/1`.

use super::objects::kilo;
use super::rows::{Quoted, each, from_one, row};
use crate::vehicles::{VehicleSweep, Weights};

/// Factors on weights as three cells.
fn weight_cells(w: Option<Weights>) -> [Option<f64>; 3] {
    [w.map(|w| w.masonry), w.and_then(|w| w.fill), w.and_then(|w| w.surfacing)]
}

/// Vehicles with their adequacy factors.
pub fn vehicles_table(found: &VehicleSweep) -> String {
    let mut csv = String::from(
        "vehicle,model,status,adequacy_factor,adequacy_factor_at_most,positions,positions_not_converged,lower_bound,upper_bound,without_dilation,rigid_factor,deformable_factor,position_m,direction,first_axle,last_axle,\
         critical_axle,uniform_from_m,uniform_to_m,load_kn_per_m,effective_width_m,weight_masonry,\
         weight_fill,weight_surfacing,arrangement\n",
    );
    for v in &found.vehicles {
        let c = v.case.as_ref();
        row!(
            &mut csv,
            v.code,
            v.model,
            v.status.word(),
            [v.adequacy, v.adequacy_at_most],
            [v.envelope.len(), v.positions_not_converged],
            each(v.bounds),
            v.without_dilation,
            [v.rigid, v.deformable.as_ref().and_then(|d| d.adequacy)],
            c.map(|c| c.position),
            c.map(|c| c.direction.word()),
            each(from_one(c.and_then(|c| c.axles))),
            c.and_then(|c| c.critical_axle).map(|k| k + 1),
            each(c.and_then(|c| c.uniform)),
            c.map(|c| kilo(c.load)),
            v.effective_width,
            weight_cells(v.weights),
            Quoted(c.map_or("", |c| &c.arrangement))
        );
    }
    csv
}

/// The least adequacy factor at every position of every vehicle.
pub fn vehicle_envelope_table(found: &VehicleSweep) -> String {
    let mut csv = String::from(
        "vehicle,direction,position_m,converged,adequacy_factor,rigid_factor,deformable_factor,first_axle,last_axle,weight_masonry,weight_fill,\
         weight_surfacing,arrangement\n",
    );
    for v in &found.vehicles {
        for p in &v.envelope {
            row!(
                &mut csv,
                v.code,
                p.case.direction.word(),
                p.case.position,
                p.converged,
                [p.adequacy, p.rigid, p.deformable],
                each(from_one(p.case.axles)),
                weight_cells(p.weights),
                Quoted(&p.case.arrangement)
            );
        }
    }
    csv
}

/// Extremes at critical joints, each with the values and the position that go with it.
pub fn vehicle_sections_table(found: &VehicleSweep) -> String {
    let mut csv = String::from(
        "vehicle,section,x_m,y_m,depth_m,extreme,thrust_kn_per_m,eccentricity_m,outside_section,shear_kn_per_m,position_m,direction,first_axle,last_axle,\
         weight_masonry,weight_fill,weight_surfacing\n",
    );
    for v in &found.vehicles {
        for s in &v.sections {
            for e in &s.extremes {
                let (case, shear) = (&e.case, kilo(e.shear));
                row!(
                    &mut csv,
                    [&v.code, &s.name],
                    s.at,
                    s.depth,
                    e.of.word(),
                    kilo(e.thrust),
                    e.eccentricity,
                    e.outside,
                    shear,
                    case.position,
                    case.direction.word(),
                    each(from_one(case.axles)),
                    weight_cells(Some(case.weights))
                );
            }
        }
    }
    csv
}
