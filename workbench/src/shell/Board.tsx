/** The drawing board: the bridge at true scale with its dimensions, handles on them, and the load with its answer. */
import { createEffect, createMemo, createSignal, For, on, onCleanup, onMount, Show, type JSX } from "solid-js";
import * as answers from "../drawing/answer";
import { ready } from "../drawing/canvas";
import * as elevation from "../drawing/elevation";
import { handlesOf, literalOf, metresOf, type Handle } from "../drawing/handles";
import { inkOf, type Ink } from "../drawing/ink";
import { fromPointer } from "../drawing/measure";
import { boundsOf, roadAt, View, type Box, type Margins } from "../drawing/view";
import type { Picture } from "../engine/types";
import { download } from "../drawing/film";
import { liveEngine, poke, setQuantity } from "../model/live";
import type { Sheet } from "../model/sheet";
import { say } from "../model/workspace";
import { dimension, place, words } from "../units";
import { isSmall, system, theme } from "./settings";

export type BoardProps = {
  sheet: Sheet;
  /** Whether dimensions have handles. */
  handles: boolean;
  /** Whether the load can be moved and its answer is drawn. */
  load: boolean;
  /** Reach of the drawn mechanism [px]; 0 leaves it out. */
  reach: number;
  sayLoad: (factor: number) => string;
  children?: JSX.Element;
};

export function Board(props: BoardProps): JSX.Element {
  let box!: HTMLDivElement;
  let under!: HTMLCanvasElement;
  let over!: HTMLCanvasElement;
  const [size, setSize] = createSignal({ width: 0, height: 0 });
  const [user, setUser] = createSignal<View | null>(null);
  const [dragged, setDragged] = createSignal(false);
  let ink: Ink | null = null;
  /** Pixels of a picture that is saved for each of the sheet; 0 for the screen's. */
  let fineness = 0;
  /** When the pointer asked for a place, until its picture is there. */
  const asked = new Map<number, number>();

  const picture = () => props.sheet.picture[0]();
  const margins = (): Margins =>
    isSmall()
      ? { left: 10, right: 10, top: props.load ? 128 : 60, bottom: 34 }
      : { left: 34, right: 34, top: props.load ? 190 : 84, bottom: 56 };

  const fitted = createMemo<View | null>((before) => {
    const seen = picture();
    const { width, height } = size();
    if (!seen || width === 0) return null;
    // While a handle is held the scale stays, so that the bridge does not run away from the hand.
    if (dragged() && before) return before;
    return View.fit(reached(boundsOf(seen)), width, height, margins());
  });
  const view = createMemo(() => user() ?? fitted());
  /** The bridge with every place of its load, so that the curve over these places and the least of them are on the sheet. */
  function reached(box: Box): Box {
    const about = props.load ? props.sheet.about[0]() : null;
    return about ? { ...box, left: Math.min(box.left, about.from), right: Math.max(box.right, about.to) } : box;
  }

  const placed = createMemo(() => {
    const seen = picture();
    const now = view();
    return seen && now ? elevation.placeDimensions(seen, now, system(), isSmall()) : [];
  });
  const handles = createMemo<Handle[]>(() => (props.handles ? handlesOf(placed(), props.sheet.quantities[0]()) : []));

  let lastBodies: { picture: Picture; bodies: answers.Bodies } | null = null;
  const bodies = createMemo(() => {
    const seen = picture();
    const answer = props.sheet.answer[0]();
    if (!seen || !answer || answer.centroids.length !== 2 * seen.shapes.length) return null;
    return cached(seen, answer.centroids);
  });
  function cached(seen: Picture, centroids: Float64Array): answers.Bodies {
    if (lastBodies?.picture !== seen) lastBodies = { picture: seen, bodies: answers.bodiesOf(seen, centroids) };
    return lastBodies.bodies;
  }

  function paper(canvas: HTMLCanvasElement): elevation.Sheet | null {
    const { width, height } = size();
    const now = view();
    if (!now || width === 0) return null;
    const pen = ready(canvas, width, height, fineness || Math.min(2, devicePixelRatio || 1));
    if (!pen) return null;
    ink ??= inkOf(box);
    return { pen, view: now, ink, width, height, system: system() };
  }

  function drawUnder(): void {
    const seen = picture();
    const sheet = paper(under);
    if (!seen || !sheet) return;
    elevation.grid(sheet);
    elevation.cover(sheet, seen);
    elevation.particles(sheet, seen);
    elevation.masonry(sheet, seen);
    elevation.defects(sheet, seen);
    elevation.road(sheet, seen);
    // Under a load, its arrows stand where the names of the layers are.
    if (!props.load) elevation.layerNames(sheet, seen);
    elevation.scaleBar(sheet, 0);
  }

  /** Axles of the vehicle where its first one stands at x, and which of them count there. */
  function standing(x: number): answers.Wheel[] {
    const back = props.sheet.leftward[0]() ? 1 : -1;
    const { stands, critical } = props.sheet.answer[0]()?.words ?? { stands: null, critical: null };
    return (props.sheet.about[0]()?.axles ?? []).map((axle, k) => ({
      x: x + back * axle.offset, force: axle.force, counts: stands !== null && k >= stands[0] && k <= stands[1], critical: critical === k,
    }));
  }

  function drawOver(): void {
    const begin = performance.now();
    const seen = picture();
    const sheet = paper(over);
    if (!seen || !sheet) return;
    clearTimeout(late);
    const answer = props.sheet.answer[0]();
    const curve = props.sheet.envelope[0]();
    const x = props.sheet.x[0]();
    if (props.load && answer && curve) {
      const top = isSmall() ? 60 : 44;
      // Room for the arrows, and for their forces where a vehicle has any.
      const room = props.sheet.vehicle[0]() === "" ? 70 : isSmall() ? 78 : 92;
      const bottom = Math.max(top + 30, Math.min(sheet.view.y(boundsOf(seen).top) - room, sheet.height * 0.45));
      answers.envelope(sheet, curve, 1, props.sayLoad, top, bottom, x === null ? null : { x, factor: answer.words.factor });
    }
    if (!answer) {
      elevation.dimensions(sheet, placed());
      return;
    }
    const zone = props.sheet.zone[0]();
    if (props.load) {
      if (zone) answers.thrustZone(sheet, zone);
      const moved = bodies();
      if (moved && props.reach > 0) answers.mechanism(sheet, moved, answer, props.reach);
    }
    // A thickness stands where a mechanism moves.
    elevation.dimensions(sheet, props.load ? placed().filter((one) => one.dimension.measure === "Span" || one.dimension.measure === "Rise") : placed());
    if (!props.load) return;
    answers.dispersed(sheet, answer.loads);
    answers.thrust(sheet, answer);
    answers.hinges(sheet, answer.words.hinges);
    answers.sliding(sheet, answer.words.sliding);
    // The load stands where the hand is; the answer may be a picture behind.
    const axles = answer.axles.slice();
    if (x !== null) for (let k = 0; k < axles.length; k += 4) axles[k] = axles[k]! + (x - answer.x);
    answers.axles(sheet, seen, axles, system(), props.sheet.vehicle[0]() === "" ? null : standing(x ?? answer.x));
    const since = asked.get(answer.x);
    if (since !== undefined) {
      fromPointer("pointer-to-picture", since);
      asked.delete(answer.x);
    }
    fromPointer("frame", begin);
  }

  let askedUnder = 0;
  let askedOver = 0;
  const soonUnder = () => (askedUnder ||= requestAnimationFrame(() => ((askedUnder = 0), drawUnder())));
  const soonOver = () => (askedOver ||= requestAnimationFrame(() => ((askedOver = 0), drawOver())));

  createEffect(on([picture, view, system, theme, placed, () => props.load], soonUnder));
  createEffect(
    on(
      [picture, view, system, theme, placed, props.sheet.answer[0], props.sheet.zone[0], props.sheet.envelope[0], () => props.load, () => props.reach],
      soonOver,
    ),
  );
  // The load alone moves on only where its answer is late: one picture for both otherwise.
  let late: ReturnType<typeof setTimeout> | undefined;
  createEffect(
    on(props.sheet.x[0], () => {
      clearTimeout(late);
      late = setTimeout(soonOver, 40);
    }),
  );
  createEffect(
    on(theme, () => {
      ink = null;
    }),
  );
  createEffect(
    on(
      () => props.sheet.id,
      () => setUser(null),
    ),
  );

  onMount(() => {
    const observer = new ResizeObserver(() => {
      setSize({ width: box.clientWidth, height: box.clientHeight });
      soonUnder();
      soonOver();
    });
    observer.observe(box);
    onCleanup(() => observer.disconnect());
    // A canvas asks for no font by itself.
    const font = inkOf(box).font;
    void Promise.all([400, 500, 600].map((weight) => document.fonts?.load(`${weight} 13px ${font}`))).then(() => {
      soonUnder();
      soonOver();
    });
  });
  onCleanup(() => {
    clearTimeout(late);
    cancelAnimationFrame(askedUnder);
    cancelAnimationFrame(askedOver);
  });

  // Wheel and two fingers zoom, an empty place of the sheet moves it.
  function wheel(event: WheelEvent): void {
    const now = view();
    if (!now || !(event.ctrlKey || event.metaKey || event.altKey)) return;
    event.preventDefault();
    const box_ = box.getBoundingClientRect();
    setUser(now.zoomed(Math.exp(-event.deltaY * 0.002), event.clientX - box_.left, event.clientY - box_.top));
  }
  const fingers = new Map<number, { x: number; y: number }>();
  function down(event: PointerEvent): void {
    if ((event.target as Element).closest("button")) return;
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    if (props.load && fingers.size === 1 && event.button === 0) tap(event);
  }
  function move(event: PointerEvent): void {
    const before = fingers.get(event.pointerId);
    const now = view();
    if (!before || !now) return;
    if (fingers.size === 2) {
      const other = [...fingers].find(([id]) => id !== event.pointerId)![1];
      const was = Math.hypot(before.x - other.x, before.y - other.y);
      const is = Math.hypot(event.clientX - other.x, event.clientY - other.y);
      const place_ = box.getBoundingClientRect();
      if (was > 8) setUser(now.zoomed(is / was, (event.clientX + other.x) / 2 - place_.left, (event.clientY + other.y) / 2 - place_.top));
    } else if (event.pointerType === "mouse" && !loadHeld) {
      setUser(now.moved(event.clientX - before.x, event.clientY - before.y));
    }
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (loadHeld) dragLoad(event);
  }
  function up(event: PointerEvent): void {
    fingers.delete(event.pointerId);
    loadHeld = false;
  }

  // The load.
  let loadHeld = false;
  let loadOffset = 0;
  function tap(event: PointerEvent): void {
    const now = view();
    const seen = picture();
    const x = props.sheet.x[0]();
    if (!now || !seen || x === null) return;
    const at = box.getBoundingClientRect();
    const px = event.clientX - at.left;
    const py = event.clientY - at.top;
    const axles = props.sheet.answer[0]()?.axles;
    if (!axles) return;
    for (let k = 0; k < axles.length; k += 4) {
      const ax = now.x(axles[k]!);
      const ay = now.y(roadAt(seen, axles[k]!));
      if (Math.abs(px - ax) < 22 && py > ay - 66 && py < ay + 12) {
        loadHeld = true;
        loadOffset = now.metresX(px) - x;
        return;
      }
    }
  }
  function dragLoad(event: PointerEvent): void {
    const now = view();
    const about = props.sheet.about[0]();
    if (!now || !about) return;
    const at = box.getBoundingClientRect();
    moveLoad(now.metresX(event.clientX - at.left) - loadOffset, event.timeStamp);
  }
  function moveLoad(x: number, time: number): void {
    const about = props.sheet.about[0]();
    if (!about) return;
    const to = Math.min(about.to, Math.max(about.from, x));
    if (to === props.sheet.x[0]()) return;
    asked.set(to, time);
    if (asked.size > 200) asked.delete(asked.keys().next().value!);
    props.sheet.moves += 1;
    props.sheet.x[1](to);
    poke();
  }
  function gripDown(event: PointerEvent): void {
    const now = view();
    const x = props.sheet.x[0]();
    if (!now || x === null || event.button !== 0) return;
    event.stopPropagation();
    const at = box.getBoundingClientRect();
    loadOffset = now.metresX(event.clientX - at.left) - x;
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    loadHeld = true;
  }
  function gripMove(event: PointerEvent): void {
    if (!loadHeld) return;
    event.stopPropagation();
    dragLoad(event);
  }
  function gripUp(event: PointerEvent): void {
    event.stopPropagation();
    loadHeld = false;
  }
  function gripKey(event: KeyboardEvent): void {
    const about = props.sheet.about[0]();
    const x = props.sheet.x[0]();
    if (!about || x === null) return;
    const step = event.shiftKey ? 0.5 : event.altKey ? 0.01 : 0.1;
    const to: Record<string, number> = {
      ArrowLeft: x - step,
      ArrowDown: x - step,
      ArrowRight: x + step,
      ArrowUp: x + step,
      PageUp: x + 1,
      PageDown: x - 1,
      Home: about.from,
      End: about.to,
    };
    const next = to[event.key];
    if (next === undefined) return;
    event.preventDefault();
    moveLoad(next, event.timeStamp);
  }

  // Handles of dimensions.
  function handleDown(event: PointerEvent, handle: Handle): void {
    const now = view();
    const start = metresOf(handle.quantity);
    if (!now || start === null || event.button !== 0) return;
    event.stopPropagation();
    const target = event.currentTarget as HTMLElement;
    target.setPointerCapture(event.pointerId);
    setDragged(true);
    const mark = `drag ${handle.path} ${event.timeStamp}`;
    const from = handle.axis === "x" ? event.clientX : -event.clientY;
    const moveOn = (next: PointerEvent): void => {
      const by = ((handle.axis === "x" ? next.clientX : -next.clientY) - from) / now.scale;
      const snap = next.shiftKey ? 0.001 : 0.005;
      const metres = Math.max(0.01, Math.round((start + handle.sign * by) / snap) * snap);
      setQuantity(handle.path, literalOf(handle.quantity, metres), mark);
    };
    const end = (): void => {
      setDragged(false);
      target.removeEventListener("pointermove", moveOn);
      target.removeEventListener("pointerup", end);
      target.removeEventListener("pointercancel", end);
    };
    target.addEventListener("pointermove", moveOn);
    target.addEventListener("pointerup", end);
    target.addEventListener("pointercancel", end);
  }
  function handleKey(event: KeyboardEvent, handle: Handle): void {
    const start = metresOf(handle.quantity);
    if (start === null) return;
    const step = event.shiftKey ? 0.1 : event.altKey ? 0.001 : 0.01;
    const by = { ArrowUp: step, ArrowRight: step, ArrowDown: -step, ArrowLeft: -step }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    setQuantity(handle.path, literalOf(handle.quantity, Math.max(0.01, start + by)), `keys ${handle.path}`);
  }

  const gripPlace = createMemo(() => {
    const now = view();
    const seen = picture();
    const x = props.sheet.x[0]();
    if (!props.load || !now || !seen || x === null || !props.sheet.about[0]()) return null;
    return { x: now.x(x), y: now.y(roadAt(seen, x)) };
  });

  const stem = () => props.sheet.path.replace(/\.\w+$/, "");
  /** What is drawn, twice as fine as on the screen at least, on the colour of the sheet, with what it shows in a line. */
  function savePicture(): void {
    const ratio = Math.max(2, devicePixelRatio || 1);
    const { width, height } = size();
    const shown = [under, over];
    fineness = ratio;
    drawUnder();
    drawOver();
    const canvas = document.createElement("canvas");
    canvas.width = shown[0]!.width;
    canvas.height = shown[0]!.height;
    const pen = canvas.getContext("2d");
    if (!pen) return;
    const colours = (ink ??= inkOf(box));
    pen.fillStyle = colours.sheet;
    pen.fillRect(0, 0, canvas.width, canvas.height);
    for (const one of shown) pen.drawImage(one, 0, 0);
    fineness = 0;
    drawUnder();
    drawOver();
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.fillStyle = colours.ink;
    pen.font = `500 14px ${colours.font}`;
    pen.textAlign = "center";
    pen.textBaseline = "bottom";
    pen.fillText(caption(), width / 2, height - 8, width - 16);
    canvas.toBlob((blob) => blob && download(blob, `${stem()}${props.load ? "-load" : ""}.png`));
  }
  /** The bridge, and what it carries where its load stands. */
  function caption(): string {
    const answer = props.load ? props.sheet.answer[0]() : null;
    const factor = answer?.words.factor ?? null;
    const units = system() === "metric" ? "dimensions in mm" : "dimensions in feet and inches";
    return [props.sheet.name(), ...(answer && factor !== null ? [`${props.sayLoad(factor)} at ${words(place(answer.x, system()))}`] : []), units].join("; ");
  }
  /** The engine's own drawing of the bridge. */
  async function saveDrawing(): Promise<void> {
    const svg = await liveEngine.call<string>("drawing", { sheet: props.sheet.id }).catch(() => "");
    if (svg === "") return say("The bridge cannot be drawn as long as its file has errors.", true);
    download(new TextEncoder().encode(svg), `${stem()}.svg`, "image/svg+xml");
  }

  const told = () => {
    const seen = picture();
    if (!seen) return "Drawing of the bridge";
    const spans = seen.dimensions.filter((one) => one.measure === "Span").map((one) => `${dimension(one.to[0] - one.from[0], system())}`);
    const answer = props.sheet.answer[0]();
    return `Elevation of ${props.sheet.name()}: ${spans.length} ${spans.length === 1 ? "span" : "spans"}, ${spans.join(", ")}${
      system() === "metric" ? " mm" : ""
    }${props.load && answer ? `; thrust line and ${answer.words.hinges.length} hinges of the load` : ""}.`;
  };

  return (
    <div class="scene" ref={box} onWheel={wheel} onPointerDown={down} onPointerMove={move} onPointerUp={up} onPointerCancel={up}>
      <canvas ref={under} role="img" aria-label={told()} />
      <canvas ref={over} class="live" classList={{ "scene-old": props.sheet.isOld() }} aria-hidden="true" />
      <div class="sheet-title">{props.sheet.name()}</div>
      <Show when={isSmall() && props.sheet.answer[0]()}>
        {(answer) => <div class="sheet-answer num" classList={{ old: props.sheet.isOld() }} aria-hidden="true">{answer().words.factor === null ? "–" : props.sayLoad(answer().words.factor!)}</div>}
      </Show>
      <div class="sheet-note">{system() === "metric" ? "Elevation · dimensions in mm" : "Elevation · feet and inches"}</div>
      <For each={handles().map((handle) => handle.path)}>
        {(path) => {
          const handle = () => handles().find((one) => one.path === path);
          return (
            <Show when={handle()}>
              {(one) => (
                <button
                  type="button"
                  class="grip"
                  role="slider"
                  aria-label={one().title}
                  aria-orientation={one().axis === "x" ? "horizontal" : "vertical"}
                  aria-valuenow={one().quantity.number ?? 0}
                  aria-valuetext={one().quantity.text}
                  title={`${one().title}: drag, or arrow keys`}
                  data-path={path}
                  style={{
                    transform: `translate(${one().axis === "x" ? one().placed.to[0] : one().placed.to[0]}px, ${one().placed.to[1]}px)`,
                  }}
                  onPointerDown={(event) => handleDown(event, one())}
                  onKeyDown={(event) => handleKey(event, one())}
                />
              )}
            </Show>
          );
        }}
      </For>
      <Show when={gripPlace()}>
        {(at) => (
          <button
            type="button"
            class="grip load"
            role="slider"
            aria-label="Place of the load along the road"
            aria-valuemin={props.sheet.about[0]()?.from ?? 0}
            aria-valuemax={props.sheet.about[0]()?.to ?? 0}
            aria-valuenow={props.sheet.x[0]() ?? 0}
            aria-valuetext={words(place(props.sheet.x[0]() ?? 0, system()))}
            title="Drag the load along the road, or use the arrow keys"
            style={{ transform: `translate(${at().x}px, ${at().y}px)` }}
            onPointerDown={gripDown}
            onPointerMove={gripMove}
            onPointerUp={gripUp}
            onPointerCancel={gripUp}
            onKeyDown={gripKey}
          />
        )}
      </Show>
      <div class="corner">
        <button type="button" aria-label="Save the drawing as PNG" title="Save what is drawn here, as PNG" onClick={savePicture}>PNG</button>
        <button type="button" aria-label="Save the bridge as SVG" title="Save the bridge as built, as SVG" onClick={() => void saveDrawing()}>SVG</button>
        <button type="button" aria-label="Enlarge the drawing" onClick={() => setUser((view() ?? null)?.zoomed(1.25, size().width / 2, size().height / 2) ?? null)}>+</button>
        <button type="button" aria-label="Reduce the drawing" onClick={() => setUser((view() ?? null)?.zoomed(0.8, size().width / 2, size().height / 2) ?? null)}>−</button>
        <Show when={user()}>
          <button type="button" aria-label="Fit the drawing to the sheet" onClick={() => setUser(null)}>Fit</button>
        </Show>
      </div>
      {props.children}
    </div>
  );
}
