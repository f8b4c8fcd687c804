/** By which rule and vehicles a bridge is judged: what its file says, and the file with another answer. */
import type { Library } from "../engine/types";
import { inserted, tablesOf } from "./structure";

export type Judged = { rule: string; vehicles: string };

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

/** The text with this rule and these vehicles, several codes with commas between them. */
export function withJudged(text: string, { rule, vehicles }: Judged): string {
  const list = `[${vehicles.split(",").map((code) => `"${code.trim()}"`).join(", ")}]`;
  const lines = `rule = "${rule}"\nvehicles = ${list}`;
  const table = tablesOf(text).find((one) => one.name === "sweep" && !one.list);
  if (!table) return inserted(text, "sweep", lines).replace("[[sweep]]", "[sweep]");
  const body = text
    .slice(table.start, table.end)
    .replace(/^[ \t]*(?:rule|vehicles)[ \t]*=[ \t]*(?:\[[^\]]*\]|[^\n]*)[^\n]*\n?/gm, "")
    .replace(/^([ \t]*\[sweep\][^\n]*)\n?/m, `$1\n${lines}\n`);
  return text.slice(0, table.start) + body + text.slice(table.end);
}
