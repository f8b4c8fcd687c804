//! A bridge of some hundred elements, for tests that need all of it in a moment.

/// One span under one wagon of ten tonnes: an evaluation takes hundredths of a second.
pub(crate) const BRIDGE: &str = r#"bridge = { name = "Tiny", width = "4 m" } # a bridge of a test
span = { profile = "segmental", span = "4 m", rise = "1 m", thickness = "0.5 m", voussoirs = 9 }
abutment = { top_width = "1 m", height = "1 m" }
joint = { friction_angle = "35 deg", cohesion = "0 kPa" }
load = { kind = "knife-edge", force = "10 kN/m", length = "0.3 m", at = "1/4 of span 1" }

[masonry]
density = "2200 kg/m^3"        # weighed
elastic_modulus = "10 GPa"
poisson_ratio = 0.2
compressive_strength = "10 MPa"

[[cover]]
layer = "fill"
thickness = "0.4 m"
density = "1800 kg/m^3"

[dispersal]
rule = "uniform"
slope = "2:1"

[mesh]
size = "0.6 m"
ring_nodes = 3

[fill]
elastic_modulus = "100 MPa"
poisson_ratio = 0.2
density = "1800 kg/m^3"
friction_angle = "30 deg"
cohesion = "50 kPa"

[mortar]
elastic_modulus = "1 GPa"
thickness = "10 mm"
lift_off = "100 kN"

[fill_contact]
friction_coefficient = 0.6
separation = false

[train]
name = "one wagon"

[[train.vehicle]]
axle_loads = ["10 t"]
axle_spacings = ["2.0 m"]
front_overhang = "1 m"
rear_overhang = "1 m"

[track]
rail_bending_stiffness = "4 MNm^2"
track_modulus = "30 MPa"
sleeper_spacing = "0.60 m"
sleeper_breadth = "0.25 m"
sleeper_length = "2.75 m"
ballast_depth = "0.25 m"
ballast_slope = "2:1"
dead_load = "3 kPa"

[passage]
speed = "36 km/h"
time_step = "0.04 s"
from = "-3 m"
to = "9 m"

[[sensor]]
name = "crown"
kind = "displacement"
direction = "vertical"
place = "crown"

[[sensor]]
name = "quarter"
kind = "displacement"
direction = "vertical"
at = "1/4 of span 1"

[[sensor]]
name = "strain"
kind = "strain"
gauge_length = "100 mm"
place = "left-springing"
"#;
