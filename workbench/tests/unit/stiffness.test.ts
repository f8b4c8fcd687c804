import { expect, test } from "vitest";
import type { Picture } from "../../src/engine/types";
import { lacksStiffness, stoneLength, withStiffness } from "../../src/model/stiffness";

const square = (x: number): [number, number][] => [[x, 0], [x + 0.4, 0], [x + 0.4, 0.5], [x, 0.5]];

test("a stone is as long as the next one is away, and its joint has a tenth of its modulus", () => {
  const shapes = [0, 0.4, 0.8, 9].map((x) => ({ outline: square(x), role: "voussoir", held: false }));
  const length = stoneLength({ shapes } as unknown as Picture)!;
  expect(length).toBeCloseTo(0.4, 12);
  const text = '[bridge]\nwidth = "5 m"\n\n[joint]  # old\nfriction_angle = "30 deg"\n';
  expect(lacksStiffness(text)).toBe(true);
  const filled = withStiffness(text, "8 GPa", length, "brick-in-lime")!;
  expect(filled).toContain('[joint]  # old\nnormal_stiffness = "2.00 GPa/m"');
  expect(filled).toContain('shear_stiffness = "0.83 GPa/m"');
  expect(filled).toContain('friction_angle = "30 deg"');
  expect(lacksStiffness(filled)).toBe(false);
  expect(withStiffness('[bridge]\n', "8 GPa", length, "x")).toBe(null);
});
