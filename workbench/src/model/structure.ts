/** Tables of a bridge file as stretches of its text: for adding a span like the last one, or taking a layer out. */

/** What the file's plan seeks: "load" where it says nothing, "thickness", "support-movement". */
export function sought(text: string): string {
  const table = tablesOf(text).find((one) => one.name === "analysis" && !one.list);
  return (table && /^[ \t]*analysis[ \t]*=[ \t]*["']([\w-]+)["']/m.exec(text.slice(table.start, table.end))?.[1]) || "load";
}

export type Table = { name: string; list: boolean; start: number; end: number };

/** Tables in the order of the text; each reaches to the next header. Comments just above a header belong to it. */
export function tablesOf(text: string): Table[] {
  const tables: Table[] = [];
  const lines = text.split("\n");
  let at = 0;
  let quoted = false;
  let comments = -1;
  for (const line of lines) {
    const fences = (line.match(/"""|'''/g) ?? []).length;
    const header = quoted ? null : /^\s*(\[\[?)\s*([\w.\-]+)\s*\]\]?\s*(#.*)?$/.exec(line);
    if (fences % 2 === 1) quoted = !quoted;
    if (header) {
      const start = comments >= 0 && tables.length > 0 ? comments : at;
      const last = tables[tables.length - 1];
      if (last) last.end = start;
      tables.push({ name: header[2]!, list: header[1] === "[[", start, end: text.length });
      comments = -1;
    } else if (/^\s*#/.test(line)) {
      if (comments < 0) comments = at;
    } else {
      comments = -1;
    }
    at += line.length + 1;
  }
  return tables;
}

/** The nth table of a list with everything nested in it, from 1. */
export function stretchOf(text: string, name: string, index: number): { start: number; end: number } | null {
  const tables = tablesOf(text);
  let count = 0;
  for (let k = 0; k < tables.length; k += 1) {
    if (tables[k]!.name !== name || !tables[k]!.list) continue;
    count += 1;
    if (count !== index) continue;
    let end = k + 1;
    while (end < tables.length && tables[end]!.name.startsWith(`${name}.`)) end += 1;
    return { start: tables[k]!.start, end: end < tables.length ? tables[end]!.start : text.length };
  }
  return null;
}

export function countOf(text: string, name: string): number {
  return tablesOf(text).filter((table) => table.list && table.name === name).length;
}

/** The last table of a list once more, below itself. */
export function repeated(text: string, name: string): string | null {
  const count = countOf(text, name);
  const stretch = count > 0 ? stretchOf(text, name, count) : null;
  if (!stretch) return null;
  const copy = text.slice(stretch.start, stretch.end).replace(/\s*$/, "\n");
  const before = text.slice(0, stretch.end).replace(/\s*$/, "\n");
  const after = text.slice(stretch.end).replace(/^\s*/, "");
  return `${before}\n${copy}${after ? `\n${after}` : ""}`;
}

/** A table put below the last of its list, or at the end of the text. */
export function inserted(text: string, name: string, body: string): string {
  const count = countOf(text, name);
  const stretch = count > 0 ? stretchOf(text, name, count) : null;
  const at = stretch ? stretch.end : text.length;
  const before = text.slice(0, at).replace(/\s*$/, "\n");
  const after = text.slice(at).replace(/^\s*/, "");
  return `${before}\n[[${name}]]\n${body.trim()}\n${after ? `\n${after}` : ""}`;
}

export function without(text: string, name: string, index: number): string {
  const stretch = stretchOf(text, name, index);
  if (!stretch) return text;
  return `${text.slice(0, stretch.start).replace(/\s*$/, "\n")}\n${text.slice(stretch.end).replace(/^\s*/, "")}`;
}

/** A text value of a single table, written in the place of the one that is there; the text as it was where there is none. */
export function withWord(text: string, name: string, key: string, word: string): string {
  const table = tablesOf(text).find((one) => one.name === name && !one.list);
  if (!table) return text;
  const body = text.slice(table.start, table.end);
  const line = new RegExp(`^(\\s*${key}\\s*=\\s*)("[^"\\n]*"|'[^'\\n]*')`, "m");
  return text.slice(0, table.start) + body.replace(line, (_all, before: string) => `${before}"${word.replace(/["\\\p{Cc}]/gu, "")}"`) + text.slice(table.end);
}
