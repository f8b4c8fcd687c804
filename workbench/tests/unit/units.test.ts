import { describe, expect, it } from "vitest";
import { also, choices, dimension, entry, figures, grouped, inSystem, lineLoad, meant, restated, shown } from "../../src/units";

describe("numbers as an engineer writes them", () => {
  it("groups digits and keeps signs", () => {
    expect(grouped(18300, 0)).toBe("18\u2009300");
    expect(grouped(-0.4, 0)).toBe("0");
    expect(grouped(-1234.5, 1)).toBe("−1\u2009234.5");
    expect(figures(204820 / 1e3)).toBe("204.8");
    expect(figures(0.012345, 3)).toBe("0.0123");
  });
  it("dimensions are whole millimetres, or feet and inches", () => {
    expect(dimension(0.711, "metric")).toBe("711");
    expect(dimension(18.3, "imperial")).toBe("60′\u20090.5″");
    // Twelve inches are a foot.
    expect(dimension(0.3048 * 2 - 1e-9, "imperial")).toBe("2′\u20090″");
  });
  it("loads convert both ways", () => {
    expect(lineLoad(14593.903, "imperial")).toEqual({ value: "1.000", unit: "kip/ft" });
    expect(lineLoad(204820, "metric")).toEqual({ value: "204.8", unit: "kN/m" });
  });
  it("a bare number takes the unit that was shown, a unit that is typed stays", () => {
    expect(meant("60", "ft")).toBe("60 ft");
    expect(meant("18,5", "m")).toBe("18.5 m");
    expect(meant("18.5 m", "ft")).toBe("18.5 m");
    expect(meant("unlimited", "MPa")).toBe("unlimited");
    const there = shown("18.30 m", "imperial");
    expect(there.unit).toBe("ft");
    expect(Number(there.text) * 0.3048).toBeCloseTo(18.3, 3);
    expect(shown("18.30 m", "metric")).toEqual({ text: "18.30", unit: "m" });
  });
});

describe("fields of a survey", () => {
  it("weights per volume and tonnes are offered beside the units of the file, and told in both", () => {
    expect(choices("kg/m^3", "metric")).toEqual(["kg/m^3", "kN/m^3"]);
    expect(choices("kN", "metric")).toEqual(["kN", "t"]);
    expect(also("22 kN/m3")).toBe("22 kN/m3 is 2243 kg/m^3 at g = 9.81 m/s^2".replace("m3 is", "m^3 is"));
    expect(also("2200 kg/m^3")).toBe("2200 kg/m^3 weighs 21.58 kN/m^3 at g = 9.81 m/s^2");
    expect(also("11.5 t")).toBe("11.5 t weighs 112.8 kN at g = 9.81 m/s^2");
    expect(also("6.00 m")).toBe("");
    expect(also("heavy")).toBe("");
  });
  it("an answer keeps its unit, whatever the field would show", () => {
    expect(entry("22 kN/m³", "kg/m^3", "metric")).toEqual({ text: "22", unit: "kN/m^3" });
    expect(entry("450 mm", "m", "metric")).toEqual({ text: "450", unit: "mm" });
    expect(entry("20 ft", "m", "metric")).toEqual({ text: "20 ft", unit: "m" });
    expect(entry("450 mm", "m", "imperial")).toEqual({ text: "17.72", unit: "in" });
    expect(entry("6.096 m", "m", "imperial")).toEqual({ text: "20", unit: "ft" });
    expect(entry("18 in", "m", "imperial")).toEqual({ text: "18", unit: "in" });
    expect(entry("11.5 t", "kN", "imperial")).toEqual({ text: "11.5 t", unit: "kip" });
    expect(entry("", "m", "metric")).toEqual({ text: "", unit: "m" });
    expect(entry("3", "", "imperial")).toEqual({ text: "3", unit: "" });
  });
  it("an answer is restated as its field shows it, and stays where the field has no unit for it", () => {
    expect(restated("6.00 m", "m", "imperial")).toBe("19.685 ft");
    expect(restated("6.00 m", "m", "imperial", 3)).toBe("19.7 ft");
    expect(restated("450 mm", "m", "imperial")).toBe("17.7165 in");
    for (const [written, unit] of [["20 ft", "m"], ["19' 8\"", "m"], ["11.5 t", "kN"], ["22 kN/m^3", "kg/m^3"], ["wide", "m"], ["3", ""], ["Mill Lane", ""]] as const) expect(restated(written, unit, "imperial")).toBe(written);
    expect(restated("20 ft", "m", "metric")).toBe("20 ft");
    expect(restated("6.00 m", "m", "metric")).toBe("6.00 m");
  });
  it("words in metric units are said in imperial ones, but for what somebody wrote", () => {
    expect(inSystem("masonry usually weighs 1500 to 3000 kg/m^3", "imperial")).toBe("masonry usually weighs 93.6 to 187 lb/ft^3");
    expect(inSystem("0.5 MPa to 400 MPa, at most 3 m", "imperial")).toBe("72.5 psi to 58000 psi, at most 9.84 ft");
    expect(inSystem('"3 m" is a length', "imperial")).toBe('"3 m" is a length');
    expect(inSystem("at most 3 m", "metric")).toBe("at most 3 m");
  });
});
