/** By which rule and vehicles a bridge is judged: what its file says, and the file with another answer. */
import type { Library, LibraryModel } from "../engine/types";
import { inserted, tablesOf } from "./structure";

/** `vehicles` are codes with commas between them; "" for all that go with the rule. */
export type Judged = { rule: string; vehicles: string };

/** The load models that a rule says how to use, of this traffic. */
export function modelsOf(library: Library, traffic: string, rule: string): LibraryModel[] {
  return library.models.filter((one) => one.ways === traffic && one.rules.includes(rule));
}

/** The vehicles that go with a rule of themselves. */
export function allOf(models: LibraryModel[]): Set<string> {
  return new Set(models.filter((one) => !one.only_by_name).flatMap((one) => one.vehicles.map((vehicle) => vehicle.code)));
}

/** The vehicles behind codes of vehicles and load models; "" stands for all that go with the rule. */
export function pickedBy(models: LibraryModel[], codes: string): Set<string> {
  const names = codes.split(",").map((code) => code.trim()).filter((code) => code !== "");
  if (names.length === 0) return allOf(models);
  return new Set(names.flatMap((code) => models.find((one) => one.code === code)?.vehicles.map((one) => one.code) ?? models.flatMap((one) => one.vehicles).filter((one) => one.code === code).map((one) => one.code)));
}

/** Codes of these vehicles: load models by their own code where all of their vehicles are there; "" where they are what the rule takes without being told. A
 * rule for road and rail is always told. */
export function codesOf(library: Library, traffic: string, rule: string, picked: Set<string>): string {
  const models = modelsOf(library, traffic, rule);
  const all = allOf(models);
  const alone = library.rules.find((one) => one.code === rule)?.ways.every((way) => way === traffic) ?? false;
  if (alone && all.size === picked.size && [...all].every((code) => picked.has(code))) return "";
  return models.flatMap((one) => (one.vehicles.every((vehicle) => picked.has(vehicle.code)) ? [one.code] : one.vehicles.map((vehicle) => vehicle.code).filter((code) => picked.has(code)))).join(", ");
}

const bodyOf = (text: string): string => {
  const table = tablesOf(text).find((one) => one.name === "sweep" && !one.list);
  return table ? text.slice(table.start, table.end) : "";
};

/** The rule of the file that gives a verdict; "" where it names none. A factor of its own, or a file with a rule, judges as well. */
export function judgedBy(text: string, library: Library): string {
  const body = bodyOf(text);
  if (/^\s*rule_file\s*=/m.test(body)) return "a rule of its own";
  if (/^\s*adequacy_factor\s*=/m.test(text)) return "a factor of its own";
  const rule = /^\s*rule\s*=\s*["']([^"'\n]*)["']/m.exec(body)?.[1] ?? "";
  return library.rules.find((one) => one.code === rule)?.judges ? rule : "";
}

/** The text with this rule and these vehicles. */
export function withJudged(text: string, { rule, vehicles }: Judged): string {
  const list = `vehicles = [${vehicles.split(",").map((code) => `"${code.trim()}"`).join(", ")}]`;
  const lines = `rule = "${rule}"\n${vehicles === "" ? "# every vehicle of the library that goes with the rule" : list}`;
  const table = tablesOf(text).find((one) => one.name === "sweep" && !one.list);
  if (!table) return inserted(text, "sweep", lines).replace("[[sweep]]", "[sweep]");
  const body = text
    .slice(table.start, table.end)
    .replace(/^[ \t]*(?:rule|vehicles)[ \t]*=[ \t]*(?:\[[^\]]*\]|[^\n]*)[^\n]*\n?/gm, "")
    .replace(/^([ \t]*\[sweep\][^\n]*)\n?/m, `$1\n${lines}\n`);
  return text.slice(0, table.start) + body + text.slice(table.end);
}
