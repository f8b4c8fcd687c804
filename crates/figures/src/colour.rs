//! A perceptually uniform colour map that also prints in grey.

/// The map "cividis" of Nuñez, Anderton and Renslow (2018), PLoS ONE 13(7): e0199239, at seventeen even steps.
const CIVIDIS: [[u8; 3]; 17] = [
    [0, 34, 78],
    [0, 46, 106],
    [26, 56, 111],
    [50, 67, 109],
    [67, 78, 108],
    [83, 90, 109],
    [97, 101, 111],
    [111, 112, 115],
    [125, 124, 120],
    [140, 136, 120],
    [155, 148, 118],
    [171, 160, 114],
    [188, 174, 108],
    [205, 187, 99],
    [222, 201, 88],
    [240, 216, 70],
    [254, 232, 56],
];

/// The map "OrRd" of Harrower and Brewer (2003), The Cartographic Journal 40(1): 27-37, at nine even steps.
const ORANGE_RED: [[u8; 3]; 9] = [
    [255, 247, 236],
    [254, 232, 200],
    [253, 212, 158],
    [253, 187, 132],
    [252, 141, 89],
    [239, 101, 72],
    [215, 48, 31],
    [179, 0, 0],
    [127, 0, 0],
];

/// The map "YlGnBu" of the same authors, at nine even steps.
const YELLOW_BLUE: [[u8; 3]; 9] = [
    [255, 255, 217],
    [237, 248, 177],
    [199, 233, 180],
    [127, 205, 187],
    [65, 182, 196],
    [29, 145, 192],
    [34, 94, 168],
    [37, 52, 148],
    [8, 29, 88],
];

/// The map "RdBu" of the same authors turned round, at nine even steps.
const BLUE_RED: [[u8; 3]; 9] = [
    [33, 102, 172],
    [67, 147, 195],
    [146, 197, 222],
    [209, 229, 240],
    [247, 247, 247],
    [253, 219, 199],
    [244, 165, 130],
    [214, 96, 77],
    [178, 24, 43],
];

/// The colour of a share from 0 (light) to 1 (dark), as `#rrggbb`; grey for what is not a number.
pub(crate) fn dark_for_much(share: f64) -> String {
    mixed(&CIVIDIS, 1.0 - share)
}

/// The same from pale yellow to dark blue, for large fields.
pub(crate) fn blue_for_much(share: f64) -> String {
    mixed(&YELLOW_BLUE, share)
}

/// The same in reds, for a second scale in one drawing.
pub(crate) fn red_for_much(share: f64) -> String {
    mixed(&ORANGE_RED, share)
}

/// From blue at -1 over white at 0 to red at 1.
pub(crate) fn either_way(share: f64) -> String {
    mixed(&BLUE_RED, 0.5 * (share + 1.0))
}

fn mixed(map: &[[u8; 3]], share: f64) -> String {
    if share.is_nan() {
        return "#cccccc".into();
    }
    let at = share.clamp(0.0, 1.0) * (map.len() - 1) as f64;
    let low = (at.floor() as usize).min(map.len() - 2);
    let t = at - low as f64;
    let mix = |c: usize| {
        let (a, b) = (f64::from(map[low][c]), f64::from(map[low + 1][c]));
        (a + t * (b - a)).round() as u8
    };
    format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_is_darker_in_grey_print() {
        let grey = |map: fn(f64) -> String, s: f64| {
            let c = map(s);
            let part = |k: usize| f64::from(u8::from_str_radix(&c[k..k + 2], 16).unwrap());
            0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5)
        };
        for map in [dark_for_much, red_for_much, blue_for_much] {
            let greys: Vec<f64> = (0..=50).map(|k| grey(map, f64::from(k) / 50.0)).collect();
            assert!(greys.windows(2).all(|w| w[1] < w[0]), "{greys:?}");
        }
        assert_eq!(dark_for_much(0.0), "#fee838");
        assert_eq!(dark_for_much(1.0), "#00224e");
        assert_eq!([-1.0, 0.0, 1.0].map(either_way), ["#2166ac", "#f7f7f7", "#b2182b"]);
    }
}
