/** Blocks and particles where they have moved to, with the forces between them. */
import type { Picture } from "../engine/types";
import type { Frame } from "../model/run";
import { outline, type Bodies } from "./answer";
import type { Sheet } from "./elevation";
import { scaleColour } from "./ink";

export type Look = { times: number; stress: boolean; forces: boolean; dark: boolean };

/** Largest compression of each body [Pa], positive, from xx, yy, xy with tension positive. */
export function compressions(stresses: Float32Array): Float64Array {
  const out = new Float64Array(stresses.length / 3);
  for (let k = 0; k < out.length; k += 1) {
    const xx = stresses[3 * k]!;
    const yy = stresses[3 * k + 1]!;
    const xy = stresses[3 * k + 2]!;
    out[k] = Math.max(0, Math.hypot((xx - yy) / 2, xy) - (xx + yy) / 2);
  }
  return out;
}

/** The value that all but a hundredth stay below, so that one corner does not take the whole scale. */
export function nearlyMost(values: ArrayLike<number>): number {
  // Some hundred of them tell it as well as all.
  const stride = Math.max(1, Math.floor(values.length / 400));
  const list: number[] = [];
  for (let k = 0; k < values.length; k += stride) if (values[k]! > 0) list.push(values[k]!);
  list.sort((a, b) => a - b);
  return list.length === 0 ? 0 : list[Math.min(list.length - 1, Math.floor(0.99 * list.length))]!;
}

export function moved(sheet: Sheet, picture: Picture, bodies: Bodies, centroids: Float64Array, frame: Frame, look: Look): { top: number } {
  const { pen, view, ink } = sheet;
  let top = 0;

  // Fill first: the ring is drawn over it.
  const discs = frame.particles;
  if (discs.length > 0) {
    const mean = new Float64Array(discs.length / 5);
    for (let k = 0; k < mean.length; k += 1) mean[k] = Math.max(0, -discs[5 * k + 4]!);
    const most = look.stress ? nearlyMost(mean) : 0;
    const buckets = new Map<number, number[]>();
    for (let k = 0; k < mean.length; k += 1) {
      const bucket = most > 0 ? Math.round(24 * Math.min(1, mean[k]! / most)) : -1;
      const list = buckets.get(bucket);
      if (list) list.push(k);
      else buckets.set(bucket, [k]);
    }
    for (const [bucket, list] of buckets) {
      pen.beginPath();
      for (const k of list) {
        const x0 = picture.particles[k]?.centre[0] ?? discs[5 * k]!;
        const y0 = picture.particles[k]?.centre[1] ?? discs[5 * k + 1]!;
        const x = view.x(x0 + look.times * (discs[5 * k]! - x0));
        const y = view.y(y0 + look.times * (discs[5 * k + 1]! - y0));
        const r = discs[5 * k + 2]! * view.scale;
        pen.moveTo(x + r, y);
        pen.arc(x, y, r, 0, 2 * Math.PI);
      }
      pen.fillStyle = bucket < 0 ? ink.soilDark : scaleColour(bucket / 24, look.dark);
      pen.globalAlpha = bucket < 0 ? 1 : 0.75;
      pen.fill();
      pen.globalAlpha = 1;
      if (view.scale > 28 && mean.length < 900) {
        pen.strokeStyle = ink.line;
        pen.lineWidth = 0.4;
        pen.stroke();
      }
    }
  }

  const stress = look.stress ? compressions(frame.stresses) : null;
  if (stress) {
    const loose: number[] = [];
    stress.forEach((value, k) => !bodies.held[k] && loose.push(value));
    top = nearlyMost(loose);
  }
  for (let k = 0; k < bodies.offsets.length; k += 1) {
    const x0 = centroids[2 * k]!;
    const y0 = centroids[2 * k + 1]!;
    pen.beginPath();
    outline(
      pen,
      view,
      bodies.offsets[k]!,
      x0 + look.times * (frame.poses[3 * k]! - x0),
      y0 + look.times * (frame.poses[3 * k + 1]! - y0),
      look.times * frame.poses[3 * k + 2]!,
    );
    pen.fillStyle = bodies.held[k] ? ink.sheet : stress && top > 0 ? scaleColour(stress[k]! / top, look.dark) : ink.masonry;
    pen.fill();
    pen.strokeStyle = bodies.held[k] ? ink.ink : stress ? ink.sheet : ink.ink;
    pen.lineWidth = bodies.held[k] ? 1.2 : 0.7;
    pen.stroke();
  }

  if (look.forces) {
    // Forces of the fill are known where its particles are, not where they are drawn when displacements are enlarged.
    if (look.times === 1) chains(sheet, frame);
    contacts(sheet, frame, centroids, look.times);
  }
  return { top };
}

/** Forces between particles: the thicker the larger, in three thicknesses so that few strokes are made. */
function chains({ pen, view, ink }: Sheet, frame: Frame): void {
  const links = frame.chains;
  if (links.length === 0) return;
  const sizes = new Float64Array(links.length / 7);
  for (let k = 0; k < sizes.length; k += 1) sizes[k] = links[7 * k + 4]!;
  const most = nearlyMost(sizes);
  if (most <= 0) return;
  // No thicker than the particles are, so that the fill does not turn black.
  const radius = (frame.particles[2] ?? 0.1) * view.scale;
  const thick = Math.max(0.8, Math.min(3.2, 1.3 * radius));
  pen.strokeStyle = ink.ink;
  for (const [low, high, share] of [[0.1, 0.3, 0.22], [0.3, 0.6, 0.5], [0.6, Infinity, 1]] as const) {
    pen.lineWidth = share * thick;
    pen.beginPath();
    for (let k = 0; k < sizes.length; k += 1) {
      const size = sizes[k]! / most;
      if (size < low || size >= high) continue;
      pen.moveTo(view.x(links[7 * k]!), view.y(links[7 * k + 1]!));
      pen.lineTo(view.x(links[7 * k + 2]!), view.y(links[7 * k + 3]!));
    }
    pen.stroke();
  }
}

/** Forces in the joints: a short stroke along the force at each closed contact, the thicker the larger; those that slide are dashed. */
function contacts({ pen, view, ink }: Sheet, frame: Frame, centroids: Float64Array, times: number): void {
  const list = frame.contacts;
  let most = 0;
  for (let k = 0; k + 7 < list.length; k += 8) most = Math.max(most, list[k + 4]!);
  if (most <= 0) return;
  pen.strokeStyle = ink.answer;
  for (const [low, high, width] of [[0.02, 0.2, 1.2], [0.2, 0.45, 2.6], [0.45, 0.7, 4], [0.7, Infinity, 5.5]] as const) {
    for (const slides of [false, true]) {
      pen.lineWidth = width;
      pen.setLineDash(slides ? [2, 2] : []);
      pen.beginPath();
      for (let k = 0; k + 7 < list.length; k += 8) {
        if (list[k + 7]! > 0.5 !== slides) continue;
        const normal = list[k + 4]!;
        const shear = list[k + 5]!;
        const size = Math.hypot(normal, shear);
        if (size < low * most || size >= high * most) continue;
        const fx = (list[k + 2]! * normal - list[k + 3]! * shear) / size;
        const fy = (list[k + 3]! * normal + list[k + 2]! * shear) / size;
        const [px, py] = times === 1 ? [list[k]!, list[k + 1]!] : enlarged(list[k]!, list[k + 1]!, frame, centroids, times);
        const x = view.x(px);
        const y = view.y(py);
        pen.moveTo(x - 5 * fx, y + 5 * fy);
        pen.lineTo(x + 5 * fx, y - 5 * fy);
      }
      pen.stroke();
    }
  }
  pen.setLineDash([]);
}

/** Where a point of the nearest block stands when displacements are enlarged. */
function enlarged(x: number, y: number, frame: Frame, centroids: Float64Array, times: number): [number, number] {
  let best = 0;
  let least = Infinity;
  for (let k = 0; 3 * k < frame.poses.length; k += 1) {
    const distance = (frame.poses[3 * k]! - x) ** 2 + (frame.poses[3 * k + 1]! - y) ** 2;
    if (distance < least) {
      least = distance;
      best = k;
    }
  }
  const angle = frame.poses[3 * best + 2]!;
  const rx = x - frame.poses[3 * best]!;
  const ry = y - frame.poses[3 * best + 1]!;
  // Back to the block as built, then on with the enlarged movement.
  const bx = Math.cos(angle) * rx + Math.sin(angle) * ry;
  const by = -Math.sin(angle) * rx + Math.cos(angle) * ry;
  const c = Math.cos(times * angle);
  const s = Math.sin(times * angle);
  const cx = centroids[2 * best]!;
  const cy = centroids[2 * best + 1]!;
  return [
    cx + times * (frame.poses[3 * best]! - cx) + c * bx - s * by,
    cy + times * (frame.poses[3 * best + 1]! - cy) + s * bx + c * by,
  ];
}

/** The scale of stress in a corner of the sheet. */
export function stressScale({ pen, ink, width, height }: Sheet, most: string, dark: boolean): void {
  const x = width - 190;
  const y = height - 66;
  for (let k = 0; k < 48; k += 1) {
    pen.fillStyle = scaleColour(k / 47, dark);
    pen.fillRect(x + k * 3, y, 3.4, 9);
  }
  pen.strokeStyle = ink.ink;
  pen.lineWidth = 0.8;
  pen.strokeRect(x, y, 144, 9);
  pen.font = `400 12px ${ink.font}`;
  pen.fillStyle = ink.ink;
  pen.textBaseline = "bottom";
  pen.textAlign = "left";
  pen.fillText("0", x, y - 2);
  pen.textAlign = "right";
  pen.fillText(most, x + 144, y - 2);
}
