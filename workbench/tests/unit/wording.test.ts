import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { plainly, typeset } from "../../src/wording";

test("powers of units are raised, and nothing else", () => {
  expect(typeset("2200 kg/m^3, 5 kN/m^2, 9.81 m/s^2, 20 mm^2, 1 kN/m")).toBe("2200 kg/m³, 5 kN/m², 9.81 m/s², 20 mm², 1 kN/m");
  expect(typeset("2^3 and x^12 and ^3")).toBe("2^3 and x^12 and ^3");
});

test("the assumption about rigid rings, as the engine words it, names a table of the page", () => {
  const source = readFileSync(join(__dirname, "../../../crates/outcome/src/note/vehicles.rs"), "utf8");
  const rigid = /RigidAlone => "((?:[^"\\]|\\[\s\S])*)";/.exec(source)![1]!.replace(/\\\n\s*/g, "").replace(/\\"/g, '"');
  expect(rigid).toMatch(/^Rings are rigid/);
  const said = plainly(rigid);
  expect(said).toContain("“Deformable joints”, in the table of methods under Load");
  expect(said).not.toMatch(/docs\/|\[analysis\]|method =/);
  // The row of the table that it names.
  expect(readFileSync(join(__dirname, "../../src/parts/LoadPanel.tsx"), "utf8")).toContain('title: "Deformable joints"');
});

test("a page of the documentation is left out with the words that lead to it", () => {
  expect(plainly("Fill helps; docs/theory/fill-pressure.md says when to use it.")).toBe("Fill helps.");
  expect(plainly("The model factor is 1.9.")).toBe("The model factor is 1.9.");
});
