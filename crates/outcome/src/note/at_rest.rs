//! Loads at rest over finite elements.

use crate::sentences::notes;

notes! {
    /// What a load test assumes.
    AtRest {
        Independent => "Each position at rest is reached from the unloaded bridge, as if it were the only one (`sequence = \"independent\"`).";
        InOrder => "Positions at rest are gone through in the order of the file, the loads taken off after each (`sequence = \"in-order\"`): what has \
                    yielded or slid stays so in all that follow. Every value is a change from the bridge before the first position.";
        /// The vehicle of the file: the width that carries an axle of it.
        Vehicle { width [m]: f64, of_file: bool } =>
            "an axle of the vehicle at rest is carried by {width:.3} m of the bridge's width, {}",
            if *of_file { "as the file says" } else { "as one that crosses is" };
        Library => "an axle of a vehicle of the library is carried by the distance between its wheels spread 1:2 to either side through the cover over the crown, \
                    not wider than the barrel; one on rails as those of [train]";
        Forces => "a force is carried by its own width spread 1:2 to either side through the cover over the crown, not wider than the barrel, and by the whole \
                   barrel where it has no width";
    }
}
