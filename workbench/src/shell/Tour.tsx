/** Two minutes with Bridgemill: each stop says what to do, shows where, and notices when it has been done. */
import { createEffect, createMemo, createSignal, on, onCleanup, onMount, Show, type JSX } from "solid-js";
import { examples } from "../model/library";
import { runOf } from "../model/run";
import { active, part, setPart, type Part } from "../model/workspace";
import { setTab, tab } from "../parts/BridgePanel";
import { openExample } from "./OpenDialog";

type Stop = {
  part: Part;
  title: string;
  words: string;
  /** What is marked on the page. */
  at: string;
  prepare?: () => void;
  /** Whether the reader has done it. */
  done?: () => boolean;
};

const STOPS: Stop[] = [
  {
    part: "bridge",
    title: "A bridge is a drawing",
    words: "Bridgemill, a bridge that was tested to collapse: 18.3 m of span, drawn to scale. Hold the small square at the end of the dimension line of the rise and pull it up a little, or focus it and press the arrow up.",
    at: '.grip[data-path="span[1].rise"]',
    done: () => (active()?.steps().back ?? 0) > 0,
  },
  {
    part: "bridge",
    title: "Form and text are the same file",
    words: "The rise changed in the form too. Open “Text”: the same value stands in the bridge file, and its comments are still there. Undo takes your change back, wherever it was made.",
    at: ".panel-tabs",
    done: () => tab() === "text",
  },
  {
    part: "load",
    title: "Drag the load",
    words: "Pull the arrow along the road, or focus it and use the arrow keys. The line is the thrust, the rings are hinges, the thin outline is how the bridge would move.",
    at: ".grip.load",
    prepare: () => setTab("form"),
    done: () => {
      const sheet = active();
      sheet?.x[0]();
      return sheet !== null && sheet.moves > 2;
    },
  },
  {
    part: "load",
    title: "Read the title block",
    words: "In the corner, as on every drawing: what is carried and by which load, how it was found, and every warning and assumption beside it. The curve above the bridge fills itself; its lowest point governs.",
    at: ".block",
  },
  {
    part: "collapse",
    title: "Watch it fall",
    words: "Press “Load until it falls”. The load grows in steps and the stones move until they rest, or fall. Pause, go back with the slider, and enlarge the displacements.",
    at: ".panel-body",
    done: () => {
      const sheet = active();
      return sheet !== null && runOf(sheet).count[0]() > 20;
    },
  },
  {
    part: "verdict",
    title: "Take it with you",
    words: "Here the analyses run as by the command, with the same numbers, a report to print and every file to save. “Link”, at the top, puts the bridge into an address; nothing leaves this machine.",
    at: ".panel-body",
  },
];

export function Tour(props: { close: () => void }): JSX.Element {
  const [at, setAt] = createSignal(0);
  const stop = () => STOPS[at()]!;
  let box!: HTMLElement;
  onMount(() => box.focus());
  // The tour may begin before the engine, which holds the examples, has been loaded.
  let opened = false;
  createEffect(() => {
    const bridgemill = examples()?.find((example) => example.name === "bridgemill");
    if (!bridgemill || opened) return;
    opened = true;
    void openExample(bridgemill);
  });
  createEffect(
    on(at, () => {
      stop().prepare?.();
      setPart(stop().part);
    }),
  );
  const [mark, setMark] = createSignal<DOMRect | null>(null);
  const timer = setInterval(() => {
    const element = part() === stop().part ? document.querySelector(stop().at) : null;
    const rect = element?.getBoundingClientRect() ?? null;
    const old = mark();
    if (rect?.x !== old?.x || rect?.y !== old?.y || rect?.width !== old?.width || rect?.height !== old?.height) setMark(rect);
  }, 200);
  onCleanup(() => clearInterval(timer));
  const done = createMemo(() => stop().done?.() ?? false);
  return (
    <>
      <Show when={mark()}>
        {(rect) => (
          <div
            class="tour-mark"
            aria-hidden="true"
            style={{ left: `${rect().x - 5}px`, top: `${rect().y - 5}px`, width: `${rect().width + 10}px`, height: `${rect().height + 10}px` }}
          />
        )}
      </Show>
      <section
        class="tour"
        role="dialog"
        aria-modal="false"
        aria-labelledby="tour-title"
        tabindex="-1"
        ref={box}
        onKeyDown={(event) => event.key === "Escape" && props.close()}
      >
        <p class="soft num">{at() + 1} of {STOPS.length}</p>
        <h2 id="tour-title">{stop().title}</h2>
        <p>{stop().words}</p>
        <div class="row">
          <button type="button" class="btn small" disabled={at() === 0} onClick={() => setAt(at() - 1)}>Back</button>
          <Show when={at() < STOPS.length - 1} fallback={<button type="button" class="btn small main" onClick={props.close}>To work</button>}>
            <button type="button" class="btn small main" onClick={() => setAt(at() + 1)}>Next</button>
          </Show>
          <span class="soft" role="status">{done() ? "Done." : ""}</span>
          <button type="button" class="btn small last" onClick={props.close}>Leave the tour</button>
        </div>
      </section>
    </>
  );
}
