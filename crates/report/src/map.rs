//! Many bridges as points on a map.

use crate::FleetRow;
use serde_json::{Value, json};

/// The bridges as GeoJSON (RFC 7946): a point for each that has a place, with longitude before latitude as that format has it; bridges without a
/// place are features without a geometry, so that a table of attributes has them all. None where no bridge has a place.
pub fn fleet_geojson(rows: &[FleetRow]) -> Option<String> {
    rows.iter().any(|row| row.place.is_some()).then(|| {
        let features: Vec<Value> = rows.iter().map(feature).collect();
        let map = json!({ "type": "FeatureCollection", "features": features });
        serde_json::to_string_pretty(&map).unwrap_or_default() + "\n"
    })
}

fn feature(row: &FleetRow) -> Value {
    let point = |[latitude, longitude]: [f64; 2]| json!({ "type": "Point", "coordinates": [longitude, latitude] });
    let text = |text: &str| if text.is_empty() { Value::Null } else { json!(text) };
    json!({
        "type": "Feature",
        "geometry": row.place.map(point),
        "properties": {
            "file": row.file,
            "name": text(&row.name),
            "status": row.status,
            "verdict": row.words,
            "least_factor": row.factor,
            "least_factor_on": text(&row.factor_on),
            "utilisation": row.utilisation,
            "governing": text(&row.governing),
            "not_met": row.broken,
            "report": text(&row.report),
        },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bridge_is_a_point_with_its_longitude_first_and_none_without_a_place() {
        let one = FleetRow {
            file: "mill.toml".into(),
            name: "Mill \"Lane\"".into(),
            status: "adequate".into(),
            factor: Some(1.25),
            place: Some([54.0689, -2.2836]),
            ..FleetRow::default()
        };
        let other = FleetRow { file: "x.toml".into(), status: "unusable-input".into(), ..FleetRow::default() };
        assert_eq!(fleet_geojson(std::slice::from_ref(&other)), None);
        let map: Value = serde_json::from_str(&fleet_geojson(&[one, other]).unwrap()).unwrap();
        assert_eq!(map["type"], "FeatureCollection");
        let [first, second] = [&map["features"][0], &map["features"][1]];
        assert_eq!(first["geometry"]["coordinates"], json!([-2.2836, 54.0689]));
        assert_eq!(first["properties"]["name"], "Mill \"Lane\"");
        assert_eq!(first["properties"]["least_factor"], 1.25);
        assert!(second["geometry"].is_null() && second["properties"]["name"].is_null());
    }
}
