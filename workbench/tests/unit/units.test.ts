import { describe, expect, it } from "vitest";
import { dimension, figures, grouped, lineLoad, meant, shown } from "../../src/units";

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
    expect(Number(there.text) * 0.3048).toBeCloseTo(18.3, 4);
    expect(shown("18.30 m", "metric")).toEqual({ text: "18.30", unit: "m" });
  });
});
