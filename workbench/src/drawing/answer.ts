/** What the load does, in the one accent colour of the sheet: the layer that follows the pointer. */
import type { LiveAnswer, Picture, Point } from "../engine/types";
import { force, place, pressure, words, type System } from "../units";
import { label, line, type Pen } from "./canvas";
import type { Sheet } from "./elevation";
import { roadAt, type View } from "./view";

/** Outlines about the centroid of each shape, made once a picture, so that moved shapes cost additions alone. */
export type Bodies = { offsets: Float64Array[]; held: boolean[] };

export function bodiesOf(picture: Picture, centroids: Float64Array): Bodies {
  return {
    held: picture.shapes.map((shape) => shape.held),
    offsets: picture.shapes.map((shape, k) => {
      const cx = centroids[2 * k] ?? 0;
      const cy = centroids[2 * k + 1] ?? 0;
      const flat = new Float64Array(2 * shape.outline.length);
      shape.outline.forEach(([x, y], n) => {
        flat[2 * n] = x - cx;
        flat[2 * n + 1] = y - cy;
      });
      return flat;
    }),
  };
}

/** Adds the outline of a body with its centroid at (cx, cy), turned by an angle. */
export function outline(pen: Pen | Path2D, view: View, offsets: Float64Array, cx: number, cy: number, angle: number): void {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  for (let n = 0; n < offsets.length; n += 2) {
    const x = view.x(cx + c * offsets[n]! - s * offsets[n + 1]!);
    const y = view.y(cy + s * offsets[n]! + c * offsets[n + 1]!);
    if (n === 0) pen.moveTo(x, y);
    else pen.lineTo(x, y);
  }
  pen.closePath();
}

/** The mechanism, so large that its greatest movement is `reach` pixels. */
export function mechanism({ pen, view, ink }: Sheet, bodies: Bodies, answer: LiveAnswer, reach: number): void {
  const motion = answer.mechanism;
  if (motion.length === 0) return;
  const times = reach / view.scale;
  pen.beginPath();
  for (let k = 0; k < bodies.offsets.length; k += 1) {
    if (bodies.held[k]) continue;
    const dx = motion[3 * k]! * times;
    const dy = motion[3 * k + 1]! * times;
    const turn = motion[3 * k + 2]! * times;
    if (Math.abs(dx) + Math.abs(dy) + Math.abs(turn) < 1e-9) continue;
    outline(pen, view, bodies.offsets[k]!, answer.centroids[2 * k]! + dx, answer.centroids[2 * k + 1]! + dy, turn);
  }
  pen.strokeStyle = ink.answer;
  pen.globalAlpha = 0.6;
  pen.lineWidth = 0.8;
  pen.stroke();
  pen.globalAlpha = 1;
}

/** Where the thrust may lie: between its lowest and highest place in every joint. Gaps where a joint has no answer. */
export function thrustZone({ pen, view, ink }: Sheet, zone: Float64Array): void {
  pen.fillStyle = ink.answerSoft;
  let low: Point[] = [];
  let high: Point[] = [];
  const close = (): void => {
    if (low.length > 1) {
      pen.beginPath();
      low.forEach((p, k) => (k === 0 ? pen.moveTo(p[0], p[1]) : pen.lineTo(p[0], p[1])));
      high.reverse().forEach((p) => pen.lineTo(p[0], p[1]));
      pen.closePath();
      pen.fill();
    }
    low = [];
    high = [];
  };
  for (let k = 0; k + 3 < zone.length; k += 4) {
    if (Number.isNaN(zone[k]!)) {
      close();
      continue;
    }
    const p: Point = [view.x(zone[k]!), view.y(zone[k + 1]!)];
    const before = low[low.length - 1];
    // The next span or ring begins elsewhere.
    if (before && Math.hypot(p[0] - before[0], p[1] - before[1]) > 3 * view.scale) close();
    low.push(p);
    high.push([view.x(zone[k + 2]!), view.y(zone[k + 3]!)]);
  }
  close();
}

export function thrust({ pen, view, ink }: Sheet, answer: LiveAnswer): void {
  const { thrust: points, thrustStarts: starts } = answer;
  const count = points.length / 3;
  pen.strokeStyle = ink.answer;
  pen.lineWidth = 2.2;
  pen.lineJoin = "round";
  pen.lineCap = "round";
  pen.beginPath();
  for (let s = 0; s < starts.length; s += 1) {
    const end = s + 1 < starts.length ? starts[s + 1]! : count;
    for (let k = starts[s]!; k < end; k += 1) {
      const x = view.x(points[3 * k]!);
      const y = view.y(points[3 * k + 1]!);
      if (k === starts[s]) pen.moveTo(x, y);
      else pen.lineTo(x, y);
    }
  }
  pen.stroke();
}

export function hinges({ pen, view, ink }: Sheet, points: { point: Point }[]): void {
  for (const { point } of points) {
    pen.beginPath();
    pen.arc(view.x(point[0]), view.y(point[1]), 5.5, 0, 2 * Math.PI);
    pen.fillStyle = ink.sheet;
    pen.fill();
    pen.lineWidth = 2.4;
    pen.strokeStyle = ink.answer;
    pen.stroke();
  }
}

/** Joints that slide: a lozenge, so that the shape and not the colour tells it from a hinge. */
export function sliding({ pen, view, ink }: Sheet, points: Point[]): void {
  pen.fillStyle = ink.answer;
  for (const point of points) {
    const [x, y] = view.at(point);
    pen.beginPath();
    pen.moveTo(x, y - 7);
    pen.lineTo(x + 4, y);
    pen.lineTo(x, y + 7);
    pen.lineTo(x - 4, y);
    pen.closePath();
    pen.fill();
  }
}

/** Forces that reach the blocks through the cover, thin and in ink. */
export function dispersed({ pen, view, ink }: Sheet, loads: Float64Array): void {
  let most = 0;
  for (let k = 0; k + 3 < loads.length; k += 4) most = Math.max(most, Math.hypot(loads[k + 2]!, loads[k + 3]!));
  if (most === 0) return;
  pen.strokeStyle = ink.soft;
  pen.lineWidth = 1;
  pen.beginPath();
  for (let k = 0; k + 3 < loads.length; k += 4) {
    const fx = loads[k + 2]!;
    const fy = loads[k + 3]!;
    const size = Math.hypot(fx, fy);
    if (size < 0.02 * most) continue;
    const long = 4 + (20 * size) / most;
    const x = view.x(loads[k]!);
    const y = view.y(loads[k + 1]!);
    const ux = fx / size;
    const uy = -fy / size;
    pen.moveTo(x - ux * long, y - uy * long);
    pen.lineTo(x, y);
    pen.moveTo(x - ux * 4 - uy * 2, y - uy * 4 + ux * 2);
    pen.lineTo(x, y);
    pen.lineTo(x - ux * 4 + uy * 2, y - uy * 4 - ux * 2);
  }
  pen.stroke();
}

/** How an axle of a vehicle stands at this place. */
export type Wheel = { x: number; force: number; counts: boolean; critical: boolean };

/** The wheels of a vehicle on the road, joined to one another; one that would help the bridge here does not count and is hollow, and the one that bears a further factor
 * is in the colour of the answer. Returns how high they reach [px]. */
export function wheels({ pen, view, ink }: Sheet, picture: Picture, list: Wheel[]): number {
  if (list.length === 0) return 0;
  const radius = Math.max(4, Math.min(9, 0.45 * view.scale));
  const placed = [...list].sort((a, b) => a.x - b.x).map((one) => ({ ...one, px: view.x(one.x), py: view.y(roadAt(picture, one.x)) - 5 - radius }));
  pen.strokeStyle = ink.ink;
  pen.lineWidth = 2;
  pen.beginPath();
  placed.forEach(({ px, py }, k) => (k === 0 ? pen.moveTo(px, py) : pen.lineTo(px, py)));
  pen.stroke();
  for (const { px, py, counts, critical } of placed) {
    pen.beginPath();
    pen.arc(px, py, radius, 0, 2 * Math.PI);
    pen.fillStyle = critical ? ink.answer : counts ? ink.ink : ink.sheet;
    pen.fill();
    pen.strokeStyle = critical ? ink.answer : ink.ink;
    pen.lineWidth = 1.6;
    pen.stroke();
    if (!counts) continue;
    pen.beginPath();
    pen.arc(px, py, 0.35 * radius, 0, 2 * Math.PI);
    pen.fillStyle = ink.sheet;
    pen.fill();
  }
  return 2 * radius;
}

/** Axles or patches on the road: an arrow each with the length that they press on, and what they weigh where that is given and not sought: axles as a whole, the rest of a
 * train or lane per metre of width and length. */
export function axles(sheet: Sheet, picture: Picture, axles: Float64Array, system: System, given: Wheel[] | null): void {
  const { pen, view, ink } = sheet;
  const high = given ? wheels(sheet, picture, given) : 0;
  pen.font = `600 13px ${ink.font}`;
  pen.textAlign = "center";
  pen.textBaseline = "bottom";
  let lastRight = -Infinity;
  const order = Array.from({ length: axles.length / 4 }, (_, k) => k).sort((a, b) => axles[4 * a]! - axles[4 * b]!);
  for (const k of order) {
    const x = axles[4 * k]!;
    const length = axles[4 * k + 2]!;
    const size = axles[4 * k + 3]!;
    const px = view.x(x);
    const py = view.y(Number.isFinite(axles[4 * k + 1]!) ? axles[4 * k + 1]! : roadAt(picture, x));
    const half = Math.max(3, (length * view.scale) / 2);
    pen.fillStyle = ink.ink;
    pen.fillRect(px - half, py - 5, 2 * half, 5);
    pen.strokeStyle = ink.ink;
    pen.lineWidth = 2;
    // Above its wheel, where it has one.
    const tip = py - 6 - high;
    line(pen, px, tip - 34 + Math.min(high, 12), px, tip - 6);
    pen.beginPath();
    pen.moveTo(px, tip);
    pen.lineTo(px - 5, tip - 10);
    pen.lineTo(px + 5, tip - 10);
    pen.closePath();
    pen.fill();
    // A narrow drawing has no room for them.
    if (given && sheet.width > 560) {
      const axle = given.find((one) => Math.abs(one.x - x) < 1e-6);
      const said = words(axle ? force(axle.force, system) : pressure(size / length, system));
      const text = axle?.critical ? `${said}, critical` : said;
      const width = pen.measureText(text).width;
      if (px - width / 2 > Math.max(0, lastRight + 6) && px + width / 2 < sheet.width) {
        label(pen, text, px, tip - 36 + Math.min(high, 12), ink.sheet);
        lastRight = px + width / 2;
      }
    }
  }
}

/** Places from left to right, what is carried there, and which of them have been answered. */
export type Envelope = { xs: Float64Array; factors: Float64Array; known: Uint8Array };

/** What is carried over the place of the load, on the scale of the bridge below it; the least one is marked. */
export function envelope(
  sheet: Sheet,
  curve: Envelope,
  times: number,
  say: (value: number) => string,
  top: number,
  bottom: number,
  here: { x: number; factor: number | null } | null,
): void {
  const { pen, view, ink, system, width } = sheet;
  let least = Infinity;
  let leastAt = -1;
  let most = 0;
  for (let k = 0; k < curve.xs.length; k += 1) {
    const factor = curve.factors[k]!;
    if (!curve.known[k] || !Number.isFinite(factor)) continue;
    if (factor < least) {
      least = factor;
      leastAt = k;
    }
    most = Math.max(most, factor);
  }
  if (leastAt < 0) return;
  const ceiling = Math.min(most, 3 * least) * 1.05;
  const y = (factor: number) => bottom - ((bottom - top) * Math.min(factor, 3 * ceiling)) / ceiling;
  pen.strokeStyle = ink.line;
  pen.lineWidth = 0.8;
  const left = view.x(curve.xs[0]!);
  const right = view.x(curve.xs[curve.xs.length - 1]!);
  line(pen, left, bottom + 0.5, right, bottom + 0.5);
  pen.font = `400 12px ${ink.font}`;
  pen.fillStyle = ink.soft;
  pen.textAlign = "left";
  pen.textBaseline = "top";
  if (width > 560) pen.fillText("Carried, over the place of the load", Math.max(8, left), bottom + 4);
  // What the height of the curve is: its upper end, and none at its foot.
  const upper = say(ceiling * times);
  pen.textAlign = "left";
  pen.textBaseline = "top";
  if (width > right + 14 + pen.measureText(upper).width) pen.fillText(upper, right + 6, top);
  pen.setLineDash([2, 3]);
  line(pen, left, y(least), right, y(least));
  pen.setLineDash([]);
  pen.save();
  pen.beginPath();
  pen.rect(0, top - 2, width, bottom - top + 4);
  pen.clip();
  pen.beginPath();
  let open = false;
  for (let k = 0; k < curve.xs.length; k += 1) {
    if (!curve.known[k]) continue;
    const factor = curve.factors[k]!;
    if (!Number.isFinite(factor)) {
      open = false;
      continue;
    }
    const px = view.x(curve.xs[k]!);
    if (open) pen.lineTo(px, y(factor));
    else pen.moveTo(px, y(factor));
    open = true;
  }
  // Much larger loads run out of the strip.
  pen.strokeStyle = ink.answer;
  pen.lineWidth = 1.6;
  pen.stroke();
  pen.restore();
  const px = view.x(curve.xs[leastAt]!);
  pen.fillStyle = ink.answer;
  pen.beginPath();
  pen.moveTo(px, y(least) + 2);
  pen.lineTo(px - 5, y(least) + 11);
  pen.lineTo(px + 5, y(least) + 11);
  pen.closePath();
  pen.fill();
  pen.font = `600 13px ${ink.font}`;
  pen.textBaseline = "top";
  const text = `least ${say(least * times)} at ${words(place(curve.xs[leastAt]!, system))}`;
  const half = pen.measureText(text).width / 2;
  pen.textAlign = "center";
  label(pen, text, Math.min(width - half - 8, Math.max(half + 8, px)), y(least) + 13, ink.sheet);
  if (here && here.factor !== null && Number.isFinite(here.factor) && y(here.factor) >= top - 4) {
    const hx = view.x(here.x);
    pen.beginPath();
    pen.arc(hx, y(here.factor), 4, 0, 2 * Math.PI);
    pen.fillStyle = ink.answer;
    pen.fill();
    pen.strokeStyle = ink.answer;
    pen.lineWidth = 0.7;
    pen.setLineDash([3, 3]);
    line(pen, hx, y(here.factor), hx, bottom);
    pen.setLineDash([]);
  }
}
