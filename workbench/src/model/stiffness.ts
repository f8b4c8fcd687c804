/** Stiffness of joints that nobody measured, as the engine itself assumes it where it may: a tenth of the modulus of the masonry over the length of a stone. */
import type { Picture } from "../engine/types";
import { tablesOf } from "./structure";

/** What the deformation of a joint with its stones is more than that of the stones alone. */
const SHARE = 0.1;
/** Shear over normal stiffness of an elastic layer with Poisson's ratio 0.2: 1 / (2 (1 + 0.2)). */
const SHEAR = 1 / 2.4;

const middle = (outline: [number, number][]): [number, number] => [
  outline.reduce((sum, point) => sum + point[0], 0) / outline.length,
  outline.reduce((sum, point) => sum + point[1], 0) / outline.length,
];

/** Length of a stone along the ring [m]: half of the stones lie closer to the next one than this, half farther. */
export function stoneLength(picture: Picture): number | null {
  const middles = picture.shapes.filter((shape) => shape.role === "voussoir").map((shape) => middle(shape.outline));
  const apart = middles.slice(1).map((point, k) => Math.hypot(point[0] - middles[k]![0], point[1] - middles[k]![1]));
  apart.sort((a, b) => a - b);
  return apart[Math.floor(apart.length / 2)] ?? null;
}

export const lacksStiffness = (text: string): boolean => !/^\s*(mortar_)?normal_stiffness\s*=/m.test(text);

/** The text with a stiffness for its joints, by a modulus as written ("8 GPa") and the length of a stone [m]; null where that cannot be done. */
export function withStiffness(text: string, modulus: string, length: number, source: string): string | null {
  const number = /^([\d.]+) GPa$/.exec(modulus);
  const joint = tablesOf(text).find((table) => table.name === "joint" && !table.list);
  if (!number || !joint || !(length > 0)) return null;
  const normal = (SHARE * Number(number[1])) / length;
  const header = text.indexOf("]", text.indexOf("[joint]", joint.start));
  const at = text.indexOf("\n", header);
  if (at < 0) return null;
  const remark = `# assumed: a tenth of ${modulus} (${source}) over stones of ${length.toFixed(2)} m`;
  return `${text.slice(0, at + 1)}normal_stiffness = "${normal.toFixed(2)} GPa/m"  ${remark}\nshear_stiffness = "${(SHEAR * normal).toFixed(2)} GPa/m"  # assumed: Poisson's ratio 0.2\n${text.slice(at + 1)}`;
}
