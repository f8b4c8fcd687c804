/** From metres of the bridge (x right, y up) to pixels of the sheet (x right, y down), at one scale in both directions. */
import type { Picture, Point } from "../engine/types";

export type Box = { left: number; right: number; bottom: number; top: number };
export type Margins = { left: number; right: number; top: number; bottom: number };

export class View {
  constructor(
    /** Pixels a metre. */
    readonly scale: number,
    readonly originX: number,
    readonly originY: number,
  ) {}

  x(metres: number): number {
    return this.originX + this.scale * metres;
  }
  y(metres: number): number {
    return this.originY - this.scale * metres;
  }
  at(point: Point): Point {
    return [this.x(point[0]), this.y(point[1])];
  }
  metresX(pixels: number): number {
    return (pixels - this.originX) / this.scale;
  }
  metresY(pixels: number): number {
    return (this.originY - pixels) / this.scale;
  }

  /** The largest true scale at which a box fits between the margins, in the middle of what is left. */
  static fit(box: Box, width: number, height: number, margins: Margins): View {
    const w = Math.max(40, width - margins.left - margins.right);
    const h = Math.max(40, height - margins.top - margins.bottom);
    const scale = Math.min(w / Math.max(1e-3, box.right - box.left), h / Math.max(1e-3, box.top - box.bottom));
    const middleX = margins.left + w / 2;
    const middleY = margins.top + h / 2;
    return new View(
      scale,
      middleX - (scale * (box.left + box.right)) / 2,
      middleY + (scale * (box.bottom + box.top)) / 2,
    );
  }

  /** The same about a point of the sheet that stays where it is. */
  zoomed(times: number, px: number, py: number): View {
    const scale = Math.min(4000, Math.max(0.5, this.scale * times));
    const k = scale / this.scale;
    return new View(scale, px + (this.originX - px) * k, py + (this.originY - py) * k);
  }

  moved(dx: number, dy: number): View {
    return new View(this.scale, this.originX + dx, this.originY + dy);
  }
}

export function boundsOf(picture: Picture): Box {
  const box: Box = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
  const take = ([x, y]: Point): void => {
    if (x < box.left) box.left = x;
    if (x > box.right) box.right = x;
    if (y < box.bottom) box.bottom = y;
    if (y > box.top) box.top = y;
  };
  for (const shape of picture.shapes) shape.outline.forEach(take);
  for (const band of picture.bands) for (const outline of band.outlines) outline.forEach(take);
  picture.surface.forEach(take);
  picture.fill.forEach(take);
  return Number.isFinite(box.left) ? box : { left: 0, right: 1, bottom: 0, top: 1 };
}

/** Ends of the bridge itself: the abutments' springings, where dimensions say so. */
export function spansOf(picture: Picture): { from: Point; to: Point }[] {
  return picture.dimensions.filter((d) => d.measure === "Span").map(({ from, to }) => ({ from, to }));
}

/** Height of the road at x [m]: its line between points, level beyond its ends. */
export function roadAt(picture: Picture, x: number): number {
  const line = roadOf(picture);
  if (line.length === 0) return boundsOf(picture).top;
  if (x <= line[0]![0]) return line[0]![1];
  for (let k = 1; k < line.length; k += 1) {
    const [x1, y1] = line[k]!;
    if (x <= x1) {
      const [x0, y0] = line[k - 1]!;
      return x1 - x0 < 1e-9 ? y1 : y0 + ((y1 - y0) * (x - x0)) / (x1 - x0);
    }
  }
  return line[line.length - 1]![1];
}

const roads = new WeakMap<Picture, Point[]>();
/** The road's surface as a line from left to right; the ring's highest point, level, where there is no cover. */
export function roadOf(picture: Picture): Point[] {
  const kept = roads.get(picture);
  if (kept) return kept;
  let line: Point[] = [];
  if (picture.surface.length >= 2) {
    line = [...picture.surface].sort((a, b) => a[0] - b[0]);
  } else {
    const box = boundsOf(picture);
    line = [
      [box.left, box.top],
      [box.right, box.top],
    ];
  }
  roads.set(picture, line);
  return line;
}
