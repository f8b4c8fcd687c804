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
test("what further spans and piers have from the first stands together, with their number", () => {
  const span = (remark: string): string => `[[span]]\nspan = "9 m"${remark}\nrise = "2 m"${remark}\nvoussoirs = 30  # assumed: stones of 0.30 m\n\n`;
  const pier = (remark: string): string => `[[pier]]\nwidth = "1.5 m"\nheight = "5 m"${remark}\n\n`;
  const text = span("") + span("  # assumed: as span 1") + span("") + pier("") + pier("  # assumed: as pier 1");
  expect(assumedIn(text)).toEqual(["span 1 voussoirs 30", "span 2 as span 1 (span, rise)", "span 2 voussoirs 30", "span 3 voussoirs 30", "pier 2 as pier 1 (height)"]);
});
