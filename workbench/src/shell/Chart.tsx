/** Curves of numbers by uPlot, in the ink of the sheet. */
import { createEffect, on, onCleanup, onMount, type JSX } from "solid-js";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { inkOf } from "../drawing/ink";
import { theme } from "./settings";

export type Curve = { label: string; kind?: "answer" | "ink" | "soft" | "second"; points?: boolean; dash?: number[] };

export function Chart(props: {
  data: uPlot.AlignedData;
  curves: Curve[];
  x: string;
  y: string;
  height: number;
  label: string;
  time?: number | null;
}): JSX.Element {
  let host!: HTMLDivElement;
  let plot: uPlot | null = null;

  const make = (): void => {
    plot?.destroy();
    host.replaceChildren();
    const ink = inkOf(host);
    const colours = { answer: ink.answer, ink: ink.ink, soft: ink.soft, second: ink.second };
    const axis = { stroke: ink.soft, grid: { stroke: ink.grid, width: 1 }, ticks: { stroke: ink.line, width: 1 }, font: `12px ${ink.font}`, labelFont: `12px ${ink.font}`, labelSize: 18 };
    plot = new uPlot(
      {
        width: Math.max(120, host.clientWidth),
        height: props.height,
        legend: { show: false },
        cursor: { drag: { x: false, y: false } },
        scales: { x: { time: false } },
        axes: [
          { ...axis, label: props.x, size: 34 },
          { ...axis, label: props.y, size: 46 },
        ],
        series: [
          {},
          ...props.curves.map((curve) => ({
            label: curve.label,
            stroke: colours[curve.kind ?? "answer"],
            width: 1.6,
            points: { show: curve.points ?? false, size: 5 },
            spanGaps: true,
            ...(curve.dash ? { dash: curve.dash } : {}),
          })),
        ],
        hooks: {
          draw: [
            (self) => {
              const at = props.time;
              if (at === undefined || at === null) return;
              const x = Math.round(self.valToPos(at, "x", true));
              self.ctx.strokeStyle = ink.ink;
              self.ctx.lineWidth = 1;
              self.ctx.beginPath();
              self.ctx.moveTo(x, self.bbox.top);
              self.ctx.lineTo(x, self.bbox.top + self.bbox.height);
              self.ctx.stroke();
            },
          ],
        },
      },
      props.data,
      host,
    );
  };
  onMount(() => {
    make();
    const observer = new ResizeObserver(() => plot?.setSize({ width: Math.max(120, host.clientWidth), height: props.height }));
    observer.observe(host);
    onCleanup(() => observer.disconnect());
  });
  createEffect(on([theme, () => props.curves, () => props.x, () => props.y], make, { defer: true }));
  createEffect(on(() => props.data, (data) => plot?.setData(data), { defer: true }));
  createEffect(on(() => props.time, () => plot?.redraw(false), { defer: true }));
  onCleanup(() => plot?.destroy());
  return (
    <figure class="chart" role="img" aria-label={props.label}>
      <div ref={host} />
    </figure>
  );
}
