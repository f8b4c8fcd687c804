//! What stands at the edges of the road: parapets and kerbs. Drawn and weighed, and loads of no analysis.

use crate::cards::*;
use crate::values::of_keys;

of_keys! {
    /// Parapets, one at each edge of the barrel.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Parapet {
        pub height: f64 = length("height above the surface of the road", "1.0 m").positive_up_to(5.0),
        pub thickness: f64 = length("thickness of one of them", "0.40 m").positive_up_to(3.0),
        pub density: Option<f64> = density("mass density", "2200 kg/m^3").positive().optional("as [masonry] says"),
    }
}

of_keys! {
    /// Kerbs, one at each edge, and what is raised behind them: a footway or a verge.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Kerb {
        pub distance: f64 =
            length("distance of the kerb's face from the edge of the barrel", "0.90 m").positive_up_to(20.0),
        pub upstand: f64 = length("height of the kerb above the surface of the road", "0.10 m").positive_up_to(1.0),
        pub density: Option<f64> = density("mass density of what is raised behind it", "2000 kg/m^3")
            .positive()
            .optional("as the uppermost layer of [[cover]]"),
    }
}
