//! CSV tables of collapse analyses and sweeps: a header with units, a row per item.

use super::rows::{each, row};
use crate::collapse::Collapse;
use crate::sweep::Sweep;
use bridge::Analysis;

/// What the states of an analysis are counted by, and what divides its SI unit: a load, or the movement of a support.
pub(super) fn counted(c: &Collapse) -> (&'static str, f64) {
    match c.analysis() {
        Analysis::SupportMovement => ("movement_m", 1.0),
        _ => ("load_kn_per_m", 1e3),
    }
}

/// Load steps of a discrete element run.
pub fn path(c: &Collapse) -> String {
    let (name, unit) = counted(c);
    let mut csv = format!("{name},displacement_x_mm,displacement_y_mm,iterations,unbalanced_ratio,at_rest\n");
    for s in &c.picture.path {
        row!(&mut csv, s.load / unit, s.displacement.map(|d| 1e3 * d), s.iterations, s.unbalanced_ratio, s.at_rest);
    }
    csv
}

/// Hinges of the mechanism.
pub fn hinges(c: &Collapse) -> String {
    let mut csv = String::from("x_m,y_m,edge,rotation,first_side,second_side\n");
    for h in &c.picture.hinges {
        row!(&mut csv, h.point, h.edge.word(), h.rotation, c.sides(h).unwrap_or_default());
    }
    csv
}

/// Contacts of every snapshot.
pub fn contacts(c: &Collapse) -> String {
    let (name, unit) = counted(c);
    let mut csv = format!(
        "{name},first_block,second_block,x_m,y_m,normal_x,normal_y,compression_kn_per_m,shear_kn_per_m,stress_mpa,sliding\n",
    );
    for s in &c.picture.snapshots {
        for k in &s.contacts {
            let force = [k.compression / 1e3, k.shear / 1e3, k.stress / 1e6];
            row!(&mut csv, s.load / unit, k.blocks, k.point, k.normal, force, k.sliding);
        }
    }
    csv
}

/// Points of the line of thrust, line by line.
pub fn thrust_line(c: &Collapse) -> String {
    let mut csv = String::from("line,x_m,y_m,thrust_kn_per_m\n");
    for (k, line) in c.picture.thrust_lines.iter().enumerate() {
        for p in line {
            row!(&mut csv, k, p.point, p.thrust / 1e3);
        }
    }
    csv
}

/// Blocks of every snapshot: what they are, how they moved, their average stress where it is known.
pub fn blocks(c: &Collapse) -> String {
    let (name, unit) = counted(c);
    let mut csv = format!(
        "{name},block,name,role,held,displacement_x_mm,displacement_y_mm,rotation_rad,stress_xx_mpa,stress_yy_mpa,stress_xy_mpa\n",
    );
    for s in &c.picture.snapshots {
        let rows = c.picture.shapes.iter().zip(&s.motions).zip(&c.block_names).enumerate();
        for (k, ((shape, m), name)) in rows {
            let moved = m.translation.map(|d| 1e3 * d);
            let stress = each(s.stresses.get(k).map(|stress| stress.map(|v| v / 1e6)));
            row!(&mut csv, s.load / unit, k, name, shape.role, shape.held, moved, m.rotation, stress);
        }
    }
    csv
}

/// Positions of a sweep.
pub fn sweep_table(sweep: &Sweep) -> String {
    let mut csv = String::from(
        "position_m,offset_m,status,load_factor,last_stable_load_kn_per_m,collapse_load_kn_per_m,first_axle,last_axle,\
         rigid_factor,deformable_factor,upper_bound_factor\n",
    );
    for p in &sweep.points {
        let load = p.collapse_load.map(|l| l / 1e3);
        let axles = p.axles.map(|k| k + 1);
        let both = [p.rigid_factor, p.deformable_factor, p.upper_factor];
        row!(&mut csv, p.position, p.offset, p.status.word(), p.load_factor, load, load, axles, both);
    }
    csv
}
