/** Which quantity of the file a dimension of the drawing measures, so that its handle can change it. */
import type { Quantity } from "../engine/types";
import type { Placed } from "./elevation";

export type Handle = { placed: Placed; path: string; title: string; quantity: Quantity; axis: "x" | "y"; sign: 1 | -1; share: number };

/** Index in the file of the nth span (or pier) as drawn: tables may stand for several with `repeat`. */
function tableOf(quantities: Quantity[], list: string, drawn: number): { index: number; repeat: number } | null {
  let passed = 0;
  for (let index = 1; index <= 64; index += 1) {
    const own = quantities.filter((q) => q.path.startsWith(`${list}[${index}].`));
    if (own.length === 0) return null;
    const repeat = Math.max(1, own.find((q) => q.path === `${list}[${index}].repeat`)?.number ?? 1);
    if (drawn <= passed + repeat) return { index, repeat };
    passed += repeat;
  }
  return null;
}

export function handlesOf(placed: Placed[], quantities: Quantity[]): Handle[] {
  const handles: Handle[] = [];
  const byPath = new Map(quantities.map((quantity) => [quantity.path, quantity]));
  const seen = new Set<string>();
  for (const one of placed) {
    const measure = one.dimension.measure;
    let candidates: string[] = [];
    let title = "";
    let axis: "x" | "y" = "y";
    let sign: 1 | -1 = 1;
    if (measure === "Span" || measure === "Rise" || measure === "Thickness") {
      // Thickness and rise are drawn once a span, or once for all: the nth is of the nth span that has one.
      const table = tableOf(quantities, "span", one.index);
      if (!table) continue;
      const base = `span[${table.index}]`;
      if (measure === "Span") {
        candidates = [`${base}.span`, `${base}.square_span`];
        axis = "x";
        title = `Span ${table.index}`;
      } else if (measure === "Rise") {
        candidates = [`${base}.rise`];
        title = `Rise of span ${table.index}`;
      } else {
        candidates = [`${base}.thickness`, `${base}.crown_thickness`];
        title = `Ring thickness of span ${table.index}`;
      }
    } else if (measure === "Depth") {
      const layers = quantities.filter((q) => /^cover\[\d+\]\.thickness$/.test(q.path));
      candidates = layers.slice(0, 1).map((q) => q.path);
      title = "Depth of the lowest layer at the crown";
    } else {
      const table = tableOf(quantities, "pier", one.index);
      if (!table) continue;
      candidates = [`pier[${table.index}].${measure === "Height" ? "height" : "width"}`];
      title = `${measure} of pier ${table.index}`;
      axis = measure === "Height" ? "y" : "x";
      sign = measure === "Height" ? -1 : 1;
    }
    const path = candidates.find((candidate) => {
      const quantity = byPath.get(candidate);
      return quantity !== undefined && quantity.number !== null && !quantity.by_default;
    });
    if (!path || seen.has(path)) continue;
    seen.add(path);
    if (measure === "Height" && one.dimension.to[1] > one.dimension.from[1]) sign = 1;
    handles.push({ placed: one, path, title, quantity: byPath.get(path)!, axis, sign, share: 1 });
  }
  return handles;
}

const METRES: Record<string, number> = { m: 1, mm: 1e-3, cm: 1e-2, ft: 0.3048, in: 0.0254, yd: 0.9144 };

/** Length of a quantity in metres; null where its unit is no length. */
export function metresOf(quantity: Quantity): number | null {
  const per = METRES[quantity.unit];
  return per === undefined || quantity.number === null ? null : quantity.number * per;
}

/** A length in the unit in which the file states it, to the millimetre or its like. */
export function literalOf(quantity: Quantity, metres: number): string {
  const per = METRES[quantity.unit] ?? 1;
  const decimals: Record<string, number> = { m: 3, mm: 0, cm: 1, ft: 3, in: 2, yd: 3 };
  return `${(metres / per).toFixed(decimals[quantity.unit] ?? 3)} ${quantity.unit}`;
}
