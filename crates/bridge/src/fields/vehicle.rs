//! A road vehicle that crosses.

use super::train::{axles, within};
use crate::card::{Section, joined};
use crate::cards::*;
use crate::findings::Findings;
use crate::passage::{Way, Wheels};
use crate::train::{Train, Vehicle};
use crate::tree::Table;

pub(super) static VEHICLE: Section = Section {
    path: "vehicle",
    doc: "The road vehicle that crosses: its axles press on the road through their wheels, and the layers of the mesh spread what they bring along the \
          bridge. Give `axle_loads` or `axle_forces`. Vehicles that are moved to collapse are named in [sweep].",
    fields: &joined::<6>(&[
        &[
            text("name", "name of the vehicle", "test lorry").optional("vehicle"),
            masses(
                "axle_loads",
                "mass on each axle, from the first one back; a single value is for all",
                r#"["6.1 t", "9.5 t"]"#,
            )
            .positive_up_to(1e6)
            .optional("given by `axle_forces`"),
            forces(
                "axle_forces",
                "force of each axle, from the first one back; a single value is for all",
                r#"["60 kN", "93 kN"]"#,
            )
            .positive_up_to(1e7)
            .optional("given by `axle_loads`"),
            lengths(
                "axle_spacings",
                "distances between the axles, one fewer than the axles; [] for a single axle",
                r#"["3.6 m"]"#,
            )
            .positive(),
        ],
        Wheels::CARDS,
    ]),
};

/// The vehicle and how its wheels press. `width` of the barrel [m].
pub(super) fn vehicle(file: &Table<'_>, width: Option<f64>, findings: &mut Findings) -> (Option<Train>, Option<Way>) {
    let Some(table) = file.table("vehicle", findings) else { return (None, None) };
    let name: Option<Option<String>> = table.read("name", findings);
    let axles = axles(&table, findings);
    let wheels = Wheels::of(&table, findings);
    if let Some(wheels) = &wheels {
        within(&table, wheels.effective_width, width, findings);
    }
    let train = name.zip(axles).map(|(name, (loads, spacings))| {
        let name = name.unwrap_or_else(|| "vehicle".to_owned());
        let vehicle = Vehicle { name: name.clone(), count: 1, loads, spacings, overhangs: [0.0; 2] };
        Train { name, file: None, vehicles: vec![vehicle] }
    });
    (train, wheels.map(Way::Road))
}
