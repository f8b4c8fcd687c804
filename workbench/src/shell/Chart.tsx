/** Curves of numbers by uPlot, in the ink of the sheet. */
import { createEffect, on, onCleanup, onMount, type JSX } from "solid-js";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { download } from "../drawing/film";
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
  const name = () => props.y.replace(/,.*$/, "").replace(/[^\w]+/g, "-").toLowerCase() || "curve";
  const png = (): void => {
    const drawn = host.querySelector("canvas");
    if (!drawn) return;
    const canvas = document.createElement("canvas");
    canvas.width = drawn.width;
    canvas.height = drawn.height;
    const pen = canvas.getContext("2d")!;
    pen.fillStyle = inkOf(host).sheet;
    pen.fillRect(0, 0, canvas.width, canvas.height);
    pen.drawImage(drawn, 0, 0);
    canvas.toBlob((blob) => blob && download(blob, `${name()}.png`));
  };
  const csv = (): void => {
    const cell = (words: string): string => (/[",]/.test(words) ? `"${words.replace(/"/g, '""')}"` : words);
    const heads = [props.x, ...props.curves.map((curve) => (props.curves.length === 1 ? props.y : `${curve.label} (${props.y})`))];
    const rows = Array.from(props.data[0], (x, k) => [x, ...props.curves.map((_, n) => props.data[n + 1]?.[k] ?? "")].join(","));
    download(new TextEncoder().encode([heads.map(cell).join(","), ...rows].join("\n") + "\n"), `${name()}.csv`, "text/csv");
  };
  return (
    <div class="charted">
      <figure class="chart" role="img" aria-label={props.label}>
        <div ref={host} />
      </figure>
      <div class="saves">
        <button type="button" class="link" aria-label={`Save ${props.y} as PNG`} onClick={png}>PNG</button>
        <button type="button" class="link" aria-label={`Save ${props.y} as CSV`} onClick={csv}>CSV</button>
      </div>
    </div>
  );
}
