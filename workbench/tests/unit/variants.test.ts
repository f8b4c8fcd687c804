import { describe, expect, it } from "vitest";
import { loadAt, withContinuum, withPressure } from "../../src/model/variants";

const FILE = `[bridge]
name = "x"

[[cover]]   # from the extrados up
layer = "fill"
thickness = "0.3 m"
density = "1800 kg/m^3"

[[load]]
kind = "knife-edge"
at = "1/4 of span 1"     # where

[analysis]
method = "limit"
`;

describe("the same file otherwise", () => {
  it("has its one load elsewhere, and nothing else changed", () => {
    const moved = loadAt(FILE, 3.21)!;
    expect(moved).toContain('position = "3.2100 m"     # where');
    expect(moved.replace('position = "3.2100 m"', 'at = "1/4 of span 1"')).toBe(FILE);
    const inline = 'load = [{ kind = "axle", axle_force = "100 kN", at = "1/4 of span 1" }]\n';
    expect(loadAt(inline, 3.21)).toBe('load = [{ kind = "axle", axle_force = "100 kN", position = "3.2100 m" }]\n');
    expect(loadAt(inline.replace("}]", '}, { at = "1 m" }]'), 1)).toBeNull();
    expect(loadAt(`${FILE}\n[[load]]\nat = "1/2 of span 1"\n`, 1)).toBeNull();
  });
  it("has fill that presses or yields, but only where the file's fill is weight alone", () => {
    expect(withPressure(FILE)).toContain("[fill_pressure]");
    expect(withPressure(withPressure(FILE)!)).toBeNull();
    expect(withContinuum(FILE)).toMatch(/\[\[cover\]\][^\n]*\nas = "continuum"\nfriction_angle = "30 deg"/);
    expect(withContinuum(withContinuum(FILE)!)).toBeNull();
    expect(withPressure(FILE.replace('layer = "fill"', 'layer = "fill"\nas = "particles"'))).toBeNull();
  });
});
