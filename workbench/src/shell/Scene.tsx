/** A sheet that is painted anew whenever what it shows changes: one canvas at true scale, enlarged and moved by hand. */
import { createEffect, createMemo, createSignal, on, onCleanup, onMount, Show, type JSX } from "solid-js";
import { ready } from "../drawing/canvas";
import type { Sheet as Paper } from "../drawing/elevation";
import { inkOf, type Ink } from "../drawing/ink";
import { fromPointer } from "../drawing/measure";
import { View, type Box, type Margins } from "../drawing/view";
import { isSmall, system, theme } from "./settings";

export type SceneProps = {
  box: Box | null;
  margins?: Margins;
  /** Read by the scene so that it knows when to paint. */
  depends: () => unknown;
  paint: (paper: Paper) => void;
  label: string;
  title: string;
  note: string;
  click?: (x: number, y: number, scale: number) => void;
  canvas?: (canvas: HTMLCanvasElement) => void;
  children?: JSX.Element;
  /** Things that lie over the canvas at places of the bridge. */
  over?: (view: View) => JSX.Element;
};

export function Scene(props: SceneProps): JSX.Element {
  let host!: HTMLDivElement;
  let canvas!: HTMLCanvasElement;
  const [size, setSize] = createSignal({ width: 0, height: 0 });
  const [user, setUser] = createSignal<View | null>(null);
  let ink: Ink | null = null;
  const fitted = createMemo(() => {
    const { width, height } = size();
    const margins = props.margins ?? (isSmall() ? { left: 10, right: 10, top: 54, bottom: 34 } : { left: 34, right: 34, top: 70, bottom: 70 });
    return props.box && width > 0 ? View.fit(props.box, width, height, margins) : null;
  });
  const view = createMemo(() => user() ?? fitted());
  let asked = 0;
  const paint = (): void => {
    const now = view();
    const { width, height } = size();
    if (!now || width === 0) return;
    const pen = ready(canvas, width, height, Math.min(2, devicePixelRatio || 1));
    if (!pen) return;
    ink ??= inkOf(host);
    const begin = performance.now();
    props.paint({ pen, view: now, ink, width, height, system: system() });
    fromPointer("frame", begin);
  };
  const soon = () => (asked ||= requestAnimationFrame(() => ((asked = 0), paint())));
  createEffect(on(theme, () => (ink = null)));
  createEffect(on([view, system, theme, () => props.depends()], soon));
  onMount(() => {
    props.canvas?.(canvas);
    const observer = new ResizeObserver(() => setSize({ width: host.clientWidth, height: host.clientHeight }));
    observer.observe(host);
    const font = inkOf(host).font;
    void Promise.all([400, 500, 600].map((weight) => document.fonts?.load(`${weight} 13px ${font}`))).then(soon);
    onCleanup(() => observer.disconnect());
  });
  onCleanup(() => cancelAnimationFrame(asked));

  let from: { x: number; y: number; moved: boolean } | null = null;
  return (
    <div
      class="scene"
      ref={host}
      onWheel={(event) => {
        const now = view();
        if (!now || !(event.ctrlKey || event.metaKey || event.altKey)) return;
        event.preventDefault();
        const at = host.getBoundingClientRect();
        setUser(now.zoomed(Math.exp(-event.deltaY * 0.002), event.clientX - at.left, event.clientY - at.top));
      }}
      onPointerDown={(event) => {
        if ((event.target as Element).closest("button")) return;
        from = { x: event.clientX, y: event.clientY, moved: false };
      }}
      onPointerMove={(event) => {
        const now = view();
        if (!from || !now || event.buttons === 0 || event.pointerType !== "mouse") return;
        const dx = event.clientX - from.x;
        const dy = event.clientY - from.y;
        if (!from.moved && Math.hypot(dx, dy) < 4) return;
        setUser(now.moved(dx, dy));
        from = { x: event.clientX, y: event.clientY, moved: true };
      }}
      onPointerUp={(event) => {
        const now = view();
        if (from && !from.moved && now && props.click) {
          const at = host.getBoundingClientRect();
          props.click(now.metresX(event.clientX - at.left), now.metresY(event.clientY - at.top), now.scale);
        }
        from = null;
      }}
    >
      <canvas ref={canvas} role="img" aria-label={props.label} />
      <div class="sheet-title">{props.title}</div>
      <div class="sheet-note">{props.note}</div>
      <Show when={view()}>{(now) => props.over?.(now())}</Show>
      <div class="corner">
        <button type="button" aria-label="Enlarge the drawing" onClick={() => setUser(view()?.zoomed(1.25, size().width / 2, size().height / 2) ?? null)}>+</button>
        <button type="button" aria-label="Reduce the drawing" onClick={() => setUser(view()?.zoomed(0.8, size().width / 2, size().height / 2) ?? null)}>−</button>
        <Show when={user()}>
          <button type="button" aria-label="Fit the drawing to the sheet" onClick={() => setUser(null)}>Fit</button>
        </Show>
      </div>
      {props.children}
    </div>
  );
}
