import { expect, test } from "vitest";
import type { Library } from "../../src/engine/types";
import { allOf, codesOf, judgedBy, modelsOf, pickedBy, withJudged } from "../../src/model/judged";

const library = { models: [], rules: [{ code: "cs-454", title: "", ways: ["road"], judges: true }, { code: "characteristic", title: "", ways: ["road"], judges: false }] } as Library;
const BARE = '[bridge]\nname = "a"\n\n[analysis]\nmethod = "limit"\n';

test("a file is judged by a rule with safety, a rule of its own or a factor of its own, and by nothing else", () => {
  expect(judgedBy(BARE, library)).toBe("");
  expect(judgedBy(`${BARE}[sweep]\nvehicles = ["hb-45"]\n`, library)).toBe("");
  expect(judgedBy(`${BARE}[sweep]\nrule = "characteristic"\n`, library)).toBe("");
  expect(judgedBy(`${BARE}[sweep]\nrule = "cs-454" # road\n`, library)).toBe("cs-454");
  expect(judgedBy(`${BARE}[sweep]\nrule_file = "ours.toml"\n`, library)).not.toBe("");
  expect(judgedBy(`${BARE}[assess]\nadequacy_factor = 2.0\n`, library)).not.toBe("");
});

test("rule and vehicles are written into a table of their own, or in the place of those that are there, and the rest stays", () => {
  const written = withJudged(BARE, { rule: "cs-454", vehicles: "hb-45" });
  expect(written).toContain('\n[sweep]\nrule = "cs-454"\nvehicles = ["hb-45"]\n');
  expect(written.startsWith(BARE.trimEnd())).toBe(true);
  expect(judgedBy(written, library)).toBe("cs-454");
  const replaced = withJudged('[sweep]  # moved\nrule = "characteristic"\nvehicles = [\n  "lm1",\n]\nstep = "0.2 m"  # coarse\n\n[analysis]\n', { rule: "cs-454", vehicles: "hb-45, cs-454" });
  expect(replaced).toBe('[sweep]  # moved\nrule = "cs-454"\nvehicles = ["hb-45", "cs-454"]\nstep = "0.2 m"  # coarse\n\n[analysis]\n');
});

test("all that go with a rule are written as no vehicles, whole load models by their code, and what is asked for by name alone is told", () => {
  const model = (code: string, ways: string, rules: string[], vehicles: string[], only_by_name = false) => ({ code, title: code, ways, rules, vehicles: vehicles.map((one) => ({ code: one, title: one })), source: "", confidence: "read", longest_span: null, only_by_name });
  const known: Library = {
    models: [model("hb", "road", ["cs-454"], ["hb-25", "hb-45"]), model("cs-454", "road", ["cs-454"], ["single", "bogie"]), model("sv", "road", ["cs-454"], ["sv-80"], true), model("lm1", "road", ["en"], ["lm1"]), model("lm71", "rail", ["en"], ["lm71"])],
    rules: [{ code: "cs-454", title: "", ways: ["road"], judges: true }, { code: "en", title: "", ways: ["road", "rail"], judges: true }],
  };
  const models = modelsOf(known, "road", "cs-454");
  expect(models.map((one) => one.code)).toEqual(["hb", "cs-454", "sv"]);
  expect([...allOf(models)]).toEqual(["hb-25", "hb-45", "single", "bogie"]);
  const written = (codes: string): string => codesOf(known, "road", "cs-454", pickedBy(models, codes));
  expect(written("")).toBe("");
  expect(written("hb, cs-454")).toBe("");
  expect(written("cs-454")).toBe("cs-454");
  expect(written("bogie, hb")).toBe("hb, bogie");
  expect(written("hb, cs-454, sv")).toBe("hb, cs-454, sv");
  // A rule for both would take the trains as well.
  expect(codesOf(known, "road", "en", allOf(modelsOf(known, "road", "en")))).toBe("lm1");
  const file = withJudged(BARE, { rule: "cs-454", vehicles: "" });
  expect(file).toContain('\n[sweep]\nrule = "cs-454"\n# every vehicle');
  expect(file).not.toContain("vehicles =");
});
