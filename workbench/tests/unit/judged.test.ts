import { expect, test } from "vitest";
import type { Library } from "../../src/engine/types";
import { judgedBy, withJudged } from "../../src/model/judged";

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
