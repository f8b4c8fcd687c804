/** What a drawing does not say of its blocks: found in the text that is made of it, and written there. */
import type { Picture } from "../engine/types";
import { countOf, inserted, stretchOf, tablesOf } from "./structure";

/** Marks a value that no drawing has. */
const OPEN = "TO FILL IN";
/** Values by which a drawing is drawn before it is known what its blocks are made of; no number comes of them. */
const STAND_IN: [RegExp, string][] = [
  [/"TO FILL IN kg\/m\^3"/g, '"2000 kg/m^3"'],
  [/"TO FILL IN MPa"/g, '"unlimited"'],
  [/"TO FILL IN deg"/g, '"30 deg"'],
];

/** Whether a text is made of a drawing and still lacks something. */
export const isOpen = (text: string): boolean => text.includes(`"${OPEN}`);
/** The text as if everything in it were known, to be drawn. */
export const standIn = (text: string): string => STAND_IN.reduce((now, [what, by]) => now.replace(what, by), text);

export type Layer = { name: string; blocks: number; supports: number };
export type Lacks = { materials: { name: string; density: string; strength: string }[]; friction: string; layers: Layer[]; width: string; loads: number };

const value = (body: string, key: string): string => {
  const found = new RegExp(`^[ \\t]*${key}[ \\t]*=[ \\t]*"([^"\\n]*)"`, "m").exec(body)?.[1] ?? "";
  return found.startsWith(OPEN) ? "" : found;
};
const bodies = (text: string, name: string): string[] => tablesOf(text).filter((one) => one.name === name && one.list).map((one) => text.slice(one.start, one.end));

/** What the text says of the questions that a drawing leaves open. */
export function lacksOf(text: string): Lacks {
  const layers = new Map<string, Layer>();
  for (const body of bodies(text, "block")) {
    const name = value(body, "layer");
    const layer = layers.get(name) ?? { name, blocks: 0, supports: 0 };
    layer.blocks += 1;
    if (value(body, "role") === "support") layer.supports += 1;
    layers.set(name, layer);
  }
  const model = tablesOf(text).find((one) => one.name === "model" && !one.list);
  return {
    materials: bodies(text, "material").map((body) => ({ name: value(body, "name"), density: value(body, "density"), strength: value(body, "compressive_strength") })),
    friction: value(bodies(text, "joint")[0] ?? "", "friction_angle"),
    layers: [...layers.values()],
    width: model ? value(text.slice(model.start, model.end), "width") : "",
    loads: countOf(text, "load"),
  };
}

const quoted = (words: string): string => `"${words.replace(/["\\\p{Cc}]/gu, "")}"`;

/** A value in the nth table of a list, or in a single table (0), in the place of what stands there. */
export function withValue(text: string, name: string, index: number, key: string, written: string): string {
  const single = tablesOf(text).find((one) => one.name === name && !one.list);
  const stretch = index === 0 ? single : stretchOf(text, name, index);
  if (!stretch) return text;
  const body = text.slice(stretch.start, stretch.end);
  const line = new RegExp(`^([ \\t]*${key}[ \\t]*=[ \\t]*)"[^"\\n]*"`, "m");
  const now = line.test(body) ? body.replace(line, (_all, before: string) => before + quoted(written)) : body.replace(/^([ \t]*\[[^\n]*\n)/m, (head) => `${head}${key} = ${quoted(written)}\n`);
  return text.slice(0, stretch.start) + now + text.slice(stretch.end);
}

/** All blocks of a layer as supports, or as blocks that move. */
export function withSupport(text: string, layer: string, held: boolean): string {
  let now = text;
  for (const table of tablesOf(text).filter((one) => one.name === "block" && one.list).reverse()) {
    const body = now.slice(table.start, table.end);
    if (value(body, "layer") !== layer) continue;
    const free = body.replace(/^[ \t]*role[ \t]*=[ \t]*"support"[^\n]*\n/m, "");
    now = now.slice(0, table.start) + (held ? free.replace(/^([ \t]*layer[ \t]*=[^\n]*\n)/m, `$1role = "support"\n`) : free) + now.slice(table.end);
  }
  return now;
}

/** Where a load at x [m] reaches the uppermost block that moves: just below its top; null where none is there. */
export function topAt(picture: Picture, x: number): number | null {
  let top: number | null = null;
  for (const { outline, held } of picture.shapes) {
    if (held) continue;
    outline.forEach(([x0, y0], k) => {
      const [x1, y1] = outline[(k + 1) % outline.length]!;
      if (Math.min(x0, x1) > x || Math.max(x0, x1) < x || x0 === x1) return;
      const y = y0 + ((y1 - y0) * (x - x0)) / (x1 - x0);
      if (top === null || y > top) top = y;
    });
  }
  return top === null ? null : top - 0.005;
}

/** A load downwards at x [m] on the uppermost block there; null where none is there. */
export function withLoad(text: string, picture: Picture, x: number): string | null {
  const y = topAt(picture, x);
  if (y === null) return null;
  return inserted(text, "load", `name = "load"\nx = "${x.toFixed(3)} m"\ny = "${y.toFixed(3)} m"\ndown = "1 kN/m"`);
}
