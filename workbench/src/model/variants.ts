/** The same bridge file with its load elsewhere or its fill as something else, for answers side by side. The sheet's own text stays. */
import { countOf, stretchOf, tablesOf } from "./structure";

/** The load of a file with one load, at a place [m]; null where the file has several, or places it in a way that is not understood. */
export function loadAt(text: string, x: number): string | null {
  const place = `"${x.toFixed(4)} m"`;
  const inline = /^([ \t]*load[ \t]*=[ \t]*\[[ \t]*\{[^{}\n]*?)\b(?:at|position)[ \t]*=[ \t]*"[^"\n]*"([^{}\n]*\}[ \t]*\])/m;
  if (inline.test(text)) return text.replace(inline, (_all, before: string, after: string) => `${before}position = ${place}${after}`);
  if (countOf(text, "load") !== 1) return null;
  const stretch = stretchOf(text, "load", 1)!;
  const table = text.slice(stretch.start, stretch.end);
  const line = /^([ \t]*)(at|position)[ \t]*=[ \t]*"[^"]*"/m;
  if (!line.test(table)) return null;
  return text.slice(0, stretch.start) + table.replace(line, `$1position = ${place}`) + text.slice(stretch.end);
}

function hasTable(text: string, name: string): boolean {
  return tablesOf(text).some((table) => table.name === name);
}

function lowestLayer(text: string): { start: number; end: number; table: string } | null {
  const stretch = stretchOf(text, "cover", 1);
  return stretch ? { ...stretch, table: text.slice(stretch.start, stretch.end) } : null;
}

/** What is assumed of fill whose strength the file does not state. */
export const ASSUMED = "friction angle 30°, no cohesion";

/** Fill that presses sideways, with an assumed strength; null where the file has such a pressure, or fill that is more than weight. */
export function withPressure(text: string): string | null {
  const layer = lowestLayer(text);
  if (!layer || hasTable(text, "fill_pressure") || /^[ \t]*as[ \t]*=/m.test(layer.table) || /^[ \t]*weighs[ \t]*=[ \t]*false/m.test(layer.table)) return null;
  return `${text.replace(/\s*$/, "\n")}\n[fill_pressure]\nfriction_angle = "30 deg"\ncohesion = "0 kPa"\n`;
}

/** The lowest layer as soil that yields, with an assumed strength; null where it is more than weight already. */
export function withContinuum(text: string): string | null {
  const layer = lowestLayer(text);
  if (!layer || hasTable(text, "fill_pressure") || /^[ \t]*(as|friction_angle|cohesion)[ \t]*=/m.test(layer.table) || /^[ \t]*weighs[ \t]*=[ \t]*false/m.test(layer.table)) return null;
  const added = layer.table.replace(/^([ \t]*\[\[[ \t]*cover[ \t]*\]\][^\n]*\n)/m, `$1as = "continuum"\nfriction_angle = "30 deg"\ncohesion = "0 kPa"\n`);
  return added === layer.table ? null : text.slice(0, layer.start) + added + text.slice(layer.end);
}
