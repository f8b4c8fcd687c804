import { expect, test } from "vitest";
import { keyOf, rowsOf } from "../../src/model/rows";

const UNITS: Record<string, string> = { density: "kg/m^3", strength: "MPa", axle: "kN", spans: "" };
const units = (key: string): string => UNITS[key] ?? "m";

test("rows of a spreadsheet are answers, headings are none, and what is not understood is told", () => {
  const sheet = "Item\tValue\tUnit\nBridge name\tMill Lane, Upton\nGeometry\nClear span\t6.10\tm\nRise at crown (mm)\t1500\nRing thickness\t450 mm\nBarrel width\t5,2\nFill depth\t0.5 m\nSkew\t12 deg\nDensity of masonry\t22\tkN/m3\nAxle load\t11.5 t\nStrength\tunknown\n";
  const { answers, left } = rowsOf(sheet, units);
  expect(answers).toEqual({ name: "Mill Lane, Upton", span: "6.10 m", rise: "1500 mm", thickness: "450 mm", width: "5.2 m", cover: "0.5 m", density: "22 kN/m3", skew: "12 deg", axle: "11.5 t" });
  expect(left.map((one) => `${one.row} ${one.text}: ${one.why}`)).toEqual(["12 Strength: unknown: no number"]);
});

test("commas part columns too, a cell in quotation marks may hold them, and one that may be two things is not guessed", () => {
  const { answers, left } = rowsOf('name,"Mill Lane, Upton"\r\nspan,6.1 m\r\nrise,1,5\r\ndensity,"2,200 kg/m3"\r\nthickness,1\' 6"\r\nspan,7 m', units);
  expect(answers).toEqual({ name: "Mill Lane, Upton", span: "6.1 m", thickness: `1' 6"` });
  expect(left.map((one) => one.row)).toEqual([3, 4, 6]);
});

test("names are matched whole: another measure of the same part is not taken for it", () => {
  for (const [name, key] of [["Clear span [m]", "span"], ["CLEAR SPAN:", "span"], ["span", "span"], ["Thickness of the ring", "thickness"], ["Depth of fill at crown", "cover"], ["pier_width_2", "pier_width_2"], ["Width of pier 1", "pier_width"], ["Rise, span 2", "rise_2"], ["Span 3", "span_3"], ["Pier 2 height", "pier_height_2"], ["Span 2, clear span", "span_2"], ["Number of spans", "spans"], ["compressive_strength", "strength"], ["Height of the pier", "pier_height"], ["Structure number", "reference"], ["No. of rings", "rings"], ["Density of fill", "fill_density"], ["Skew angle", "skew"]] as const) expect(keyOf(name), name).toBe(key);
  for (const name of ["Ring thickness at springing", "Springing thickness", "Skew span", "Rise at quarter point", "Parapet height", "Tensile strength", "Depth", "Width 2", "Rise of pier 2", ""]) expect(keyOf(name), name).toBe("");
});
