import { expect, test } from "vitest";
import { assumedIn } from "../../src/model/assumed";

test("values with the remark that they are assumed are listed with their tables, others are not", () => {
  const text = `# Lines with "assumed" are to be replaced.
[bridge]
width = "5 m"

[[span]]
voussoirs = 34  # assumed: stones of 0.30 m

[[cover]]
density = "1900 kg/m^3"  # assumed: fill and surfacing as one layer
thickness = "0.5 m"  # measured, where assumed before

[joint]
friction_angle = "30 deg"  # assumed
`;
  expect(assumedIn(text)).toEqual(["ring voussoirs 34", "layer density 1900 kg/m^3", "joint friction angle 30 deg"]);
});
