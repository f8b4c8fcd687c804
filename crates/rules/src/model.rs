//! A load model: vehicles, and what was published of them.

use crate::shape::{table, words};
use crate::{Factor, Impact, Source, Vehicle};

table! {
    /// Vehicles of one standard, and the tables that were published for them.
    pub struct LoadModel = "a file of vehicles" {
        must code: String, "name of the load model in bridge files";
        must title: String, "its name in reports";
        must ways: Ways, "on what it drives";
        must source: Source, "where it is from";
        /// When vehicles stand abreast.
        may[default] abreast: Vec<f64>, "shares of its axle loads in the first lane, the second and so on; all whole where not written";
        may[default] grades: String, "what its vehicles are grades of, where they are, from the lightest up";
        may span_limit: Option<SpanLimit>, "the longest span that it may be used for";
        may[default] only_by_name: bool,
            "whether its vehicles are taken only where they are named, and not among all that a rule is made for; false where not written";
        must[default, rename = "vehicle"] vehicles("vehicle"): Vec<Vehicle>, "its vehicles";
        may[default] checked: Vec<Published>,
            "numbers worked out by hand that it is compared with; those that somebody published stand in `published`";
        may[default] under: Vec<Under>, "factors under rules that do not name it";
        may[default] left_out: Vec<String>, "what the loading has and these vehicles leave out: a verdict names it";
        may[default] loading: String,
            "the loading whose cases its vehicles are, where a bridge must carry all of them; models with the same name belong together";
        may[default] published: Vec<Published>, "numbers that it is compared with";
    }
}

table! {
    /// The longest span that a load model may be used for.
    pub struct SpanLimit = "span_limit" {
        must longest_m: f64, "longest span that the model may be used for [m]";
        must reason: String, "why not longer ones";
        must source: Source, "where that is from";
    }
}

table! {
    /// What a rule does with the loads of a model, in the model's own file.
    pub struct Under = "under" {
        must rule: String, "code of a rule that does not name this model";
        must live_load: Factor, "factor on its loads under that rule";
        must impact: Impact, "what motion adds to them";
        may[default = "crate::rule::yes"] impact_on_uniform: bool,
            "whether motion adds to uniform loads as well; true where it is not written";
        may[default] presence: Vec<f64>, "factors of multiple presence with one lane loaded, two, three; 1 where they are not written";
    }
}

words! {
    /// On what vehicles drive.
    pub enum Ways {
        /// On rails; loads are those of one track.
        Rail = "rail",
        /// On a road; loads are those of one lane.
        Road = "road",
    }
}

table! {
    /// A table of numbers over spans that were published, or worked out by hand.
    pub struct Published = "published" {
        must vehicle: String, "code of the vehicle that the table is compared with";
        must quantity: PublishedQuantity, "what the numbers are";
        must with_uniform: bool, "whether the vehicle's uniform loads take part";
        must spans_m: Vec<f64>, "spans [m]";
        must values: Vec<f64>, "the numbers: kN, kN m or none";
        must tolerance: f64, "how far the vehicle may be from them, relative";
        may[default] above: f64, "how far above them it may be, where it covers them";
        may section: Option<f64>, "where moments are compared, as a share of the span; at the worst section where it is not written";
        must reason: String, "why this tolerance";
        may[default] not_from_vehicle: String, "why the vehicle alone does not give them; they are then read and not compared";
        must source: Source, "where they are from";
    }
}

words! {
    /// What published numbers are: all of a simply supported span.
    pub enum PublishedQuantity {
        /// Uniform load with the same greatest bending moment, as a total [kN].
        EudlBending = "eudl-bending",
        /// Uniform load with the same greatest shear, as a total [kN].
        EudlShear = "eudl-shear",
        /// Greatest bending moment [kN m].
        Bending = "bending",
        /// Greatest shear, at a support [kN].
        Shear = "shear",
        /// Coefficient of dynamic augment of the rule that goes with the model.
        DynamicAugment = "dynamic-augment",
    }
}

impl LoadModel {
    /// The vehicle of this code, in whatever case it is written.
    pub fn vehicle(&self, code: &str) -> Option<&Vehicle> {
        self.vehicles.iter().find(|vehicle| vehicle.code.eq_ignore_ascii_case(code))
    }

    /// Every table that its vehicles are compared with: what was published, then what was worked out by hand.
    pub fn tables(&self) -> impl Iterator<Item = &Published> {
        self.published.iter().chain(&self.checked)
    }

    /// Where a vehicle of the model is from: its own source, or the model's.
    pub fn source_of<'a>(&'a self, vehicle: &'a Vehicle) -> &'a Source {
        vehicle.source.as_ref().unwrap_or(&self.source)
    }
}
