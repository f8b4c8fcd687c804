/** The bridge as built, as on an engineer's drawing: the layer that changes with the bridge and not with the load. */
import type { Dimension, Picture, Point } from "../engine/types";
import { dimension, inSystem, type System } from "../units";
import { typeset } from "../wording";
import { label, line, pathOf, trace, type Pen } from "./canvas";
import type { Ink } from "./ink";
import { boundsOf, roadOf, type View } from "./view";

export type Sheet = { pen: Pen; view: View; ink: Ink; width: number; height: number; system: System };

/** Detail paper: metres, every fifth one stronger. Feet would be no better a guide, so that metres stay. */
export function grid({ pen, view, ink, width, height }: Sheet): void {
  let step = 1;
  while (step * view.scale < 14) step *= 5;
  pen.strokeStyle = ink.grid;
  const first = Math.floor(view.metresX(0) / step);
  const last = Math.ceil(view.metresX(width) / step);
  for (let k = first; k <= last; k += 1) {
    pen.lineWidth = k % 5 === 0 ? 1 : 0.5;
    const x = Math.round(view.x(k * step)) + 0.5;
    line(pen, x, 0, x, height);
  }
  const low = Math.floor(view.metresY(height) / step);
  const high = Math.ceil(view.metresY(0) / step);
  for (let k = low; k <= high; k += 1) {
    pen.lineWidth = k % 5 === 0 ? 1 : 0.5;
    const y = Math.round(view.y(k * step)) + 0.5;
    line(pen, 0, y, width, y);
  }
}

function hatch(pen: Pen, path: Path2D, colour: string, spacing: number, box: { left: number; right: number; top: number; bottom: number }): void {
  pen.save();
  pen.clip(path);
  pen.strokeStyle = colour;
  pen.lineWidth = 0.7;
  pen.beginPath();
  const height = box.bottom - box.top;
  for (let x = box.left - height; x < box.right; x += spacing) {
    pen.moveTo(x, box.bottom);
    pen.lineTo(x + height, box.top);
  }
  pen.stroke();
  pen.restore();
}

function screenBox(view: View, points: Point[]) {
  let left = Infinity, right = -Infinity, top = Infinity, bottom = -Infinity;
  for (const p of points) {
    left = Math.min(left, view.x(p[0]));
    right = Math.max(right, view.x(p[0]));
    top = Math.min(top, view.y(p[1]));
    bottom = Math.max(bottom, view.y(p[1]));
  }
  return { left, right, top, bottom };
}

/** What lies on the ring: a tint for each layer, the uppermost (surfacing, ballast) darker; backing hatched as masonry. */
export function cover({ pen, view, ink }: Sheet, picture: Picture): void {
  picture.bands.forEach((band, k) => {
    if (band.outlines.length === 0) return;
    const path = pathOf(view, band.outlines);
    const backing = band.name.includes("backing");
    pen.fillStyle = backing ? ink.masonry : /surfac|ballast|road|asphalt/.test(band.name) ? ink.road : k % 2 === 0 ? ink.soil : ink.soilDark;
    pen.fill(path);
    if (backing) for (const outline of band.outlines) hatch(pen, pathOf(view, [outline]), ink.line, 7, screenBox(view, outline));
    pen.strokeStyle = ink.line;
    pen.lineWidth = 0.5;
    pen.stroke(path);
  });
  if (picture.fill.length > 2) {
    pen.fillStyle = ink.soil;
    pen.fill(pathOf(view, [picture.fill]));
  }
}

export function particles({ pen, view, ink }: Sheet, picture: Picture): void {
  if (picture.particles.length === 0) return;
  pen.strokeStyle = ink.line;
  pen.lineWidth = 0.5;
  pen.fillStyle = ink.soilDark;
  pen.beginPath();
  for (const { centre, radius } of picture.particles) {
    const r = radius * view.scale;
    pen.moveTo(view.x(centre[0]) + r, view.y(centre[1]));
    pen.arc(view.x(centre[0]), view.y(centre[1]), r, 0, 2 * Math.PI);
  }
  pen.fill();
  pen.stroke();
}

export function masonry({ pen, view, ink }: Sheet, picture: Picture, faint = false): void {
  const held: Point[][] = [];
  const loose: Point[][] = [];
  const backing: Point[][] = [];
  for (const shape of picture.shapes) {
    if (shape.held) held.push(shape.outline);
    else if (shape.role === "backing") backing.push(shape.outline);
    else loose.push(shape.outline);
  }
  pen.globalAlpha = faint ? 0.35 : 1;
  if (backing.length > 0) {
    const path = pathOf(view, backing);
    pen.fillStyle = ink.masonryDark;
    pen.fill(path);
    pen.strokeStyle = ink.line;
    pen.lineWidth = 0.5;
    pen.stroke(path);
  }
  if (loose.length > 0) {
    const path = pathOf(view, loose);
    pen.fillStyle = ink.masonry;
    pen.fill(path);
    pen.strokeStyle = ink.ink;
    pen.lineWidth = view.scale > 60 ? 0.9 : 0.6;
    pen.lineJoin = "round";
    pen.stroke(path);
  }
  for (const outline of held) {
    const path = pathOf(view, [outline]);
    pen.fillStyle = ink.sheet;
    pen.fill(path);
    hatch(pen, path, ink.soft, 6, screenBox(view, outline));
    pen.strokeStyle = ink.ink;
    pen.lineWidth = 1.3;
    pen.stroke(path);
  }
  pen.globalAlpha = 1;
}

export function road({ pen, view, ink }: Sheet, picture: Picture): void {
  const surface = roadOf(picture);
  pen.strokeStyle = ink.ink;
  pen.lineWidth = 1.6;
  pen.beginPath();
  trace(pen, view, surface, false);
  pen.stroke();
}

export function defects({ pen, view, ink }: Sheet, picture: Picture): void {
  pen.strokeStyle = ink.second;
  pen.lineWidth = 3;
  picture.defects.forEach((defect, k) => {
    pen.beginPath();
    trace(pen, view, defect.line, false);
    pen.stroke();
    const middle = defect.line[Math.floor(defect.line.length / 2)];
    if (!middle) return;
    pen.fillStyle = ink.second;
    pen.textAlign = "center";
    pen.textBaseline = "bottom";
    label(pen, String(k + 1), view.x(middle[0]), view.y(middle[1]) - 6, ink.sheet);
  });
}

/** The oblique stroke of a dimension line. */
function tick(pen: Pen, x: number, y: number): void {
  line(pen, x - 4, y + 4, x + 4, y - 4);
}

/** Where the line of a dimension stands on the sheet, in pixels; handles stand at its second end. */
export type Placed = { dimension: Dimension; index: number; from: Point; to: Point; text: string; anchor: Point };

export function placeDimensions(picture: Picture, view: View, system: System, small: boolean): Placed[] {
  const counts = new Map<string, number>();
  const said = new Set<string>();
  const box = boundsOf(picture);
  const spans = picture.dimensions.filter((one) => one.measure === "Span");
  const lowest = Math.min(...spans.map((one) => Math.min(one.from[1], one.to[1])), Infinity);
  return picture.dimensions.flatMap((one) => {
    const index = (counts.get(one.measure) ?? 0) + 1;
    counts.set(one.measure, index);
    const length = one.measure === "Span" ? Math.abs(one.to[0] - one.from[0])
      : one.measure === "Rise" || one.measure === "Height" || one.measure === "Depth" ? Math.abs(one.to[1] - one.from[1])
      : Math.hypot(one.to[0] - one.from[0], one.to[1] - one.from[1]);
    const text = dimension(length, system);
    let from = view.at(one.from);
    let to = view.at(one.to);
    if (one.measure === "Span") {
      const y = view.y(Number.isFinite(lowest) ? lowest : box.bottom) + (small ? 18 : 26);
      from = [from[0], y];
      to = [to[0], y];
    } else if (one.measure === "Rise") {
      from = [to[0], from[1]];
    } else if (one.measure === "Height") {
      from = [to[0], from[1]];
    }
    // On a small sheet what repeats is said once, spans apart.
    const repeated = said.has(one.measure + text);
    said.add(one.measure + text);
    if (view.scale < 16 && repeated && one.measure !== "Span") return [];
    return [{ dimension: one, index, from, to, text, anchor: view.at(one.to) }];
  });
}

export function dimensions({ pen, view, ink }: Sheet, placed: Placed[]): void {
  pen.strokeStyle = ink.soft;
  pen.fillStyle = ink.ink;
  pen.lineWidth = 0.8;
  pen.font = `500 13px ${ink.font}`;
  const thick: Placed[] = [];
  for (const one of placed) {
    const { measure, from, to } = one.dimension;
    if (measure === "Span") {
      const a = view.at(from);
      const b = view.at(to);
      line(pen, a[0], a[1] + 5, one.from[0], one.from[1] + 6);
      line(pen, b[0], b[1] + 5, one.to[0], one.to[1] + 6);
      line(pen, one.from[0], one.from[1], one.to[0], one.to[1]);
      tick(pen, one.from[0], one.from[1]);
      tick(pen, one.to[0], one.to[1]);
      pen.textAlign = "center";
      pen.textBaseline = "middle";
      const middle = (one.from[0] + one.to[0]) / 2;
      const width = pen.measureText(one.text).width;
      // Off the middle, where the rise has its foot.
      const shift = Math.min(width, Math.abs(one.to[0] - one.from[0]) / 4);
      label(pen, one.text, middle - (Math.abs(one.to[0] - one.from[0]) > 3 * width ? shift : 0), one.from[1], ink.sheet);
    } else if (measure === "Rise" || measure === "Height") {
      const x = one.to[0];
      line(pen, x, one.from[1], x, one.to[1]);
      if (measure === "Rise") line(pen, x - 9, one.from[1], x + 9, one.from[1]);
      tick(pen, x, one.from[1]);
      tick(pen, x, one.to[1]);
      pen.textAlign = "left";
      pen.textBaseline = "middle";
      if (Math.abs(one.from[1] - one.to[1]) > (measure === "Height" ? 46 : 22)) label(pen, one.text, x + 8, (one.from[1] + one.to[1]) / 2, ink.sheet);
    } else if (measure === "Width") {
      thick.push(one);
    } else {
      thick.push(one);
    }
  }
  // Thin things are measured between arrows from outside, with their figure at the end of a leader.
  for (const one of thick) {
    const a = one.from;
    const b = one.to;
    const dx = b[0] - a[0];
    const dy = b[1] - a[1];
    const length = Math.hypot(dx, dy) || 1;
    const ux = dx / length;
    const uy = dy / length;
    if (one.dimension.measure === "Width") {
      line(pen, a[0], a[1], b[0], b[1]);
      tick(pen, a[0], a[1]);
      tick(pen, b[0], b[1]);
      pen.textAlign = "center";
      pen.textBaseline = "top";
      if (Math.abs(b[0] - a[0]) > 20) label(pen, one.text, (a[0] + b[0]) / 2, Math.max(a[1], b[1]) + 6, ink.sheet);
      continue;
    }
    const side = one.dimension.measure === "Depth" ? -1 : 1;
    const x = (a[0] + b[0]) / 2;
    const y = (a[1] + b[1]) / 2;
    pen.strokeStyle = ink.ink;
    line(pen, a[0], a[1], b[0], b[1]);
    arrow(pen, a[0], a[1], -ux, -uy, 10);
    arrow(pen, b[0], b[1], ux, uy, 10);
    pen.strokeStyle = ink.soft;
    const endX = x + side * 34;
    line(pen, x, y, endX, y);
    pen.textAlign = side > 0 ? "left" : "right";
    pen.textBaseline = "middle";
    label(pen, one.text, endX + side * 4, y, ink.sheet);
  }
}

/** An arrow from outside whose tip touches (x, y); (ux, uy) points away from what is measured. */
function arrow(pen: Pen, x: number, y: number, ux: number, uy: number, length: number): void {
  line(pen, x, y, x + ux * length, y + uy * length);
  pen.beginPath();
  pen.moveTo(x, y);
  pen.lineTo(x + ux * 6 - uy * 2.2, y + uy * 6 + ux * 2.2);
  pen.lineTo(x + ux * 6 + uy * 2.2, y + uy * 6 - ux * 2.2);
  pen.closePath();
  const fill = pen.fillStyle;
  pen.fillStyle = pen.strokeStyle;
  pen.fill();
  pen.fillStyle = fill;
}

/** Names of the layers above the right end of the road, each with a leader to its layer. */
export function layerNames({ pen, view, ink, width, system }: Sheet, picture: Picture): void {
  const bands = picture.bands.filter((band) => band.outlines.some((outline) => outline.length > 2));
  if (bands.length === 0 || width < 560) return;
  pen.font = `400 12px ${ink.font}`;
  pen.fillStyle = ink.soft;
  pen.strokeStyle = ink.soft;
  pen.lineWidth = 0.6;
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  const notes = bands.map((band) => {
    const points = band.outlines.flat();
    const right = Math.max(...points.map((p) => p[0]));
    const near = points.filter((p) => p[0] > right - 0.02);
    const top = Math.max(...near.map((p) => p[1]));
    const bottom = Math.min(...near.map((p) => p[1]));
    return { text: typeset(inSystem(`${band.name}${band.size ? ` ${band.size}` : ""}`, system)), right, y: Math.max((bottom + top) / 2, top - 0.4), top };
  });
  notes.sort((a, b) => b.y - a.y);
  const end = Math.min(width - 14, view.x(Math.max(...notes.map((note) => note.right))));
  const roadY = Math.min(...notes.map((note) => view.y(note.top)));
  notes.forEach((note, k) => {
    const y = roadY - 14 - 15 * (notes.length - 1 - k);
    // The uppermost name stands farthest to the right, so that its line passes by the names below.
    const x = end - 8 - 9 * k;
    pen.beginPath();
    pen.moveTo(x - 3, y);
    pen.lineTo(x, y);
    pen.lineTo(x, view.y(note.y));
    pen.stroke();
    pen.beginPath();
    pen.arc(x, view.y(note.y), 1.6, 0, 2 * Math.PI);
    pen.fill();
    pen.fillText(note.text, x - 6, y);
  });
}

/** A bar of whole metres (or feet) in a corner of the sheet. */
export function scaleBar({ pen, view, ink, height, system }: Sheet, bottom: number): void {
  const unit = system === "metric" ? 1 : 0.3048;
  const wanted = 110 / view.scale / unit;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const count = [1, 2, 5, 10].map((k) => k * power).filter((k) => k <= wanted).pop() ?? power;
  const parts = count / power === 2 ? 4 : 5;
  const x = 16;
  const y = height - bottom - 14;
  const length = count * unit * view.scale;
  pen.lineWidth = 1;
  pen.strokeStyle = ink.ink;
  for (let k = 0; k < parts; k += 1) {
    pen.fillStyle = k % 2 === 0 ? ink.ink : ink.sheet;
    pen.fillRect(x + (k * length) / parts, y, length / parts, 4);
    pen.strokeRect(x + (k * length) / parts, y, length / parts, 4);
  }
  pen.font = `400 12px ${ink.font}`;
  pen.fillStyle = ink.ink;
  pen.textBaseline = "bottom";
  pen.textAlign = "left";
  pen.fillText("0", x, y - 2);
  pen.textAlign = "right";
  pen.fillText(`${count} ${system === "metric" ? "m" : "ft"}`, x + length + 6, y - 2);
}
