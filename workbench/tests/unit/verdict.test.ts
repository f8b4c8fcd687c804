import { expect, test } from "vitest";
import { trade, type Assessed } from "../../src/model/verdict";

const check = (load_model: string, value: number) => ({ code: "C204", title: "adequacy of vehicles", load_model, value, limit: 1, utilisation: 1 / value, met: value >= 1 });
const vehicle = (code: string, title: string) => ({ code, title });

test("a bridge that carries some of the vehicles says which, and which governs", () => {
  const found: Assessed = {
    status: "inadequate", headline: "Not adequate", by_name: "CS 454", level: null, strength_assessed: true,
    head: "Not adequate by CS 454 (8 factors to be confirmed; skew not given)",
    governing: { code: "C204", title: "adequacy of vehicles", load_model: "cs454-bogie-10", utilisation: 1 / 0.79 },
    checks: [check("cs454-single", 1.06), check("cs454-bogie-10", 0.79), { ...check("x", 2), code: "C201", title: "load" }],
    vehicles: { vehicles: [vehicle("cs454-single", "CS 454 single axle, 11.5 t"), vehicle("cs454-bogie-10", "CS 454 bogie, 2 x 10 t")], graded: [] },
  };
  expect(trade(found)).toEqual({
    says: "Not adequate",
    governs: "CS 454 bogie, 2 x 10 t governs: factor 0.790, 1.00 is asked for",
    carries: ["Carries: CS 454 single axle, 11.5 t", "Does not carry: CS 454 bogie, 2 x 10 t"],
    with: "8 factors to be confirmed; skew not given",
  });
  // Where strength is left open, a factor is no promise.
  expect(trade({ ...found, strength_assessed: false })!.carries).toEqual(["Factor of 1 or more: CS 454 single axle, 11.5 t", "Less than 1: CS 454 bogie, 2 x 10 t"]);
  const open = trade({ ...found, status: "undetermined", headline: "Undetermined", head: "Undetermined (load cases left out, and 2 more things)" })!;
  expect([open.says, open.with, open.carries[0]]).toEqual(["Undetermined", "Load cases left out, and 2 more things", "Factor of 1 or more: CS 454 single axle, 11.5 t"]);
});

test("grades are the answer where vehicles stand for them, as the result has them", () => {
  const found: Assessed = {
    status: "inadequate", headline: "Not adequate", by_name: "CS 454", level: "40 t", strength_assessed: true, head: "Not adequate by CS 454 for 40 t",
    governing: { code: "C204", title: "adequacy of vehicles", load_model: "gb-40t", utilisation: 1 / 0.79 },
    checks: [check("gb-18t", 1.2), check("gb-26t", 0.9), check("gb-40t", 0.79)],
    vehicles: { vehicles: [vehicle("gb-40t", "40 t lorry")], graded: [{ of: "weight restriction", highest: "18 t", carried: ["18 t"], not_carried: ["26 t", "40 t"], unanswered: [] }] },
  };
  expect(trade(found)).toEqual({ says: "Not adequate for 40 t", governs: "40 t lorry governs: factor 0.790, 1.00 is asked for", carries: ["Weight restriction: carries 18 t, not 26 t, 40 t"], with: "" });
  const none = { of: "Route Availability", highest: null, carried: [], not_carried: ["RA1", "RA2"], unanswered: ["RA3"] };
  expect(trade({ ...found, vehicles: { graded: [none] } })!.carries).toEqual(["Route Availability: less than RA1, not settled: RA3"]);
});

test("nothing is said that the result does not have", () => {
  expect(trade({ status: "undetermined" })).toBeNull();
  expect(trade({ status: "undetermined", headline: "Undetermined: nothing was compared", head: "Undetermined: nothing was compared", governing: null, checks: [] })).toEqual({ says: "Undetermined: nothing was compared", governs: "", carries: [], with: "" });
  const other = trade({ status: "inadequate", headline: "Not adequate", head: "Not adequate", level: "RA10", by_name: "NR", governing: { code: "C101", title: "crown deflection", utilisation: 1.25 }, checks: [] })!;
  // The grade is not what it fails.
  expect([other.says, other.governs, other.carries]).toEqual(["Not adequate", "Crown deflection governs: 125 % of its limit is used", []]);
});
