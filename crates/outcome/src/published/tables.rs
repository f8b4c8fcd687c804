//! CSV tables: a header with units, a row per item, points as decimal separators, no quoting needed.

use super::collapse::edge;
use crate::collapse::Collapse;
use crate::sweep::Sweep;
use bridge::Analysis;
use std::fmt::Write;

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
        let [x, y] = s.displacement.map(|d| 1e3 * d);
        row(&mut csv, format_args!("{},{x},{y},{},{},{}", s.load / unit, s.iterations, s.unbalanced_ratio, s.at_rest));
    }
    csv
}

/// Hinges of the mechanism.
pub fn hinges(c: &Collapse) -> String {
    let mut csv = String::from("x_m,y_m,edge,rotation,first_side,second_side\n");
    for h in &c.hinges {
        let [first, second] = c.sides(h).unwrap_or_default().map(super::vary::quoted);
        let [x, y] = h.point;
        row(&mut csv, format_args!("{x},{y},{},{},{first},{second}", edge(h.edge), h.rotation));
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
            row(
                &mut csv,
                format_args!(
                    "{},{},{},{},{},{},{},{},{},{},{}",
                    s.load / unit,
                    k.blocks[0],
                    k.blocks[1],
                    k.point[0],
                    k.point[1],
                    k.normal[0],
                    k.normal[1],
                    k.compression / 1e3,
                    k.shear / 1e3,
                    k.stress / 1e6,
                    k.sliding
                ),
            );
        }
    }
    csv
}

/// Points of the line of thrust, line by line.
pub fn thrust_line(c: &Collapse) -> String {
    let mut csv = String::from("line,x_m,y_m,thrust_kn_per_m\n");
    for (k, line) in c.picture.thrust_lines.iter().enumerate() {
        for p in line {
            row(&mut csv, format_args!("{k},{},{},{}", p.point[0], p.point[1], p.thrust / 1e3));
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
            let [x, y] = m.translation.map(|d| 1e3 * d);
            let stress = s.stresses.get(k).map(|stress| stress.map(|v| (v / 1e6).to_string()));
            let [xx, yy, xy] = stress.unwrap_or_default();
            row(
                &mut csv,
                format_args!(
                    "{},{k},{name},{},{},{x},{y},{},{xx},{yy},{xy}",
                    s.load / unit,
                    shape.role,
                    shape.held,
                    m.rotation
                ),
            );
        }
    }
    csv
}

/// Positions of a sweep.
pub fn sweep_table(sweep: &Sweep) -> String {
    let mut csv = String::from(
        "position_m,offset_m,status,load_factor,last_stable_load_kn_per_m,collapse_load_kn_per_m,first_axle,last_axle\n",
    );
    let number = |v: Option<f64>| v.map_or(String::new(), |v| v.to_string());
    for p in &sweep.points {
        row(
            &mut csv,
            format_args!(
                "{},{},{},{},{},{},{},{}",
                p.position,
                p.offset,
                p.status.word(),
                number(p.load_factor),
                number(p.collapse_load.map(|l| l / 1e3)),
                number(p.collapse_load.map(|l| l / 1e3)),
                p.axles[0] + 1,
                p.axles[1] + 1
            ),
        );
    }
    csv
}

pub(super) fn row(csv: &mut String, cells: std::fmt::Arguments<'_>) {
    writeln!(csv, "{cells}").expect("a string takes every line");
}
