import type { Point } from "../engine/types";
import type { View } from "./view";

export type Pen = CanvasRenderingContext2D;

/** Sets a canvas to the size of its box at the screen's resolution and clears it; drawing is then in CSS pixels. */
export function ready(canvas: HTMLCanvasElement, width: number, height: number, ratio: number): Pen | null {
  const w = Math.max(1, Math.round(width * ratio));
  const h = Math.max(1, Math.round(height * ratio));
  if (canvas.width !== w) canvas.width = w;
  if (canvas.height !== h) canvas.height = h;
  const pen = canvas.getContext("2d");
  if (!pen) return null;
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  return pen;
}

export function trace(pen: Pen, view: View, points: Point[], close: boolean): void {
  for (let k = 0; k < points.length; k += 1) {
    const p = points[k]!;
    if (k === 0) pen.moveTo(view.x(p[0]), view.y(p[1]));
    else pen.lineTo(view.x(p[0]), view.y(p[1]));
  }
  if (close && points.length > 0) pen.closePath();
}

export function pathOf(view: View, outlines: Point[][], close = true): Path2D {
  const path = new Path2D();
  for (const points of outlines) {
    points.forEach((p, k) => (k === 0 ? path.moveTo(view.x(p[0]), view.y(p[1])) : path.lineTo(view.x(p[0]), view.y(p[1]))));
    if (close && points.length > 0) path.closePath();
  }
  return path;
}

export function line(pen: Pen, x0: number, y0: number, x1: number, y1: number): void {
  pen.beginPath();
  pen.moveTo(x0, y0);
  pen.lineTo(x1, y1);
  pen.stroke();
}

/** Text on a patch of the sheet's colour, so that lines do not run through figures. */
export function label(pen: Pen, text: string, x: number, y: number, paper: string, pad = 3): void {
  const width = pen.measureText(text).width;
  const size = parseFloat(pen.font.match(/(\d+(\.\d+)?)px/)?.[1] ?? "12");
  const left = pen.textAlign === "center" ? x - width / 2 : pen.textAlign === "right" ? x - width : x;
  const top = pen.textBaseline === "middle" ? y - size / 2 : pen.textBaseline === "top" ? y : y - size;
  const ink = pen.fillStyle;
  pen.fillStyle = paper;
  pen.globalAlpha = 0.86;
  pen.fillRect(left - pad, top - 1, width + 2 * pad, size + 2);
  pen.globalAlpha = 1;
  pen.fillStyle = ink;
  pen.fillText(text, x, y);
}
