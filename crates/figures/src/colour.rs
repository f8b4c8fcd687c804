//! A perceptually uniform colour map that also prints in grey.

/// The map "cividis" of Nuñez, Anderton and Renslow (2018), PLoS ONE 13(7): e0199239, at seventeen even steps.
const CIVIDIS: [u32; 17] = [
    0x00224e, 0x002e6a, 0x1a386f, 0x32436d, 0x434e6c, 0x535a6d, 0x61656f, 0x6f7073, 0x7d7c78, 0x8c8878, 0x9b9476,
    0xaba072, 0xbcae6c, 0xcdbb63, 0xdec958, 0xf0d846, 0xfee838,
];

/// The map "OrRd" of Harrower and Brewer (2003), The Cartographic Journal 40(1): 27-37, at nine even steps.
const ORANGE_RED: [u32; 9] = [0xfff7ec, 0xfee8c8, 0xfdd49e, 0xfdbb84, 0xfc8d59, 0xef6548, 0xd7301f, 0xb30000, 0x7f0000];

/// The map "YlGnBu" of the same authors, at nine even steps.
const YELLOW_BLUE: [u32; 9] =
    [0xffffd9, 0xedf8b1, 0xc7e9b4, 0x7fcdbb, 0x41b6c4, 0x1d91c0, 0x225ea8, 0x253494, 0x081d58];

/// The map "RdBu" of the same authors turned round, at nine even steps.
const BLUE_RED: [u32; 9] = [0x2166ac, 0x4393c3, 0x92c5de, 0xd1e5f0, 0xf7f7f7, 0xfddbc7, 0xf4a582, 0xd6604d, 0xb2182b];

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

fn mixed(map: &[u32], share: f64) -> String {
    if share.is_nan() {
        return "#cccccc".into();
    }
    let at = share.clamp(0.0, 1.0) * (map.len() - 1) as f64;
    let low = (at.floor() as usize).min(map.len() - 2);
    let t = at - low as f64;
    let [a, b] = [map[low], map[low + 1]].map(u32::to_be_bytes);
    let mix = |c: usize| (f64::from(a[c]) + t * (f64::from(b[c]) - f64::from(a[c]))).round() as u8;
    format!("#{:02x}{:02x}{:02x}", mix(1), mix(2), mix(3))
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
